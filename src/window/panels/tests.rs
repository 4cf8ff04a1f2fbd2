//! What is kept of the panels against panels that are all drawn anew.

use std::path::PathBuf;
use std::sync::{Arc, mpsc};

use egui::{Event, Modifiers, PointerButton, RawInput, TexturesDelta, vec2};

use super::*;
use crate::editor::{Command, Edit, Editor, PlaybackCommand, WindowCommand};
use crate::scene::{DEFAULT_SCENE, built_in_scene};
use crate::settings::Settings;
use crate::ui::{Panels, theme};

const SIZE_PX: [u32; 2] = [1024, 640];
const FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8Unorm;

/// Panels without a window.
struct Bench {
    gpu: Gpu,
    context: Context,
    editor: Editor,
    ui: Panels,
}

/// The panels of one layout.
struct Layout {
    shapes: Vec<ClippedShape>,
    textures: TexturesDelta,
    window: WindowLayout,
}

impl Drop for Layout {
    fn drop(&mut self) {
        self.textures.clear();
    }
}

impl Bench {
    fn new() -> Self {
        let scene = built_in_scene(DEFAULT_SCENE).expect("the default scene is built in");
        let mut editor = Editor::new(Arc::new(scene), PathBuf::from("walk.json"));
        for _ in 0..8 {
            editor.apply(Command::Edit(Edit::CreateKeyframe)).expect("a keyframe can be made");
        }
        let context = Context::default();
        theme::install(&context);
        Self { gpu: Gpu::headless().expect("an adapter"), context, editor, ui: Panels::new() }
    }

    fn lay_out(&mut self, events: Vec<Event>, pixels_per_point: f32, can_copy: bool) -> Layout {
        let window = vec2(super::pixels(SIZE_PX[0]), super::pixels(SIZE_PX[1])) / pixels_per_point;
        let mut input =
            RawInput { screen_rect: Some(Rect::from_min_size(Pos2::ZERO, window)), events, ..RawInput::default() };
        input.viewports.entry(egui::ViewportId::ROOT).or_default().native_pixels_per_point = Some(pixels_per_point);
        let mut scene = Rect::NOTHING;
        let mut shown = self.context.run_ui(input, |root| scene = self.ui.show(root, &self.editor).viewport);
        assert_eq!(shown.pixels_per_point, pixels_per_point);
        let scene = scene * pixels_per_point;
        let layout = WindowLayout {
            size_px: SIZE_PX,
            scene_px: Rect::from_min_max(scene.min.round(), scene.max.round()),
            pixels_per_point,
            can_copy,
        };
        Layout {
            shapes: std::mem::take(&mut shown.shapes),
            textures: std::mem::take(&mut shown.textures_delta),
            window: layout,
        }
    }

    /// The window's pixels after an update, over a scene of one colour.
    fn picture(&self, panels: &mut PanelPainter, layout: &Layout) -> Vec<u8> {
        let Gpu { device, queue, .. } = &self.gpu;
        let mut textures = layout.textures.clone();
        panels.update(&self.gpu, &self.context, layout.shapes.clone(), &mut textures, layout.window);
        let [width, height] = SIZE_PX;
        let texture = device.create_texture(&wgpu::TextureDescriptor {
            label: None,
            size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: FORMAT,
            usage: wgpu::TextureUsages::RENDER_ATTACHMENT
                | wgpu::TextureUsages::COPY_SRC
                | wgpu::TextureUsages::COPY_DST,
            view_formats: &[],
        });
        let view = texture.create_view(&wgpu::TextureViewDescriptor::default());
        let buffer = device.create_buffer(&wgpu::BufferDescriptor {
            label: None,
            size: u64::from(4 * width * height),
            usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
            mapped_at_creation: false,
        });
        let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        drop(begin_pass(&mut encoder, &view, wgpu::LoadOp::Clear(wgpu::Color { r: 0.2, g: 0.4, b: 0.6, a: 1.0 })));
        let mut buffers = panels.draw(&self.gpu, &mut encoder, &texture, &view);
        let layout = wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(4 * width), rows_per_image: None };
        let into = wgpu::TexelCopyBufferInfo { buffer: &buffer, layout };
        encoder.copy_texture_to_buffer(texture.as_image_copy(), into, texture.size());
        buffers.push(encoder.finish());
        queue.submit(buffers);
        panels.free(&mut textures);
        let (sender, receiver) = mpsc::channel();
        buffer.map_async(wgpu::MapMode::Read, .., move |result| sender.send(result).expect("somebody waits"));
        device.poll(wgpu::PollType::wait_indefinitely()).expect("the device is there");
        receiver.recv().expect("it was mapped").expect("it can be mapped");
        buffer.get_mapped_range(..).expect("it is mapped").to_vec()
    }
}

fn pointer_at(x: f32, y: f32) -> Event {
    Event::PointerMoved(pos2(x, y))
}

fn click(x: f32, y: f32) -> Vec<Event> {
    let button = |pressed| Event::PointerButton {
        pos: pos2(x, y),
        button: PointerButton::Primary,
        pressed,
        modifiers: Modifiers::NONE,
    };
    vec![pointer_at(x, y), button(true), button(false)]
}

/// What happens before a layout.
enum Step {
    Nothing,
    Apply(Command),
    Ask(WindowCommand),
    Events(Vec<Event>),
}

/// A session with playing, hovering, a menu over the scene, a list over everything, and hidden panels.
fn session() -> Vec<Step> {
    use Step::{Apply, Ask, Events, Nothing};
    let mut steps = vec![Nothing, Nothing, Apply(Command::Playback(PlaybackCommand::PlayOrStop))];
    steps.extend((0..6).map(|_| Apply(Command::Playback(PlaybackCommand::Step(3)))));
    steps.extend([Events(vec![pointer_at(900.0, 90.0)]), Nothing]);
    steps.extend([Events(click(80.0, 10.0)), Nothing, Events(vec![pointer_at(100.0, 60.0)]), Nothing, Nothing]);
    steps.extend([Events(click(500.0, 200.0)), Nothing, Nothing]);
    steps.extend([Apply(Command::Undo), Nothing, Apply(Command::Edit(Edit::CreateKeyframe)), Nothing]);
    steps.extend([Ask(WindowCommand::ShowCommands), Nothing, Nothing, Ask(WindowCommand::ToggleStatistics)]);
    let hide = || Apply(Command::View(crate::editor::ViewCommand::TogglePanels));
    steps.extend([hide(), Nothing, hide(), Nothing]);
    steps
}

/// Incremental redraws give the same bytes as full redraws.
#[track_caller]
fn check(pixels_per_point: f32, can_copy: bool) {
    let mut bench = Bench::new();
    let mut settings = Settings::default();
    let (mut kept, mut anew) = (PanelPainter::new(&bench.gpu, FORMAT), PanelPainter::new(&bench.gpu, FORMAT));
    for (index, step) in session().into_iter().enumerate() {
        let mut events = Vec::new();
        match step {
            Step::Nothing => {}
            Step::Apply(command) => drop(bench.editor.apply(command)),
            Step::Ask(command) => drop(bench.ui.perform(&command, &mut settings).expect("no keys are changed")),
            Step::Events(all) => events = all,
        }
        let layout = bench.lay_out(events, pixels_per_point, can_copy);
        anew.canvas = None;
        let (kept, anew) = (bench.picture(&mut kept, &layout), bench.picture(&mut anew, &layout));
        let differing = kept.chunks_exact(4).zip(anew.chunks_exact(4)).position(|(kept, anew)| kept != anew);
        let width = SIZE_PX[0] as usize;
        assert_eq!(differing.map(|at| (at % width, at / width)), None, "step {index}: the first pixel that differs");
    }
}

#[test]
fn what_is_kept_is_what_would_be_drawn() {
    check(1.0, true);
}

#[test]
fn also_at_other_scales() {
    check(1.25, true);
}

#[test]
fn also_where_nothing_can_be_copied() {
    check(1.0, false);
}

#[test]
fn playing_fills_little() {
    let mut bench = Bench::new();
    bench.editor.apply(Command::Playback(PlaybackCommand::PlayOrStop)).expect("it plays");
    for _ in 0..4 {
        bench.editor.tick(1);
        bench.lay_out(Vec::new(), 1.0, true);
    }
    let before = bench.lay_out(Vec::new(), 1.0, true);
    bench.editor.tick(1);
    let after = bench.lay_out(Vec::new(), 1.0, true);
    let area: f32 = damage::between(&before.shapes, &after.shapes, 1.0).iter().map(|area| area.area()).sum();
    let window = after.window.window().area();
    assert!(area > 0.0 && area < 0.05 * window, "{:.1} % of the window", 100.0 * area / window);
}
