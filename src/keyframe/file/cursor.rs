//! A position in JSON text that advances over expected tokens. `None` means that another token was found.

/// Powers of ten that double precision holds exactly.
const POWERS_OF_TEN: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20,
    1e21, 1e22,
];
/// Whole numbers up to this one are exact in double precision.
const LARGEST_WHOLE: u64 = 1 << 53;
/// Any number with this many decimal digits fits into 64 bits.
const MOST_DIGITS: usize = 19;
/// Exponents with more digits are left to the strict reader.
const MOST_EXPONENT_DIGITS: usize = 4;

/// A position in a text.
#[derive(Clone, Copy)]
pub struct Cursor<'a> {
    bytes: &'a [u8],
    at: usize,
}

impl<'a> Cursor<'a> {
    /// A cursor at the byte offset `at`.
    pub const fn new(bytes: &'a [u8], at: usize) -> Self {
        Self { bytes, at }
    }

    /// The byte offset.
    pub const fn at(&self) -> usize {
        self.at
    }

    /// Whether nothing is left.
    pub const fn is_at_end(&self) -> bool {
        self.at >= self.bytes.len()
    }

    #[inline]
    fn next(&mut self) -> Option<u8> {
        let byte = *self.bytes.get(self.at)?;
        self.at += 1;
        Some(byte)
    }

    /// Skips white space.
    #[inline]
    pub fn skip_space(&mut self) {
        while let Some(b' ' | b'\n' | b'\t' | b'\r') = self.bytes.get(self.at) {
            self.at += 1;
        }
    }

    /// Skips white space and one byte, which must be this one.
    #[inline]
    pub fn expect(&mut self, byte: u8) -> Option<()> {
        self.skip_space();
        (self.next()? == byte).then_some(())
    }

    /// Skips white space and `text` if it comes next. Returns whether it did.
    #[inline]
    pub fn try_consume<const N: usize>(&mut self, text: &[u8; N]) -> bool {
        self.skip_space();
        let is_next = self.bytes[self.at..].first_chunk() == Some(text);
        self.at += if is_next { N } else { 0 };
        is_next
    }

    /// Moves from the start of an object to just after the `[` of the member `name`, which includes its quotation marks. The skipped text
    /// is not checked to be JSON.
    pub fn skip_to_array(&mut self, quoted_name: &[u8]) -> Option<()> {
        self.expect(b'{')?;
        let mut depth = 0_usize;
        loop {
            match self.next()? {
                b'"' => {
                    let start = self.at - 1;
                    while match self.next()? {
                        b'"' => false,
                        b'\\' => self.next().is_some(),
                        _ => true,
                    } {}
                    if depth == 0 && &self.bytes[start..self.at] == quoted_name && self.try_consume(b":") {
                        return self.expect(b'[');
                    }
                }
                b'{' | b'[' => depth += 1,
                b'}' | b']' => depth = depth.checked_sub(1)?,
                _ => {}
            }
        }
    }

    /// Reads an array of `N` numbers.
    #[inline]
    pub fn read_numbers<const N: usize>(&mut self) -> Option<[f32; N]> {
        self.expect(b'[')?;
        let mut numbers = [0.0; N];
        for (index, number) in numbers.iter_mut().enumerate() {
            if index > 0 {
                self.expect(b',')?;
            }
            self.skip_space();
            *number = self.read_number()?;
        }
        self.expect(b']')?;
        Some(numbers)
    }

    /// Reads digits and appends them to a number, which is correct up to [`MOST_DIGITS`] digits. Returns how many there were.
    #[inline]
    fn read_digits(&mut self, number: &mut u64) -> usize {
        let start = self.at;
        while let Some(&byte) = self.bytes.get(self.at) {
            let digit = byte.wrapping_sub(b'0');
            if digit > 9 {
                break;
            }
            *number = number.wrapping_mul(10).wrapping_add(u64::from(digit));
            self.at += 1;
        }
        self.at - start
    }

    /// Reads a number and rounds it to single precision. `None` also if it is beyond the largest.
    #[inline]
    pub fn read_number(&mut self) -> Option<f32> {
        let start = self.at;
        let is_negative = self.bytes.get(start) == Some(&b'-');
        self.at += usize::from(is_negative);
        let first = self.at;
        let mut digits = 0;
        let whole = self.read_digits(&mut digits);
        if whole == 0 || (whole > 1 && self.bytes[first] == b'0') {
            return None;
        }
        let mut decimals = 0;
        if self.bytes.get(self.at) == Some(&b'.') {
            self.at += 1;
            decimals = self.read_digits(&mut digits);
            if decimals == 0 {
                return None;
            }
        }
        let mut power = -(decimals as i64);
        if let Some(b'e' | b'E') = self.bytes.get(self.at) {
            power += self.read_exponent()?;
        }
        let is_exact = whole + decimals <= MOST_DIGITS && digits <= LARGEST_WHOLE;
        if is_exact && let Some(number) = to_single(digits, power) {
            return Some(if is_negative { -number } else { number });
        }
        let text = std::str::from_utf8(&self.bytes[start..self.at]).ok()?;
        text.parse().ok().filter(|number: &f32| number.is_finite())
    }

    fn read_exponent(&mut self) -> Option<i64> {
        self.at += 1;
        let sign = self.bytes.get(self.at);
        let is_negative = sign == Some(&b'-');
        self.at += usize::from(is_negative || sign == Some(&b'+'));
        let mut exponent = 0;
        let count = self.read_digits(&mut exponent);
        let exponent = exponent as i64;
        (1..=MOST_EXPONENT_DIGITS).contains(&count).then_some(if is_negative { -exponent } else { exponent })
    }
}

/// `digits · 10^power` rounded to single precision; `None` if one rounding in double precision does not decide it.
#[inline]
fn to_single(digits: u64, power: i64) -> Option<f32> {
    /// The bits of a double that single precision drops, and half a unit in its last place.
    const DROPPED: u64 = (1 << 29) - 1;
    const HALF: u64 = 1 << 28;
    let scale = *POWERS_OF_TEN.get(usize::try_from(power.unsigned_abs()).ok()?)?;
    // Both operands are exact, so this rounds once. The rounding to single precision is then correct unless the double lies exactly
    // half-way.
    let double = if power < 0 { digits as f64 / scale } else { digits as f64 * scale };
    let is_plain = double == 0.0 || (f64::from(f32::MIN_POSITIVE)..f64::from(f32::MAX)).contains(&double);
    (is_plain && double.to_bits() & DROPPED != HALF).then_some(double as f32)
}
