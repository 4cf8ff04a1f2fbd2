//! The program: its command line, which opens the window where no other command is given; in a browser, the page.

#[cfg(not(target_arch = "wasm32"))]
fn main() -> std::process::ExitCode {
    inbetween::cli::run(std::env::args_os())
}

#[cfg(target_arch = "wasm32")]
fn main() {
    inbetween::window::start();
}
