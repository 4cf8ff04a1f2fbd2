//! The scene: a graph of RBT nodes and shape nodes, its file, and the scenes that are built in.

mod shape;

pub use shape::{Colour, MeshKind, PlacedShape, Shape};
