//! How the desktop knows the window, by name and icon; where it is and how large: at first it fits its monitor; later it is where it was
//! when it was closed.

#[cfg(not(target_arch = "wasm32"))]
use winit::dpi::PhysicalPosition;
use winit::dpi::{LogicalSize, PhysicalSize};
use winit::event_loop::ActiveEventLoop;
use winit::monitor::MonitorHandle;
use winit::window::{Icon, Window, WindowAttributes};

use crate::picture::Image;
use crate::settings::WindowPlace;

/// The window's icon, a PNG. It is made of `assets/linux/inbetween.svg`.
const ICON: &[u8] = include_bytes!("../../assets/linux/inbetween-64.png");

/// The window's size at first, in points.
const SIZE: [f64; 2] = [1280.0, 800.0];
/// The smallest size at which the panels leave room for the scene, in points.
const SMALLEST: [f64; 2] = [360.0, 480.0];
/// What a monitor has for the inside of a window: the rest is for the frame and for the desktop's panels.
const SHARE: f64 = 0.9;
/// How much of a window has to be on a monitor, in pixels, so that it can be taken by its frame.
const SEEN: i64 = 64;

/// A monitor.
#[derive(Clone, Copy, Debug)]
struct Monitor {
    min_px: [i64; 2],
    size_px: [u32; 2],
    scale: f64,
}

impl From<MonitorHandle> for Monitor {
    fn from(monitor: MonitorHandle) -> Self {
        let (position, size) = (monitor.position(), monitor.size());
        let min_px = [position.x, position.y].map(i64::from);
        Self { min_px, size_px: [size.width, size.height], scale: monitor.scale_factor() }
    }
}

impl Monitor {
    /// The largest size in points that a window fits on it.
    fn room(self) -> [f64; 2] {
        self.size_px.map(|side| f64::from(side) * SHARE / self.scale)
    }

    /// Whether a window whose top left corner is there can be seen on it and taken.
    fn shows(self, at_px: [i32; 2]) -> bool {
        (0..2).all(|axis| {
            let inside = i64::from(at_px[axis]) - self.min_px[axis];
            inside > -SEEN / 4 && inside + SEEN < i64::from(self.size_px[axis])
        })
    }
}

/// Where a window opens.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Opening {
    size: [f64; 2],
    smallest: [f64; 2],
    at_px: Option<[i32; 2]>,
}

/// A window as it was, or the usual one, on monitors of which the first is the main one.
fn opening(kept: Option<&WindowPlace>, monitors: &[Monitor]) -> Opening {
    let at_px = kept.and_then(|kept| kept.at_px).filter(|&at_px| monitors.iter().any(|monitor| monitor.shows(at_px)));
    let monitor = match at_px {
        Some(at_px) => monitors.iter().find(|monitor| monitor.shows(at_px)),
        None => monitors.first(),
    };
    let room = monitor.map_or([f64::INFINITY; 2], |monitor| monitor.room());
    let wanted = kept.map_or(SIZE, |kept| kept.size.map(f64::from));
    let within = |size: [f64; 2], axis: usize| size[axis].min(room[axis]).floor();
    let smallest = [0, 1].map(|axis| within(SMALLEST, axis));
    let size = [0, 1].map(|axis| within(wanted, axis).max(smallest[axis]));
    Opening { size, smallest, at_px }
}

/// What a window is to be made with: in a page it is the canvas.
#[cfg(target_arch = "wasm32")]
pub fn attributes(_: &ActiveEventLoop, _: Option<&WindowPlace>) -> WindowAttributes {
    super::page::attributes()
}

/// What a window is to be made with that opens where it was.
#[cfg(not(target_arch = "wasm32"))]
pub fn attributes(event_loop: &ActiveEventLoop, kept: Option<&WindowPlace>) -> WindowAttributes {
    let main = event_loop.primary_monitor();
    let others = event_loop.available_monitors().filter(|monitor| Some(monitor) != main.as_ref());
    let monitors: Vec<Monitor> = main.iter().cloned().chain(others).map(Monitor::from).collect();
    let opening = opening(kept, &monitors);
    let logical = |[width, height]: [f64; 2]| LogicalSize::new(width, height);
    let attributes = Window::default_attributes()
        .with_inner_size(logical(opening.size))
        .with_min_inner_size(logical(opening.smallest))
        .with_maximized(kept.is_some_and(|kept| kept.is_maximized))
        .with_window_icon(icon())
        .with_visible(false);
    let attributes = named(attributes);
    match opening.at_px {
        Some([x, y]) => attributes.with_position(PhysicalPosition::new(x, y)),
        None => attributes,
    }
}

/// The icon for window systems that take one from the window: X11 and Windows.
fn icon() -> Option<Icon> {
    let Image { width, height, rgba } = Image::from_png(ICON).ok()?;
    Icon::from_rgba(rgba, width, height).ok()
}

/// The application id, on Wayland, and the class of the window, on X11: desktops find `inbetween.desktop` by it.
#[cfg(all(unix, not(target_os = "macos")))]
fn named(attributes: WindowAttributes) -> WindowAttributes {
    // The method for X11 sets the same field.
    winit::platform::wayland::WindowAttributesExtWayland::with_name(attributes, "inbetween", "inbetween")
}

#[cfg(not(all(unix, not(target_os = "macos"))))]
fn named(attributes: WindowAttributes) -> WindowAttributes {
    attributes
}

/// Where a window is now; `before` is where it was before it was maximised, if it is.
pub fn of_window(window: &Window, before: Option<&WindowPlace>) -> Option<WindowPlace> {
    if window.is_maximized() {
        return before.map(|before| WindowPlace { is_maximized: true, ..before.clone() });
    }
    let inner: PhysicalSize<u32> = window.inner_size();
    if inner.width == 0 || inner.height == 0 {
        return None;
    }
    let size: LogicalSize<f32> = inner.to_logical(window.scale_factor());
    let at_px = window.outer_position().ok().map(|at| [at.x, at.y]);
    Some(WindowPlace::new([size.width, size.height], at_px))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn monitor(size_px: [u32; 2], scale: f64) -> Monitor {
        Monitor { min_px: [0, 0], size_px, scale }
    }

    #[test]
    fn the_first_window_fits_its_monitor() {
        let size = |monitors: &[Monitor]| opening(None, monitors).size;
        assert_eq!(size(&[]), SIZE);
        assert_eq!(size(&[monitor([1920, 1080], 1.0)]), SIZE);
        assert_eq!(size(&[monitor([1366, 768], 1.0)]), [1229.0, 691.0]);
        let small = opening(None, &[monitor([1366, 768], 2.0)]);
        assert_eq!((small.size, small.smallest), ([614.0, 345.0], [360.0, 345.0]));
    }

    #[test]
    fn a_window_opens_where_it_was_if_that_can_still_be_seen() {
        let kept = |at_px| WindowPlace::new([900.0, 600.0], Some(at_px));
        let right = Monitor { min_px: [1366, 0], ..monitor([1920, 1080], 1.0) };
        let both = [monitor([1366, 768], 1.0), right];
        let open = |at_px, monitors: &[Monitor]| opening(Some(&kept(at_px)), monitors);
        assert_eq!(open([1500, 40], &both).at_px, Some([1500, 40]));
        assert_eq!(open([1500, 40], &both[..1]).at_px, None);
        assert_eq!(open([1500, 40], &both[..1]).size, [900.0, 600.0]);
        for lost in [[-2000, 0], [100, 5000], [1330, 10]] {
            assert_eq!(open(lost, &both[..1]).at_px, None, "{lost:?}");
        }
    }

    #[test]
    fn the_icon_can_be_read() {
        assert!(icon().is_some());
    }

    #[test]
    fn a_kept_size_is_neither_too_large_nor_too_small() {
        let size = |size| {
            let kept = WindowPlace::new(size, None);
            opening(Some(&kept), &[monitor([1366, 768], 1.0)]).size
        };
        assert_eq!(size([2000.0, 2000.0]), [1229.0, 691.0]);
        assert_eq!(size([100.0, 100.0]), [360.0, 480.0]);
    }
}
