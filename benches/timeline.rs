//! What the panels cost a frame with 10,000 keyframes of 22 nodes, without a GPU: `cargo bench --bench timeline`.
//!
//! Each frame is laid out and cut into triangles, as it would be for the screen.

use std::hint::black_box;
use std::path::PathBuf;
use std::sync::Arc;

use criterion::{Criterion, criterion_group, criterion_main};
use egui::{Context, Event, PointerButton, Pos2, RawInput, Rect, pos2, vec2};
use glam::{Quat, Vec3};
use inbetween::editor::{Command, Editor, PlaybackCommand, ViewCommand};
use inbetween::keyframe::{Keyframe, KeyframeList, keyframes_to_json};
use inbetween::pose::{Pose, RbtIndex};
use inbetween::rbt::Rbt;
use inbetween::scene::{DEFAULT_SCENE, built_in_scene};
use inbetween::ui::{Panels, theme};

const KEYFRAMES: usize = 10_000;
const SIZE: egui::Vec2 = vec2(1280.0, 800.0);

/// Keyframes in which all nodes move all the time.
fn editor() -> Editor {
    let scene = Arc::new(built_in_scene(DEFAULT_SCENE).expect("it is built in"));
    let rest = scene.rest_pose().to_vec();
    let pose = |place: usize| {
        let angle = place as f32 * 0.01;
        let turned =
            |rbt: &Rbt| Rbt::new(rbt.translation + Vec3::X * angle, rbt.rotation * Quat::from_rotation_x(angle));
        Pose::new(rest.iter().map(turned).collect())
    };
    let list = KeyframeList::new((0..KEYFRAMES).map(|place| Keyframe::new(pose(place))).collect());
    let text = keyframes_to_json(&scene, &list, inbetween::interpolation::Interpolation::CatmullRom, 2000);
    let path = PathBuf::from("long.json");
    let mut editor = Editor::new(scene, path.clone());
    editor.keyframes_read(&path, Ok(text.into_bytes())).expect("it is a keyframe file");
    assert_eq!(editor.document().keyframes.len(), KEYFRAMES);
    editor
}

struct Bench {
    context: Context,
    ui: Panels,
    editor: Editor,
}

impl Bench {
    fn new() -> Self {
        let context = Context::default();
        theme::install(&context);
        let mut panels = Self { context, ui: Panels::new(), editor: editor() };
        for _ in 0..4 {
            panels.frame(Vec::new());
        }
        panels
    }

    /// One frame: laid out, commands applied, cut into triangles. Says how many triangles.
    fn frame(&mut self, events: Vec<Event>) -> usize {
        let input =
            RawInput { screen_rect: Some(Rect::from_min_size(Pos2::ZERO, SIZE)), events, ..RawInput::default() };
        let mut commands = Vec::new();
        let mut output = self.context.run_ui(input, |ui| commands = self.ui.show(ui, &self.editor).commands);
        for command in commands {
            let _ = self.editor.apply(command);
        }
        output.textures_delta.clear();
        let primitives = self.context.tessellate(output.shapes, output.pixels_per_point);
        primitives
            .iter()
            .map(|clipped| match &clipped.primitive {
                egui::epaint::Primitive::Mesh(mesh) => mesh.indices.len() / 3,
                egui::epaint::Primitive::Callback(_) => 0,
            })
            .sum()
    }

    fn click(&mut self, at: Pos2) {
        let button = |pressed| Event::PointerButton {
            pos: at,
            button: PointerButton::Primary,
            pressed,
            modifiers: egui::Modifiers::NONE,
        };
        self.frame(vec![Event::PointerMoved(at)]);
        self.frame(vec![button(true)]);
        self.frame(vec![button(false)]);
        self.frame(Vec::new());
    }
}

fn panels(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("10000 keyframes of 22 nodes");
    group.sample_size(40);

    let mut panels = Bench::new();
    group.bench_function("a still frame", |bencher| bencher.iter(|| black_box(panels.frame(Vec::new()))));

    // The button that fits all stands over the names of the rows.
    panels.click(pos2(144.0, 598.0));
    // Both robots are unfolded, from below.
    panels.click(pos2(12.0, 754.0));
    panels.click(pos2(12.0, 732.0));
    group.bench_function("all in sight, unfolded", |bencher| bencher.iter(|| black_box(panels.frame(Vec::new()))));

    let mut step = 0_u32;
    group.bench_function("scrubbing, all in sight", |bencher| {
        bencher.iter(|| {
            step = (step + 37) % 9000;
            panels
                .editor
                .apply(Command::Playback(PlaybackCommand::Scrub(f64::from(step))))
                .expect("it can be scrubbed");
            black_box(panels.frame(Vec::new()))
        });
    });

    let chosen = RbtIndex::new(2);
    panels.editor.apply(Command::View(ViewCommand::Choose(Some(chosen)))).expect("the scene has it");
    panels.click(pos2(97.0, 598.0));
    group.bench_function("graphs, all in sight", |bencher| bencher.iter(|| black_box(panels.frame(Vec::new()))));
    group.finish();
}

criterion_group!(benches, panels);
criterion_main!(benches);
