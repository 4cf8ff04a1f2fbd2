//! Models of other programs: glTF files made by hand for each thing that a file can hold.

mod make;
mod reading;
