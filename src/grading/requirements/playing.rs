//! An animation as it plays, tick by tick, in world space.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::ToPrimitive as _;

use crate::animation_diff::Played;
use crate::blend::AlignedAffine;
use crate::clock::TICKS_PER_SECOND;
use crate::keyframe::whole;
use crate::pose::Pose;
use crate::scene::SceneGraph;

/// The most ticks that are looked at. Of a longer animation as many are, evenly spread, and those about its keyframes.
const MOST_TICKS: usize = 10_000;
/// The most nodes that are placed, all in all: in a scene of many nodes fewer ticks are looked at.
const MOST_PLACED: usize = 2_000_000;
/// Ticks that are looked at, however many nodes there are.
const FEWEST_TICKS: usize = 200;

/// The scene at a tick.
pub struct Moment {
    /// The key time.
    pub key_time: f64,
    /// `world_from_node` of every node.
    pub world_from_node: Vec<AlignedAffine>,
}

/// An animation that plays in a scene.
pub struct Playing<'a> {
    /// The scene.
    pub scene: &'a SceneGraph,
    /// The animation.
    pub played: Played<'a>,
}

impl Playing<'_> {
    /// The scene at a tick; after the end, at the end. `None` where there is no pose.
    fn at(&self, tick: u64) -> Option<Moment> {
        let ms = BigRational::new(BigInt::from(tick) * 1000, BigInt::from(TICKS_PER_SECOND));
        let key_time = self.played.key_time_at(&ms);
        let mut pose = Pose::identity(0);
        self.played.range.pose_into(key_time, self.played.interpolation, &mut pose).ok()?;
        let seconds = tick as f64 / f64::from(TICKS_PER_SECOND);
        Some(Moment { key_time, world_from_node: self.scene.world_from_nodes(&pose, seconds) })
    }

    /// The ticks to look at, each together with the next, in order; and whether these are all.
    fn ticks(&self) -> (Vec<u64>, bool) {
        let to_tick = |ms: BigRational| {
            (ms * whole(TICKS_PER_SECOND as usize) / whole(1000)).to_integer().to_u64().unwrap_or(u64::MAX / 2)
        };
        let last = to_tick(self.played.length_ms());
        let most = (MOST_PLACED / self.scene.nodes().len().max(1)).clamp(FEWEST_TICKS, MOST_TICKS) as u64;
        if last < most {
            return ((0..=last).collect(), true);
        }
        let spread = (0..=most).map(|index| (u128::from(last) * u128::from(index) / u128::from(most)) as u64);
        let timing = self.played.range.timing();
        let ms_between = whole(self.played.ms_between_keyframes as usize);
        let at_keyframes = (0..=self.played.range.last_key_time())
            .take(most as usize)
            .map(|keyframe| to_tick(timing.at_keyframe(keyframe) * &ms_between))
            .flat_map(|tick| [tick.saturating_sub(1), tick]);
        let mut ticks: Vec<u64> = spread.chain(at_keyframes).collect();
        ticks.sort_unstable();
        ticks.dedup();
        (ticks, false)
    }

    /// Calls `look` with the scene at a tick and at the next, for the ticks to look at. The number of ticks, and whether these are all.
    pub fn each_step(&self, mut look: impl FnMut(&Moment, &Moment)) -> (usize, bool) {
        let (ticks, are_all) = self.ticks();
        let mut known: Option<(u64, Moment)> = None;
        for &tick in &ticks {
            let now = known.take().filter(|(of, _)| *of == tick).map(|(_, moment)| moment);
            let (Some(now), Some(next)) = (now.or_else(|| self.at(tick)), self.at(tick + 1)) else { continue };
            look(&now, &next);
            known = Some((tick + 1, next));
        }
        (ticks.len(), are_all)
    }
}
