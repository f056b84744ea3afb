//! Where an axis is, and where a move starts and ends.

use crate::real::Real;

/// Position, velocity and acceleration of an axis at one instant, all signed.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(C)]
pub struct State<R> {
    /// Position.
    pub position: R,
    /// Velocity: positive towards larger positions.
    pub velocity: R,
    /// Acceleration: positive where the velocity grows.
    pub acceleration: R,
}

impl<R: Real> State<R> {
    /// At rest.
    pub const fn at(position: R) -> Self {
        Self { position, velocity: R::ZERO, acceleration: R::ZERO }
    }

    /// The state after the time `t`, s, at this jerk.
    pub(crate) fn after(self, t: R, jerk: R) -> Self {
        let Self { position, velocity, acceleration } = self;
        Self {
            position: position + t * (velocity + t * (R::HALF * acceleration + t * jerk * R::SIXTH)),
            velocity: velocity + t * (acceleration + R::HALF * t * jerk),
            acceleration: acceleration + t * jerk,
        }
    }

    pub(crate) fn mirrored(self) -> Self {
        let Self { position, velocity, acceleration } = self;
        Self { position: -position, velocity: -velocity, acceleration: -acceleration }
    }

    /// The state in the other order of time, as the mirrored axis sees it: velocities stay.
    pub(crate) fn reversed(self) -> Self {
        let Self { position, velocity, acceleration } = self;
        Self { position: -position, velocity, acceleration: -acceleration }
    }

    pub(crate) fn is_at_rest(self) -> bool {
        self.velocity == R::ZERO && self.acceleration == R::ZERO
    }

    pub(crate) fn is_finite(self) -> bool {
        // A product with 0 is 0 for finite numbers only.
        let Self { position, velocity, acceleration } = self;
        (position * R::ZERO + velocity * R::ZERO) + acceleration * R::ZERO == R::ZERO
    }
}

/// How a plan limits the velocities at both ends. The generations of liba differ for a NaN, and for a zero if the limit is 0.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Saturation {
    /// liba up to 0.1.15: a NaN becomes the negative limit, and so does a zero if the limit is 0.
    #[default]
    Everything,
    /// liba since 2025: a NaN stays NaN, and a zero keeps its sign.
    Numbers,
}

/// Where a move starts and ends: position and velocity at both ends.
///
/// ```
/// use atraj::Boundary;
/// let there = Boundary { p0: 0.0, p1: 10.0, v0: 1.0, v1: 0.0 };
/// let back = Boundary::rest_to_rest(10.0, 0.0);
/// assert_eq!((there.p1, back.v0), (back.p0, there.v1));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Boundary<R> {
    /// Position at the start.
    pub p0: R,
    /// Position at the end.
    pub p1: R,
    /// Velocity at the start, signed: positive towards larger positions.
    pub v0: R,
    /// Velocity at the end, signed: positive towards larger positions.
    pub v1: R,
}

impl<R: Real> Boundary<R> {
    /// A move that begins and ends at standstill.
    pub fn rest_to_rest(p0: R, p1: R) -> Self {
        Self { p0, p1, v0: R::ZERO, v1: R::ZERO }
    }

    /// The move with both velocities limited to `-vm … vm`.
    pub(crate) fn limit_velocities(self, vm: R, saturation: Saturation) -> Self {
        let limit = match saturation {
            Saturation::Everything => R::limit,
            Saturation::Numbers => R::limit_numbers,
        };
        Self { v0: limit(self.v0, vm), v1: limit(self.v1, vm), ..self }
    }

    /// Whether the positions are finite and no velocity is NaN.
    pub(crate) fn is_numbers(self) -> bool {
        let is_nan = |v: R| v.partial_cmp(&v).is_none();
        self.p0.is_finite() && self.p1.is_finite() && !is_nan(self.v0) && !is_nan(self.v1)
    }
}

/// Whether the axis dips first, because the direct ramp gets farther than the displacement `h`.
///
/// Where the direct ramp ends at the target up to rounding, it is the move. Its direction is that of its final velocity `v1`, else of
/// its first one, else of the displacement. `positions` is the sum of the magnitudes of both positions, in the unit of `h`.
pub(crate) fn dips<R: Real>(h: R, direct: R, positions: R, [v0, v1]: [R; 2]) -> bool {
    let tie = R::EPSILON * (R::from(4) * (h.abs() + direct.abs()) + positions);
    let is_direct = (h - direct).abs() <= tie;
    if !is_direct {
        h < direct
    } else if v1 != R::ZERO {
        v1 < R::ZERO
    } else if v0 != R::ZERO {
        v0 < R::ZERO
    } else {
        h < R::ZERO
    }
}
