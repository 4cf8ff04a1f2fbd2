//! Arguments of `import`.

use std::path::PathBuf;

use clap::Args;

use super::reduction::ReductionArguments;
use super::values::positive;

/// The long help.
pub const HELP: &str = "\
Make a scene of another program's file, and keyframes of its animation. What is read is told by its content: a BVH capture. Its joints \
become RBT nodes, its bones capsules; it gets the height of the robots and stands on the ground. The report says what was taken, \
simplified and left out.";

/// Arguments of `import`.
#[derive(Debug, Args)]
pub struct ImportArguments {
    /// The file to read: a BVH capture of at most 256 MiB.
    #[arg(value_name = "MODEL")]
    pub file: PathBuf,
    /// The scene file to write.
    #[arg(short, long, value_name = "SCENE.json")]
    pub output: PathBuf,
    /// The keyframe file to write, if the model has an animation.
    #[arg(long, value_name = "OUT.json")]
    pub keyframes: Option<PathBuf>,
    /// Scene units for one unit of a capture [default: what makes it as tall as the robots, 4.3 units].
    #[arg(long, value_name = "FACTOR", value_parser = positive)]
    pub scale: Option<f64>,
    /// How the animation becomes keyframes.
    #[command(flatten)]
    pub reduction: ReductionArguments,
    /// Print the report as a JSON object: input, scene, keyframes, notes.
    #[arg(long)]
    pub json: bool,
}
