//! Reads BVH: words up to `MOTION`, lines after it.

use super::{BvhError, Capture, CapturedJoint, Channel};
use crate::interchange::MOST_NODE_POSES;
use crate::text::without_byte_order_mark;
use crate::words::{Argument, Message, quoted, texts};

use glam::DVec3;

/// The largest BVH file that is read: 256 MiB.
pub const LARGEST_BVH_BYTES: u64 = 256 << 20;
/// The most joints.
const MOST_JOINTS: usize = 4096;
/// The most levels of joints: a scene has room for them and for what they carry.
const MOST_DEPTH: usize = 250;
/// The longest name that is kept, in characters.
const LONGEST_NAME: usize = 64;
/// The seconds from a frame to the next.
const FRAME_SECONDS: std::ops::RangeInclusive<f64> = 1e-4..=100.0;

const HIERARCHY: &str = "HIERARCHY";

/// Reads a BVH file. A byte order mark is skipped; keywords may be in capitals or not.
///
/// # Errors
/// One [`BvhError`] with its line.
pub fn read_bvh(bytes: &[u8]) -> Result<Capture, BvhError> {
    // Names in other encodings are not worth an error.
    let text = String::from_utf8_lossy(without_byte_order_mark(bytes));
    let mut words = Words { rest: &text, line: 1 };
    words.keyword(HIERARCHY)?;
    let joints = joints(&mut words)?;
    motion(joints, &words)
}

/// The words of a text. A brace is a word.
struct Words<'a> {
    rest: &'a str,
    line: usize,
}

impl<'a> Words<'a> {
    fn next(&mut self) -> Option<&'a str> {
        let trimmed = self.rest.trim_start();
        let skipped = &self.rest[..self.rest.len() - trimmed.len()];
        self.line += skipped.bytes().filter(|&byte| byte == b'\n').count();
        let is_end = |character: char| character.is_whitespace() || matches!(character, '{' | '}');
        let length = match trimmed.chars().next() {
            Some('{' | '}') => 1,
            _ => trimmed.find(is_end).unwrap_or(trimmed.len()),
        };
        let word;
        (word, self.rest) = trimmed.split_at(length);
        (!word.is_empty()).then_some(word)
    }

    fn error(&self, problem: impl Into<Message>) -> BvhError {
        BvhError { line: self.line, problem: problem.into() }
    }

    fn expected(&self, expected: impl Into<Argument>, found: Option<&str>) -> BvhError {
        let found: Argument = match found {
            Some(word) => quoted(&short(word)).into(),
            None => texts::BVH_END_OF_FILE.into(),
        };
        self.error(texts::bvh_expected(expected, found))
    }

    fn keyword(&mut self, keyword: &'static str) -> Result<(), BvhError> {
        match self.next() {
            Some(word) if word.eq_ignore_ascii_case(keyword) => Ok(()),
            found => Err(self.expected(keyword, found)),
        }
    }

    /// All words up to a brace that opens, as a name.
    fn name(&mut self) -> Result<String, BvhError> {
        let mut name = String::new();
        loop {
            match self.next() {
                Some("{") => return Ok(name),
                Some(word) if word != "}" => {
                    if !name.is_empty() {
                        name.push(' ');
                    }
                    name = short(&(name + word));
                }
                found => return Err(self.expected("{", found)),
            }
        }
    }

    fn number(&mut self) -> Result<f64, BvhError> {
        let word = self.next();
        word.and_then(number).ok_or_else(|| self.expected(texts::BVH_A_NUMBER, word))
    }
}

/// A finite number.
fn number(word: &str) -> Option<f64> {
    word.parse().ok().filter(|number: &f64| number.is_finite())
}

/// The beginning of a text that may be too long.
fn short(text: &str) -> String {
    text.chars().filter(|character| !character.is_control()).take(LONGEST_NAME).collect()
}

/// What a brace has opened.
#[derive(Clone, Copy)]
enum Open {
    Joint(usize),
    /// The end of a bone of a joint.
    End(usize),
}

/// The tree of joints, up to and with the word `MOTION`.
fn joints(words: &mut Words<'_>) -> Result<Vec<CapturedJoint>, BvhError> {
    let mut joints: Vec<CapturedJoint> = Vec::new();
    let mut open: Vec<Open> = Vec::new();
    loop {
        let found = words.next();
        let keyword = found.unwrap_or_default().to_ascii_lowercase();
        match (keyword.as_str(), open.last().copied()) {
            ("root", None) => open.push(Open::Joint(joint(words, &mut joints, None)?)),
            ("joint", Some(Open::Joint(parent))) => {
                if open.len() >= MOST_DEPTH {
                    return Err(words.error(texts::bvh_too_deep(MOST_DEPTH)));
                }
                open.push(Open::Joint(joint(words, &mut joints, Some(parent))?));
            }
            ("end", Some(Open::Joint(index))) => {
                words.name()?;
                if joints.iter().map(|joint| joint.ends.len()).sum::<usize>() >= MOST_JOINTS {
                    return Err(words.error(texts::bvh_too_many_joints(MOST_JOINTS)));
                }
                joints[index].ends.push(DVec3::ZERO);
                open.push(Open::End(index));
            }
            ("offset", Some(place)) => {
                let offset = DVec3::new(words.number()?, words.number()?, words.number()?);
                match place {
                    Open::Joint(index) => joints[index].offset = offset,
                    Open::End(index) => {
                        if let Some(end) = joints[index].ends.last_mut() {
                            *end = offset;
                        }
                    }
                }
            }
            ("channels", Some(Open::Joint(index))) => channels(words, &mut joints[index].channels)?,
            ("}", Some(_)) => drop(open.pop()),
            ("motion", None) if !joints.is_empty() => return Ok(joints),
            (_, place) => {
                let expected = match place {
                    None if joints.is_empty() => "ROOT",
                    None => "ROOT / MOTION",
                    Some(Open::Joint(_)) => "OFFSET / CHANNELS / JOINT / End Site / }",
                    Some(Open::End(_)) => "OFFSET / }",
                };
                return Err(words.expected(expected, found));
            }
        }
    }
}

fn joint(words: &mut Words<'_>, joints: &mut Vec<CapturedJoint>, parent: Option<usize>) -> Result<usize, BvhError> {
    let name = words.name()?;
    if joints.len() >= MOST_JOINTS {
        return Err(words.error(texts::bvh_too_many_joints(MOST_JOINTS)));
    }
    joints.push(CapturedJoint { name, parent, offset: DVec3::ZERO, channels: Vec::new(), ends: Vec::new() });
    Ok(joints.len() - 1)
}

/// The number of channels, and their names.
fn channels(words: &mut Words<'_>, channels: &mut Vec<Channel>) -> Result<(), BvhError> {
    let word = words.next();
    let count: usize =
        word.and_then(|word| word.parse().ok()).ok_or_else(|| words.expected(texts::BVH_A_NUMBER, word))?;
    for _ in 0..count {
        let word = words.next();
        let named = |(name, _): &&(&str, Channel)| word.is_some_and(|word| word.eq_ignore_ascii_case(name));
        let Some(&(name, channel)) = Channel::NAMES.iter().find(named) else {
            let Some(word) = word else { return Err(words.expected("CHANNELS", None)) };
            return Err(words.error(texts::bvh_channel(quoted(&short(word)))));
        };
        if channels.contains(&channel) {
            return Err(words.error(texts::bvh_channel_twice(name)));
        }
        channels.push(channel);
    }
    Ok(())
}

/// The lines after `MOTION`: the number of frames, the time of one, and the frames.
fn motion(joints: Vec<CapturedJoint>, words: &Words<'_>) -> Result<Capture, BvhError> {
    let mut lines = words.rest.lines().zip(words.line..).filter(|(line, _)| !line.trim().is_empty());
    let mut last_line = words.line + words.rest.lines().count().saturating_sub(1);
    let mut header = |keyword: &'static str| {
        let (line, number) = lines.next().map_or(("", last_line), |(line, number)| (line, number));
        let value = after_keyword(line, keyword);
        let found = (!line.is_empty()).then_some(line.trim());
        value.ok_or_else(|| Words { rest: "", line: number }.expected(keyword, found)).map(|value| (value, number))
    };
    let (said, line) = header("Frames:")?;
    let not_a_number = |line, word: &str| Words { rest: "", line }.expected(texts::BVH_A_NUMBER, Some(word));
    let said_frames: usize = said.parse().map_err(|_| not_a_number(line, &said))?;
    let (said, line) = header("Frame Time:")?;
    let seconds = number(&said).ok_or_else(|| not_a_number(line, &said))?;
    let is_in_range = FRAME_SECONDS.contains(&seconds);
    if said_frames > 1 && !is_in_range {
        return Err(BvhError { line, problem: texts::bvh_frame_time(format!("{seconds}")) });
    }
    let frame_seconds = if is_in_range { seconds } else { 1.0 };
    let width: usize = joints.iter().map(|joint| joint.channels.len()).sum();
    let most_frames = MOST_NODE_POSES / joints.len();
    let too_many = |line, frames: usize| {
        let problem = texts::bvh_too_many_frames(frames, joints.len(), MOST_NODE_POSES);
        BvhError { line, problem }
    };
    let mut values = Vec::new();
    let mut frames = 0;
    for (line, number_of_line) in lines {
        last_line = number_of_line;
        let start = values.len();
        for word in line.split_whitespace() {
            values.push(number(word).ok_or_else(|| not_a_number(number_of_line, word))?);
        }
        let found = values.len() - start;
        if found != width {
            return Err(BvhError { line: number_of_line, problem: texts::bvh_frame_numbers(width, found) });
        }
        frames += 1;
        if frames > most_frames {
            return Err(too_many(number_of_line, frames));
        }
    }
    if width == 0 {
        // Frames without numbers leave no lines.
        frames = said_frames;
        if frames > most_frames {
            return Err(too_many(last_line, frames));
        }
    }
    if frames > 1 && !is_in_range {
        return Err(BvhError { line, problem: texts::bvh_frame_time(format!("{seconds}")) });
    }
    Ok(Capture { joints, frame_seconds, frames, values, said_frames })
}

/// What follows a keyword of several words, the last of which ends in a colon; `None` where the line begins otherwise.
fn after_keyword(line: &str, keyword: &str) -> Option<String> {
    let line = line.replace(':', " : ");
    let mut words = line.split_whitespace();
    for expected in keyword.trim_end_matches(':').split(' ') {
        words.next().filter(|word| word.eq_ignore_ascii_case(expected))?;
    }
    let value = words.next()?;
    let value = if value == ":" { words.next().unwrap_or_default() } else { value };
    Some(short(value))
}
