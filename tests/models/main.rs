//! Models of other programs: glTF files made by hand for each thing that a file can hold.

mod features;
#[path = "../common/golden.rs"]
mod golden;
mod importing;
mod judged;
mod make;
mod meshes;
mod mutants;
mod pictures;
#[path = "../common/random_numbers.rs"]
mod random_numbers;
mod reading;
mod scales;
mod trips;
