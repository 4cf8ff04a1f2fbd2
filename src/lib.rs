//! *Inbetween*, a desktop 3D keyframe animator: the library behind the `inbetween` program.
//!
//! # The idea in one picture
//!
//! ```text
//! winit event ─ window::input ─┐
//! egui widgets ─ ui ───────────┼─► Command ─► Editor::apply ─► Result<Option<Effect>, CommandError>
//! script lines ─ script ───────┘                    │               └► a Host performs: read, write, quit
//! wall time ─ AnimationClock ─► n ticks ─► Editor::tick(n)
//!                                                   ▼ (shared borrow from here on)
//!                       Editor::displayed_pose() ─► Pose ─► view::frame_of_editor
//!                                                                 ▼
//!                                       Renderer::encode(&Frame, Target)
//!                                           ▲ the window's next picture ▲ an offscreen texture
//!                                           window                      cli, tests
//! ```
//!
//! State has one owner, the [`editor::Editor`], and one door, [`editor::Command`]. A hotkey, a button, a menu item and a script line
//! that mean the same thing are the same command: they cannot drift apart, all can be undone, and all can be tested without a window.
//! Everything downstream only reads. The window and the headless commands share one [`render::Renderer`], which gets a texture view
//! and cannot tell whose it is.
//!
//! # The modules, in reading order
//!
//! A module imports only from modules of a lower level, and from those before it in its own row. `tests/tidy.rs` reads this table and
//! checks it against the sources.
//!
//! | level | modules | may name |
//! |---|---|---|
//! | 0 | [`words`] | serde, for the code of a language in settings |
//! | 0 | [`rbt`], [`interpolation`], [`rotation_rules`], [`json`], [`colour`], [`picture`], [`text`], [`parallel`] | glam |
//! | 1 | [`timed`], [`pose`], [`blend`], [`scene`], [`camera`] | serde, in file formats |
//! | 2 | [`keyframe`], [`clock`], [`settings`], [`text_layouts`], [`frame`], [`film`] | serde, in file formats; `Duration`, never `Instant` |
//! | 3 | [`editor`], [`diagnosis`], [`difference`] | no wgpu, egui, winit, file system |
//! | 4 | [`view`] | |
//! | 5 | [`render`], [`ui`] | wgpu; egui |
//! | 6 | [`compare`] | pictures in, numbers out |
//! | 6 | [`storage`] | the file system |
//! | 7 | [`export`] | of the outside world only `ffmpeg` |
//! | 8 | [`files`], [`script`] | named files to values; text to commands, run without a window |
//! | 9 | [`grading`], [`references`] | bytes or folders in, values out |
//! | 10 | [`window`], [`cli`] | winit; clap |
//!
//! # Invariants, as absences
//!
//! * The editor cannot fail because of the outside world: text, ticks and commands go in, values come out.
//! * The clock on the wall is read only in `window` and `cli`, through one function each.
//! * `render` never names `editor`: whatever can be drawn can be drawn headless.
//! * No `Rc`, no `RefCell`, no mutable global state: a static is a constant, or a cache that is filled once with what never differs.
//! * Playback never writes the document while it runs; ending, stopping and pausing are commands, which do.
//!
//! # Conventions
//!
//! * **Spaces**: `target_from_source`, as in `world_from_node = world_from_parent * parent_from_node`; points end in `_in_world`.
//!   Spaces are node, parent, world (right-handed, Y up), eye (−Z forward), clip (reversed depth, 0 to 1), pixel (origin at the top
//!   left).
//! * **Time**: ticks of 1/60 s; `key_time` counts played keyframes; `_ms`, `seconds` or `Duration` for wall time.
//! * **Indices** are newtypes: [`keyframe::KeyframeIndex`], [`pose::RbtIndex`], [`scene::NodeId`].
//!
//! # Where this differs from the first design
//!
//! * Keys at their own times have a module of their own, [`timed`], below the scene that holds them; the scene's world matrices take
//!   the elapsed seconds beside the pose.
//! * The control points of a spline belong to the shared storage of a [`keyframe::KeyframeList`]: one cell an interval, filled when
//!   first asked for and dropped with the list's state, so that a change of a long list costs nothing for intervals that nobody looks at.
//! * [`interpolation`] says what a blend of two transforms is; whole poses are made by [`blend`], sixteen nodes at a time, and a
//!   [`pose::Pose`] lies in memory as that wants it. Tests hold the two together.
//! * A scene is part of the document, since its control nodes and keys can be edited: a change shares all that stayed as it was.
//! * The renderer draws what may be seen, the nearest first, and round parts in the detail that their pixels show, in the sun's map
//!   in the detail that its texels show; it uploads what changed.
//! * What takes a software driver long is begun before it is needed: shaders are parsed while the driver opens, and the sun's map is
//!   sent off while the picture's pipelines are made. `cli` has the Vulkan loader leave out drivers that have nothing to drive.
//! * Where the CPU draws for an X server, the window's pictures go through memory that both share, not through the driver's surface,
//!   which may send them through a socket.
//! * Playback's position is an exact fraction, since the pace can change while it plays and the end must come at the right tick.
//! * A writing effect says whether the file is known to the editor: a window keeps a copy of what it would overwrite unseen.

pub mod blend;
pub mod camera;
pub mod cli;
pub mod clock;
pub mod colour;
pub mod compare;
pub mod diagnosis;
pub mod difference;
pub mod editor;
pub mod export;
pub mod files;
pub mod film;
pub mod frame;
pub mod grading;
pub mod interpolation;
pub mod json;
pub mod keyframe;
pub mod parallel;
pub mod picture;
pub mod pose;
pub mod rbt;
pub mod references;
pub mod render;
pub mod rotation_rules;
pub mod scene;
pub mod script;
pub mod settings;
pub mod storage;
pub mod text;
pub mod text_layouts;
pub mod timed;
pub mod ui;
pub mod view;
pub mod window;
pub mod words;
