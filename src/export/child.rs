//! A program that is started and fed: it is ended, with all that it started, where it hangs or is not wanted any more.

use std::io::{self, BufRead as _, BufReader, Read, Write};
use std::process::{Child, ChildStdin, Command, ExitStatus, Stdio};
use std::sync::mpsc::{Receiver, channel};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::Duration;

use crate::unfinished::{self, Unfinished};

/// How often a program is looked at that somebody waits for.
const STEP: Duration = Duration::from_millis(20);
/// How long the end of its last words is waited for once it has ended.
const LAST_WORDS: Duration = Duration::from_secs(1);
/// Of a line of its last words so many bytes are kept.
const LONGEST_LINE: usize = 1000;

/// A running program. When this is dropped it is ended.
#[derive(Debug)]
pub struct Running {
    input: Option<ChildStdin>,
    shared: Arc<Shared>,
    said: Receiver<String>,
    _unfinished: Unfinished,
}

/// Why there is no exit status.
#[derive(Debug)]
pub enum Unended {
    /// It made no progress for as long as it may, and was ended.
    Hung,
    /// The caller did not want to wait any more. It goes on.
    Cancelled,
    /// The system cannot say.
    System(io::Error),
}

#[derive(Debug)]
struct Shared {
    child: Mutex<Child>,
    waiting: Mutex<Waiting>,
    changed: Condvar,
}

/// What the thread that watches the program goes by.
#[derive(Debug, Default)]
struct Waiting {
    /// Whether somebody waits for the program.
    is_wanted: bool,
    /// Counts what shows that the program does its work.
    progress: u64,
    is_over: bool,
    is_hung: bool,
}

fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Running {
    /// Starts a program in a process group of its own. It hangs where somebody waits for it and it makes no progress for `patience`:
    /// it takes no input, and says nothing new on its standard output.
    ///
    /// # Errors
    /// It cannot be started, or the threads that watch it cannot.
    pub fn start(command: &mut Command, patience: Duration) -> io::Result<Self> {
        #[cfg(unix)]
        std::os::unix::process::CommandExt::process_group(command, 0);
        let hold = unfinished::hold();
        let mut child = command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn()?;
        let (input, output, errors) = (child.stdin.take(), child.stdout.take(), child.stderr.take());
        let (child, waiting) = (Mutex::new(child), Mutex::new(Waiting::default()));
        let shared = Arc::new(Shared { child, waiting, changed: Condvar::new() });
        let ended = Arc::clone(&shared);
        let unfinished = hold.begin(move || ended.kill());
        let (sender, said) = channel();
        // From here on it is ended where something fails.
        let running = Self { input, shared: Arc::clone(&shared), said, _unfinished: unfinished };
        let spawn = |work: Box<dyn FnOnce() + Send>| thread::Builder::new().name("child".to_owned()).spawn(work);
        let [watched, heard] = [Arc::clone(&shared), shared];
        spawn(Box::new(move || watched.watch(patience)))?;
        spawn(Box::new(move || drop(sender.send(last_line(errors)))))?;
        spawn(Box::new(move || heard.listen(output)))?;
        Ok(running)
    }

    /// Ends its input.
    pub fn close_input(&mut self) {
        self.input = None;
    }

    /// What ends the program at any moment, from any thread.
    pub fn killer(&self) -> impl Fn() + Send + Sync + use<> {
        let shared = Arc::clone(&self.shared);
        move || shared.kill()
    }

    /// Waits for its end, and asks now and then whether to go on.
    ///
    /// # Errors
    /// [`Unended`]
    pub fn wait(&mut self, mut goes_on: impl FnMut() -> bool) -> Result<ExitStatus, Unended> {
        self.shared.wait_for_it(true);
        let ended = loop {
            match lock(&self.shared.child).try_wait() {
                Ok(Some(status)) => break Ok(status),
                Ok(None) => {}
                Err(error) => break Err(Unended::System(error)),
            }
            if !goes_on() {
                break Err(Unended::Cancelled);
            }
            thread::sleep(STEP);
        };
        self.shared.wait_for_it(false);
        if lock(&self.shared.waiting).is_hung { Err(Unended::Hung) } else { ended }
    }

    /// The last line of its standard error, once it has ended.
    pub fn last_words(&self) -> Option<String> {
        self.said.recv_timeout(LAST_WORDS).ok().filter(|line| !line.is_empty())
    }
}

impl Write for Running {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let Some(input) = &mut self.input else { return Err(io::ErrorKind::BrokenPipe.into()) };
        self.shared.wait_for_it(true);
        let written = input.write(bytes);
        self.shared.wait_for_it(false);
        written
    }

    fn flush(&mut self) -> io::Result<()> {
        self.input.as_mut().map_or(Ok(()), Write::flush)
    }
}

impl Drop for Running {
    fn drop(&mut self) {
        self.input = None;
        self.shared.kill();
        lock(&self.shared.waiting).is_over = true;
        self.shared.changed.notify_all();
        let _ = lock(&self.shared.child).wait();
    }
}

impl Shared {
    fn wait_for_it(&self, is_wanted: bool) {
        let mut waiting = lock(&self.waiting);
        waiting.is_wanted = is_wanted;
        waiting.progress += 1;
        drop(waiting);
        self.changed.notify_all();
    }

    /// Ends the program and what it started, unless it was waited for: its number may then be another's.
    fn kill(&self) {
        let mut child = lock(&self.child);
        if matches!(child.try_wait(), Ok(None)) {
            kill_group(&child);
            let _ = child.kill();
        }
    }

    fn watch(&self, patience: Duration) {
        let mut waiting = lock(&self.waiting);
        loop {
            let is_idle = |waiting: &mut Waiting| !waiting.is_wanted && !waiting.is_over;
            waiting = self.changed.wait_while(waiting, is_idle).unwrap_or_else(PoisonError::into_inner);
            let before = waiting.progress;
            let is_same = |waiting: &mut Waiting| waiting.progress == before && !waiting.is_over;
            let slept = self.changed.wait_timeout_while(waiting, patience, is_same);
            let (now, timeout) = slept.unwrap_or_else(PoisonError::into_inner);
            waiting = now;
            if waiting.is_over {
                return;
            }
            if timeout.timed_out() {
                waiting.is_hung = true;
                drop(waiting);
                self.kill();
                return;
            }
        }
    }

    /// Takes a new line of standard output for progress.
    fn listen(&self, output: Option<impl Read>) {
        let Some(output) = output else { return };
        let mut last = Vec::new();
        for line in BufReader::new(output).split(b'\n').map_while(Result::ok) {
            if line.starts_with(b"frame=") && line != last {
                last = line;
                lock(&self.waiting).progress += 1;
                self.changed.notify_all();
            }
        }
    }
}

#[cfg(unix)]
fn kill_group(child: &Child) {
    let group = rustix::process::Pid::from_child(child);
    let _ = rustix::process::kill_process_group(group, rustix::process::Signal::KILL);
}

#[cfg(not(unix))]
fn kill_group(_: &Child) {}

/// The last line that is not empty, of a stream that is read to its end.
fn last_line(stream: Option<impl Read>) -> String {
    let Some(stream) = stream else { return String::new() };
    let (mut last, mut line) = (Vec::new(), Vec::new());
    for byte in BufReader::new(stream).bytes().map_while(Result::ok) {
        if matches!(byte, b'\n' | b'\r') {
            if !line.trim_ascii().is_empty() {
                last = std::mem::take(&mut line);
            }
            line.clear();
        } else if line.len() < LONGEST_LINE {
            line.push(byte);
        }
    }
    let last = if line.trim_ascii().is_empty() { last } else { line };
    String::from_utf8_lossy(last.trim_ascii()).into_owned()
}
