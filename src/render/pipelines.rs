//! Pipelines, each created on first use: creating one takes milliseconds.

use std::mem::size_of;
use std::sync::OnceLock;

use wgpu::{CompareFunction, ShaderStages, VertexFormat};

use crate::lighting::Lighting;
use crate::render::edges::EdgeLine;
use crate::render::instances::{Instance, Stroke};
use crate::render::light::{CONSTANTS, constants};
use crate::render::mesh::Vertex;
use crate::render::shaders::{self, CORNERS, Corner, SOURCES, Source, Variant};
use crate::render::triangles::{MeshForm, joints_layout, material_layout, surface_buffer, weights_buffer};

/// Depth format of pictures, and of small shadow maps.
pub const DEPTH_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Depth32Float;
/// Depth of a large shadow map: 16 bits, to save memory. One step is at most 0.004 units unless a single shape is longer than the
/// shadow distance. Harmless, because back faces are compared.
const LARGE_MAP_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Depth16Unorm;
/// Meshes of triangles may be open, so both their sides go into the shadow map, pushed away from the sun so that lit faces do not shadow
/// themselves.
const OPEN_SHADOW_BIAS: wgpu::DepthBiasState = wgpu::DepthBiasState { constant: 2, slope_scale: 2.0, clamp: 0.0 };
/// Format of the outline's mask.
pub const MASK_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8Unorm;

/// All pipelines.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Opaque shapes except planes.
    Shape,
    /// Planes, with their grid.
    Plane,
    /// The sky behind everything.
    Sky,
    /// One colour, or nothing, behind everything in a sub-frame.
    Backdrop,
    /// A small shadow map. It has the picture's depth format, so that a software driver need not compile again.
    Shadow,
    /// A large shadow map.
    LargeShadow,
    /// The depth of shapes and planes, whose colours the target has already.
    Depth,
    /// Ghosts' depth, so that only the nearest ghost fragment is blended.
    GhostDepth,
    /// Ghosts' colour.
    Ghost,
    /// Lines in front of everything.
    Line,
    /// Hidden parts of lines, faint.
    LineHidden,
    /// Lines over everything.
    LineOnTop,
    /// Dots over everything.
    Dot,
    /// Outlined shapes, hidden or not.
    MaskAll,
    /// Visible parts of outlined shapes.
    MaskVisible,
    /// The outline around the mask.
    Outline,
    /// Shades on the ground under what stands there, and edges of opaque shapes, smoothed.
    Edge,
    /// Edges of ghosts, smoothed.
    GhostEdge,
}

const COUNT: usize = Kind::GhostEdge as usize + 1;

/// What a pipeline draws.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// Unit meshes, or what is no mesh.
    Unit,
    /// Meshes of triangles.
    Mesh(MeshForm),
}

const FORMS: usize = 1 + MeshForm::COUNT;

impl Form {
    const fn index(self) -> usize {
        match self {
            Self::Unit => 0,
            Self::Mesh(form) => 1 + form.index(),
        }
    }

    /// What transforms vertices.
    pub const fn corner(self) -> Corner {
        match self {
            Self::Unit => Corner::Unit,
            Self::Mesh(MeshForm { is_skinned: true, .. }) => Corner::Skin,
            Self::Mesh(_) => Corner::Mesh,
        }
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Input {
    Instances,
    Strokes,
    Edges,
    Nothing,
}

/// The differences between pipelines.
struct Recipe {
    source: Source,
    vertex: &'static str,
    fragment: Option<&'static str>,
    input: Input,
    /// The depth comparison, and whether depth is written; `None` without depth.
    depth: Option<(CompareFunction, bool)>,
    blend: bool,
}

impl Recipe {
    /// Whether it reads the surface of meshes of triangles, and their material.
    const fn has_surface(&self) -> bool {
        matches!(self.source, Source::Mesh | Source::Masked)
    }
}

impl Kind {
    const fn is_shadow(self) -> bool {
        matches!(self, Self::Shadow | Self::LargeShadow)
    }

    /// Whether triangles are drawn from behind too.
    const fn draws_both_sides(self, form: Form) -> bool {
        let Form::Mesh(form) = form else { return false };
        form.is_double_sided || self.is_shadow() || matches!(self, Self::Ghost | Self::GhostDepth)
    }

    /// The depth format of the target.
    pub const fn depth_format(self) -> wgpu::TextureFormat {
        match self {
            Self::LargeShadow => LARGE_MAP_FORMAT,
            _ => DEPTH_FORMAT,
        }
    }

    /// Whether it draws shapes.
    const fn is_of_shapes(self) -> bool {
        matches!(
            self,
            Self::Shape
                | Self::Shadow
                | Self::LargeShadow
                | Self::Depth
                | Self::GhostDepth
                | Self::Ghost
                | Self::MaskAll
                | Self::MaskVisible
        )
    }

    /// The recipe for meshes of triangles, where it is another.
    fn recipe_of(self, form: MeshForm) -> Recipe {
        let usual = self.recipe();
        let (vertex, fragment) = match self {
            Self::Shape if form.is_masked => {
                let (vertex, fragment) = ("mesh_vertex", Some("masked_mesh_fragment"));
                return Recipe { source: Source::Mesh, vertex, fragment, ..usual };
            }
            Self::Shape => {
                return Recipe {
                    source: Source::Mesh,
                    vertex: "mesh_vertex",
                    fragment: Some("mesh_fragment"),
                    ..usual
                };
            }
            _ if !form.is_masked => return usual,
            Self::Shadow | Self::LargeShadow => ("masked_shadow_vertex", Some("masked_fragment")),
            Self::Depth => ("masked_identity_vertex", Some("masked_fragment")),
            Self::GhostDepth => ("masked_ghost_vertex", Some("masked_fragment")),
            Self::MaskAll | Self::MaskVisible => ("masked_position_vertex", Some("masked_fragment")),
            _ => return usual,
        };
        Recipe { source: Source::Masked, vertex, fragment, ..usual }
    }

    fn recipe(self) -> Recipe {
        use CompareFunction::{Always, Equal, GreaterEqual, Less};
        let shape = |source, vertex, fragment, depth, blend| Recipe {
            source,
            vertex,
            fragment,
            input: Input::Instances,
            depth: Some(depth),
            blend,
        };
        let stroke = |vertex, fragment, compare| Recipe {
            source: Source::Stroke,
            vertex,
            fragment: Some(fragment),
            input: Input::Strokes,
            depth: Some((compare, false)),
            blend: true,
        };
        let screen = |source, vertex, fragment, depth, blend| Recipe {
            source,
            vertex,
            fragment: Some(fragment),
            input: Input::Nothing,
            depth,
            blend,
        };
        let is_ghost = matches!(self, Self::Ghost | Self::GhostEdge);
        match self {
            Self::Shape => shape(Source::Shape, "shape_vertex", Some("shape_fragment"), (GreaterEqual, true), false),
            Self::Plane => shape(Source::Plane, "plane_vertex", Some("plane_fragment"), (GreaterEqual, true), false),
            Self::Sky => screen(Source::Sky, "sky_vertex", "sky_fragment", Some((GreaterEqual, false)), false),
            Self::Backdrop => {
                screen(Source::Sky, "sky_vertex", "backdrop_fragment", Some((GreaterEqual, false)), false)
            }
            Self::Shadow | Self::LargeShadow => shape(
                Source::Silhouette,
                "shadow_vertex",
                Some("shadow_fragment"),
                (CompareFunction::LessEqual, true),
                false,
            ),
            Self::Depth => {
                shape(Source::Silhouette, "depth_vertex", Some("mask_fragment"), (GreaterEqual, true), false)
            }
            Self::GhostDepth => shape(Source::Shape, "ghost_vertex", None, (GreaterEqual, true), false),
            Self::Ghost => shape(Source::Shape, "ghost_vertex", Some("ghost_fragment"), (Equal, false), true),
            Self::Line => stroke("line_vertex", "line_fragment", GreaterEqual),
            Self::LineHidden => stroke("hidden_line_vertex", "line_fragment", Less),
            Self::LineOnTop => stroke("line_vertex", "line_fragment", Always),
            Self::Dot => stroke("dot_vertex", "dot_fragment", Always),
            Self::MaskAll => {
                shape(Source::Silhouette, "position_vertex", Some("mask_fragment"), (Always, false), false)
            }
            Self::MaskVisible => {
                shape(Source::Silhouette, "position_vertex", Some("mask_fragment"), (GreaterEqual, false), false)
            }
            Self::Outline => screen(Source::Outline, "outline_vertex", "outline_fragment", None, true),
            Self::Edge | Self::GhostEdge => Recipe {
                source: Source::Shape,
                vertex: if is_ghost { "ghost_edge_vertex" } else { "edge_vertex" },
                fragment: Some(if is_ghost { "ghost_edge_fragment" } else { "edge_fragment" }),
                input: Input::Edges,
                depth: Some((GreaterEqual, false)),
                blend: true,
            },
        }
    }
}

/// Pipelines for one target format and number of samples.
#[derive(Debug)]
pub struct Pipelines {
    /// The layout of group 0: the globals.
    pub globals_layout: wgpu::BindGroupLayout,
    /// The layout of group 1 for shapes: the sun's map and its sampler.
    pub sun_map_layout: wgpu::BindGroupLayout,
    /// The layout of group 1 for the outline: its mask.
    pub mask_layout: wgpu::BindGroupLayout,
    /// The layout of group 2 for meshes of triangles: their material.
    pub material_layout: wgpu::BindGroupLayout,
    /// The layout of group 3 for skins that the vertex shader moves: their joints.
    pub joints_layout: wgpu::BindGroupLayout,
    target_format: wgpu::TextureFormat,
    samples: u32,
    variant: Variant,
    /// The light of shapes and meshes.
    constants: [(&'static str, f64); CONSTANTS],
    modules: [[OnceLock<wgpu::ShaderModule>; CORNERS]; SOURCES],
    made: [[OnceLock<wgpu::RenderPipeline>; FORMS]; COUNT],
}

impl Pipelines {
    /// A set with no pipelines created.
    pub fn new(device: &wgpu::Device, target_format: wgpu::TextureFormat, samples: u32, variant: Variant) -> Self {
        let layout = |label, entries: &[wgpu::BindGroupLayoutEntry]| {
            device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor { label: Some(label), entries })
        };
        let entry = |binding, visibility, ty| wgpu::BindGroupLayoutEntry { binding, visibility, ty, count: None };
        let texture = |sample_type, multisampled| wgpu::BindingType::Texture {
            sample_type,
            view_dimension: wgpu::TextureViewDimension::D2,
            multisampled,
        };
        let globals = wgpu::BindingType::Buffer {
            ty: wgpu::BufferBindingType::Uniform,
            has_dynamic_offset: false,
            min_binding_size: None,
        };
        Self {
            globals_layout: layout(
                "globals",
                &[
                    entry(0, ShaderStages::VERTEX_FRAGMENT, globals),
                    // The sum of the sub-frames before.
                    entry(
                        1,
                        ShaderStages::FRAGMENT,
                        texture(wgpu::TextureSampleType::Float { filterable: false }, false),
                    ),
                ][..if variant.is_sub_frame { 2 } else { 1 }],
            ),
            sun_map_layout: layout(
                "sun map",
                &[
                    entry(0, ShaderStages::FRAGMENT, texture(wgpu::TextureSampleType::Depth, false)),
                    entry(1, ShaderStages::FRAGMENT, wgpu::BindingType::Sampler(wgpu::SamplerBindingType::Comparison)),
                ],
            ),
            mask_layout: layout(
                "mask",
                &[entry(
                    0,
                    ShaderStages::FRAGMENT,
                    texture(wgpu::TextureSampleType::Float { filterable: false }, samples > 1),
                )],
            ),
            material_layout: material_layout(device),
            joints_layout: joints_layout(device),
            target_format,
            samples,
            variant,
            constants: constants(&Lighting::default()),
            modules: [const { [const { OnceLock::new() }; CORNERS] }; SOURCES],
            made: [const { [const { OnceLock::new() }; FORMS] }; COUNT],
        }
    }

    /// Sets the light of shapes and meshes. Another one makes their pipelines anew, when they are next needed.
    pub fn light(&mut self, lighting: &Lighting) {
        let constants = constants(lighting);
        if constants != self.constants {
            self.constants = constants;
            for kind in [Kind::Shape, Kind::Edge] {
                self.made[kind as usize] = [const { OnceLock::new() }; FORMS];
            }
        }
    }

    /// Returns a pipeline for unit meshes or what is no mesh, and creates it on first use. Two threads may create two pipelines at the same
    /// time.
    pub fn get(&self, device: &wgpu::Device, kind: Kind) -> &wgpu::RenderPipeline {
        self.of(device, kind, Form::Unit)
    }

    /// The same for a form; one of shapes, for meshes of triangles.
    pub fn of(&self, device: &wgpu::Device, kind: Kind, form: Form) -> &wgpu::RenderPipeline {
        self.made[kind as usize][form.index()].get_or_init(|| {
            let recipe = match form {
                Form::Mesh(form) if kind.is_of_shapes() => kind.recipe_of(form),
                Form::Mesh(_) | Form::Unit => kind.recipe(),
            };
            let variant = Variant { corner: form.corner(), ..self.variant };
            let module = self.modules[recipe.source as usize][variant.corner as usize]
                .get_or_init(|| shaders::module(device, recipe.source, variant));
            self.make(device, kind, form, &recipe, module)
        })
    }

    /// The bind groups of a pipeline.
    fn layout(&self, device: &wgpu::Device, kind: Kind, form: Form, recipe: &Recipe) -> wgpu::PipelineLayout {
        let second = match kind {
            Kind::Shape | Kind::Plane | Kind::Edge => Some(&self.sun_map_layout),
            Kind::Outline => Some(&self.mask_layout),
            _ => None,
        };
        let groups = [
            Some(&self.globals_layout),
            second,
            recipe.has_surface().then_some(&self.material_layout),
            (form.corner() == Corner::Skin).then_some(&self.joints_layout),
        ];
        device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: None,
            bind_group_layouts: &groups[..groups.iter().rposition(Option::is_some).map_or(0, |last| last + 1)],
            immediate_size: 0,
        })
    }

    /// How the shaders of a kind are compiled.
    fn options(&self, kind: Kind) -> wgpu::PipelineCompilationOptions<'_> {
        let is_lit = matches!(kind, Kind::Shape | Kind::Edge);
        let constants: &[_] = if is_lit { &self.constants } else { &[] };
        wgpu::PipelineCompilationOptions { constants, ..Default::default() }
    }

    fn make(
        &self,
        device: &wgpu::Device,
        kind: Kind,
        form: Form,
        recipe: &Recipe,
        module: &wgpu::ShaderModule,
    ) -> wgpu::RenderPipeline {
        let layout = self.layout(device, kind, form, recipe);
        let is_mask = matches!(kind, Kind::MaskAll | Kind::MaskVisible);
        let target = wgpu::ColorTargetState {
            format: if is_mask { MASK_FORMAT } else { self.target_format },
            blend: recipe
                .blend
                .then_some(wgpu::BlendState { alpha: wgpu::BlendComponent::OVER, ..wgpu::BlendState::ALPHA_BLENDING }),
            write_mask: match kind {
                Kind::MaskAll => wgpu::ColorWrites::RED,
                Kind::MaskVisible => wgpu::ColorWrites::GREEN,
                Kind::Depth | Kind::GhostDepth => wgpu::ColorWrites::empty(),
                _ => wgpu::ColorWrites::ALL,
            },
        };
        let targets = [Some(target)];
        // A depth-only pipeline in the picture's pass must still name the pass's colour target.
        let is_plain_depth = kind == Kind::GhostDepth && recipe.fragment.is_none();
        let fragment = if is_plain_depth { Some("nothing_fragment") } else { recipe.fragment };
        let is_single = kind.is_shadow() || kind == Kind::Outline;
        device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
            label: None,
            layout: Some(&layout),
            vertex: wgpu::VertexState {
                module,
                entry_point: Some(recipe.vertex),
                // Edges have their light at their corners.
                compilation_options: if kind == Kind::Edge {
                    self.options(kind)
                } else {
                    wgpu::PipelineCompilationOptions::default()
                },
                buffers: &buffers(recipe.input, form, recipe.has_surface()),
            },
            primitive: wgpu::PrimitiveState {
                topology: if matches!(recipe.input, Input::Strokes | Input::Edges) {
                    wgpu::PrimitiveTopology::TriangleStrip
                } else {
                    wgpu::PrimitiveTopology::TriangleList
                },
                cull_mode: match recipe.input {
                    Input::Instances if kind.draws_both_sides(form) => None,
                    // Back faces go into the shadow map, so that lit faces never shadow themselves (no bias needed).
                    Input::Instances if kind.is_shadow() => Some(wgpu::Face::Front),
                    Input::Instances => Some(wgpu::Face::Back),
                    _ => None,
                },
                ..Default::default()
            },
            depth_stencil: recipe.depth.map(|(compare, write)| wgpu::DepthStencilState {
                format: kind.depth_format(),
                depth_write_enabled: Some(write),
                depth_compare: Some(compare),
                stencil: wgpu::StencilState::default(),
                bias: match form {
                    Form::Mesh(_) if kind.is_shadow() => OPEN_SHADOW_BIAS,
                    Form::Mesh(_) | Form::Unit => wgpu::DepthBiasState::default(),
                },
            }),
            multisample: wgpu::MultisampleState {
                count: if is_single { 1 } else { self.samples },
                ..Default::default()
            },
            fragment: fragment.map(|entry_point| wgpu::FragmentState {
                module,
                entry_point: Some(entry_point),
                compilation_options: self.options(kind),
                targets: if kind.is_shadow() { &[] } else { &targets },
            }),
            multiview_mask: None,
            cache: None,
        })
    }
}

/// The vertex buffers of a pipeline.
fn buffers(input: Input, form: Form, has_surface: bool) -> Vec<Option<wgpu::VertexBufferLayout<'static>>> {
    const CORNER: [wgpu::VertexAttribute; 2] = wgpu::vertex_attr_array![0 => Float32x3, 1 => Float32x3];
    const INSTANCE: [wgpu::VertexAttribute; 7] = wgpu::vertex_attr_array![
        2 => Float32x4, 3 => Float32x4, 4 => Float32x4, 5 => Float32x4, 6 => Float32x3, 7 => Uint32, 8 => Float32x4
    ];
    const STROKE: [wgpu::VertexAttribute; 4] =
        wgpu::vertex_attr_array![0 => Float32x3, 1 => Float32x3, 2 => Float32x4, 3 => Float32];
    const EDGE: [wgpu::VertexAttribute; 6] = wgpu::vertex_attr_array![
        0 => Float32x3, 1 => Float32x3, 2 => Float32x3, 3 => Float32x3, 4 => Float32x3, 5 => Float32x4
    ];
    const { assert!(VertexFormat::Float32x4.size() * 5 + 16 == size_of::<Instance>() as u64) };
    let of = |array_stride: usize, step_mode, attributes| {
        Some(wgpu::VertexBufferLayout { array_stride: array_stride as u64, step_mode, attributes })
    };
    let per_instance = |array_stride, attributes| of(array_stride, wgpu::VertexStepMode::Instance, attributes);
    match input {
        Input::Instances => {
            let corners = of(size_of::<Vertex>(), wgpu::VertexStepMode::Vertex, &CORNER[..]);
            let instances = per_instance(size_of::<Instance>(), &INSTANCE[..]);
            if form == Form::Unit {
                return vec![corners, instances];
            }
            let weights = (form.corner() == Corner::Skin).then_some(weights_buffer());
            vec![corners, instances, has_surface.then_some(surface_buffer()), weights]
        }
        Input::Strokes => vec![per_instance(size_of::<Stroke>(), &STROKE[..])],
        Input::Edges => vec![per_instance(size_of::<EdgeLine>(), &EDGE[..])],
        Input::Nothing => Vec::new(),
    }
}
