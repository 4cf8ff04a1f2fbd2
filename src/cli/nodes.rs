//! `inbetween nodes`: the paths of the RBT nodes.

use super::{CliError, output};
use crate::scene::SceneGraph;

/// Prints the paths, one a line, in the order of poses.
///
/// # Errors
/// [`CliError`]: standard output does not take them.
pub fn run(scene: &SceneGraph) -> Result<(), CliError> {
    output::list(&scene.rbt_paths().map(|path| format!("{path}\n")).collect::<String>())
}
