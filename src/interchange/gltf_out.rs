//! Scenes and animations as glTF 2.0, with a statement of how exact the animation is.
//!
//! Each node of a scene is a glTF node under the same parent, named by the last part of its path. RBT and control nodes have their
//! transforms, shapes a mesh, eyes the scene's camera. RBT nodes move from key time 0, at 0 s; control nodes by their timed keys.
//!
//! What glTF has no place for is in `extras.inbetween`, in the form of scene and keyframe files, so that a scene comes back as it was: of a
//! node `path`, `kind` (`rbt`, `control` or `shape`) and the fields of [`node_properties_to_json`](crate::scene::node_properties_to_json);
//! of the scene `name`, `eyes`, `vertical_fov_degrees` and `lighting`; of the animation `interpolation`, `ms_between_keyframes`, and lists with an item
//! for each played keyframe but the last: `durations` and `easings`, and with the last one `names`. No transform and no key is there.

mod animation;
mod fit;
mod keyed;
mod keys;
mod measure;
mod motion;
mod report;
mod tree;

use crate::gltf::Writer;
use crate::keyframe::{Animation, PlayRange};
use crate::scene::SceneGraph;

pub use fit::Tolerance;
pub use keys::Curves;
pub use report::{Exactness, Report, Worst};

/// What is exported, and how.
#[derive(Clone, Copy, Debug)]
pub struct Export<'a> {
    /// The scene.
    pub scene: &'a SceneGraph,
    /// The animation, which must be long enough to play, and its name in the file; without one, timed keys alone move.
    pub animation: Option<(&'a Animation, &'a str)>,
    /// How far readers may be off, in the world.
    pub tolerance: Tolerance,
    /// How values between keys are said.
    pub curves: Curves,
    /// A key for each frame in place of as few as the tolerance allows.
    pub frames_per_second: Option<u32>,
    /// Whether shapes are written.
    pub has_meshes: bool,
}

impl<'a> Export<'a> {
    /// The export of a scene with the defaults.
    #[must_use]
    pub fn of(scene: &'a SceneGraph) -> Self {
        Self {
            scene,
            animation: None,
            tolerance: Tolerance::default(),
            curves: Curves::default(),
            frames_per_second: None,
            has_meshes: true,
        }
    }

    /// The file as binary glTF, and what is to be said of it.
    #[must_use]
    pub fn glb(self) -> (Vec<u8>, Report) {
        let (writer, report) = self.written();
        (writer.into_glb(), report)
    }

    /// The file as JSON with everything inside, and what is to be said of it.
    #[must_use]
    pub fn gltf(self) -> (String, Report) {
        let (writer, report) = self.written();
        (writer.into_gltf(), report)
    }

    fn written(self) -> (Writer, Report) {
        let mut writer = Writer::new();
        let mut report = Report::default();
        let nodes = tree::write(&mut writer, self, &mut report);
        let range = self.animation.and_then(|(animation, _)| PlayRange::new(&animation.keyframes).ok());
        let played = self.animation.zip(range.as_ref()).map(|((animation, _), range)| (animation, range));
        let motions = motion::motions(self.scene, played);
        let tree = measure::Tree::of(self.scene, self.has_meshes);
        let fitted = match self.frames_per_second {
            Some(frames_per_second) => fit::each_frame(&tree, &motions, frames_per_second, self.curves),
            None => fit::within(&tree, &motions, self.tolerance, self.curves),
        };
        animation::write(&mut writer, self, &nodes, &motions, &fitted, &mut report);
        (writer, report)
    }
}
