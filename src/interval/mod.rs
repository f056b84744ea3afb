//! The displacements that an axis can reach in a duration. They form an interval, because limits are convex: a mean of two motions within
//! the limits keeps the limits and travels the mean.
//!
//! `border` is the motion that covers the largest displacement, `derivatives` are those of its displacement, and `crossing` is the first duration in which
//! it gets as far as wanted. `docs/planner.md` has the theory.

pub(crate) mod border;
pub(crate) mod crossing;
pub(crate) mod derivatives;
mod piece;
pub(crate) mod profile;
pub(crate) mod ramp;
pub(crate) mod rounding;
