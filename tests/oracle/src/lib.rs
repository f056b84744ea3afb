//! atraj against the original C library: the same moves through both, every result compared bit for bit.
//!
//! The original comes from the `liba` crate and is compiled by `build.rs` under other names, so that both libraries are in
//! one program and the linker cannot mistake one for the other.

pub mod abi;
pub mod bytes;
pub mod comparison;
pub mod family;
pub mod faults;
pub mod moves;
pub mod ours;
pub mod real;
pub mod reference;
pub mod together;
pub mod volume;

#[allow(missing_docs)]
#[path = "../../common/mod.rs"]
pub mod common;
