//! An export from its options to its file, for a thread of the window.

use std::path::{Path, PathBuf};
use std::sync::Arc;

#[cfg(not(target_arch = "wasm32"))]
use super::Watch;
use super::{
    Animation, ExportError, Exposure, Painter, RenderRequest, Shutter, Size, Source, Span, Subject, check_format,
};
use crate::colour::Colour;
use crate::film::{ExportBackground, ExportEnd, ExportOptions, Format};
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
    #[cfg(not(target_arch = "wasm32"))]
    #[must_use]
    pub fn run(&self, watch: &mut Watch<'_>) -> ExportEnd {
        let mut frames = 0;
        let lit = self.lit();
        let written = self.request(&lit).and_then(|request| {
            // Errors in the animation are found before anything is drawn.
            let planned = request.plan()?;
            let mut painter = Painter::headless(self.size(), self.options.samples)?;
            self.prepare(&mut painter);
            planned.write(&mut painter, watch, &mut |_, _| frames += 1)?;
            Ok(planned.frame_count())
        });
        end(written, frames)
    }

    /// The size of its pictures.
    pub(super) fn size(&self) -> Size {
        Size::of(self.options.size)
    }

    /// The format of its file.
    pub(super) const fn format(&self) -> &'static Format {
        self.options.format
    }

    /// The scene in the light that is asked for.
    pub(super) fn lit(&self) -> Arc<SceneGraph> {
        match self.options.lighting {
            Some(lighting) => Arc::new(self.scene.with_lighting(lighting.into())),
            None => Arc::clone(&self.scene),
        }
    }

    /// The request, of the scene that [`Self::lit`] gives.
    pub(super) fn request<'a>(&'a self, scene: &'a SceneGraph) -> Result<RenderRequest<'a>, ExportError> {
        let ExportOptions { path, format, fps, range, ghosts, camera, background, .. } = &self.options;
        let is_opaque = *background != ExportBackground::Transparent;
        check_format(format, self.size(), Some(*fps), is_opaque, path)?;
        let animation = self.animation.as_ref();
        let file = animation.is_some().then_some(self.file.as_path());
        let [from, to] = range.map_or([None; 2], |range| range.map(Some));
        Ok(RenderRequest {
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
        })
    }

    /// Has a painter draw as is asked for.
    pub(super) fn prepare(&self, painter: &mut Painter) {
        painter.refine(Refinement::of_quality(self.options.quality));
        painter.set_background(match self.options.background {
            ExportBackground::Sky => Background::Sky,
            ExportBackground::Colour(bytes) => Background::Colour(Colour::from_bytes(bytes).to_linear()),
            ExportBackground::Transparent => Background::Transparent,
        });
    }
}

/// How it ended; of a folder so many frames were written.
pub(super) fn end(written: Result<usize, ExportError>, frames: usize) -> ExportEnd {
    match written {
        Ok(count) => ExportEnd::Written(count),
        Err(ExportError::Cancelled) => ExportEnd::Cancelled(frames),
        Err(error) => ExportEnd::Failed(error.message()),
    }
}
