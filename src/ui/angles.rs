//! Rotations as yaw, pitch and roll in degrees: `q = qz(yaw) · qy(pitch) · qx(roll)`.

use egui::{Label, RichText, Ui};
use glam::{EulerRot, Quat};

use super::words::Words;
use crate::pose::RbtIndex;
use crate::rotation_rules::{beyond_half_turn, rotation_from_euler_degrees};

/// Yaw, pitch and roll of a rotation, in degrees: yaw and roll within ±180, pitch within ±90. -0 becomes 0.
#[must_use]
pub fn degrees_from_rotation(rotation: Quat) -> [f32; 3] {
    let (yaw, pitch, roll) = rotation.normalize().to_euler(EulerRot::ZYX);
    [yaw, pitch, roll].map(|radians| radians.to_degrees() + 0.0)
}

/// Says of angles in degrees that were typed or dragged beyond half a turn what smaller one they are.
pub fn say_of_angles(ui: &mut Ui, degrees: [f32; 3]) {
    // Rounded, so that 360.1 is not 360.1000061.
    let note = degrees.into_iter().find_map(|degrees| beyond_half_turn((f64::from(degrees) * 1e3).round() / 1e3));
    if let Some(note) = note {
        let text = RichText::new(Words::of(ui).message(note)).small().color(ui.visuals().warn_fg_color);
        ui.add(Label::new(text).wrap());
    }
}

/// The angles last shown for a node, so that they stay as they were typed, although one rotation has many.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ShownAngles {
    shown: Option<(RbtIndex, [f32; 3])>,
}

impl ShownAngles {
    /// What to show for a node's rotation: what was shown before where that still means it.
    pub fn of(&mut self, rbt: RbtIndex, rotation: Quat) -> [f32; 3] {
        if let Some((shown_rbt, degrees)) = self.shown
            && shown_rbt == rbt
            && rotation_from_euler_degrees(degrees).dot(rotation).abs() > 1.0 - 1e-6
        {
            return degrees;
        }
        let degrees = degrees_from_rotation(rotation);
        self.shown = Some((rbt, degrees));
        degrees
    }

    /// These angles were set.
    pub const fn set(&mut self, rbt: RbtIndex, degrees: [f32; 3]) {
        self.shown = Some((rbt, degrees));
    }
}

/// A unit quaternion (x, y, z, w) with one component set, and the others scaled to make room. Where the others are all zero they
/// cannot say in which direction, and the component becomes 1 or −1.
#[must_use]
pub fn with_component(rotation: Quat, component: usize, value: f32) -> Quat {
    let mut parts = rotation.to_array();
    let value = value.clamp(-1.0, 1.0);
    parts[component] = 0.0;
    let others = parts.iter().map(|part| part * part).sum::<f32>().sqrt();
    if others > 1e-6 {
        let scale = (1.0 - value * value).sqrt() / others;
        parts = parts.map(|part| part * scale);
        parts[component] = value;
    } else {
        parts[component] = 1.0_f32.copysign(value);
    }
    Quat::from_array(parts)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(degrees: [f32; 3]) {
        let back = degrees_from_rotation(rotation_from_euler_degrees(degrees));
        for (given, got) in degrees.into_iter().zip(back) {
            assert!((given - got).abs() < 1e-3, "{degrees:?} came back as {back:?}");
        }
    }

    #[test]
    fn angles_come_back() {
        check([0.0, 0.0, 0.0]);
        check([45.0, 0.0, 0.0]);
        check([0.0, 45.0, 0.0]);
        check([0.0, 0.0, 45.0]);
        check([-170.0, 80.0, 33.0]);
    }

    #[test]
    fn yaw_is_about_z() {
        let turned = rotation_from_euler_degrees([90.0, 0.0, 0.0]) * glam::Vec3::X;
        assert!(turned.distance(glam::Vec3::Y) < 1e-6);
    }

    #[test]
    fn what_was_typed_stays() {
        let mut shown = ShownAngles::default();
        let rbt = RbtIndex::new(3);
        shown.set(rbt, [0.0, 135.0, 0.0]);
        let rotation = rotation_from_euler_degrees([0.0, 135.0, 0.0]);
        assert_eq!(shown.of(rbt, -rotation).map(f32::to_bits), [0.0, 135.0, 0.0].map(f32::to_bits));
        assert!(shown.of(RbtIndex::new(4), rotation)[1] < 91.0);
    }

    #[test]
    fn a_component_stays_as_typed() {
        let turned = with_component(Quat::IDENTITY, 1, 0.6);
        assert!((turned.w - 0.8).abs() < 1e-6 && (turned.length() - 1.0).abs() < 1e-6);
        assert_eq!(with_component(Quat::IDENTITY, 3, 0.5), Quat::IDENTITY);
    }
}
