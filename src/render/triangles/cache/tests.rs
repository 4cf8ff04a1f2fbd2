//! What the cache keeps and what it lets go.

use glam::Vec3;

use super::*;
use crate::render::Gpu;
use crate::render::triangles::material_layout;

struct Bench {
    gpu: Gpu,
    layout: wgpu::BindGroupLayout,
    cache: MeshCache,
}

impl Bench {
    fn new() -> Self {
        let gpu = Gpu::headless().expect("an adapter");
        let layout = material_layout(&gpu.device);
        Self { gpu, layout, cache: MeshCache::default() }
    }

    /// A frame of some meshes, with a bound in bytes.
    fn frame(&mut self, meshes: &[&Arc<TriangleMesh>], most_bytes: u64) {
        let meshes: Vec<Arc<TriangleMesh>> = meshes.iter().map(|mesh| Arc::clone(mesh)).collect();
        self.cache.take_within(most_bytes, &self.gpu.device, &self.gpu.queue, &self.layout, &meshes, false);
    }

    /// How many meshes and textures there are.
    fn kept(&self) -> (usize, usize) {
        (self.cache.meshes.len(), self.cache.textures.len())
    }

    fn bytes(&self) -> u64 {
        self.cache.bytes()
    }
}

fn texture() -> Arc<Texture> {
    Arc::new(Texture {
        file: Arc::default(),
        media_type: "image/png",
        size_px: [2, 2],
        pixels: [255; 16].into(),
        wrap: [Wrap::Repeat; 2],
        is_pixelated: false,
    })
}

fn mesh(texture: Option<&Arc<Texture>>) -> Arc<TriangleMesh> {
    let mut mesh = TriangleMesh::empty("mesh");
    mesh.positions = vec![Vec3::ZERO, Vec3::X, Vec3::Y];
    mesh.normals = vec![Vec3::Z; 3];
    mesh.indices = vec![0, 1, 2];
    mesh.material.texture = texture.cloned();
    Arc::new(mesh)
}

#[test]
fn a_mesh_that_is_still_held_stays_though_no_frame_needs_it() {
    let mut bench = Bench::new();
    let (one, other) = (mesh(Some(&texture())), mesh(None));
    bench.frame(&[&one, &other], u64::MAX);
    assert_eq!(bench.kept(), (2, 1));
    bench.frame(&[&other], u64::MAX);
    assert!(bench.cache.get(&one).is_some());
    assert_eq!(bench.kept(), (2, 1));
}

#[test]
fn a_mesh_that_nobody_else_holds_goes_with_its_texture() {
    let mut bench = Bench::new();
    let (one, other) = (mesh(Some(&texture())), mesh(None));
    bench.frame(&[&one, &other], u64::MAX);
    drop(one);
    bench.frame(&[&other], u64::MAX);
    assert_eq!(bench.kept(), (1, 0));
    // The last one goes in a frame without meshes.
    drop(other);
    bench.frame(&[], u64::MAX);
    assert_eq!((bench.kept(), bench.bytes()), ((0, 0), 0));
}

#[test]
fn a_texture_stays_as_long_as_one_mesh_has_it() {
    let mut bench = Bench::new();
    let shared = texture();
    let (one, other) = (mesh(Some(&shared)), mesh(Some(&shared)));
    drop(shared);
    bench.frame(&[&one, &other], u64::MAX);
    assert_eq!(bench.kept(), (2, 1));
    drop(one);
    bench.frame(&[&other], u64::MAX);
    assert_eq!(bench.kept(), (1, 1));
    drop(other);
    bench.frame(&[], u64::MAX);
    assert_eq!(bench.kept(), (0, 0));
}

#[test]
fn beyond_the_bound_only_what_the_frame_needs_stays() {
    let mut bench = Bench::new();
    let (one, other) = (mesh(Some(&texture())), mesh(Some(&texture())));
    bench.frame(&[&one, &other], u64::MAX);
    let both = bench.bytes();
    bench.frame(&[&one], both);
    assert_eq!(bench.kept(), (2, 2), "the bound itself is allowed");
    bench.frame(&[&one], both - 1);
    assert_eq!(bench.kept(), (1, 1));
    assert!(bench.cache.get(&one).is_some() && bench.cache.get(&other).is_none());
    // What one frame needs is more than the bound, and is there nevertheless; what was let go is made again.
    bench.frame(&[&one, &other], 0);
    assert_eq!((bench.kept(), bench.bytes()), ((2, 2), both));
}
