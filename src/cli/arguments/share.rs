//! Arguments of `share`.

use std::path::PathBuf;

use clap::Args;

/// The long help.
pub const HELP: &str = "\
Write the page of Inbetween with an animation in it, ready to put on a web space: whoever opens it sees the animation, turns it and \
plays it, in a browser. With --compare it plays beside another one. Published are the keyframes, the scene and those of --compare, as \
animation.json, scene.json and reference.json: no name of a file or of a person. The page's own files come with the program; in a \
checkout, .ci/web makes them.";

/// Arguments of `share`.
#[derive(Debug, Args)]
pub struct ShareArguments {
    /// The animation: a keyframe file, or a text in any layout.
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// The folder to write, which is made if it is missing; one with other files in it is refused.
    #[arg(short, long, value_name = "DIR")]
    pub output: PathBuf,
    /// Another animation, to show beside it.
    #[arg(long, value_name = "REFERENCE")]
    pub compare: Option<PathBuf>,
    /// The folder of the page's files [default: share/inbetween/web beside the program's folder].
    #[arg(long, value_name = "DIR")]
    pub page: Option<PathBuf>,
    /// Print the report as a JSON object: input, output, files, notes.
    #[arg(long)]
    pub json: bool,
}
