//! YAML as a tree: all scalars as they are written, repeated keys as often as they occur. An alias shares the node that it names, so that
//! no file is larger in memory than it is on the disk.

use std::collections::HashMap;
use std::sync::Arc;

use saphyr_parser::{Event, EventReceiver, Parser};

/// A node.
#[derive(Debug)]
pub enum Yaml {
    /// A text, a number, a date, `~`: as it is written, without quotes.
    Scalar(String),
    /// A list.
    Sequence(Vec<Arc<Self>>),
    /// Keys and values, in the order of the file.
    Mapping(Vec<(Arc<Self>, Arc<Self>)>),
}

impl Yaml {
    /// The nodes of a list.
    pub fn sequence(&self) -> Option<&[Arc<Self>]> {
        if let Self::Sequence(nodes) = self { Some(nodes) } else { None }
    }

    /// The keys and values of a mapping.
    pub fn mapping(&self) -> Option<&[(Arc<Self>, Arc<Self>)]> {
        if let Self::Mapping(entries) = self { Some(entries) } else { None }
    }
}

/// The first document of a file, if there is one.
///
/// # Errors
/// Why it is not YAML: a sentence.
pub fn first_document(source: &str) -> Result<Option<Arc<Yaml>>, String> {
    let mut builder = Builder::default();
    Parser::new_from_str(source).load(&mut builder, false).map_err(|error| error.to_string())?;
    Ok(builder.first)
}

/// Makes the tree of what the parser finds.
#[derive(Default)]
struct Builder {
    /// The lists and mappings that are not closed yet, with their anchors; keys and values of mappings in turn.
    open: Vec<(usize, bool, Vec<Arc<Yaml>>)>,
    anchors: HashMap<usize, Arc<Yaml>>,
    first: Option<Arc<Yaml>>,
}

impl Builder {
    fn add(&mut self, anchor: usize, node: Arc<Yaml>) {
        // Zero is none.
        if anchor != 0 {
            self.anchors.insert(anchor, Arc::clone(&node));
        }
        match self.open.last_mut() {
            Some((.., nodes)) => nodes.push(node),
            None => drop(self.first.get_or_insert(node)),
        }
    }

    fn close(&mut self) {
        let Some((anchor, is_mapping, nodes)) = self.open.pop() else { return };
        let node = if is_mapping {
            let (pairs, _) = nodes.as_chunks();
            Yaml::Mapping(pairs.iter().map(|[key, value]| (Arc::clone(key), Arc::clone(value))).collect())
        } else {
            Yaml::Sequence(nodes)
        };
        self.add(anchor, Arc::new(node));
    }
}

impl<'input> EventReceiver<'input> for Builder {
    fn on_event(&mut self, event: Event<'input>) {
        match event {
            Event::Scalar(text, _, anchor, _) => self.add(anchor, Arc::new(Yaml::Scalar(text.into_owned()))),
            Event::SequenceStart(anchor, _) => self.open.push((anchor, false, Vec::new())),
            Event::MappingStart(anchor, _) => self.open.push((anchor, true, Vec::new())),
            Event::SequenceEnd | Event::MappingEnd => self.close(),
            Event::Alias(anchor) => {
                // A node that names itself is none yet.
                let node = self.anchors.get(&anchor).cloned();
                self.add(0, node.unwrap_or_else(|| Arc::new(Yaml::Scalar("~".to_owned()))));
            }
            Event::DocumentEnd => self.anchors.clear(),
            _ => {}
        }
    }
}
