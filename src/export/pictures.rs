//! Where the pictures of a film come from.

use super::{ExportError, Watch};
use crate::picture::Image;

/// Receives a picture and its place in the film.
pub type Take<'a> = dyn FnMut(usize, Image) -> Result<(), ExportError> + Send + 'a;

/// The pictures of a film in their order: they are drawn, or read from a folder.
pub trait Pictures {
    /// How many there are.
    fn count(&self) -> usize;

    /// The pictures in these places, counted from 0, before the film is begun.
    ///
    /// # Errors
    /// [`ExportError`] of the drawing or reading.
    fn ahead(&mut self, places: &[usize]) -> Result<Vec<Image>, ExportError>;

    /// Gives every picture to `take`, in order. Ends at the first error.
    ///
    /// # Errors
    /// [`ExportError`] of the drawing or reading, of `take`, or [`ExportError::Cancelled`].
    fn each(&mut self, watch: &mut Watch<'_>, take: &mut Take<'_>) -> Result<(), ExportError>;
}
