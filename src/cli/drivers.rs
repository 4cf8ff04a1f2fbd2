//! Which graphics drivers the Vulkan loader opens. It opens all that are installed, a millisecond or more each, before it asks what
//! they drive.

use std::env;
use std::path::Path;

use crate::storage;

/// Devices through which GPUs are driven: where none exists, there is no GPU.
const GPU_DEVICES: [&str; 5] = ["/dev/dri", "/dev/nvidiactl", "/dev/nvidia0", "/dev/kfd", "/dev/dxg"];
/// Where distributions put the files that describe drivers to the loader.
const MANIFESTS: &str = "/usr/share/vulkan/icd.d";
/// The most of these files that are looked at.
const MOST_MANIFESTS: usize = 100;
/// How the name of the file begins that describes Mesa's software driver.
const SOFTWARE: &str = "lvp_icd";
/// The environment variable by which the loader selects drivers.
const SELECTED: &str = "VK_LOADER_DRIVERS_SELECT";
/// Environment variables by which a user chooses drivers; if any is set, the choice is left alone.
const CHOOSING: [&str; 5] =
    [SELECTED, "VK_LOADER_DRIVERS_DISABLE", "VK_DRIVER_FILES", "VK_ICD_FILENAMES", "VK_ADD_DRIVER_FILES"];
/// Leaves out Mesa's layer that sorts GPUs, which asks the display for them.
const NO_CHOICE: &str = "NODEVICE_SELECT";
/// A folder with an entry for each thread of this process.
const THREADS: &str = "/proc/self/task";

/// Where there is no GPU and Mesa's software driver is installed, has the loader open that driver alone.
///
/// To be called first in a process: once there is another thread, it does nothing.
pub fn leave_out_useless_ones() {
    // On other machines, GPUs have devices of other names.
    let is_known = cfg!(target_arch = "x86_64");
    let has_gpu = || GPU_DEVICES.iter().any(|path| storage::exists(Path::new(path)));
    let is_chosen = || CHOOSING.iter().any(|name| env::var_os(name).is_some());
    let is_only_thread = || storage::list(Path::new(THREADS), 1).is_ok_and(|(_, count)| count == 1);
    if is_known && !is_chosen() && !has_gpu() && has_software() && is_only_thread() {
        #[expect(unsafe_code, reason = "the loader can only be told through the environment")]
        // SAFETY: this thread is the only one, as was just checked, so that none reads the environment meanwhile.
        unsafe {
            env::set_var(SELECTED, format!("{SOFTWARE}*"));
            env::set_var(NO_CHOICE, "1");
        }
    }
}

fn has_software() -> bool {
    let manifests = storage::list(Path::new(MANIFESTS), MOST_MANIFESTS).map(|(entries, _)| entries);
    manifests.unwrap_or_default().iter().any(|entry| entry.name.starts_with(SOFTWARE))
}
