//! The command line, by running the binary: bytes in; bytes, files and exit statuses out.

#[cfg(target_os = "linux")]
mod action;
mod again;
mod bounds;
mod check;
mod class;
mod class_mistakes;
mod compare;
mod comparing;
mod convert;
mod diagnose;
mod diff;
mod even;
mod export;
mod feedback;
mod films;
mod formats;
mod frames;
mod generate;
mod grade;
mod grade_start;
mod help;
mod journal;
mod marks;
mod models;
mod other_files;
mod overrides;
mod places;
#[cfg(unix)]
mod platforms;
mod playback;
mod render;
mod report;
mod report_class;
mod requirements;
mod results;
mod roster;
mod sample;
mod sandbox;
mod script;
mod several;
mod share;
#[cfg(target_os = "linux")]
mod signals;
#[path = "../student/mod.rs"]
mod student;
mod usage;
mod verify;
