//! Mutants: an original with up to four changes.

/// A random number generator (SplitMix64), the same everywhere.
pub struct Random(u64);

impl Random {
    /// The numbers of neighbouring seeds have nothing in common.
    pub fn new(seed: u64) -> Self {
        Self(mixed(seed.wrapping_add(0x632b_e59b_d9b4_e019)))
    }

    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        mixed(self.0)
    }

    /// A number below another, which is above 0.
    pub fn below(&mut self, end: usize) -> usize {
        usize::try_from(self.next() % end as u64).expect("it is below a usize")
    }

    pub fn one_of<'a, T>(&mut self, all: &'a [T]) -> &'a T {
        &all[self.below(all.len())]
    }
}

fn mixed(mut bits: u64) -> u64 {
    bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    bits ^ (bits >> 31)
}

/// Numbers at and beyond the ends of what is read.
const NUMBERS: [&str; 26] = [
    "0",
    "-0",
    "-1",
    "1e308",
    "-1e308",
    "1e999",
    "1e39",
    "1e-320",
    "nan",
    "-nan(ind)",
    "1.#QNAN",
    "inf",
    "NaN",
    "Infinity",
    "0.1e",
    "2147483648",
    "4294967296",
    "9007199254740993",
    "18446744073709551615",
    "18446744073709551616",
    "99999999999999999999999",
    "1e6",
    "1000000.1",
    "0x10",
    "01",
    "1_000",
];

/// Pieces of all the languages that are read.
const PIECES: [&str; 44] = [
    "{",
    "}",
    "[",
    "]",
    "\"",
    ",",
    ":",
    "null",
    "true",
    "\\u0000",
    "\\ud800",
    "\\",
    "\n",
    "\r\n",
    "\r",
    "\t",
    "#",
    ";",
    "=",
    "-",
    "(",
    ")",
    "vec(",
    "quaternion_from_euler(",
    "frame [0]",
    "frame [",
    "end",
    "\u{feff}",
    "\u{e9}",
    "\u{1b}[31m",
    "\u{202e}",
    "key_time",
    "wait 1e300s",
    "key w",
    "key t",
    "imported \"a\" ",
    "undo",
    "[points]",
    "\"\"\"",
    "'''",
    "\n# fault\n",
    "../",
    "..",
    "\u{0}",
];

/// What nests.
const NESTS: [(&str, &str); 5] = [("[", "]"), ("{\"a\":", "}"), ("{\"children\":[", "]}"), ("(", ")"), ("[[", "]]")];

/// A mutant of one of these, perhaps with a part of another.
pub fn mutant(originals: &[Vec<u8>], random: &mut Random) -> Vec<u8> {
    let mut mutant = random.one_of(originals).clone();
    for _ in 0..=random.below(4) {
        change(&mut mutant, originals, random);
    }
    mutant
}

fn change(text: &mut Vec<u8>, originals: &[Vec<u8>], random: &mut Random) {
    let at = random.below(text.len() + 1);
    let end = |random: &mut Random| (at + random.below(200)).min(text.len());
    match random.below(13) {
        0 => {
            if let Some(byte) = text.get_mut(at) {
                *byte ^= 1 << random.below(8);
            }
        }
        1 => {
            if let Some(byte) = text.get_mut(at) {
                *byte = *random.one_of(b"\x00\xff\x800123456789 \t\n\r,;.+-eE[](){}:=#\"\\");
            }
        }
        2 => insert(text, at, random.one_of(&PIECES).as_bytes()),
        3 => {
            let end = end(random);
            drop(text.drain(at..end));
        }
        4 => {
            let end = end(random);
            let again = text[at..end].to_vec();
            insert(text, at, &again);
        }
        5 => text.truncate(at),
        6 | 7 => {
            // A number becomes another.
            let number = random.one_of(&NUMBERS).as_bytes();
            let (start, end) = token(text, at, |byte| byte.is_ascii_digit() || b"+-.eE".contains(&byte));
            drop(text.splice(start..end, number.iter().copied()));
        }
        8 => {
            // A token goes, or is there twice.
            let (start, end) = token(text, at, |byte| byte.is_ascii_alphanumeric() || b"_-\"".contains(&byte));
            let word = text[start..end].to_vec();
            if random.below(2) == 0 {
                drop(text.drain(start..end));
            } else {
                insert(text, end, &word);
            }
        }
        9 => {
            // A line goes, is there twice, or comes at another place.
            let (start, end) = token(text, at, |byte| byte != b'\n');
            let line = [&text[start..end], b"\n"].concat();
            match random.below(3) {
                0 => drop(text.drain(start..end)),
                1 => insert(text, start, &line),
                _ => {
                    let (other, _) = token(text, random.below(text.len() + 1), |byte| byte != b'\n');
                    insert(text, other, &line);
                }
            }
        }
        10 => {
            let (open, close) = random.one_of(&NESTS);
            let depth = *random.one_of(&[1, 3, 120, 130, 300, 3000]);
            let closes = if random.below(2) == 0 { depth } else { 0 };
            insert(text, at, (open.repeat(depth) + &close.repeat(closes)).as_bytes());
        }
        11 => {
            // The start of one and the end of another.
            let other = random.one_of(originals);
            let from = random.below(other.len() + 1);
            text.truncate(at);
            text.extend_from_slice(&other[from..]);
        }
        _ => {
            // A long run of one piece.
            let piece = random.one_of(&PIECES).repeat(*random.one_of(&[10, 1000, 20_000]));
            insert(text, at, piece.as_bytes());
        }
    }
}

fn insert(text: &mut Vec<u8>, at: usize, bytes: &[u8]) {
    drop(text.splice(at..at, bytes.iter().copied()));
}

/// Where the bytes that belong together begin and end around a place.
fn token(text: &[u8], at: usize, belongs: impl Fn(u8) -> bool) -> (usize, usize) {
    let start = text[..at].iter().rposition(|&byte| !belongs(byte)).map_or(0, |before| before + 1);
    let end = text[at..].iter().position(|&byte| !belongs(byte)).map_or(text.len(), |after| at + after);
    (start, end)
}
