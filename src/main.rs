//! The program: its command line, which opens the window where no other command is given.

use std::process::ExitCode;

fn main() -> ExitCode {
    #[cfg(target_os = "linux")]
    drivers::leave_out_useless_ones();
    inbetween::cli::run(std::env::args_os())
}

/// Which drivers the Vulkan loader opens. It opens all that are installed, a millisecond or more each, before it says what they drive.
#[cfg(target_os = "linux")]
mod drivers {
    use std::path::Path;
    use std::{env, fs};

    /// What drives a GPU goes through one of these.
    const GPU_DEVICES: [&str; 5] = ["/dev/dri", "/dev/nvidiactl", "/dev/nvidia0", "/dev/kfd", "/dev/dxg"];
    /// Where distributions put what describes a driver to the loader.
    const MANIFESTS: &str = "/usr/share/vulkan/icd.d";
    /// Mesa's software driver, by the start of its description's name.
    const SOFTWARE: &str = "lvp_icd";
    /// The loader's list of descriptions to read, and what else decides on them.
    const SELECTED: &str = "VK_LOADER_DRIVERS_SELECT";
    const DECIDING: [&str; 5] =
        [SELECTED, "VK_LOADER_DRIVERS_DISABLE", "VK_DRIVER_FILES", "VK_ICD_FILENAMES", "VK_ADD_DRIVER_FILES"];
    /// Mesa's way to leave out its layer that puts GPUs into order, which asks the display for them.
    const NO_CHOICE: &str = "NODEVICE_SELECT";

    /// Where there is no GPU and Mesa's software driver is installed, has the loader open that alone. Whoever sets one of the loader's own
    /// variables is left in charge.
    pub fn leave_out_useless_ones() {
        // Other machines have GPUs behind other names.
        let is_known = cfg!(target_arch = "x86_64");
        let has_gpu = || GPU_DEVICES.iter().any(|path| Path::new(path).exists());
        let is_decided = || DECIDING.iter().any(|name| env::var_os(name).is_some());
        if is_known && !is_decided() && !has_gpu() && has_software() {
            #[expect(unsafe_code, reason = "the loader can only be told through the environment")]
            // SAFETY: this is the start of the process's only thread, so that none reads the environment meanwhile.
            unsafe {
                env::set_var(SELECTED, format!("{SOFTWARE}*"));
                env::set_var(NO_CHOICE, "1");
            }
        }
    }

    fn has_software() -> bool {
        let mut names = fs::read_dir(MANIFESTS).into_iter().flatten().flatten().map(|entry| entry.file_name());
        names.any(|name| name.to_string_lossy().starts_with(SOFTWARE))
    }
}
