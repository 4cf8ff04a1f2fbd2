//! What a window can begin with: scenes and animations, built in or from files.

use std::path::Path;
use std::sync::Arc;

use super::model::{Model, ModelError, ModelOptions};
use super::scene::load_file;
use crate::editor::{Beginning, Document, Editor, ModelChoice, NEW_FILE};
use crate::interchange::gltf_in::AnimationChoice;
use crate::keyframe::KeyframeIndex;
use crate::scene::{BUILT_IN_ANIMATIONS, built_in_scene};
use crate::storage;
use crate::words::{Message, texts};

/// What a window begins with.
#[derive(Debug)]
pub struct Begun {
    /// Its editor.
    pub editor: Editor,
    /// What is to be said of it.
    pub said: Vec<Message>,
}

/// An editor that begins so. Its keyframe file is in `folder` and not there yet, so that saving it replaces nothing.
///
/// # Errors
/// Why the file cannot be read, or that nothing built in has the name.
pub fn begun(beginning: &Beginning, folder: &Path) -> Result<Begun, Message> {
    let silent = |editor| Begun { editor, said: Vec::new() };
    let new = |name: &str| storage::free_path(&folder.join(name));
    let of_scene = |name: &str| built_in_scene(name).ok_or_else(|| texts::refused_no_example(name));
    match beginning {
        Beginning::SceneFile(path) => {
            let scene = load_file(path).map_err(|reason| texts::refused_file(path.display(), reason))?;
            Ok(silent(Editor::new(Arc::new(scene), new(NEW_FILE)).with_scene_path(path.clone())))
        }
        Beginning::Scene(name) => Ok(silent(Editor::new(Arc::new(of_scene(name)?), new(NEW_FILE)))),
        Beginning::Animation(name) => {
            let example = BUILT_IN_ANIMATIONS.iter().find(|example| example.name == *name);
            let example = example.ok_or_else(|| texts::refused_no_example(*name))?;
            let path = new(&format!("{name}.json"));
            let mut editor = Editor::new(Arc::new(of_scene(example.scene)?), path.clone());
            editor.keyframes_read(&path, Ok(example.text.into())).map_err(|error| error.message())?;
            Ok(silent(editor))
        }
        Beginning::Model { path, choice } => {
            let ModelChoice { scene, animation } = choice.unwrap_or_default();
            let animation = animation.map(AnimationChoice::Number);
            let options = ModelOptions { animation, gltf_scene: scene, ..Default::default() };
            let model = Model::read(path, &options).map_err(|error| match error {
                ModelError::Misuse(said) => texts::refused_file(path.display(), said),
                ModelError::File(error) => texts::foreign(error.to_string()),
            })?;
            let keyframes = model.usual_keyframes();
            let mut document = Document::new(Arc::new(model.scene));
            let mut said = model.notes;
            if let Some((mut animation, sentence)) = keyframes {
                // The first keyframe only steers: the motion begins at the second.
                animation.keyframes.set_current(KeyframeIndex::new(1));
                document.install(animation);
                said.push(sentence);
            }
            let name = path.with_extension("json");
            let file = storage::free_path(&folder.join(name.file_name().unwrap_or(NEW_FILE.as_ref())));
            Ok(Begun { editor: Editor::of_unsaved(document, file), said })
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::built_in_scene_names;

    #[test]
    fn every_example_opens_and_its_file_is_new() {
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("walk.json"), "mine").unwrap();
        for example in BUILT_IN_ANIMATIONS {
            let Begun { editor, .. } = begun(&Beginning::Animation(example.name), folder.path()).unwrap();
            assert_eq!(editor.scene().name(), example.scene);
            assert!(editor.document().keyframes.len() >= 4 && !editor.has_unsaved_changes(), "{}", example.name);
            assert!(!editor.keyframe_file().exists(), "{}", editor.keyframe_file().display());
        }
        for name in built_in_scene_names() {
            let Begun { editor, .. } = begun(&Beginning::Scene(name), folder.path()).unwrap();
            assert!(editor.document().keyframes.is_empty() && editor.keyframe_file().ends_with(NEW_FILE));
        }
    }

    #[test]
    fn a_model_opens_where_its_motion_begins() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("walk.gltf");
        let Begun { editor, .. } = begun(&Beginning::Animation("walk"), folder.path()).unwrap();
        super::super::model::write(&path, editor.document()).unwrap();
        let choice = Some(ModelChoice { scene: Some(0), animation: Some(0) });
        let Begun { editor, said } = begun(&Beginning::Model { path, choice }, folder.path()).unwrap();
        let document = editor.document();
        assert_eq!(document.keyframes.current(), Some(KeyframeIndex::new(1)));
        assert!(document.live_pose == document.keyframes.as_slice()[1].pose && editor.has_unsaved_scene());
        assert!(said.len() >= 2 && !said.iter().any(|said| said.to_string().contains("--")), "{said:?}");
    }

    #[test]
    fn a_scene_file_opens_with_its_own_path() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("mine.json");
        std::fs::write(&path, include_str!("../../assets/scenes/orbits.json")).unwrap();
        let Begun { editor, .. } = begun(&Beginning::SceneFile(path.clone()), folder.path()).unwrap();
        assert_eq!(editor.scene_path(), Some(&*path));
        std::fs::write(&path, "{").unwrap();
        let said = begun(&Beginning::SceneFile(path.clone()), folder.path()).map(|_| ()).unwrap_err().to_string();
        assert!(said.contains("mine.json") && said.contains("line 1"), "{said}");
        assert!(begun(&Beginning::Scene("nosuch"), folder.path()).is_err());
    }
}
