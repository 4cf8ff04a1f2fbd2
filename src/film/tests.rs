//! Films of generated pictures, decoded again.

use std::io::Cursor;

use super::formats::Palette;
use super::*;
use crate::picture::Image;

/// A gradient with a block at a distance in pixels from the left. Around the block it is opaque or transparent.
fn picture(left: u32, is_opaque: bool) -> Image {
    let (width, height) = (31_u32, 18_u32);
    let mut rgba = Vec::new();
    for y in 0..height {
        for x in 0..width {
            let is_block = (left..left + 6).contains(&x) && (5..12).contains(&y);
            let [shade, tint] = [(7 * x).to_le_bytes()[0], (13 * y).to_le_bytes()[0]];
            rgba.extend(if is_block {
                [220, 40, 30, 255]
            } else {
                [shade, tint, 128, if is_opaque { 255 } else { 0 }]
            });
        }
    }
    Image { width, height, rgba }
}

fn encoder(format: &Format) -> FilmFormat {
    match format.encoder {
        Encoder::Film(film) | Encoder::Ffmpeg(film) => film,
        Encoder::Still(_) => panic!("{format:?} is of single pictures"),
    }
}

fn film(format: &Format, is_opaque: bool) -> Vec<u8> {
    let plan = Plan { width: 31, height: 18, frames: 4, frames_per_second: 30, is_opaque };
    let pictures: Vec<Image> = [2, 5, 5, 9].map(|left| picture(left, is_opaque)).into();
    let mut bytes = Vec::new();
    let mut film = Film::new(encoder(format), plan, &pictures, &mut bytes).unwrap();
    for (index, picture) in pictures.iter().enumerate() {
        let ms = |index: usize| f64::from(u32::try_from(index).unwrap()) * 1000.0 / 30.0;
        film.push(picture, ms(index), ms(index + 1)).unwrap();
    }
    film.finish().unwrap();
    bytes
}

/// The pictures of a GIF, each whole, and their times in hundredths of a second.
fn gif_pictures(bytes: &[u8]) -> (Vec<Vec<u8>>, Vec<u16>) {
    let mut options = ::gif::DecodeOptions::new();
    options.set_color_output(::gif::ColorOutput::RGBA);
    let mut decoder = options.read_info(Cursor::new(bytes)).unwrap();
    let (width, height) = (usize::from(decoder.width()), usize::from(decoder.height()));
    let (mut canvas, mut pictures, mut delays) = (vec![0; 4 * width * height], Vec::new(), Vec::new());
    while let Some(frame) = decoder.read_next_frame().unwrap() {
        for (index, pixel) in frame.buffer.chunks_exact(4).enumerate() {
            let (x, y) = (index % usize::from(frame.width), index / usize::from(frame.width));
            let at = 4 * ((y + usize::from(frame.top)) * width + x + usize::from(frame.left));
            if pixel[3] > 0 {
                canvas[at..at + 4].copy_from_slice(pixel);
            }
        }
        pictures.push(canvas.clone());
        delays.push(frame.delay);
        if frame.dispose == ::gif::DisposalMethod::Background {
            canvas.fill(0);
        }
    }
    (pictures, delays)
}

#[test]
fn a_gif_shows_the_pictures_and_what_does_not_move_does_not_flicker() {
    let bytes = film(&GIF, true);
    assert_eq!(bytes, film(&GIF, true));
    let (pictures, delays) = gif_pictures(&bytes);
    assert_eq!(delays, [3, 4, 3, 3]);
    assert_eq!(pictures[1], pictures[2]);
    for (found, left) in pictures.iter().zip([2, 5, 5, 9]) {
        let expected = picture(left, true);
        for (index, (found, expected)) in found.chunks_exact(4).zip(expected.rgba.chunks_exact(4)).enumerate() {
            let is_near = found.iter().zip(expected).all(|(a, b)| a.abs_diff(*b) < 40);
            assert!(is_near, "pixel {index}: {found:?}, expected {expected:?}");
        }
        let still = |picture: &[u8]| picture[..4 * 31 * 4].to_vec();
        assert_eq!(still(found), still(&pictures[0]));
    }
}

#[test]
fn a_gif_keeps_what_is_transparent() {
    let (pictures, _) = gif_pictures(&film(&GIF, false));
    for (found, left) in pictures.iter().zip([2, 5, 5, 9]) {
        let expected = picture(left, false);
        assert!(found.chunks_exact(4).zip(expected.rgba.chunks_exact(4)).all(|(a, b)| a[3] == b[3]));
    }
}

#[test]
fn a_gif_does_not_write_noise_that_nobody_sees() {
    let plan = Plan { width: 64, height: 32, frames: 3, frames_per_second: 25, is_opaque: true };
    let level = |x: u32, y: u32| 40 + (x + 2 * y) as u8;
    let noisy = |noise: u8| {
        let pixels = (0..32).flat_map(|y| (0..64).map(move |x| (x, y)));
        let rgba = pixels.flat_map(|(x, y)| [level(x, y), 90 + noise * (x % 2) as u8, level(y, x), 255]).collect();
        Image { width: 64, height: 32, rgba }
    };
    let pictures = [noisy(0), noisy(1), noisy(2)];
    let mut bytes = Vec::new();
    let mut film = Film::new(encoder(&GIF), plan, &pictures, &mut bytes).unwrap();
    for (index, picture) in pictures.iter().enumerate() {
        film.push(picture, 40.0 * index as f64, 40.0 * (index + 1) as f64).unwrap();
    }
    film.finish().unwrap();
    let (shown, _) = gif_pictures(&bytes);
    assert!(shown[0] == shown[1], "a change of one level shows");
    assert!(shown[1] != shown[2], "two changes of one level do not add up");
}

/// The pictures of a WebP, each whole, and their times in milliseconds.
fn webp_pictures(bytes: &[u8]) -> (Vec<Image>, Vec<u32>) {
    use image::AnimationDecoder as _;
    let decoder = image::codecs::webp::WebPDecoder::new(Cursor::new(bytes)).unwrap();
    let frames = decoder.into_frames().collect_frames().unwrap();
    let ms = frames
        .iter()
        .map(|frame| frame.delay().numer_denom_ms())
        .map(|(numerator, denominator)| numerator / denominator);
    let ms = ms.collect();
    let picture = |frame: image::Frame| {
        let (width, height) = frame.buffer().dimensions();
        Image { width, height, rgba: frame.into_buffer().into_raw() }
    };
    (frames.into_iter().map(picture).collect(), ms)
}

#[test]
fn a_webp_film_shows_the_pictures_for_their_times() {
    let webp = format_of_ending("webp").unwrap().of_films();
    for is_opaque in [true, false] {
        let bytes = film(webp, is_opaque);
        assert_eq!(bytes, film(webp, is_opaque));
        assert_eq!(bytes[..4], *b"RIFF");
        assert_eq!(bytes.len() as u32, 8 + u32::from_le_bytes(*bytes[4..].first_chunk().unwrap()));
        // It is lossy.
        assert!(bytes.windows(4).any(|chunk| chunk == b"VP8 ") && !bytes.windows(4).any(|chunk| chunk == b"VP8L"));
        let (pictures, ms) = webp_pictures(&bytes);
        // The second and the third are the same. Four thirtieths of a second, rounded once.
        assert_eq!(ms, [33, 67, 33]);
        for (found, left) in pictures.iter().zip([2, 5, 9]) {
            let expected = picture(left, is_opaque);
            assert_eq!((found.width, found.height), (31, 18));
            let mut sum = 0;
            for (found, expected) in found.rgba.chunks_exact(4).zip(expected.rgba.chunks_exact(4)) {
                assert_eq!(found[3], expected[3]);
                if expected[3] > 0 {
                    sum += (0..3).map(|channel| u32::from(found[channel].abs_diff(expected[channel]))).sum::<u32>();
                }
            }
            assert!(sum < 8 * 3 * 31 * 18, "left {left}: {sum} levels");
        }
    }
}

#[test]
fn few_colours_are_kept_exactly() {
    let two = Image { width: 2, height: 1, rgba: vec![1, 2, 3, 255, 250, 251, 252, 255] };
    let palette = Palette::of(std::slice::from_ref(&two));
    assert_eq!(palette.colours(), [[1, 2, 3], [250, 251, 252]]);
    let plan = Plan { width: 2, height: 1, frames: 1, frames_per_second: 25, is_opaque: true };
    let mut bytes = Vec::new();
    let mut film = Film::new(encoder(&GIF), plan, std::slice::from_ref(&two), &mut bytes).unwrap();
    film.push(&two, 0.0, 40.0).unwrap();
    film.finish().unwrap();
    let (pictures, delays) = gif_pictures(&bytes);
    assert_eq!((&pictures[0], &delays[..]), (&two.rgba, &[4][..]));
}

#[test]
fn an_apng_holds_every_picture_to_the_bit() {
    for is_opaque in [true, false] {
        let bytes = film(&APNG, is_opaque);
        let mut reader = png::Decoder::new(Cursor::new(&bytes)).read_info().unwrap();
        assert_eq!(
            reader.info().animation_control.map(|control| (control.num_frames, control.num_plays)),
            Some((4, 0))
        );
        for left in [2, 5, 5, 9] {
            let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
            reader.next_frame(&mut pixels).unwrap();
            let control = reader.info().frame_control.unwrap();
            assert_eq!((control.delay_num, control.delay_den), (1, 30));
            let expected = picture(left, is_opaque).rgba;
            let channels = if is_opaque { 3 } else { 4 };
            assert!(expected.chunks_exact(4).zip(pixels.chunks_exact(channels)).all(|(a, b)| a[..channels] == *b));
        }
    }
}

#[test]
fn a_y4m_has_its_header_and_so_many_bytes_a_picture() {
    let bytes = film(&Y4M, true);
    let header = b"YUV4MPEG2 W31 H18 F30:1 Ip A1:1 C420jpeg XCOLORRANGE=LIMITED\n";
    assert!(bytes.starts_with(header));
    assert_eq!(bytes.len(), header.len() + 4 * (6 + 31 * 18 + 2 * 16 * 9));
    // Grey is the same in both matrices; the values of primary colours are those of the two standards.
    for format in [&Y4M, &MP4] {
        assert_eq!(yuv(format, [0; 3]), [16, 128, 128]);
        assert_eq!(yuv(format, [255; 3]), [235, 128, 128]);
    }
    let primaries = [[255, 0, 0], [0, 255, 0], [0, 0, 255]];
    assert_eq!(primaries.map(|colour| yuv(&Y4M, colour)), [[81, 90, 240], [145, 54, 34], [41, 240, 110]]);
    assert_eq!(primaries.map(|colour| yuv(&MP4, colour)), [[63, 102, 240], [173, 42, 26], [32, 240, 118]]);
}

/// Luma and the two chromas of a picture of one colour.
fn yuv(format: &Format, [r, g, b]: [u8; 3]) -> [u8; 3] {
    let plan = Plan { width: 2, height: 2, frames: 1, frames_per_second: 1, is_opaque: true };
    let mut bytes = Vec::new();
    let mut film = Film::new(encoder(format), plan, &[], &mut bytes).unwrap();
    film.push(&Image { width: 2, height: 2, rgba: [r, g, b, 255].repeat(4) }, 0.0, 1.0).unwrap();
    film.finish().unwrap();
    let [luma, others @ .., blue, red] = bytes.last_chunk::<6>().unwrap();
    assert_eq!(others, &[*luma; 3]);
    [*luma, *blue, *red]
}

#[test]
fn a_contact_sheet_has_its_pictures_in_rows() {
    let cells = [2, 5, 9].map(|left| Cell { picture: picture(left, true), caption: Vec::new() });
    let sheet = contact_sheet(Grid { columns: 2, rows: 2 }, &cells);
    assert_eq!((sheet.width, sheet.height), (2 * 35 + 4, 2 * 22 + 4));
    assert_eq!(sheet.pixel(4 + 9, 4 + 22 + 6), Some([220, 40, 30, 255]));
    assert_eq!(sheet.pixel(4 + 35 + 9, 4 + 22 + 6), Some([0x1b, 0x1d, 0x21, 255]));
}

#[test]
fn a_picture_of_another_size_is_refused() {
    let plan = Plan { width: 3, height: 3, frames: 1, frames_per_second: 1, is_opaque: true };
    let mut bytes = Vec::new();
    let mut film = Film::new(encoder(&Y4M), plan, &[], &mut bytes).unwrap();
    let error = film.push(&picture(1, true), 0.0, 1.0).unwrap_err();
    assert_eq!(error.to_string(), "a picture of 31x18 pixels in a film of 3x3");
}
