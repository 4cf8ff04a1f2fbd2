//! Two threads: one draws, the other consumes the pictures in order.

use std::sync::mpsc;
use std::thread;
use std::time::Duration;

use super::compared::Compared;
use super::pictures::{Pictures, Take};
use super::{ExportError, Exposed, Moment, Moments, Painter, Picture, Size, Stage};
use crate::picture::{Image, Rows};

/// The capacity of the queue: enough that a slow picture on one thread does not stop the other, at acceptable memory.
fn waiting(size: Size) -> usize {
    const WORTH_BYTES: usize = 16 << 20;
    const FEWEST: usize = 4;
    const MOST: usize = 12;
    let bytes = 4 * size.width as usize * size.height as usize;
    (WORTH_BYTES / bytes.max(1)).clamp(FEWEST, MOST)
}

/// Receives the number of drawn frames and the total, before each frame and after the last. Returns whether to continue.
pub type Watch<'a> = dyn FnMut(usize, usize) -> bool + 'a;

/// What a run draws at each moment.
#[derive(Clone, Copy)]
pub enum Scenery<'a> {
    /// A scene with its camera.
    Stage(&'a Stage<'a>),
    /// Several, arranged in one picture.
    Compared(&'a Compared<'a>),
}

impl<'a> Scenery<'a> {
    /// The scenes that are drawn for one picture.
    pub(super) fn stages(self) -> &'a [Stage<'a>] {
        match self {
            Self::Stage(stage) => std::slice::from_ref(stage),
            Self::Compared(compared) => compared.stages(),
        }
    }

    /// Draws the picture of a moment.
    pub(super) fn image(self, painter: &mut Painter, moment: &Moment) -> Result<Image, ExportError> {
        match self {
            Self::Stage(stage) => painter.exposed(&Exposed::of_stage(stage, moment)?),
            Self::Compared(compared) => {
                let view = |stage| painter.exposed(&Exposed::of_stage(stage, moment)?);
                let views = compared.stages().iter().map(view).collect::<Result<Vec<_>, _>>()?;
                Ok(compared.picture(&views.iter().map(Image::rows).collect::<Vec<_>>(), moment))
            }
        }
    }

    /// The next picture of a run, of what was drawn for it; `None` if that ends before.
    fn next_picture(self, drawn: &mut impl Iterator<Item = Picture>, moment: &Moment) -> Option<Picture> {
        match self {
            Self::Stage(_) => drawn.next(),
            Self::Compared(compared) => {
                let views: Vec<Picture> = drawn.take(compared.stages().len()).collect();
                let views: Vec<Rows<'_>> = views.iter().map(Picture::rows).collect();
                (views.len() == compared.stages().len()).then(|| Picture::Made(compared.picture(&views, moment)))
            }
        }
    }
}

/// The inputs of a run.
pub struct Drawing<'a> {
    /// What is drawn.
    pub scenery: Scenery<'a>,
    /// The moments to draw.
    pub moments: &'a Moments,
    /// The painter that draws them.
    pub painter: &'a mut Painter,
}

impl Drawing<'_> {
    /// Draws every moment and gives the pictures to `take` in their order, on another thread than the drawing. Ends at the first error.
    ///
    /// # Errors
    /// [`ExportError`] of the drawing, of `take`, or [`ExportError::Cancelled`].
    pub fn draw(
        &mut self,
        watch: &mut Watch<'_>,
        mut take: impl FnMut(usize, Picture) -> Result<(), ExportError> + Send,
    ) -> Result<(), ExportError> {
        let Self { scenery, moments, painter } = self;
        let (scenery, stages, moments) = (*scenery, scenery.stages(), *moments);
        let count = moments.all.len();
        let mut goes_on = |done: usize| if watch(done, count) { Ok(()) } else { Err(ExportError::Cancelled) };
        let gives_way = painter.gpu().is_software;
        thread::scope(|scope| {
            let (sender, receiver) = mpsc::sync_channel::<Picture>(waiting(painter.size()));
            let taker = scope.spawn(move || {
                if gives_way {
                    give_way();
                }
                let mut drawn = receiver.into_iter();
                for (index, moment) in moments.all.iter().enumerate() {
                    // Where the drawing has ended by an error there are no more.
                    let Some(picture) = scenery.next_picture(&mut drawn, moment) else { break };
                    take(index, picture)?;
                }
                Ok(())
            });
            let views = moments
                .all
                .iter()
                .enumerate()
                .flat_map(|(index, moment)| stages.iter().map(move |stage| (index, stage, moment)));
            let drawn = { views }.try_for_each(|(index, stage, moment)| -> Result<(), Stop> {
                goes_on(index)?;
                match painter.next_drawn(Some(&Exposed::of_stage(stage, moment)?))? {
                    Some(picture) => send(&sender, picture, || goes_on(index)),
                    None => Ok(()),
                }
            });
            // Frames that were submitted are read back, also after cancelling.
            let drawn = match painter.next_drawn(None) {
                Ok(Some(picture)) => {
                    let sent = send(&sender, picture, || goes_on(count.saturating_sub(1)));
                    drawn.and(sent)
                }
                Ok(None) => drawn,
                Err(error) => drawn.and(Err(Stop(Some(error)))),
            };
            drop(sender);
            let taken = taker.join().expect("taking pictures does not panic");
            match drawn {
                Err(Stop(Some(error))) => Err(error),
                _ => taken,
            }
        })?;
        // Waiting for the consumer took time; the watcher is asked again.
        goes_on(count)
    }
}

impl Pictures for Drawing<'_> {
    fn count(&self) -> usize {
        self.moments.all.len()
    }

    fn ahead(&mut self, places: &[usize]) -> Result<Vec<Image>, ExportError> {
        let Self { scenery, moments, painter } = self;
        places.iter().map(|&place| scenery.image(painter, &moments.all[place])).collect()
    }

    fn each(&mut self, watch: &mut Watch<'_>, take: &mut Take<'_>) -> Result<(), ExportError> {
        self.draw(watch, |place, drawn| take(place, drawn.into_image()))
    }
}

/// How often the watcher is asked while the queue is full.
const STEP: Duration = Duration::from_millis(5);

/// Sends a picture. While the queue is full, because its consumer is slow or hangs, the watcher can cancel.
fn send(
    sender: &mpsc::SyncSender<Picture>,
    mut picture: Picture,
    mut goes_on: impl FnMut() -> Result<(), ExportError>,
) -> Result<(), Stop> {
    loop {
        match sender.try_send(picture) {
            Ok(()) => return Ok(()),
            Err(mpsc::TrySendError::Full(unsent)) => picture = unsent,
            // If the other thread has ended, it has returned an error.
            Err(mpsc::TrySendError::Disconnected(_)) => return Err(Stop(None)),
        }
        goes_on()?;
        thread::sleep(STEP);
    }
}

/// The niceness of the consuming thread: at 15 it gets a thirtieth of a core that another thread competes for.
#[cfg(target_os = "linux")]
const NICER: i32 = 15;

/// Lowers the priority of this thread below the threads of a software driver. Those wait for each other within a picture, so one that waits
/// for a core delays all. This thread uses the remaining time; if it falls behind, the queue makes the drawing wait.
#[cfg(target_os = "linux")]
fn give_way() {
    // With process 0 Linux means the calling thread (setpriority(2)). An error only makes pictures slower.
    let _ = rustix::process::nice(NICER);
}

/// Only Linux can lower the priority of one thread without unsafe code.
#[cfg(not(target_os = "linux"))]
const fn give_way() {}

/// Why drawing stopped: an own error, or an error of the consuming thread.
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
