//! The shaders as parsed modules, parsed once per process.

use std::borrow::Cow;
use std::sync::OnceLock;

use wgpu::naga::Module;
use wgpu::naga::front::wgsl;

/// The source modules, by what they draw.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Source {
    /// Shapes except planes, and ghosts.
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
}

/// The number of sources.
pub const SOURCES: usize = Source::Identity as usize + 1;
const VARIANTS: usize = 8;

/// The variants of a module.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Variant {
    /// The target does not encode colours, so shaders encode them as sRGB.
    pub encodes_srgb: bool,
    /// The CPU draws: shadows take fewer lookups.
    pub is_software: bool,
    /// Targets have several samples per pixel.
    pub is_multisampled: bool,
}

static PARSED: [[OnceLock<Module>; VARIANTS]; SOURCES] = [const { [const { OnceLock::new() }; VARIANTS] }; SOURCES];

/// Parses the modules that a plain picture on the CPU needs.
pub fn parse_usual() {
    let variant = Variant { encodes_srgb: false, is_software: true, is_multisampled: false };
    for source in [Source::Silhouette, Source::Shape, Source::Plane, Source::Sky] {
        parsed(source, variant);
    }
}

/// Creates the shader module of a source.
pub fn module(device: &wgpu::Device, source: Source, variant: Variant) -> wgpu::ShaderModule {
    let source = wgpu::ShaderSource::Naga(Cow::Borrowed(parsed(source, variant)));
    device.create_shader_module(wgpu::ShaderModuleDescriptor { label: None, source })
}

fn parsed(source: Source, variant: Variant) -> &'static Module {
    let Variant { encodes_srgb, is_software, is_multisampled } = variant;
    let index = usize::from(encodes_srgb) | usize::from(is_software) << 1 | usize::from(is_multisampled) << 2;
    PARSED[source as usize][index]
        .get_or_init(|| wgsl::parse_str(&text(source, variant)).expect("the program's own shaders have no errors"))
}

fn text(source: Source, variant: Variant) -> String {
    macro_rules! joined {
        ($($file:literal),*) => {
            concat!(include_str!("../../shaders/common.wgsl"), $(include_str!(concat!("../../shaders/", $file))),*)
        };
    }
    let text = match (source, variant.is_software) {
        (Source::Shape, true) => joined!("corner.wgsl", "pixel.wgsl", "lit.wgsl", "shadow_one.wgsl", "shape.wgsl"),
        (Source::Shape, false) => joined!("corner.wgsl", "pixel.wgsl", "lit.wgsl", "shadow_square.wgsl", "shape.wgsl"),
        (Source::Plane, true) => joined!("corner.wgsl", "pixel.wgsl", "lit.wgsl", "shadow_one.wgsl", "plane.wgsl"),
        (Source::Plane, false) => joined!("corner.wgsl", "pixel.wgsl", "lit.wgsl", "shadow_square.wgsl", "plane.wgsl"),
        (Source::Sky, _) => joined!("pixel.wgsl", "sky.wgsl"),
        (Source::Silhouette, _) => joined!("corner.wgsl", "pixel.wgsl", "silhouette.wgsl"),
        (Source::Stroke, _) => joined!("stroke.wgsl"),
        (Source::Outline, _) => joined!("outline.wgsl"),
        (Source::Identity, _) => joined!("corner.wgsl", "identity.wgsl"),
    };
    let mut text = format!("const ENCODE_SRGB = {};\n{text}", variant.encodes_srgb);
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
        use Source::{Identity, Outline, Plane, Shape, Silhouette, Sky, Stroke};
        let sources = [Shape, Plane, Sky, Silhouette, Stroke, Outline, Identity];
        assert_eq!(sources.len(), SOURCES);
        for source in sources {
            for bits in 0..VARIANTS {
                let has = |bit: usize| bits >> bit & 1 == 1;
                let variant = Variant { encodes_srgb: has(0), is_software: has(1), is_multisampled: has(2) };
                let validated =
                    Validator::new(ValidationFlags::all(), Capabilities::empty()).validate(parsed(source, variant));
                assert!(validated.is_ok(), "{source:?} {variant:?}: {validated:?}");
            }
        }
    }
}
