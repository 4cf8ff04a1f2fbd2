//! *Inbetween*, a desktop 3D keyframe animator: the library behind the `inbetween` program.
//!
#![doc = include_str!("../assets/manual/architecture.md")]
//!
//! # The modules, in reading order
//!
//! A module imports only from lines above its own; `tests/tidy.rs` checks it by reading the sources.
//!
//! | level | modules | may name |
//! |---|---|---|
//! | 0 | [`rbt`], [`interpolation`], [`json`] | glam |
//! | 0 | [`manual`] | pulldown-cmark |
//! | 1 | [`timed`], [`pose`], [`blend`], [`scene`], [`camera`] | serde, in file formats |
//! | 2 | [`keyframe`], [`clock`], [`settings`], [`text_layouts`] | serde, in file formats; `Duration`, never `Instant` |
//! | 3 | [`editor`], [`diagnosis`], [`difference`] | no wgpu, egui, winit, file system |
//! | 4 | [`frame`] | |
//! | 5 | [`render`], [`ui`] | wgpu; egui |
//! | 6 | [`compare`], [`film`] | pictures in, numbers and bytes out |
//! | 6 | [`storage`] | the file system |
//! | 7 | [`export`] | of the outside world only `ffmpeg` |
//! | 8 | [`window`], [`cli`] | winit; clap |
//!
#![doc = include_str!("../assets/manual/glossary.md")]

pub mod blend;
pub mod camera;
pub mod cli;
pub mod clock;
pub mod compare;
pub mod diagnosis;
pub mod difference;
pub mod editor;
pub mod export;
pub mod film;
pub mod frame;
pub mod interpolation;
pub mod json;
pub mod keyframe;
pub mod manual;
pub mod pose;
pub mod rbt;
pub mod render;
pub mod scene;
pub mod settings;
pub mod storage;
pub mod text_layouts;
pub mod timed;
pub mod ui;
pub mod window;
