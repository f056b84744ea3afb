//! Double-S (bell-shaped velocity) profile, after Biagotti & Melchiorri, *Trajectory Planning for Automatic Machines
//! and Robots*, section 3.4, with the operations and the rounding of liba's `a_trajbell_*`.
//!
//! `plan` fills the struct as the C library does, with `search` for a move without cruise. `motion` evaluates the struct.
//!
//! Evaluation reads the struct in the axis in which the move goes forward: it mirrors `p0 p1 v0 v1` if `p0 > p1`, takes every
//! other field as it stands, and mirrors the result back. It relies on no sign of these fields: in a move that dips, that is,
//! decelerates before it accelerates, `vm jm am dm` belong to the dip, and have the opposite signs.

pub(crate) mod motion;
mod plan;
mod search;

use crate::findings::Error;
use crate::real::Real;
use crate::sampling::sampled;
use crate::state::{Boundary, Saturation};

/// Double-S velocity profile: jerk, acceleration and velocity are limited, and seven phases follow each other.
///
/// Jerk is piecewise constant, acceleration trapezoidal, velocity bell-shaped. It is the gentlest of the limited profiles, for a load
/// that can swing, spill or resonate. Fields carry the book's symbols. For a move towards smaller positions (`p0 > p1`) the fields `vm`,
/// `jm`, `am` and `dm` hold in the mirrored axis.
///
#[doc = include_str!("../../../docs/img/double-s-with-cruise.svg")]
///
/// ```
/// use atraj::{Bell, Boundary};
/// let boundary = Boundary { p0: 0.0, p1: 10.0, v0: 1.0, v1: 0.0 };
/// let bell = Bell::new(30.0, 10.0, 5.0, boundary).expect("the limits allow this move");
/// assert!((bell.t - 2.71_f64).abs() < 1e-12);
/// assert_eq!(bell.position(0.0), 0.0);
/// assert_eq!(bell.velocity(bell.ta), 5.0);
/// assert_eq!(bell.position(bell.t), 10.0);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(C)]
pub struct Bell<R> {
    /// Total duration, s.
    pub t: R,
    /// Duration of the constant-velocity (cruise) phase, s; 0 if there is none.
    pub tv: R,
    /// Duration of the acceleration phase, s.
    pub ta: R,
    /// Duration of the deceleration phase, s.
    pub td: R,
    /// Duration of each constant-jerk part of the acceleration phase, s.
    pub taj: R,
    /// Duration of each constant-jerk part of the deceleration phase, s.
    pub tdj: R,
    /// Initial position.
    pub p0: R,
    /// Final position.
    pub p1: R,
    /// Initial velocity, limited to the maximum velocity.
    pub v0: R,
    /// Final velocity, limited to the maximum velocity.
    pub v1: R,
    /// Highest velocity reached.
    pub vm: R,
    /// Jerk.
    pub jm: R,
    /// Highest acceleration reached.
    pub am: R,
    /// Highest deceleration reached, negative.
    pub dm: R,
}

impl<R: Real> Bell<R> {
    /// Plans a move within the magnitudes of `jerk`, `acceleration` and `velocity`; their signs are ignored.
    ///
    /// Boundary velocities beyond `±velocity` are limited to it. [`Error::Unreachable`] if liba finds no such move, or if the move
    /// takes no time; [`Error::NotFinite`] if an argument is not a number, or a position infinite; [`Error::Limits`] if a limit is 0.
    pub fn new(jerk: R, acceleration: R, velocity: R, boundary: Boundary<R>) -> Result<Self, Error> {
        Self::new_saturated(jerk, acceleration, velocity, boundary, Saturation::Everything)
    }

    /// [`Bell::new`] with the saturation of either generation of liba.
    pub fn new_saturated(
        jerk: R, acceleration: R, velocity: R, boundary: Boundary<R>, saturation: Saturation,
    ) -> Result<Self, Error> {
        let mut bell = Self::default();
        match bell.plan_saturated(jerk, acceleration, velocity, boundary, saturation) {
            Some(duration) if duration > R::ZERO => Ok(bell),
            _ => Err(Error::of_plan([jerk, acceleration, velocity], boundary, Error::Unreachable)),
        }
    }

    sampled! { 4, "Position, velocity, acceleration and jerk" }
}
