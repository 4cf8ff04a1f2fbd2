//! Arguments of `info`.

use std::path::PathBuf;

use clap::Args;

use crate::film::MOST_FRAMES_PER_SECOND;

/// Arguments of `info`.
#[derive(Debug, Args)]
pub struct InfoArguments {
    /// The keyframes, keyframe files or texts, of at most 1 GiB each; without any, the scene alone is described.
    #[arg(value_name = "FILE")]
    pub files: Vec<PathBuf>,
    /// Frames a second of the film whose frames are counted.
    #[arg(long, value_name = "N", default_value_t = 30, value_parser = clap::value_parser!(u32).range(1..=i64::from(MOST_FRAMES_PER_SECOND)))]
    pub fps: u32,
    /// Print JSON; of several files an object in a line each.
    #[arg(long)]
    pub json: bool,
}
