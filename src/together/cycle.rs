//! The ticks on which axes arrive.

use crate::findings::Error;
use crate::real::Real;

/// The period of a control loop. All axes arrive on one of its ticks.
pub(super) struct Cycle<R> {
    /// s; 0 if any time will do.
    period: R,
}

impl<R: Real> Cycle<R> {
    /// The cycle for a move that lasts at least `duration`, s.
    pub fn new(duration: R, period: R) -> Result<Self, Error> {
        let is_time = |t: R| t >= R::ZERO && t.is_finite();
        if is_time(duration) && is_time(period) {
            Ok(Self { period })
        } else {
            Err(Error::Duration)
        }
    }

    /// The first tick from `t` on, up to rounding.
    fn from(&self, t: R) -> R {
        let count = t / self.period;
        // Adding and subtracting this number rounds to a whole number. Larger numbers are whole.
        let whole = R::ONE / R::EPSILON;
        if !(self.period > R::ZERO && count < whole) {
            return t;
        }
        let nearest = (count + whole) - whole;
        let is_early = nearest < count - R::from(4) * R::EPSILON * count;
        self.period * if is_early { nearest + R::ONE } else { nearest }
    }

    /// The first tick from `t` on at which all axes can arrive, unless it is beyond the range of the real type. `next_duration` gives the shortest possible duration of the slowest axis.
    pub fn until_possible(
        &self,
        axes: usize,
        t: R,
        next_duration: impl Fn(R) -> R,
    ) -> Result<R, Error> {
        let mut t = self.from(t);
        // Every round passes a gap of an axis. An axis has at most one to each side.
        for _ in 0..2 * axes + 2 {
            let next = self.from(next_duration(t));
            if next <= t {
                break;
            }
            t = next;
        }
        if t.is_finite() {
            Ok(t)
        } else {
            Err(Error::NotFinite)
        }
    }
}
