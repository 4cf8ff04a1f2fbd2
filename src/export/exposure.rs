//! How a camera takes a refined picture: how long its shutter is open, and what is in focus.

use super::stage::Stage;
use super::{ExportError, Moment};
use crate::frame::Frame;

/// The time for which the shutter is open.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Shutter {
    /// As an angle of a turning shutter, in degrees: 360 is the time from one frame to the next. 0 is a moment.
    pub degrees: f64,
    /// Whether it closes at the frame's moment. Otherwise that moment is the middle of its time.
    pub trails: bool,
}

/// A lens that is sharp at a node.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Focus<'a> {
    /// The node's path.
    pub node: &'a str,
    /// The focal length over the diameter of the lens's opening.
    pub f_stop: f32,
}

/// How a camera takes a refined picture.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Exposure<'a> {
    /// The shutter.
    pub shutter: Shutter,
    /// The lens; `None` is a point, to which everything is sharp.
    pub focus: Option<Focus<'a>>,
}

/// The height of the camera's sensor in scene units: that of a photographer's 24 mm, if a scene unit is 10 cm, as for a robot on a desk.
const SENSOR_HEIGHT: f32 = 0.24;

impl Focus<'_> {
    /// Half the width of the lens's opening in scene units, for a vertical field of view in radians.
    pub(super) fn radius(&self, vertical_fov: f32) -> f32 {
        let focal_length = 0.5 * SENSOR_HEIGHT / (0.5 * vertical_fov).tan();
        0.5 * focal_length / self.f_stop
    }
}

/// A shutter's time in a film.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct OpenTime {
    /// How long it is open, in seconds.
    pub seconds: f64,
    /// How far the turntable turns meanwhile, in turns.
    pub turn: f64,
    /// The part of its time before the frame's moment.
    pub before: f64,
}

impl Shutter {
    /// The usual shutter of films, open for half of each frame.
    pub const OF_FILMS: Self = Self { degrees: 180.0, trails: false };

    /// Its time in a film of `frames` at a rate. The turntable turns once in all of them.
    pub(super) fn open_time(self, fps: u32, frames: usize) -> OpenTime {
        let of_frame = self.degrees / 360.0;
        OpenTime {
            seconds: of_frame / f64::from(fps),
            turn: of_frame / frames.max(1) as f64,
            before: if self.trails { 1.0 } else { 0.5 },
        }
    }
}

/// One picture: the frame at its moment, and how it looks while the shutter is open.
pub struct Exposed<'a> {
    /// The frame at the picture's moment.
    pub frame: Frame,
    moving: Option<(&'a Stage<'a>, &'a Moment)>,
}

impl<'a> Exposed<'a> {
    /// A picture in which nothing moves while the shutter is open.
    #[must_use]
    pub const fn still(frame: Frame) -> Self {
        Self { frame, moving: None }
    }

    /// A picture of a stage at a moment.
    ///
    /// # Errors
    /// [`ExportError`]: the moment does not exist.
    pub fn of_stage(stage: &'a Stage<'a>, moment: &'a Moment) -> Result<Self, ExportError> {
        let moving = stage.is_open().then_some((stage, moment));
        Ok(Self { frame: stage.frame(moment)?, moving })
    }

    /// The frame after a part of the shutter's time, 0 to 1; `None` if it is the same for all.
    pub(super) fn moved(&self, shutter: f64) -> Result<Option<Frame>, ExportError> {
        self.moving.map(|(stage, moment)| stage.frame_in_shutter(moment, shutter)).transpose()
    }
}

impl From<Frame> for Exposed<'_> {
    fn from(frame: Frame) -> Self {
        Self::still(frame)
    }
}
