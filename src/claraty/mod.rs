//! CLARAty's trapezoid: a target, start and stop at any time, and a setpoint whenever the controller asks.
//!
//! Two modes share one profile. [`Mode::Corrected`] keeps the promise of CLARAty's class: a motion starts in any state, ends at rest at the target,
//! and neither jumps nor overshoots without need. [`Mode::Listing`] gives the published listing's numbers, bit for bit, wrong motions included.
//!
//! Nothing here reads a clock. A method that needs the time takes it as `now`: a finite number of seconds from any fixed origin.
//!
//! ```
//! use atraj::claraty::{Target, Trajectory};
//! let mut axis = Trajectory::default();
//! let target = Target { position: 10.0, velocity: 2.0, acceleration: 4.0, deceleration: 4.0 };
//! axis.set(target.into(), 0.0)?;
//! axis.start(0.0);
//! assert_eq!(axis.duration(), 5.5);
//! let now = axis.setpoint(3.0);
//! assert_eq!((now.position, now.velocity, now.acceleration), (5.5, 2.0, 0.0));
//! axis.stop(3.0); // feed hold: brakes from here
//! assert_eq!(axis.setpoint(3.5).position, 6.0);
//! # Ok::<(), atraj::claraty::OutOfRange>(())
//! ```

mod profile;
mod route;
mod trajectory;

pub use profile::{EPS, Kind, Profile, Warnings};
pub use route::{LARGEST, OutOfRange, Route, Target, Waypoints};
pub use trajectory::{Mode, Trajectory};
