//! An export from its options to its file: what the window does on a thread of its own.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::{
    Animation, Drawing, ExportError, Moments, Painter, Size, Source, Span, Stage, Target, View, Watch, find_ffmpeg,
    write_film, write_folder,
};
use crate::editor::{Editor, ExportBackground, ExportEnd, ExportOptions};
use crate::render::{Background, Gpu};
use crate::scene::{Colour, SceneGraph};

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
    /// An export of an editor's document. An empty list shows what the command line shows without a file: the rest pose.
    #[must_use]
    pub fn new(editor: &Editor, options: ExportOptions) -> Self {
        let document = editor.document();
        let animation = (!document.keyframes.is_empty()).then(|| Animation {
            keyframes: document.keyframes.clone(),
            interpolation: document.interpolation,
            ms_between_keyframes: document.ms_between_keyframes,
        });
        Self { scene: Arc::clone(editor.scene()), animation, file: editor.path().to_owned(), options }
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
        let is_seen_through = *background == ExportBackground::Transparent;
        if let Some(problem) = format.problem(*size, Some(*fps), is_seen_through) {
            return Err(ExportError::misuse(problem));
        }
        let target = Target::from(*format);
        if target == Target::Mp4 {
            find_ffmpeg(path)?;
        }
        let animation = self.animation.as_ref();
        let file = animation.is_some().then_some(self.file.as_path());
        let source = Source { scene: &self.scene, animation, file };
        let view = View::named(camera.as_deref(), &self.scene)?;
        let [from, to] = range.map_or([None; 2], |range| range.map(Some));
        // What cannot be played is found out before anything is drawn.
        let moments = Moments::of_film(Span { from, to, seconds: 0.0 }, source, view, *fps)?;
        let size = Size { width: size[0], height: size[1] };
        let mut painter = Painter::on(Gpu::headless()?, size, *samples)?;
        painter.set_background(match background {
            ExportBackground::Sky => Background::Sky,
            ExportBackground::Colour([red, green, blue]) => Background::Colour(
                Colour::from_hex(&format!("#{red:02x}{green:02x}{blue:02x}"))
                    .expect("the colour is of the form #rrggbb")
                    .to_linear(),
            ),
            ExportBackground::Transparent => Background::Transparent,
        });
        let stage = Stage::new(source, view, *ghosts, painter.size_px());
        let mut drawing = Drawing { stage: &stage, moments: &moments, painter: &mut painter, watch };
        if target == Target::Folder {
            write_folder(path, &mut drawing, &mut |_, _| *in_folder += 1)?;
        } else {
            write_film(path, target, moments.plan(size, *fps, !is_seen_through)?, &mut drawing)?;
        }
        Ok(moments.all.len())
    }
}
