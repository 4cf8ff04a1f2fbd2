//! Help texts that say which formats there are.

use crate::film::{FORMATS, MOST_FRAMES_PER_SECOND, films, written_endings};
use crate::text::listed;

/// Of `render --output`.
pub fn output() -> String {
    let [stills, own_films, through_ffmpeg] = written_endings();
    let dotted = |endings: &[&str]| -> Vec<String> { endings.iter().map(|ending| format!(".{ending}")).collect() };
    let marked = through_ffmpeg.iter().map(|ending| format!(".{ending} (through ffmpeg)"));
    let both: Vec<&str> = own_films.iter().copied().filter(|ending| stills.contains(ending)).collect();
    let films: Vec<String> = dotted(&own_films).into_iter().chain(marked).collect();
    format!(
        "What to write: OUT{} is one image; OUT{} are films ({} with --fps); a folder gets frame-00000.png and on",
        listed(&dotted(&stills), "or"),
        listed(&films, "and"),
        listed(&dotted(&both), "and")
    )
}

/// Of `render --fps`.
pub fn fps() -> String {
    let own = |usual: u32| films().filter(move |format| format.usual_frames_per_second != usual);
    let usual = FORMATS.last().map_or(0, |format| format.usual_frames_per_second);
    let others: Vec<String> =
        own(usual).map(|format| format!("{} in a {}", format.usual_frames_per_second, format.name)).collect();
    format!(
        "Frames a second, 1 to {MOST_FRAMES_PER_SECOND}: of the whole playing range and its end [default: {}, else {usual}; a folder must \
         be told]",
        others.join(", ")
    )
}

/// Of `render --background`.
pub fn background() -> String {
    let names: Vec<&str> = films().filter(|format| format.has_opacity).map(|format| format.name).collect();
    format!("What is behind everything: sky, a colour, or transparent (in films: {})", listed(&names, "and"))
}
