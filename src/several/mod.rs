//! Several axes that move together.
//!
//! `sync` gives all axes one duration, `within` also keeps each axis between two positions, and `line` puts them on one straight line. All
//! plan each axis as in `online`. An axis with time to spare makes a `blend` of two motions.

pub(crate) mod axis;
mod blend;
mod cruise;
pub(crate) mod cycle;
pub(crate) mod line;
mod sync;
mod within;

pub use line::{line, line_stop};
pub use sync::synchronise;
pub use within::synchronise_within;
