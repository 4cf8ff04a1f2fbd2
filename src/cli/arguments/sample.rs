//! Arguments of `sample`.

use std::path::PathBuf;

use clap::{Args, ValueEnum};

use super::values::{interpolation, key_time, seconds};
use crate::interpolation::Interpolation;

/// Arguments of `sample`.
#[derive(Debug, Args)]
pub struct SampleArguments {
    /// Keyframes: keyframe files or texts, of at most 1 GiB each; without one, the scene's rest pose is printed.
    #[arg(value_name = "FILE")]
    pub files: Vec<PathBuf>,
    /// The file to write instead of standard output. Several FILEs need a folder: it gets a file for each, of the same name.
    #[arg(short, long, value_name = "OUT|DIR")]
    pub output: Option<PathBuf>,
    /// Key times to sample, from 0 to N - 3, in the order in which to print them [default: 0].
    #[arg(long, value_name = "KEY_TIME,…", requires = "files", conflicts_with = "fps", allow_hyphen_values = true, value_parser = key_times)]
    pub at: Option<KeyTimes>,
    /// Frames a second, 1 to 1000. Samples the whole playing range and its end.
    #[arg(long, value_name = "N", requires = "files", value_parser = clap::value_parser!(u32).range(1..=1000))]
    pub fps: Option<u32>,
    /// The output format [default: that of the ending of OUT, else json].
    #[arg(long, value_enum)]
    pub format: Option<SampleFormat>,
    /// The same as --format json.
    #[arg(long, conflicts_with = "format")]
    pub json: bool,
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
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum SampleFormat {
    /// One object with "nodes" and "frames", a frame a line.
    Json,
    /// A row for each node of each frame: key_time,rbt_ind,tx,ty,tz,rw,rx,ry,rz.
    Csv,
}

impl SampleFormat {
    /// The ending of a file in this format.
    pub fn ending(self) -> &'static str {
        match self {
            Self::Json => "json",
            Self::Csv => "csv",
        }
    }

    /// The format with this ending.
    pub fn of_ending(ending: &str) -> Option<Self> {
        [Self::Json, Self::Csv].into_iter().find(|format| format.ending() == ending)
    }
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

/// Key times in the given order.
#[derive(Clone, Debug, PartialEq)]
pub struct KeyTimes(pub Vec<f64>);

fn key_times(text: &str) -> Result<KeyTimes, String> {
    text.split(',').map(key_time).collect::<Result<_, _>>().map(KeyTimes)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lists_of_key_times() {
        assert_eq!(key_times("0,0.5,-1, 2"), Ok(KeyTimes(vec![0.0, 0.5, -1.0, 2.0])));
        assert!(key_times("").is_err());
        assert!(key_times("1,,2").is_err());
        assert!(key_times("one").is_err());
        assert!(key_time("-0").is_ok_and(f64::is_sign_positive));
    }
}
