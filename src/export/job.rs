//! An export from its options to its file, for a thread of the window.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::{
    Animation, ExportError, Exposure, Painter, RenderRequest, Shutter, Size, Source, Span, Subject, Watch, check_format,
};
use crate::colour::Colour;
use crate::film::{ExportBackground, ExportEnd, ExportOptions};
use crate::render::{Background, Refinement};
use crate::scene::SceneGraph;

/// All data of an export: a snapshot of the document at the time of the request.
#[derive(Clone, Debug)]
pub struct Job {
    scene: Arc<SceneGraph>,
    animation: Option<Animation>,
    /// The name of the source in errors.
    file: PathBuf,
    options: ExportOptions,
}

impl Job {
    /// An export of an animation in a scene; without an animation, of the rest pose. Errors name `file`, the keyframe file.
    #[must_use]
    pub const fn new(
        scene: Arc<SceneGraph>,
        animation: Option<Animation>,
        file: PathBuf,
        options: ExportOptions,
    ) -> Self {
        Self { scene, animation, file, options }
    }

    /// The output path.
    #[must_use]
    pub fn path(&self) -> &Path {
        &self.options.path
    }

    /// Draws and writes everything, on its own GPU adapter.
    #[must_use]
    pub fn run(&self, watch: &mut Watch<'_>) -> ExportEnd {
        let mut frames = 0;
        match self.write(watch, &mut frames) {
            Ok(count) => ExportEnd::Written(count),
            Err(ExportError::Cancelled) => ExportEnd::Cancelled(frames),
            Err(error) => ExportEnd::Failed(error.message()),
        }
    }

    /// Counts the frames written into a folder in `in_folder`, and returns the total.
    fn write(&self, watch: &mut Watch<'_>, in_folder: &mut usize) -> Result<usize, ExportError> {
        let ExportOptions { path, format, size, fps, range, ghosts, camera, samples, quality, lighting, background } =
            &self.options;
        let size = Size { width: size[0], height: size[1] };
        let is_opaque = *background != ExportBackground::Transparent;
        check_format(format, size, Some(*fps), is_opaque, path)?;
        let lit = lighting.map(|lighting| self.scene.with_lighting(lighting.into()));
        let scene = lit.as_ref().unwrap_or(&self.scene);
        let animation = self.animation.as_ref();
        let file = animation.is_some().then_some(self.file.as_path());
        let [from, to] = range.map_or([None; 2], |range| range.map(Some));
        let request = RenderRequest {
            source: Source { scene, animation, file },
            subject: Subject::Film { fps: *fps },
            span: Span { from, to, seconds: 0.0 },
            frames: None,
            only_missing: false,
            camera: camera.as_deref(),
            ghosts: *ghosts,
            comparison: None,
            exposure: Exposure { shutter: Shutter::OF_FILMS, focus: None },
            is_opaque,
            format,
            output: path,
            removes_stale: false,
        };
        // Errors in the animation are found before anything is drawn.
        let planned = request.plan()?;
        let mut painter = Painter::headless(size, *samples)?;
        painter.refine(Refinement::of_quality(*quality));
        painter.set_background(match background {
            ExportBackground::Sky => Background::Sky,
            ExportBackground::Colour(bytes) => Background::Colour(Colour::from_bytes(*bytes).to_linear()),
            ExportBackground::Transparent => Background::Transparent,
        });
        planned.write(&mut painter, watch, &mut |_, _| *in_folder += 1)?;
        Ok(planned.frame_count())
    }
}
