//! Requirements that an animation meets or not without a reference to compare it with: for "make your own animation".

mod playing;
mod verdict;

use serde::Deserialize;

pub(super) use verdict::Work;

/// One requirement.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Requirement {
    /// There are enough keyframes.
    MinimumKeyframes,
    /// Enough nodes move.
    MinimumNodesMoved,
    /// It is played by Catmull-Rom splines.
    UsesCatmullRom,
    /// No shape is below the ground.
    AboveGround,
    /// Nothing jumps.
    NoJumps,
    /// The script that was handed in runs, and nothing in it is refused.
    ScriptRuns,
}

impl Requirement {
    /// All of them, in the order of results.
    pub const ALL: [Self; 6] = [
        Self::MinimumKeyframes,
        Self::MinimumNodesMoved,
        Self::UsesCatmullRom,
        Self::AboveGround,
        Self::NoJumps,
        Self::ScriptRuns,
    ];

    /// Its name in rubrics and tables.
    #[must_use]
    pub const fn id(self) -> &'static str {
        match self {
            Self::MinimumKeyframes => "minimum_keyframes",
            Self::MinimumNodesMoved => "minimum_nodes_moved",
            Self::UsesCatmullRom => "uses_catmull_rom",
            Self::AboveGround => "above_ground",
            Self::NoJumps => "no_jumps",
            Self::ScriptRuns => "script_runs",
        }
    }
}

/// The numbers that requirements depend on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Requirements {
    /// The fewest keyframes, those that only steer included.
    pub minimum_keyframes: u64,
    /// The fewest nodes that move beyond the tolerances.
    pub minimum_nodes_moved: u64,
    /// The lowest y in world space that a shape may reach, in scene units.
    pub lowest_y: f64,
    /// The longest way of a node in world space in 1/60 s, in scene units.
    pub largest_step: f64,
    /// The largest turn of a node in world space in 1/60 s, in degrees.
    pub largest_step_degrees: f64,
}

impl Default for Requirements {
    fn default() -> Self {
        Self {
            minimum_keyframes: 8,
            minimum_nodes_moved: 4,
            // The ground of the usual scene is at -2.
            lowest_y: -2.05,
            largest_step: 0.5,
            largest_step_degrees: 30.0,
        }
    }
}

/// The numbers as a rubric has them; those that are missing have their defaults.
#[derive(Clone, Copy, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct RequirementsText {
    minimum_keyframes: Option<u64>,
    minimum_nodes_moved: Option<u64>,
    lowest_y: Option<f64>,
    largest_step: Option<f64>,
    largest_step_degrees: Option<f64>,
}

impl RequirementsText {
    /// The numbers.
    ///
    /// # Errors
    /// The first that is out of its range, or of a requirement that gets no points: a sentence.
    pub fn checked(&self, gets_points: impl Fn(Requirement) -> bool) -> Result<Requirements, String> {
        // Destructured, so that a new field cannot be forgotten.
        let Self { minimum_keyframes, minimum_nodes_moved, lowest_y, largest_step, largest_step_degrees } = *self;
        let there = [
            ("minimum_keyframes", minimum_keyframes.is_some(), Requirement::MinimumKeyframes),
            ("minimum_nodes_moved", minimum_nodes_moved.is_some(), Requirement::MinimumNodesMoved),
            ("lowest_y", lowest_y.is_some(), Requirement::AboveGround),
            ("largest_step", largest_step.is_some(), Requirement::NoJumps),
            ("largest_step_degrees", largest_step_degrees.is_some(), Requirement::NoJumps),
        ];
        let useless = there.into_iter().find(|(_, is_there, requirement)| *is_there && !gets_points(*requirement));
        if let Some((name, _, requirement)) = useless {
            return Err(format!("requirements.{name} is there, but points.{} gives no points", requirement.id()));
        }
        let count = |name: &str, found: Option<u64>, default: u64, most: u64| match found {
            Some(number) if !(1..=most).contains(&number) => {
                Err(format!("requirements.{name} is {number}, expected a whole number from 1 to {most}"))
            }
            found => Ok(found.unwrap_or(default)),
        };
        let number = |name: &str, found: Option<f64>, default: f64, [least, most]: [f64; 2]| match found {
            Some(number) if !(least..=most).contains(&number) => {
                Err(format!("requirements.{name} is {number}, expected {least} to {most}"))
            }
            found => Ok(found.unwrap_or(default)),
        };
        let usual = Requirements::default();
        Ok(Requirements {
            minimum_keyframes: count("minimum_keyframes", minimum_keyframes, usual.minimum_keyframes, 2000)?,
            minimum_nodes_moved: count("minimum_nodes_moved", minimum_nodes_moved, usual.minimum_nodes_moved, 100_000)?,
            lowest_y: number("lowest_y", lowest_y, usual.lowest_y, [-1e6, 1e6])?,
            largest_step: number("largest_step", largest_step, usual.largest_step, [0.0, 1e6])?,
            largest_step_degrees: number(
                "largest_step_degrees",
                largest_step_degrees,
                usual.largest_step_degrees,
                [0.0, 180.0],
            )?,
        })
    }
}

#[cfg(test)]
mod tests;
