//! Reaching with a limb of two bones, in closed form (inverse kinematics).
//!
//! The upper bone turns freely about the root joint. The lower bone turns about a hinge that the upper bone carries, within a range of
//! angles. So the distance from the root joint to the limb's end depends on the hinge's angle alone, and the upper bone turns the end
//! to any direction: the nearest point that can be reached lies on the ray to the target.
//!
//! All is in the space that carries the root joint, with that joint at the origin.

use std::f64::consts::{PI, TAU};

use glam::{DQuat, DVec3};

/// Parts of the limb's length that count as nothing: no direction is taken from them.
const NOTHING: f64 = 1e-9;
/// A bend by less, as a sine, is straight: which side it bends to is not taken from it.
const STRAIGHT: f64 = 1e-6;
/// The cosine of a turn of the end's direction from which on the limb turns in its own plane first. A target that passes the root joint
/// jumps to the opposite direction, and the shortest turn there would leave the plane by chance.
const BACKWARDS: f64 = -0.9;

/// The measures of a limb.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limb {
    /// From the root joint to the hinge, in the upper node's space.
    pub upper: DVec3,
    /// From the hinge to the end at a hinge angle of 0, in the upper node's space.
    pub lower: DVec3,
    /// The hinge's axis in the upper node's space, of unit length.
    pub axis: DVec3,
    /// The smallest and the largest angle of the hinge in radians, right-handed about the axis; at most a turn apart.
    pub range: [f64; 2],
}

/// How a limb stands.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stance {
    /// The upper node's rotation; unit.
    pub root: DQuat,
    /// The hinge's angle in radians.
    pub angle: f64,
}

impl Limb {
    /// A limb whose lower bone may turn freely, which reaches by bending in the plane in which it is bent now, to that side.
    /// `lower`: as the lower bone stands now. `straight_axis`: the axis of the bend where the bones are in line; unit.
    #[must_use]
    pub fn free(upper: DVec3, lower: DVec3, straight_axis: DVec3) -> Self {
        let normal = upper.cross(lower);
        let is_straight = normal.length() <= STRAIGHT * upper.length() * lower.length();
        let axis = match normal.try_normalize() {
            Some(axis) if !is_straight => axis,
            _ => {
                let along = upper.try_normalize().or_else(|| lower.try_normalize()).unwrap_or(DVec3::X);
                let across = straight_axis - along * straight_axis.dot(along);
                across.try_normalize().unwrap_or_else(|| along.any_orthonormal_vector())
            }
        };
        let limb = Self { upper, lower, axis, range: [0.0; 2] };
        let straight = limb.straight_angle();
        Self { range: [straight, straight + PI], ..limb }
    }

    /// The end at a hinge angle, in the upper node's space.
    fn end_in_upper(&self, angle: f64) -> DVec3 {
        self.upper + DQuat::from_axis_angle(self.axis, angle) * self.lower
    }

    /// The end, from the root joint.
    #[must_use]
    pub fn end(&self, stance: Stance) -> DVec3 {
        stance.root * self.end_in_upper(stance.angle)
    }

    /// The parts of the bones across the hinge's axis, which the hinge turns against each other.
    fn across(&self) -> (DVec3, DVec3) {
        let across = |bone: DVec3| bone - self.axis * bone.dot(self.axis);
        (across(self.upper), across(self.lower))
    }

    /// The hinge angle at which the end is farthest from the root joint, from -π to π.
    fn straight_angle(&self) -> f64 {
        let (upper, lower) = self.across();
        angle_about(self.axis, lower, upper)
    }

    /// The squared distance from the root joint to the end is the first number plus the second times the cosine of the angle from straight.
    fn squared_distance(&self) -> (f64, f64) {
        let (upper, lower) = self.across();
        let along = self.upper.dot(self.axis) + self.lower.dot(self.axis);
        (upper.length_squared() + lower.length_squared() + along * along, 2.0 * upper.length() * lower.length())
    }

    /// The distances that the range of the hinge allows: the smallest and the largest.
    #[must_use]
    pub fn distances(&self) -> [f64; 2] {
        let (constant, swing) = self.squared_distance();
        let straight = self.straight_angle();
        let [low, high] = self.range;
        let distance = |angle: f64| (constant + swing * (angle - straight).cos()).max(0.0).sqrt();
        let is_within = |angle: f64| low + (angle - low).rem_euclid(TAU) <= high;
        let ends = [distance(low), distance(high)];
        let smallest = if is_within(straight + PI) { distance(straight + PI) } else { ends[0].min(ends[1]) };
        let largest = if is_within(straight) { distance(straight) } else { ends[0].max(ends[1]) };
        [smallest, largest]
    }

    /// The angle of the hinge that brings the end as near to a distance as the range allows, on the side to which the limb is bent.
    fn angle_for(&self, distance: f64, now: f64) -> f64 {
        let (constant, swing) = self.squared_distance();
        let [low, high] = self.range;
        let length = self.upper.length() + self.lower.length();
        if swing <= NOTHING * length * length {
            return now.clamp(low, high);
        }
        let [smallest, largest] = self.distances();
        let distance = distance.clamp(smallest, largest);
        let bend = ((distance * distance - constant) / swing).clamp(-1.0, 1.0).acos();
        let straight = self.straight_angle();
        let middle = f64::midpoint(low, high);
        let side = |angle: f64| (angle - straight).sin();
        let positive = if side(now).abs() > STRAIGHT { side(now) > 0.0 } else { side(middle) >= 0.0 };
        // As far outside of the range, where rounding leaves an angle at its end.
        let outside = |angle: f64| (low - angle).max(angle - high).max(0.0);
        let in_turn = |angle: f64| {
            let angle = middle + (angle - middle + PI).rem_euclid(TAU) - PI;
            [angle, angle - TAU, angle + TAU]
                .into_iter()
                .min_by(|a, b| outside(*a).total_cmp(&outside(*b)))
                .unwrap_or(angle)
        };
        let (wanted, other) = (in_turn(straight + bend), in_turn(straight - bend));
        let (wanted, other) = if positive { (wanted, other) } else { (other, wanted) };
        let is_allowed = outside(wanted) <= outside(other) + STRAIGHT;
        (if is_allowed { wanted } else { other }).clamp(low, high)
    }

    /// How the limb stands after its end has gone as near to a target as the bones and the range allow.
    ///
    /// The lower bone stays on its side of the upper one, and the plane of the two goes along with the shortest turn of the end's
    /// direction. The result is finite, and continuous in target and stance but where the target passes the root joint.
    #[must_use]
    pub fn reach(&self, from: Stance, target: DVec3) -> Stance {
        let angle = self.angle_for(target.length(), from.angle);
        let (before, after) = (self.end_in_upper(from.angle), self.end_in_upper(angle));
        let nothing = NOTHING * (self.upper.length() + self.lower.length());
        if after.length() <= nothing {
            return Stance { root: from.root, angle };
        }
        // Bending turns the end's direction in the plane of the bones: the upper bone turns back by as much.
        let back = if before.length() <= nothing { 0.0 } else { angle_about(self.axis, after, before) };
        let root = from.root * DQuat::from_axis_angle(self.axis, back);
        let root = match target.try_normalize() {
            Some(direction) if target.length() > nothing => {
                shortest_turn(root * after.normalize(), direction, root * self.axis) * root
            }
            _ => root,
        };
        Stance { root: root.normalize(), angle }
    }

    /// The limb turned by radians about the line from its root joint to its end, right-handed along it. The end stays where it is.
    /// `None` if the end is at the root joint.
    #[must_use]
    pub fn swivelled(&self, stance: Stance, radians: f64) -> Option<Stance> {
        let nothing = NOTHING * (self.upper.length() + self.lower.length());
        let along = self.end(stance);
        if along.length() <= nothing {
            return None;
        }
        let turn = DQuat::from_axis_angle(along.normalize(), radians);
        Some(Stance { root: (turn * stance.root).normalize(), ..stance })
    }

    /// The limb turned about the line from its root joint to its end, so that the last node turns as little as possible from a rotation.
    /// `last_from_upper`: the rotation from the last node's space to the upper node's at a hinge angle of 0.
    #[must_use]
    pub fn facing(&self, stance: Stance, last_in_upper: DQuat, wanted: DQuat) -> Stance {
        let last = stance.root * DQuat::from_axis_angle(self.axis, stance.angle) * last_in_upper;
        let along = self.end(stance).try_normalize().unwrap_or(DVec3::Y);
        // The part of `wanted * last⁻¹` that turns about the line.
        let turn = wanted * last.conjugate();
        let (sine, cosine) = (turn.xyz().dot(along), turn.w);
        if sine.hypot(cosine) <= NOTHING {
            return stance;
        }
        self.swivelled(stance, 2.0 * sine.atan2(cosine)).unwrap_or(stance)
    }
}

/// The angle in radians by which the first vector turns about an axis to point where the second does, seen along the axis; 0 where one
/// of them has no direction there.
fn angle_about(axis: DVec3, from: DVec3, to: DVec3) -> f64 {
    let sine = axis.dot(from.cross(to));
    let cosine = from.dot(to) - axis.dot(from) * axis.dot(to);
    if sine == 0.0 && cosine == 0.0 { 0.0 } else { sine.atan2(cosine) }
}

/// The angle of a single hinge that brings the end of its bone as near to a target as the range allows.
///
/// `bone`: from the hinge to the end at an angle of 0. `now`: the angle that it keeps where all are equally near. `range`: the smallest
/// and the largest angle in radians, at most a turn apart.
#[must_use]
pub fn angle_towards(axis: DVec3, bone: DVec3, range: [f64; 2], now: f64, target: DVec3) -> f64 {
    let across = |vector: DVec3| vector - axis * vector.dot(axis);
    let [low, high] = range;
    if across(bone).length() <= NOTHING * bone.length() || across(target).length() <= NOTHING * bone.length() {
        return now.clamp(low, high);
    }
    let middle = f64::midpoint(low, high);
    // Beyond the range the nearer end of it is the nearest.
    let wanted = middle + (angle_about(axis, bone, target) - middle + PI).rem_euclid(TAU) - PI;
    wanted.clamp(low, high)
}

/// The shortest turn from one unit vector to another. Where they are nearly opposite, half a turn about `normal` comes first.
fn shortest_turn(from: DVec3, to: DVec3, normal: DVec3) -> DQuat {
    if from.dot(to) >= BACKWARDS {
        return DQuat::from_rotation_arc(from, to);
    }
    let across = (normal - from * normal.dot(from)).try_normalize().unwrap_or_else(|| from.any_orthonormal_vector());
    let half = DQuat::from_axis_angle(across, PI);
    DQuat::from_rotation_arc(half * from, to) * half
}

#[cfg(test)]
mod tests;
