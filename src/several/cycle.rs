//! The ticks on which axes arrive.

use crate::findings::Error;
use crate::interval::rounding::of_formula;
use crate::real::Real;

/// The period of a control loop. All axes arrive on one of its ticks.
pub(crate) struct Cycle<R> {
    /// s; 0 if any time will do.
    period: R,
    /// The axes arrive no earlier, s.
    earliest: R,
}

impl<R: Real> Cycle<R> {
    /// The cycle for a move that lasts at least `duration`, s.
    pub fn new(duration: R, period: R) -> Result<Self, Error> {
        let is_time = |t: R| t >= R::ZERO && t < R::INFINITY;
        Error::Duration.unless(is_time(duration) && is_time(period))?;
        Ok(Self { period, earliest: duration })
    }

    /// The first tick from `slowest` on at which all axes can arrive, unless it is beyond the range of the real type. `next_duration` gives
    /// the shortest possible duration of the slowest axis from a duration on.
    pub fn until_possible(&self, axes: usize, slowest: R, next_duration: impl Fn(R) -> R) -> Result<R, Error> {
        let mut t = self.from(slowest);
        // Every round passes a gap of an axis. An axis has at most one to each side.
        for _ in 0..2 * axes + 2 {
            let next = self.from(next_duration(t));
            if next <= t {
                break;
            }
            t = next;
        }
        if t.is_finite() { Ok(t) } else { Err(Error::NotFinite) }
    }

    /// The shortest duration that all axes can take up to rounding: the possible duration `t`, one of their own `durations`, or its nearest tick.
    /// Near its end each axis has a duration with rounding errors of its own, and the next possible one may be far away. A loop that always
    /// waited for the slowest axis would add up these errors, until another axis cannot wait any more.
    pub fn earlier(&self, t: R, slowest: R, durations: impl Iterator<Item = R>, all_take: impl Fn(R) -> bool) -> R {
        let mut shortest = t;
        let few = R::EPSILON.sqrt();
        // More than a sixteenth is no rounding error. If no time is to be gained, neither is more than what adds up.
        let part = if t > slowest + few * slowest { R::SIXTEENTH } else { few };
        let least = slowest - part * slowest;
        let near = durations.chain([slowest]).filter(|duration| *duration >= least);
        for tick in near.map(|duration| self.nearest(duration)) {
            if tick < shortest && tick >= least && tick >= self.from(self.earliest) && all_take(tick) {
                shortest = tick;
            }
        }
        shortest
    }

    /// The first tick from `t` on, up to rounding.
    #[inline(never)] // for its size
    pub fn from(&self, t: R) -> R {
        self.count(t).map_or(t, |count| {
            let nearest = whole(count);
            // A small part of a period may underflow to 0.
            let is_early = nearest < count - of_formula(count) || count == R::ZERO && t > R::ZERO;
            self.period * if is_early { nearest + R::ONE } else { nearest }
        })
    }

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

#[cfg(test)]
mod tests {
    use super::Cycle;

    const ANY_TIME: Cycle<f64> = Cycle { period: 0.0, earliest: 0.0 };

    /// An axis is earlier by a sixteenth of its duration at most, or by the root of an ulp where no more time is lost.
    #[test]
    fn axes_arrive_earlier_by_a_rounding_error() {
        let is_earlier = |t: f64, to: f64| ANY_TIME.earlier(t, 1.0, [to].into_iter(), |_| true) == to;
        assert_eq!([15.01, 14.99].map(|part| is_earlier(2.0, part / 16.0)), [true, false]);
        let roots = |errors: f64| errors * f64::exp2(-26.0);
        assert_eq!([0.75, 1.5].map(|errors| is_earlier(1.0, 1.0 - roots(errors))), [true, false]);
        assert_eq!([0.75, 1.5].map(|errors| is_earlier(1.0 + roots(errors), 0.99)), [false, true]);
    }

    /// A tick is early by the rounding error of a formula, which is four ulps. A small part of a period may underflow to 0, and a period may be too
    /// short to be counted.
    #[test]
    fn axes_arrive_on_the_next_tick() {
        let after_1024 = |ulps: f64| 1024.0 * (1.0 + ulps * f64::EPSILON);
        for (period, slowest, tick) in [
            (1.0, after_1024(3.0), 1024.0),
            (1.0, after_1024(6.0), 1025.0),
            (1e241, 0.0, 0.0),
            (1e241, 1e-102, 1e241),
            (1e-310, 1e10, 1e10),
        ] {
            let cycle = Cycle::new(0.0, period).expect("a cycle");
            assert_eq!(cycle.until_possible(1, slowest, |t| t), Ok(tick), "{period} {slowest}");
        }
    }

    #[test]
    fn five_axes_have_ten_gaps() {
        assert_eq!(ANY_TIME.until_possible(5, 0.0, |t: f64| (t + 1.0).min(10.0)), Ok(10.0));
    }
}
