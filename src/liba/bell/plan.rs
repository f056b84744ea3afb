//! liba's plan of the double-S, in the order of the numerical contract.

use super::{Bell, search::Fit};
use crate::real::{Real, target};
use crate::state::{Boundary, Saturation};

impl<R: Real> Bell<R> {
    /// [`Bell::new`] in place and literally the C function: the duration, also if it is NaN, or `None` where the C
    /// function gives up. What a failed plan does not reach keeps its old value.
    #[must_use = "`None` says that there is no plan"]
    pub fn plan(&mut self, jerk: R, acceleration: R, velocity: R, boundary: Boundary<R>) -> Option<R> {
        self.plan_saturated(jerk, acceleration, velocity, boundary, Saturation::Everything)
    }

    /// [`Bell::plan`] with the saturation of either generation of liba.
    #[must_use = "`None` says that there is no plan"]
    pub fn plan_saturated(
        &mut self, jerk: R, acceleration: R, velocity: R, boundary: Boundary<R>, saturation: Saturation,
    ) -> Option<R> {
        let (jm, am, vm) = (jerk.magnitude(), acceleration.magnitude(), velocity.magnitude());
        let Boundary { p0, p1, v0, v1 } = boundary.limit_velocities(vm, saturation);
        (self.p0, self.p1, self.v0, self.v1) = (p0, p1, v0, v1);
        (self.vm, self.jm) = (vm, jm);
        let [h, v0, v1] = target::forward(p1 - p0, v0, v1);

        let full_tj = am / jm;
        (self.taj, self.ta, self.am) = ramp(vm - v0, jm, am, full_tj);
        (self.tdj, self.td, self.dm) = ramp(vm - v1, jm, am, full_tj);
        self.dm = -self.dm;

        self.tv = h / vm - R::HALF * self.ta * (R::ONE + v0 / vm) - R::HALF * self.td * (R::ONE + v1 / vm);
        let planned = self.tv > R::ZERO || self.plan_without_cruise(am, h, v0, v1);
        self.t = if planned { self.ta + self.tv + self.td } else { R::ZERO };
        planned.then_some(self.t)
    }

    /// No room to cruise: two ramps meet, or one ramp covers the whole displacement `h`. `false` if no such move exists.
    fn plan_without_cruise(&mut self, am: R, h: R, v0: R, v1: R) -> bool {
        self.tv = R::ZERO;
        self.am = am;
        self.dm = am * R::SIXTEENTH;
        // The one divergence: here the C function halves an infinite step for ever.
        if am == R::INFINITY {
            return false;
        }
        match self.search(am, h, v0, v1) {
            Fit::Both => true,
            Fit::TooSteep => false,
            single => self.plan_single_ramp(matches!(single, Fit::DownOnly), h, v0, v1),
        }
    }

    /// One ramp covers the whole displacement `h`: deceleration if `down`, else acceleration.
    fn plan_single_ramp(&mut self, down: bool, h: R, v0: R, v1: R) -> bool {
        let s = v0 + v1;
        let dv = if down { v1 - v0 } else { v0 - v1 };
        let duration = R::from(2) * h / s;
        if down {
            (self.ta, self.taj, self.td) = (R::ZERO, R::ZERO, duration);
        } else {
            (self.td, self.tdj, self.ta) = (R::ZERO, R::ZERO, duration);
        }
        let m = self.jm * h;
        let w = self.jm * (m * h + dv * s * s);
        // Not `w >= 0`: a NaN goes on, as in the C function.
        if w < R::ZERO {
            return false;
        }
        let tj = (m - w.sqrt()) / (self.jm * s);
        let reached = self.jm * tj;
        if down {
            (self.tdj, self.am, self.dm, self.vm) = (tj, R::ZERO, -reached, v0);
        } else {
            (self.taj, self.am, self.dm) = (tj, reached, R::ZERO);
            self.vm = v0 + reached * (duration - tj);
        }
        true
    }
}

/// The ramp of a velocity change `dv`: duration of each constant-jerk part, duration of the whole, acceleration reached.
/// `full_tj = am/jm` is the first where the ramp reaches `am`.
fn ramp<R: Real>(dv: R, jm: R, am: R, full_tj: R) -> (R, R, R) {
    if dv * jm < am * am {
        let tj = (dv / jm).sqrt();
        (tj, R::from(2) * tj, jm * tj)
    } else {
        (full_tj, full_tj + dv / am, am)
    }
}
