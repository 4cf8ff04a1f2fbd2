//! Painters for the commands.

use super::CliError;
use crate::export::{Painter, Size};
use crate::render::Gpu;

impl Painter {
    /// Acquires a GPU adapter for pictures of a size; with as many samples a pixel as suit it, unless told.
    ///
    /// # Errors
    /// [`CliError::Gpu`] where there is none, or it cannot draw pictures so large.
    pub(super) fn headless(size: Size, samples: Option<u32>) -> Result<Self, CliError> {
        let gpu = super::quiet::without_driver_chatter(Gpu::headless)?;
        Ok(Self::on(gpu, size, samples)?)
    }
}
