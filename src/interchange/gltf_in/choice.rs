//! Which scene and which animation of a file are taken.

use crate::gltf::json::{Animation, Index, Root};
use crate::words::{Message, all_of, quoted, texts};

/// The scene of a number, or the file's own; `None` where the file has none. `notes` gets the others.
pub(super) fn chosen_scene(
    root: &Root,
    wanted: Option<usize>,
    notes: &mut Vec<Message>,
) -> Result<Option<Index>, Message> {
    let count = root.scenes.len();
    let chosen = wanted.or(root.scene).unwrap_or(0);
    if chosen >= count {
        let is_given = wanted.is_some() || root.scene.is_some();
        return if is_given { Err(texts::gltf_in_no_scene(chosen.to_string(), count)) } else { Ok(None) };
    }
    if count > 1 {
        let names = root.scenes.iter().map(|scene| scene.name.as_deref());
        notes.push(texts::gltf_in_scenes(numbered(names, chosen)));
    }
    Ok(Some(chosen))
}

/// The animation of a name or a number, or the first one; `None` where the file has none. `notes` gets the others.
pub(super) fn chosen_animation(
    root: &Root,
    wanted: Option<&str>,
    notes: &mut Vec<Message>,
) -> Result<Option<Index>, Message> {
    let count = root.animations.len();
    let chosen = match wanted {
        None if count == 0 => return Ok(None),
        None => 0,
        Some(wanted) => {
            let named = root.animations.iter().position(|animation| animation.name.as_deref() == Some(wanted));
            let by_number = || wanted.parse().ok().filter(|number| *number < count);
            named.or_else(by_number).ok_or_else(|| {
                let names = root.animations.iter().map(|animation| animation.name.as_deref());
                texts::gltf_in_no_animation(quoted(wanted), numbered(names, count))
            })?
        }
    };
    if count > 1 {
        let names = root.animations.iter().map(|animation| animation.name.as_deref());
        notes.push(texts::gltf_in_animations(numbered(names, chosen)));
    }
    Ok(Some(chosen))
}

/// The names of a file's animations; of one without a name its number.
pub(super) fn animation_names(root: &Root) -> Vec<String> {
    let name = |(number, animation): (usize, &Animation)| animation.name.clone().unwrap_or_else(|| number.to_string());
    root.animations.iter().enumerate().map(name).collect()
}

/// The numbers and names of all but one of a list: `0 "Survey", 2 "Run"`.
fn numbered<'a>(names: impl Iterator<Item = Option<&'a str>>, but: usize) -> crate::words::Argument {
    let others = names.enumerate().filter(|(number, _)| *number != but);
    let others: Vec<String> = others
        .map(|(number, name)| name.map_or_else(|| number.to_string(), |name| format!("{number} {}", quoted(name))))
        .collect();
    all_of(&others)
}
