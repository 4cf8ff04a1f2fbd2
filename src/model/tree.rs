//! Where a ray meets triangles: a tree of axis-aligned boxes around them.

use glam::Vec3;

/// So many triangles are tried one by one.
const LEAF: usize = 4;

/// The triangles of a mesh in a tree of boxes.
#[derive(Clone, Debug)]
pub struct TriangleTree {
    /// The root first; the children of a node follow one another.
    nodes: Vec<TreeNode>,
    /// The corners of all triangles, those of a leaf together.
    triangles: Vec<[Vec3; 3]>,
}

#[derive(Clone, Copy, Debug)]
struct TreeNode {
    least: Vec3,
    most: Vec3,
    /// Of a leaf its first triangle, of any other node its first child.
    first: u32,
    /// The number of its triangles; 0 for a node with children.
    count: u32,
}

impl TriangleTree {
    /// A tree of triangles, each by its corners.
    #[must_use]
    pub fn new(triangles: impl Iterator<Item = [Vec3; 3]>) -> Self {
        let mut tree = Self { nodes: Vec::new(), triangles: triangles.collect() };
        if !tree.triangles.is_empty() {
            tree.nodes.push(TreeNode::LEAF);
            tree.split(0, 0, tree.triangles.len());
        }
        tree
    }

    /// Makes the node of an index the root of some triangles. Halves are of equal size, so the tree is as deep as the logarithm.
    fn split(&mut self, node: usize, start: usize, end: usize) {
        let triangles = &mut self.triangles[start..end];
        let corners = || triangles.iter().flatten().copied();
        let (least, most) = (corners().fold(Vec3::INFINITY, Vec3::min), corners().fold(Vec3::NEG_INFINITY, Vec3::max));
        if triangles.len() <= LEAF {
            self.nodes[node] = TreeNode { least, most, first: start as u32, count: (end - start) as u32 };
            return;
        }
        let axis = (most - least).max_position();
        let place = |triangle: &[Vec3; 3]| triangle.iter().map(|corner| corner[axis]).sum::<f32>();
        let half = triangles.len() / 2;
        triangles.select_nth_unstable_by(half, |a, b| place(a).total_cmp(&place(b)));
        let first = self.nodes.len();
        self.nodes.extend([TreeNode::LEAF; 2]);
        self.nodes[node] = TreeNode { least, most, first: first as u32, count: 0 };
        self.split(first, start, start + half);
        self.split(first + 1, start + half, end);
    }

    /// Where a ray first meets a triangle from either side, in lengths of `direction`; above 0.
    #[must_use]
    pub fn enter(&self, origin: Vec3, direction: Vec3) -> Option<f32> {
        let over_direction = direction.recip();
        let mut nearest = None;
        let mut open = vec![0_usize];
        while let Some(node) = open.pop().and_then(|index| self.nodes.get(index)) {
            if !node.may_be_met(origin, over_direction, nearest.unwrap_or(f32::INFINITY)) {
                continue;
            }
            let first = node.first as usize;
            if node.count == 0 {
                open.extend([first, first + 1]);
                continue;
            }
            for triangle in &self.triangles[first..first + node.count as usize] {
                nearest = nearer(nearest, meets(triangle, origin, direction));
            }
        }
        nearest
    }
}

impl TreeNode {
    const LEAF: Self = Self { least: Vec3::ZERO, most: Vec3::ZERO, first: 0, count: 0 };

    /// Whether a ray meets the box nearer than at a distance. A ray within the plane of a face counts as meeting it.
    fn may_be_met(&self, origin: Vec3, over_direction: Vec3, nearest: f32) -> bool {
        may_meet_box(self.least, self.most, origin, over_direction, nearest)
    }
}

/// Whether a ray meets a box nearer than at a distance; `over_direction` is 1 over each part of its direction. A ray within the plane of a
/// face counts as meeting it.
#[must_use]
pub fn may_meet_box(least: Vec3, most: Vec3, origin: Vec3, over_direction: Vec3, nearest: f32) -> bool {
    let (mut enters, mut leaves) = (0.0_f32, nearest);
    for axis in 0..3 {
        let one = (least[axis] - origin[axis]) * over_direction[axis];
        let other = (most[axis] - origin[axis]) * over_direction[axis];
        // `max` and `min` pass over NaN: 0 times infinity, on a face.
        enters = enters.max(one.min(other));
        leaves = leaves.min(one.max(other));
    }
    // A margin against rounding, so that no triangle on a face is missed.
    enters <= leaves * 1.000_001 + f32::MIN_POSITIVE
}

/// The nearer one of two distances.
#[must_use]
pub fn nearer(one: Option<f32>, other: Option<f32>) -> Option<f32> {
    match (one, other) {
        (Some(one), Some(other)) => Some(one.min(other)),
        (one, other) => one.or(other),
    }
}

/// Where a ray meets a triangle from either side, in lengths of `direction`; above 0. After Möller and Trumbore.
#[must_use]
pub fn meets(&[a, b, c]: &[Vec3; 3], origin: Vec3, direction: Vec3) -> Option<f32> {
    let (ab, ac) = (b - a, c - a);
    let across = direction.cross(ac);
    let determinant = ab.dot(across);
    if determinant == 0.0 {
        return None;
    }
    let from_a = origin - a;
    let u = from_a.dot(across) / determinant;
    let along = from_a.cross(ab);
    let v = direction.dot(along) / determinant;
    let distance = ac.dot(along) / determinant;
    (u >= 0.0 && v >= 0.0 && u + v <= 1.0 && distance > 0.0).then_some(distance)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Numbers from -1 to 1 that look random.
    fn noise(state: &mut u32) -> f32 {
        *state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (*state >> 8) as f32 / (1 << 23) as f32 - 1.0
    }

    #[test]
    fn a_ray_meets_what_it_meets_one_by_one() {
        let mut state = 7;
        let mut point = |size: f32| Vec3::new(noise(&mut state), noise(&mut state), noise(&mut state)) * size;
        for count in [0, 1, 4, 5, 300] {
            let triangles: Vec<[Vec3; 3]> = (0..count)
                .map(|_| {
                    let middle = point(3.0);
                    [middle + point(0.6), middle + point(0.6), middle + point(0.6)]
                })
                .collect();
            let tree = TriangleTree::new(triangles.iter().copied());
            let mut hits = 0;
            for _ in 0..500 {
                let (origin, direction) = (point(5.0), point(1.0));
                let expected = triangles.iter().fold(None, |nearest, it| nearer(nearest, meets(it, origin, direction)));
                assert_eq!(tree.enter(origin, direction), expected);
                hits += u32::from(expected.is_some());
            }
            assert!(count < 300 || hits > 50, "{hits} hits");
        }
    }

    #[test]
    fn a_ray_along_a_face_meets_what_stands_in_it() {
        // Flat boxes: the two triangles stand in the plane x = 0, and the ray runs within it.
        let square = [[0.0, -1.0, -1.0], [0.0, 1.0, -1.0], [0.0, 1.0, 1.0], [0.0, -1.0, 1.0]].map(Vec3::from);
        let [a, b, c, d] = square;
        let tree = TriangleTree::new([[a, b, c], [a, c, d]].into_iter());
        assert_eq!(tree.enter(Vec3::new(3.0, 0.5, 0.5), Vec3::NEG_X), Some(3.0));
        assert_eq!(tree.enter(Vec3::new(-3.0, 0.5, 0.5), Vec3::X), Some(3.0), "from behind too");
        assert_eq!(tree.enter(Vec3::new(3.0, 0.5, 0.5), Vec3::X), None);
    }
}
