//! Makes glTF files: one buffer, with equal data stored once.

mod model;

use std::collections::HashMap;

use bytemuck::{NoUninit, cast_slice};
use glam::{Affine3A, Mat4, Vec2, Vec3, Vec4};

use super::json::{Accessor, Asset, Buffer, BufferView, Index, Root};
use super::{data_uri, glb};

/// The program that [`Writer`] names.
const GENERATOR: &str = "Inbetween";

const UNSIGNED_BYTE: u32 = 5121;
const UNSIGNED_SHORT: u32 = 5123;
const UNSIGNED_INT: u32 = 5125;
const FLOAT: u32 = 5126;
const VERTICES: u32 = 34962;
const INDICES: u32 = 34963;
/// The specification reserves the largest 16-bit index.
const LARGEST_SHORT_INDEX: u32 = 0xFFFE;

/// What the bytes of an accessor are for. The specification wants vertices, indices and other data in views of their own.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
enum Purpose {
    /// One value for each vertex.
    Vertices,
    /// The corners of triangles.
    Triangles,
    /// Times and values of animations: they share a view, because there are many.
    Animation,
    /// Inverse bind matrices.
    Skin,
}

/// The form of an accessor's elements.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
struct Form {
    component_type: u32,
    kind: &'static str,
}

impl Form {
    const fn floats(kind: &'static str) -> Self {
        Self { component_type: FLOAT, kind }
    }
}

/// A glTF file in the making. Nodes, meshes and the rest are pushed to the lists of [`Writer::root`]; data go through the methods, which
/// return the index of the accessor or object. No value may be infinite or NaN. The same calls make the same bytes.
#[derive(Debug, Default)]
pub struct Writer {
    /// The JSON so far. `asset`, `accessors`, `buffer_views` and `buffers` are the writer's.
    pub root: Root,
    binary: Vec<u8>,
    /// The bytes of the view that animations share. They go to the end of the buffer.
    animation: Vec<u8>,
    animation_view: Option<Index>,
    accessors: HashMap<(Purpose, Form, Vec<u8>), Index>,
    images: HashMap<Vec<u8>, Index>,
}

impl Writer {
    /// A file with nothing but the name of the program.
    #[must_use]
    pub fn new() -> Self {
        let asset = Asset { version: "2.0".to_owned(), generator: Some(GENERATOR.to_owned()), ..Asset::default() };
        Self { root: Root { asset, ..Root::default() }, ..Self::default() }
    }

    /// Points of vertices, with their bounds.
    pub fn positions(&mut self, values: &[Vec3]) -> Index {
        self.bounded(Purpose::Vertices, Form::floats("VEC3"), values, Vec3::to_array)
    }

    /// Vectors of vertices.
    pub fn vectors(&mut self, values: &[Vec3]) -> Index {
        self.accessor(Purpose::Vertices, Form::floats("VEC3"), values)
    }

    /// Texture coordinates of vertices.
    pub fn texture_coordinates(&mut self, values: &[Vec2]) -> Index {
        self.accessor(Purpose::Vertices, Form::floats("VEC2"), values)
    }

    /// Linear-light colours with opacities, or weights, of vertices.
    pub fn vertex_values<T: NoUninit + Into<[f32; 4]>>(&mut self, values: &[T]) -> Index {
        self.accessor(Purpose::Vertices, Form::floats("VEC4"), values)
    }

    /// Joints of vertices.
    pub fn joints(&mut self, values: &[[u8; 4]]) -> Index {
        let form = Form { component_type: UNSIGNED_BYTE, kind: "VEC4" };
        self.accessor(Purpose::Vertices, form, values)
    }

    /// Corners of triangles, with as many bytes each as the largest needs.
    pub fn indices(&mut self, values: &[u32]) -> Index {
        let form = |component_type| Form { component_type, kind: "SCALAR" };
        if values.iter().all(|&index| index <= LARGEST_SHORT_INDEX) {
            let short: Vec<u16> = values.iter().map(|&index| index as u16).collect();
            self.accessor(Purpose::Triangles, form(UNSIGNED_SHORT), &short)
        } else {
            self.accessor(Purpose::Triangles, form(UNSIGNED_INT), values)
        }
    }

    /// Inverse bind matrices.
    pub fn matrices(&mut self, values: &[Affine3A]) -> Index {
        let values: Vec<[f32; 16]> = values.iter().map(|&value| Mat4::from(value).to_cols_array()).collect();
        self.accessor(Purpose::Skin, Form::floats("MAT4"), &values)
    }

    /// Times of an animation in seconds, ascending, with their bounds.
    pub fn times(&mut self, seconds: &[f32]) -> Index {
        self.bounded(Purpose::Animation, Form::floats("SCALAR"), seconds, |&second| [second])
    }

    /// Translations or scales of an animation, or their tangents.
    pub fn animated_vectors(&mut self, values: &[Vec3]) -> Index {
        self.accessor(Purpose::Animation, Form::floats("VEC3"), values)
    }

    /// Rotations of an animation as x, y, z, w, or their tangents.
    pub fn animated_rotations(&mut self, values: &[Vec4]) -> Index {
        self.accessor(Purpose::Animation, Form::floats("VEC4"), values)
    }

    /// A view of bytes that no accessor describes: a picture.
    fn picture_view(&mut self, bytes: &[u8]) -> Index {
        let offset = self.append(bytes);
        self.view(offset, bytes.len(), None)
    }

    /// The file as JSON alone, with the buffer as a data URI.
    #[must_use]
    pub fn into_gltf(self) -> String {
        let (mut root, binary) = self.finished();
        if let Some(buffer) = root.buffers.first_mut() {
            buffer.uri = Some(data_uri("application/octet-stream", &binary));
        }
        let mut text = serde_json::to_string_pretty(&root).expect("names and numbers are JSON");
        text.push('\n');
        text
    }

    /// The file as binary glTF.
    ///
    /// # Panics
    /// If it would have 4 GiB or more.
    #[must_use]
    pub fn into_glb(self) -> Vec<u8> {
        let (root, binary) = self.finished();
        glb(&serde_json::to_string(&root).expect("names and numbers are JSON"), &binary)
    }

    fn finished(mut self) -> (Root, Vec<u8>) {
        if let Some(view) = self.animation_view {
            let bytes = std::mem::take(&mut self.animation);
            let offset = self.append(&bytes);
            self.root.buffer_views[view] =
                BufferView { byte_offset: Some(offset), byte_length: bytes.len(), ..BufferView::default() };
        }
        if !self.binary.is_empty() {
            self.root.buffers = vec![Buffer { uri: None, byte_length: self.binary.len() }];
        }
        (self.root, self.binary)
    }

    /// An accessor with the least and the largest of each component, which the specification wants for positions and times.
    fn bounded<T: NoUninit, const N: usize>(
        &mut self,
        purpose: Purpose,
        form: Form,
        values: &[T],
        parts: impl Fn(&T) -> [f32; N],
    ) -> Index {
        let accessor = self.accessor(purpose, form, values);
        let bound = |pick: fn(f32, f32) -> f32| {
            let bounds = values.iter().map(&parts).reduce(|a, b| std::array::from_fn(|part| pick(a[part], b[part])));
            bounds.map(Vec::from).unwrap_or_default()
        };
        self.root.accessors[accessor].min = bound(f32::min);
        self.root.accessors[accessor].max = bound(f32::max);
        accessor
    }

    /// The accessor of values: a new one, or the one that has these bytes.
    fn accessor<T: NoUninit>(&mut self, purpose: Purpose, form: Form, values: &[T]) -> Index {
        let bytes: &[u8] = cast_slice(values);
        debug_assert!(
            form.component_type != FLOAT
                || bytes
                    .chunks_exact(4)
                    .all(|float| f32::from_le_bytes([float[0], float[1], float[2], float[3]]).is_finite()),
            "a file has finite numbers"
        );
        let key = (purpose, form, bytes.to_vec());
        if let Some(&accessor) = self.accessors.get(&key) {
            return accessor;
        }
        let (view, offset) = match purpose {
            Purpose::Vertices => (self.view_of(bytes, Some(VERTICES)), None),
            Purpose::Triangles => (self.view_of(bytes, Some(INDICES)), None),
            Purpose::Skin => (self.view_of(bytes, None), None),
            Purpose::Animation => {
                let offset = self.animation.len();
                self.animation.extend_from_slice(bytes);
                (self.animation_view(), Some(offset))
            }
        };
        let accessor = self.root.accessors.len();
        self.root.accessors.push(Accessor {
            buffer_view: Some(view),
            byte_offset: offset,
            component_type: form.component_type,
            count: values.len(),
            kind: form.kind.to_owned(),
            ..Accessor::default()
        });
        self.accessors.insert(key, accessor);
        accessor
    }

    fn view_of(&mut self, bytes: &[u8], target: Option<u32>) -> Index {
        let offset = self.append(bytes);
        self.view(offset, bytes.len(), target)
    }

    /// The view that animations share. Its place is known at the end.
    fn animation_view(&mut self) -> Index {
        if let Some(view) = self.animation_view {
            return view;
        }
        let view = self.view(0, 0, None);
        self.animation_view = Some(view);
        view
    }

    fn view(&mut self, offset: usize, length: usize, target: Option<u32>) -> Index {
        let view = BufferView { byte_offset: Some(offset), byte_length: length, target, ..BufferView::default() };
        self.root.buffer_views.push(view);
        self.root.buffer_views.len() - 1
    }

    /// Appends bytes to the buffer; returns where they begin: at a multiple of four, as every kind of component wants.
    fn append(&mut self, bytes: &[u8]) -> usize {
        self.binary.resize(self.binary.len().next_multiple_of(4), 0);
        let offset = self.binary.len();
        self.binary.extend_from_slice(bytes);
        offset
    }
}

#[cfg(test)]
mod tests;
