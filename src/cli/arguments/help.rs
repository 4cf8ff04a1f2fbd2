//! Help texts that say which formats there are.

use crate::film::{FORMATS, MOST_FRAMES_PER_SECOND, films, listed, written_endings};

/// Of `render --output`.
pub fn output() -> String {
    let [stills, own_films, through_ffmpeg] = written_endings();
    let marked = through_ffmpeg.iter().map(|ending| format!(".{ending} (through ffmpeg)"));
    let films: Vec<String> = own_films.iter().map(|ending| format!(".{ending}")).chain(marked).collect();
    let films: Vec<&str> = films.iter().map(String::as_str).collect();
    format!(
        "What to write: OUT.{} is one image; OUT{} are films; a folder gets frame-00000.png and on",
        listed(&stills, " or ."),
        listed(&films, " and ")
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
    format!("What is behind everything: sky, a colour, or transparent (in films: {})", listed(&names, " and "))
}
