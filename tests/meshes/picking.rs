//! What a ray meets, against all triangles one by one and against the identity picture.

use glam::Vec3;
use inbetween::model::{TriangleMesh, meets, nearer};
use inbetween::scene::{Ray, SceneGraph};

use super::models::{ball, bar, bent, cube, scene};

/// Numbers from -1 to 1 that look random.
fn noise(state: &mut u32) -> f32 {
    *state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
    (*state >> 8) as f32 / (1 << 23) as f32 - 1.0
}

fn rays(count: u32) -> Vec<Ray> {
    let mut state = 3;
    let mut point = |size: f32| Vec3::new(noise(&mut state), noise(&mut state), noise(&mut state)) * size;
    (0..count)
        .map(|_| {
            let origin_in_world = point(1.0).normalize_or(Vec3::X) * 6.0;
            Ray { origin_in_world, direction_in_world: point(1.4) - origin_in_world }
        })
        .collect()
}

/// The nearest triangle of meshes whose vertices are in world space.
fn one_by_one(meshes: &[(Vec<Vec3>, &TriangleMesh)], ray: Ray) -> Option<f32> {
    let corners = |positions: &[Vec3], mesh: &TriangleMesh| -> Vec<[Vec3; 3]> {
        let corner = |index: u32| positions[index as usize];
        mesh.indices.chunks_exact(3).map(|corners| [0, 1, 2].map(|place| corner(corners[place]))).collect()
    };
    let all = meshes.iter().flat_map(|(positions, mesh)| corners(positions, mesh));
    all.fold(None, |nearest, triangle| nearer(nearest, meets(&triangle, ray.origin_in_world, ray.direction_in_world)))
}

#[track_caller]
fn check(scene: &SceneGraph, meshes: &[(Vec<Vec3>, &TriangleMesh)], least_hits: usize) {
    let mut hits = 0;
    for ray in rays(400) {
        let found = scene.pick(scene.rest_pose(), 0.0, ray).map(|pick| pick.distance);
        match (found, one_by_one(meshes, ray)) {
            (Some(found), Some(expected)) => {
                assert!((found - expected).abs() < 1e-4 * expected.max(1.0), "{found}, expected {expected}");
                hits += 1;
            }
            (found, expected) => {
                // Within rounding of a silhouette it may be either.
                let beside = |by: f32| {
                    let near = Ray { direction_in_world: ray.direction_in_world + Vec3::splat(by), ..ray };
                    one_by_one(meshes, near).is_some()
                };
                let is_at_rim = beside(1e-4) != beside(-1e-4);
                assert!(
                    found.is_some() == expected.is_some() || is_at_rim,
                    "{found:?}, expected {expected:?} for {ray:?}"
                );
            }
        }
    }
    assert!(hits > least_hits, "{hits} hits");
}

#[test]
fn rigid_meshes_are_met_at_their_nearest_triangle() {
    let (ball, cube) = (ball("ball", 12), cube("cube"));
    let nodes = r#"[{"name": "sky"}, {"name": "a", "translation": [0.8, 0, 0], "children": [
        {"name": "ball", "shape": {"mesh": {"name": "ball"}}, "scale": [0.5, 1, 0.7]}]},
        {"name": "b", "translation": [-0.8, 0.2, 0], "children": [{"name": "cube", "shape": {"mesh": {"name": "cube"}}, "scale": 0.5}]}]"#;
    let of_ball = ball.positions.iter().map(|at| *at * Vec3::new(0.5, 1.0, 0.7) + Vec3::X * 0.8).collect();
    let of_cube = cube.positions.iter().map(|at| *at * 0.5 + Vec3::new(-0.8, 0.2, 0.0)).collect();
    check(&scene(&[ball.clone(), cube.clone()], nodes), &[(of_ball, &ball), (of_cube, &cube)], 150);
}

#[test]
fn skins_are_met_as_their_joints_stand_and_give_the_joint_that_was_met() {
    let bar = bar("bar", 16, 12);
    let scene = scene(std::slice::from_ref(&bar), &format!(r#"[{{"name": "sky"}}, {}]"#, bent("arm", 0.0, 60.0)));
    let (id, skin) = scene.nodes_with_ids().find_map(|(id, _)| Some((id, scene.skin(id)?))).expect("it is there");
    let world_from_node = scene.world_from_nodes(scene.rest_pose(), 0.0);
    let joints: Vec<_> = skin.world_from_bind(|joint| world_from_node[joint.get()].get()).collect();
    let vertices: Vec<Vec3> = skin.skinned(&joints).iter().map(|vertex| Vec3::from(vertex.position)).collect();
    let [least, most] = skin.reach_of_skin(&joints);
    assert!(vertices.iter().all(|at| at.cmpge(least - 1e-5).all() && at.cmple(most + 1e-5).all()));
    check(&scene, &[(vertices, &bar)], 40);
    let pick = |at: Vec3| {
        let ray = Ray { origin_in_world: at + Vec3::Z * 5.0, direction_in_world: Vec3::NEG_Z };
        scene.pick(scene.rest_pose(), 0.0, ray).map(|pick| (pick.shape, scene.rbt_path(pick.rbt.expect("a joint"))))
    };
    assert_eq!(pick(Vec3::new(0.0, -1.2, 0.0)), Some((id, "arm")));
    let upper = scene.world_from_rbt(scene.rest_pose(), 0.0, scene.find_rbt("arm/upper").expect("it is there"));
    assert_eq!(pick(upper.transform_point(Vec3::Y)), Some((id, "arm/upper")));
}
