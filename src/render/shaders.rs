//! The shaders as parsed modules, parsed once per process.

use std::borrow::Cow;
use std::sync::OnceLock;

use wgpu::naga::Module;
use wgpu::naga::front::wgsl;

/// The source modules, by what they draw.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Source {
    /// Shapes except planes, ghosts, the edges of both, and shades under what stands on the ground.
    Shape,
    /// Planes.
    Plane,
    /// The sky.
    Sky,
    /// The sun's map and the outline's mask.
    Silhouette,
    /// Lines and dots.
    Stroke,
    /// The outline.
    Outline,
    /// Which node each pixel shows.
    Identity,
    /// Meshes of triangles with their materials.
    Mesh,
    /// The same with holes, without colours.
    Masked,
    /// Sums of sub-frames.
    Refine,
}

/// What vertices are transformed by.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Corner {
    /// Unit meshes by the half extents, rounding and matrix of their instance.
    Unit,
    /// Meshes of triangles by the matrix of their instance.
    Mesh,
    /// Meshes with a skin by their joints.
    Skin,
}

/// The number of ways to transform vertices.
pub const CORNERS: usize = Corner::Skin as usize + 1;

/// The number of sources.
pub const SOURCES: usize = Source::Refine as usize + 1;
const VARIANTS: usize = 16 * CORNERS;

/// The variants of a module.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Variant {
    /// The target does not encode colours, so shaders encode them as sRGB.
    pub encodes_srgb: bool,
    /// The CPU draws: shadows take fewer lookups.
    pub is_software: bool,
    /// Targets have several samples per pixel.
    pub is_multisampled: bool,
    /// The target takes light before the tone curve: it is a sub-frame.
    pub is_sub_frame: bool,
    /// What vertices are transformed by.
    pub corner: Corner,
}

static PARSED: [[OnceLock<Module>; VARIANTS]; SOURCES] = [const { [const { OnceLock::new() }; VARIANTS] }; SOURCES];

/// Parses the modules that a plain picture on the CPU needs.
pub fn parse_usual() {
    use Source::{Plane, Shape, Silhouette, Sky};
    let variant = Variant {
        encodes_srgb: false,
        is_software: true,
        is_multisampled: false,
        is_sub_frame: false,
        corner: Corner::Unit,
    };
    for source in [Silhouette, Shape, Plane, Sky] {
        parsed(source, variant);
    }
}

/// Creates the shader module of a source.
pub fn module(device: &wgpu::Device, source: Source, variant: Variant) -> wgpu::ShaderModule {
    let source = wgpu::ShaderSource::Naga(Cow::Borrowed(parsed(source, variant)));
    device.create_shader_module(wgpu::ShaderModuleDescriptor { label: None, source })
}

fn parsed(source: Source, variant: Variant) -> &'static Module {
    let Variant { encodes_srgb, is_software, is_multisampled, is_sub_frame, corner } = variant;
    let flags = [encodes_srgb, is_software, is_multisampled, is_sub_frame];
    let flags = flags.iter().rev().fold(0, |bits, &flag| bits << 1 | usize::from(flag));
    let index = flags | (corner as usize) << 4;
    PARSED[source as usize][index]
        .get_or_init(|| wgsl::parse_str(&text(source, variant)).expect("the program's own shaders have no errors"))
}

fn text(source: Source, variant: Variant) -> String {
    macro_rules! file {
        ($file:literal) => {
            include_str!(concat!("../../shaders/", $file))
        };
    }
    let corner: &[&str] = match variant.corner {
        Corner::Unit => &[file!("corner.wgsl")],
        Corner::Mesh => &[file!("normal.wgsl"), file!("mesh_corner.wgsl")],
        Corner::Skin => &[file!("normal.wgsl"), file!("skin_corner.wgsl")],
    };
    // Many sub-frames filter their shadows together.
    let sun = if variant.is_software || variant.is_sub_frame {
        file!("shadow_one.wgsl")
    } else {
        file!("shadow_square.wgsl")
    };
    let own: &[&str] = match source {
        Source::Shape => &[
            file!("pixel.wgsl"),
            file!("lit.wgsl"),
            sun,
            file!("arriving.wgsl"),
            file!("material.wgsl"),
            file!("shape.wgsl"),
            file!("edge.wgsl"),
        ],
        Source::Plane => &[file!("pixel.wgsl"), file!("lit.wgsl"), sun, file!("plane.wgsl")],
        Source::Sky => &[file!("pixel.wgsl"), file!("sky.wgsl")],
        Source::Silhouette => &[file!("pixel.wgsl"), file!("silhouette.wgsl")],
        Source::Stroke => &[file!("stroke.wgsl")],
        Source::Outline => &[file!("outline.wgsl")],
        Source::Identity => &[file!("identity.wgsl")],
        Source::Mesh => &[
            file!("lit.wgsl"),
            sun,
            file!("arriving.wgsl"),
            file!("surface.wgsl"),
            file!("material.wgsl"),
            file!("mesh.wgsl"),
        ],
        Source::Masked => &[file!("surface.wgsl"), file!("masked.wgsl")],
        Source::Refine => &[file!("refine.wgsl")],
    };
    let corner = match source {
        Source::Sky | Source::Stroke | Source::Outline | Source::Refine => &[],
        _ => corner,
    };
    let mut text = format!(
        "const ENCODE_SRGB = {};\nconst IS_SUB_FRAME = {};\n{}",
        variant.encodes_srgb,
        variant.is_sub_frame,
        file!("common.wgsl")
    );
    text.push_str(if variant.is_sub_frame { file!("sum.wgsl") } else { file!("no_sum.wgsl") });
    text.extend(corner.iter().chain(own).copied());
    // `textureLoad` has the same form for both; the last argument is then the sample.
    if source == Source::Outline && variant.is_multisampled {
        text = text.replace("texture_2d<f32>", "texture_multisampled_2d<f32>");
    }
    text
}

#[cfg(test)]
mod tests {
    use wgpu::naga::valid::{Capabilities, ValidationFlags, Validator};

    use super::*;

    /// Also the variants that only a GPU uses.
    #[test]
    fn every_variant_of_every_source_is_valid() {
        use Source::{Identity, Masked, Mesh, Outline, Plane, Refine, Shape, Silhouette, Sky, Stroke};
        let sources = [Shape, Plane, Sky, Silhouette, Stroke, Outline, Identity, Mesh, Masked, Refine];
        assert_eq!(sources.len(), SOURCES);
        for source in sources {
            for bits in 0..VARIANTS {
                let has = |bit: usize| bits >> bit & 1 == 1;
                let corner = [Corner::Unit, Corner::Mesh, Corner::Skin][bits >> 4];
                let is_of_triangles = corner != Corner::Unit;
                if matches!(source, Mesh | Masked) && !is_of_triangles || source == Plane && is_of_triangles {
                    continue;
                }
                let variant = Variant {
                    encodes_srgb: has(0),
                    is_software: has(1),
                    is_multisampled: has(2),
                    is_sub_frame: has(3),
                    corner,
                };
                let validated =
                    Validator::new(ValidationFlags::all(), Capabilities::empty()).validate(parsed(source, variant));
                assert!(validated.is_ok(), "{source:?} {variant:?}: {validated:?}");
            }
        }
    }
}
