//! Points for each graded item.

use serde::Deserialize;

use crate::grading::requirements::Requirement;

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
    /// For enough keyframes.
    pub minimum_keyframes: f64,
    /// For enough nodes that move.
    pub minimum_nodes_moved: f64,
    /// For Catmull-Rom splines.
    pub uses_catmull_rom: f64,
    /// If no shape is below the ground.
    pub above_ground: f64,
    /// If nothing jumps.
    pub no_jumps: f64,
    /// For a script that runs.
    pub script_runs: f64,
}

impl Points {
    /// The points for a requirement.
    #[must_use]
    pub const fn of(&self, requirement: Requirement) -> f64 {
        match requirement {
            Requirement::MinimumKeyframes => self.minimum_keyframes,
            Requirement::MinimumNodesMoved => self.minimum_nodes_moved,
            Requirement::UsesCatmullRom => self.uses_catmull_rom,
            Requirement::AboveGround => self.above_ground,
            Requirement::NoJumps => self.no_jumps,
            Requirement::ScriptRuns => self.script_runs,
        }
    }
}
