//! Weights of skins: any number of joints a vertex becomes four, any number of joints a skin at most 256.

use crate::model::{MOST_JOINTS, Skin};
use crate::words::{Message, texts};

use super::document::GltfError;

/// Weights that add up to 1 within this stay what they are.
const SUM_BOUND: f32 = 1e-4;

/// The weights of a primitive's vertices, as they are read.
pub(super) struct Weights {
    joint_count: usize,
    vertices: Vec<Vec<(u32, f32)>>,
}

impl Weights {
    /// No weights yet, of a skin of so many joints.
    pub(super) fn new(joint_count: usize) -> Self {
        Self { joint_count, vertices: Vec::new() }
    }

    /// Adds four joints for each vertex.
    pub(super) fn add(&mut self, joints: Vec<[u32; 4]>, weights: Vec<[f32; 4]>) {
        self.vertices.resize_with(joints.len(), Vec::new);
        for (vertex, (joints, weights)) in self.vertices.iter_mut().zip(joints.into_iter().zip(weights)) {
            vertex.extend(joints.into_iter().zip(weights).filter(|(_, weight)| *weight != 0.0));
        }
    }

    /// The skin without its matrices, and which of the joints it has; `None` if there were no weights.
    ///
    /// # Errors
    /// [`GltfError`]: weights that are none, joints that there are not, too many joints.
    pub(super) fn finish(self, at: &str, notes: &mut Vec<Message>) -> Result<Option<(Skin, Vec<usize>)>, GltfError> {
        if self.vertices.is_empty() {
            return Ok(None);
        }
        let mut is_used = vec![false; self.joint_count];
        let mut normalised = 0_usize;
        let mut has_dropped = false;
        let mut four = Vec::with_capacity(self.vertices.len());
        for (index, mut vertex) in self.vertices.into_iter().enumerate() {
            let sum: f32 = vertex.iter().map(|(_, weight)| weight).sum();
            if vertex.iter().any(|(_, weight)| *weight < 0.0) || !sum.is_finite() || sum < SUM_BOUND {
                let weights: Vec<f32> = vertex.iter().map(|(_, weight)| *weight).collect();
                // Joints of no weight are left out by now.
                let weights = if weights.is_empty() { "0".to_owned() } else { format!("{weights:?}") };
                return Err(GltfError::new(at, texts::gltf_weights(index, weights)));
            }
            if let Some((joint, _)) = vertex.iter().find(|(joint, _)| *joint as usize >= self.joint_count) {
                return Err(GltfError::new(at, texts::gltf_joint(index, *joint, self.joint_count)));
            }
            let is_off = (sum - 1.0).abs() > SUM_BOUND;
            normalised += usize::from(is_off);
            let is_dropped = vertex.len() > 4;
            if is_dropped {
                has_dropped = true;
                vertex.sort_by(|(_, a), (_, b)| b.total_cmp(a));
                vertex.truncate(4);
            }
            if is_off || is_dropped {
                let sum: f32 = vertex.iter().map(|(_, weight)| weight).sum();
                for (_, weight) in &mut vertex {
                    *weight /= sum;
                }
            }
            for (joint, _) in &vertex {
                is_used[*joint as usize] = true;
            }
            four.push(vertex);
        }
        if normalised > 0 {
            notes.push(texts::gltf_note_weights_normalised(at, normalised));
        }
        if has_dropped {
            notes.push(texts::gltf_note_weights_four(at));
        }
        // A skin of few joints keeps them all, so that its list is the file's.
        let keeps_all = self.joint_count <= MOST_JOINTS;
        let used: Vec<usize> = (0..self.joint_count).filter(|joint| keeps_all || is_used[*joint]).collect();
        if used.len() > MOST_JOINTS {
            return Err(GltfError::new(at, texts::gltf_too_many_joints(used.len(), MOST_JOINTS)));
        }
        let mut place = vec![0_u8; self.joint_count];
        used.iter().enumerate().for_each(|(new, joint)| place[*joint] = new as u8);
        let mut skin = Skin { joints: Vec::new(), weights: Vec::new(), joint_from_shape: Vec::new() };
        for vertex in four {
            let mut joints = [0; 4];
            let mut weights = [0.0; 4];
            for (slot, (joint, weight)) in vertex.into_iter().enumerate() {
                joints[slot] = place[joint as usize];
                weights[slot] = weight;
            }
            skin.joints.push(joints);
            skin.weights.push(weights);
        }
        Ok(Some((skin, used)))
    }
}
