//! Materials and their pictures (glTF 2.0, sections 3.8 and 3.9).

use std::collections::HashMap;
use std::sync::Arc;

use glam::{Mat2, Vec2, Vec3, Vec4};
use serde::Deserialize;
use zune_core::bytestream::ZCursor;
use zune_core::colorspace::ColorSpace;
use zune_core::options::DecoderOptions;
use zune_jpeg::JpegDecoder;

use super::document::{Document, GltfError, MOST_BUFFER_BYTES, ReadFile, UNDERSTOOD, bytes_of};
use super::json::{self, Index};
use crate::model::{Material, Texture, Wrap};
use crate::picture::{Image, decode_png, rgba_of};
use crate::words::{Message, all_of, texts};

/// The most pixels of a picture's side.
pub const MOST_PIXELS_A_SIDE: u32 = 8192;
/// The most pixels of all pictures of a file together, in millions.
pub const MOST_MILLION_PIXELS: u64 = 64;

/// The most memory that a PNG takes while it is decoded, beside its pixels.
const MOST_PNG_BYTES: usize = 1 << 29;

/// A material, and what belongs to the primitive that has it.
#[derive(Clone, Debug)]
pub struct MaterialRead {
    /// The material.
    pub material: Material,
    /// The factor of its base colour: linear red, green and blue.
    pub colour: Vec3,
    /// Which of the coordinates `TEXCOORD_…` its texture has.
    pub coordinates: u32,
    /// What is done to the texture coordinates: a matrix, then an offset.
    pub coordinates_moved: Option<(Mat2, Vec2)>,
}

/// Reads materials, each picture once.
pub struct MaterialReader<'a, 'f> {
    document: &'a Document<'a>,
    read_file: &'a mut ReadFile<'f>,
    pictures: HashMap<Index, Option<Picture>>,
    pixels_left: u64,
    bytes_left: usize,
}

/// A picture that was read.
#[derive(Clone)]
struct Picture {
    file: Arc<[u8]>,
    media_type: &'static str,
    size_px: [u32; 2],
    pixels: Arc<[u8]>,
}

/// `KHR_texture_transform`.
#[derive(Deserialize)]
#[serde(rename_all = "camelCase", default)]
struct Transform {
    offset: [f32; 2],
    rotation: f32,
    scale: [f32; 2],
    tex_coord: Option<u32>,
}

impl Default for Transform {
    fn default() -> Self {
        Self { offset: [0.0; 2], rotation: 0.0, scale: [1.0; 2], tex_coord: None }
    }
}

impl<'a, 'f> MaterialReader<'a, 'f> {
    /// A reader of a file's materials; `read_file` reads pictures beside it.
    pub fn new(document: &'a Document<'a>, read_file: &'a mut ReadFile<'f>) -> Self {
        Self {
            document,
            read_file,
            pictures: HashMap::new(),
            pixels_left: MOST_MILLION_PIXELS << 20,
            bytes_left: MOST_BUFFER_BYTES,
        }
    }

    /// Reads a material. `notes` gets what was left out.
    ///
    /// # Errors
    /// [`GltfError`]: it names something that the file does not have, or a number is out of range.
    pub fn material(&mut self, index: Index, notes: &mut Vec<Message>) -> Result<MaterialRead, GltfError> {
        let at = format!("/materials/{index}");
        let Some(json) = self.document.root.materials.get(index) else {
            return Err(GltfError::leads_nowhere("/materials", &at));
        };
        let surface = json.pbr_metallic_roughness.clone().unwrap_or_default();
        let colour = Vec4::from(surface.base_color_factor.unwrap_or([1.0; 4])).clamp(Vec4::ZERO, Vec4::ONE);
        let mut material = Material {
            texture: None,
            metallic: surface.metallic_factor.unwrap_or(1.0).clamp(0.0, 1.0),
            roughness: surface.roughness_factor.unwrap_or(1.0).clamp(0.0, 1.0),
            emissive: Vec3::from(json.emissive_factor.unwrap_or_default()).max(Vec3::ZERO),
            opacity: colour.w,
            alpha_cutoff: None,
            is_double_sided: json.double_sided.unwrap_or(false),
            is_unlit: json.extensions.contains_key("KHR_materials_unlit"),
        };
        match json.alpha_mode.as_deref() {
            Some("MASK") => material.alpha_cutoff = Some(json.alpha_cutoff.unwrap_or(0.5)),
            Some("BLEND") => {
                material.alpha_cutoff = Some(0.5);
                notes.push(texts::gltf_note_blend(&at));
            }
            _ => {}
        }
        let strength = json.extensions.get("KHR_materials_emissive_strength");
        let strength = strength.and_then(|extension| extension.get("emissiveStrength")?.as_f64());
        material.emissive *= strength.map_or(1.0, |strength| strength.clamp(0.0, 1e4) as f32);
        left_out(json, &surface, &at, notes);
        let mut read = MaterialRead { material, colour: colour.truncate(), coordinates: 0, coordinates_moved: None };
        if let Some(info) = &surface.base_color_texture {
            read.coordinates = info.tex_coord.unwrap_or(0);
            if let Some(value) = info.extensions.get("KHR_texture_transform") {
                let moved = Transform::deserialize(value).unwrap_or_default();
                let (sine, cosine) = moved.rotation.sin_cos();
                // The specification's rotation is anticlockwise with y down.
                let turn = Mat2::from_cols_array(&[cosine, -sine, sine, cosine]);
                let moved_by = (turn * Mat2::from_diagonal(moved.scale.into()), Vec2::from(moved.offset));
                read.coordinates = moved.tex_coord.unwrap_or(read.coordinates);
                read.coordinates_moved = (moved_by.0.is_finite() && moved_by.1.is_finite()).then_some(moved_by);
            }
            read.material.texture = self.texture(info.index, &at, notes)?;
        }
        Ok(read)
    }

    /// A texture; `None`, with a note, if its picture cannot be had.
    fn texture(&mut self, index: Index, at: &str, notes: &mut Vec<Message>) -> Result<Option<Arc<Texture>>, GltfError> {
        let root = &self.document.root;
        let place = format!("/textures/{index}");
        let json = root.textures.get(index).ok_or_else(|| GltfError::leads_nowhere(at, &place))?;
        let sampler = match json.sampler {
            Some(sampler) => {
                let to = format!("/samplers/{sampler}");
                root.samplers.get(sampler).cloned().ok_or_else(|| GltfError::leads_nowhere(place.as_str(), &to))?
            }
            None => json::Sampler::default(),
        };
        let Some(source) = json.source else {
            notes.push(texts::gltf_note_picture(&place, texts::GLTF_NOTE_PICTURE_KIND));
            return Ok(None);
        };
        let image_place = format!("/images/{source}");
        let image = root.images.get(source).ok_or_else(|| GltfError::leads_nowhere(place, &image_place))?;
        if !self.pictures.contains_key(&source) {
            let picture = match self.picture(image)? {
                Ok(picture) => Some(picture),
                Err(problem) => {
                    notes.push(texts::gltf_note_picture(&image_place, problem));
                    None
                }
            };
            self.pictures.insert(source, picture);
        }
        let wrap = |code: Option<u32>| match code {
            Some(33071) => Wrap::Clamp,
            Some(33648) => Wrap::Mirror,
            _ => Wrap::Repeat,
        };
        Ok(self.pictures[&source].clone().map(|Picture { file, media_type, size_px, pixels }| {
            Arc::new(Texture {
                file,
                media_type,
                size_px,
                pixels,
                wrap: [wrap(sampler.wrap_s), wrap(sampler.wrap_t)],
                is_pixelated: sampler.mag_filter == Some(9728),
            })
        }))
    }

    /// A picture, or why there is none.
    fn picture(&mut self, image: &json::Image) -> Result<Result<Picture, Message>, GltfError> {
        let file = match (image.buffer_view, &image.uri) {
            (Some(view), _) => Ok(self.document.view(view)?.0.to_vec()),
            (None, Some(uri)) => bytes_of(uri, self.read_file),
            (None, None) => Err(texts::GLTF_NOTE_PICTURE_KIND.into()),
        };
        Ok(file.and_then(|file| {
            let left = self.bytes_left.checked_sub(file.len());
            self.bytes_left = left.ok_or_else(|| texts::gltf_note_pictures_large(MOST_BUFFER_BYTES >> 20))?;
            decoded(file.into(), &mut self.pixels_left)
        }))
    }
}

/// Decodes a PNG or JPEG file of a size that fits into memory.
fn decoded(file: Arc<[u8]>, pixels_left: &mut u64) -> Result<Picture, Message> {
    let damaged = || Message::from(texts::GLTF_NOTE_PICTURE_DAMAGED);
    let mut take = |[width, height]: [u32; 2]| {
        let pixels = u64::from(width) * u64::from(height);
        if width.max(height) > MOST_PIXELS_A_SIDE || pixels > *pixels_left {
            return Err(texts::gltf_note_picture_large(width, height, MOST_PIXELS_A_SIDE, MOST_MILLION_PIXELS));
        }
        *pixels_left -= pixels;
        Ok(())
    };
    let (media_type, read) = if file.starts_with(b"\x89PNG\r\n\x1a\n") {
        let side = |at: usize| file.get(at..)?.first_chunk().map(|bytes| u32::from_be_bytes(*bytes));
        take(side(16).zip(side(20)).map(<[u32; 2]>::from).ok_or_else(damaged)?)?;
        ("image/png", decode_png(&file, MOST_PNG_BYTES).map_err(|_| damaged())?)
    } else if file.starts_with(b"\xff\xd8\xff") {
        ("image/jpeg", jpeg(&file, take, damaged)?)
    } else {
        return Err(texts::GLTF_NOTE_PICTURE_KIND.into());
    };
    let size_px = [read.width, read.height];
    Ok(Picture { file, media_type, size_px, pixels: read.rgba.into() })
}

/// Decodes a JPEG file, after `take` has agreed to its size.
fn jpeg(
    file: &[u8],
    mut take: impl FnMut([u32; 2]) -> Result<(), Message>,
    damaged: impl Fn() -> Message,
) -> Result<Image, Message> {
    let options = DecoderOptions::default().set_strict_mode(false).set_max_width(usize::MAX).set_max_height(usize::MAX);
    let mut decoder = JpegDecoder::new_with_options(ZCursor::new(file), options);
    decoder.decode_headers().map_err(|_| damaged())?;
    let sides = decoder.dimensions().ok_or_else(&damaged)?;
    let [width, height] = <[usize; 2]>::from(sides).map(|side| u32::try_from(side).unwrap_or(u32::MAX));
    take([width, height])?;
    let (colours, channels) = match decoder.input_colorspace() {
        Some(ColorSpace::Luma) => (ColorSpace::Luma, 1),
        _ => (ColorSpace::RGB, 3),
    };
    decoder.set_options(options.jpeg_set_out_colorspace(colours));
    let pixels = decoder.decode().map_err(|_| damaged())?;
    Ok(Image { width, height, rgba: rgba_of(&pixels, channels) })
}

/// Notes what of a material is not drawn.
fn left_out(json: &json::Material, surface: &json::MetallicRoughness, at: &str, notes: &mut Vec<Message>) {
    let textures = [
        (json.normal_texture.is_some(), "normalTexture"),
        (json.occlusion_texture.is_some(), "occlusionTexture"),
        (json.emissive_texture.is_some(), "emissiveTexture"),
        (surface.metallic_roughness_texture.is_some(), "metallicRoughnessTexture"),
    ];
    let extensions = json.extensions.keys().map(String::as_str).filter(|name| !UNDERSTOOD.contains(name));
    let all: Vec<&str> =
        textures.iter().filter(|(is_there, _)| *is_there).map(|(_, name)| *name).chain(extensions).collect();
    if !all.is_empty() {
        notes.push(texts::gltf_note_material(at, all_of(&all)));
    }
}
