//! The picture in the corner of the scene: what the recorded camera sees. It is made when the window has nothing more urgent to do, ten
//! times a second at most, and only where it would differ from the one before.

use std::sync::Arc;
use std::time::Duration;

use glam::Vec2;
use web_time::Instant;

use super::now;
use super::panels::PanelPainter;
use super::shell::Shell;
use crate::editor::Editor;
use crate::frame::Frame;
use crate::pose::{Pose, RbtIndex};
use crate::render::{Gpu, Renderer, Target, Viewport};
use crate::scene::SceneGraph;
use crate::view::frame_of_recorded_eye;

/// The least time between two pictures.
const PAUSE: Duration = Duration::from_millis(100);
/// The time after a change before a picture is made, so that the window draws the change first.
const REST: Duration = Duration::from_millis(20);

/// What a picture shows.
#[derive(Clone, Debug)]
struct Shown {
    scene: Arc<SceneGraph>,
    pose: Pose,
    seconds: f64,
    eye: RbtIndex,
    size_px: [u32; 2],
}

impl Shown {
    fn now(editor: &Editor, size_px: [u32; 2]) -> Self {
        let (_, eye) = editor.recorded_eye();
        let scene = Arc::clone(editor.scene());
        Self { scene, pose: editor.displayed_pose(), seconds: editor.seconds(), eye, size_px }
    }

    fn is_like(&self, other: &Self) -> bool {
        let is_same_pose = self.pose.shares_with(&other.pose) || self.pose == other.pose;
        Arc::ptr_eq(&self.scene, &other.scene)
            && is_same_pose
            && self.seconds.to_bits() == other.seconds.to_bits()
            && (self.eye, self.size_px) == (other.eye, other.size_px)
    }
}

/// When the next picture is made, and what the last one shows.
#[derive(Debug, Default)]
pub struct Inset {
    shown: Option<Shown>,
    last: Option<Instant>,
    /// When the next one is due.
    pub due: Option<Instant>,
}

impl Inset {
    /// Plans the next picture; `wanted` is what it shows, where there is to be one.
    fn plan(&mut self, wanted: Option<&Shown>, at: Instant) {
        let is_new = wanted.is_some_and(|wanted| self.shown.as_ref().is_none_or(|shown| !shown.is_like(wanted)));
        let earliest = self.last.map_or(at, |last| (last + PAUSE).max(at)).max(at + REST);
        self.due = self.due.or(Some(earliest)).filter(|_| is_new);
    }

    /// Whether a picture is made now.
    fn is_due(&mut self, at: Instant) -> bool {
        let is_due = self.due.is_some_and(|due| due <= at);
        if is_due {
            self.due = None;
            self.last = Some(at);
        }
        is_due
    }
}

impl Shell {
    /// When the next picture is due: none where nothing changed, or no corner is in sight.
    pub(super) fn plan_inset(&mut self) {
        let wanted = self.ui.wanted_inset().map(|size_px| Shown::now(&self.editor, size_px));
        self.inset.plan(wanted.as_ref(), now());
    }

    /// Makes the picture where one is due, and shows it.
    pub(super) fn make_inset(&mut self, at: Instant) {
        if !self.inset.is_due(at) {
            return;
        }
        let (Some(size_px), Some(stage)) = (self.ui.wanted_inset(), &mut self.stage) else { return };
        let shown = Shown::now(&self.editor, size_px);
        #[expect(clippy::cast_precision_loss, reason = "it is a small picture")]
        let size = Vec2::new(size_px[0] as f32, size_px[1] as f32);
        let frame = frame_of_recorded_eye(&self.editor, &shown.pose, size);
        self.ui.inset = Some(stage.draw_inset(&frame, size_px));
        self.inset.shown = Some(shown);
        self.request_redraw();
    }
}

/// Draws the picture into a texture that the panels show.
pub struct InsetPainter {
    renderer: Renderer,
    shown: Option<(wgpu::TextureView, [u32; 2], egui::TextureId)>,
}

impl InsetPainter {
    /// The format of textures that panels show: their shader reads sRGB's own numbers.
    const FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8Unorm;

    /// For a device. The picture is so small that many samples cost nothing.
    pub fn new(gpu: &Gpu) -> Self {
        Self { renderer: Renderer::new(gpu, Self::FORMAT, 4), shown: None }
    }

    /// Draws a picture of a size in pixels, and says which texture has it.
    pub fn draw(&mut self, gpu: &Gpu, panels: &mut PanelPainter, frame: &Frame, size_px: [u32; 2]) -> egui::TextureId {
        let [width, height] = size_px;
        if self.shown.as_ref().is_none_or(|(_, size, _)| *size != size_px) {
            let texture = gpu.device.create_texture(&wgpu::TextureDescriptor {
                label: Some("inset"),
                size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
                mip_level_count: 1,
                sample_count: 1,
                dimension: wgpu::TextureDimension::D2,
                format: Self::FORMAT,
                usage: wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::TEXTURE_BINDING,
                view_formats: &[],
            });
            let view = texture.create_view(&wgpu::TextureViewDescriptor::default());
            let id = panels.show_texture(gpu, &view, self.shown.as_ref().map(|(_, _, id)| *id));
            self.shown = Some((view, size_px, id));
        }
        let (view, _, id) = self.shown.as_ref().expect("it was just made");
        self.renderer.render(gpu, frame, Target { view, viewport: Viewport::whole(width, height) });
        *id
    }
}

#[cfg(test)]
mod tests {
    use std::path::PathBuf;

    use super::*;
    use crate::editor::{Command, Edit};
    use crate::scene::{DEFAULT_SCENE, built_in_scene};

    #[test]
    fn pictures_are_made_ten_times_a_second_at_most_and_only_where_something_changed() {
        let mut editor = Editor::new(Arc::new(built_in_scene(DEFAULT_SCENE).unwrap()), PathBuf::from("a.json"));
        let (mut inset, start) = (Inset::default(), now());
        let mut made = Vec::new();
        // For two seconds the window draws every 10 ms; in the first, the robot moves each time.
        for ms in (0..2000).step_by(10) {
            if ms < 1000 {
                #[expect(clippy::cast_precision_loss, reason = "it is a small number")]
                let to = glam::Vec3::new(ms as f32 / 1000.0, 1.0, 0.0);
                let robot = editor.scene().find_rbt("robot1").unwrap();
                editor.apply(Command::Edit(Edit::SetTranslation(robot, to))).unwrap();
            }
            let at = start + Duration::from_millis(ms);
            let wanted = Shown::now(&editor, [160, 90]);
            inset.plan(Some(&wanted), at);
            if inset.is_due(at) {
                inset.shown = Some(wanted);
                made.push(ms);
            }
        }
        assert!(made.len() >= 10 && made.windows(2).all(|pair| pair[1] - pair[0] >= 100), "{made:?}");
        assert!(made.last().is_some_and(|&last| (990..1200).contains(&last)), "the last change shows: {made:?}");
        inset.plan(Some(&Shown::now(&editor, [80, 45])), start + Duration::from_secs(3));
        assert!(inset.due.is_some(), "another size is another picture");
        inset.plan(None, start + Duration::from_secs(3));
        assert_eq!(inset.due, None);
    }
}
