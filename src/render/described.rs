//! The adapter in words, for reports of faults.

use super::Gpu;

/// Name and kind, driver, and programming interface of an adapter: a label and a text each.
#[must_use]
pub fn adapter_facts(gpu: &Gpu) -> Vec<(&'static str, String)> {
    let info = &gpu.info;
    let kind = match info.device_type {
        wgpu::DeviceType::IntegratedGpu => "integrated GPU",
        wgpu::DeviceType::DiscreteGpu => "discrete GPU",
        wgpu::DeviceType::VirtualGpu => "virtual GPU",
        wgpu::DeviceType::Cpu => "CPU",
        wgpu::DeviceType::Other => "another kind",
    };
    let api = match info.backend {
        wgpu::Backend::Vulkan => "Vulkan",
        wgpu::Backend::Metal => "Metal",
        wgpu::Backend::Dx12 => "DirectX 12",
        wgpu::Backend::Gl => "OpenGL",
        wgpu::Backend::BrowserWebGpu => "WebGPU",
        wgpu::Backend::Noop => "none",
    };
    let driver = [info.driver.as_str(), info.driver_info.as_str()].map(str::trim);
    let driver: Vec<&str> = driver.into_iter().filter(|part| !part.is_empty()).collect();
    vec![
        ("adapter", format!("{} ({kind})", info.name)),
        ("driver", if driver.is_empty() { "unknown".to_owned() } else { driver.join(", ") }),
        ("API", api.to_owned()),
    ]
}
