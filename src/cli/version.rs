//! `inbetween --version`.

use super::{CliError, output};
use crate::facts::{VERSION, facts, lines};
use crate::render::{Gpu, GpuError, adapter_facts};
use crate::signals;

/// Prints the version, and with `is_verbose` what a report of a fault needs. Where nothing can draw, a sentence says so in the adapter's
/// place: that is no failure.
///
/// # Errors
/// [`CliError`]: standard output does not take it.
pub fn run(is_verbose: bool) -> Result<(), CliError> {
    if !is_verbose {
        return output::say(&format!("inbetween {VERSION}\n"));
    }
    let gpu = Gpu::headless();
    let adapter = match &gpu {
        Ok(gpu) => adapter_facts(gpu),
        Err(error) => vec![("adapter", error.to_string())],
    };
    output::say(&lines(&facts().into_iter().chain(adapter).collect::<Vec<_>>()))?;
    match gpu {
        // The usual end of the process would wait for a driver that hangs.
        Err(error @ GpuError::Hangs { .. }) => signals::end(0, &error.to_string()),
        // The driver's clean-up takes milliseconds, and the process ends.
        gpu => std::mem::forget(gpu),
    }
    Ok(())
}
