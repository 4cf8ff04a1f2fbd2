//! The fast reader: keyframes as programs write them, read on all cores directly into poses.
//!
//! It accepts one layout: `keyframes` somewhere in the file, `pose` last in each keyframe, names without escapes, numbers within range. It
//! gives up on anything else and on any error; the strict reader then reads the file. The text outside of keyframes and poses is read by
//! the strict reader's code, the text inside by a [`Cursor`].

use std::sync::atomic::{AtomicBool, Ordering};

use glam::{Quat, Vec3};

use super::KeyframeFile;
use super::cursor::Cursor;
use super::problems::Problems;
use super::strict::{self, FileText, Head, KeyframeText};
use crate::keyframe::list::Keyframe;
use crate::parallel::map_in_order;
use crate::pose::{LANES, Pose, RbtBlock};
use crate::rbt::Rbt;
use crate::scene::SceneGraph;

/// Bytes of text that one thread reads as a piece: some milliseconds of work.
const PIECE_BYTES: usize = 1 << 20;

/// Reads a keyframe file for a scene, with the same result as [`strict::read`]. `None` if the strict reader must read it.
pub fn read(bytes: &[u8], scene: &SceneGraph) -> Option<KeyframeFile> {
    read_in_pieces(bytes, scene, PIECE_BYTES)
}

/// Like [`read`], with pieces of at least `piece_bytes` bytes.
pub fn read_in_pieces(bytes: &[u8], scene: &SceneGraph, piece_bytes: usize) -> Option<KeyframeFile> {
    let mut cursor = Cursor::new(bytes, 0);
    cursor.skip_to_array(b"\"keyframes\"")?;
    let (start, end) = (cursor.at(), end_of_keyframes(bytes)?);
    let around = [bytes.get(..start)?, bytes.get(end..)?].concat();
    if end < start {
        return None;
    }
    let text: FileText = serde_json::from_slice(&around).ok()?;
    if strict::header_problem(&text.format, text.version).is_some() {
        return None;
    }
    let mut problems = Problems::default();
    let Head { interpolation, ms_between_keyframes, index_in_file } = strict::head_of(&text, scene, &mut problems);
    problems.into_result(()).ok()?;
    let index_in_file = index_in_file?;
    let mut index_in_scene = vec![0; index_in_file.len()];
    for (in_scene, in_file) in index_in_file.into_iter().enumerate() {
        *index_in_scene.get_mut(in_file)? = in_scene;
    }
    let keyframes = Keyframes { text: bytes, version: text.version, index_in_scene };
    Some(KeyframeFile {
        interpolation,
        ms_between_keyframes,
        keyframes: keyframes.read(&pieces(bytes, start, end, piece_bytes))?,
    })
}

/// The offset of the last byte before `at` that is not white space.
fn last_before(bytes: &[u8], at: usize) -> Option<usize> {
    bytes[..at].iter().rposition(|byte| !matches!(byte, b' ' | b'\n' | b'\t' | b'\r'))
}

/// The offset of the last `]` that follows `]}`: the probable end of `keyframes`. `]}` ends the last pose and its keyframe.
fn end_of_keyframes(bytes: &[u8]) -> Option<usize> {
    let mut at = bytes.len();
    loop {
        at = bytes[..at].iter().rposition(|&byte| byte == b']')?;
        let brace = last_before(bytes, at)?;
        if bytes[brace] == b'}' && bytes[last_before(bytes, brace)?] == b']' {
            return Some(at);
        }
    }
}

/// Offsets of probable keyframe starts, at least `piece_bytes` apart. The first is `start`, the last `end`. A wrong offset is
/// safe: the piece before it ends in the middle of a keyframe, so [`read`] returns `None`.
fn pieces(bytes: &[u8], start: usize, end: usize, piece_bytes: usize) -> Vec<usize> {
    let mut boundaries = vec![start];
    let mut at = start + piece_bytes;
    while let Some(found) = bytes.get(at..end).and_then(|rest| rest.iter().position(|&byte| byte == b']')) {
        at += found + 1;
        let is_end_of_pose = last_before(bytes, at - 1).is_some_and(|before| bytes[before] == b'}');
        let mut cursor = Cursor::new(&bytes[..end], at);
        if is_end_of_pose && cursor.expect(b'}').is_some() && cursor.expect(b',').is_some() {
            cursor.skip_space();
            boundaries.push(cursor.at());
            at = cursor.at() + piece_bytes;
        }
    }
    boundaries.push(end);
    boundaries
}

/// The data that all threads share.
struct Keyframes<'a> {
    text: &'a [u8],
    version: u64,
    /// For each index in the file's `nodes`, the index of that node in the scene's pose order.
    index_in_scene: Vec<usize>,
}

impl Keyframes<'_> {
    /// Reads the keyframes between these offsets on all cores.
    fn read(&self, boundaries: &[usize]) -> Option<Vec<Keyframe>> {
        let last = boundaries.last();
        let pieces: Vec<&[usize]> = boundaries.windows(2).collect();
        let is_given_up = AtomicBool::new(false);
        let read = map_in_order(&pieces, |piece| {
            if is_given_up.load(Ordering::Relaxed) {
                return None;
            }
            let read = self.piece(piece[0], piece[1], piece.last() == last);
            is_given_up.fetch_or(read.is_none(), Ordering::Relaxed);
            read
        });
        let read: Vec<Vec<Keyframe>> = read.into_iter().collect::<Option<_>>()?;
        let mut keyframes = Vec::with_capacity(read.iter().map(Vec::len).sum());
        keyframes.extend(read.into_iter().flatten());
        Some(keyframes)
    }

    /// Reads the keyframes from offset `start` to `end`, with a comma after each except the very last.
    fn piece(&self, start: usize, end: usize, is_last: bool) -> Option<Vec<Keyframe>> {
        let mut cursor = Cursor::new(&self.text[..end], start);
        let mut keyframes = Vec::new();
        loop {
            keyframes.push(self.keyframe(&mut cursor)?);
            cursor.skip_space();
            if cursor.is_at_end() {
                return is_last.then_some(keyframes);
            }
            cursor.expect(b',')?;
            cursor.skip_space();
            if cursor.is_at_end() {
                return (!is_last).then_some(keyframes);
            }
        }
    }

    fn keyframe(&self, cursor: &mut Cursor<'_>) -> Option<Keyframe> {
        let start = *cursor;
        cursor.expect(b'{')?;
        let mut keyframe = if cursor.try_consume(b"\"pose\"") {
            cursor.expect(b':')?;
            cursor.expect(b'[')?;
            Keyframe::new(Pose::identity(0))
        } else {
            *cursor = start;
            cursor.skip_to_array(b"\"pose\"")?;
            self.extras(&self.text[start.at()..cursor.at()])?
        };
        let mut is_read = false;
        let nodes = self.index_in_scene.len();
        keyframe.pose.fill(nodes, |blocks| is_read = self.pose(cursor, blocks).is_some());
        cursor.expect(b'}')?;
        is_read.then_some(keyframe)
    }

    /// The keyframe without its pose, from the text before the pose.
    fn extras(&self, before_pose: &[u8]) -> Option<Keyframe> {
        let text: KeyframeText = serde_json::from_slice(&[before_pose, b"]}"].concat()).ok()?;
        let mut problems = Problems::default();
        let keyframe = strict::extras_of(&text, 0, self.version, &mut problems);
        problems.into_result(keyframe).ok()
    }

    fn pose(&self, cursor: &mut Cursor<'_>, blocks: &mut [RbtBlock]) -> Option<()> {
        for (entry, &index) in self.index_in_scene.iter().enumerate() {
            if entry > 0 {
                cursor.expect(b',')?;
            }
            let mut rbt = rbt(cursor)?;
            if strict::mend(&mut rbt, 0, "").is_some() {
                return None;
            }
            blocks[index / LANES].set(index % LANES, rbt);
        }
        cursor.expect(b']')
    }
}

/// A translation and a rotation, in either order.
#[inline]
fn rbt(cursor: &mut Cursor<'_>) -> Option<Rbt> {
    const TRANSLATION: &[u8; 13] = b"\"translation\"";
    const ROTATION: &[u8; 10] = b"\"rotation\"";
    cursor.expect(b'{')?;
    let (translation, rotation);
    if cursor.try_consume(TRANSLATION) {
        cursor.expect(b':')?;
        translation = cursor.read_numbers()?;
        cursor.expect(b',')?;
        cursor.try_consume(ROTATION).then_some(())?;
        cursor.expect(b':')?;
        rotation = cursor.read_numbers()?;
    } else {
        cursor.try_consume(ROTATION).then_some(())?;
        cursor.expect(b':')?;
        rotation = cursor.read_numbers()?;
        cursor.expect(b',')?;
        cursor.try_consume(TRANSLATION).then_some(())?;
        cursor.expect(b':')?;
        translation = cursor.read_numbers()?;
    }
    cursor.expect(b'}')?;
    Some(Rbt::new(Vec3::from(translation), Quat::from_array(rotation)))
}
