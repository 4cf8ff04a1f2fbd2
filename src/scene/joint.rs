//! What reaching knows of an RBT node: the end of the limb that it ends, and how its joint turns. Poses and playback ignore it.

use glam::{DVec3, Vec3};
use serde::Deserialize;

use super::checks::NodeChecks;
use super::file::SceneError;
use super::write::numbers;
use crate::words::texts;

/// The first version of scene files with `reach`, `stands` and `limits`.
pub(super) const VERSION_OF_JOINTS: u32 = 3;
/// A shorter axis has no direction.
const SHORTEST_AXIS: f64 = 1e-6;

/// What a scene says of an RBT node as a joint. The default says nothing.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Joint {
    /// The end of the limb whose last node this is, in the node's space, in scene units.
    pub reach: Option<Vec3>,
    /// Whether that end stands on something, as a sole does: it can be kept in place while the body moves.
    pub stands: bool,
    /// How the joint turns when its limb reaches; `None`: freely.
    pub hinge: Option<Hinge>,
}

/// A joint that turns about one axis. An angle of 0 is the node's rest rotation; angles are right-handed about the axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hinge {
    /// The axis in the node's space, of any length but 0. Turning about it leaves it where it is.
    pub axis: Vec3,
    /// The smallest and the largest angle in degrees, from -180 to 180.
    pub degrees: [f32; 2],
}

impl Hinge {
    /// The axis in the node's space, of unit length.
    #[must_use]
    pub fn unit_axis(&self) -> DVec3 {
        self.axis.as_dvec3().normalize()
    }

    /// The smallest and the largest angle in radians.
    #[must_use]
    pub fn range(&self) -> [f64; 2] {
        self.degrees.map(|degrees| f64::from(degrees).to_radians())
    }
}

/// The object `limits` of a scene file. Other kinds of limits would stand beside `hinge`.
#[derive(Clone, Copy, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct LimitsText {
    hinge: HingeText,
}

#[derive(Clone, Copy, Deserialize)]
#[serde(deny_unknown_fields)]
struct HingeText {
    axis: [f32; 3],
    degrees: [f32; 2],
}

/// The fields of a node in a scene file that make its joint.
#[derive(Clone, Copy)]
pub(super) struct JointText {
    pub reach: Option<[f32; 3]>,
    pub stands: Option<bool>,
    pub limits: Option<LimitsText>,
}

impl JointText {
    /// The first field that the file has; `None` if it has none.
    fn field(self) -> Option<&'static str> {
        let fields =
            [(self.reach.is_some(), "reach"), (self.stands.is_some(), "stands"), (self.limits.is_some(), "limits")];
        fields.into_iter().find_map(|(is_there, field)| is_there.then_some(field))
    }

    /// The joint, checked. `is_rbt`: whether the node is an RBT node; others have no joint.
    ///
    /// # Errors
    /// [`SceneError::Misplaced`] or [`SceneError::Value`]
    pub fn joint(self, checks: NodeChecks<'_>, is_rbt: bool, version: u32) -> Result<Joint, SceneError> {
        let misplaced = |field, reason| Err(SceneError::Misplaced { path: checks.path.to_owned(), field, reason });
        let Some(field) = self.field() else { return Ok(Joint::default()) };
        if version < VERSION_OF_JOINTS {
            return misplaced(field, texts::SCENE_FIELD_NEEDS_VERSION_3);
        }
        if !is_rbt {
            return misplaced(field, texts::SCENE_JOINT_OF_RBT);
        }
        if self.stands.is_some() && self.reach.is_none() {
            return misplaced("stands", texts::SCENE_STANDS_NEEDS_REACH);
        }
        let reach = self.reach.map(|end| checks.coordinates("reach", Vec3::from(end))).transpose()?;
        let hinge = self.limits.map(|limits| checks.hinge(limits.hinge)).transpose()?;
        Ok(Joint { reach, stands: self.stands == Some(true), hinge })
    }
}

impl NodeChecks<'_> {
    /// An axis with a direction, and angles from -180 to 180 degrees in order.
    fn hinge(self, text: HingeText) -> Result<Hinge, SceneError> {
        let axis = self.coordinates("limits.hinge.axis", Vec3::from(text.axis))?;
        if axis.as_dvec3().length() < SHORTEST_AXIS {
            return Err(self.error("limits.hinge.axis", format!("{axis}"), texts::SCENE_EXPECTED_AXIS));
        }
        let [low, high] = text.degrees;
        if -180.0 <= low && low <= high && high <= 180.0 {
            return Ok(Hinge { axis, degrees: text.degrees });
        }
        Err(self.error("limits.hinge.degrees", numbers(&text.degrees), texts::SCENE_EXPECTED_HINGE_DEGREES))
    }
}

/// The fields of a joint as a scene file has them.
pub(super) fn push_joint(fields: &mut Vec<String>, joint: &Joint) {
    if let Some(end) = joint.reach {
        fields.push(format!("\"reach\": {}", numbers(&end.to_array())));
    }
    if joint.stands {
        fields.push("\"stands\": true".to_owned());
    }
    if let Some(hinge) = joint.hinge {
        let (axis, degrees) = (numbers(&hinge.axis.to_array()), numbers(&hinge.degrees));
        fields.push(format!("\"limits\": {{ \"hinge\": {{ \"axis\": {axis}, \"degrees\": {degrees} }} }}"));
    }
}
