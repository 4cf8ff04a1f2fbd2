//! Goals 1 to 3: poses, and where they put every node in the world.

use std::hint::black_box;

use glam::{Affine3A, Quat, Vec3};
use inbetween::blend::{self, Level, Weights};
use inbetween::interpolation::{ControlPoints, Interpolation, TangentDivisors, rbt_control_points};
use inbetween::keyframe::{Keyframe, KeyframeList, PlayRange};
use inbetween::pose::{Pose, RbtIndex};
use inbetween::rbt::Rbt;
use inbetween::scene::{SceneBuilder, SceneGraph};

use crate::report::{Report, in_turn};

const MANY: usize = 10_000;
const FEW: usize = 22;
const MILLION: usize = 1_000_000;

/// A pose in which every node stands in its own way.
pub fn rbts(nodes: usize, keyframe: usize) -> Vec<Rbt> {
    let rbt = |node: usize| {
        let phase = (keyframe * 7 + node * 13) as f32;
        let axis = Vec3::new(phase.sin(), (1.3 * phase).cos(), (0.7 * phase).sin() + 0.1).normalize();
        Rbt::new(axis * 3.0, Quat::from_axis_angle(axis, phase))
    };
    (0..nodes).map(rbt).collect()
}

fn keyframes(nodes: usize) -> KeyframeList {
    KeyframeList::new((0..5).map(|keyframe| Keyframe::new(Pose::new(rbts(nodes, keyframe)))).collect())
}

/// Fractions that change from call to call.
struct Fractions(u32);

impl Fractions {
    fn next(&mut self) -> f32 {
        self.0 = (self.0 + 7) % 97;
        (self.0 as f32 + 0.5) / 97.0
    }
}

/// The plain loop: glam's lerp and slerp, one node after the other.
fn glam_loop(from: &[Rbt], to: &[Rbt], alpha: f32, into: &mut [Rbt]) {
    for ((from, to), into) in from.iter().zip(to).zip(into) {
        *into = Rbt::new(from.translation.lerp(to.translation, alpha), from.rotation.slerp(to.rotation, alpha));
    }
}

/// 1. Linear poses.
pub fn linear(report: &mut Report) {
    for (nodes, repeats, least) in [(MANY, 1, None), (FEW, 400, Some(1.0))] {
        let list = keyframes(nodes);
        let range = PlayRange::new(&list).expect("it is long enough");
        let (from, to) = (rbts(nodes, 1), rbts(nodes, 2));
        let (mut plain, mut pose) = (from.clone(), Pose::identity(0));
        let (mut alpha, mut key_time) = (Fractions(0), Fractions(0));
        let [ours, theirs] = in_turn(
            400,
            [
                &mut || {
                    for _ in 0..repeats {
                        let key_time = f64::from(key_time.next());
                        range.pose_into(key_time, Interpolation::Linear, &mut pose).expect("it is in the range");
                        black_box(&mut pose);
                    }
                },
                &mut || {
                    for _ in 0..repeats {
                        glam_loop(&from, &to, alpha.next(), &mut plain);
                        black_box(&mut plain);
                    }
                },
            ],
        );
        let (name, usual) = widest();
        report.at_least(&format!("linear poses of {nodes} nodes, {name}"), ours, theirs, least.unwrap_or(usual));
    }
    #[cfg(target_arch = "x86_64")]
    if let (Level::Avx512(_), Some(avx2)) = (blend::widest(), blend::widest().as_avx2()) {
        let [from_pose, to_pose] = [1, 2].map(|keyframe| Pose::new(rbts(MANY, keyframe)));
        let (from, to) = (rbts(MANY, 1), rbts(MANY, 2));
        let (mut plain, mut blocks) = (from.clone(), from_pose.blocks().to_vec());
        let mut alpha = Fractions(0);
        let mut alphas = Fractions(0);
        let [ours, theirs] = in_turn(
            400,
            [
                &mut || {
                    let weights = Weights::at(alphas.next());
                    blend::linear(Level::Avx2(avx2), &weights, from_pose.blocks(), to_pose.blocks(), &mut blocks);
                    black_box(&mut blocks);
                },
                &mut || {
                    glam_loop(&from, &to, alpha.next(), &mut plain);
                    black_box(&mut plain);
                },
            ],
        );
        report.at_least(&format!("linear poses of {MANY} nodes, AVX2"), ours, theirs, 14.0);
    }
}

/// What this processor's instructions are called, and how many times as fast linear poses are to be with them.
fn widest() -> (&'static str, f64) {
    #[cfg(target_arch = "x86_64")]
    if matches!(blend::widest(), Level::Avx512(_)) {
        return ("AVX-512", 18.0);
    }
    #[cfg(target_arch = "x86_64")]
    if matches!(blend::widest(), Level::Avx2(_)) {
        return ("AVX2", 14.0);
    }
    ("128 bits", 1.0)
}

/// 2. Catmull-Rom poses, beside six of glam's slerps for each node with control points made before.
pub fn catmull_rom(report: &mut Report) {
    let list = keyframes(MANY);
    let range = PlayRange::new(&list).expect("it is long enough");
    let c = [0, 1, 2, 3].map(|keyframe| rbts(MANY, keyframe));
    let inner: Vec<ControlPoints<Rbt>> = (0..MANY)
        .map(|node| rbt_control_points(c.each_ref().map(|rbts| rbts[node]), TangentDivisors::UNIFORM))
        .collect();
    let (mut plain, mut pose) = (c[1].clone(), Pose::identity(0));
    let (mut alpha, mut key_time) = (Fractions(0), Fractions(0));
    let [ours, theirs] = in_turn(
        200,
        [
            &mut || {
                let key_time = f64::from(key_time.next());
                range.pose_into(key_time, Interpolation::CatmullRom, &mut pose).expect("it is in the range");
                black_box(&mut pose);
            },
            &mut || {
                let alpha = alpha.next();
                let blend = |from: Rbt, to: Rbt| {
                    Rbt::new(from.translation.lerp(to.translation, alpha), from.rotation.slerp(to.rotation, alpha))
                };
                for (((start, inner), end), into) in c[1].iter().zip(&inner).zip(&c[2]).zip(&mut plain) {
                    let middle = blend(inner.after_start, inner.before_end);
                    let early = blend(blend(*start, inner.after_start), middle);
                    *into = blend(early, blend(middle, blend(inner.before_end, *end)));
                }
                black_box(&mut plain);
            },
        ],
    );
    report.at_least(&format!("Catmull-Rom poses of {MANY} nodes"), ours, theirs, 18.0);
}

/// A tree of RBT nodes, three below each.
pub fn tree(count: usize) -> SceneGraph {
    fn below(builder: &mut SceneBuilder, place: usize, count: usize) {
        if place < count {
            builder.open_rbt(&format!("n{place}"), Rbt::IDENTITY).expect("a name of its own");
            (1..=3).for_each(|child| below(builder, 3 * place + child, count));
            builder.close();
        }
    }
    let mut builder = SceneBuilder::new();
    below(&mut builder, 0, count);
    builder.finish("tree", &["n0".to_owned()], 1.0).expect("a scene")
}

/// 3. Poses and world matrices together, and the traffic of a million nodes.
pub fn worlds(report: &mut Report) {
    for (nodes, rounds) in [(MANY, 300), (MILLION, 15)] {
        let scene = tree(nodes);
        let list = keyframes(nodes);
        let range = PlayRange::new(&list).expect("it is long enough");
        let parents: Vec<Option<usize>> = (0..nodes)
            .map(|rbt| scene.node(scene.rbt_node(RbtIndex::new(rbt))).parent.map(inbetween::scene::NodeId::get))
            .collect();
        let (from, to) = (rbts(nodes, 1), rbts(nodes, 2));
        let (mut plain, mut pose) = (from.clone(), Pose::identity(0));
        let (mut plain_world, mut world) = (vec![Affine3A::IDENTITY; nodes], Vec::new());
        let (mut alpha, mut key_time) = (Fractions(0), Fractions(0));
        // Two poses read, one written, matrices written and parents read: the same bytes, as plainly as can be.
        let floats = pose_floats(nodes);
        let (left, right, places) = (vec![1.0_f32; floats], vec![2.0_f32; floats], vec![1_u32; nodes]);
        let (mut sums, mut matrices) = (vec![0.0_f32; floats], vec![Affine3A::IDENTITY; nodes]);
        let [ours, theirs, traffic] = in_turn(
            rounds,
            [
                &mut || {
                    let key_time = f64::from(key_time.next());
                    range.pose_into(key_time, Interpolation::Linear, &mut pose).expect("it is in the range");
                    scene.world_from_nodes_into(&pose, 0.0, &mut world);
                    black_box((&mut pose, &mut world));
                },
                &mut || {
                    glam_loop(&from, &to, alpha.next(), &mut plain);
                    for (place, rbt) in plain.iter().enumerate() {
                        let parent_from_node = Affine3A::from_rotation_translation(rbt.rotation, rbt.translation);
                        plain_world[place] = match parents[place] {
                            Some(parent) => plain_world[parent] * parent_from_node,
                            None => parent_from_node,
                        };
                    }
                    black_box((&mut plain, &mut plain_world));
                },
                &mut || {
                    for ((sum, left), right) in sums.iter_mut().zip(&left).zip(&right) {
                        *sum = left + right;
                    }
                    for (matrix, place) in matrices.iter_mut().zip(&places) {
                        matrix.translation.x = *place as f32;
                        matrix.matrix3 = glam::Mat3A::IDENTITY;
                    }
                    black_box((&mut sums, &mut matrices));
                },
            ],
        );
        if nodes == MANY {
            report.at_most(
                &format!("poses and matrices of {nodes} nodes beside the loop and the walk"),
                ours,
                theirs,
                0.2,
            );
        } else {
            report.at_most(&format!("poses and matrices of {nodes} nodes beside plain traffic"), ours, traffic, 1.5);
        }
    }
}

fn pose_floats(nodes: usize) -> usize {
    7 * nodes
}
