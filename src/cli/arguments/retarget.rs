//! Arguments of `retarget`.

use std::path::PathBuf;

use clap::Args;

use super::reduction::ReductionArguments;

/// The long help.
pub const HELP: &str = "\
Give the motion of one skeleton to another one: of a BVH capture, or of keyframes of --scene. Legs, arms and head of both are told by \
their rest poses, and sides by where they are, whatever they are called. Feet that stand stay in place. --write-map writes which node \
follows which, to be edited and given as --map.";

/// Arguments of `retarget`.
#[derive(Debug, Args)]
pub struct RetargetArguments {
    /// The motion: a BVH capture of at most 256 MiB; or keyframes of --scene.
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// Whom to give it to: a built-in scene or a scene file, and the path of the topmost node, as in two-robots:robot1.
    #[arg(long, value_name = "SCENE[:NODE]")]
    pub onto: PathBuf,
    /// The keyframe file to write.
    #[arg(short, long, value_name = "OUT.json")]
    pub output: PathBuf,
    /// Which node follows which, as --write-map writes it.
    #[arg(long, value_name = "MAP.json")]
    pub map: Option<PathBuf>,
    /// Write which node follows which.
    #[arg(long, value_name = "MAP.json")]
    pub write_map: Option<PathBuf>,
    /// How the motion becomes keyframes.
    #[command(flatten)]
    pub reduction: ReductionArguments,
    /// Print the report as a JSON object: input, output, map, notes, and how each foot stands.
    #[arg(long)]
    pub json: bool,
}
