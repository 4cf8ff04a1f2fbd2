//! *Inbetween*, a desktop 3D keyframe animator: the library behind the `inbetween` program.
//!
#![doc = include_str!("../assets/manual/architecture.md")]
//!
//! # The modules, in reading order
//!
//! A module imports only from modules of a lower level, and from those before it in its own row. `tests/tidy.rs` reads this table and
//! checks it against the sources.
//!
//! | level | modules | may name |
//! |---|---|---|
//! | 0 | [`words`], [`text`], [`rbt`], [`interpolation`], [`rotation_rules`], [`json`], [`colour`], [`lighting`], [`picture`], [`decode`], [`parallel`], [`limb`], [`unfinished`], [`markup`], [`junit`], [`model`], [`gltf`], [`notices`] | glam; `words` may name serde: settings store language codes; `decode` and `gltf` read by serde; `markup` hashes by sha2 |
//! | 0 | [`manual`] | pulldown-cmark |
//! | 1 | [`timed`], [`pose`], [`blend`], [`scene`], [`camera`] | serde, in file formats |
//! | 2 | [`keyframe`], [`pose_file`], [`clock`], [`settings`], [`text_layouts`], [`frame`], [`film`], [`unit_mesh`] | serde, in file formats; `Duration`, never `Instant` |
//! | 3 | [`editor`], [`diagnosis`], [`animation_diff`], [`interchange`] | no wgpu, egui, winit, file system |
//! | 4 | [`view`] | |
//! | 5 | [`render`], [`ui`] | wgpu; egui |
//! | 6 | [`flip`] | pictures in, numbers out |
//! | 6 | [`storage`] | the file system; in a page js-sys |
//! | 7 | [`signals`] | signal-hook |
//! | 7 | [`facts`] | the environment |
//! | 7 | [`export`] | of the outside world only `ffmpeg` |
//! | 8 | [`files`], [`script`] | named files to values; text to commands, run without a window |
//! | 9 | [`grading`], [`references`] | bytes or folders in, values out |
//! | 9 | [`journal`] | commands to a file before they are done, and back |
//! | 10 | [`window`], [`cli`] | winit, wgpu, egui, in a page wasm-bindgen; clap |
//!
#![doc = include_str!("../assets/manual/glossary.md")]
// A page has no command line, no threads and no signals: what only those use is not used there.
#![cfg_attr(target_arch = "wasm32", allow(dead_code))]

pub mod animation_diff;
pub mod blend;
pub mod camera;
#[cfg(not(target_arch = "wasm32"))]
pub mod cli;
pub mod clock;
pub mod colour;
pub mod decode;
pub mod diagnosis;
pub mod editor;
pub mod export;
pub mod facts;
pub mod files;
pub mod film;
pub mod flip;
pub mod frame;
pub mod gltf;
#[cfg(not(target_arch = "wasm32"))]
pub mod grading;
pub mod interchange;
pub mod interpolation;
pub mod journal;
pub mod json;
pub mod junit;
pub mod keyframe;
pub mod lighting;
pub mod limb;
pub mod manual;
pub mod markup;
pub mod model;
pub mod notices;
pub mod parallel;
pub mod picture;
pub mod pose;
pub mod pose_file;
pub mod rbt;
#[cfg(not(target_arch = "wasm32"))]
pub mod references;
pub mod render;
pub mod rotation_rules;
pub mod scene;
pub mod script;
pub mod settings;
#[cfg(not(target_arch = "wasm32"))]
pub mod signals;
pub mod storage;
pub mod text;
pub mod text_layouts;
pub mod timed;
pub mod ui;
pub mod unfinished;
pub mod unit_mesh;
pub mod view;
pub mod window;
pub mod words;
