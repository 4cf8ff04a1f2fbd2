//! Journals: what was done, written down before it is done, so that no ending of the program loses it.
//!
//! A journal is a script. Comments at its head say what it belongs to; its first lines restore what the editor was at first, the others
//! are the commands, in order. What was read from files stands in it; what was written is a comment. So playing it makes the same
//! document again, and touches no file.
//!
//! [`Writer`] writes one, [`survey`] says what one holds, [`play`] does what it says, and [`left`] finds those that programs left which
//! did not end as their users wanted. [`Journaled`] keeps one for a host without a window.

mod folder;
mod journaled;
mod mark;
mod nowhere;
mod play;
mod start;
mod writer;

pub use folder::{ENDING, LARGEST_READ_BYTES, Left, left, tidy_up};
pub use journaled::Journaled;
pub use mark::{Survey, is_journal, survey};
pub use play::{Played, fingerprint, play, play_alone, play_alone_observed, recover};
pub use writer::{Ending, LARGEST_JOURNAL_BYTES, MOST_LINES, Writer};
