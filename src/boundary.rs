//! Boundary conditions shared by every profile.

use crate::Real;

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
    /// Velocity at the end, signed likewise.
    pub v1: R,
}

impl<R: Real> Boundary<R> {
    /// A move that begins and ends at standstill.
    pub fn rest_to_rest(p0: R, p1: R) -> Self {
        let zero = R::from(0);
        Self {
            p0,
            p1,
            v0: zero,
            v1: zero,
        }
    }

    /// The same with both velocities limited to `±vm`.
    pub(crate) fn limit_velocities(self, vm: R) -> Self {
        Self {
            v0: self.v0.limit(-vm, vm),
            v1: self.v1.limit(-vm, vm),
            ..self
        }
    }

    /// The same move seen from the other direction of the axis.
    pub(crate) fn mirrored(self) -> Self {
        Self {
            p0: -self.p0,
            p1: -self.p1,
            v0: -self.v0,
            v1: -self.v1,
        }
    }
}
