//! The structs of liba 0.1.15: the coefficients of position and, up to the level of the build, the coefficients of its derivatives.

pub mod trajpoly3;
pub mod trajpoly5;
pub mod trajpoly7;
