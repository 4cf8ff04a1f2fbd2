//! Which graphics drivers the Vulkan loader opens. It opens all that are installed, a millisecond or more each, before it asks what
//! they drive.

use std::collections::BTreeSet;
use std::env;
use std::path::Path;

use crate::render::{DRIVER_VARIABLES, SELECTED_DRIVERS, SOFTWARE_DRIVER, software_alone};
use crate::storage;

/// Devices through which GPUs are driven: where none exists, there is no GPU.
const GPU_DEVICES: [&str; 5] = ["/dev/dri", "/dev/nvidiactl", "/dev/nvidia0", "/dev/kfd", "/dev/dxg"];
/// Where distributions put the files that describe drivers to the loader.
const MANIFESTS: &str = "/usr/share/vulkan/icd.d";
/// The most of these files that are looked at.
const MOST_MANIFESTS: usize = 100;
/// Leaves out Mesa's layer that sorts GPUs, which asks the display for them.
const NO_CHOICE: &str = "NODEVICE_SELECT";
/// What this process has loaded, a line each that ends with a path.
const LOADED: &str = "/proc/self/maps";
/// More than that ever has.
const LARGEST_LOADED_BYTES: u64 = 16 << 20;
/// A folder with an entry for each thread of this process.
const THREADS: &str = "/proc/self/task";

/// Where there is no GPU and Mesa's software driver is installed, has the loader open that driver alone.
///
/// To be called first in a process: once there is another thread, it does nothing.
pub fn leave_out_useless_ones() {
    // On other machines, GPUs have devices of other names.
    let is_known = cfg!(target_arch = "x86_64");
    let has_gpu = || GPU_DEVICES.iter().any(|path| storage::exists(Path::new(path)));
    let is_chosen = || DRIVER_VARIABLES.iter().any(|name| env::var_os(name).is_some());
    let is_only_thread = || storage::list(Path::new(THREADS), 1).is_ok_and(|(_, count)| count == 1);
    if is_known && !is_chosen() && !has_gpu() && has_software() && is_only_thread() {
        #[expect(unsafe_code, reason = "the loader can only be told through the environment")]
        // SAFETY: this thread is the only one, as was just checked, so that none reads the environment meanwhile.
        unsafe {
            env::set_var(SELECTED_DRIVERS, software_alone());
            env::set_var(NO_CHOICE, "1");
        }
    }
}

/// The libraries of drivers that are loaded, for where one of them hangs; `None` where there are none.
pub fn loaded() -> Option<String> {
    /// Parts of their names. The loader's own name has a dot after it.
    const DRIVERS: [&str; 4] = ["vulkan_", "_dri", "nvidia", "amdvlk"];
    let maps = storage::read(Path::new(LOADED), LARGEST_LOADED_BYTES).ok()?;
    let maps = String::from_utf8_lossy(&maps);
    let names = maps.lines().filter_map(|line| Some(line.rsplit_once('/')?.1));
    let drivers: BTreeSet<&str> = names.filter(|name| DRIVERS.iter().any(|part| name.contains(part))).collect();
    (!drivers.is_empty()).then(|| drivers.into_iter().collect::<Vec<_>>().join(", "))
}

fn has_software() -> bool {
    let manifests = storage::list(Path::new(MANIFESTS), MOST_MANIFESTS).map(|(entries, _)| entries);
    manifests.unwrap_or_default().iter().any(|entry| entry.name.starts_with(SOFTWARE_DRIVER))
}
