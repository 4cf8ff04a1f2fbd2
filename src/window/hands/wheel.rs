//! The wheel, scrolling on a touchpad, and two fingers that move apart: what they do with the view.

use glam::Vec2;
use winit::event::MouseScrollDelta;

use super::{Desk, Hands};
use crate::camera::Camera;
use crate::editor::{Command, Edit, ViewCommand, WorkEye};

/// Pixels of a touchpad's scrolling that are as much as one notch of a wheel.
const PIXELS_PER_NOTCH: f32 = 50.0;
/// Notches of a wheel that are as much as fingers that move apart by their whole distance.
const NOTCHES_PER_PINCH: f32 = 7.0;

/// What is scrolled.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Scroll {
    /// So many notches of a wheel, away from the user.
    Notches(f32),
    /// So many pixels on a touchpad (Wayland, macOS).
    Pixels(Vec2),
    /// Two fingers move apart by this part of their distance, or together.
    Pinch(f32),
}

impl Scroll {
    #[expect(clippy::cast_possible_truncation, reason = "scrolling is small")]
    const fn of(delta: MouseScrollDelta) -> Self {
        match delta {
            MouseScrollDelta::LineDelta(_, lines) => Self::Notches(lines),
            MouseScrollDelta::PixelDelta(by) => Self::Pixels(Vec2::new(by.x as f32, by.y as f32)),
        }
    }

    /// As notches of a wheel.
    fn notches(self) -> f32 {
        match self {
            Self::Notches(notches) => notches,
            Self::Pixels(by_px) => by_px.y / PIXELS_PER_NOTCH,
            Self::Pinch(by) => by * NOTCHES_PER_PINCH,
        }
    }

    /// Where the work eye goes: pixels pan, all else zooms to the pointer; with Ctrl, pixels zoom as well.
    fn moved(self, eye: WorkEye, is_ctrl_held: bool, at_px: Vec2, camera: &Camera) -> WorkEye {
        match self {
            Self::Pixels(by_px) if !is_ctrl_held => eye.panned(by_px, camera),
            _ => eye.zoomed(self.notches(), at_px, camera),
        }
    }
}

impl Hands {
    /// Two fingers on a touchpad moved apart, or together: by so much of their distance.
    pub fn pinch(&self, desk: &mut dyn Desk, by: f64) {
        if desk.editor().is_work_eye() && desk.is_over_scene(self.pointer_px) {
            #[expect(clippy::cast_possible_truncation, reason = "fingers are short")]
            self.scroll(desk, Scroll::Pinch(by as f32));
        }
    }

    /// The wheel turns, or two fingers scroll.
    pub fn wheel(&mut self, desk: &mut dyn Desk, delta: MouseScrollDelta) {
        let scroll = Scroll::of(delta);
        if desk.is_over_scene(self.pointer_px) && !self.wheel_limb(desk, scroll.notches()) {
            self.scroll(desk, scroll);
        }
    }

    fn scroll(&self, desk: &mut dyn Desk, scroll: Scroll) {
        let Some(view) = desk.view() else { return };
        let camera = view.camera(desk.editor());
        if desk.editor().is_work_eye() {
            let (eye, at_px) = (desk.editor().session().work_eye, view.inside(self.pointer_px));
            let eye = scroll.moved(eye, self.modifiers.control_key(), at_px, &camera);
            desk.apply(Command::View(ViewCommand::SetWorkEye(eye)));
        } else if scroll.notches() != 0.0 {
            let motion = desk.editor().manipulation(&camera).wheel(scroll.notches());
            desk.apply(Command::Edit(Edit::Wheel(motion)));
        }
        desk.request_redraw();
    }
}

#[cfg(test)]
mod tests {
    use winit::dpi::PhysicalPosition;

    use super::*;

    fn camera(eye: WorkEye) -> Camera {
        Camera { world_from_eye: eye.world_from_eye(), vertical_fov: 1.0, size_px: Vec2::new(640.0, 480.0) }
    }

    #[test]
    fn lines_and_fingers_zoom_to_the_pointer_and_pixels_pan() {
        let eye = WorkEye::default();
        let (before, at_px) = (camera(eye), Vec2::new(500.0, 100.0));
        let ray = before.ray_through(at_px);
        let under_pointer = ray.origin_in_world + ray.direction_in_world * eye.distance;
        let lines = Scroll::of(MouseScrollDelta::LineDelta(0.0, 2.0));
        let pixels = Scroll::of(MouseScrollDelta::PixelDelta(PhysicalPosition::new(30.0, 100.0)));
        for (scroll, is_ctrl_held, nearer, by_px) in [
            (lines, false, true, Vec2::ZERO),
            (lines, true, true, Vec2::ZERO),
            (Scroll::of(MouseScrollDelta::LineDelta(0.0, -1.0)), false, false, Vec2::ZERO),
            (pixels, true, true, Vec2::ZERO),
            (pixels, false, false, Vec2::new(30.0, 100.0)),
            (Scroll::Pinch(0.2), false, true, Vec2::ZERO),
            (Scroll::Pinch(-0.2), true, false, Vec2::ZERO),
        ] {
            let moved = scroll.moved(eye, is_ctrl_held, at_px, &before);
            assert_eq!(moved.distance < eye.distance, nearer, "{scroll:?}");
            let (seen_px, _) = camera(moved).project(under_pointer).unwrap();
            assert!(seen_px.distance(at_px + by_px) < 1e-2, "{scroll:?}: {seen_px}");
            assert_ne!(moved, eye, "{scroll:?}");
        }
        assert_eq!(lines.moved(eye, false, at_px, &before), pixels.moved(eye, true, at_px, &before));
    }
}
