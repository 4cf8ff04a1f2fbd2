//! The arguments, as clap reads them. Errors found here are wrong usage (status 2); errors that commands find are bad input (status 1).

mod help;

use std::path::PathBuf;

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use clap::{Args, Parser, ValueEnum};

use crate::colour::Colour;
use crate::diagnosis;
use crate::export::{Size, Span};
use crate::film::{Format, Grid, MOST_FRAMES_PER_SECOND, format_of_ending, stills};
use crate::flip::DEFAULT_TOLERANCE;
use crate::frame::MOST_GHOSTS;
use crate::interpolation::Interpolation;
use crate::rbt::LARGEST_COORDINATE;
use crate::render::Background;
use crate::scene::LATEST_SECONDS;
use crate::text_layouts::{FieldOrder, Layout};

/// The keyframe file if none is given.
pub const DEFAULT_KEYFRAME_FILE: &str = "animation.json";

const AFTER_HELP: &str = "\
Keyframes are counted from 0. Key times count played keyframes: with N keyframes in the list, the first and the last only steer, \
and key times run from 0 (keyframe 1) to N - 3 (keyframe N - 2).

Exit status: 0 done; 1 bad input, said on standard error; 2 wrong usage; 3 no display or no GPU adapter.";

/// Animate a scene with keyframes: in a window, or with one of the commands below.
#[derive(Debug, Parser)]
#[command(name = "inbetween", version, after_help = AFTER_HELP, disable_help_subcommand = true)]
pub struct Arguments {
    /// The scene: a built-in one (two-robots, cylinder, orbits), or a scene file of at most 256 MiB.
    #[arg(long, global = true, value_name = "NAME|FILE")]
    pub scene: Option<PathBuf>,
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
    #[command(long_about = CONVERT_HELP, after_long_help = "Manual: inbetween help texts")]
    Convert(ConvertArguments),
    /// Print the paths of the scene's RBT nodes, one a line, in the order of poses.
    Nodes,
    /// Print poses as JSON or CSV: of an animation at key times, or the scene's rest pose.
    #[command(after_long_help = "Manual: inbetween help command-line")]
    Sample(SampleArguments),
    /// Render images and films: of an animation, or of the scene's rest pose. Needs no display.
    #[command(after_long_help = "Manual: inbetween help films")]
    Render(RenderArguments),
    /// Render what DIR/pictures.json lists and compare it with the references beside it. Exit status: 1 on a difference or a missing reference.
    #[command(after_long_help = "Manual: inbetween help ci")]
    Verify(VerifyArguments),
    /// Compare two PNG images by the differences that an eye notices (FLIP). Exit status: 0 within the tolerance, 1 beyond, 2 trouble.
    #[command(after_long_help = "Manual: inbetween help films")]
    Compare(CompareArguments),
    /// Run a script of hotkeys and gestures with no window.
    #[command(long_about = script_help(), after_long_help = "Manual: inbetween help scripts")]
    Script(ScriptArguments),
    /// Get back what was not saved when a program ended, out of its journal.
    #[command(after_long_help = "Manual: inbetween help recovery")]
    Recover(RecoverArguments),
    /// Name the mistake that explains what a program showed, from samples of its playback.
    #[command(long_about = diagnose_help(), after_long_help = "Manual: inbetween help grading")]
    Diagnose(DiagnoseArguments),
    /// Compare two animations node by node, as they play. Exit status: 0 within tolerance, 1 beyond, 2 trouble.
    #[command(after_long_help = "Manual: inbetween help grading")]
    Diff(DiffArguments),
    /// Grade submissions by a rubric: grades.csv, grades.json and report.html.
    #[command(long_about = GRADE_HELP, after_long_help = "Manual: inbetween help grading")]
    Grade(GradeArguments),
    /// Print the help of a command, or a page of the manual.
    Help(HelpArguments),
}

const GRADE_HELP: &str = "\
Grade submissions by a rubric: grades.csv, grades.json and report.html, one page with pictures that needs nothing else.

A folder or an archive (zip, tar, tar.gz) that is named alone is a class: each of its entries is a submission. Of several that are \
named, each is one submission; with --classes each is a class, with --one each is one submission. Downloads of Canvas, Moodle and \
Gradescope are recognised by their names, and the student, the number and lateness are in the results. What is no submission is listed.

A submission holds a keyframe file, perhaps samples as `diagnose` reads them (linear or catmull in the name tells which playback they \
show), a hotkey script or a trace of it. The content decides what a file is. Archives are opened, also one level inside each other. \
Sources, object files, videos, pictures, documents, hidden files and links out of the submission are skipped. Bounds for a submission: \
200 files are read, 16 MiB a file, 64 MiB in all, unpacked; 4 files of samples of 4 MiB; 2000 keyframes; a script of 2000 commands \
that waits for an hour, reads 64 MiB and writes 32 MiB. What is wrong with a submission is in its marks.";

fn diagnose_help() -> String {
    let mut names = diagnosis::names();
    let mut next = || names.next().unwrap_or_default();
    let (linear, catmull_rom) = (next(), next());
    let mistakes: Vec<&str> = names.collect();
    format!(
        "\
Name the mistake that explains what a program showed, from samples of its playback. The samples are CSV with the header \
key_time,rbt_ind,tx,ty,tz,rw,rx,ry,rz and perhaps a column ms, parted by commas, semicolons or tabs: a row for each node at each \
key time; nan, -nan(ind) and 1.#QNAN are read as samples.

They are compared with the right result, linear and Catmull-Rom, with what each known mistake would show, and with pairs of mistakes. \
A name is given only if every row agrees, to the printed decimals or 0.0001 units and 0.0002 in a component of a quaternion, and the \
right result does not. The residual is the root mean square over the rows of the distance of translations and of quaternions as \
printed.

The names: {linear} (linear), {catmull_rom}; {}.",
        mistakes.join(", ")
    )
}

fn script_help() -> String {
    format!(
        "\
Run a script of hotkeys and gestures with no window. One command a line; # starts a comment:

{lines}
The script is read whole first: a line that makes no sense, or an unknown node, is an error, and nothing is run. While it runs, \
what the window would refuse with a message is a message here too. A file that cannot be written ends it with exit status 1, \
ctrl+q with 0.",
        lines = crate::script::help()
    )
}

/// Arguments of `help`.
#[derive(Debug, Args)]
pub struct HelpArguments {
    /// A command or a page of the manual; without it, both are listed.
    pub topic: Option<String>,
}

/// Arguments of `check`.
#[derive(Debug, Args)]
pub struct CheckArguments {
    /// Keyframe files, of at most 1 GiB each.
    #[arg(required = true, value_name = "FILE")]
    pub files: Vec<PathBuf>,
}

const CONVERT_HELP: &str = "\
Read keyframes in any layout that students' own programs write, and write a keyframe file, or with --to another layout. What is read is \
told by its content: a keyframe file (JSON), or a text of numbers with or without a header \"N M\", with lines \"frame [0]\" or \"end\", \
CSV, matrices. Keys in Python dictionaries (translate_keys, rotate_keys, scale_keys) give a scene file with a control node.

On success the report of what was inferred, and how sure that is, goes to standard output: a line of what was read, then one for each \
finding, which begins with sure, likely, warning or note. A text that cannot be read gives a sentence with line and column on standard \
error, and nothing is written.";

/// Arguments of `convert`.
#[derive(Debug, Args)]
pub struct ConvertArguments {
    /// The keyframes: a keyframe file or a text, of at most 1 GiB.
    #[arg(value_name = "IN")]
    pub input: PathBuf,
    /// The file to write.
    #[arg(short, long, value_name = "OUT")]
    pub output: PathBuf,
    /// Write this layout instead of a keyframe file, numbers with six significant digits.
    #[arg(long, value_name = "LAYOUT", value_parser = layout())]
    pub to: Option<Layout>,
    /// With --to, write enough digits to read back the same values.
    #[arg(long)]
    pub exact: bool,
    /// The order of a row's numbers, instead of the inferred one.
    #[arg(long, value_name = "ORDER", value_parser = field_order())]
    pub order: Option<FieldOrder>,
    /// The nodes of a keyframe's rows: a file with a path on each line; - marks a row that is not used.
    #[arg(long, value_name = "FILE")]
    pub joints: Option<PathBuf>,
    /// Write OUT also where it is IN.
    #[arg(long)]
    pub overwrite: bool,
    /// Accept a text that breaks off or disagrees with its header, and take its whole keyframes.
    #[arg(long)]
    pub salvage: bool,
}

/// Arguments of `sample`.
#[derive(Debug, Args)]
pub struct SampleArguments {
    /// The keyframe file; without it, the scene's rest pose is printed.
    pub file: Option<PathBuf>,
    /// Key times to sample, from 0 to N - 3, in the order in which to print them [default: 0].
    #[arg(long, value_name = "KEY_TIME,…", requires = "file", conflicts_with = "fps", allow_hyphen_values = true, value_parser = key_times)]
    pub at: Option<KeyTimes>,
    /// Frames a second, 1 to 1000. Samples the whole playing range and its end.
    #[arg(long, value_name = "N", requires = "file", value_parser = clap::value_parser!(u32).range(1..=1000))]
    pub fps: Option<u32>,
    /// The output format.
    #[arg(long, value_enum, default_value_t)]
    pub format: SampleFormat,
    /// The space of the output: parent prints poses; world prints the world matrix of every node, including shapes and control nodes.
    #[arg(long, value_enum, default_value_t)]
    pub space: Space,
    /// The time of the timed keys, in seconds.
    #[arg(long, value_name = "S", default_value_t = 0.0, allow_negative_numbers = true, value_parser = seconds)]
    pub seconds: f64,
    /// The interpolation to use instead of the file's.
    #[arg(long, value_name = "NAME", value_parser = interpolation())]
    pub interpolation: Option<Interpolation>,
}

/// How samples are printed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum SampleFormat {
    /// One object with "nodes" and "frames", a frame a line.
    #[default]
    Json,
    /// A row for each node of each frame: key_time,rbt_ind,tx,ty,tz,rw,rx,ry,rz.
    Csv,
}

/// In which space samples are printed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum Space {
    /// Poses: each RBT node's transform in its parent's space.
    #[default]
    Parent,
    /// "world_from_node" of every node: 16 numbers in column order.
    World,
}

/// Arguments of `render`.
#[derive(Debug, Args)]
pub struct RenderArguments {
    /// The keyframe file; without it, the scene's rest pose is rendered.
    pub file: Option<PathBuf>,
    /// What to write: a picture or film by its ending, or a folder of numbered pictures.
    #[arg(short, long, value_name = "OUT.png|OUT.gif|…|DIR", help = help::output())]
    pub output: PathBuf,
    /// The key time to render, from 0 to N - 3 [default: 0].
    #[arg(long, value_name = "KEY_TIME", requires = "file", conflicts_with_all = ["keyframe", "fps"], allow_hyphen_values = true, value_parser = key_time)]
    pub at: Option<f64>,
    /// The keyframe of the list to render, from 0 to N - 1.
    #[arg(long, value_name = "INDEX", requires = "file", conflicts_with = "fps", allow_negative_numbers = true)]
    pub keyframe: Option<i64>,
    /// Frames a second, of the whole playing range and its end.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=i64::from(MOST_FRAMES_PER_SECOND)), help = help::fps())]
    pub fps: Option<u32>,
    /// The format of a folder's numbered images [default: png].
    #[arg(long, value_name = "FORMAT", value_parser = still_format())]
    pub frame_format: Option<&'static Format>,
    /// Remove the numbered images of an earlier film from the folder that this film does not replace. Without this they are an error.
    #[arg(long)]
    pub clean: bool,
    /// The key time at which a film or contact sheet begins [default: 0].
    #[arg(long, value_name = "KEY_TIME", requires = "file", conflicts_with_all = ["at", "keyframe"], allow_hyphen_values = true, value_parser = key_time)]
    pub from: Option<f64>,
    /// The key time at which a film or contact sheet ends [default: N - 3].
    #[arg(long, value_name = "KEY_TIME", requires = "file", conflicts_with_all = ["at", "keyframe"], allow_hyphen_values = true, value_parser = key_time)]
    pub to: Option<f64>,
    /// A contact sheet of COLUMNS times ROWS images, evenly from --from to --to. Each has --size (by default 320x240).
    #[arg(long, value_name = "COLUMNSxROWS", conflicts_with_all = ["at", "keyframe", "fps"], value_parser = grid)]
    pub sheet: Option<Grid>,
    /// Show ghosts: moving nodes as in the N keyframes before (orange) and after (blue), translucent. At most 20.
    #[arg(long, value_name = "N", requires = "file", value_parser = clap::value_parser!(u8).range(0..=i64::from(MOST_GHOSTS)))]
    pub ghosts: Option<u8>,
    /// The eye: the path of one of the scene's, or turntable, which circles the world's centre once [default: the scene's first].
    #[arg(long, value_name = "EYE|turntable")]
    pub camera: Option<String>,
    /// What is behind everything.
    #[arg(long, value_name = "sky|#rrggbb|transparent", default_value = "sky", value_parser = background, help = help::background())]
    pub background: Background,
    /// The time of the timed keys, in seconds. In a film, their time at its first frame.
    #[arg(long, value_name = "S", default_value_t = 0.0, allow_negative_numbers = true, value_parser = seconds)]
    pub seconds: f64,
    /// Width and height in pixels [default: 640x480].
    #[arg(long, value_name = "WIDTHxHEIGHT", value_parser = size)]
    pub size: Option<Size>,
    /// Samples a pixel, 1 or 4 [default: 4; 1 on a software adapter].
    #[arg(long, value_name = "1|4", value_parser = samples())]
    pub samples: Option<u32>,
    /// The interpolation to use instead of the file's.
    #[arg(long, value_name = "NAME", value_parser = interpolation())]
    pub interpolation: Option<Interpolation>,
    /// Write node indices instead of colours, as a 16-bit grey PNG: 0 for background, else the node's pre-order index plus 1.
    #[arg(long, conflicts_with_all = ["fps", "sheet", "ghosts", "samples"])]
    pub id: bool,
    /// Also write a JSON file with adapter, driver, versions and the SHA-256 of each written file.
    #[arg(long, value_name = "FILE")]
    pub manifest: Option<PathBuf>,
}

impl RenderArguments {
    /// Which part of the animation is rendered.
    pub fn span(&self) -> Span {
        Span { from: self.from, to: self.to, seconds: self.seconds }
    }
}

/// Arguments of `verify`.
#[derive(Debug, Args)]
pub struct VerifyArguments {
    /// The folder with pictures.json and the references.
    pub folder: PathBuf,
    /// Replace the references by the pictures drawn now.
    #[arg(long)]
    pub update: bool,
    /// The folder for drawn pictures and differences [default: DIR/actual].
    #[arg(short, long, value_name = "DIR")]
    pub output: Option<PathBuf>,
}

/// Arguments of `compare`.
#[derive(Debug, Args)]
pub struct CompareArguments {
    /// The first image.
    #[arg(value_name = "A.png")]
    pub first: PathBuf,
    /// The second image, of the same size.
    #[arg(value_name = "B.png")]
    pub second: PathBuf,
    /// The largest score that counts as equal, 0 to 1.
    #[arg(long, value_name = "T", default_value_t = DEFAULT_TOLERANCE, value_parser = tolerance)]
    pub tolerance: f32,
    /// Write a PNG of the differences: black where equal, brighter for larger differences.
    #[arg(short, long, value_name = "DIFF.png")]
    pub output: Option<PathBuf>,
    /// Print the result as JSON.
    #[arg(long)]
    pub json: bool,
}

/// Arguments of `script`.
#[derive(Debug, Args)]
pub struct ScriptArguments {
    /// The script, of at most 16 MiB; - reads standard input.
    pub file: PathBuf,
    /// The keyframe file: what the hotkeys i and w read and write.
    #[arg(long, value_name = "FILE", default_value = DEFAULT_KEYFRAME_FILE)]
    pub keyframes: PathBuf,
    /// After each command, print a JSON object with its line, its message and the state.
    #[arg(long)]
    pub trace: bool,
    /// Write keyframes and scenes also over files that another program has changed since they were read or written, or since the
    /// start. What they held is kept in NAME.bak. Without this, such a file is left alone, and the exit status is 1.
    #[arg(long)]
    pub overwrite: bool,
    /// At the end, write the state and the pose displayed to this file, as JSON.
    #[arg(long, value_name = "FILE")]
    pub state: Option<PathBuf>,
    /// Width and height of screenshots in pixels.
    #[arg(long, value_name = "WIDTHxHEIGHT", default_value = "640x480", value_parser = size)]
    pub size: Size,
    /// Write each command to this journal before it is done. The file may be missing, empty, or a journal, which is replaced.
    #[arg(long, value_name = "FILE")]
    pub journal: Option<PathBuf>,
    /// For tests: the command of this number panics, counted from 1.
    #[arg(long, hide = true, value_name = "N")]
    pub panic_at: Option<u64>,
}

/// Arguments of `recover`.
#[derive(Debug, Args)]
pub struct RecoverArguments {
    /// The journal; without it, the newest one that was left.
    #[arg(value_name = "JOURNAL")]
    pub journal: Option<PathBuf>,
    /// List the journals that hold what was not saved.
    #[arg(long, conflicts_with_all = ["journal", "output"])]
    pub list: bool,
    /// The keyframe file to write [default: NAME.recovered.json beside the keyframe file NAME.json].
    #[arg(short, long, value_name = "OUT")]
    pub output: Option<PathBuf>,
}

/// Arguments of `diagnose`.
#[derive(Debug, Args)]
pub struct DiagnoseArguments {
    /// The keyframes that the program played, of at most 1 GiB.
    pub keyframes: PathBuf,
    /// The samples that it showed, as CSV of at most 64 MiB.
    #[arg(value_name = "SAMPLES.csv", required_unless_present = "mistake")]
    pub samples: Option<PathBuf>,
    /// Draw a film: right playback beside what the samples show.
    #[arg(long, value_name = "OUT.gif|OUT.apng|OUT.y4m")]
    pub film: Option<PathBuf>,
    /// Instead of samples, let this program make the mistake, for the film.
    #[arg(long, value_name = "NAME", conflicts_with_all = ["samples", "json"], requires = "film", value_parser = known_mistake())]
    pub mistake: Option<&'static str>,
    /// Print JSON: best, explained, also, residual, candidates.
    #[arg(long)]
    pub json: bool,
}

/// Arguments of `diff`.
#[derive(Debug, Args)]
pub struct DiffArguments {
    /// Keyframes, of at most 1 GiB.
    pub a: PathBuf,
    /// Keyframes to compare them with.
    pub b: PathBuf,
    /// The tolerance of translations, in scene units.
    #[arg(long, value_name = "UNITS", default_value_t = 1e-3, value_parser = tolerance_of_poses)]
    pub tolerance_translation: f64,
    /// The tolerance of rotations, in degrees.
    #[arg(long, value_name = "DEGREES", default_value_t = 0.1, value_parser = tolerance_of_poses)]
    pub tolerance_rotation: f64,
    /// Frames a second to compare, 1 to 1000. The end is always compared.
    #[arg(long, value_name = "N", default_value_t = 60, value_parser = clap::value_parser!(u32).range(1..=1000))]
    pub fps: u32,
    /// Print JSON.
    #[arg(long)]
    pub json: bool,
    /// The interpolation to use for both instead of those of the files.
    #[arg(long, value_name = "NAME", value_parser = interpolation())]
    pub interpolation: Option<Interpolation>,
}

/// Arguments of `grade`.
#[derive(Debug, Args)]
pub struct GradeArguments {
    /// The rubric, JSON or (where its name ends in .toml) TOML, as in assets/grading.
    pub rubric: PathBuf,
    /// A class: a folder or an archive of submissions. Or several submissions.
    #[arg(required = true, value_name = "SUBMISSION")]
    pub submissions: Vec<PathBuf>,
    /// Each SUBMISSION is a class: a folder or an archive of submissions.
    #[arg(long)]
    pub classes: bool,
    /// Each SUBMISSION is one submission, also where it is a folder or an archive.
    #[arg(long, conflicts_with = "classes")]
    pub one: bool,
    /// The folder for the results.
    #[arg(short, long, value_name = "DIR")]
    pub output: PathBuf,
    /// Draw no pictures: faster, and needs no GPU adapter.
    #[arg(long)]
    pub no_images: bool,
}

fn tolerance_of_poses(text: &str) -> Result<f64, String> {
    let tolerance =
        text.trim().parse().ok().filter(|tolerance| (0.0..=f64::from(LARGEST_COORDINATE)).contains(tolerance));
    tolerance.ok_or_else(|| format!("{text:?} is not a number from 0 to 1e6"))
}

/// Key times in the given order.
#[derive(Clone, Debug, PartialEq)]
pub struct KeyTimes(pub Vec<f64>);

fn key_times(text: &str) -> Result<KeyTimes, String> {
    text.split(',').map(key_time).collect::<Result<_, _>>().map(KeyTimes)
}

fn key_time(text: &str) -> Result<f64, String> {
    // Adding zero makes a zero of minus zero.
    text.trim().parse::<f64>().map(|key_time| key_time + 0.0).map_err(|_| format!("{text:?} is not a number"))
}

fn seconds(text: &str) -> Result<f64, String> {
    let seconds = text.trim().parse().ok().filter(|seconds: &f64| seconds.abs() <= LATEST_SECONDS);
    seconds.ok_or_else(|| format!("{text:?} is not a number of seconds from -1e6 to 1e6"))
}

fn tolerance(text: &str) -> Result<f32, String> {
    text.trim()
        .parse()
        .ok()
        .filter(|tolerance| (0.0..=1.0).contains(tolerance))
        .ok_or_else(|| format!("{text:?} is not a number from 0 to 1"))
}

fn grid(text: &str) -> Result<Grid, String> {
    let side = |text: &str| text.parse().ok().filter(|side| (1..=32).contains(side));
    text.split_once('x')
        .and_then(|(columns, rows)| Some(Grid { columns: side(columns)?, rows: side(rows)? }))
        .ok_or_else(|| "expected COLUMNSxROWS, as in 4x3, each from 1 to 32".to_owned())
}

fn background(text: &str) -> Result<Background, String> {
    match text {
        "sky" => Ok(Background::Sky),
        "transparent" => Ok(Background::Transparent),
        colour => Colour::from_hex(colour)
            .map(|colour| Background::Colour(colour.to_linear()))
            .ok_or_else(|| "expected sky, transparent or a colour such as #aebfce".to_owned()),
    }
}

/// The longest side of a picture that can be asked for, in pixels. What the GPU adapter takes may be less.
const LONGEST_SIDE: u32 = 65_536;

fn size(text: &str) -> Result<Size, String> {
    let side = |text: &str| {
        let digits_only = !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
        text.parse().ok().filter(|side| digits_only && (1..=LONGEST_SIDE).contains(side))
    };
    text.split_once('x')
        .and_then(|(width, height)| Some(Size { width: side(width)?, height: side(height)? }))
        .ok_or_else(|| format!("expected WIDTHxHEIGHT in pixels, as in 640x480, each from 1 to {LONGEST_SIDE}"))
}

fn interpolation() -> impl TypedValueParser<Value = Interpolation> {
    PossibleValuesParser::new(Interpolation::ALL.map(Interpolation::name))
        .try_map(|name| Interpolation::from_name(&name).ok_or("unknown interpolation"))
}

fn still_format() -> impl TypedValueParser<Value = &'static Format> {
    PossibleValuesParser::new(stills().map(|format| format.ending))
        .try_map(|ending| format_of_ending(&ending).ok_or("unknown format"))
}

fn known_mistake() -> impl TypedValueParser<Value = &'static str> {
    PossibleValuesParser::new(diagnosis::names())
        .try_map(|name| diagnosis::names().find(|known| *known == name).ok_or("unknown mistake"))
}

fn layout() -> impl TypedValueParser<Value = Layout> {
    PossibleValuesParser::new(
        Layout::WRITTEN.map(|layout| PossibleValue::new(layout.name()).help(layout.description())),
    )
    .try_map(|name| Layout::from_name(&name).ok_or("unknown layout"))
}

fn field_order() -> impl TypedValueParser<Value = FieldOrder> {
    PossibleValuesParser::new(FieldOrder::ALL.map(FieldOrder::name))
        .try_map(|name| FieldOrder::from_name(&name).ok_or("unknown order"))
}

fn samples() -> impl TypedValueParser<Value = u32> {
    PossibleValuesParser::new(["1", "4"]).try_map(|samples| samples.parse::<u32>())
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::CommandFactory as _;

    #[test]
    fn the_arguments_are_consistent() {
        Arguments::command().debug_assert();
    }

    #[test]
    fn sizes() {
        assert_eq!(size("640x480"), Ok(Size { width: 640, height: 480 }));
        for bad in ["", "640", "0x480", "640x0", "-1x5", "640x480x3", "+6x6", "640X480", "99999999999x1", "a x b"] {
            assert!(size(bad).is_err(), "{bad}");
        }
    }

    #[test]
    fn lists_of_key_times() {
        assert_eq!(key_times("0,0.5,-1, 2"), Ok(KeyTimes(vec![0.0, 0.5, -1.0, 2.0])));
        assert!(key_times("").is_err());
        assert!(key_times("1,,2").is_err());
        assert!(key_times("one").is_err());
        assert!(key_time("-0").is_ok_and(f64::is_sign_positive));
    }
}
