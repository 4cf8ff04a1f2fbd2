//! Drawing meshes of triangles.

use bytemuck::cast_slice;

use super::Renderer;
use crate::frame::Frame;
use crate::render::gpu::Gpu;
use crate::render::instances::INSTANCES_START;
use crate::render::pipelines::{Form, Kind};
use crate::render::triangles::{JointRows, Skinning, TriangleDraw};

impl Renderer {
    /// Brings the meshes of a frame to the GPU, and moves their skins.
    pub(super) fn take_meshes(&mut self, gpu: &Gpu, frame: &Frame, is_map_due: bool) {
        let (device, queue) = (&gpu.device, &gpu.queue);
        let has_shader = self.skins.skinning() == Skinning::Shader;
        self.meshes.take(device, queue, &self.pipelines.material_layout, &frame.meshes, has_shader);
        if self.skins.take(frame, &self.arranged, is_map_due) {
            let bytes: &[u8] = cast_slice(&self.skins.vertices);
            let needed = bytes.len() as u64;
            let buffer = self.skinned.take().filter(|buffer| buffer.size() >= needed).unwrap_or_else(|| {
                device.create_buffer(&wgpu::BufferDescriptor {
                    label: Some("skins"),
                    size: needed.next_power_of_two().max(1024),
                    usage: wgpu::BufferUsages::VERTEX | wgpu::BufferUsages::COPY_DST,
                    mapped_at_creation: false,
                })
            });
            queue.write_buffer(&buffer, 0, bytes);
            self.skinned = Some(buffer);
        }
        if has_shader && !frame.world_from_bind.is_empty() {
            let layout = &self.pipelines.joints_layout;
            self.joints = Some(JointRows::with(self.joints.take(), device, queue, layout, &frame.world_from_bind));
        }
    }

    /// Draws meshes of a frame. The caller binds the instances of unit meshes anew.
    pub(super) fn draw_triangles(
        &self,
        device: &wgpu::Device,
        pass: &mut wgpu::RenderPass<'_>,
        frame: &Frame,
        kind: Kind,
        draws: &[TriangleDraw],
    ) {
        for draw in draws {
            let Some(mesh) = self.meshes.get(&frame.meshes[draw.mesh]) else { continue };
            pass.set_pipeline(self.pipelines.of(device, kind, Form::Mesh(mesh.form)));
            pass.set_bind_group(0, &self.globals, &[]);
            pass.set_bind_group(2, &mesh.material, &[]);
            if let (true, Some(joints)) = (mesh.form.is_skinned, &self.joints) {
                pass.set_bind_group(3, &joints.bind_group, &[]);
            }
            mesh.bind(pass, draw, self.skinned.as_ref(), &self.frame_buffer, INSTANCES_START as u64);
            pass.draw_indexed(0..mesh.index_count(), 0, draw.instances.clone());
        }
    }
}
