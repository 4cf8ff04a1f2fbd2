//! What rounding decides: every way in which a computation may go.

/// The most choices in one computation; later ones go the first way.
const MOST: usize = 12;

/// A run through every combination of the choices that a computation meets.
///
/// A computation asks [`Choices::pick`] wherever rounding decides. It is repeated while [`Choices::next`] finds another way.
#[derive(Debug, Default)]
pub(super) struct Choices {
    ways: [bool; MOST],
    known: usize,
    asked: usize,
}

impl Choices {
    /// The way at the next choice: `false` at first.
    pub fn pick(&mut self) -> bool {
        if self.asked == MOST {
            return false;
        }
        if self.asked == self.known {
            self.ways[self.known] = false;
            self.known += 1;
        }
        self.asked += 1;
        self.ways[self.asked - 1]
    }

    /// Turns to the next combination, the last choice first; false if there is none left.
    pub fn next(&mut self) -> bool {
        self.known = self.asked;
        self.asked = 0;
        while self.known > 0 {
            if !self.ways[self.known - 1] {
                self.ways[self.known - 1] = true;
                return true;
            }
            self.known -= 1;
        }
        false
    }
}

#[cfg(test)]
mod tests {
    use super::Choices;

    #[test]
    fn every_combination_comes_once() {
        let mut choices = Choices::default();
        let mut found = Vec::new();
        loop {
            // The second choice is met on one way of the first only.
            let first = choices.pick();
            let second = first.then(|| choices.pick());
            found.push((first, second, choices.pick()));
            if !choices.next() {
                break;
            }
        }
        assert_eq!(
            found,
            [
                (false, None, false),
                (false, None, true),
                (true, Some(false), false),
                (true, Some(false), true),
                (true, Some(true), false),
                (true, Some(true), true),
            ]
        );
    }
}
