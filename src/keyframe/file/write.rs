//! Writes the text of a keyframe file, piece by piece on all cores.

use std::fmt::{self, Write as _};
use std::ops::Range;
use std::sync::Arc;
use std::sync::mpsc::{self, Receiver, Sender};
use std::thread;

use super::{FORMAT, VERSIONS};
use crate::interpolation::Interpolation;
use crate::json::RbtBuffer;
use crate::keyframe::easing::Easing;
use crate::keyframe::list::{Keyframe, KeyframeList};
use crate::pose::RbtIndex;
use crate::scene::SceneGraph;

/// Nodes per piece of text: a few hundred kilobytes.
const PIECE_NODES: usize = 1024;
/// Upper bound of the bytes per node of a pose in bounds: the names, and seven numbers of up to 15 bytes. Untouched pages of a reservation
/// cost nothing.
pub const MOST_NODE_BYTES: usize = 160;
/// Pieces per thread: finished ones that wait to be written, and one in progress.
const PIECES_AHEAD: usize = 3;

/// The text of a keyframe file: the same bytes for the same keyframes, one line for each node of each pose.
#[must_use]
pub fn keyframes_to_json(
    scene: &SceneGraph,
    keyframes: &KeyframeList,
    interpolation: Interpolation,
    ms_between_keyframes: u32,
) -> String {
    let nodes: usize = keyframes.as_slice().iter().map(|keyframe| keyframe.pose.len()).sum();
    let mut text = String::with_capacity(nodes * MOST_NODE_BYTES);
    let json = KeyframesJson { scene, keyframes, interpolation, ms_between_keyframes };
    write!(text, "{json}").expect("memory takes all");
    text
}

/// A keyframe file that owns its data cheaply: it shares the scene and the keyframes. Its `Display` is the file's text.
#[derive(Clone, Debug, PartialEq)]
pub struct KeyframesText {
    /// The scene whose nodes the poses are of.
    pub scene: Arc<SceneGraph>,
    /// The keyframes.
    pub keyframes: KeyframeList,
    /// The interpolation.
    pub interpolation: Interpolation,
    /// The milliseconds between keyframes.
    pub ms_between_keyframes: u32,
}

impl fmt::Display for KeyframesText {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { scene, keyframes, interpolation, ms_between_keyframes } = self;
        let (interpolation, ms_between_keyframes) = (*interpolation, *ms_between_keyframes);
        KeyframesJson { scene, keyframes, interpolation, ms_between_keyframes }.fmt(out)
    }
}

/// A keyframe file whose `Display` is the file's text, made while it is written.
#[derive(Clone, Copy, Debug)]
pub struct KeyframesJson<'a> {
    /// The scene whose nodes the poses are of.
    pub scene: &'a SceneGraph,
    /// The keyframes.
    pub keyframes: &'a KeyframeList,
    /// The interpolation.
    pub interpolation: Interpolation,
    /// The milliseconds between keyframes.
    pub ms_between_keyframes: u32,
}

impl fmt::Display for KeyframesJson<'_> {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let has_extras = self.keyframes.as_slice().iter().any(Keyframe::has_extras);
        let version = if has_extras { VERSIONS.end() } else { VERSIONS.start() };
        let quoted = |name: &str| serde_json::Value::from(name).to_string();
        write!(
            out,
            "{{\n  \"format\": \"{FORMAT}\",\n  \"version\": {version},\n  \"scene\": {},\n  \"interpolation\": \"{}\",\n  \
             \"ms_between_keyframes\": {},\n  \"nodes\": [",
            quoted(self.scene.name()),
            self.interpolation.name(),
            self.ms_between_keyframes,
        )?;
        for (index, path) in self.scene.rbt_paths().enumerate() {
            write!(out, "{}    {}", if index == 0 { "\n" } else { ",\n" }, quoted(path))?;
        }
        out.write_str("\n  ],\n  \"keyframes\": [")?;
        write_keyframes(self.keyframes.as_slice(), |text| out.write_str(text))?;
        out.write_str(if self.keyframes.is_empty() { "]\n}\n" } else { "\n  ]\n}\n" })
    }
}

/// A piece of the text: whole keyframes, or some nodes of one keyframe.
#[derive(Debug)]
struct Piece {
    keyframes: Range<usize>,
    nodes: Range<usize>,
}

/// Keyframes in pieces of about [`PIECE_NODES`] nodes, in order.
fn pieces(keyframes: &[Keyframe]) -> Vec<Piece> {
    let mut pieces: Vec<Piece> = Vec::new();
    let mut held = PIECE_NODES;
    for (keyframe_index, Keyframe { pose, .. }) in keyframes.iter().enumerate() {
        let nodes = pose.len();
        if nodes > PIECE_NODES {
            let starts = (0..nodes).step_by(PIECE_NODES);
            pieces.extend(starts.map(|start| Piece {
                keyframes: keyframe_index..keyframe_index + 1,
                nodes: start..nodes.min(start + PIECE_NODES),
            }));
            held = PIECE_NODES;
        } else if let Some(last) = pieces.last_mut().filter(|_| held + nodes.max(1) <= PIECE_NODES) {
            last.keyframes.end = keyframe_index + 1;
            held += nodes.max(1);
        } else {
            pieces.push(Piece { keyframes: keyframe_index..keyframe_index + 1, nodes: 0..PIECE_NODES });
            held = nodes.max(1);
        }
    }
    pieces
}

/// Writes the text of keyframes piece by piece. Threads make the pieces in turn and never run far ahead of the writer. Unlike
/// [`crate::parallel::map_in_order`], which keeps all results, this needs memory for a few pieces only.
fn write_keyframes(keyframes: &[Keyframe], mut write: impl FnMut(&str) -> fmt::Result) -> fmt::Result {
    let pieces = pieces(keyframes);
    let threads = thread::available_parallelism().map_or(1, usize::from).min(pieces.len());
    if threads <= 1 {
        let mut text = String::new();
        return pieces.iter().try_for_each(|piece| {
            text = text_of(piece, keyframes, std::mem::take(&mut text));
            write(&text)
        });
    }
    let pieces = &pieces;
    thread::scope(|scope| {
        let makers: Vec<(Sender<String>, Receiver<String>)> = (0..threads)
            .map(|thread| {
                let (give_back, blank) = mpsc::channel();
                let (give, made) = mpsc::channel();
                for _ in 0..PIECES_AHEAD {
                    let _ = give_back.send(String::new());
                }
                scope.spawn(move || {
                    for piece in pieces.iter().skip(thread).step_by(threads) {
                        let Ok(storage) = blank.recv() else { break };
                        if give.send(text_of(piece, keyframes, storage)).is_err() {
                            break;
                        }
                    }
                });
                (give_back, made)
            })
            .collect();
        for (_, (give_back, made)) in pieces.iter().zip(makers.iter().cycle()) {
            let text = made.recv().map_err(|_| fmt::Error)?;
            write(&text)?;
            let _ = give_back.send(text);
        }
        Ok(())
    })
}

/// A piece of the text between the brackets of `keyframes`, in storage that is reused.
fn text_of(piece: &Piece, keyframes: &[Keyframe], storage: String) -> String {
    let mut text = storage.into_bytes();
    text.clear();
    let mut buffer = RbtBuffer::default();
    for keyframe_index in piece.keyframes.clone() {
        let keyframe = &keyframes[keyframe_index];
        if piece.nodes.start == 0 {
            text.extend_from_slice(if keyframe_index == 0 { b"\n    { " } else { b",\n    { " });
            text.extend_from_slice(extras(keyframe).as_bytes());
            text.extend_from_slice(b"\"pose\": [");
        }
        let nodes = keyframe.pose.len();
        for node in piece.nodes.start..nodes.min(piece.nodes.end) {
            let rbt = keyframe.pose.get(RbtIndex::new(node));
            text.extend_from_slice(if node == 0 {
                buffer.of(b"\n      ", &rbt)
            } else {
                buffer.of(b",\n      ", &rbt)
            });
        }
        if piece.nodes.end >= nodes {
            text.extend_from_slice(b"\n    ] }");
        }
    }
    String::from_utf8(text).expect("it was put together from texts")
}

/// The fields of a keyframe besides its pose; empty if it has none.
fn extras(keyframe: &Keyframe) -> String {
    let mut text = String::new();
    if let Some(name) = &keyframe.name {
        let _ = write!(text, "\"name\": {}, ", serde_json::Value::from(&**name));
    }
    if keyframe.duration != 1.0 {
        let duration = format!("{:?}", keyframe.duration);
        let _ = write!(text, "\"duration\": {}, ", duration.strip_suffix(".0").unwrap_or(&duration));
    }
    if keyframe.easing != Easing::Linear {
        let _ = write!(text, "\"easing\": \"{}\", ", keyframe.easing.name());
    }
    text
}
