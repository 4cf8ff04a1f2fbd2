//! The environment variables by which users choose graphics drivers.

use std::env;

/// The variable by which the Vulkan loader selects drivers.
pub const SELECTED_DRIVERS: &str = "VK_LOADER_DRIVERS_SELECT";
/// How the name of the file begins that describes Mesa's software driver.
pub const SOFTWARE_DRIVER: &str = "lvp_icd";

/// Variables by which users choose drivers or adapters.
pub const DRIVER_VARIABLES: [&str; 9] = [
    SELECTED_DRIVERS,
    "VK_LOADER_DRIVERS_DISABLE",
    "VK_DRIVER_FILES",
    "VK_ICD_FILENAMES",
    "VK_ADD_DRIVER_FILES",
    "VK_LOADER_DEVICE_SELECT",
    "MESA_VK_DEVICE_SELECT",
    "GALLIUM_DRIVER",
    "__EGL_VENDOR_LIBRARY_FILENAMES",
];

/// The value of [`SELECTED_DRIVERS`] by which this program has Mesa's software driver alone opened.
#[must_use]
pub fn software_alone() -> String {
    format!("{SOFTWARE_DRIVER}*")
}

/// The variables that are set, as in `VK_DRIVER_FILES is "/a.json"`; `None` where there are none. The choice of this program does not
/// count.
pub(super) fn chosen_drivers() -> Option<String> {
    let set = DRIVER_VARIABLES.iter().filter_map(|&name| Some((name, env::var_os(name)?)));
    let chosen = set.filter(|(name, value)| *name != SELECTED_DRIVERS || *value != *software_alone());
    let said: Vec<String> = chosen.map(|(name, value)| format!("{name} is \"{}\"", value.display())).collect();
    (!said.is_empty()).then(|| said.join(", "))
}
