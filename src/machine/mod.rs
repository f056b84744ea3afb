//! What a control loop holds: an axis whose plans come from the main loop and whose setpoints go to a timer interrupt, the [`Clock`] of
//! a path, the [`Steps`] of a motor, and the [`Shaper`] of a load.
//!
//! A plan takes long: 115,000 instructions on a Cortex-M0 in `double`, more than two milliseconds at 48 MHz. The setpoint of the next
//! millisecond cannot wait for it. So the interrupt follows the move in force while the main loop plans the next one, from the state
//! that the axis will have some ticks ahead. Then the next move takes over at exactly this tick.
//!
//! ```
//! use atraj::machine::Axis;
//! use atraj::online::{Limits, State};
//! let limits = Limits::symmetric(30.0, 10.0, 5.0);
//! let mut axis = Axis::new(0.001, State::at(0.0))?;
//! let (mut planner, mut ticker) = axis.split();
//! planner.go(&limits, State::at(10.0), 4)?;
//! let states: Vec<_> = (0..700).map(|_| ticker.tick()).collect();
//! assert_eq!((states[3].velocity, states[4].velocity > 0.0), (0.0, true));
//! planner.go(&limits, State::at(-2.0), 4)?; // in mid-motion
//! let last = (0..4000).map(|_| ticker.tick()).last();
//! assert_eq!(last, Some(State::at(-2.0)));
//! # Ok::<(), atraj::Error>(())
//! ```
//!
//! The halves of the axis are safe on both sides. Here one loop has both; in firmware the ticker is the interrupt's. `docs/machine.md` has
//! programs with a group, steps, shapers, and streams of both.

#[allow(unsafe_code)] // the moves of an axis, which `handover` proves to be used by one side at a time
mod axis;
mod change;
mod clock;
mod enclosure;
#[allow(unsafe_code)] // as above
pub(crate) mod group;
mod handover;
mod lead;
mod sections;
mod shaper;
mod steps;

pub use axis::{Axis, Planner, Ticker};
pub use clock::Clock;
use core::sync::atomic;
pub use group::{Group, GroupPlanner, GroupTicker, Tick};
pub use shaper::{Shaper, ShaperKind, ShaperStream};
pub use steps::{Step, StepStream, Steps};
