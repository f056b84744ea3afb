//! What most tests import: the library's types and functions, both real types, and random numbers.

pub use crate::{Random, Real, online, test_both_reals};
pub use atraj::axes::*;
pub use atraj::machine::*;
pub use atraj::online::{Limits, Move, Phase};
pub use atraj::{Bell, Boundary, Error, Extremes, Findings, Poly, Poly3, Poly5, Poly7, Saturation, State, Trap};
