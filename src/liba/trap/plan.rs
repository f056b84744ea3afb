//! liba's plan of the trapezoid, in the order of the numerical contract.

use super::Trap;
use crate::real::Real;
use crate::state::{Boundary, Saturation};

enum Shape {
    /// Up to the highest velocity, and down.
    Cruise,
    /// Up and down.
    Peak,
    /// Too short to reach the demanded final velocity: the reached one takes its place.
    UpOnly,
    /// Too short to come down to the demanded final velocity: the reached one takes its place.
    DownOnly,
}

impl<R: Real> Trap<R> {
    /// [`Trap::new`] in place and literally the C function: the duration, also if it is NaN, or `None` where the C
    /// function gives up. What a failed plan does not reach keeps its old value.
    #[must_use = "`None` says that there is no plan"]
    pub fn plan(&mut self, velocity: R, acceleration: R, deceleration: R, boundary: Boundary<R>) -> Option<R> {
        self.plan_saturated(velocity, acceleration, deceleration, boundary, Saturation::Everything)
    }

    /// [`Trap::plan`] with the saturation of either generation of liba.
    #[must_use = "`None` says that there is no plan"]
    pub fn plan_saturated(
        &mut self, velocity: R, acceleration: R, deceleration: R, boundary: Boundary<R>, saturation: Saturation,
    ) -> Option<R> {
        let (a0, a1) = (acceleration, deceleration);
        if a0 == a1 {
            return None;
        }
        let vm = velocity.magnitude();
        let Boundary { p0, p1, v0, v1 } = boundary.limit_velocities(vm, saturation);
        (self.p0, self.p1, self.v0, self.v1) = (p0, p1, v0, v1);
        let h = p1 - p0;
        let two_h = R::from(2) * h;

        // Squared velocity at which the acceleration line meets the deceleration line.
        let (a, b) = (v0 * v0, v1 * v1);
        let c = (b * a0 - a * a1 - two_h * a0 * a1) / (a0 - a1);
        if c <= R::ZERO {
            return None;
        }
        let shape = if c > vm * vm {
            Shape::Cruise
        } else if c > a && c <= b {
            Shape::UpOnly
        } else if c <= a && c > b {
            Shape::DownOnly
        } else {
            Shape::Peak
        };
        let speed = match shape {
            Shape::Cruise => vm,
            Shape::UpOnly => root(a + two_h * a0)?,
            Shape::DownOnly => root(a + two_h * a1)?,
            Shape::Peak => c.sqrt(),
        };
        let v = speed.negate_if(h < R::ZERO);
        (self.a0, self.a1) = (a0, a1);
        if matches!(shape, Shape::DownOnly) {
            self.v1 = v;
            self.vc = v0;
            self.t = (v - v0) / a1;
            (self.ta, self.cruise_end) = (R::ZERO, R::ZERO);
            (self.pa, self.pd) = (p0, p0);
            return Some(self.t);
        }
        self.vc = v;
        self.ta = (v - v0) / a0;
        self.pa = p0 + v0 * self.ta + R::HALF * a0 * self.ta * self.ta;
        if matches!(shape, Shape::UpOnly) {
            self.v1 = v;
            (self.t, self.cruise_end) = (self.ta, self.ta);
            self.pd = p1;
            return Some(self.t);
        }
        // Duration of the deceleration.
        let t = (v1 - v) / a1;
        if matches!(shape, Shape::Cruise) {
            self.pd = p1 - v * t - R::HALF * a1 * t * t;
            self.cruise_end = self.ta + (self.pd - self.pa) / v;
        } else {
            self.pd = self.pa;
            self.cruise_end = self.ta;
        }
        self.t = self.cruise_end + t;
        Some(self.t)
    }
}

/// The root of a squared velocity; `None` below 0.
fn root<R: Real>(squared: R) -> Option<R> {
    // Not `squared >= 0`: a NaN goes on, as in the C function.
    if squared < R::ZERO { None } else { Some(squared.sqrt()) }
}
