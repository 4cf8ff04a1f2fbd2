//! The same moments by several interpolations, arranged in one picture with plots of the angular speed.

use num_rational::BigRational;
use num_traits::FromPrimitive as _;

use super::{Animation, ExportError, FrameTime, Moment, MomentPose, Size, Source, Span, Stage, Subject};
use crate::film::{ComparedAs, ComparedBoard, ComparedLayout, Plot, PlotCurve, axis_end};
use crate::keyframe::{Blend, PlayRange};
use crate::picture::{Image, Rows};
use crate::pose::RbtIndex;

/// Interpolations to compare.
#[derive(Clone, Debug, PartialEq)]
pub struct Comparison<'a> {
    /// Each by the name that it is labelled with; `None` is what the file says.
    pub blends: &'a [(String, Option<Blend>)],
    /// Where everything is in the picture.
    pub layout: ComparedLayout,
    /// The path of the node whose angular speed is plotted; `None`: the node that turns fastest.
    pub node: Option<&'a str>,
}

/// Makes the layout of a picture that compares.
///
/// # Errors
/// [`ExportError::TooSmallToCompare`]
pub fn check_comparison(how: ComparedAs, count: u32, size: Size) -> Result<ComparedLayout, ExportError> {
    let too_small = || {
        let least = Size::of(ComparedLayout::least_size(how, count));
        ExportError::TooSmallToCompare { size, count, least }
    };
    ComparedLayout::new(how, count, [size.width, size.height]).ok_or_else(too_small)
}

/// The board of a comparison, with the blends that it shows.
pub(super) struct PlannedComparison<'a> {
    source: Source<'a>,
    board: ComparedBoard,
    blends: Vec<Blend>,
    /// The seconds of playing before the plots begin.
    begins: f64,
}

impl<'a> PlannedComparison<'a> {
    /// Measures what is plotted.
    ///
    /// # Errors
    /// [`ExportError`]: the animation cannot be played, or there is no such node.
    pub fn new(
        comparison: &Comparison<'_>,
        source: Source<'a>,
        span: Span,
        subject: Subject,
    ) -> Result<Self, ExportError> {
        let Some(animation) = source.animation else {
            return Err(ExportError::NothingMoves { source_name: source.name() });
        };
        let range = PlayRange::new(&animation.keyframes).map_err(|cause| source.unplayable(cause))?;
        let named = |&(_, blend): &(String, Option<Blend>)| blend.unwrap_or(Blend::Played(animation.interpolation));
        let blends: Vec<Blend> = comparison.blends.iter().map(named).collect();
        let whole = matches!(subject, Subject::Picture { .. });
        let key_times = source.key_times(if whole { Span::default() } else { span }, animation)?;
        let speeds = Speeds { range, animation, key_times };
        let node = match comparison.node {
            Some(path) => {
                let node = source.scene.find_rbt(path);
                node.ok_or_else(|| ExportError::NoComparedNode { path: path.to_owned() })?
            }
            None => speeds.fastest(source.scene.rbt_indices()),
        };
        let [begins, ends] = key_times.map(|key_time| speeds.seconds(key_time));
        // A point for each column of pixels.
        let count = comparison.layout.view()[0];
        let points: Vec<_> = blends.iter().map(|&blend| speeds.points(node, blend, count)).collect();
        let plot = Plot {
            length: ends - begins,
            top: axis_end(shown_speed(&blends, &points)),
            lines: speeds.keyframes().map(|seconds| seconds - begins).collect(),
            curves: points
                .into_iter()
                .zip(comparison.layout.how().colours())
                .map(|(points, colour)| PlotCurve { colour, points })
                .collect(),
        };
        let labels: Vec<String> = comparison.blends.iter().map(|(label, _)| label.clone()).collect();
        let path = source.scene.rbt_path(node);
        let seconds = format!("0-{} s", (100.0 * plot.length).round() / 100.0);
        let name = path.rsplit('/').next().unwrap_or(path);
        let captions = [path, name, "°/s"].map(|what| match what {
            "°/s" => format!("°/s  {seconds}"),
            node => format!("{node}  °/s  {seconds}"),
        });
        let board = ComparedBoard::new(comparison.layout, &labels, &plot, &captions);
        Ok(Self { source, board, blends, begins })
    }

    /// The size of the whole picture.
    pub fn size(&self) -> Size {
        Size::of(self.board.layout().size())
    }

    /// What is drawn, with stages that `make` makes for each view.
    pub fn compared<'b>(
        &'b self,
        stage: impl Fn() -> Result<Stage<'b>, ExportError>,
    ) -> Result<Compared<'b>, ExportError> {
        let layout = self.board.layout();
        let stages = match (layout.how(), self.blends.as_slice()) {
            (ComparedAs::Ghosts, [first, others @ ..]) => {
                let mut stage = stage()?;
                stage.blend(*first);
                stage.compare(others.iter().copied().zip(layout.how().colours().into_iter().skip(1)).collect());
                vec![stage]
            }
            (_, blends) => blends
                .iter()
                .map(|&blend| {
                    let mut stage = stage()?;
                    stage.blend(blend);
                    Ok(stage)
                })
                .collect::<Result<_, ExportError>>()?,
        };
        Ok(Compared { planned: self, stages })
    }
}

impl PlannedComparison<'_> {
    /// The time of a moment in the plots, in seconds; `None` if it is none of playing.
    fn seconds(&self, moment: &Moment) -> Option<f64> {
        let (MomentPose::KeyTime(key_time), Some(animation)) = (moment.shown, self.source.animation) else {
            return None;
        };
        let timing = animation.keyframes.timing()?;
        Some(FrameTime::at_key_time(key_time, animation.ms_between_keyframes, timing).ms / 1000.0 - self.begins)
    }
}

/// What a comparison draws.
pub struct Compared<'a> {
    planned: &'a PlannedComparison<'a>,
    stages: Vec<Stage<'a>>,
}

impl<'a> Compared<'a> {
    /// What is drawn for each picture, in the order of the views.
    pub(super) fn stages(&self) -> &[Stage<'a>] {
        &self.stages
    }

    /// The picture of a moment, of its views.
    pub(super) fn picture(&self, views: &[Rows<'_>], moment: &Moment) -> Image {
        self.planned.board.picture(views, self.planned.seconds(moment))
    }
}

/// The angular speeds of a part of an animation.
struct Speeds<'a> {
    range: PlayRange<'a>,
    animation: &'a Animation,
    /// Where the part begins and ends.
    key_times: [f64; 2],
}

/// Moments at which nodes are looked at to find the one that turns fastest.
const LOOKS: u32 = 96;

impl Speeds<'_> {
    /// The seconds of playing from the first played keyframe to a key time.
    fn seconds(&self, key_time: f64) -> f64 {
        FrameTime::at_key_time(key_time, self.animation.ms_between_keyframes, self.range.timing()).ms / 1000.0
    }

    /// The seconds at which the part has keyframes, its ends included.
    fn keyframes(&self) -> impl Iterator<Item = f64> {
        let [from, to] = self.key_times;
        (from.ceil() as usize..=to.floor() as usize).map(|played| self.seconds(played as f64))
    }

    fn at(&self, key_time: f64, blend: Blend, node: RbtIndex) -> f64 {
        // At its end the speed is still that of the part.
        let key_time = key_time.min(self.key_times[1].next_down());
        self.range.angular_speed_at(key_time, blend, node, self.animation.ms_between_keyframes)
    }

    /// The node that turns fastest as the animation plays, at one of evenly spread moments; the first of equals.
    fn fastest(&self, nodes: impl Iterator<Item = RbtIndex>) -> RbtIndex {
        let [from, to] = self.key_times;
        let looks = (0..LOOKS).map(|look| from + (to - from) * (f64::from(look) + 0.5) / f64::from(LOOKS));
        let looks: Vec<f64> = looks.collect();
        let blend = Blend::Played(self.animation.interpolation);
        let fastest = |node| looks.iter().map(|&key_time| self.at(key_time, blend, node)).fold(0.0, f64::max);
        let speeds = nodes.map(|node| (fastest(node), node));
        // A tie by rounding is one as well: robots that mirror each other.
        let best = speeds.reduce(|best, next| if next.0 > best.0 * (1.0 + 1e-4) { next } else { best });
        best.map_or(RbtIndex::new(0), |(_, node)| node)
    }

    /// Seconds from the part's beginning and speeds in degrees a second, `count` of them, at least 2.
    fn points(&self, node: RbtIndex, blend: Blend, count: u32) -> Vec<[f64; 2]> {
        let [begins, ends] = self.key_times.map(|key_time| self.seconds(key_time));
        let (timing, unit) = (self.range.timing(), f64::from(self.animation.ms_between_keyframes) / 1000.0);
        let last = f64::from(count.max(2) - 1);
        let point = |place: u32| {
            let seconds = (ends - begins) * f64::from(place) / last;
            let units = BigRational::from_f64((begins + seconds) / unit).unwrap_or_default();
            let key_time = timing.key_time_at(&units).clamp(self.key_times[0], self.key_times[1]);
            [seconds, self.at(key_time, blend, node)]
        };
        (0..count.max(2)).map(point).collect()
    }
}

/// How many times as fast as all others a blend of matrices can be before its curve is cut off: half way between opposite rotations it
/// turns at once.
const MATRICES_AT_MOST: f64 = 4.0;

/// The largest speed that is shown.
fn shown_speed(blends: &[Blend], points: &[Vec<[f64; 2]>]) -> f64 {
    let fastest = |is_wanted: fn(Blend) -> bool| {
        let curves = blends.iter().zip(points).filter(|&(&blend, _)| is_wanted(blend));
        curves.flat_map(|(_, points)| points).map(|point| point[1]).fold(0.0, f64::max)
    };
    let (all, others) = (fastest(|_| true), fastest(|blend| blend != Blend::Matrices));
    if others > 0.0 { all.min(MATRICES_AT_MOST * others) } else { all }
}

#[cfg(test)]
mod tests {
    use glam::Quat;

    use super::*;
    use crate::interpolation::Interpolation;
    use crate::keyframe::{Keyframe, KeyframeList};
    use crate::rbt::Rbt;
    use crate::scene::{DEFAULT_SCENE, SceneGraph, built_in_scene};

    const LINEAR: Blend = Blend::Played(Interpolation::Linear);

    /// A shoulder turns by 90 degrees in a second, and back in a second; the other by less.
    fn animation(scene: &SceneGraph) -> Animation {
        turning(scene, [0.0, 0.0, 90.0, 0.0, 0.0])
    }

    fn turning(scene: &SceneGraph, degrees: [f32; 5]) -> Animation {
        let nodes = ["robot1/right_shoulder", "robot2/right_shoulder"].map(|path| scene.find_rbt(path).unwrap());
        let keyframe = |degrees: f32| {
            let mut pose = scene.rest_pose().clone();
            for (node, part) in nodes.into_iter().zip([0.9, 1.0]) {
                let rest = pose.get(node);
                let turn = Quat::from_rotation_z((part * degrees).to_radians());
                pose.set(node, Rbt::new(rest.translation, turn));
            }
            Keyframe::new(pose)
        };
        let keyframes = KeyframeList::new(degrees.map(keyframe).to_vec());
        Animation { keyframes, interpolation: Interpolation::Linear, ms_between_keyframes: 1000 }
    }

    fn speeds(animation: &Animation, key_times: [f64; 2]) -> Speeds<'_> {
        Speeds { range: PlayRange::new(&animation.keyframes).unwrap(), animation, key_times }
    }

    #[test]
    fn a_quarter_turn_a_second_is_a_flat_line_by_slerp_only() {
        let scene = built_in_scene(DEFAULT_SCENE).unwrap();
        let animation = animation(&scene);
        let speeds = speeds(&animation, [0.0, 2.0]);
        let node = speeds.fastest(scene.rbt_indices());
        assert_eq!(scene.rbt_path(node), "robot2/right_shoulder");
        let of = |blend| speeds.points(node, blend, 101);
        assert!(of(LINEAR).iter().all(|[_, speed]| (speed - 90.0).abs() < 0.02), "{:?}", of(LINEAR));
        for (blend, [least, most]) in [(Blend::Nlerp, [81.0, 94.93]), (Blend::Matrices, [57.3, 114.6])] {
            let found = of(blend);
            let speeds = found.iter().map(|point| point[1]);
            let range = [speeds.clone().fold(f64::INFINITY, f64::min), speeds.fold(0.0, f64::max)];
            assert!((range[0] - least).abs() < 0.5 && (range[1] - most).abs() < 0.1, "{blend:?}: {range:?}");
        }
        let times: Vec<f64> = of(LINEAR).iter().map(|point| point[0]).collect();
        assert_eq!([times[0], times[50], times[100]], [0.0, 1.0, 2.0]);
        assert_eq!(speeds.keyframes().collect::<Vec<_>>(), [0.0, 1.0, 2.0]);
    }

    #[test]
    fn a_part_has_the_time_of_the_part() {
        let scene = built_in_scene(DEFAULT_SCENE).unwrap();
        let animation = animation(&scene);
        let speeds = speeds(&animation, [0.5, 1.25]);
        let points = speeds.points(scene.find_rbt("robot1/right_shoulder").unwrap(), LINEAR, 4);
        assert_eq!(points.iter().map(|point| point[0]).collect::<Vec<_>>(), [0.0, 0.25, 0.5, 0.75]);
        assert!(points.iter().all(|[_, speed]| (speed - 81.0).abs() < 0.02), "{points:?}");
        assert_eq!(speeds.keyframes().collect::<Vec<_>>(), [1.0]);
    }

    #[test]
    fn the_end_of_a_part_has_the_speed_of_the_part() {
        let scene = built_in_scene(DEFAULT_SCENE).unwrap();
        let animation = turning(&scene, [0.0, 0.0, 90.0, 100.0, 100.0]);
        let speeds = speeds(&animation, [0.0, 1.0]);
        let points = speeds.points(scene.find_rbt("robot1/right_shoulder").unwrap(), LINEAR, 5);
        assert!(points.iter().all(|[_, speed]| (speed - 81.0).abs() < 0.02), "{points:?}");
    }

    #[test]
    fn matrices_that_turn_at_once_do_not_flatten_the_others() {
        let curve = |most: f64| vec![[0.0, 90.0], [1.0, most]];
        assert_eq!(shown_speed(&[LINEAR, Blend::Matrices], &[curve(90.0), curve(9000.0)]), 360.0);
        assert_eq!(shown_speed(&[LINEAR, Blend::Matrices], &[curve(90.0), curve(114.6)]), 114.6);
        assert_eq!(shown_speed(&[LINEAR, Blend::Nlerp], &[curve(90.0), curve(9000.0)]), 9000.0);
        assert_eq!(shown_speed(&[Blend::Matrices], &[curve(9000.0)]), 9000.0);
    }
}
