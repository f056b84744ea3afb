//! The judge of the moves from any state to any state: nasty problems, a slow referee, and faults that the judge must see.

pub mod axes;
pub mod faults;
pub mod judge;
pub mod problems;
pub mod referee;
pub mod replan;
pub mod ruckig;
pub mod simplify;
