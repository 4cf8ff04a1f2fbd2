//! Accessors: lists of vectors in buffers, with strides, sparse and normalised ones (glTF 2.0, section 3.6.2).
//!
//! Memory is bounded by the bytes that are there: an accessor cannot have more elements than its view holds. One without a view is zeros
//! and costs no bytes, so it may have [`MOST_ZEROS`] elements.

use super::document::{Document, GltfError};
use super::json::{Accessor, Index};
use crate::words::texts;

/// The most elements of an accessor that has no bytes of its own.
pub const MOST_ZEROS: usize = 1 << 20;

/// The number of components of an element, by the accessor's type.
fn components(kind: &str) -> Option<usize> {
    Some(match kind {
        "SCALAR" => 1,
        "VEC2" => 2,
        "VEC3" => 3,
        "VEC4" => 4,
        "MAT4" => 16,
        _ => return None,
    })
}

/// How a component is stored.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Component {
    I8,
    U8,
    I16,
    U16,
    U32,
    F32,
}

impl Component {
    fn of_code(code: u32) -> Option<Self> {
        Some(match code {
            5120 => Self::I8,
            5121 => Self::U8,
            5122 => Self::I16,
            5123 => Self::U16,
            5125 => Self::U32,
            5126 => Self::F32,
            _ => return None,
        })
    }

    const fn bytes(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::U32 | Self::F32 => 4,
        }
    }

    /// The number at the start of the bytes, which are long enough.
    fn number(self, bytes: &[u8], is_normalised: bool) -> f32 {
        let pair = || [bytes[0], bytes[1]];
        let four = || [bytes[0], bytes[1], bytes[2], bytes[3]];
        let (number, largest) = match self {
            Self::I8 => (f32::from(bytes[0] as i8), 127.0),
            Self::U8 => (f32::from(bytes[0]), 255.0),
            Self::I16 => (f32::from(i16::from_le_bytes(pair())), 32767.0),
            Self::U16 => (f32::from(u16::from_le_bytes(pair())), 65535.0),
            Self::U32 => return u32::from_le_bytes(four()) as f32,
            Self::F32 => return f32::from_le_bytes(four()),
        };
        if is_normalised { (number / largest).max(-1.0) } else { number }
    }

    /// The whole number at the start of the bytes, if it is one that has no sign.
    fn whole(self, bytes: &[u8]) -> Option<u32> {
        Some(match self {
            Self::U8 => bytes[0].into(),
            Self::U16 => u16::from_le_bytes([bytes[0], bytes[1]]).into(),
            Self::U32 => u32::from_le_bytes([bytes[0], bytes[1], bytes[2], bytes[3]]),
            _ => return None,
        })
    }
}

/// Elements at equal distances in bytes.
struct Elements<'a> {
    bytes: &'a [u8],
    start: usize,
    stride: usize,
    size: usize,
    count: usize,
}

impl<'a> Elements<'a> {
    fn iter(&self) -> impl Iterator<Item = &'a [u8]> + '_ {
        (0..self.count).map(|index| &self.bytes[self.start + index * self.stride..][..self.size])
    }
}

impl Document<'_> {
    /// An accessor's description.
    ///
    /// # Errors
    /// [`GltfError`]: there is none.
    pub fn accessor(&self, accessor: Index) -> Result<&Accessor, GltfError> {
        let found = self.root.accessors.get(accessor);
        found.ok_or_else(|| GltfError::leads_nowhere("/accessors", &place(accessor)))
    }

    /// An accessor's elements as numbers. Normalised integers become 0 to 1 or −1 to 1, other integers stay what they are.
    ///
    /// # Errors
    /// [`GltfError`]: it has another number of components than `N`, its bytes are not there, or a number is not finite.
    pub fn floats<const N: usize>(&self, accessor: Index) -> Result<Vec<[f32; N]>, GltfError> {
        let json = self.accessor(accessor)?;
        let is_normalised = json.normalized.unwrap_or(false);
        let elements =
            self.elements::<N, f32>(accessor, |component, bytes| Some(component.number(bytes, is_normalised)))?;
        match elements.iter().position(|element| element.iter().any(|number| !number.is_finite())) {
            Some(index) => Err(GltfError::new(place(accessor), texts::gltf_not_finite(index))),
            None => Ok(elements),
        }
    }

    /// An accessor's elements as whole numbers.
    ///
    /// # Errors
    /// [`GltfError`]: it has another number of components than `N`, its bytes are not there, or its numbers may have signs or fractions.
    pub fn wholes<const N: usize>(&self, accessor: Index) -> Result<Vec<[u32; N]>, GltfError> {
        self.elements::<N, u32>(accessor, Component::whole)
    }

    fn elements<const N: usize, T: Copy + Default>(
        &self,
        accessor: Index,
        read: impl Fn(Component, &[u8]) -> Option<T>,
    ) -> Result<Vec<[T; N]>, GltfError> {
        let json = self.accessor(accessor)?;
        let error = |problem| GltfError::new(place(accessor), problem);
        if components(&json.kind) != Some(N) {
            return Err(error(texts::gltf_components(&json.kind, N)));
        }
        let bad_component = || error(texts::gltf_component_type(json.component_type));
        let component = Component::of_code(json.component_type).ok_or_else(bad_component)?;
        let element = |bytes: &[u8]| -> Result<[T; N], GltfError> {
            let mut numbers = [T::default(); N];
            for (number, bytes) in numbers.iter_mut().zip(bytes.chunks_exact(component.bytes())) {
                *number = read(component, bytes).ok_or_else(bad_component)?;
            }
            Ok(numbers)
        };
        let size = component.bytes() * N;
        let mut elements = match json.buffer_view {
            Some(view) => {
                let bytes = self.part(accessor, view, json.byte_offset, size, json.count, true)?;
                bytes.iter().map(element).collect::<Result<Vec<_>, _>>()?
            }
            None if json.count > MOST_ZEROS => return Err(error(texts::gltf_zeros(MOST_ZEROS))),
            None => vec![[T::default(); N]; json.count],
        };
        if let Some(sparse) = &json.sparse {
            let places = &sparse.indices;
            let kind = Component::of_code(places.component_type).ok_or_else(bad_component)?;
            let places =
                self.part(accessor, places.buffer_view, places.byte_offset, kind.bytes(), sparse.count, false)?;
            let values =
                self.part(accessor, sparse.values.buffer_view, sparse.values.byte_offset, size, sparse.count, false)?;
            for (at, value) in places.iter().zip(values.iter()) {
                let at = kind.whole(at).ok_or_else(bad_component)?;
                let replaced =
                    elements.get_mut(at as usize).ok_or_else(|| error(texts::gltf_sparse(at, json.count)))?;
                *replaced = element(value)?;
            }
        }
        Ok(elements)
    }

    /// The elements of a view, all of which are there.
    fn part(
        &self,
        accessor: Index,
        view: Index,
        offset: Option<usize>,
        size: usize,
        count: usize,
        may_have_stride: bool,
    ) -> Result<Elements<'_>, GltfError> {
        let (bytes, stride) = self.view(view)?;
        let stride = stride.filter(|stride| may_have_stride && *stride > 0).unwrap_or(size);
        let start = offset.unwrap_or(0);
        let needed = match count.checked_sub(1) {
            None => Some(0),
            Some(last) => last.checked_mul(stride).and_then(|last| start.checked_add(last)?.checked_add(size)),
        };
        // Elements that overlap would cost more memory than there are bytes.
        if stride < size || needed.is_none_or(|needed| needed > bytes.len()) {
            let needed = needed.unwrap_or(usize::MAX);
            return Err(GltfError::new(place(accessor), texts::gltf_short(needed, bytes.len())));
        }
        Ok(Elements { bytes, start, stride, size, count })
    }
}

/// An accessor's place in the JSON.
fn place(accessor: Index) -> String {
    format!("/accessors/{accessor}")
}
