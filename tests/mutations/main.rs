//! Mutants of every input that the program reads: none makes a reader panic, or takes more memory than is stated.
//!
//! A mutant is made from a seed, so that one can be made again: `MUTANTS_FROM=SEED MUTANTS=1 cargo test --test mutations`. Without that, 20,000
//! are made from a fixed seed. By hand, a million: `MUTANTS=1000000 MUTANTS_FROM=7 cargo test --release --test mutations`.
//!
//! This is a test of its own because memory is counted over the whole process, so it is one test.

mod mutate;
mod originals;
mod readers;
#[path = "../convert/samples.rs"]
mod samples;

use std::alloc::{GlobalAlloc, Layout, System};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicUsize, Ordering};

use inbetween::text_layouts::{Options, import};
use mutate::Random;

/// So many mutants are made where the environment does not say.
const USUAL_COUNT: u64 = 20_000;

/// Counts the bytes in use, their peak, and the allocations, which stand for the work that is done.
struct Counting;

static IN_USE: AtomicUsize = AtomicUsize::new(0);
static PEAK: AtomicUsize = AtomicUsize::new(0);
static ALLOCATIONS: AtomicUsize = AtomicUsize::new(0);

#[expect(unsafe_code, reason = "only an allocator can count what is allocated")]
// SAFETY: the system's allocator does the work.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        let in_use = IN_USE.fetch_add(layout.size(), Ordering::Relaxed) + layout.size();
        PEAK.fetch_max(in_use, Ordering::Relaxed);
        ALLOCATIONS.fetch_add(1, Ordering::Relaxed);
        // SAFETY: as the caller promises.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, at: *mut u8, layout: Layout) {
        IN_USE.fetch_sub(layout.size(), Ordering::Relaxed);
        // SAFETY: as the caller promises.
        unsafe { System.dealloc(at, layout) }
    }
}

#[global_allocator]
static MEMORY: Counting = Counting;

fn number(variable: &str) -> Option<u64> {
    std::env::var(variable).ok().map(|text| text.parse().unwrap_or_else(|_| panic!("{variable} is a number")))
}

#[test]
fn mutants_do_no_harm() {
    let readers = readers::all();
    let from = number("MUTANTS_FROM").unwrap_or(1);
    let count = number("MUTANTS").unwrap_or(USUAL_COUNT);
    println!("mutants of the seeds {from} to {}", from + count - 1);
    // What is made once and kept is no mutant's.
    for reader in &readers {
        reader.originals.iter().for_each(|original| (reader.read)(original));
    }
    for seed in from..from + count {
        let mut random = Random::new(seed);
        let reader = random.one_of(&readers);
        let mutant = mutate::mutant(&reader.originals, &mut random);
        let again = || {
            let start = String::from_utf8_lossy(&mutant[..mutant.len().min(600)]).into_owned();
            format!("MUTANTS_FROM={seed} MUTANTS=1 ({}, {} bytes: {start:?})", reader.name, mutant.len())
        };
        let before = IN_USE.load(Ordering::Relaxed);
        PEAK.store(before, Ordering::Relaxed);
        let allocations = ALLOCATIONS.load(Ordering::Relaxed);
        let outcome = catch_unwind(AssertUnwindSafe(|| (reader.read)(&mutant)));
        assert!(outcome.is_ok(), "it panicked: {}", again());
        let taken = PEAK.load(Ordering::Relaxed).saturating_sub(before) + mutant.len();
        let bound = (reader.most_bytes)(&mutant);
        assert!(taken <= bound, "{taken} bytes of at most {bound}: {}", again());
        let steps = ALLOCATIONS.load(Ordering::Relaxed) - allocations;
        let most_steps = reader.most_steps_per_byte * (mutant.len() + 10_000);
        assert!(steps <= most_steps, "{steps} allocations of at most {most_steps}: {}", again());
    }
    counts_in_a_header_take_no_memory();
}

/// Texts whose size is said by a number in them, which may be wrong.
fn counts_in_a_header_take_no_memory() {
    let scene = samples::scene();
    for text in [
        "999999999 22\n1 2 3",
        "99999999 999999999 0",
        "4000000000 22",
        "frame [18446744073709551615]\n1",
        "{0: 1, 1e308: 1",
    ] {
        let before = IN_USE.load(Ordering::Relaxed);
        PEAK.store(before, Ordering::Relaxed);
        assert!(import(text.as_bytes(), &scene, &Options::default()).is_err(), "{text}");
        assert!(PEAK.load(Ordering::Relaxed) - before < 1 << 20, "{text}");
    }
}
