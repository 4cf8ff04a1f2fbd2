//! The arguments, as clap reads them. Errors found here are wrong usage (status 2); errors that commands find are bad input (status 1).

mod check;
mod compare;
mod comparing;
mod convert;
mod diagnose;
mod diff;
mod examples;
mod export;
mod generate;
mod grade;
mod help;
mod import;
mod info;
mod join;
mod progress;
mod recover;
mod reduction;
mod refining;
mod render;
mod retarget;
mod sample;
mod script;
mod share;
mod values;
mod verify;

use std::path::PathBuf;

use clap::{Args, CommandFactory as _, Parser};

pub use check::CheckArguments;
pub use compare::CompareArguments;
pub use comparing::ComparingArguments;
pub use convert::ConvertArguments;
pub use diagnose::DiagnoseArguments;
pub use diff::DiffArguments;
pub use export::{ExportArguments, ModelFormat};
pub use generate::{CompletionsArguments, ManArguments};
pub use grade::GradeArguments;
pub use import::ImportArguments;
pub use info::InfoArguments;
pub use join::JoinArguments;
pub use progress::ProgressKind;
pub use recover::RecoverArguments;
pub use refining::RefiningArguments;
pub use render::RenderArguments;
pub use retarget::RetargetArguments;
pub use sample::{SampleArguments, SampleFormat, Space};
pub use script::ScriptArguments;
pub use share::ShareArguments;
pub use verify::VerifyArguments;

/// The keyframe file if none is given.
pub const DEFAULT_KEYFRAME_FILE: &str = crate::editor::NEW_FILE;

const AFTER_HELP: &str = "\
`-` is standard input for FILE, and standard output for -o.

Keyframes are counted from 0. Key times count played keyframes: with N keyframes in the list, the first and the last only steer, \
and key times run from 0 (keyframe 1) to N - 3 (keyframe N - 2).

Exit status: 0 done; 1 bad input, said on standard error; 2 wrong usage; 3 no display or no GPU adapter.";

/// Animate a scene with keyframes: in a window, or with one of the commands below.
#[derive(Debug, Parser)]
#[command(name = "inbetween", version, disable_help_subcommand = true, disable_version_flag = true)]
pub struct Arguments {
    /// The scene: a built-in one (two-robots, cylinder, orbits), or a scene file of at most 256 MiB.
    #[arg(long, global = true, value_name = "NAME|FILE")]
    pub scene: Option<PathBuf>,
    /// Say only what was asked for and what is wrong: no notes, no reports, no progress.
    #[arg(short, long, global = true)]
    pub quiet: bool,
    /// Print the version.
    #[arg(short = 'V', long)]
    pub version: bool,
    /// With --version: print what a report of a fault needs to say, of the program, the system and the graphics driver.
    #[arg(long, requires = "version")]
    pub verbose: bool,
    /// The keyframe file to open in the window, loaded if it exists [default: animation.json, not loaded].
    pub file: Option<PathBuf>,
    /// For tests: after each command the window prints how many lines its journal has, and a hash of what it must bring back; and
    /// `picture` for each picture.
    #[arg(long, hide = true)]
    pub print_lines: bool,
    /// For tests: the command of this number panics in the window, counted from 1.
    #[arg(long, hide = true, value_name = "N")]
    pub window_panic_at: Option<u64>,
    /// For tests: drawing panics after so many commands.
    #[arg(long, hide = true, value_name = "N")]
    pub drawing_panic_at: Option<u64>,
    /// For tests: the device is lost for good after so many commands.
    #[arg(long, hide = true, value_name = "N")]
    pub device_lost_at: Option<u64>,
    /// The command to run instead of opening the window.
    #[command(subcommand)]
    pub command: Option<Subcommand>,
}

/// The commands besides the window.
#[derive(Debug, clap::Subcommand)]
pub enum Subcommand {
    /// Validate keyframe files: one line a file, one a problem.
    Check(CheckArguments),
    /// Read keyframes in any layout that students' own programs write, and write a keyframe file, or another layout.
    #[command(long_about = convert::HELP)]
    Convert(ConvertArguments),
    /// Describe a keyframe file or a text: keyframes, nodes, scene, timing, and the frames of its film.
    Info(InfoArguments),
    /// Print the paths of the scene's RBT nodes, one a line, in the order of poses.
    Nodes(NodesArguments),
    /// Print poses as JSON or CSV: of an animation at key times, or the scene's rest pose.
    Sample(SampleArguments),
    /// Render images and films: of an animation, or of the scene's rest pose. Needs no display.
    Render(RenderArguments),
    /// Make a film of the numbered images in a folder, which may have been drawn in parts, on many machines.
    #[command(long_about = join::HELP)]
    Join(JoinArguments),
    /// Make a scene and keyframes of another program's file: a glTF model or a BVH capture.
    #[command(long_about = import::HELP)]
    Import(ImportArguments),
    /// Write the scene and an animation as a file of another program: glTF or a BVH capture.
    #[command(long_about = export::HELP)]
    Export(ExportArguments),
    /// Give the motion of one skeleton, such as a captured person, to another one, such as a robot.
    #[command(long_about = retarget::HELP)]
    Retarget(RetargetArguments),
    /// Write a web page that shows an animation, or one beside another, for everybody with a browser.
    #[command(long_about = share::HELP)]
    Share(ShareArguments),
    /// Render what DIR/pictures.json lists and compare it with the references beside it. Exit status: 1 on a difference or a missing reference.
    Verify(VerifyArguments),
    /// Compare two PNG images by the differences that an eye notices (FLIP). Exit status: 0 within the tolerance, 1 beyond, 2 trouble.
    Compare(CompareArguments),
    /// Run a script of hotkeys and gestures with no window.
    #[command(long_about = script::help())]
    Script(ScriptArguments),
    /// Get back what was not saved when a program ended, out of its journal.
    Recover(RecoverArguments),
    /// Name the mistake that explains what a program showed, from samples of its playback.
    #[command(long_about = diagnose::help())]
    Diagnose(DiagnoseArguments),
    /// Compare two animations node by node, as they play. Exit status: 0 within tolerance, 1 beyond, 2 trouble.
    Diff(DiffArguments),
    /// Grade submissions by a rubric: grades.csv, grades.json and report.html.
    #[command(long_about = grade::HELP)]
    Grade(GradeArguments),
    /// Print the completions of a shell: what it proposes after `inbetween` and the tab key.
    Completions(CompletionsArguments),
    /// Write pages for the program `man` to a folder.
    Man(ManArguments),
    /// Print the help of a command, or a page of the manual.
    Help(HelpArguments),
}

/// The whole command line, with what stands below the help of each command.
pub fn command() -> clap::Command {
    let program = Arguments::command().after_help(format!("{AFTER_HELP}\n\n{}", examples::below("")));
    program.mut_subcommands(|command| {
        let below = examples::below(command.get_name());
        command.after_help(below)
    })
}

/// Arguments of `nodes`.
#[derive(Debug, Args)]
pub struct NodesArguments {
    /// Print a JSON list.
    #[arg(long)]
    pub json: bool,
}

/// Arguments of `help`.
#[derive(Debug, Args)]
pub struct HelpArguments {
    /// A command, a page of the manual, or `licences`: those of what the program is made of. Without it, commands and pages are listed.
    pub topic: Option<String>,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_arguments_are_consistent() {
        command().debug_assert();
    }
}
