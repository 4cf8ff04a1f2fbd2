//! An export from its options to its file: what the window does on a thread of its own.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::{Animation, ExportError, Painter, RenderRequest, Size, Source, Span, Subject, Watch, check_format};
use crate::colour::Colour;
use crate::film::{ExportBackground, ExportEnd, ExportOptions};
use crate::render::Background;
use crate::scene::SceneGraph;

/// All that an export needs: what it was when it was asked for, whatever becomes of the document meanwhile.
#[derive(Clone, Debug)]
pub struct Job {
    scene: Arc<SceneGraph>,
    animation: Option<Animation>,
    /// What errors name.
    file: PathBuf,
    options: ExportOptions,
}

impl Job {
    /// An export of an animation in a scene; without one it is what the command line shows without a file, the rest pose. `file` is
    /// the keyframe file, which errors name.
    #[must_use]
    pub const fn new(
        scene: Arc<SceneGraph>,
        animation: Option<Animation>,
        file: PathBuf,
        options: ExportOptions,
    ) -> Self {
        Self { scene, animation, file, options }
    }

    /// Where it goes.
    #[must_use]
    pub fn path(&self) -> &Path {
        &self.options.path
    }

    /// Draws and writes it all, on a GPU adapter of its own.
    #[must_use]
    pub fn run(&self, watch: &mut Watch<'_>) -> ExportEnd {
        let mut frames = 0;
        match self.write(watch, &mut frames) {
            Ok(count) => ExportEnd::Written(count),
            Err(ExportError::Cancelled) => ExportEnd::Cancelled(frames),
            Err(error) => ExportEnd::Failed(error.message()),
        }
    }

    /// Counts the frames that are in a folder in `in_folder`, and returns how many there are in all.
    fn write(&self, watch: &mut Watch<'_>, in_folder: &mut usize) -> Result<usize, ExportError> {
        let ExportOptions { path, format, size, fps, range, ghosts, camera, samples, background } = &self.options;
        let size = Size { width: size[0], height: size[1] };
        let is_opaque = *background != ExportBackground::Transparent;
        check_format(format, size, Some(*fps), is_opaque, path)?;
        let animation = self.animation.as_ref();
        let file = animation.is_some().then_some(self.file.as_path());
        let [from, to] = range.map_or([None; 2], |range| range.map(Some));
        let request = RenderRequest {
            source: Source { scene: &self.scene, animation, file },
            subject: Subject::Film { fps: *fps },
            span: Span { from, to, seconds: 0.0 },
            camera: camera.as_deref(),
            ghosts: *ghosts,
            is_opaque,
            format,
            output: path,
            removes_stale: false,
        };
        // What cannot be played is found out before anything is drawn.
        let planned = request.plan()?;
        let mut painter = Painter::headless(size, *samples)?;
        painter.set_background(match background {
            ExportBackground::Sky => Background::Sky,
            ExportBackground::Colour(bytes) => Background::Colour(Colour::from_bytes(*bytes).to_linear()),
            ExportBackground::Transparent => Background::Transparent,
        });
        planned.write(&mut painter, watch, &mut |_, _| *in_folder += 1)?;
        Ok(planned.frame_count())
    }
}
