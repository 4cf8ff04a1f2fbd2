//! Ctrl+C during long work: the work ends at its next step, and what is not finished is removed.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// Whether an interrupt was requested.
#[derive(Clone)]
pub struct Interrupt(Arc<AtomicBool>);

impl Interrupt {
    /// Listens from now on to Ctrl+C, and to the system's wish that the program end.
    pub fn listen() -> Self {
        let asked = Arc::new(AtomicBool::new(false));
        let told = Arc::clone(&asked);
        // If a handler exists already, Ctrl+C ends the process at once, as usual.
        let _ = ctrlc::set_handler(move || told.store(true, Ordering::Relaxed));
        Self(asked)
    }

    /// Whether an interrupt was requested.
    pub fn is_asked(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }
}
