//! The film of a diagnosis: right playback beside what a program showed.

use std::collections::BTreeMap;
use std::path::Path;

use glam::Quat;

use crate::cli::CliError;
use crate::diagnosis::Row;
use crate::export::{Animation, ExportError, Painter, Size};
use crate::files;
use crate::film::{
    Cell, Encoder, Film, FilmError, FilmFormat, Grid, Plan, contact_sheet, format_of_path, written_endings,
};
use crate::picture::Image;
use crate::rbt::Rbt;
use crate::scene::SceneGraph;

/// The size of each of the two pictures of a frame, in pixels.
const SIZE: Size = Size { width: 320, height: 240 };
/// The most frames; more moments are thinned evenly.
const MOST_FRAMES: usize = 240;
/// The most letters that fit under a picture.
const LONGEST_NAME: usize = 26;
/// How long the last frame is shown, in milliseconds.
const LAST_MS: f64 = 1000.0;

/// The film format of a file's ending.
///
/// # Errors
/// [`CliError`]: the ending is not that of a film that is written without another program.
pub fn format_of(path: &Path) -> Result<FilmFormat, CliError> {
    if let Some(Encoder::Film(format)) = format_of_path(path).map(|format| &format.of_films().encoder) {
        return Ok(*format);
    }
    let [_, own, _] = written_endings();
    Err(CliError::bad_input(path.display(), format!("the name of this film ends in one of .{}", own.join(", ."))))
}

/// Writes the film: on the left right playback, on the right the rows, under a name if it fits there.
///
/// # Errors
/// [`CliError`]: the keyframes cannot be played, the GPU fails, the film cannot be written.
pub fn write(
    (output, format): (&Path, FilmFormat),
    scene: &SceneGraph,
    (file, animation): (&Path, &Animation),
    rows: &[Row],
    name: &str,
) -> Result<(), CliError> {
    let range = animation.play_range(file)?;
    let last = range.last_key_time() as f64;
    // Key times are finite and not negative, so their bits order them as their values would.
    let mut by_time: BTreeMap<u64, Vec<&Row>> = BTreeMap::new();
    for row in rows {
        by_time.entry(row.key_time.to_bits()).or_default().push(row);
    }
    let moments: Vec<(f64, Vec<&Row>)> = by_time.into_iter().map(|(bits, rows)| (f64::from_bits(bits), rows)).collect();
    let step = moments.len().div_ceil(MOST_FRAMES).max(1);
    let moments: Vec<_> = moments.into_iter().step_by(step).collect();
    let mut painter = Painter::headless(SIZE, None)?;
    let mut images = Vec::with_capacity(moments.len());
    for (key_time, rows) in &moments {
        let right = range
            .pose_at(key_time.clamp(0.0, last), animation.interpolation)
            .map_err(|error| CliError::bad_input(file.display(), error))?;
        let mut shown = right.clone();
        for row in rows {
            let [w, x, y, z] = row.rotation_wxyz.map(|part| part as f32);
            shown.set(row.node, Rbt { translation: row.translation.as_vec3(), rotation: Quat::from_xyzw(x, y, z, w) });
        }
        let caption = if name.len() > LONGEST_NAME { "as shown" } else { name };
        let cell = |picture, caption: &str| Cell { picture, caption: vec![caption.to_owned()] };
        let cells = [
            cell(painter.loose_pose(scene, &right, &right)?, "right"),
            cell(painter.loose_pose(scene, &shown, &right)?, caption),
        ];
        images.push(contact_sheet(Grid { columns: 2, rows: 1 }, &cells));
    }
    let ms = |key_time: f64| key_time * f64::from(animation.ms_between_keyframes);
    let begins: Vec<f64> = moments.iter().map(|(key_time, _)| ms(*key_time)).collect();
    let bytes =
        encoded(format, &images, &begins).map_err(|cause| ExportError::Film { path: output.to_owned(), cause })?;
    Ok(files::write(output, &bytes)?)
}

/// The pictures as a film; each is shown from its beginning, in milliseconds, to that of the next.
fn encoded(format: FilmFormat, images: &[Image], begins: &[f64]) -> Result<Vec<u8>, FilmError> {
    let first = &images[0];
    let length = begins[begins.len() - 1] - begins[0] + LAST_MS;
    let plan = Plan {
        width: first.width,
        height: first.height,
        frames: images.len() as u32,
        frames_per_second: (images.len() as f64 * 1000.0 / length).ceil().clamp(1.0, 50.0) as u32,
        is_opaque: true,
    };
    let step = images.len().div_ceil(format.sample_frames.max(1)).max(1);
    let samples: Vec<Image> = images.iter().skip(step / 2).step_by(step).cloned().collect();
    let mut bytes = Vec::new();
    let mut film = Film::new(format, plan, &samples, &mut bytes)?;
    for (index, image) in images.iter().enumerate() {
        let begin = begins[index] - begins[0];
        let end = begins.get(index + 1).map_or(begin + LAST_MS, |next| next - begins[0]);
        film.push(image, begin, end)?;
    }
    film.finish()?;
    Ok(bytes)
}
