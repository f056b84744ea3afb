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
        let mut c = [R::from(0); 4];
        Self::write(&mut c, ts, boundary);
        c
    }

    /// Likewise, each where it belongs as soon as it is known.
    #[inline(always)]
    pub(crate) fn write(c: &mut [R; 4], ts: R, boundary: Boundary<R>) {
        let Boundary { p0, p1, v0, v1 } = boundary;
        let n = R::from;
        c[0] = p0;
        c[1] = v0;
        let p = p1 - p0;
        let u1 = n(1) / ts;
        let u2 = u1 * u1;
        let up = u2 * p * n(3);
        c[2] = (v0 * -n(2) - v1) * u1 + up;
        let up = u1 * u2 * p * n(2);
        c[3] = (v0 + v1) * u2 - up;
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
        Sweep { x0, dt }.fill(outputs, |x| poly.state(x))
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
    pub fn coefficients(ts: R, boundary: Boundary<R>, acceleration: [R; 2]) -> [R; 6] {
        let mut c = [R::from(0); 6];
        Self::write(&mut c, ts, boundary, acceleration);
        c
    }

    /// Likewise, each where it belongs as soon as it is known.
    #[inline(always)]
    pub(crate) fn write(c: &mut [R; 6], ts: R, boundary: Boundary<R>, [a0, a1]: [R; 2]) {
        let Boundary { p0, p1, v0, v1 } = boundary;
        let n = R::from;
        let half = R::HALF;
        c[0] = p0;
        c[1] = v0;
        c[2] = a0 * half;
        let p = p1 - p0;
        let u1 = n(1) / ts;
        let u2 = u1 * u1;
        let u3 = u1 * u2;
        let u4 = u2 * u2;
        c[3] = {
            let up = u3 * p * n(20);
            let v = v1 * n(8);
            let uv = (v0 * n(12) + v) * u2;
            ((a0 * -n(3) + a1) * u1 - uv + up) * half
        };
        c[4] = {
            let up = u4 * p * n(30);
            let v = v1 * n(14);
            let uv = (v0 * n(16) + v) * u3;
            let a = a0 * n(3);
            ((a1 * -n(2) + a) * u2 + uv - up) * half
        };
        c[5] = {
            let up = u2 * u3 * p * n(12);
            let uv = (v0 + v1) * u4 * n(6);
            ((a1 - a0) * u3 - uv + up) * half
        };
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
        Sweep { x0, dt }.fill(outputs, |x| poly.state(x))
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
        acceleration: [R; 2],
        jerk: [R; 2],
    ) -> [R; 8] {
        let mut c = [R::from(0); 8];
        Self::write(&mut c, ts, boundary, acceleration, jerk);
        c
    }

    /// Likewise, each where it belongs as soon as it is known.
    #[inline(always)]
    pub(crate) fn write(
        c: &mut [R; 8],
        ts: R,
        boundary: Boundary<R>,
        [a0, a1]: [R; 2],
        [j0, j1]: [R; 2],
    ) {
        let Boundary { p0, p1, v0, v1 } = boundary;
        let n = R::from;
        let half = R::HALF;
        let sixth = R::SIXTH;
        c[0] = p0;
        c[1] = v0;
        c[2] = a0 * half;
        c[3] = j0 * sixth;
        let p = p1 - p0;
        let u1 = n(1) / ts;
        let u2 = u1 * u1;
        let u3 = u1 * u2;
        let u4 = u2 * u2;
        let u5 = u2 * u3;
        c[4] = {
            let up = u4 * p * n(210);
            let v = v1 * n(90);
            let uv = (v0 * n(120) + v) * u3;
            let a = a0 * n(30);
            let ua = (a1 * n(15) - a) * u2;
            ((j0 * -n(4) - j1) * u1 + ua - uv + up) * sixth
        };
        c[5] = {
            let up = u5 * p * n(168);
            let v = v1 * n(78);
            let uv = (v0 * n(90) + v) * u4;
            let a = a1 * n(14);
            let ua = (a0 * n(20) - a) * u3;
            ((j0 * n(2) + j1) * u2 + ua + uv - up) * half
        };
        c[6] = {
            let up = u3 * u3 * p * (n(210) + n(210));
            let v = v1 * n(204);
            let uv = (v0 * n(216) + v) * u5;
            let a = a0 * n(45);
            let ua = (a1 * n(39) - a) * u4;
            let j = j1 * n(3);
            ((j0 * -n(4) - j) * u3 + ua - uv + up) * sixth
        };
        c[7] = {
            let up = u3 * u4 * p * n(120);
            let uv = (v0 + v1) * (u3 * u3) * n(60);
            let ua = (a0 - a1) * u5 * n(12);
            ((j0 + j1) * u4 + ua + uv - up) * sixth
        };
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
        Sweep { x0, dt }.fill(outputs, |x| poly.state(x))
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

/// The value at `x`, from the highest power down; multiplication and addition are rounded apart. 0 without coefficients.
#[inline(always)]
pub(crate) fn horner<R: Real>(c: &[R], x: R) -> R {
    if c.len() > 8 || cfg!(all(target_os = "none", not(soft_binary64))) {
        return match c.split_last() {
            Some((&highest, lower)) => lower.iter().rev().fold(highest, |y, c| y * x + *c),
            None => R::from(0),
        };
    }
    // A loop costs more than what it repeats. So all steps are written out, and each degree enters at its own.
    let at = |k: usize| c.get(k).copied().unwrap_or(R::from(0));
    // One load for all degrees is smaller where the sums come in the same registers anyhow, as they do from calls.
    let called = cfg!(soft_binary64) && !R::CHEAP_ROOT;
    let last = at(c.len().wrapping_sub(1));
    let highest = |k: usize| if called { last } else { at(k) };
    let c1 = 'one: {
        let c2 = 'two: {
            let c3 = 'three: {
                let c4 = 'four: {
                    let c5 = 'five: {
                        let c6 = 'six: {
                            let c7 = match c.len() {
                                8 => highest(7),
                                7 => break 'six highest(6),
                                6 => break 'five highest(5),
                                5 => break 'four highest(4),
                                4 => break 'three highest(3),
                                3 => break 'two highest(2),
                                2 => break 'one highest(1),
                                _ => return highest(0),
                            };
                            c7 * x + at(6)
                        };
                        c6 * x + at(5)
                    };
                    c5 * x + at(4)
                };
                c4 * x + at(3)
            };
            c3 * x + at(2)
        };
        c2 * x + at(1)
    };
    c1 * x + at(0)
}

/// The coefficients of the derivative of a polynomial of up to the seventh degree. Written out from the highest down: a lower
/// degree enters later.
#[inline(always)]
pub(crate) fn differentiate<R: Real>(c: &[R], derivative: &mut [R]) {
    let mut term = |power: u8| {
        let index = usize::from(power);
        if let (Some(&c), Some(d)) = (c.get(index), derivative.get_mut(index - 1)) {
            // Times 1 is left out: the bits are the same.
            *d = if power == 1 { c } else { c * R::from(power) };
        }
    };
    'one: {
        'two: {
            'three: {
                'four: {
                    'five: {
                        match c.len() {
                            8 => term(7),
                            7 => {}
                            6 => break 'five,
                            5 => break 'four,
                            4 => break 'three,
                            3 => break 'two,
                            2 => break 'one,
                            _ => return,
                        }
                        term(6);
                    }
                    term(5);
                }
                term(4);
            }
            term(3);
        }
        term(2);
    }
    term(1);
}

/// The coefficients of the derivative of a polynomial.
#[inline(always)] // what is left of it is smaller than a call
pub(crate) fn derivative<R: Real, const N: usize, const M: usize>(c: &[R; N]) -> [R; M] {
    let mut derivative = [R::from(0); M];
    differentiate(c, &mut derivative);
    derivative
}

fn all_finite<R: Real>(c: &[R]) -> bool {
    c.iter().all(|c| c.is_finite())
}
