//! Arguments of `share`.

use std::path::PathBuf;

use clap::Args;

/// The long help.
pub const HELP: &str = "\
Write the page of Inbetween with an animation in it, ready to put on a web space: whoever opens it sees the animation, turns it and \
plays it, in a browser. With --compare it plays beside another one. Published are the keyframes, the scene and those of --compare, as \
animation.json, scene.json and reference.json: no name of a file or of a person.

With --report, FILE is one submission, as `grade --one` takes it: a keyframe file, a folder or an archive. It is graded, and its report \
goes along as report.html: what was looked at and why, with pictures, some of which show the rubric's reference. Names, numbers, names \
of files, lateness and notes for graders are left out, and points too unless --with-marks asks for them. Nothing of other submissions is \
read. Whoever has the address sees all of this: ask the student before.

The page's own files come with the program; in a checkout, .ci/web makes them.";

/// Arguments of `share`.
#[derive(Debug, Args)]
pub struct ShareArguments {
    /// The animation: a keyframe file, or a text in any layout. With --report, a submission.
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// The folder to write, which is made if it is missing; one with other files in it is refused.
    #[arg(short, long, value_name = "DIR")]
    pub output: PathBuf,
    /// Another animation, to show beside it.
    #[arg(long, value_name = "REFERENCE")]
    pub compare: Option<PathBuf>,
    /// Also grade FILE by this rubric, and put its report in.
    #[arg(long, value_name = "RUBRIC")]
    pub report: Option<PathBuf>,
    /// With --report: show points in it.
    #[arg(long, requires = "report")]
    pub with_marks: bool,
    /// The folder of the page's files [default: share/inbetween/web beside the program's folder].
    #[arg(long, value_name = "DIR")]
    pub page: Option<PathBuf>,
    /// Print the report as a JSON object: input, output, files, notes.
    #[arg(long)]
    pub json: bool,
}
