//! The trajectories of the C library liba, bit for bit.

pub(crate) mod bell;
pub(crate) mod poly;
pub(crate) mod trap;

pub use bell::Bell;
pub use poly::{Poly, Poly3, Poly5, Poly7};
pub use trap::Trap;
