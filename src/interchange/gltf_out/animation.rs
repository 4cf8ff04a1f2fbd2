//! The channels of an animation, and the statement of how exact they are.

use serde_json::{Map, Value, json};

use super::fit::Fitted;
use super::keyed::Keyed;
use super::motion::{Motion, Property};
use super::report::{Exactness, Worst};
use super::tree::OWN;
use super::{Curves, Export, Report};
use crate::gltf::{Writer, json as gltf};
use crate::keyframe::{Animation, Easing};

/// Writes the channels of all nodes that are in the file and move, or stand elsewhere than at rest.
pub fn write(
    writer: &mut Writer,
    export: Export<'_>,
    nodes: &[Option<gltf::Index>],
    motions: &[Motion],
    fitted: &Fitted,
    report: &mut Report,
) {
    let mut animation = gltf::Animation { name: Some(name(export)), ..gltf::Animation::default() };
    for (motion, keyed) in motions.iter().zip(&fitted.keyed) {
        let Some(node) = nodes[motion.node] else { continue };
        if keyed.seconds.len() == 1 && is_at_rest(&writer.root.nodes[node], keyed) {
            continue;
        }
        report.keys += keyed.seconds.len();
        report.seconds = report.seconds.max(keyed.seconds.last().copied().unwrap_or_default());
        let sampler = sampler(writer, keyed);
        animation.channels.push(gltf::Channel {
            sampler: animation.samplers.len(),
            target: gltf::ChannelTarget {
                node: Some(node),
                path: keyed.property.path().to_owned(),
                ..gltf::ChannelTarget::default()
            },
        });
        animation.samplers.push(sampler);
    }
    if animation.channels.is_empty() {
        return;
    }
    report.channels = animation.channels.len();
    animation.extras = export.animation.map(|(animation, _)| json!({ OWN: pace(animation) }));
    writer.root.animations.push(animation);
    let exactness = exactness(export, fitted);
    writer.root.asset.extras = Some(json!({ OWN: { "exactness": exactness.json() } }));
    report.exactness = Some(exactness);
}

fn name(export: Export<'_>) -> String {
    export.animation.map_or_else(|| export.scene.name().to_owned(), |(_, name)| name.to_owned())
}

/// Whether the node of a file stands where the only key has it.
fn is_at_rest(node: &gltf::Node, keyed: &Keyed) -> bool {
    let [x, y, z, w] = keyed.values[0].to_array();
    match keyed.property {
        Property::Translation => node.translation.unwrap_or_default() == [x, y, z],
        Property::Rotation => node.rotation.unwrap_or([0.0, 0.0, 0.0, 1.0]) == [x, y, z, w],
        Property::Scale => node.scale.unwrap_or([1.0; 3]) == [x, y, z],
    }
}

fn sampler(writer: &mut Writer, keyed: &Keyed) -> gltf::AnimationSampler {
    let values: Vec<glam::Vec4> = if keyed.tangents.is_empty() {
        keyed.values.clone()
    } else {
        let with_tangents = |(value, [into, out]): (&glam::Vec4, &[glam::Vec4; 2])| [*into, *value, *out];
        keyed.values.iter().zip(&keyed.tangents).flat_map(with_tangents).collect()
    };
    let output = if keyed.property == Property::Rotation {
        writer.animated_rotations(&values)
    } else {
        let values: Vec<glam::Vec3> = values.into_iter().map(glam::Vec4::truncate).collect();
        writer.animated_vectors(&values)
    };
    let interpolation = (!keyed.tangents.is_empty()).then(|| "CUBICSPLINE".to_owned());
    gltf::AnimationSampler { input: writer.times(&keyed.seconds), output, interpolation }
}

/// How the animation plays, as keyframe files say it.
fn pace(animation: &Animation) -> Value {
    let mut pace = Map::new();
    pace.insert("interpolation".to_owned(), json!(animation.interpolation.name()));
    pace.insert("ms_between_keyframes".to_owned(), json!(animation.ms_between_keyframes));
    let keyframes = animation.keyframes.as_slice();
    let played = &keyframes[1..keyframes.len() - 1];
    let starts = &played[..played.len() - 1];
    if starts.iter().any(|keyframe| keyframe.duration != 1.0) {
        pace.insert("durations".to_owned(), starts.iter().map(|keyframe| keyframe.duration).collect());
    }
    if starts.iter().any(|keyframe| keyframe.easing != Easing::Linear) {
        pace.insert("easings".to_owned(), starts.iter().map(|keyframe| keyframe.easing.name()).collect());
    }
    if played.iter().any(|keyframe| keyframe.name.is_some()) {
        pace.insert("names".to_owned(), played.iter().map(|keyframe| json!(keyframe.name.as_deref())).collect());
    }
    pace.into()
}

fn exactness(export: Export<'_>, fitted: &Fitted) -> Exactness {
    let worst = |error: fn(&super::measure::Off) -> (f64, f64)| {
        let of_nodes = fitted.off.iter().map(error).zip(export.scene.nodes());
        let worst = of_nodes.max_by(|((a, _), _), ((b, _), _)| a.total_cmp(b));
        worst.map_or_else(Worst::default, |((off, seconds), node)| Worst { off, node: node.path.clone(), seconds })
    };
    let turned = worst(|off| off.turned);
    Exactness {
        asked: export.frames_per_second.is_none().then_some(export.tolerance),
        is_cubic: export.curves == Curves::Cubic,
        turned: Worst { off: turned.off.to_degrees(), ..turned },
        moved: worst(|off| off.moved),
    }
}
