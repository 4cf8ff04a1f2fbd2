//! Arguments of `grade`.

use std::path::PathBuf;

use clap::Args;
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};

use crate::grading::{FORMATS, Format, MOST_SHARDS, ShardNumber, format_named};
use crate::words::texts;

use super::values::size;
use crate::export::Size;
use crate::grading::PICTURE_SIZE;

/// The long help.
pub const HELP: &str = "\
Grade submissions by a rubric: grades.csv, grades.json and report.html, one page with pictures that needs nothing else.

A folder or an archive (zip, tar, tar.gz) that is named alone is a class: each of its entries is a submission. Of several that are \
named, each is one submission; with --classes each is a class, with --one each is one submission. Downloads of Canvas, Moodle and \
Gradescope are recognised by their names, and the student, the number and lateness are in the results. What is no submission is listed.

A submission holds a keyframe file, perhaps samples as `diagnose` reads them (linear or catmull in the name tells which playback they \
show), a hotkey script or a trace of it. The content decides what a file is. Archives are opened, also one level inside each other. \
Sources, object files, videos, pictures, documents, hidden files and links out of the submission are skipped. Bounds for a submission: \
200 files are read, 16 MiB a file, 64 MiB in all, unpacked; 4 files of samples of 4 MiB; 2000 keyframes; a script of 2000 commands \
that waits for an hour, reads 64 MiB and writes 32 MiB. What is wrong with a submission is in its marks.";

/// Arguments of `grade`.
#[derive(Debug, Args)]
pub struct GradeArguments {
    /// The rubric, JSON or (where its name ends in .toml) TOML, as --example writes one.
    #[arg(required_unless_present_any = ["example", "merge"])]
    pub rubric: Option<PathBuf>,
    /// A class: a folder or an archive of submissions. Or several submissions.
    #[arg(required_unless_present_any = ["check", "example", "merge"], value_name = "SUBMISSION")]
    pub submissions: Vec<PathBuf>,
    /// Each SUBMISSION is a class: a folder or an archive of submissions.
    #[arg(long)]
    pub classes: bool,
    /// Each SUBMISSION is one submission, also where it is a folder or an archive.
    #[arg(long, conflicts_with = "classes")]
    pub one: bool,
    /// The folder for the results.
    #[arg(short, long, required_unless_present_any = ["check", "example"], value_name = "DIR")]
    pub output: Option<PathBuf>,
    /// Draw no pictures: faster, and needs no GPU adapter.
    #[arg(long)]
    pub no_images: bool,
    /// Write the results in this form too, into DIR. May be repeated.
    #[arg(long, value_name = "FORMAT", value_parser = format())]
    pub to: Vec<&'static Format>,
    /// With --to canvas: the column of the assignment, as Canvas's own export names it: 'Title (id)'.
    #[arg(long, value_name = "COLUMN", requires = "to")]
    pub assignment: Option<String>,
    /// The students of the course: a table with names, numbers or sections, as Canvas, Moodle and Gradescope export it, or with the columns
    /// name,id,section. Who handed nothing in gets a row.
    #[arg(long, value_name = "FILE.csv")]
    pub roster: Option<PathBuf>,
    /// A teacher's points, comments and late days, instead of the file overrides.toml beside the rubric.
    #[arg(long, value_name = "FILE")]
    pub overrides: Option<PathBuf>,
    /// End with status 1 where a submission has no keyframes that can be read. Everything is written all the same.
    #[arg(long)]
    pub strict: bool,
    /// End with status 1 where a submission has less than this percentage of the points. Everything is written all the same.
    #[arg(long, value_name = "PERCENT", value_parser = percent)]
    pub fail_under: Option<f64>,
    /// In grades.csv, give each keyframe a column of its own.
    #[arg(long)]
    pub wide: bool,
    /// The most pictures of a submission: first a film of each playback, then three for each moment at which it is farthest off.
    #[arg(long, value_name = "N", default_value_t = 8, value_parser = clap::value_parser!(u8).range(1..), conflicts_with = "no_images")]
    pub images: u8,
    /// The size of a picture in pixels.
    #[arg(long, value_name = "WIDTHxHEIGHT", value_parser = size, default_value_t = PICTURE_SIZE, conflicts_with = "no_images")]
    pub image_size: Size,
    /// Also write a page for each student to hand back, with nothing of others, into this folder: ID.html and ID.md.
    #[arg(long, value_name = "DIR")]
    pub feedback: Option<PathBuf>,
    /// Write numbers in place of the names and ids of students, in everything.
    #[arg(long, conflicts_with = "to")]
    pub anonymous: bool,
    /// With --anonymous: the file that says who each number is, JSON.
    #[arg(long, value_name = "FILE", requires = "anonymous")]
    pub key: Option<PathBuf>,
    /// Grade only the submission of this name, student or id; of the others, write what earlier runs have kept. May be repeated.
    #[arg(long, value_name = "NAME", conflicts_with_all = ["anonymous", "shard"])]
    pub only: Vec<String>,
    /// The folder in which marks and pictures are kept for the next run. Without it, .cache in --output.
    #[arg(long, value_name = "DIR")]
    pub cache: Option<PathBuf>,
    /// Keep nothing for the next run, and use nothing of earlier ones.
    #[arg(long, conflicts_with = "cache")]
    pub no_cache: bool,
    /// Grade only each N-th submission, from the I-th on, and write nothing but shard.json, for --merge.
    #[arg(long, value_name = "I/N", value_parser = shard, conflicts_with_all = ["wide", "to", "strict", "fail_under", "roster", "overrides", "feedback", "anonymous", "json"])]
    pub shard: Option<ShardNumber>,
    /// Grade nothing: write the results of all shards, which are in these folders. They are those of one run.
    #[arg(long, value_name = "DIR", num_args = 1.., conflicts_with_all = ["rubric", "submissions", "classes", "one", "no_images", "images", "image_size", "only", "cache", "no_cache", "shard"])]
    pub merge: Vec<PathBuf>,
    /// Grade nothing: say which known mistakes the rubric's reference reveals, and which keyframes would reveal the others.
    #[arg(long, conflicts_with_all = ["submissions", "output", "classes", "one", "no_images", "wide", "to", "strict", "fail_under", "roster", "overrides", "feedback", "anonymous", "only", "cache", "no_cache", "shard", "merge"])]
    pub check: bool,
    /// Print JSON: what grades.json holds; with --check, what the reference reveals.
    #[arg(long, conflicts_with = "example")]
    pub json: bool,
    /// Grade nothing: write a rubric, a reference, a script and a README to start from into this folder.
    #[arg(long, value_name = "DIR", conflicts_with_all = ["rubric", "submissions", "output", "classes", "one", "no_images", "wide", "to", "strict", "fail_under", "roster", "overrides", "feedback", "anonymous", "only", "cache", "no_cache", "shard", "merge", "check"])]
    pub example: Option<PathBuf>,
}

fn format() -> impl TypedValueParser<Value = &'static Format> {
    PossibleValuesParser::new(FORMATS.map(|format| PossibleValue::new(format.name).help(format.about)))
        .map(|name| format_named(&name).expect("a possible value"))
}

fn percent(text: &str) -> Result<f64, String> {
    let percent = text.parse().ok().filter(|percent| (0.0..=100.0).contains(percent));
    percent.ok_or_else(|| texts::GRADE_BAD_PERCENT.to_string())
}

fn shard(text: &str) -> Result<ShardNumber, String> {
    let number = |text: &str| {
        let is_whole = !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
        text.parse::<usize>().ok().filter(|number| is_whole && (1..=MOST_SHARDS).contains(number))
    };
    let both = text.split_once('/').and_then(|(one, of)| Some(ShardNumber { number: number(one)?, of: number(of)? }));
    both.filter(|shard| shard.number <= shard.of).ok_or_else(|| texts::grade_bad_shard(MOST_SHARDS).to_string())
}
