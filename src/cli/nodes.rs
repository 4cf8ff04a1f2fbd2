//! `inbetween nodes`: the paths of the RBT nodes.

use super::arguments::NodesArguments;
use super::places::Places;
use super::{CliError, Common, output, scene};
use crate::json::push_strings;

/// Prints the paths in the order of poses: one a line, or a JSON list.
///
/// # Errors
/// [`CliError`]: a bad scene; standard output does not take them.
pub fn run(arguments: &NodesArguments, common: Common<'_>) -> Result<(), CliError> {
    Places::with_scene(common.scene).check()?;
    let scene = scene::load(common.scene)?;
    let mut text = String::new();
    if arguments.json {
        push_strings(&mut text, scene.rbt_paths());
        text.push('\n');
    } else {
        text.extend(scene.rbt_paths().flat_map(|path| [path, "\n"]));
    }
    output::list(&text)
}
