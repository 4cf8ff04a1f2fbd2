//! What the program and its libraries log: to standard error, a line each. `RUST_LOG` says how much: a level (`off`, `error`, `warn`,
//! `info`, `debug`, `trace`), or parts as in `inbetween=debug,wgpu=warn`, of which the longest that fits counts. Without it, errors of
//! this program are logged.

use std::io::Write as _;

use log::{LevelFilter, Log, Metadata, Record};

/// Starts logging. A logger that is there already, in a test, serves as well.
pub fn start() {
    let wanted = std::env::var("RUST_LOG").unwrap_or_else(|_| "inbetween=error".to_owned());
    let logger = Logger::new(&wanted);
    log::set_max_level(logger.most());
    let _ = log::set_boxed_logger(Box::new(logger));
}

/// Levels by the beginnings of modules' paths.
struct Logger(Vec<(String, LevelFilter)>);

impl Logger {
    /// What does not read as a level or as `PATH=LEVEL` is a path, of which everything is logged.
    fn new(wanted: &str) -> Self {
        let part = |part: &str| match part.split_once('=') {
            Some((path, level)) => (path.trim().to_owned(), level.trim().parse().unwrap_or(LevelFilter::Trace)),
            None => match part.trim().parse() {
                Ok(level) => (String::new(), level),
                Err(_) => (part.trim().to_owned(), LevelFilter::Trace),
            },
        };
        Self(wanted.split(',').filter(|part| !part.trim().is_empty()).map(part).collect())
    }

    fn most(&self) -> LevelFilter {
        self.0.iter().map(|(_, level)| *level).max().unwrap_or(LevelFilter::Off)
    }

    fn level_of(&self, target: &str) -> LevelFilter {
        let fits = |path: &str| {
            target.strip_prefix(path).is_some_and(|rest| path.is_empty() || rest.is_empty() || rest.starts_with("::"))
        };
        let fitting = self.0.iter().filter(|(path, _)| fits(path));
        fitting.max_by_key(|(path, _)| path.len()).map_or(LevelFilter::Off, |(_, level)| *level)
    }
}

impl Log for Logger {
    fn enabled(&self, metadata: &Metadata<'_>) -> bool {
        metadata.level() <= self.level_of(metadata.target())
    }

    fn log(&self, record: &Record<'_>) {
        if self.enabled(record.metadata()) {
            // Where standard error is closed nobody listens.
            let _ = writeln!(std::io::stderr(), "[{} {}] {}", record.level(), record.target(), record.args());
        }
    }

    fn flush(&self) {}
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_longest_path_that_fits_counts() {
        #[track_caller]
        fn check(wanted: &str, target: &str, expected: LevelFilter) {
            assert_eq!(Logger::new(wanted).level_of(target), expected, "{target} by {wanted:?}");
        }
        check("inbetween=error", "inbetween::window", LevelFilter::Error);
        check("inbetween=error", "inbetweener", LevelFilter::Off);
        check("inbetween=error", "wgpu_core", LevelFilter::Off);
        check("debug", "wgpu_core", LevelFilter::Debug);
        check("warn, inbetween=trace", "inbetween", LevelFilter::Trace);
        check("warn,inbetween::window=off,inbetween=info", "inbetween::window::shell", LevelFilter::Off);
        check("inbetween", "inbetween::cli", LevelFilter::Trace);
        check("", "inbetween", LevelFilter::Off);
        assert_eq!(Logger::new("warn,inbetween=info").most(), LevelFilter::Info);
    }
}
