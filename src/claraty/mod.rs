//! CLARAty's trapezoid: a target, start and stop at any time, and a setpoint whenever the controller asks.
//!
//! Two ways to plan share one profile. [`Mode::Corrected`] keeps what CLARAty's class documents: from any position and
//! velocity to the target, at rest there, without a jump and without a needless overshoot. [`Mode::Listing`] gives the
//! published listing's numbers, bit for bit, with its wrong motions.
//!
//! Nothing here reads a clock: every method that needs the time takes it as `now`, in seconds from any fixed origin.
//!
//! ```
//! use atraj::claraty::{Target, Trajectory};
//! let mut axis = Trajectory::default();
//! axis.set(Target { position: 10.0, velocity: 2.0, acceleration: 4.0, deceleration: 4.0 }.into(), 0.0);
//! axis.start(0.0);
//! assert_eq!(axis.duration(), 5.5);
//! let now = axis.setpoint(3.0);
//! assert_eq!((now.position, now.velocity, now.acceleration), (5.5, 2.0, 0.0));
//! axis.stop(3.0); // feed hold: brakes from here
//! assert_eq!(axis.setpoint(3.5).position, 6.0);
//! ```

mod clock;
mod profile;
mod route;
mod trajectory;

pub use clock::Timer;
pub use profile::{EPS, Kind, Profile, Warnings};
pub use route::{Route, Target, Waypoints};
pub use trajectory::{Mode, Trajectory};
