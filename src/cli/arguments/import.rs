//! Arguments of `import`.

use std::path::PathBuf;

use clap::Args;

use super::reduction::ReductionArguments;
use super::values::positive;

/// The long help.
pub const HELP: &str = "\
Make a scene of another program's file, and keyframes of its animation. What is read is told by its content: a glTF model (.glb or \
.gltf), or a BVH capture.

The nodes of a glTF model become RBT nodes, its meshes shapes below them, its cameras eyes; the meshes go to a .glb file beside the \
scene, or into the scene where that goes to standard output. The joints of a capture become RBT nodes, its bones capsules; it gets the \
height of the robots and stands on the ground. The report says what was taken, simplified and left out.";

/// Arguments of `import`.
#[derive(Debug, Args)]
pub struct ImportArguments {
    /// The file to read: a glTF model of at most 512 MiB, or a BVH capture of at most 256 MiB.
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
    /// The animation of a glTF model, by its name or its number from 0 [default: the first].
    #[arg(long, value_name = "NAME|N")]
    pub animation: Option<String>,
    /// The scene of a glTF model, by its number from 0 [default: the file's own].
    #[arg(long, value_name = "N")]
    pub gltf_scene: Option<usize>,
    /// Make timed keys of control nodes, with the times of the glTF model, in place of keyframes.
    #[arg(long)]
    pub timed: bool,
    /// How the animation becomes keyframes.
    #[command(flatten)]
    pub reduction: ReductionArguments,
    /// Print the report as a JSON object: input, scene, keyframes, notes.
    #[arg(long)]
    pub json: bool,
}
