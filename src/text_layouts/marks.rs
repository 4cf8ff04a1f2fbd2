//! What stands between rows and keyframes, and the blocks of numbers between it.

use super::structure::Irregular;

/// The most numbers of a header.
pub(super) const MOST_HEADER: usize = 6;

/// The longest line of names in bytes.
const LONGEST_NAMES: usize = 400;

/// The kinds of marks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum MarkKind {
    /// A word such as `frame` or `keyframe`, before a keyframe.
    Frame,
    /// The word `end`, after a keyframe or after all.
    End,
    /// Anything else, between rows or keyframes.
    Other,
}

impl MarkKind {
    /// The kind of a mark's text.
    pub(super) fn of(text: &[u8]) -> Self {
        if names(text).is_some() {
            return Self::Other;
        }
        let begin = text.iter().position(u8::is_ascii_alphabetic).unwrap_or(text.len());
        let word = text[begin..].to_ascii_lowercase();
        if ["frame", "keyframe", "key frame", "key_frame"].iter().any(|name| word.starts_with(name.as_bytes())) {
            Self::Frame
        } else if begin == 0
            && word.strip_prefix(b"end").is_some_and(|rest| !rest.iter().any(u8::is_ascii_alphanumeric))
        {
            Self::End
        } else {
            Self::Other
        }
    }
}

/// The names of a table's columns, if a line has at least one for each number of a row.
pub(super) fn names(line: &[u8]) -> Option<Vec<String>> {
    let line = std::str::from_utf8(line).ok().filter(|line| line.len() <= LONGEST_NAMES)?;
    let is_blank = |c: char| c.is_whitespace() || matches!(c, '"' | '\'' | '|');
    let by_comma: Vec<&str> = line.trim_end_matches([',', ';', ' ']).split([',', ';', '\t']).collect();
    let by_bar: Vec<&str> = line.trim().trim_matches('|').split('|').collect();
    let parts = match (by_comma.len(), by_bar.len()) {
        (2.., _) => by_comma,
        (_, 2..) => by_bar,
        _ => line.split_whitespace().collect(),
    };
    let names: Vec<String> = parts.iter().map(|name| name.trim_matches(is_blank).to_lowercase()).collect();
    let are_names =
        names.iter().all(|name| !name.starts_with(|c: char| c.is_ascii_digit() || matches!(c, '-' | '+' | '.')));
    let has_letters = names.iter().filter(|name| name.contains(char::is_alphabetic)).count() >= 7;
    (are_names && has_letters).then_some(names)
}

/// The number of a mark such as `frame [3]` or `Keyframe 3:`, if it has one.
fn number(text: &[u8]) -> Option<u64> {
    let begin = text.iter().position(u8::is_ascii_digit)?;
    let digits: Vec<u8> = text[begin..].iter().copied().take_while(u8::is_ascii_digit).collect();
    std::str::from_utf8(&digits).ok()?.parse().ok()
}

/// Marks that may delimit keyframes, and the numbers between them.
#[derive(Debug, Default)]
pub(super) struct Marks {
    /// The number of marks.
    pub(super) count: usize,
    /// The number of marks that stand after a keyframe: `end`.
    pub(super) ends: usize,
    /// The number of numbers before the first mark, if they are a header.
    pub(super) lead: usize,
    /// The number of blocks of numbers.
    pub(super) blocks: usize,
    /// The lengths of the first two blocks in numbers.
    pub(super) first_blocks: [usize; 2],
    /// The byte offsets of the first two blocks.
    pub(super) first_blocks_at: [usize; 2],
    /// The first block, from the third on, whose length differs from the second's.
    pub(super) irregular: Option<Irregular>,
    /// The first mark out of sequence: the number found and the number expected.
    pub(super) out_of_turn: Option<(u64, u64)>,
    /// The bytes of the first mark.
    pub(super) first: [usize; 2],
    next_number: Option<u64>,
    in_block: usize,
    block_at: usize,
    is_open: bool,
}

impl Marks {
    /// Takes in a number of a row.
    pub(super) fn number(&mut self, at: usize) {
        if self.in_block == 0 && !self.is_open {
            self.block_at = at;
        }
        self.in_block += 1;
    }

    /// Takes in a mark.
    pub(super) fn mark(&mut self, at: usize, text: &[u8]) {
        let kind = MarkKind::of(text);
        let is_header = kind != MarkKind::End && (1..=MOST_HEADER).contains(&self.in_block);
        if self.count == 0 {
            self.first = [at, at + text.len()];
        }
        if is_header && self.blocks == 0 && self.lead == 0 && !self.is_open {
            self.lead = std::mem::take(&mut self.in_block);
        } else if self.is_open || self.in_block > 0 {
            self.close();
        }
        self.count += 1;
        match kind {
            MarkKind::Frame => {
                let number = number(text);
                self.turn(number);
                // A number promises a keyframe.
                self.is_open = number.is_some();
                self.block_at = at;
            }
            MarkKind::End => self.ends += 1,
            MarkKind::Other => {}
        }
    }

    /// Takes in the end of the text.
    pub(super) fn finish(&mut self) {
        if self.in_block > 0 || self.is_open {
            self.close();
        }
    }

    fn close(&mut self) {
        let (found, at, index) = (self.in_block, self.block_at, self.blocks);
        if let Some(first) = self.first_blocks.get_mut(index) {
            *first = found;
            self.first_blocks_at[index] = at;
        } else if found != self.first_blocks[1] && self.irregular.is_none() {
            self.irregular = Some(Irregular { at, index, found, expected: self.first_blocks[1] });
        }
        self.blocks += 1;
        self.in_block = 0;
        self.is_open = false;
    }

    fn turn(&mut self, number: Option<u64>) {
        let Some(number) = number else {
            self.next_number = self.next_number.map(|number| number.saturating_add(1));
            return;
        };
        // The first may be 0 or 1.
        let expected = self.next_number.unwrap_or(number.min(1));
        if number != expected && self.out_of_turn.is_none() {
            self.out_of_turn = Some((number, expected));
        }
        self.next_number = Some(number.saturating_add(1));
    }

    /// Whether the marks delimit keyframes. A single `end` may also close the file, and words may name what follows.
    pub(super) fn divide(&self) -> bool {
        self.next_number.is_some() || self.blocks > 1
    }
}
