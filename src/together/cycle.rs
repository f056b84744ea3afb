//! The ticks on which axes arrive.

use crate::findings::Error;
use crate::real::Real;

/// The period of a control loop. All axes arrive on one of its ticks.
pub(super) struct Cycle<R> {
    /// s; 0 if any time will do.
    period: R,
    /// The axes arrive no earlier, s.
    earliest: R,
}

impl<R: Real> Cycle<R> {
    /// The cycle for a move that lasts at least `duration`, s.
    pub fn new(duration: R, period: R) -> Result<Self, Error> {
        let is_time = |t: R| t >= R::ZERO && t.is_finite();
        if is_time(duration) && is_time(period) {
            Ok(Self {
                period,
                earliest: duration,
            })
        } else {
            Err(Error::Duration)
        }
    }

    /// The first tick from `slowest` on at which all axes can arrive, unless it is beyond the range of the real type. `next_duration` gives
    /// the shortest possible duration of the slowest axis from a duration on.
    ///
    /// An axis that misses a tick by roundings arrives at it, if `may_slip` allows it. More is allowed if the axis else has a detour before it.
    pub fn until_possible(
        &self,
        axes: usize,
        slowest: R,
        next_duration: impl Fn(R) -> R,
        may_slip: impl FnOnce(R, bool) -> bool,
    ) -> Result<R, Error> {
        let mut t = self.from(slowest);
        // Every round passes a gap of an axis. An axis has at most one to each side.
        for _ in 0..2 * axes + 2 {
            let next = self.from(next_duration(t));
            if next <= t {
                break;
            }
            t = next;
        }
        let missed = self.nearest(slowest);
        let is_detour = t > missed + self.period + R::HALF * self.period;
        let is_early = missed < self.earliest - R::from(4) * R::EPSILON * missed;
        if t > missed && !is_early && may_slip(missed, is_detour) {
            t = missed;
        }
        if t.is_finite() {
            Ok(t)
        } else {
            Err(Error::NotFinite)
        }
    }

    /// The first tick from `t` on, up to rounding.
    fn from(&self, t: R) -> R {
        self.count(t).map_or(t, |count| {
            let nearest = whole(count);
            let is_early = nearest < count - R::from(4) * R::EPSILON * count;
            self.period * if is_early { nearest + R::ONE } else { nearest }
        })
    }

    /// The tick next to `t`.
    fn nearest(&self, t: R) -> R {
        self.count(t).map_or(t, |count| self.period * whole(count))
    }

    /// `t` in periods. `None` if any time will do.
    fn count(&self, t: R) -> Option<R> {
        let count = t / self.period;
        (self.period > R::ZERO && count < R::ONE / R::EPSILON).then_some(count)
    }
}

/// The whole number next to a number below `1/ε`. Adding and subtracting `1/ε` rounds.
fn whole<R: Real>(x: R) -> R {
    let whole = R::ONE / R::EPSILON;
    (x + whole) - whole
}
