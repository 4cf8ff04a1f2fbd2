//! Points for each graded item.

use serde::Deserialize;

/// Points for each item. Items without points are not graded.
#[derive(Clone, Copy, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Points {
    /// For keyframes that can be read.
    pub readable: f64,
    /// For as many keyframes as the reference has.
    pub keyframe_count: f64,
    /// For each of the reference's keyframes.
    pub each_keyframe: f64,
    /// If linear playback matches the reference.
    pub linear_playback: f64,
    /// If Catmull-Rom playback matches the reference.
    pub catmull_rom_playback: f64,
    /// For beginning and ending where it should.
    pub range_and_end: f64,
    /// For a trace of the hotkey script that matches.
    pub script: f64,
}
