//! The user's list of which row is which node.

use super::super::error::{TextError, TextProblem, quoted};
use crate::pose::RbtIndex;
use crate::scene::SceneGraph;
use crate::text::without_byte_order_mark;
use crate::words::{self, Argument, texts};

/// The node of each row of a keyframe, from a user's list.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct JointList {
    nodes: Vec<Option<RbtIndex>>,
}

impl JointList {
    /// Reads a list with one line for each row of a keyframe: a path, or `-` for an unused row. Blank lines and comments after `#` are
    /// skipped.
    ///
    /// # Errors
    /// A path that is not in the scene or occurs twice, and missing nodes of the scene.
    pub fn from_text(bytes: &[u8], scene: &SceneGraph) -> Result<Self, TextError> {
        let error = |at, found: Argument, expected: Argument| {
            TextError::new(bytes, at, TextProblem::Unexpected { found, expected })
        };
        let mut nodes = Vec::new();
        let mut is_named = vec![false; scene.rbt_count()];
        let mut at = bytes.len() - without_byte_order_mark(bytes).len();
        for line in bytes[at..].split(|&byte| byte == b'\n') {
            let path = line.split(|&byte| byte == b'#').next().unwrap_or_default().trim_ascii();
            let node = std::str::from_utf8(path).ok().and_then(|path| scene.find_rbt(path));
            match node {
                _ if path.is_empty() => {}
                None if path == b"-" => nodes.push(None),
                None => return Err(error(at, quoted(path).into(), texts::TEXT_EXPECTED_PATH.into())),
                Some(node) => {
                    if std::mem::replace(&mut is_named[node.get()], true) {
                        return Err(error(
                            at,
                            texts::text_found_again(quoted(path)).into(),
                            texts::TEXT_EXPECTED_PATH_ONCE.into(),
                        ));
                    }
                    nodes.push(Some(node));
                }
            }
            at += line.len() + 1;
        }
        if let Some(missing) = is_named.iter().position(|is_named| !is_named) {
            let path = scene.rbt_path(RbtIndex::new(missing));
            let expected = texts::text_expected_in_list(words::quoted(path)).into();
            return Err(error(bytes.len(), texts::TEXT_FOUND_END_OF_LIST.into(), expected));
        }
        Ok(Self { nodes })
    }

    /// The number of rows.
    #[must_use]
    pub fn rows(&self) -> usize {
        self.nodes.len()
    }

    /// The node of each of so many rows. Rows beyond the list are not used.
    pub(in crate::text_layouts) fn node_of_row(&self, rows: usize) -> Vec<Option<RbtIndex>> {
        self.nodes.iter().copied().chain(std::iter::repeat(None)).take(rows).collect()
    }
}
