//! What it costs to sample poses and to read and write files: simple numbers to compare within one run.

use std::hint::black_box;

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use glam::{Quat, Vec3};
use inbetween::interpolation::Interpolation;
use inbetween::keyframe::{Keyframe, KeyframeList, PlayRange, keyframes_from_json, keyframes_to_json};
use inbetween::pose::Pose;
use inbetween::rbt::Rbt;
use inbetween::scene::{DEFAULT_SCENE, SceneGraph, built_in_scene};

/// Keyframes that differ in every node, the same in every run.
fn keyframes(count: usize, nodes: usize) -> KeyframeList {
    let rbt = |keyframe: usize, node: usize| {
        let phase = (keyframe * 7 + node * 13) as f32;
        let axis = Vec3::new(phase.sin(), (1.3 * phase).cos(), (0.7 * phase).sin() + 0.1).normalize();
        Rbt::new(axis * 3.0, Quat::from_axis_angle(axis, phase))
    };
    let pose = |keyframe| Pose::new((0..nodes).map(|node| rbt(keyframe, node)).collect());
    KeyframeList::new((0..count).map(|keyframe| Keyframe::new(pose(keyframe))).collect())
}

/// Catmull-Rom is to cost at most eight times what linear does.
fn sampling(criterion: &mut Criterion) {
    for nodes in [22, 10_000] {
        let list = keyframes(6, nodes);
        let range = PlayRange::new(&list).expect("six keyframes play");
        let mut group = criterion.benchmark_group(format!("sample {nodes} nodes"));
        group.throughput(Throughput::Elements(nodes as u64));
        for interpolation in Interpolation::ALL {
            group.bench_function(BenchmarkId::from_parameter(interpolation.name()), |bencher| {
                let mut key_time = 0.0;
                bencher.iter(|| {
                    key_time = (key_time + 1.0 / 120.0) % 3.0;
                    black_box(range.pose_at(key_time, interpolation))
                });
            });
        }
    }
}

fn files(criterion: &mut Criterion) {
    let scene: SceneGraph = built_in_scene(DEFAULT_SCENE).expect("it is built in");
    let list = keyframes(1000, scene.rbt_count());
    let text = keyframes_to_json(&scene, &list, Interpolation::Linear, 2000);
    let mut group = criterion.benchmark_group("keyframe file, 1000 keyframes of 22 nodes");
    group.throughput(Throughput::Bytes(text.len() as u64));
    group.bench_function("read", |bencher| bencher.iter(|| keyframes_from_json(black_box(text.as_bytes()), &scene)));
    group.bench_function("write", |bencher| {
        bencher.iter(|| keyframes_to_json(&scene, black_box(&list), Interpolation::Linear, 2000));
    });
}

criterion_group! {
    name = benches;
    config = Criterion::default().sample_size(20);
    targets = sampling, files
}
criterion_main!(benches);
