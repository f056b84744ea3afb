//! Polynomial profiles between two prescribed ends in a prescribed time, with the operations and the rounding of liba's
//! `a_trajpoly3/5/7_*`; Biagotti & Melchiorri, *Trajectory Planning for Automatic Machines and Robots*, section 2.1.
//!
//! A coefficient array is in ascending powers of time: `c[k]` belongs to `x^k`.

use crate::sample::Sweep;
use crate::{Boundary, Real};

/// Cubic polynomial: position and velocity are prescribed at both ends.
///
/// ```
/// use atraj::{Boundary, Poly3};
/// let cubic = Poly3::new(8.0, Boundary { p0: 0.0, p1: 10.0, v0: 0.0, v1: 0.0 }).expect("finite");
/// assert_eq!((cubic.position(0.0), cubic.position(4.0), cubic.position(8.0)), (0.0, 5.0, 10.0));
/// assert_eq!((cubic.velocity(8.0), cubic.acceleration(4.0)), (0.0, 0.0));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(C)]
pub struct Poly3<R> {
    /// Coefficients of position.
    pub c: [R; 4],
}

impl<R: Real> Poly3<R> {
    /// Plans a move of duration `ts`, s, which must not be 0. `None` if a coefficient is not finite.
    pub fn new(ts: R, boundary: Boundary<R>) -> Option<Self> {
        let c = Self::coefficients(ts, boundary);
        all_finite(&c).then_some(Self { c })
    }

    /// The coefficients as they come out, finite or not: literally the C function.
    pub fn coefficients(ts: R, boundary: Boundary<R>) -> [R; 4] {
        let Boundary { p0, p1, v0, v1 } = boundary;
        let [n1, n2, n3] = [1, 2, 3].map(R::from);
        let p = p1 - p0;
        let u1 = n1 / ts;
        let u2 = u1 * u1;
        let u3 = u1 * u2;
        [
            p0,
            v0,
            u1 * (-n2 * v0 - v1) + u2 * p * n3,
            u2 * (v0 + v1) - u3 * p * n2,
        ]
    }

    /// Position at time `x`, s; the polynomial goes on outside the move.
    pub fn position(&self, x: R) -> R {
        horner(&self.c, x)
    }

    /// Velocity at time `x`, s.
    pub fn velocity(&self, x: R) -> R {
        horner(&self.velocity_coefficients(), x)
    }

    /// Acceleration at time `x`, s.
    pub fn acceleration(&self, x: R) -> R {
        horner(&self.acceleration_coefficients(), x)
    }

    /// Position, velocity and acceleration at time `x`, s.
    pub fn state(&self, x: R) -> [R; 3] {
        [self.position(x), self.velocity(x), self.acceleration(x)]
    }

    /// The states at the times `x0`, `x0 + dt`, `x0 + 2*dt`, …, s.
    pub fn states(&self, x0: R, dt: R) -> impl Iterator<Item = [R; 3]> {
        Sweep { x0, dt }.states(|x| self.state(x))
    }

    /// Writes positions, velocities and accelerations at the times `x0`, `x0 + dt`, `x0 + 2*dt`, …, s, with the bits of
    /// the single calls. Each output is filled to its own end and may be empty.
    ///
    /// Returns the number of samples: the length of the longest output, but at most `i32::MAX`.
    pub fn sample_into(&self, x0: R, dt: R, outputs: [&mut [R]; 3]) -> usize {
        let poly = *self;
        Sweep { x0, dt }.sample([], outputs, |run| run.fill(|x| poly.state(x)))
    }

    /// Coefficients of velocity.
    pub fn velocity_coefficients(&self) -> [R; 3] {
        derivative(&self.c)
    }

    /// Coefficients of acceleration.
    pub fn acceleration_coefficients(&self) -> [R; 2] {
        derivative(&self.velocity_coefficients())
    }
}

/// Quintic polynomial: position, velocity and acceleration are prescribed at both ends.
///
/// ```
/// use atraj::{Boundary, Poly5};
/// let quintic = Poly5::new(8.0, Boundary::rest_to_rest(0.0, 10.0), [0.0, 0.0]).expect("finite");
/// assert_eq!((quintic.position(0.0), quintic.position(4.0), quintic.position(8.0)), (0.0, 5.0, 10.0));
/// assert_eq!((quintic.velocity(8.0), quintic.acceleration(8.0)), (0.0, 0.0));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(C)]
pub struct Poly5<R> {
    /// Coefficients of position.
    pub c: [R; 6],
}

impl<R: Real> Poly5<R> {
    /// Plans a move of duration `ts`, s, which must not be 0, between the accelerations `[a0, a1]`. `None` if a
    /// coefficient is not finite.
    pub fn new(ts: R, boundary: Boundary<R>, acceleration: [R; 2]) -> Option<Self> {
        let c = Self::coefficients(ts, boundary, acceleration);
        all_finite(&c).then_some(Self { c })
    }

    /// The coefficients as they come out, finite or not: literally the C function.
    pub fn coefficients(ts: R, boundary: Boundary<R>, [a0, a1]: [R; 2]) -> [R; 6] {
        let Boundary { p0, p1, v0, v1 } = boundary;
        let [n1, n2, n3, n6, n8, n12] = [1, 2, 3, 6, 8, 12].map(R::from);
        let [n14, n16, n20, n30] = [14, 16, 20, 30].map(R::from);
        let half = R::HALF;
        let p = p1 - p0;
        let u1 = n1 / ts;
        let u2 = u1 * u1;
        let u3 = u1 * u2;
        let u4 = u2 * u2;
        let u5 = u2 * u3;
        [
            p0,
            v0,
            a0 * half,
            half * (u1 * (a1 - n3 * a0) - u2 * (n12 * v0 + n8 * v1) + u3 * p * n20),
            half * (u2 * (n3 * a0 - n2 * a1) + u3 * (n16 * v0 + n14 * v1) - u4 * p * n30),
            half * (u3 * (a1 - a0) - u4 * (v0 + v1) * n6 + u5 * p * n12),
        ]
    }

    /// Position at time `x`, s; the polynomial goes on outside the move.
    pub fn position(&self, x: R) -> R {
        horner(&self.c, x)
    }

    /// Velocity at time `x`, s.
    pub fn velocity(&self, x: R) -> R {
        horner(&self.velocity_coefficients(), x)
    }

    /// Acceleration at time `x`, s.
    pub fn acceleration(&self, x: R) -> R {
        horner(&self.acceleration_coefficients(), x)
    }

    /// Position, velocity and acceleration at time `x`, s.
    pub fn state(&self, x: R) -> [R; 3] {
        [self.position(x), self.velocity(x), self.acceleration(x)]
    }

    /// The states at the times `x0`, `x0 + dt`, `x0 + 2*dt`, …, s.
    pub fn states(&self, x0: R, dt: R) -> impl Iterator<Item = [R; 3]> {
        Sweep { x0, dt }.states(|x| self.state(x))
    }

    /// Writes positions, velocities and accelerations at the times `x0`, `x0 + dt`, `x0 + 2*dt`, …, s, with the bits of
    /// the single calls. Each output is filled to its own end and may be empty.
    ///
    /// Returns the number of samples: the length of the longest output, but at most `i32::MAX`.
    pub fn sample_into(&self, x0: R, dt: R, outputs: [&mut [R]; 3]) -> usize {
        let poly = *self;
        Sweep { x0, dt }.sample([], outputs, |run| run.fill(|x| poly.state(x)))
    }

    /// Coefficients of velocity.
    pub fn velocity_coefficients(&self) -> [R; 5] {
        derivative(&self.c)
    }

    /// Coefficients of acceleration.
    pub fn acceleration_coefficients(&self) -> [R; 4] {
        derivative(&self.velocity_coefficients())
    }
}

/// Septic polynomial: position, velocity, acceleration and jerk are prescribed at both ends.
///
/// ```
/// use atraj::{Boundary, Poly7};
/// let septic = Poly7::new(8.0, Boundary::rest_to_rest(0.0, 10.0), [0.0, 0.0], [0.0, 0.0]).expect("finite");
/// assert_eq!((septic.position(0.0), septic.position(4.0), septic.position(8.0)), (0.0, 5.0, 10.0));
/// assert_eq!((septic.velocity(0.0), septic.acceleration(0.0), septic.jerk(0.0)), (0.0, 0.0, 0.0));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(C)]
pub struct Poly7<R> {
    /// Coefficients of position.
    pub c: [R; 8],
}

impl<R: Real> Poly7<R> {
    /// Plans a move of duration `ts`, s, which must not be 0, between the accelerations `[a0, a1]` and the jerks
    /// `[j0, j1]`. `None` if a coefficient is not finite.
    pub fn new(ts: R, boundary: Boundary<R>, acceleration: [R; 2], jerk: [R; 2]) -> Option<Self> {
        let c = Self::coefficients(ts, boundary, acceleration, jerk);
        all_finite(&c).then_some(Self { c })
    }

    /// The coefficients as they come out, finite or not: literally the C function.
    pub fn coefficients(
        ts: R,
        boundary: Boundary<R>,
        [a0, a1]: [R; 2],
        [j0, j1]: [R; 2],
    ) -> [R; 8] {
        let Boundary { p0, p1, v0, v1 } = boundary;
        let [n1, n2, n3, n4, n12, n14, n15] = [1, 2, 3, 4, 12, 14, 15].map(R::from);
        let [n20, n30, n39, n45, n60, n78] = [20, 30, 39, 45, 60, 78].map(R::from);
        let [n90, n120, n168, n204, n210, n216] = [90, 120, 168, 204, 210, 216].map(R::from);
        let n420 = n210 + n210;
        let half = R::HALF;
        let sixth = R::SIXTH;
        let p = p1 - p0;
        let u1 = n1 / ts;
        let u2 = u1 * u1;
        let u3 = u1 * u2;
        let u4 = u2 * u2;
        let u5 = u2 * u3;
        let u6 = u3 * u3;
        let u7 = u3 * u4;
        [
            p0,
            v0,
            a0 * half,
            j0 * sixth,
            sixth
                * (u1 * (-n4 * j0 - j1) + u2 * (n15 * a1 - n30 * a0) - u3 * (n120 * v0 + n90 * v1)
                    + u4 * p * n210),
            half * (u2 * (n2 * j0 + j1) + u3 * (n20 * a0 - n14 * a1) + u4 * (n90 * v0 + n78 * v1)
                - u5 * p * n168),
            sixth
                * (u3 * (-n4 * j0 - n3 * j1) + u4 * (n39 * a1 - n45 * a0)
                    - u5 * (n216 * v0 + n204 * v1)
                    + u6 * p * n420),
            sixth * (u4 * (j0 + j1) + u5 * (a0 - a1) * n12 + u6 * (v0 + v1) * n60 - u7 * p * n120),
        ]
    }

    /// Position at time `x`, s; the polynomial goes on outside the move.
    pub fn position(&self, x: R) -> R {
        horner(&self.c, x)
    }

    /// Velocity at time `x`, s.
    pub fn velocity(&self, x: R) -> R {
        horner(&self.velocity_coefficients(), x)
    }

    /// Acceleration at time `x`, s.
    pub fn acceleration(&self, x: R) -> R {
        horner(&self.acceleration_coefficients(), x)
    }

    /// Jerk at time `x`, s.
    pub fn jerk(&self, x: R) -> R {
        horner(&self.jerk_coefficients(), x)
    }

    /// Position, velocity, acceleration and jerk at time `x`, s.
    pub fn state(&self, x: R) -> [R; 4] {
        [
            self.position(x),
            self.velocity(x),
            self.acceleration(x),
            self.jerk(x),
        ]
    }

    /// The states at the times `x0`, `x0 + dt`, `x0 + 2*dt`, …, s.
    pub fn states(&self, x0: R, dt: R) -> impl Iterator<Item = [R; 4]> {
        Sweep { x0, dt }.states(|x| self.state(x))
    }

    /// Writes positions, velocities, accelerations and jerks at the times `x0`, `x0 + dt`, `x0 + 2*dt`, …, s, with the bits of
    /// the single calls. Each output is filled to its own end and may be empty.
    ///
    /// Returns the number of samples: the length of the longest output, but at most `i32::MAX`.
    pub fn sample_into(&self, x0: R, dt: R, outputs: [&mut [R]; 4]) -> usize {
        let poly = *self;
        Sweep { x0, dt }.sample([], outputs, |run| run.fill(|x| poly.state(x)))
    }

    /// Coefficients of velocity.
    pub fn velocity_coefficients(&self) -> [R; 7] {
        derivative(&self.c)
    }

    /// Coefficients of acceleration.
    pub fn acceleration_coefficients(&self) -> [R; 6] {
        derivative(&self.velocity_coefficients())
    }

    /// Coefficients of jerk.
    pub fn jerk_coefficients(&self) -> [R; 5] {
        derivative(&self.acceleration_coefficients())
    }
}

/// The value at `x`, from the highest power down; multiplication and addition are rounded apart.
pub(crate) fn horner<R: Real>(c: &[R], x: R) -> R {
    let mut descending = c.iter().rev().copied();
    match descending.next() {
        Some(highest) => descending.fold(highest, |y, c| y * x + c),
        None => R::from(0),
    }
}

/// The coefficients of the derivative, of which there is one less: `d[k] = c[k+1]*(k+1)`.
pub(crate) fn derivative<R: Real, const N: usize>(c: &[R]) -> [R; N] {
    let mut terms = (1..).zip(c.iter().skip(1));
    core::array::from_fn(|_| match terms.next() {
        Some((power, &c)) => c * R::from(power),
        None => R::from(0),
    })
}

fn all_finite<R: Real>(c: &[R]) -> bool {
    c.iter().all(|c| c.is_finite())
}
