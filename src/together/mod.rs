//! Several axes that move together.
//!
//! `sync` gives all axes one duration, and `line` puts them on one straight line. Both plan each axis as in `online`. An axis with time to
//! spare makes a `blend` of two motions. `track` lets one axis follow a signal by such blends. `path` passes way points without stops.

mod axis;
mod blend;
mod cruise;
mod cycle;
mod line;
mod line_stop;
pub mod path;
mod sync;
mod track;

pub use line::line;
pub use line_stop::line_stop;
pub use sync::synchronise;
