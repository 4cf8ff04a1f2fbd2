//! Arguments of `export`.

use std::path::PathBuf;

use clap::{Args, ValueEnum};

use super::values::interpolation;
use crate::interpolation::Interpolation;

/// The long help.
pub const HELP: &str = "\
Write the scene and an animation as a file of another program. The ending of OUT names the format: .bvh has the RBT nodes as joints, and \
a frame for each time. The report says what was left out.";

/// Arguments of `export`.
#[derive(Debug, Args)]
pub struct ExportArguments {
    /// Keyframes: a keyframe file or a text, of at most 1 GiB; without it, the scene's rest pose is written.
    #[arg(value_name = "FILE")]
    pub file: Option<PathBuf>,
    /// The file to write.
    #[arg(short, long, value_name = "OUT.bvh")]
    pub output: PathBuf,
    /// The format, where OUT has no ending that names it, as - has none.
    #[arg(long, value_enum)]
    pub format: Option<ModelFormat>,
    /// Frames a second, 1 to 1000.
    #[arg(long, value_name = "N", default_value_t = 60, value_parser = clap::value_parser!(u32).range(1..=1000))]
    pub fps: u32,
    /// The interpolation to use instead of the file's.
    #[arg(long, value_name = "NAME", requires = "file", value_parser = interpolation())]
    pub interpolation: Option<Interpolation>,
    /// Print the report as a JSON object: output, format, notes.
    #[arg(long)]
    pub json: bool,
}

/// A format of scenes and animations of other programs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum ModelFormat {
    /// Motion capture: a tree of joints, and their channels in frames.
    Bvh,
}

impl ModelFormat {
    /// The ending of a file in this format.
    pub fn ending(self) -> &'static str {
        match self {
            Self::Bvh => "bvh",
        }
    }
}
