//! Two threads: one draws, the other takes what is drawn, in its order.

use std::sync::mpsc;
use std::thread;

use super::{ExportError, Moments, Painter, Size, Stage};
use crate::render::Drawn;

/// Pictures that wait at most: enough for one thread not to stop for slow pictures of the other, and no more memory than that is worth.
fn waiting(size: Size) -> usize {
    const WORTH_BYTES: usize = 16 << 20;
    const FEWEST: usize = 4;
    const MOST: usize = 12;
    let bytes = 4 * size.width as usize * size.height as usize;
    (WORTH_BYTES / bytes.max(1)).clamp(FEWEST, MOST)
}

/// Is told how many frames are drawn and of how many, before each and after the last; says whether to go on.
pub type Watch<'a> = dyn FnMut(usize, usize) -> bool + 'a;

/// What is drawn, with what, and under whose eyes.
pub struct Drawing<'a> {
    /// What there is to see.
    pub stage: &'a Stage<'a>,
    /// When.
    pub moments: &'a Moments,
    /// Who draws it.
    pub painter: &'a mut Painter,
    /// Who may end it.
    pub watch: &'a mut Watch<'a>,
}

impl Drawing<'_> {
    /// Draws every moment and gives the pictures to `take` in their order, on another thread than the drawing. Ends at the first error.
    ///
    /// # Errors
    /// [`ExportError`] of the drawing, of `take`, or [`ExportError::Cancelled`].
    pub fn draw(
        &mut self,
        mut take: impl FnMut(usize, Drawn) -> Result<(), ExportError> + Send,
    ) -> Result<(), ExportError> {
        let Self { stage, moments, painter, watch } = self;
        let count = moments.all.len();
        let mut goes_on = |done: usize| if watch(done, count) { Ok(()) } else { Err(ExportError::Cancelled) };
        let gives_way = painter.gpu().is_software;
        thread::scope(|scope| {
            let (sender, receiver) = mpsc::sync_channel::<Drawn>(waiting(painter.size()));
            let taker = scope.spawn(move || {
                if gives_way {
                    give_way();
                }
                receiver.into_iter().enumerate().try_for_each(|(index, drawn)| take(index, drawn))
            });
            let drawn = moments.all.iter().enumerate().try_for_each(|(index, moment)| -> Result<(), Stop> {
                goes_on(index)?;
                match painter.next_drawn(Some(&stage.frame(moment)?))? {
                    // Where the other side is gone it has an error to tell.
                    Some(picture) => sender.send(picture).map_err(|_| Stop(None)),
                    None => Ok(()),
                }
            });
            // What was begun is finished, also where no more is wanted.
            let drawn = match painter.next_drawn(None) {
                Ok(Some(picture)) => drawn.and(sender.send(picture).map_err(|_| Stop(None))),
                Ok(None) => drawn,
                Err(error) => drawn.and(Err(error.into())),
            };
            drop(sender);
            let taken = taker.join().expect("taking pictures does not panic");
            match drawn {
                Err(Stop(Some(error))) => Err(error),
                _ => taken,
            }
        })?;
        // Taking what waited took its time.
        goes_on(count)
    }
}

/// How much nicer than the others the thread that takes pictures is: 15 steps leave it a thirtieth of a core that another thread wants.
#[cfg(target_os = "linux")]
const NICER: i32 = 15;

/// Lets the threads of a software driver go first from now on: they wait for each other within a picture, so that one of them that
/// has to wait for a core holds up all. This thread has the time they leave over, and while it is behind they wait for it.
#[cfg(target_os = "linux")]
fn give_way() {
    // With process 0 Linux means the calling thread (setpriority(2)). Where it refuses, pictures only come later.
    let _ = rustix::process::nice(NICER);
}

/// Only on Linux can a thread go behind the others of its program without unsafe code.
#[cfg(not(target_os = "linux"))]
const fn give_way() {}

/// Why drawing stopped: an error of its own, or one that the other side tells.
struct Stop(Option<ExportError>);

impl<E: Into<ExportError>> From<E> for Stop {
    fn from(error: E) -> Self {
        Self(Some(error.into()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn few_large_pictures_wait_or_many_small_ones() {
        let of = |width, height| waiting(Size { width, height });
        assert_eq!([of(1, 1), of(640, 480), of(1024, 640), of(1280, 720), of(7680, 4320)], [12, 12, 6, 4, 4]);
    }
}
