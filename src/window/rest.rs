//! The picture at rest: once nothing has moved for a while, the scene refines itself, one sub-frame at a time, and then sleeps.

use std::time::Duration;

use web_time::Instant;

use super::now;
use super::shell::Shell;
use super::stage::WindowSurface;
use crate::film::Quality;
use crate::frame::Frame;
use crate::render::{Gpu, Refinement, Refiner, Viewport};

/// How far the picture is refined.
pub const AT_REST: Refinement = Refinement::of(Quality::GOOD.sub_frames());
/// The time without any change before the first sub-frame.
const REST: Duration = Duration::from_millis(150);
/// The time after which the driver is asked again whether it has drawn a sub-frame.
const PAUSE: Duration = Duration::from_millis(2);
/// The first number of sub-frames whose mean is shown; then twice as many, and so on.
const FIRST_SHOWN: u32 = 4;

/// The sub-frames of what the window shows.
pub struct RestingPicture {
    refiner: Refiner,
    /// What they are of; `None` before the first.
    of: Option<(Frame, Viewport)>,
}

impl RestingPicture {
    /// No sub-frames yet, for views of a format.
    pub fn new(gpu: &Gpu, format: wgpu::TextureFormat) -> Self {
        Self { refiner: Refiner::new(gpu, format, AT_REST), of: None }
    }

    /// The refiner, if it has enough sub-frames of a frame to show it. Where the scene is another, there are none any more.
    pub fn of(&mut self, frame: &Frame, viewport: Viewport) -> Option<&mut Refiner> {
        let (resting, its_viewport) = self.of.as_ref()?;
        if *its_viewport != viewport || !resting.has_same_scene(frame) {
            self.restart();
        }
        (self.refiner.count() >= FIRST_SHOWN).then_some(&mut self.refiner)
    }

    /// Forgets its sub-frames.
    pub fn restart(&mut self) {
        self.of = None;
        self.refiner.restart();
    }

    /// Adds a sub-frame of what is shown, unless the driver still draws one.
    pub fn go_on(&mut self, gpu: &Gpu, shown: &(Frame, Viewport)) -> Next {
        // An error is reported when the next picture is drawn.
        if !gpu.device.poll(wgpu::PollType::Poll).is_ok_and(|status| status.is_queue_empty()) {
            return Next::Wait;
        }
        let (frame, Viewport { width, height, .. }) = self.of.get_or_insert_with(|| shown.clone());
        self.refiner.add(gpu, frame, [*width, *height]);
        let count = self.refiner.count();
        if self.is_whole() || count >= FIRST_SHOWN && count.is_power_of_two() { Next::Show } else { Next::Wait }
    }

    /// Whether there is at least one sub-frame.
    pub const fn is_begun(&self) -> bool {
        self.refiner.count() > 0
    }

    /// Whether all sub-frames are there.
    pub fn is_whole(&self) -> bool {
        self.refiner.next().is_none()
    }
}

/// What follows a sub-frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Next {
    /// Another one, a little later.
    Wait,
    /// The mean is shown.
    Show,
}

impl Shell {
    /// When the next sub-frame is due: none while something moves or is held, or where all of them are there.
    pub(super) fn plan_rest(&mut self) {
        let is_busy = self.editor.wants_ticks() || self.editor.is_dragging() || self.hands.is_held();
        let is_wanted = self.settings_file.settings.refine_at_rest && !is_busy && self.drawn_eye().is_none();
        let Some(stage) = &mut self.stage else { return };
        if let (false, Some(resting)) = (is_wanted, &mut stage.resting) {
            resting.restart();
        }
        let resting = stage.resting.as_ref();
        let pause = if resting.is_some_and(RestingPicture::is_begun) { Duration::ZERO } else { REST };
        let is_due = is_wanted && !resting.is_some_and(RestingPicture::is_whole);
        self.rest_due = now().checked_add(pause).filter(|_| is_due);
    }

    /// Adds a sub-frame where one is due.
    pub(super) fn make_sub_frame(&mut self, at: Instant) {
        if self.rest_due.is_none_or(|due| due > at) {
            return;
        }
        self.rest_due = at.checked_add(PAUSE);
        if self.stage.as_mut().and_then(WindowSurface::refine) == Some(Next::Show) {
            // After it is drawn, the next one is planned.
            self.rest_due = None;
            self.request_redraw();
        }
    }
}
