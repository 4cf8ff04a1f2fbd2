//! The window's GPU resources: surface, device, and the renderers of scene and panels. All can be lost and made again.

use std::sync::Arc;
use std::time::Duration;

use glam::Vec2;
use winit::event_loop::{ActiveEventLoop, EventLoopProxy};
use winit::window::Window;

use super::clipboard::Clipboard;
use super::inset::InsetPainter;
use super::meter::{Meter, Work};
use super::panels::{PanelPainter, WindowLayout};
use super::rest::{AT_REST, Next, RestingPicture};
use super::screen::Screen;
use super::{UserEvent, WindowError, now};
use crate::camera::Camera;
use crate::editor::gizmo::Handle;
use crate::editor::{Editor, LimbBall, PathDot, WorkEye};
use crate::facts;
use crate::frame::Frame;
use crate::pose::RbtIndex;
use crate::render::{
    Gpu, GpuError, Image, Offscreen, Refiner, Renderer, Target, Viewport, adapter_facts, default_samples,
};
use crate::scene::Part;
use crate::ui::{Panels, THUMBNAIL_PX, UiOutput, theme};
use crate::view::{
    add_limb_balls, frame_of_displayed, light, light_handle, mark_dot, mark_limb_ball, picture_of_editor,
};

/// The 3D view, in physical pixels of the window.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SceneArea {
    /// Its top left corner.
    pub min_px: Vec2,
    /// Its width and height.
    pub size_px: Vec2,
}

impl SceneArea {
    fn new(viewport: egui::Rect, pixels_per_point: f32) -> Self {
        let corner = |at: egui::Pos2| (Vec2::new(at.x, at.y) * pixels_per_point).round();
        let min_px = corner(viewport.min);
        Self { min_px, size_px: (corner(viewport.max) - min_px).max(Vec2::ONE) }
    }

    /// It as a rectangle of whole pixels.
    fn area(&self) -> egui::Rect {
        let max_px = self.min_px + self.size_px;
        egui::Rect::from_min_max(egui::pos2(self.min_px.x, self.min_px.y), egui::pos2(max_px.x, max_px.y))
    }

    /// Whether a pixel of the window is in it.
    #[must_use]
    pub fn contains(&self, at_px: Vec2) -> bool {
        let inside = at_px - self.min_px;
        inside.cmpge(Vec2::ZERO).all() && inside.cmplt(self.size_px).all()
    }
}

/// What the pointer lights up over the scene.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Lit {
    /// What a click would take.
    pub part: Option<Part>,
    /// The dot of the motion path that a press would take.
    pub dot: Option<PathDot>,
    /// The handle that a press would take.
    pub handle: Option<Handle>,
    /// The ball at a limb's end that a press would take, or that is held.
    pub ball: Option<LimbBall>,
    /// A node of the robot whose balls show besides those of the chosen nodes.
    pub robot: Option<RbtIndex>,
}

/// Everything that a device belongs to.
pub struct WindowSurface {
    /// The window.
    pub window: Arc<Window>,
    /// The panels' memory.
    pub context: egui::Context,
    /// The panels' input.
    pub input: egui_winit::State,
    /// The system's clipboard.
    pub clipboard: Clipboard,
    /// Where the scene was drawn last.
    pub view: SceneArea,
    gpu: Gpu,
    screen: Screen,
    renderer: Renderer,
    panel_painter: PanelPainter,
    /// What small pictures are made with, once one was wanted.
    thumbnails: Option<(Refiner, Offscreen)>,
    /// What the window shows, without its panels.
    shown: Option<(Frame, Viewport)>,
    pub(super) resting: Option<RestingPicture>,
    /// What the recorded camera's picture is drawn with, once one was wanted.
    inset: Option<InsetPainter>,
}

/// Panels that were laid out and wait to be painted over the scene. All of them must be painted.
pub struct LaidOut {
    /// What the panels ask for.
    pub output: UiOutput,
    /// When the panels want to be shown again.
    pub again_after: Duration,
    shapes: Vec<egui::epaint::ClippedShape>,
    textures: egui::TexturesDelta,
    pixels_per_point: f32,
}

impl Drop for LaidOut {
    fn drop(&mut self) {
        // Textures that were not painted are a fault to egui, and a second panic would end the program before its journal says why.
        if std::thread::panicking() {
            std::mem::forget(std::mem::take(&mut self.textures));
        }
    }
}

impl WindowSurface {
    /// Makes everything for a window. `reader` is what a screen reader reads of it already, where the window is an old one.
    ///
    /// # Errors
    /// [`WindowError::Gpu`]
    pub fn new(
        event_loop: &ActiveEventLoop,
        window: Arc<Window>,
        (gpu, surface): (Gpu, wgpu::Surface<'static>),
        proxy: &EventLoopProxy<UserEvent>,
        reader: Option<egui_winit::accesskit_winit::Adapter>,
    ) -> Result<Self, WindowError> {
        let lost = proxy.clone();
        gpu.device.set_device_lost_callback(move |reason, _| {
            if reason != wgpu::DeviceLostReason::Destroyed {
                // Without a loop there is nothing left to mend.
                let _ = lost.send_event(UserEvent::DeviceLost);
            }
        });
        #[cfg(target_arch = "wasm32")]
        gpu.device.on_uncaptured_error(Arc::new(|error: wgpu::Error| {
            // On a lost device nothing can be made, until the browser gives it back.
            assert!(super::page::is_context_lost(), "{error}");
        }));
        let screen = Screen::new(&gpu, Arc::clone(&window), surface)?;
        let renderer = Renderer::new(&gpu, screen.scene_format(), samples(&gpu));
        let panel_painter = PanelPainter::new(&gpu, screen.format());
        if let Err(error) = gpu.check() {
            // The driver would wait for its work.
            std::mem::forget((gpu, screen, renderer, panel_painter));
            return Err(error.into());
        }
        let context = egui::Context::default();
        theme::install(&context);
        #[expect(clippy::cast_possible_truncation, reason = "scale factors are small")]
        let scale = window.scale_factor() as f32;
        let most = usize::try_from(gpu.largest_side_px()).ok();
        let viewport = egui::ViewportId::ROOT;
        let mut input =
            egui_winit::State::new(context.clone(), viewport, event_loop, Some(scale), window.theme(), most);
        let clipboard = Clipboard::new(&window, &mut input);
        // Before the window shows: a screen reader asks for it from its first moment.
        match reader {
            Some(reader) => input.accesskit = Some(reader),
            None => input.init_accesskit(event_loop, &window, proxy.clone()),
        }
        window.set_visible(true);
        Ok(Self {
            window,
            context,
            input,
            clipboard,
            view: SceneArea::default(),
            gpu,
            screen,
            renderer,
            panel_painter,
            thumbnails: None,
            shown: None,
            resting: None,
            inset: None,
        })
    }

    /// What a report of a fault says, a line a fact.
    pub fn facts(&self) -> String {
        let all = facts::facts().into_iter().chain(adapter_facts(&self.gpu));
        facts::lines(&all.collect::<Vec<_>>())
    }

    /// The surface is configured anew before it is drawn on again.
    pub const fn outdate(&mut self) {
        self.screen.outdate();
    }

    /// Lays out the panels with the input since the last time; the result must be painted. `None` if the window has no size. `cursor`
    /// replaces the pointer's shape over the scene.
    pub fn lay_out(&mut self, ui: &mut Panels, editor: &Editor, cursor: Option<egui::CursorIcon>) -> Option<LaidOut> {
        let size = self.window.inner_size();
        if size.width == 0 || size.height == 0 {
            return None;
        }
        self.screen.resize([size.width, size.height]);
        let raw_input = self.input.take_egui_input(&self.window);
        let mut output = UiOutput::default();
        // The panels may be laid out twice in one go.
        let mut shown = self.context.run_ui(raw_input, |root| {
            output.go_on(ui.show(root, editor));
        });
        if let Some(cursor) = cursor {
            shown.platform_output.cursor_icon = cursor;
        }
        self.clipboard.take(&shown.platform_output);
        self.input.handle_platform_output(&self.window, std::mem::take(&mut shown.platform_output));
        let root = shown.viewport_output.get(&egui::ViewportId::ROOT);
        self.view = SceneArea::new(output.viewport, shown.pixels_per_point);
        Some(LaidOut {
            output,
            again_after: root.map_or(Duration::MAX, |root| root.repaint_delay),
            shapes: std::mem::take(&mut shown.shapes),
            textures: std::mem::take(&mut shown.textures_delta),
            pixels_per_point: shown.pixels_per_point,
        })
    }

    /// Paints the scene as it is now, with what the pointer lights up, and panels over it. `eye` is where it is looked at from, if not from
    /// the editor's eye.
    pub fn paint(&mut self, editor: &Editor, eye: Option<WorkEye>, lit: Lit, mut laid_out: LaidOut, meter: &mut Meter) {
        let start = now();
        let pose = editor.displayed_pose();
        let evaluated = now();
        meter.add(Work::Evaluation, start, evaluated);
        let camera = editor.camera(self.view.size_px);
        let camera = eye.map_or(camera, |eye| Camera { world_from_eye: eye.world_from_eye(), ..camera });
        let mut frame = frame_of_displayed(editor, &pose, &camera);
        if let Some(part) = lit.part {
            light(&mut frame, editor.scene(), part);
        }
        add_limb_balls(&mut frame, editor, lit.robot);
        if let Some(ball) = lit.ball {
            mark_limb_ball(&mut frame, ball);
        }
        if let Some(dot) = lit.dot {
            mark_dot(&mut frame, dot);
        }
        if let Some((gizmo, handle)) = editor.gizmo(&camera).zip(lit.handle) {
            light_handle(&mut frame, editor, &gizmo, handle);
        }
        frame.scale_strokes(laid_out.pixels_per_point);
        let built = now();
        meter.add(Work::Frame, evaluated, built);
        let layout = WindowLayout {
            size_px: self.screen.size_px(),
            scene_px: self.view.area(),
            pixels_per_point: laid_out.pixels_per_point,
            can_copy: self.screen.can_copy_to(),
        };
        let shapes = std::mem::take(&mut laid_out.shapes);
        let cut = self.panel_painter.update(&self.gpu, &self.context, shapes, &mut laid_out.textures, layout);
        meter.add(Work::Ui, built, cut);
        self.draw(frame);
        self.panel_painter.free(&mut laid_out.textures);
        meter.add(Work::Drawing, cut, now());
    }

    fn draw(&mut self, frame: Frame) {
        let Some(picture) = self.screen.next(&self.gpu) else { return };
        let texture = picture.texture();
        let view =
            |format| texture.create_view(&wgpu::TextureViewDescriptor { format: Some(format), ..Default::default() });
        let mut encoder = self.gpu.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        let viewport = viewport(self.view, self.screen.size_px());
        let target = Target { view: &view(self.screen.scene_format()), viewport };
        match self.resting.as_mut().and_then(|resting| resting.of(&frame, viewport)) {
            Some(refiner) => refiner.show(&self.gpu, &mut encoder, &frame, target),
            None => self.renderer.encode(&self.gpu, &mut encoder, &frame, target),
        }
        self.shown = Some((frame, viewport));
        let before = self.panel_painter.draw(&self.gpu, &mut encoder, texture, &view(self.screen.format()));
        self.screen.show(&self.gpu, picture, before, encoder);
    }

    /// Adds a sub-frame of what the window shows.
    pub fn refine(&mut self) -> Option<Next> {
        let (gpu, format) = (&self.gpu, self.screen.scene_format());
        let resting = self.resting.get_or_insert_with(|| RestingPicture::new(gpu, format));
        self.shown.as_ref().map(|shown| resting.go_on(gpu, shown))
    }

    /// Starts to draw a small picture, of [`THUMBNAIL_PX`] pixels.
    ///
    /// # Errors
    /// [`GpuError`]
    pub fn begin_thumbnail(&mut self, frame: &Frame) -> Result<(), GpuError> {
        if self.thumbnails.is_none() {
            let [width, height] = THUMBNAIL_PX.map(|side| u32::try_from(side).unwrap_or(1));
            // It is so small that many sub-frames cost nothing.
            let refiner = Refiner::new(&self.gpu, Offscreen::FORMAT, AT_REST);
            self.thumbnails = Some((refiner, Offscreen::new(&self.gpu, width, height)?));
        }
        let (refiner, offscreen) = self.thumbnails.as_mut().expect("it was just made");
        offscreen.begin_refined(&self.gpu, refiner, frame);
        Ok(())
    }

    /// The small picture, if it is there. `None`: it is under way.
    ///
    /// # Errors
    /// [`GpuError`]
    pub fn thumbnail(&mut self) -> Result<Option<Image>, GpuError> {
        let Some((_, offscreen)) = &mut self.thumbnails else { return Ok(None) };
        Ok(offscreen.read_if_there(&self.gpu)?.map(|drawn| drawn.rows().to_image()))
    }

    /// Draws what the recorded camera sees, in a size in pixels, into a texture that panels can show.
    pub fn draw_inset(&mut self, frame: &Frame, size_px: [u32; 2]) -> egui::TextureId {
        let painter = self.inset.get_or_insert_with(|| InsetPainter::new(&self.gpu));
        painter.draw(&self.gpu, &mut self.panel_painter, frame, size_px)
    }

    /// The device, for films of a page.
    #[cfg(target_arch = "wasm32")]
    pub fn device(&self) -> Gpu {
        self.gpu.clone()
    }

    /// Starts to draw a picture of the scene alone, as large as the 3D view.
    ///
    /// # Errors
    /// [`GpuError`]
    pub fn begin_picture(&self, editor: &Editor, has_overlays: bool) -> Result<Offscreen, GpuError> {
        let [width, height] = whole(self.view.size_px);
        let mut refiner = Refiner::new(&self.gpu, Offscreen::FORMAT, AT_REST);
        let frame = picture_of_editor(editor, self.view.size_px, has_overlays);
        let mut offscreen = Offscreen::new(&self.gpu, width, height)?;
        offscreen.begin_refined(&self.gpu, &mut refiner, &frame);
        Ok(offscreen)
    }

    /// The picture that was begun, if it is there. `None`: it is under way.
    ///
    /// # Errors
    /// [`GpuError`]
    pub fn picture(&self, begun: &mut Offscreen) -> Result<Option<Image>, GpuError> {
        Ok(begun.read_if_there(&self.gpu)?.map(|drawn| drawn.rows().to_image()))
    }
}

/// Samples a pixel. WebGL2 cannot read the samples of the outline's mask, so a page has one, and its edges are smoothed.
fn samples(gpu: &Gpu) -> u32 {
    if cfg!(target_arch = "wasm32") { 1 } else { default_samples(gpu.is_software) }
}

fn viewport(view: SceneArea, target_px: [u32; 2]) -> Viewport {
    let [x, y] = whole(view.min_px);
    let [width, height] = whole(view.size_px);
    Viewport { target_px, x, y, width, height }
}

#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "they are whole and not negative")]
const fn whole(pixels: Vec2) -> [u32; 2] {
    [pixels.x as u32, pixels.y as u32]
}
