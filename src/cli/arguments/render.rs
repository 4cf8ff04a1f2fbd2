//! Arguments of `render`.

use std::path::{Path, PathBuf};

use clap::Args;

use super::help;
use super::values::{format, interpolation, key_time, lighting, samples, seconds, size, still_format};
use super::{ComparingArguments, ProgressKind, RefiningArguments};
use crate::colour::Colour;
use crate::export::{Size, Span};
use crate::film::{Format, FrameNumbers, Grid, MOST_FRAMES_PER_SECOND};
use crate::frame::MOST_GHOSTS;
use crate::interpolation::Interpolation;
use crate::lighting::BuiltInLighting;
use crate::render::Background;

/// Arguments of `render`.
#[derive(Debug, Args)]
pub struct RenderArguments {
    /// The keyframes: a keyframe file or a text, of at most 1 GiB; without it, the scene's rest pose is rendered.
    pub file: Option<PathBuf>,
    /// What to write: a picture or film by its ending, or a folder of numbered pictures.
    #[arg(short, long, value_name = "OUT.png|OUT.gif|…|DIR", help = help::output())]
    pub output: PathBuf,
    /// The format, where OUT has no ending that tells it, as - has none.
    #[arg(long, value_name = "FORMAT", value_parser = format())]
    pub format: Option<&'static Format>,
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
    /// The frames of the film to draw, as in 0-59, 60-119:2 or 0,7,12-14. Numbers count from 0; names in a folder have them [default: all].
    #[arg(long, value_name = "NUMBERS", conflicts_with_all = ["at", "keyframe", "sheet", "id"], value_parser = FrameNumbers::parse)]
    pub frames: Option<FrameNumbers>,
    /// Of these frames, draw only those that are missing in the folder, not whole, or of another size.
    #[arg(long)]
    pub missing: bool,
    /// The key time at which a film or contact sheet begins [default: 0].
    #[arg(long, value_name = "KEY_TIME", requires = "file", conflicts_with_all = ["at", "keyframe"], allow_hyphen_values = true, value_parser = key_time)]
    pub from: Option<f64>,
    /// The key time at which a film or contact sheet ends [default: N - 3].
    #[arg(long, value_name = "KEY_TIME", requires = "file", conflicts_with_all = ["at", "keyframe"], allow_hyphen_values = true, value_parser = key_time)]
    pub to: Option<f64>,
    /// A contact sheet of COLUMNS times ROWS images, evenly from --from to --to. Each has --size (by default 320x240).
    #[arg(long, value_name = "COLUMNSxROWS", conflicts_with_all = ["at", "keyframe", "fps"], value_parser = grid)]
    pub sheet: Option<Grid>,
    /// Show N moments in one picture, evenly from --from to --to: the last as it is, those before it ever more translucent. 2 to 32.
    #[arg(long, value_name = "N", requires = "file", conflicts_with_all = ["at", "keyframe", "fps", "frames", "sheet", "ghosts"], value_parser = clap::value_parser!(u32).range(2..=32))]
    pub strobe: Option<u32>,
    /// What is compared.
    #[command(flatten)]
    pub comparing: ComparingArguments,
    /// Show ghosts: moving nodes as in the N keyframes before (orange) and after (blue), translucent. At most 20.
    #[arg(long, value_name = "N", requires = "file", value_parser = clap::value_parser!(u8).range(0..=i64::from(MOST_GHOSTS)))]
    pub ghosts: Option<u8>,
    /// The eye: the path of one of the scene's, or turntable, which circles the world's centre once [default: the scene's first].
    #[arg(long, value_name = "EYE|turntable")]
    pub camera: Option<String>,
    /// What is behind everything.
    #[arg(long, value_name = "sky|#rrggbb|transparent", default_value = "sky", value_parser = background, help = help::background())]
    pub background: Background,
    /// The light: day, evening or studio [default: the scene's].
    #[arg(long, value_name = "NAME", value_parser = lighting())]
    pub lighting: Option<BuiltInLighting>,
    /// The time of the timed keys, in seconds. In a film, their time at its first frame.
    #[arg(long, value_name = "S", default_value_t = 0.0, allow_negative_numbers = true, value_parser = seconds)]
    pub seconds: f64,
    /// Width and height in pixels [default: 640x480; with --compare what views of 320x240 need].
    #[arg(long, value_name = "WIDTHxHEIGHT", value_parser = size)]
    pub size: Option<Size>,
    /// Samples a pixel, 1 or 4 [default: 4; 1 on a software adapter].
    #[arg(long, value_name = "1|4", value_parser = samples())]
    pub samples: Option<u32>,
    /// How pictures are refined.
    #[command(flatten)]
    pub refining: RefiningArguments,
    /// The interpolation to use instead of the file's.
    #[arg(long, value_name = "NAME", value_parser = interpolation())]
    pub interpolation: Option<Interpolation>,
    /// Write node indices instead of colours, as a 16-bit grey PNG: 0 for background, else the node's pre-order index plus 1.
    #[arg(long, conflicts_with_all = ["fps", "sheet", "ghosts", "lighting", "samples", "quality", "strobe"])]
    pub id: bool,
    /// How progress is told.
    #[arg(long, value_enum, default_value_t)]
    pub progress: ProgressKind,
    /// Also write a JSON file with adapter, driver, versions and the SHA-256 of each written file.
    #[arg(long, value_name = "FILE")]
    pub manifest: Option<PathBuf>,
    /// Print that JSON: the same as --manifest -.
    #[arg(long, conflicts_with = "manifest")]
    pub json: bool,
}

impl RenderArguments {
    /// Where the manifest goes, if there is to be one.
    pub fn manifest(&self) -> Option<&Path> {
        if self.json { Some(Path::new("-")) } else { self.manifest.as_deref() }
    }

    /// Which part of the animation is rendered.
    pub fn span(&self) -> Span {
        Span { from: self.from, to: self.to, seconds: self.seconds }
    }
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
