//! `inbetween nodes`: the paths of the RBT nodes.

use super::{CliError, output};
use crate::scene::SceneGraph;

/// Prints the paths, one a line, in the order of poses.
///
/// # Errors
/// [`CliError`]: standard output does not take them.
pub fn run(scene: &SceneGraph) -> Result<(), CliError> {
    let mut lines = String::new();
    for path in scene.rbt_paths() {
        lines.push_str(path);
        lines.push('\n');
    }
    output::list(&lines)
}
