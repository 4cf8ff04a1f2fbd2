//! Scenes with meshes of triangles: their files, picking and pictures.

#[path = "meshes/files.rs"]
mod files;
#[path = "common/golden.rs"]
mod golden;
#[path = "meshes/models.rs"]
mod models;
#[path = "meshes/picking.rs"]
mod picking;
#[path = "meshes/pictures.rs"]
mod pictures;
