//! Keyframes as text: bytes in; keyframes, a report, or an error with its place out.

mod broken;
mod inference;
mod layouts;
mod programs;
mod python;
mod rows_of_nodes;
mod samples;
mod separators;
mod students;

use inbetween::keyframe::Keyframe;
use inbetween::text_layouts::{Imported, Options, Report, import};

/// Reads a text that is good, with nothing decided beforehand.
#[track_caller]
fn read(text: impl AsRef<[u8]>) -> (Vec<Keyframe>, Report) {
    read_with(text, &Options::default())
}

#[track_caller]
fn read_with(text: impl AsRef<[u8]>, options: &Options) -> (Vec<Keyframe>, Report) {
    match import(text.as_ref(), &samples::scene(), options) {
        Ok(Imported::Text(file, report)) => (file.keyframes, report),
        other => panic!("{other:?}"),
    }
}

/// The sentence with which a text is refused.
#[track_caller]
fn refusal(text: impl AsRef<[u8]>) -> String {
    refusal_with(text, &Options::default())
}

#[track_caller]
fn refusal_with(text: impl AsRef<[u8]>, options: &Options) -> String {
    match import(text.as_ref(), &samples::scene(), options) {
        Err(error) => error.sentences().join("\n"),
        other => panic!("{other:?}"),
    }
}

/// The numbers of a keyframe's node: tx ty tz qw qx qy qz.
fn numbers(keyframe: &Keyframe, path: &str) -> [f32; 7] {
    let rbt = keyframe.pose.get(samples::scene().find_rbt(path).expect("the scene has it"));
    let ([tx, ty, tz], [x, y, z, w]) = (rbt.translation.to_array(), rbt.rotation.to_array());
    [tx, ty, tz, w, x, y, z]
}
