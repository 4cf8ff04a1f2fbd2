//! Arguments of `export`.

use std::path::PathBuf;

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use clap::{Args, ValueEnum};

use super::values::interpolation;
use crate::interchange::gltf_out::{Curves, Tolerance};
use crate::interpolation::Interpolation;

/// The long help.
pub const HELP: &str = "\
Write the scene and an animation as a file of another program. The ending of OUT names the format. The report says what was left out.

glTF (.glb, and .gltf with everything in one text) has nodes, shapes, cameras and motion, for Blender, Godot, three.js and others. Keys \
are as few as keep every node within the tolerance in the world, as measured at many times. The report names the worst node and time; the \
file has the same in asset.extras. Linear keys are right in every reader. Cubic ones are some fifteen times fewer, and right only in \
readers that follow the specification, such as three.js: Blender up to 5.3 leaves their tangents out, and Godot up to 4.6 blends them \
wrongly.

BVH (.bvh) has the RBT nodes as joints, and a frame for each time.";

/// Arguments of `export`.
#[derive(Debug, Args)]
pub struct ExportArguments {
    /// Keyframes: a keyframe file or a text, of at most 1 GiB; without it, the scene at rest is written, and in glTF its timed keys.
    #[arg(value_name = "FILE")]
    pub file: Option<PathBuf>,
    /// The file to write.
    #[arg(short, long, value_name = "OUT.glb|OUT.gltf|OUT.bvh")]
    pub output: PathBuf,
    /// The format, where OUT has no ending that names it, as - has none.
    #[arg(long, value_enum)]
    pub format: Option<ModelFormat>,
    /// glTF: how far readers may be off in the world, in degrees and scene units [default: 0.01,0.0001].
    #[arg(long, value_name = "DEGREES,UNITS", value_parser = tolerance)]
    pub tolerance: Option<Tolerance>,
    /// glTF: how values between keys are said [default: linear].
    #[arg(long, value_name = "CURVES", value_parser = curves())]
    pub curves: Option<Curves>,
    /// glTF: leave the shapes out.
    #[arg(long)]
    pub no_meshes: bool,
    /// BVH: write only this RBT node and those below it, as one skeleton.
    #[arg(long, value_name = "PATH")]
    pub node: Option<String>,
    /// Frames a second, 1 to 1000: in glTF a key for each, in place of a tolerance [default: as the tolerance needs; 60 in BVH].
    #[arg(long, value_name = "N", conflicts_with = "tolerance", value_parser = clap::value_parser!(u32).range(1..=1000))]
    pub fps: Option<u32>,
    /// The interpolation to use instead of the file's.
    #[arg(long, value_name = "NAME", requires = "file", value_parser = interpolation())]
    pub interpolation: Option<Interpolation>,
    /// Print the report as a JSON object: output, format, notes, and of glTF how exact it is.
    #[arg(long)]
    pub json: bool,
}

/// A format of scenes and animations of other programs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum ModelFormat {
    /// Binary glTF 2.0: meshes, cameras and motion.
    Glb,
    /// The same as text.
    Gltf,
    /// Motion capture: a tree of joints, and their channels in frames.
    Bvh,
}

impl ModelFormat {
    /// The ending of a file in this format.
    pub fn ending(self) -> &'static str {
        match self {
            Self::Glb => "glb",
            Self::Gltf => "gltf",
            Self::Bvh => "bvh",
        }
    }
}

impl ExportArguments {
    /// The name of an argument that is given and has a meaning in glTF alone.
    pub fn only_gltf(&self) -> Option<&'static str> {
        let given = [
            (self.tolerance.is_some(), "--tolerance"),
            (self.curves.is_some(), "--curves"),
            (self.no_meshes, "--no-meshes"),
        ];
        given.into_iter().find_map(|(is_given, name)| is_given.then_some(name))
    }

    /// The same of BVH.
    pub fn only_bvh(&self) -> Option<&'static str> {
        self.node.is_some().then_some("--node")
    }
}

fn curves() -> impl TypedValueParser<Value = Curves> {
    const NAMES: [(&str, Curves, &str); 2] = [
        ("linear", Curves::Linear, "straight from key to key: right in every reader"),
        ("cubic", Curves::Cubic, "with tangents: right in three.js, not in Blender up to 5.3 and Godot up to 4.6"),
    ];
    PossibleValuesParser::new(NAMES.map(|(name, _, help)| PossibleValue::new(name).help(help)))
        .try_map(|name| NAMES.iter().find(|row| row.0 == name).map(|row| row.1).ok_or("unknown curves"))
}

fn tolerance(text: &str) -> Result<Tolerance, String> {
    let number = |text: &str| text.trim().parse().ok().filter(|number: &f64| *number > 0.0 && number.is_finite());
    text.split_once(',')
        .and_then(|(degrees, units)| Some(Tolerance { degrees: number(degrees)?, units: number(units)? }))
        .ok_or_else(|| "expected DEGREES,UNITS, as in 0.01,0.0001, both above 0".to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tolerances() {
        assert_eq!(tolerance("0.5, 2"), Ok(Tolerance { degrees: 0.5, units: 2.0 }));
        for bad in ["", "1", "1,", "0,1", "1,-1", "1,1,1", "inf,1", "NaN,1"] {
            assert!(tolerance(bad).is_err(), "{bad}");
        }
    }
}
