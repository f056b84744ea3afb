//! Polynomial profiles between two prescribed ends in a prescribed time, with the operations and the rounding of liba's
//! `a_trajpoly3/5/7_*`; Biagotti & Melchiorri, *Trajectory Planning for Automatic Machines and Robots*, section 2.1.

/// The bodies that differ between targets: two files with one face.
#[cfg_attr(target_os = "none", path = "bare_metal.rs")]
#[cfg_attr(not(target_os = "none"), path = "host.rs")]
#[allow(dead_code, reason = "the structs of C store what a polynomial computes")]
pub(crate) mod target;

use crate::findings::{Error, Extremes};
use crate::real::Real;
use crate::sampling::{Sweep, states};
use crate::state::Boundary;

/// Polynomial of time with `N` coefficients.
///
/// It is the position of an axis: a move of [`Poly3`], [`Poly5`] or [`Poly7`], or the derivative of such a move. The move takes exactly
/// the given time, so several axes stay in step. Nothing limits the motion between its ends, and the polynomial goes on outside them.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Poly<R, const N: usize> {
    /// Coefficients in ascending powers of time: `c[k]` belongs to `x^k`.
    pub c: [R; N],
}

/// Cubic polynomial: position and velocity are prescribed at both ends.
///
/// ```
/// use atraj::{Boundary, Poly3};
/// let cubic = Poly3::new(8.0, Boundary { p0: 0.0, p1: 10.0, v0: 0.0, v1: 0.0 }).expect("finite");
/// assert_eq!((cubic.position(0.0), cubic.position(4.0), cubic.position(8.0)), (0.0, 5.0, 10.0));
/// assert_eq!((cubic.velocity(8.0), cubic.acceleration(4.0)), (0.0, 0.0));
/// ```
pub type Poly3<R> = Poly<R, 4>;

/// Quintic polynomial: position, velocity and acceleration are prescribed at both ends.
pub type Poly5<R> = Poly<R, 6>;

/// Septic polynomial: position, velocity, acceleration and jerk are prescribed at both ends.
///
#[doc = include_str!("../../../docs/img/septic-polynomial.svg")]
pub type Poly7<R> = Poly<R, 8>;

impl<R: Real> Poly3<R> {
    /// Plans a move that lasts `duration`, s. [`Error::Duration`] if `duration` is 0 or not a number; [`Error::NotFinite`] if a coefficient is not finite.
    pub fn new(duration: R, boundary: Boundary<R>) -> Result<Self, Error> {
        Self::planned(duration, |poly| poly.plan(duration, boundary))
    }

    /// [`Poly3::new`] in place and literally the C function: the coefficients as they come out, finite or not.
    pub fn plan(&mut self, duration: R, boundary: Boundary<R>) {
        let Boundary { p0, p1, v0, v1 } = boundary;
        let c = &mut self.c;
        let n = R::from;
        let h = p1 - p0;
        let u1 = R::ONE / duration;
        let u2 = u1 * u1;
        let u3 = u1 * u2;
        c[0] = p0;
        c[1] = v0;
        c[2] = u1 * (-n(2) * v0 - v1) + u2 * h * n(3);
        c[3] = u2 * (v0 + v1) - u3 * h * n(2);
    }
}

impl<R: Real> Poly5<R> {
    /// Plans a move that lasts `duration`, s, between the accelerations `[a0, a1]`. It returns the errors of [`Poly3::new`].
    pub fn new(duration: R, boundary: Boundary<R>, acceleration: [R; 2]) -> Result<Self, Error> {
        Self::planned(duration, |poly| poly.plan(duration, boundary, acceleration))
    }

    /// [`Poly5::new`] in place and literally the C function: the coefficients as they come out, finite or not.
    pub fn plan(&mut self, duration: R, boundary: Boundary<R>, [a0, a1]: [R; 2]) {
        let Boundary { p0, p1, v0, v1 } = boundary;
        let c = &mut self.c;
        let n = R::from;
        let h = p1 - p0;
        let u1 = R::ONE / duration;
        let u2 = u1 * u1;
        let u3 = u1 * u2;
        let u4 = u2 * u2;
        let u5 = u2 * u3;
        c[0] = p0;
        c[1] = v0;
        c[2] = a0 * R::HALF;
        c[3] = R::HALF * (u1 * (a1 - n(3) * a0) - u2 * (n(12) * v0 + n(8) * v1) + u3 * h * n(20));
        c[4] = R::HALF * (u2 * (n(3) * a0 - n(2) * a1) + u3 * (n(16) * v0 + n(14) * v1) - u4 * h * n(30));
        c[5] = R::HALF * (u3 * (a1 - a0) - u4 * (v0 + v1) * n(6) + u5 * h * n(12));
    }
}

impl<R: Real> Poly7<R> {
    /// Plans a move that lasts `duration`, s, between the accelerations `[a0, a1]` and the jerks `[j0, j1]`. It returns the errors of [`Poly3::new`].
    pub fn new(duration: R, boundary: Boundary<R>, acceleration: [R; 2], jerk: [R; 2]) -> Result<Self, Error> {
        Self::planned(duration, |poly| poly.plan(duration, boundary, acceleration, jerk))
    }

    /// [`Poly7::new`] in place and literally the C function: the coefficients as they come out, finite or not.
    pub fn plan(&mut self, duration: R, boundary: Boundary<R>, [a0, a1]: [R; 2], [j0, j1]: [R; 2]) {
        let Boundary { p0, p1, v0, v1 } = boundary;
        let c = &mut self.c;
        let n = R::from;
        let h = p1 - p0;
        let u1 = R::ONE / duration;
        let u2 = u1 * u1;
        let u3 = u1 * u2;
        let u4 = u2 * u2;
        let u5 = u2 * u3;
        let u6 = u3 * u3;
        let u7 = u3 * u4;
        c[0] = p0;
        c[1] = v0;
        c[2] = a0 * R::HALF;
        c[3] = j0 * R::SIXTH;
        c[4] = R::SIXTH
            * (u1 * (-n(4) * j0 - j1) + u2 * (n(15) * a1 - n(30) * a0) - u3 * (n(120) * v0 + n(90) * v1)
                + u4 * h * n(210));
        c[5] = R::HALF
            * (u2 * (n(2) * j0 + j1) + u3 * (n(20) * a0 - n(14) * a1) + u4 * (n(90) * v0 + n(78) * v1)
                - u5 * h * n(168));
        c[6] = R::SIXTH
            * (u3 * (-n(4) * j0 - n(3) * j1) + u4 * (n(39) * a1 - n(45) * a0) - u5 * (n(216) * v0 + n(204) * v1)
                + u6 * h * (n(210) + n(210)));
        c[7] = R::SIXTH * (u4 * (j0 + j1) + u5 * (a0 - a1) * n(12) + u6 * (v0 + v1) * n(60) - u7 * h * n(120));
    }
}

impl<R: Real, const N: usize> Poly<R, N> {
    /// Position at time `x`, s.
    pub fn position(&self, x: R) -> R {
        self.derivative_at(0, x)
    }

    /// Velocity at time `x`, s.
    pub fn velocity(&self, x: R) -> R {
        self.derivative_at(1, x)
    }

    /// Acceleration at time `x`, s.
    pub fn acceleration(&self, x: R) -> R {
        self.derivative_at(2, x)
    }

    /// Jerk at time `x`, s.
    pub fn jerk(&self, x: R) -> R {
        self.derivative_at(3, x)
    }

    /// Position, velocity, acceleration and jerk at time `x`, s.
    pub fn state(&self, x: R) -> [R; 4] {
        [self.position(x), self.velocity(x), self.acceleration(x), self.jerk(x)]
    }

    states! { 4 }

    /// Writes positions, velocities, accelerations and jerks, as [`Bell::sample_into`](crate::Bell::sample_into).
    pub fn sample_into(&self, x0: R, dt: R, outputs: [&mut [R]; 4]) -> usize {
        let poly = *self;
        Sweep { x0, dt }.fill(outputs, |x| poly.state(x))
    }

    /// The lowest and the highest position, velocity and acceleration between 0 and `duration`, s. A polynomial limits none of them.
    pub fn extremes(&self, duration: R) -> Extremes<R> {
        let (mut reached, end) = (Extremes::of(self.state_at(R::ZERO)), self.state_at(duration));
        reached.include_position(end.position);
        reached.include_velocity(end.velocity);
        reached.include_acceleration(end.acceleration);
        // A derivative turns where the next derivative is 0, so the zeros of each lie between the zeros of the next.
        let mut zeros = Zeros::default();
        for order in (1..N).rev() {
            zeros = self.zeros(order, duration, zeros);
            for &x in zeros.iter() {
                match order {
                    1 => reached.include_position(self.position(x)),
                    2 => reached.include_velocity(self.velocity(x)),
                    3 => reached.include_acceleration(self.acceleration(x)),
                    _ => {}
                }
            }
        }
        reached
    }

    /// Where the derivative of this order passes through 0 between 0 and `duration`; `turns` are the zeros of the next derivative.
    fn zeros(&self, order: usize, duration: R, turns: Zeros<R>) -> Zeros<R> {
        let mut zeros = Zeros::default();
        let mut from = R::ZERO;
        for &to in turns.iter().chain([&duration]) {
            let (start, end) = (self.derivative_at(order, from), self.derivative_at(order, to));
            if start < R::ZERO && end > R::ZERO || start > R::ZERO && end < R::ZERO {
                zeros.push(self.zero_between(order, from, to));
            } else if end == R::ZERO {
                zeros.push(to);
            }
            from = to;
        }
        zeros
    }

    /// Where the derivative of this order, which changes its sign between these times, passes through 0. Each round halves the interval.
    fn zero_between(&self, order: usize, mut from: R, mut to: R) -> R {
        let rises = self.derivative_at(order, to) > R::ZERO;
        for _ in 0..MOST_HALVINGS {
            let middle = from + R::HALF * (to - from);
            if (self.derivative_at(order, middle) > R::ZERO) == rises {
                to = middle;
            } else {
                from = middle;
            }
        }
        to
    }

    /// The derivative with respect to time, which has one coefficient fewer: `d.c[k] = c[k+1]*(k+1)`.
    ///
    /// ```
    /// use atraj::{Poly, Poly3};
    /// let position = Poly3 { c: [1.0, 2.0, 3.0, 4.0] };
    /// let velocity: Poly<f64, 3> = position.derivative();
    /// assert_eq!(velocity.c, [2.0, 6.0, 12.0]);
    /// ```
    pub fn derivative<const M: usize>(&self) -> Poly<R, M> {
        const { assert!(M + 1 == N, "a derivative has one coefficient fewer") };
        let mut derivative = Poly::default();
        target::differentiate(&self.c, &mut derivative.c);
        derivative
    }

    /// The derivative of this order at time `x`, s, by Horner's rule: from the highest power down, multiplication and addition rounded apart.
    pub(crate) fn derivative_at(&self, order: usize, x: R) -> R {
        let differentiate = |(power, &c): (usize, &R)| (0..order).fold(c, |c, k| c * R::from((power - k) as u8));
        let mut terms = self.c.iter().enumerate().skip(order).rev().map(differentiate);
        let highest = terms.next().unwrap_or_default();
        terms.fold(highest, |y, c| y * x + c)
    }

    /// The polynomial that `plan` makes to last `duration`, if every coefficient is finite.
    fn planned(duration: R, plan: impl FnOnce(&mut Self)) -> Result<Self, Error> {
        Error::Duration.unless(duration.abs() > R::ZERO)?;
        let mut poly = Self::default();
        plan(&mut poly);
        Error::NotFinite.unless(poly.c.iter().all(|c| c.is_finite()))?;
        Ok(poly)
    }
}

/// So often is an interval halved until it is shorter than a rounding of its length: one more than the digits of binary64.
const MOST_HALVINGS: u32 = 54;

/// Times in ascending order. A polynomial of the seventh degree has at most seven zeros.
#[derive(Default)]
struct Zeros<R> {
    times: [R; 7],
    count: usize,
}

impl<R: Real> Zeros<R> {
    fn push(&mut self, x: R) {
        if let Some(time) = self.times.get_mut(self.count) {
            *time = x;
            self.count += 1;
        }
    }

    fn iter(&self) -> impl Iterator<Item = &R> {
        self.times.iter().take(self.count)
    }
}

impl<R: Real, const N: usize> Default for Poly<R, N> {
    fn default() -> Self {
        Self { c: [R::ZERO; N] }
    }
}
