//! The handles around the chosen node, as lines: over the scene, and faint behind it.

use std::sync::LazyLock;

use glam::Vec3;

use crate::colour::Colour;
use crate::editor::Editor;
use crate::editor::gizmo::{Gizmo, Handle, HandleKind};
use crate::frame::{Frame, Line};

const WIDTH_PX: f32 = 2.0;
/// The width of the handle that a press would take.
const LIT_WIDTH_PX: f32 = 3.5;
/// How much of its colour a handle has: at rest, at hand, and beside one at hand.
const AT_REST: f32 = 0.85;
const AT_HAND: f32 = 1.0;
const BESIDE: f32 = 1.0 / 3.0;
/// The same of the arcball.
const BALL: f32 = 0.5;
/// How much of that the far half of a ring has.
const FAR_HALF: f32 = 0.25;
/// The widths of an arrow's head from its foot to its tip, in pixels, and its length as a part of the arrow.
const HEAD_WIDTHS_PX: [f32; 5] = [11.0, 9.0, 7.0, 5.0, 3.0];
const HEAD: f32 = 0.4;
/// The lines that fill a square that is lit.
const FILLING: usize = 8;
/// How far the dark edge of a line reaches to each side, in pixels, and its share of the line's opacity: a red line shows on an orange
/// robot too.
const EDGE_PX: f32 = 1.0;
const EDGE: f32 = 0.5;
/// How much of white a handle has that a press would take.
const LIGHTER: f32 = 0.35;

/// Linear-light colours, computed once.
static AXES: LazyLock<[Vec3; 3]> = LazyLock::new(|| Colour::AXES.map(Colour::to_linear));
static ARCBALL: LazyLock<Vec3> = LazyLock::new(|| Colour::ARCBALL.to_linear());
static EDGES: LazyLock<Vec3> = LazyLock::new(|| Colour::BACKDROP.to_linear());
static IN_VIEW: LazyLock<Vec3> = LazyLock::new(|| Colour::TEXT.to_linear());

/// Adds the handles of the chosen node where they are shown, the one that is held in full and the others faint. Among them the arcball is
/// a circle: its wires would hide the rings.
pub(super) fn add_gizmo(frame: &mut Frame, editor: &Editor, gizmo: &Gizmo) {
    let held = editor.held();
    let strength = if held.is_some() { BALL * BESIDE } else { BALL };
    let colour = ARCBALL.extend(strength);
    frame.lines.extend(gizmo.arcball().map(|ends| {
        let [from_in_world, to_in_world] = ends.map(|end| gizmo.point_in_world(end));
        Line { from_in_world, to_in_world, colour, width_px: WIDTH_PX }
    }));
    if let Some(held) = held.filter(|held| held.kind == HandleKind::Move) {
        let guide = Stroke { strength: BESIDE, width_px: WIDTH_PX, lighter: 0.0 };
        frame.lines.push(guide.line(gizmo, held, gizmo.guide(held)));
    }
    let first = frame.lines.len();
    for handle in gizmo.handles().filter(|handle| Some(*handle) != held) {
        let strength = if held.is_some() { BESIDE } else { AT_REST };
        add_handle(frame, gizmo, handle, Stroke { strength, width_px: WIDTH_PX, lighter: 0.0 });
    }
    if let Some(held) = held {
        add_handle(frame, gizmo, held, Stroke { strength: AT_HAND, width_px: WIDTH_PX, lighter: 0.0 });
    }
    edge(frame, first);
}

/// Lays a dark edge under the lines from `first` on, but for faint ones: it would be stronger than they.
fn edge(frame: &mut Frame, first: usize) {
    let under = |line: &Line| Line {
        colour: EDGES.extend(EDGE * line.colour.w),
        width_px: line.width_px + 2.0 * EDGE_PX,
        ..*line
    };
    let edges: Vec<Line> = frame.lines[first..].iter().filter(|line| line.colour.w > 0.5).map(under).collect();
    frame.lines.splice(first..first, edges);
}

/// Lights the handle that a press would take.
pub fn light_handle(frame: &mut Frame, editor: &Editor, gizmo: &Gizmo, handle: Handle) {
    if editor.shows_gizmo() {
        let stroke = Stroke { strength: AT_HAND, width_px: LIT_WIDTH_PX, lighter: LIGHTER };
        let first = frame.lines.len();
        add_handle(frame, gizmo, handle, stroke);
        edge(frame, first);
        if handle.kind == HandleKind::Plane {
            fill_square(frame, gizmo, handle, stroke);
        }
    }
}

#[derive(Clone, Copy)]
struct Stroke {
    /// Opacity, 0 to 1.
    strength: f32,
    width_px: f32,
    /// How much of white it has.
    lighter: f32,
}

impl Stroke {
    fn line(self, gizmo: &Gizmo, handle: Handle, ends: [Vec3; 2]) -> Line {
        let own = if handle == Handle::TURN_IN_VIEW { *IN_VIEW } else { AXES[handle.axis.index()] };
        let colour = own.lerp(Vec3::ONE, self.lighter).extend(self.strength);
        let [from_in_world, to_in_world] = ends.map(|end| gizmo.point_in_world(end));
        Line { from_in_world, to_in_world, colour, width_px: self.width_px }
    }
}

fn add_handle(frame: &mut Frame, gizmo: &Gizmo, handle: Handle, stroke: Stroke) {
    for part in gizmo.parts(handle) {
        let strength = if part.is_behind { stroke.strength * FAR_HALF } else { stroke.strength };
        let stroke = Stroke { strength, ..stroke };
        let [from, to] = part.ends;
        if handle.kind != HandleKind::Move {
            frame.lines.push(stroke.line(gizmo, handle, part.ends));
            continue;
        }
        let foot = to.lerp(from, HEAD);
        frame.lines.push(stroke.line(gizmo, handle, [from, foot]));
        let mut before = foot;
        for (width_px, share) in HEAD_WIDTHS_PX.into_iter().zip([0.2, 0.4, 0.6, 0.8, 1.0]) {
            let width_px = width_px + stroke.width_px - WIDTH_PX;
            let after = foot.lerp(to, share);
            frame.lines.push(Stroke { width_px, ..stroke }.line(gizmo, handle, [before, after]));
            before = after;
        }
    }
}

fn fill_square(frame: &mut Frame, gizmo: &Gizmo, handle: Handle, stroke: Stroke) {
    let parts = gizmo.parts(handle);
    let [near, _, far, _] = parts.as_slice() else { return };
    let stroke = Stroke { strength: stroke.strength * 0.5, ..stroke };
    #[expect(clippy::cast_precision_loss, reason = "there are few lines")]
    for step in 1..FILLING {
        let share = step as f32 / FILLING as f32;
        let ends = [near.ends[0].lerp(near.ends[1], share), far.ends[1].lerp(far.ends[0], share)];
        frame.lines.push(stroke.line(gizmo, handle, ends));
    }
}
