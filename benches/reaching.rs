//! What it costs to reach with a limb and to keep feet in place: at most 20 µs for a limb's solution.

use std::hint::black_box;
use std::path::PathBuf;
use std::sync::Arc;

use criterion::{Criterion, criterion_group, criterion_main};
use glam::{DQuat, DVec3, Vec3};
use inbetween::editor::{Command, Edit, Editor, GestureCommand, ViewCommand};
use inbetween::limb::{Limb, Stance};
use inbetween::scene::{DEFAULT_SCENE, built_in_scene};

/// Points around a shoulder, some of them out of reach, the same in every run.
fn target(index: u32) -> DVec3 {
    let phase = f64::from(index) * 0.1;
    DVec3::new(phase.sin(), (1.3 * phase).cos(), (0.7 * phase).sin()) * (1.0 + 0.8 * (0.37 * phase).sin())
}

fn solving(criterion: &mut Criterion) {
    let hinged = Limb { upper: DVec3::X * 0.7, lower: DVec3::X * 0.72, axis: DVec3::NEG_Y, range: [0.0, 2.6] };
    let free = Limb::free(DVec3::X * 0.7, DVec3::new(0.5, 0.3, 0.1), DVec3::Y);
    let mut group = criterion.benchmark_group("reach");
    for (name, limb) in [("hinge", hinged), ("no limits", free)] {
        group.bench_function(name, |bencher| {
            let mut stance = Stance { root: DQuat::IDENTITY, angle: limb.range[0] };
            let mut index = 0;
            bencher.iter(|| {
                index += 1;
                stance = limb.reach(black_box(stance), target(index));
                stance
            });
        });
    }
    group.bench_function("turned to face", |bencher| {
        let stance = hinged.reach(Stance { root: DQuat::IDENTITY, angle: 0.0 }, target(3));
        let wanted = DQuat::from_rotation_y(0.4);
        bencher.iter(|| hinged.facing(black_box(stance), DQuat::IDENTITY, wanted));
    });
}

/// Whole commands of a drag, with all that an editor does around the solution.
fn commands(criterion: &mut Criterion) {
    let scene = Arc::new(built_in_scene(DEFAULT_SCENE).expect("it is built in"));
    let editor = || {
        let mut editor = Editor::new(Arc::clone(&scene), PathBuf::from("animation.json"));
        editor.apply(Command::Gesture(GestureCommand::Begin)).expect("nothing plays");
        editor
    };
    let find = |path: &str| scene.find_rbt(path).expect("the scene has it");
    let (elbow, robot) = (find("robot1/right_shoulder/right_elbow"), find("robot1"));
    let mut group = criterion.benchmark_group("commands of a drag");
    group.bench_function("reach", |bencher| {
        let (mut editor, mut index) = (editor(), 0);
        bencher.iter(|| {
            index += 1;
            let target = target(index).as_vec3() + Vec3::new(-1.5, 1.75, 0.0);
            editor.apply(Command::Edit(Edit::Reach(elbow, target)))
        });
    });
    group.bench_function("move a body whose feet stay", |bencher| {
        let (mut editor, mut index) = (editor(), 0_u16);
        editor.apply(Command::View(ViewCommand::SetKeepFeet(true))).expect("it can be switched on");
        bencher.iter(|| {
            index = index.wrapping_add(1);
            let at = Vec3::new(-2.0, 0.8 + 0.15 * (f32::from(index) * 0.1).sin(), 0.0);
            editor.apply(Command::Edit(Edit::SetTranslation(robot, at)))
        });
    });
}

criterion_group! {
    name = benches;
    config = Criterion::default().sample_size(20);
    targets = solving, commands
}
criterion_main!(benches);
