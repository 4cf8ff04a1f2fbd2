//! Node indices per pixel, as a 16-bit grey PNG.

use png::{BitDepth, ColorType, Compression, Encoder};

use super::super::CliError;
use crate::export::Painter;
use crate::frame::Frame;
use crate::render::node_picture;

/// The PNG of a frame: 0 where there is no shape, else the node's pre-order index in the scene plus 1.
///
/// # Errors
/// [`CliError`]: a node past 65534, or the picture cannot be drawn.
pub fn png(painter: &Painter, frame: &Frame) -> Result<Vec<u8>, CliError> {
    let size = painter.size();
    let nodes = node_picture(painter.gpu(), frame, size.width, size.height)?;
    let mut samples = Vec::with_capacity(2 * nodes.len());
    for node in nodes {
        let level = u16::try_from(node)
            .map_err(|_| CliError::bad_input("--id", format!("node {} does not fit into 16 bits", node - 1)))?;
        samples.extend(level.to_be_bytes());
    }
    let mut bytes = Vec::new();
    let mut encoder = Encoder::new(&mut bytes, size.width, size.height);
    encoder.set_color(ColorType::Grayscale);
    encoder.set_depth(BitDepth::Sixteen);
    encoder.set_compression(Compression::Fast);
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&samples)?;
    writer.finish()?;
    Ok(bytes)
}
