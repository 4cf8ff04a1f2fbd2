//! Binary glTF: a header, a chunk of JSON and a chunk of bytes (glTF 2.0, section 4.4); and data URIs (RFC 2397).

use base64::Engine as _;
use base64::alphabet;
use base64::engine::{DecodePaddingMode, GeneralPurpose, GeneralPurposeConfig};
use thiserror::Error;

use crate::words::{Message, display_by_message, texts};

const MAGIC: &[u8; 4] = b"glTF";
const VERSION: u32 = 2;
const HEADER_BYTES: usize = 12;
const JSON_CHUNK: u32 = 0x4E4F_534A;
const BINARY_CHUNK: u32 = 0x004E_4942;

/// Files with and without `=` at the end are in use.
const BASE64: GeneralPurpose = GeneralPurpose::new(
    &alphabet::STANDARD,
    GeneralPurposeConfig::new().with_decode_padding_mode(DecodePaddingMode::Indifferent),
);

/// What a glTF file is made of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Container<'a> {
    /// The JSON text.
    pub json: &'a [u8],
    /// The bytes of the first buffer, if the container has them.
    pub binary: Option<&'a [u8]>,
}

/// Why bytes are no binary glTF.
#[derive(Clone, Copy, Debug, Error, PartialEq, Eq)]
pub enum GlbError {
    /// The version of the container is not 2.
    Version {
        /// The version in the file.
        found: u32,
    },
    /// The header says that the file is longer than it is.
    Truncated {
        /// The length that the header says, in bytes.
        said: u32,
        /// The file's length in bytes.
        found: usize,
    },
    /// A chunk begins that is no chunk, or the first one is not JSON.
    Chunk {
        /// Where it begins, in bytes.
        at: usize,
    },
}

display_by_message!(GlbError);

impl GlbError {
    /// The error as a message.
    #[must_use]
    pub fn message(&self) -> Message {
        match self {
            Self::Version { found } => texts::gltf_container_version(*found),
            Self::Truncated { said, found } => texts::gltf_container_truncated(*said, *found),
            Self::Chunk { at } => texts::gltf_container_chunk(*at),
        }
    }
}

impl<'a> Container<'a> {
    /// Takes a glTF file apart: a binary one by its first four bytes, any other as JSON alone.
    ///
    /// # Errors
    /// [`GlbError`]: it begins as a binary one does, and then is none.
    pub fn of(file: &'a [u8]) -> Result<Self, GlbError> {
        if !file.starts_with(MAGIC) {
            return Ok(Self { json: file, binary: None });
        }
        let truncated = |said| GlbError::Truncated { said, found: file.len() };
        let (version, said) = number(file, 4).zip(number(file, 8)).ok_or_else(|| truncated(HEADER_BYTES as u32))?;
        if version != VERSION {
            return Err(GlbError::Version { found: version });
        }
        let file = file.get(..said as usize).ok_or_else(|| truncated(said))?;
        let (kind, json, next) = chunk(file, HEADER_BYTES)?;
        if kind != JSON_CHUNK {
            return Err(GlbError::Chunk { at: HEADER_BYTES });
        }
        let mut container = Self { json, binary: None };
        // Chunks of other kinds are for extensions.
        if next < file.len() {
            let (kind, bytes, _) = chunk(file, next)?;
            container.binary = (kind == BINARY_CHUNK).then_some(bytes);
        }
        Ok(container)
    }
}

/// The four bytes at a place as a number.
fn number(bytes: &[u8], at: usize) -> Option<u32> {
    Some(u32::from_le_bytes(*bytes.get(at..)?.first_chunk()?))
}

/// The chunk at a place: its kind, its bytes, and where the next one begins.
fn chunk(file: &[u8], at: usize) -> Result<(u32, &[u8], usize), GlbError> {
    let error = GlbError::Chunk { at };
    let (length, kind) = number(file, at).zip(number(file, at + 4)).ok_or(error)?;
    let start = at + 8;
    let end = start.checked_add(length as usize).ok_or(error)?;
    Ok((kind, file.get(start..end).ok_or(error)?, end))
}

/// A binary glTF file of a JSON text and the bytes of its first buffer; without bytes it has one chunk.
///
/// # Panics
/// If the file would have 4 GiB or more.
#[must_use]
pub fn glb(json: &str, binary: &[u8]) -> Vec<u8> {
    let mut file = Vec::with_capacity(json.len() + binary.len() + 40);
    file.extend_from_slice(MAGIC);
    file.extend_from_slice(&VERSION.to_le_bytes());
    file.extend_from_slice(&[0; 4]);
    let mut push = |kind: u32, bytes: &[u8], padding: u8| {
        let length = u32::try_from(bytes.len().next_multiple_of(4)).expect("a chunk has less than 4 GiB");
        file.extend_from_slice(&length.to_le_bytes());
        file.extend_from_slice(&kind.to_le_bytes());
        file.extend_from_slice(bytes);
        file.resize(file.len().next_multiple_of(4), padding);
    };
    push(JSON_CHUNK, json.as_bytes(), b' ');
    if !binary.is_empty() {
        push(BINARY_CHUNK, binary, 0);
    }
    let length = u32::try_from(file.len()).expect("a binary glTF has less than 4 GiB");
    file[8..12].copy_from_slice(&length.to_le_bytes());
    file
}

/// Why a data URI has no bytes.
#[derive(Clone, Copy, Debug, Error, PartialEq, Eq)]
pub enum DataUriError {
    /// It is not encoded by base64.
    NotBase64,
    /// Its text is not base64.
    Damaged,
}

display_by_message!(DataUriError);

impl DataUriError {
    /// The error as a message.
    #[must_use]
    pub fn message(&self) -> Message {
        match self {
            Self::NotBase64 => texts::GLTF_DATA_URI_NOT_BASE64.into(),
            Self::Damaged => texts::GLTF_DATA_URI_DAMAGED.into(),
        }
    }
}

/// A data URI of bytes.
#[must_use]
pub fn data_uri(media_type: &str, bytes: &[u8]) -> String {
    format!("data:{media_type};base64,{}", BASE64.encode(bytes))
}

/// The bytes of a data URI; `None` for another URI.
///
/// # Errors
/// [`DataUriError`]
#[must_use]
pub fn decoded_data_uri(uri: &str) -> Option<Result<Vec<u8>, DataUriError>> {
    let content = uri.strip_prefix("data:")?;
    let Some((_, text)) = content.split_once(',').filter(|(head, _)| head.ends_with(";base64")) else {
        return Some(Err(DataUriError::NotBase64));
    };
    Some(BASE64.decode(text).map_err(|_| DataUriError::Damaged))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_container_has_what_was_put_in() {
        for (json, binary) in [("{}", &[][..]), ("{\"a\":1}", &[1, 2, 3, 4, 5]), ("{ }", &[9; 8])] {
            let file = glb(json, binary);
            assert_eq!(file.len() % 4, 0);
            let container = Container::of(&file).unwrap();
            assert_eq!(std::str::from_utf8(container.json).unwrap().trim_end(), json);
            match container.binary {
                Some(bytes) => assert!(bytes.starts_with(binary) && bytes.len() < binary.len() + 4),
                None => assert!(binary.is_empty()),
            }
        }
        assert_eq!(Container::of(b"{}").unwrap(), Container { json: b"{}", binary: None });
    }

    #[test]
    fn a_broken_container_says_where() {
        let file = glb("{}", &[1, 2, 3, 4]);
        for length in 4..file.len() {
            assert!(matches!(Container::of(&file[..length]), Err(GlbError::Truncated { .. })), "{length}");
        }
        let with = |at: usize, byte: u8| {
            let mut file = file.clone();
            file[at] = byte;
            file
        };
        assert_eq!(Container::of(&with(4, 1)), Err(GlbError::Version { found: 1 }));
        assert_eq!(Container::of(&with(15, 200)), Err(GlbError::Chunk { at: 12 }));
        assert_eq!(Container::of(&with(16, 0)), Err(GlbError::Chunk { at: 12 }));
        assert_eq!(Container::of(&with(26, 200)), Err(GlbError::Chunk { at: 24 }));
    }

    #[test]
    fn a_data_uri_has_its_bytes() {
        let bytes = [0, 255, 1, 2];
        let uri = data_uri("application/octet-stream", &bytes);
        assert_eq!(decoded_data_uri(&uri), Some(Ok(bytes.to_vec())));
        assert_eq!(decoded_data_uri(uri.trim_end_matches('=')), Some(Ok(bytes.to_vec())));
        assert_eq!(decoded_data_uri("a.bin"), None);
        assert_eq!(decoded_data_uri("data:text/plain,abc"), Some(Err(DataUriError::NotBase64)));
        assert_eq!(decoded_data_uri("data:;base64,a*"), Some(Err(DataUriError::Damaged)));
    }
}
