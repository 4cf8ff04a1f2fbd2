//! Arguments of `diagnose`.

use std::path::PathBuf;

use clap::Args;
use clap::builder::{PossibleValuesParser, TypedValueParser};

use crate::diagnosis;

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

/// The long help.
pub fn help() -> String {
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

fn known_mistake() -> impl TypedValueParser<Value = &'static str> {
    PossibleValuesParser::new(diagnosis::names())
        .try_map(|name| diagnosis::names().find(|known| *known == name).ok_or("unknown mistake"))
}
