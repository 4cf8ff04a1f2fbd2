//! Two threads: one draws, the other takes what is drawn, in its order.

use std::sync::mpsc;
use std::thread;

use super::super::CliError;
use super::super::interrupt::Interrupt;
use super::super::picture::Painter;
use super::super::progress::Progress;
use super::Stage;
use super::moments::Moments;
use crate::render::Image;

/// Pictures that wait at most: enough for one thread not to stop for a slow picture of the other.
const WAITING: usize = 4;

/// Draws every moment and gives the pictures to `take` in their order, on another thread than the drawing. Ends at the first error.
///
/// # Errors
/// [`CliError`] of the drawing, of `take`, or [`CliError::Interrupted`].
pub fn draw(
    moments: &Moments,
    stage: &Stage<'_>,
    painter: &mut Painter,
    interrupt: &Interrupt,
    mut take: impl FnMut(usize, Image) -> Result<(), CliError> + Send,
) -> Result<(), CliError> {
    let mut progress = Progress::new("frame", moments.all.len());
    thread::scope(|scope| {
        let (sender, receiver) = mpsc::sync_channel::<Image>(WAITING);
        let taker =
            scope.spawn(move || receiver.into_iter().enumerate().try_for_each(|(place, image)| take(place, image)));
        let drawn = moments.all.iter().try_for_each(|moment| -> Result<(), Stop> {
            interrupt.check()?;
            let image = painter.image(&stage.frame(moment)?)?;
            progress.step();
            // Where the other side is gone it has an error to tell.
            sender.send(image).map_err(|_| Stop(None))
        });
        drop(sender);
        let taken = taker.join().expect("taking pictures does not panic");
        match drawn {
            Err(Stop(Some(error))) => Err(error),
            _ => taken,
        }
    })
}

/// Why drawing stopped: an error of its own, or one that the other side tells.
struct Stop(Option<CliError>);

impl From<CliError> for Stop {
    fn from(error: CliError) -> Self {
        Self(Some(error))
    }
}
