//! The polynomials, in one of the two generations of their structs.

#[cfg(feature = "poly-compact")]
mod compact;
#[cfg(not(feature = "poly-compact"))]
mod levels;

#[cfg(feature = "poly-compact")]
pub use compact::{trajpoly3, trajpoly5, trajpoly7};
#[cfg(not(feature = "poly-compact"))]
pub use levels::{trajpoly3, trajpoly5, trajpoly7};
