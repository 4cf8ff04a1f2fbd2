//! Goal 5: from the start of the process to a PNG of the default scene, beside the bare program that draws one box.

#[path = "../render/bare.rs"]
mod bare;

use std::process::{Command, Stdio};

use inbetween::render::Image;

use crate::report::{Report, in_turn};

/// With this argument, and a path after it, the benchmark is the bare program.
pub const BARE: &str = "--be-the-bare-program";

/// The bare program: one box, as a PNG, with the same encoder.
pub fn be_bare(path: &str) {
    let rgba = bare::Bare::new().draw();
    let image = Image { width: bare::WIDTH, height: bare::HEIGHT, rgba };
    std::fs::write(path, image.to_png().expect("a PNG")).expect("a file");
}

/// 5. A whole process.
pub fn process(report: &mut Report) {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let picture = folder.path().join("picture.png");
    let quiet = |mut command: Command| {
        command.stdout(Stdio::null()).stderr(Stdio::null());
        move || assert!(command.status().expect("it starts").success(), "{command:?}")
    };
    let mut ours = Command::new(env!("CARGO_BIN_EXE_inbetween"));
    ours.arg("render").arg("-o").arg(&picture);
    let mut bare = Command::new(std::env::current_exe().expect("the benchmark's own path"));
    bare.arg(BARE).arg(folder.path().join("bare.png"));
    let (mut ours, mut bare) = (quiet(ours), quiet(bare));
    // Caches are warm from the second time on.
    ours();
    bare();
    let [ours, bare] = in_turn(40, [&mut ours, &mut bare]);
    assert!(picture.exists(), "`inbetween render` wrote a picture");
    report.at_most("a process that renders the default scene", ours, bare, 1.15);
    report.at_most("the same, as was asked before there were goals", ours, bare, 1.3);
}
