//! Export of films and pictures: the moments, the camera, drawing and writing. The window and the command line share it, so both write the
//! same bytes.
//!
//! It draws on its own adapter and never blocks on the caller: a callback receives each frame and may cancel. Unfinished files are then
//! removed. [`RenderRequest`] is the entry point, and [`JoinRequest`] for films of pictures that are there; [`Job`] is a request that owns its data, for a thread.

mod child;
mod compared;
mod error;
mod exposure;
mod ffmpeg;
mod folder;
mod job;
mod join;
mod loose;
mod moments;
mod painter;
mod pictures;
mod pipeline;
mod request;
mod stage;
mod steps;
mod times;
mod write;

pub use crate::keyframe::Animation;
pub use compared::{Compared, Comparison, check_comparison};
pub use error::{ErrorKind, ExportError};
pub use exposure::{Exposed, Exposure, Focus, Shutter};
pub use ffmpeg::FfmpegError;
pub use folder::is_frame_name;
pub use job::Job;
pub use join::JoinRequest;
pub use moments::{Moment, MomentPose, Moments, Source, Span};
pub use painter::{Painter, Picture, Size};
pub use pictures::{Pictures, Take};
pub use pipeline::{Drawing, Scenery, Watch};
pub use request::{PlannedRender, RenderRequest, Subject, check_format, check_sheet, write_picture};
pub use stage::{Stage, Viewpoint};
pub use steps::{Step, Steps};
pub use times::{FrameTime, frame_times};
pub use write::{write_film, write_folder};
