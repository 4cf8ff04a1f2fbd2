//! Ctrl+C during long work: the work ends at its next step, and what is not finished is removed.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// Whether someone has asked for the end.
#[derive(Clone)]
pub struct Interrupt(Arc<AtomicBool>);

impl Interrupt {
    /// Listens from now on to Ctrl+C, and to the system's wish that the program end.
    pub fn listen() -> Self {
        let asked = Arc::new(AtomicBool::new(false));
        let told = Arc::clone(&asked);
        // Where someone listens already, the process ends at once, as without this.
        let _ = ctrlc::set_handler(move || told.store(true, Ordering::Relaxed));
        Self(asked)
    }

    /// Whether someone has asked for the end.
    pub fn is_asked(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }
}
