//! Runs in turn, and lines of results.

use std::time::{Duration, Instant};

/// Which goals were met.
#[derive(Default)]
pub struct Report {
    /// The goal that is being measured.
    pub goal: usize,
    missed: usize,
}

impl Report {
    /// Whether no goal was missed.
    pub fn is_met(&self) -> bool {
        self.missed == 0
    }

    /// How many times as fast `ours` is as `theirs`, which is to be `least` or more.
    pub fn at_least(&mut self, what: &str, ours: Duration, theirs: Duration, least: f64) {
        let times = theirs.as_secs_f64() / ours.as_secs_f64();
        let sides = format!("{ours:.1?} beside {theirs:.1?}");
        self.line(what, times, &format!("at least {least}"), times >= least, &sides);
    }

    /// How many times as long as `theirs` `ours` takes, which is to be `most` or less.
    pub fn at_most(&mut self, what: &str, ours: Duration, theirs: Duration, most: f64) {
        let times = ours.as_secs_f64() / theirs.as_secs_f64();
        let sides = format!("{ours:.1?} beside {theirs:.1?}");
        self.line(what, times, &format!("at most {most}"), times <= most, &sides);
    }

    /// How many times as many bytes as `theirs` `ours` are, which is to be `most` or less.
    pub fn bytes_at_most(&mut self, what: &str, ours: usize, theirs: usize, most: f64) {
        let times = ours as f64 / theirs as f64;
        let [ours, theirs] = [ours, theirs].map(|bytes| bytes as f64 / 1e6);
        let sides = format!("{ours:.1} MB beside {theirs:.1} MB");
        self.line(what, times, &format!("at most {most}"), times <= most, &sides);
    }

    fn line(&mut self, what: &str, times: f64, limit: &str, is_met: bool, sides: &str) {
        self.missed += usize::from(!is_met);
        let verdict = if is_met { "met" } else { "missed" };
        println!("goal {}: {times:.3} times, {limit}: {verdict} ({what}: {sides})", self.goal);
    }
}

/// What each of some pieces of work takes when it is left alone: each runs once in every round, and the tenth part of its times is
/// taken, from the shortest.
pub fn in_turn<const N: usize>(rounds: usize, mut work: [&mut dyn FnMut(); N]) -> [Duration; N] {
    let mut times = [const { Vec::new() }; N];
    for _ in 0..rounds {
        for (times, work) in times.iter_mut().zip(&mut work) {
            let start = Instant::now();
            work();
            times.push(start.elapsed());
        }
    }
    times.map(|mut times: Vec<Duration>| {
        times.sort();
        times[times.len() / 10]
    })
}
