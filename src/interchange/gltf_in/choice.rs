//! Which scene and which animation of a file are taken.

use crate::gltf::json::{Index, Root};
use crate::words::{Argument, Message, all_of, quoted, texts};

/// Which animation of a file is wanted.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum AnimationChoice {
    /// The one of this name, or else the one of this number, counted from 0.
    Words(String),
    /// The one of this number, counted from 0.
    Number(usize),
}

/// What a file has to choose from.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Contents {
    /// The names of its scenes, where they have names.
    pub scenes: Vec<Option<String>>,
    /// The number of the scene that the file says is to be shown first.
    pub own_scene: usize,
    /// The names of its animations, where they have names.
    pub animations: Vec<Option<String>>,
}

impl Contents {
    pub(super) fn of(root: &Root) -> Self {
        Self {
            scenes: root.scenes.iter().map(|scene| scene.name.clone()).collect(),
            own_scene: root.scene.unwrap_or(0),
            animations: root.animations.iter().map(|animation| animation.name.clone()).collect(),
        }
    }

    /// Whether there are several of anything.
    #[must_use]
    pub fn has_choice(&self) -> bool {
        self.scenes.len() > 1 || self.animations.len() > 1
    }
}

/// The scene of a number, or the file's own; `None` where the file has none. `others` gets the rest.
pub(super) fn chosen_scene(
    root: &Root,
    wanted: Option<usize>,
    others: &mut Vec<Message>,
) -> Result<Option<Index>, Message> {
    let count = root.scenes.len();
    let chosen = wanted.or(root.scene).unwrap_or(0);
    if chosen >= count {
        let is_given = wanted.is_some() || root.scene.is_some();
        return if is_given { Err(texts::gltf_in_no_scene(chosen.to_string(), count)) } else { Ok(None) };
    }
    if count > 1 {
        let names = root.scenes.iter().map(|scene| scene.name.as_deref());
        others.push(texts::gltf_in_scenes(numbered(names, chosen)));
    }
    Ok(Some(chosen))
}

/// The animation that is wanted, or the first one; `None` where the file has none. `others` gets the rest.
pub(super) fn chosen_animation(
    root: &Root,
    wanted: Option<&AnimationChoice>,
    others: &mut Vec<Message>,
) -> Result<Option<Index>, Message> {
    let count = root.animations.len();
    let chosen = match wanted {
        None if count == 0 => return Ok(None),
        None => 0,
        Some(AnimationChoice::Number(number)) if *number < count => *number,
        Some(AnimationChoice::Number(number)) => return Err(no_animation(root, number.to_string())),
        Some(AnimationChoice::Words(wanted)) => {
            let named = root.animations.iter().position(|animation| animation.name.as_deref() == Some(wanted));
            let by_number = || wanted.parse().ok().filter(|number| *number < count);
            named.or_else(by_number).ok_or_else(|| no_animation(root, quoted(wanted)))?
        }
    };
    if count > 1 {
        let names = root.animations.iter().map(|animation| animation.name.as_deref());
        others.push(texts::gltf_in_animations(numbered(names, chosen)));
    }
    Ok(Some(chosen))
}

fn no_animation(root: &Root, wanted: String) -> Message {
    let names = root.animations.iter().map(|animation| animation.name.as_deref());
    texts::gltf_in_no_animation(wanted, numbered(names, root.animations.len()))
}

/// The numbers and names of all but one of a list: `0 "Survey", 2 "Run"`.
fn numbered<'a>(names: impl Iterator<Item = Option<&'a str>>, but: usize) -> Argument {
    let others = names.enumerate().filter(|(number, _)| *number != but);
    let others: Vec<String> = others
        .map(|(number, name)| name.map_or_else(|| number.to_string(), |name| format!("{number} {}", quoted(name))))
        .collect();
    all_of(&others)
}
