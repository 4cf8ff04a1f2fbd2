//! One picture of a list.

use std::path::PathBuf;

use crate::film::Quality;
use crate::interpolation::Interpolation;
use crate::lighting::BuiltInLighting;

/// What a picture shows of its animation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum When {
    /// The sample at a key time.
    At(f64),
    /// A keyframe of the list, by its index.
    Keyframe(i64),
    /// A frame of the film that the whole playing range makes.
    Frame {
        /// Its number, from 0.
        number: usize,
        /// Frames a second of the film.
        fps: u32,
    },
}

/// One picture that the list asks for.
#[derive(Clone, Debug, PartialEq)]
pub struct Shot {
    /// What the picture is called, and its files after it.
    pub name: String,
    /// The keyframe file, relative to the folder; without it, the scene's rest pose.
    pub file: Option<String>,
    /// A built-in scene, or a scene file relative to the folder.
    pub scene: Option<String>,
    /// What it shows of the animation.
    pub when: When,
    /// The time of the timed keys, in seconds; of a film's frames, their time at its first frame.
    pub seconds: f64,
    /// Width and height in pixels.
    pub size: [u32; 2],
    /// The interpolation to use instead of the file's.
    pub interpolation: Option<Interpolation>,
    /// Samples a pixel, 1 or 4.
    pub samples: u32,
    /// The quality of the picture.
    pub quality: Quality,
    /// The light to use instead of the scene's.
    pub lighting: Option<BuiltInLighting>,
    /// The eye, or turntable.
    pub camera: Option<String>,
    /// The largest score that counts as the same.
    pub tolerance: f32,
    /// The reference's name in the folder.
    pub reference: String,
}

impl Shot {
    /// The name of the picture that is drawn.
    #[must_use]
    pub fn drawn_name(&self) -> String {
        format!("{}.png", self.name)
    }

    /// The name of its difference from the reference.
    #[must_use]
    pub fn difference_name(&self) -> String {
        format!("{}-difference.png", self.name)
    }

    /// The name of the copy of the reference that is kept beside the two.
    #[must_use]
    pub fn reference_copy_name(&self) -> String {
        format!("{}-reference.png", self.name)
    }

    /// The names of the files that a comparison may write into the folder of what is drawn.
    #[must_use]
    pub fn written_names(&self) -> [PathBuf; 3] {
        [self.drawn_name(), self.difference_name(), self.reference_copy_name()].map(PathBuf::from)
    }
}
