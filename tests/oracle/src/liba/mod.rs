//! The comparison with the original: the same calls through both libraries, every result compared bit for bit.

pub mod abi;
pub mod comparison;
pub mod faults;
pub mod moves;
pub mod original;
pub mod together;
pub mod volume;
