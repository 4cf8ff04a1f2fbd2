//! The textures that a picture needs besides its target, reused while the size stays the same.

use crate::render::pipelines::{DEPTH_FORMAT, Kind, MASK_FORMAT, Pipelines};

/// Depth, the samples before they are resolved, and the outline's mask.
#[derive(Debug)]
pub struct Targets {
    /// Width and height in pixels.
    pub size_px: [u32; 2],
    sample_count: u32,
    /// The depth buffer.
    pub depth: wgpu::TextureView,
    /// The samples, if there are several per pixel.
    pub samples: Option<wgpu::TextureView>,
    /// The outline's mask, once there was an outline.
    pub mask: Option<Mask>,
}

/// The outline's mask.
#[derive(Debug)]
pub struct Mask {
    /// The mask with as many samples per pixel as the picture.
    pub view: wgpu::TextureView,
    /// The mask as the outline shader reads it.
    pub bind_group: wgpu::BindGroup,
}

impl Targets {
    /// Textures for a target of this size in pixels.
    pub fn new(device: &wgpu::Device, format: wgpu::TextureFormat, samples: u32, size_px: [u32; 2]) -> Self {
        let attachment = wgpu::TextureUsages::RENDER_ATTACHMENT;
        Self {
            size_px,
            sample_count: samples,
            depth: texture_view(device, "depth", DEPTH_FORMAT, samples, size_px, attachment),
            samples: (samples > 1).then(|| texture_view(device, "samples", format, samples, size_px, attachment)),
            mask: None,
        }
    }

    /// A colour and a depth target of one pixel.
    pub fn one_pixel(device: &wgpu::Device, format: wgpu::TextureFormat) -> [wgpu::TextureView; 2] {
        let target = |format| texture_view(device, "pixel", format, 1, [1, 1], wgpu::TextureUsages::RENDER_ATTACHMENT);
        [target(format), target(DEPTH_FORMAT)]
    }

    /// The outline's mask, created on first use.
    pub fn mask(&mut self, device: &wgpu::Device, pipelines: &Pipelines) -> &Mask {
        let (size_px, sample_count) = (self.size_px, self.sample_count);
        self.mask.get_or_insert_with(|| {
            let attachment = wgpu::TextureUsages::RENDER_ATTACHMENT;
            let readable = attachment | wgpu::TextureUsages::TEXTURE_BINDING;
            let view = texture_view(device, "mask", MASK_FORMAT, sample_count, size_px, readable);
            let bind_group = device.create_bind_group(&wgpu::BindGroupDescriptor {
                label: Some("mask"),
                layout: &pipelines.mask_layout,
                entries: &[wgpu::BindGroupEntry { binding: 0, resource: wgpu::BindingResource::TextureView(&view) }],
            });
            Mask { view, bind_group }
        })
    }
}

/// Shadow maps of several sizes, the current one last: boxes change while shapes move, and the same sizes recur.
#[derive(Debug, Default)]
pub struct SunMaps(Vec<SunMap>);

/// A map is large if it may have this many texels along its longest side.
const LARGE_TEXELS: u32 = 768;
/// The number of maps that are kept.
const KEPT_MAPS: usize = 4;

impl SunMaps {
    /// Makes the map of a size current, for pictures whose maps have at most `most_texels` along the longest side. Its content belongs to
    /// another box. Without a size any map is current: shaders bind one even if nothing casts a shadow.
    pub fn take(
        &mut self,
        device: &wgpu::Device,
        pipelines: &Pipelines,
        most_texels: u32,
        size_texels: Option<[u32; 2]>,
    ) {
        if size_texels.is_none() && !self.0.is_empty() {
            return;
        }
        let size_texels = size_texels.unwrap_or([1, 1]);
        let kind = if most_texels < LARGE_TEXELS { Kind::Shadow } else { Kind::LargeShadow };
        let index = self.0.iter().position(|map| (map.kind, map.size_texels) == (kind, size_texels));
        let map = match index {
            Some(index) => self.0.remove(index),
            None => SunMap::new(device, pipelines, kind, size_texels),
        };
        if self.0.len() == KEPT_MAPS {
            self.0.remove(0);
        }
        self.0.push(map);
    }

    /// The current map; `None` before the first.
    pub fn in_use(&self) -> Option<&SunMap> {
        self.0.last()
    }
}

/// A shadow map.
#[derive(Debug)]
pub struct SunMap {
    /// Width and height in texels.
    pub size_texels: [u32; 2],
    /// The pipeline that draws it.
    pub kind: Kind,
    /// The view that it is drawn into.
    pub view: wgpu::TextureView,
    /// The bind group of the map and its sampler, for shapes.
    pub bind_group: wgpu::BindGroup,
}

impl SunMap {
    fn new(device: &wgpu::Device, pipelines: &Pipelines, kind: Kind, size_texels: [u32; 2]) -> Self {
        let usage = wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::TEXTURE_BINDING;
        let view = texture_view(device, "sun map", kind.depth_format(), 1, size_texels, usage);
        let sampler = device.create_sampler(&wgpu::SamplerDescriptor {
            label: Some("sun map"),
            mag_filter: wgpu::FilterMode::Linear,
            min_filter: wgpu::FilterMode::Linear,
            compare: Some(wgpu::CompareFunction::LessEqual),
            ..Default::default()
        });
        let bind_group = device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("sun map"),
            layout: &pipelines.sun_map_layout,
            entries: &[
                wgpu::BindGroupEntry { binding: 0, resource: wgpu::BindingResource::TextureView(&view) },
                wgpu::BindGroupEntry { binding: 1, resource: wgpu::BindingResource::Sampler(&sampler) },
            ],
        });
        Self { size_texels, kind, view, bind_group }
    }
}

/// A texture, as a view of all of it.
pub fn texture_view(
    device: &wgpu::Device,
    label: &str,
    format: wgpu::TextureFormat,
    sample_count: u32,
    [width, height]: [u32; 2],
    usage: wgpu::TextureUsages,
) -> wgpu::TextureView {
    let texture = device.create_texture(&wgpu::TextureDescriptor {
        label: Some(label),
        size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
        mip_level_count: 1,
        sample_count,
        dimension: wgpu::TextureDimension::D2,
        format,
        usage,
        view_formats: &[],
    });
    texture.create_view(&wgpu::TextureViewDescriptor::default())
}
