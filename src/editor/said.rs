//! The most recent messages, numbered, so that a reader can ask for those that are new to it.

use std::collections::VecDeque;

use super::Message;

/// How many messages are kept for readers that come late.
const MOST: usize = 64;

/// The last messages, of which each has a number from 0.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Said {
    count: u64,
    last: VecDeque<Message>,
}

impl Said {
    pub(super) fn push(&mut self, message: Message) {
        if self.last.len() == MOST {
            self.last.pop_front();
        }
        self.last.push_back(message);
        self.count += 1;
    }

    /// How many were said in all.
    #[must_use]
    pub const fn count(&self) -> u64 {
        self.count
    }

    /// Those after the first `seen`, in order, as far as they are kept.
    pub fn after(&self, seen: u64) -> impl Iterator<Item = &Message> {
        let new = usize::try_from(self.count.saturating_sub(seen)).unwrap_or(usize::MAX);
        self.last.iter().skip(self.last.len().saturating_sub(new))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::words::texts;

    #[test]
    fn a_reader_sees_what_is_new_to_it() {
        let mut said = Said::default();
        for count in 0..100 {
            said.push(texts::foreign(count.to_string()));
        }
        let new: Vec<String> = said.after(97).map(Message::to_string).collect();
        assert_eq!(new, ["97", "98", "99"]);
        assert_eq!(said.after(100).count(), 0);
        assert_eq!(said.after(0).count(), MOST);
    }
}
