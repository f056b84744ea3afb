//! One judge of all motions. A double-S is a motion without acceleration at its ends, and with the same limits in both directions. A
//! trapezoid has no limit of the jerk.
//!
//! [`problems`] makes adversarial problems, [`planner`] has the planners under test, [`solver`] knows the fastest motion, [`trial`] says what
//! is wrong with a plan, [`tally`] counts, and [`faults`] show that the judge sees a fault.

pub mod axes;
pub mod exact;
pub mod faults;
pub mod group;
pub mod inside;
pub mod path;
pub mod planner;
pub mod problem;
pub mod problems;
pub mod rivals;
pub mod solver;
pub mod steps;
pub mod tally;
pub mod trial;

pub use planner::{Fastest, Plan, Planner, Profile};
pub use problem::{POWERS_OF_TIME, Problem, Request, beyond_legal, parts, widened};
pub use problems::{Kind, Problems};
pub use tally::{MOVES_PER_SEED, PROFILES_PER_SEED, Tallies, Tally};
pub use trial::{Check, LEAVES, OF_A_MOVE, Scale, Trial, Verdict, are_of_a_move, doubt, tolerance};
