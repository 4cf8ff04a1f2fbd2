//! What a pull does with nodes.

use glam::{Affine3A, DQuat, DVec3, Vec3};

use super::{Axis, GizmoAxes, Pull};
use crate::editor::Editor;
use crate::editor::apply::CommandResult;
use crate::editor::placing::{move_label, turn_label};
use crate::pose::{Pose, RbtIndex};
use crate::rbt::Rbt;
use crate::words::Phrase;

impl Pull {
    const fn label(self, count: usize) -> Phrase {
        match self {
            Self::Turn { .. } => turn_label(count),
            Self::Move { .. } => move_label(count),
        }
    }
}

impl Editor {
    /// Pulls the chosen nodes as they are.
    pub(in crate::editor) fn pull_chosen(&mut self, pull: Pull) -> CommandResult {
        let from = self.edited_pose();
        self.pull_from(&from, pull)
    }

    /// Puts the chosen nodes where a pull takes them from where they are in a pose. What a moved node carries along is not moved twice.
    pub(in crate::editor) fn pull_from(&mut self, from: &Pose, pull: Pull) -> CommandResult {
        let primary = self.session.chosen.primary().ok_or_else(|| self.nothing_chosen())?;
        let (nodes, about) = match pull {
            Pull::Turn { .. } => (self.turned_nodes(), self.common_centre(from)),
            Pull::Move { .. } => (self.topmost_dragged(), None),
        };
        let placed = nodes.into_iter().map(|rbt| {
            let placed = match (pull, about) {
                (Pull::Turn { axis, degrees, axes }, Some(centre)) => {
                    let world_from_axes = self.axes_in_world(from, axes, primary).as_quat();
                    let motion = Rbt::from_rotation(turn(axis, degrees).as_quat());
                    self.moved_by(from, rbt, motion, Rbt::new(centre, world_from_axes))
                }
                _ => self.pulled(from, pull, rbt),
            };
            (rbt, placed)
        });
        let placed: Vec<(RbtIndex, Rbt)> = placed.collect();
        let label = pull.label(placed.len());
        self.change_nodes(placed, label, None)
    }

    /// A node's `parent_from_node` after a pull about its own origin. Not finite where the parent's space has no inverse.
    fn pulled(&self, from: &Pose, pull: Pull, rbt: RbtIndex) -> Rbt {
        let was = from.get(rbt);
        match pull {
            Pull::Turn { axis, degrees, axes } => {
                let turn = turn(axis, degrees);
                let rotation = match axes {
                    GizmoAxes::Local => was.rotation.as_dquat() * turn,
                    GizmoAxes::Parent => turn * was.rotation.as_dquat(),
                    GizmoAxes::World | GizmoAxes::View => {
                        let parent_from_world = self.axes_in_world(from, GizmoAxes::Parent, rbt).inverse();
                        let parent_from_axes = parent_from_world * self.axes_in_world(from, axes, rbt);
                        parent_from_axes * turn * parent_from_axes.conjugate() * was.rotation.as_dquat()
                    }
                };
                Rbt { rotation: rotation.normalize().as_quat(), ..was }
            }
            Pull::Move { by, axes } => {
                let by = DVec3::from(by);
                let by_in_parent = match axes {
                    GizmoAxes::Local => was.rotation.as_dquat() * by,
                    GizmoAxes::Parent => by,
                    GizmoAxes::World | GizmoAxes::View => {
                        let parent_from_world = self.world_from_parent(from, rbt).matrix3.as_dmat3().inverse();
                        parent_from_world * (self.axes_in_world(from, axes, rbt) * by)
                    }
                };
                Rbt { translation: (was.translation.as_dvec3() + by_in_parent).as_vec3(), ..was }
            }
        }
    }

    fn world_from_parent(&self, pose: &Pose, rbt: RbtIndex) -> Affine3A {
        self.scene().world_from_parent(pose, self.seconds(), rbt)
    }

    /// The turn from axes of a node in a pose to the world's, without the scales of control nodes.
    fn axes_in_world(&self, pose: &Pose, axes: GizmoAxes, rbt: RbtIndex) -> DQuat {
        let parent = || Rbt::from_affine(&self.world_from_parent(pose, rbt)).rotation.as_dquat();
        match axes {
            GizmoAxes::Local => parent() * pose.get(rbt).rotation.as_dquat(),
            GizmoAxes::Parent => parent(),
            GizmoAxes::World => DQuat::IDENTITY,
            GizmoAxes::View => self.world_from_eye(pose).rotation.as_dquat(),
        }
    }

    /// For a node in a pose: what a unit along each axis is in world space, with the scales of control nodes.
    pub(super) fn units_in_world(&self, pose: &Pose, axes: GizmoAxes, rbt: RbtIndex) -> [Vec3; 3] {
        let from_parent = |direction: Vec3| self.world_from_parent(pose, rbt).transform_vector3(direction);
        Vec3::AXES.map(|axis| match axes {
            GizmoAxes::Local => from_parent(pose.get(rbt).rotation * axis),
            GizmoAxes::Parent => from_parent(axis),
            GizmoAxes::World => axis,
            GizmoAxes::View => self.world_from_eye(pose).rotation * axis,
        })
    }
}

/// In double precision, so that half a turn goes the way that programs in double precision go. Whole turns are left out first.
fn turn(axis: Axis, degrees: f64) -> DQuat {
    DQuat::from_axis_angle(DVec3::AXES[axis.index()], (degrees % 360.0).to_radians())
}
