//! A place in JSON text that moves on over what is expected there. `None` says that something else is there.

/// Powers of ten that double precision holds exactly.
const POWERS_OF_TEN: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20,
    1e21, 1e22,
];
/// Whole numbers up to this one are exact in double precision.
const LARGEST_WHOLE: u64 = 1 << 53;
/// So many digits fit into 64 bits whatever they are.
const MOST_DIGITS: usize = 19;
/// Exponents of more digits are left to the exact reader.
const MOST_EXPONENT_DIGITS: usize = 4;

/// A place in a text.
#[derive(Clone, Copy)]
pub struct Cursor<'a> {
    bytes: &'a [u8],
    at: usize,
}

impl<'a> Cursor<'a> {
    /// The place `at` of a text.
    pub const fn new(bytes: &'a [u8], at: usize) -> Self {
        Self { bytes, at }
    }

    /// How many bytes it has passed.
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

    /// Passes white space.
    #[inline]
    pub fn pass_space(&mut self) {
        while let Some(b' ' | b'\n' | b'\t' | b'\r') = self.bytes.get(self.at) {
            self.at += 1;
        }
    }

    /// Passes white space and one byte, which must be this one.
    #[inline]
    pub fn pass(&mut self, byte: u8) -> Option<()> {
        self.pass_space();
        (self.next()? == byte).then_some(())
    }

    /// Passes white space and a text, if it is the one that comes, and says whether it did.
    #[inline]
    pub fn passes<const N: usize>(&mut self, text: &[u8; N]) -> bool {
        self.pass_space();
        let is_next = self.bytes[self.at..].first_chunk() == Some(text);
        self.at += if is_next { N } else { 0 };
        is_next
    }

    /// From the start of an object to just behind the `[` of one of its members, whose name comes with its quotation marks. What is
    /// passed over need not be JSON.
    pub fn pass_to_array(&mut self, quoted_name: &[u8]) -> Option<()> {
        self.pass(b'{')?;
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
                    if depth == 0 && &self.bytes[start..self.at] == quoted_name && self.passes(b":") {
                        return self.pass(b'[');
                    }
                }
                b'{' | b'[' => depth += 1,
                b'}' | b']' => depth = depth.checked_sub(1)?,
                _ => {}
            }
        }
    }

    /// Passes an array of `N` numbers.
    #[inline]
    pub fn pass_numbers<const N: usize>(&mut self) -> Option<[f32; N]> {
        self.pass(b'[')?;
        let mut numbers = [0.0; N];
        for (index, number) in numbers.iter_mut().enumerate() {
            if index > 0 {
                self.pass(b',')?;
            }
            self.pass_space();
            *number = self.pass_number()?;
        }
        self.pass(b']')?;
        Some(numbers)
    }

    /// Passes digits and appends them to a number, which is right up to [`MOST_DIGITS`]; says how many there were.
    #[inline]
    fn pass_digits(&mut self, number: &mut u64) -> usize {
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

    /// Passes a number and gives the nearest one of single precision; `None` also where that is beyond the largest.
    #[inline]
    pub fn pass_number(&mut self) -> Option<f32> {
        let start = self.at;
        let is_negative = self.bytes.get(start) == Some(&b'-');
        self.at += usize::from(is_negative);
        let first = self.at;
        let mut digits = 0;
        let whole = self.pass_digits(&mut digits);
        if whole == 0 || (whole > 1 && self.bytes[first] == b'0') {
            return None;
        }
        let mut decimals = 0;
        if self.bytes.get(self.at) == Some(&b'.') {
            self.at += 1;
            decimals = self.pass_digits(&mut digits);
            if decimals == 0 {
                return None;
            }
        }
        let mut power = -(decimals as i64);
        if let Some(b'e' | b'E') = self.bytes.get(self.at) {
            power += self.pass_exponent()?;
        }
        let is_exact = whole + decimals <= MOST_DIGITS && digits <= LARGEST_WHOLE;
        if is_exact && let Some(number) = to_single(digits, power) {
            return Some(if is_negative { -number } else { number });
        }
        let text = std::str::from_utf8(&self.bytes[start..self.at]).ok()?;
        text.parse().ok().filter(|number: &f32| number.is_finite())
    }

    fn pass_exponent(&mut self) -> Option<i64> {
        self.at += 1;
        let sign = self.bytes.get(self.at);
        let is_negative = sign == Some(&b'-');
        self.at += usize::from(is_negative || sign == Some(&b'+'));
        let mut exponent = 0;
        let count = self.pass_digits(&mut exponent);
        let exponent = exponent as i64;
        (1..=MOST_EXPONENT_DIGITS).contains(&count).then_some(if is_negative { -exponent } else { exponent })
    }
}

/// The number of single precision that is nearest to `digits · 10^power`, where one rounding in double precision tells it.
#[inline]
fn to_single(digits: u64, power: i64) -> Option<f32> {
    /// What single precision has no place for, and the half of its last place.
    const DROPPED: u64 = (1 << 29) - 1;
    const HALF: u64 = 1 << 28;
    let scale = *POWERS_OF_TEN.get(usize::try_from(power.unsigned_abs()).ok()?)?;
    // Both are exact, so that this is rounded once, and the next rounding goes the right way unless it starts from just half a place.
    let double = if power < 0 { digits as f64 / scale } else { digits as f64 * scale };
    let is_plain = double == 0.0 || (f64::from(f32::MIN_POSITIVE)..f64::from(f32::MAX)).contains(&double);
    (is_plain && double.to_bits() & DROPPED != HALF).then_some(double as f32)
}
