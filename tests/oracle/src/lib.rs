//! atraj against the original C library: the same moves through both, every result compared bit for bit.
//!
//! The original comes from the `liba` crate. `build.rs` compiles it under other names, so that both libraries are in one
//! program and the linker cannot mistake one for the other.

pub mod abi;
pub mod bytes;
pub mod comparison;
pub mod faults;
pub mod judge;
pub mod moves;
pub mod nasty;
pub mod online;
pub mod original;
pub mod referee;
pub mod together;
pub mod volume;

pub use support::Family;
