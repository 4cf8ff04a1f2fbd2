//! Films and pictures of an animation: which moments, seen by whom, drawn and written. The window and the command line share it, so
//! that both write the same bytes.
//!
//! It draws on an adapter of its own and waits for nobody: the caller is told of each frame, and may end the work there. What is not
//! finished then is not kept. [`RenderRequest`] is the way in; [`Job`] is a request that owns what it needs, for a thread.

mod error;
mod ffmpeg;
mod job;
mod moments;
mod painter;
mod pipeline;
mod request;
mod stage;
mod times;
mod write;

pub use crate::keyframe::Animation;
pub use error::{ErrorKind, ExportError};
pub use ffmpeg::FfmpegError;
pub use job::Job;
pub use moments::{Moment, MomentPose, Moments, Source, Span};
pub use painter::{Painter, Size};
pub use pipeline::{Drawing, Watch};
pub use request::{PlannedRender, RenderRequest, Subject, check_format, check_sheet, write_picture};
pub use stage::{Stage, Viewpoint};
pub use times::{FrameTime, frame_times};
pub use write::{write_film, write_folder};
