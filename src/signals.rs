//! Signals that ask the program to end: Ctrl+C, the end of the session, a closed terminal.

use std::io::{IsTerminal as _, Write};
use std::sync::mpsc::channel;
use std::thread;
use std::time::Duration;

#[cfg(unix)]
use crate::storage;
use crate::text::visible;
use crate::unfinished;

/// The number of the signal of Ctrl+C.
pub const INTERRUPT: i32 = 2;

/// Calls `on` with the number of each signal that asks for the end, on a thread of its own; with the sentence that it returns, the
/// program ends at once, as [`end`] has it. Signals that whoever started the program has it ignore (`nohup`) stay ignored. Where no
/// thread can be started, signals end the program as the system has it.
#[cfg(unix)]
pub fn listen(mut on: impl FnMut(i32) -> Option<String> + Send + 'static) {
    use signal_hook::consts::{SIGHUP, SIGINT, SIGTERM};

    // Drivers may have standard error redirected meanwhile.
    let errors = storage::standard_error();
    let (is_ready, ready) = channel();
    let thread = thread::Builder::new().name("signals".to_owned()).spawn(move || {
        let ignored = ignored();
        let heard = [SIGTERM, SIGHUP, SIGINT].into_iter().filter(|signal| ignored >> (signal - 1) & 1 == 0);
        let Ok(mut signals) = signal_hook::iterator::Signals::new(heard) else { return };
        let _ = is_ready.send(());
        let end = signals.forever().find_map(|signal| Some((signal, on(signal)?)));
        if let Some((signal, sentence)) = end {
            end_saying(128 + signal, &sentence, errors);
        }
    });
    if thread.is_ok() {
        // From here on nothing is left behind. Where nothing could be heard, the sender is gone.
        let _ = ready.recv();
    }
}

/// The signals that this process ignores, as a set of bits.
#[cfg(unix)]
fn ignored() -> u64 {
    /// More than it ever holds.
    const LARGEST_STATUS_BYTES: u64 = 1 << 16;
    let status = storage::read(std::path::Path::new("/proc/self/status"), LARGEST_STATUS_BYTES);
    let text = String::from_utf8(status.unwrap_or_default()).unwrap_or_default();
    let digits = text.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    digits.and_then(|digits| u64::from_str_radix(digits.trim(), 16).ok()).unwrap_or_default()
}

/// Calls `on` at each Ctrl+C, on a thread of its own.
#[cfg(not(unix))]
pub fn listen(mut on: impl FnMut(i32) -> Option<String> + Send + 'static) {
    // Where it cannot be heard, it ends the program as the system has it.
    let _ = ctrlc::set_handler(move || {
        if let Some(sentence) = on(INTERRUPT) {
            end(128 + INTERRUPT, &sentence);
        }
    });
}

/// Ends the program at once with an exit status, whatever its threads do: clears away what is unfinished, and says a sentence on standard
/// error. After a signal, shells have 128 and its number for a status.
pub fn end(status: i32, sentence: &str) -> ! {
    end_saying(status, sentence, Box::new(std::io::stderr()))
}

fn end_saying(status: i32, sentence: &str, mut errors: Box<dyn Write + Send>) -> ! {
    /// How long a reader of standard error may take.
    const PATIENCE: Duration = Duration::from_secs(1);

    unfinished::clear_all();
    let text = line(sentence);
    let bytes = text.clone();
    let (is_said, said) = channel();
    let thread = thread::Builder::new().name("last words".to_owned()).spawn(move || {
        let _ = errors.write_all(bytes.as_bytes());
        let _ = is_said.send(());
    });
    if thread.is_ok() {
        let _ = said.recv_timeout(PATIENCE);
    } else {
        let _ = std::io::stderr().write_all(text.as_bytes());
    }
    leave(status)
}

/// As [`end`], in a destructor that runs while the process exits already: no thread can be started there.
pub fn end_within_exit(status: i32, sentence: &str) -> ! {
    unfinished::clear_all();
    let _ = std::io::stderr().write_all(line(sentence).as_bytes());
    leave(status)
}

fn line(sentence: &str) -> String {
    // A line of progress is erased.
    let erase = if std::io::stderr().is_terminal() { "\r\u{1b}[K" } else { "" };
    format!("{erase}{}\n", visible(sentence))
}

/// Ends the process without the clean-up of libraries, which may wait for a thread that hangs.
fn leave(status: i32) -> ! {
    #[cfg(unix)]
    signal_hook::low_level::exit(status);
    #[cfg(not(unix))]
    std::process::exit(status)
}
