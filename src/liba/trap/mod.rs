//! Trapezoidal velocity profile with the operations and the rounding of liba's `a_trajtrap_*`; Biagotti & Melchiorri,
//! *Trajectory Planning for Automatic Machines and Robots*, section 3.2.
//!
//! `plan` fills the struct as the C library does, and `motion` evaluates it.

pub(crate) mod motion;
mod plan;

use crate::findings::Error;
use crate::real::Real;
use crate::state::{Boundary, Saturation};

/// Trapezoidal velocity profile: acceleration and velocity are limited; acceleration, cruise and deceleration follow each other.
///
/// No profile within the same limits of velocity and acceleration is faster, but the acceleration jumps at every border of a phase.
/// Fields carry the book's symbols and are signed: for a move towards smaller positions `vc` and `a0` are negative.
///
#[doc = include_str!("../../../docs/img/trapezoid-with-cruise.svg")]
///
/// ```
/// use atraj::{Boundary, Trap};
/// let trap = Trap::new(5.0, 4.0, -2.0, Boundary::rest_to_rest(0.0, 50.0)).expect("a feasible move");
/// assert_eq!((trap.ta, trap.cruise_end, trap.t), (1.25, 9.375, 11.875));
/// assert_eq!(trap.velocity(5.0), 5.0);
/// assert_eq!(trap.position(trap.t), 50.0);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(C)]
pub struct Trap<R> {
    /// Total duration, s.
    pub t: R,
    /// Initial position.
    pub p0: R,
    /// Final position.
    pub p1: R,
    /// Initial velocity, limited to the maximum velocity.
    pub v0: R,
    /// Final velocity: the demanded one limited to the maximum velocity, or what can be reached on the way.
    pub v1: R,
    /// Constant (cruise) velocity, or the highest reached.
    pub vc: R,
    /// Time at which the acceleration phase ends, s.
    pub ta: R,
    /// Time at which the deceleration phase starts, s.
    pub cruise_end: R,
    /// Position at `ta`.
    pub pa: R,
    /// Position at `cruise_end`.
    pub pd: R,
    /// Acceleration before `ta`.
    pub a0: R,
    /// Acceleration after `cruise_end`.
    pub a1: R,
}

impl<R: Real> Trap<R> {
    /// Plans a move with the highest velocity `velocity` (its sign is ignored), and these two accelerations.
    ///
    /// `acceleration` and `deceleration` are signed: a forward move has `acceleration > 0` and `deceleration < 0`, a backward one the opposite. Boundary
    /// velocities beyond `±velocity` are limited to it; a final velocity out of reach is replaced by the one that is
    /// reached. [`Error::Unreachable`] if liba finds no such move, or if the move takes no time; [`Error::NotFinite`] if an argument
    /// is not a number, or a position infinite; [`Error::Limits`] if a limit is 0.
    pub fn new(velocity: R, acceleration: R, deceleration: R, boundary: Boundary<R>) -> Result<Self, Error> {
        Self::new_saturated(velocity, acceleration, deceleration, boundary, Saturation::Everything)
    }

    /// [`Trap::new`] with the saturation of either generation of liba.
    pub fn new_saturated(
        velocity: R, acceleration: R, deceleration: R, boundary: Boundary<R>, saturation: Saturation,
    ) -> Result<Self, Error> {
        let mut trap = Self::default();
        match trap.plan_saturated(velocity, acceleration, deceleration, boundary, saturation) {
            Some(duration) if duration > R::ZERO => Ok(trap),
            _ => Err(Error::of_plan([velocity, acceleration, deceleration], boundary, Error::Unreachable)),
        }
    }
}
