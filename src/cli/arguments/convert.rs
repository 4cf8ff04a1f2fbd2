//! Arguments of `convert`.

use std::path::PathBuf;

use clap::Args;
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};

use crate::text_layouts::{FieldOrder, Layout};

/// The long help.
pub const HELP: &str = "\
Read keyframes in any layout that students' own programs write, and write a keyframe file, or another layout. What is read is \
told by its content: a keyframe file (JSON), or a text of numbers with or without a header \"N M\", with lines \"frame [0]\" or \"end\", \
CSV, matrices. Keys in a Python program (dictionaries such as translate_keys, rotate_keys and scale_keys) give a scene file with a \
control node. The program is not run.

On success the report of what was inferred, and how sure that is, goes to standard output: a line of what was read, then one for each \
finding, which begins with sure, likely, warning or note. A text that cannot be read gives a sentence with line and column on standard \
error, and nothing is written.";

/// Arguments of `convert`.
#[derive(Debug, Args)]
pub struct ConvertArguments {
    /// The keyframes: keyframe files or texts, of at most 1 GiB each.
    #[arg(required = true, value_name = "IN")]
    pub inputs: Vec<PathBuf>,
    /// The file to write. Several INs need a folder: it gets a file for each, of the same name.
    #[arg(short, long, value_name = "OUT|DIR")]
    pub output: PathBuf,
    /// Write this layout, numbers with six significant digits [default: csv if OUT ends in .csv, header if in .txt, else a keyframe file].
    #[arg(long, value_name = "LAYOUT", value_parser = layout())]
    pub to: Option<Layout>,
    /// In a text, write enough digits to read back the same values.
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
    /// Which group of keys of a Python program to read, if there are several, from 1: what one control node gets.
    #[arg(long, value_name = "N")]
    pub group: Option<usize>,
    /// Print the report as JSON: an object a line for each IN.
    #[arg(long)]
    pub json: bool,
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
