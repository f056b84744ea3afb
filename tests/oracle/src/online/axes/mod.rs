//! The judge of several axes that move together: random sets of axes, and faults that the judge must see.

pub mod faults;
pub mod judge;
pub mod line;
pub mod problems;
pub mod ruckig;
