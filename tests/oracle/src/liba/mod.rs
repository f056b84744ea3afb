//! The comparison with the original: the same calls through both libraries, every result compared bit for bit.

pub mod abi;
pub mod comparison;
pub mod faults;
pub mod moves;
pub mod original;
pub mod together;
pub mod volume;

pub use abi::{Abi, Evaluate, FASTEST, Gen7, OURS, Original};
pub use comparison::{Case, MOMENTS, Moment, Report};
pub use volume::{run_seed, run_seed_of};
