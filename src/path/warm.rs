//! The plan before the first step, from a plan that is there.
//!
//! A slower plan is off all limits at once: with durations longer by the factor `s`, velocities are divided by `s` and accelerations by `s²`. A
//! plan that begins in motion slows down by and by: velocities are `v/s`, accelerations `(a - v ṡ/s)/s²`.

use super::chain::{Chain, most_late, total};
use super::steps::NewtonBudget;
use crate::findings::Error;
use crate::interval::rounding::of_check;
use crate::limits::Limits;
use crate::real::Real;

/// A plan before the first step that is slower than the one that is there. In the table the slowest one comes first.
struct Slower {
    /// By how much, in thousandths.
    thousandths: u8,
    /// By how many powers of two its logarithms weigh less.
    octaves: u8,
    /// How many steps it takes at least to win back what is lost.
    least_steps: u32,
}

const SLOWER: [Slower; 6] = [
    Slower { thousandths: 200, octaves: 2, least_steps: 10 },
    Slower { thousandths: 100, octaves: 3, least_steps: 10 },
    Slower { thousandths: 50, octaves: 4, least_steps: 6 },
    Slower { thousandths: 20, octaves: 5, least_steps: 6 },
    Slower { thousandths: 5, octaves: 5, least_steps: 3 },
    Slower { thousandths: 0, octaves: 5, least_steps: 1 },
];

/// What is left of the speed of a plan at one of its times.
struct Slow<R> {
    /// `s`
    factor: R,
    /// `ṡ`, 1/s
    rate: R,
    /// How much later the slower plan is there, s: the integral of `s - 1`.
    later: R,
}

impl<R: Real> Slow<R> {
    /// At the time `t` of a plan that eases from its own speed for the time `ease`, s: `s = 1 + (S - 1) x² (3 - 2x)` with `x = t/ease`. Then it stays slower
    /// by `factor`, `S`.
    fn at(t: R, factor: R, ease: R) -> Self {
        let more = factor - R::ONE;
        if t >= ease {
            return Self { factor, rate: R::ZERO, later: more * (t - R::HALF * ease) };
        }
        let x = t / ease;
        let rest = R::ONE - x;
        Self {
            factor: R::ONE + more * x * x * (R::ONE + (rest + rest)),
            rate: R::from(6) * more * x * rest / ease,
            later: more * ease * x * x * x * (R::ONE - R::HALF * x),
        }
    }
}

impl<R: Real> Chain<'_, '_, R> {
    /// Shortens a plan; if it is impossible, plans again from stops. `false` if its first section is to be held, which is too short to slow down in.
    pub fn improve(&mut self, given: &[R], budget: NewtonBudget, may_be_held: bool) -> Result<bool, Error> {
        let before = self.take_given(given, R::ZERO)?;
        let late = most_late(self.duration());
        match (self.shorten_any(given, budget, before)?, before) {
            (true, _) => {}
            (false, Some(_)) if may_be_held && self.sections > 1 => return Ok(false),
            _ => self.plan(budget)?,
        }
        self.keep_plan();
        let planned = self.duration();
        // A section that is a little late is planned again. But the given plan stays as long as its motions can be planned, if it is not longer.
        let before = self.take_given(given, late)?;
        if before.is_none_or(|before| planned < before) {
            self.swap_plans();
        }
        Ok(true)
    }

    /// Shortens the plan that is there, or one that brakes along the points, if that takes half of the time: the steps do not open many new
    /// sections, which begin with stops. Whether a plan is strictly feasible.
    fn shorten_any(&mut self, given: &[R], budget: NewtonBudget, before: Option<R>) -> Result<bool, Error> {
        if let (Some(before), true) = (before, self.has_new(given) && !self.rests_at(0)) {
            self.stop_everywhere()?;
            if self.brake_along() && self.duration() < R::HALF * before {
                self.shorten(budget, 0);
                self.promise()?;
                return Ok(true);
            }
            self.take_given(given, R::ZERO)?;
        }
        self.shorten_given(given, budget)
    }

    /// Takes over the plan that is there. Gives its duration if it is possible and no section is later than this, s.
    fn take_given(&mut self, given: &[R], late: R) -> Result<Option<R>, Error> {
        let full = Slow { factor: R::ONE, rate: R::ZERO, later: R::ZERO };
        (1..self.sections).try_for_each(|point| self.take_state(point, &full))?;
        let mut is_possible = true;
        for section in 0..self.sections {
            let duration = self.given(section, given)?;
            let least = self.shortest(section, duration)?;
            let is_kept = duration == R::ZERO || least <= duration + late.at_least(of_check(duration));
            is_possible = is_possible && (is_kept || section == 0 && self.is_left(given));
            let taken = if duration == R::ZERO { least } else { duration };
            self.memory.plan.durations.put(section, taken);
        }
        let holds = |point| (0..self.axes).all(|axis| self.bounds(point, axis).hold(self.at(point, axis)));
        is_possible = is_possible && (1..self.sections).all(holds);
        Ok(is_possible.then(|| self.duration()))
    }

    /// Whether the first section is what is left of a section of a possible plan. The state under way has rounding errors: those of the
    /// positions, and those of the clock. A little more jerk makes up for them.
    fn is_left(&self, given: &[R]) -> bool {
        let Ok(duration) = self.given(0, given) else { return false };
        let all = total(given);
        let clock = of_check(all);
        (0..self.axes).all(|axis| {
            let points = 0..self.request.sections + 1;
            let farthest = points.map(|point| self.request.state(point, axis).position.abs());
            let position = of_check(farthest.fold(R::ZERO, R::at_least));
            let limits = with_errors(&self.limits(0, axis), duration, all, [position, clock]);
            self.upper(&limits, (0, axis), duration).has_slack()
        })
    }
}

impl<R: Real, const K: usize> Chain<'_, '_, R, K> {
    /// Shortens a plan that is there, if a slower one is strictly feasible. Whether one is.
    pub fn shorten_given(&mut self, given: &[R], budget: NewtonBudget) -> Result<bool, Error> {
        let Some(octaves) = self.slow_down(given, budget.most) else { return Ok(false) };
        self.shorten(budget, octaves);
        self.promise()?;
        Ok(true)
    }

    /// The duration of a section in the plan that is there, s.
    #[inline(never)] // for its size: it is asked in several places
    fn given(&self, section: usize, given: &[R]) -> Result<R, Error> {
        let duration = given.get(self.place(section)).copied().unwrap_or(R::NAN);
        let is_duration = duration >= R::ZERO && duration.is_finite();
        is_duration.then_some(duration).ok_or(Error::Duration)
    }

    /// Whether a section of the plan that is there is new.
    fn has_new(&self, given: &[R]) -> bool {
        (0..self.sections).any(|section| self.given(section, given) == Ok(R::ZERO))
    }

    fn take_state(&mut self, point: usize, slow: &Slow<R>) -> Result<(), Error> {
        for axis in 0..self.axes {
            let state = self.request.state(self.place(point), axis);
            let velocity = state.velocity / slow.factor;
            let acceleration = (state.acceleration - velocity * slow.rate) / (slow.factor * slow.factor);
            Error::NotFinite.unless(velocity.is_finite() && acceleration.is_finite())?;
            self.memory.plan.states.set(point * self.axes + axis, [velocity, acceleration]);
        }
        Ok(())
    }

    /// Takes over the slowest of some plans like the one that is there, if one is strictly feasible. Gives the powers of two for the first step. A
    /// path of one section needs no step. A plan that begins in motion eases over a quarter of its duration.
    pub fn slow_down(&mut self, given: &[R], steps: u32) -> Option<u8> {
        (self.sections > 1).then_some(())?;
        // New sections begin with stops, far from the best plan.
        let is_new = self.has_new(given);
        // From the plan itself no step opens new sections. But for fewer than 3 steps there is no other.
        let may_be_as_it_is = !is_new || steps < 3;
        let ease = if self.rests_at(0) { R::ZERO } else { R::HALF * R::HALF * total(given) };
        let tried = |slower: &Slower| slower.least_steps <= steps && (slower.thousandths > 0 || may_be_as_it_is);
        let thousand = R::from(250) * R::from(4);
        SLOWER.into_iter().filter(tried).find_map(|slower| {
            let taken = self.take_slower(R::ONE + R::from(slower.thousandths) / thousand, ease, given);
            taken.map(|()| if is_new { 0 } else { slower.octaves })
        })
    }

    /// Takes over the plan that is there, slowed down by `factor`.
    fn take_slower(&mut self, factor: R, ease: R, given: &[R]) -> Option<()> {
        let (mut time, mut later) = (R::ZERO, R::ZERO);
        for section in 0..self.sections {
            let duration = self.given(section, given).ok()?;
            time = time + duration;
            let slow = Slow::at(time, factor, ease);
            if section + 1 < self.sections {
                self.take_state(section + 1, &slow).ok()?;
            }
            self.memory.plan.durations.put(section, duration + (slow.later - later));
            later = slow.later;
        }
        for section in 0..self.sections {
            if self.given(section, given) == Ok(R::ZERO) {
                let least = self.shortest(section, R::ZERO).ok()?;
                self.memory.plan.durations.put(section, least + R::SIXTEENTH * least);
            }
        }
        self.is_strictly_feasible().then_some(())
    }
}

/// Limits so wide that a motion of the duration `t` makes up for the rounding errors of its start: that of its position, and what the one of the
/// clock changes. In a path that takes `all` an axis is no faster than its limits, or the limits of their derivatives, let it be.
fn with_errors<R: Real>(limits: &Limits<R>, t: R, all: R, [position, clock]: [R; 2]) -> Limits<R> {
    let Limits { vmax, vmin, amax, amin, jmax, jmin } = *limits;
    let (j, slower) = (jmax.at_least(-jmin), jmax.at_most(-jmin));
    let a = amax.at_least(-amin).at_most(if j < R::INFINITY { j } else { slower } * all);
    let v = vmax.at_least(-vmin).at_most(a * all);
    // The quintic that ends such an error has at most 60, 36 and 9 times these jerks. A jerk that is soon over counts as its mean.
    let jerk = ((position + v * clock) / t + a * clock) / (t * t) + j.at_most(a / t) * clock / t;
    let (more_j, more_a, more_v) = (R::from(64) * jerk, R::from(8) * jerk * t, R::from(2) * jerk * t * t);
    Limits {
        vmax: vmax + more_v,
        vmin: vmin - more_v,
        amax: amax + more_a,
        amin: amin - more_a,
        jmax: jmax + more_j,
        jmin: jmin - more_j,
    }
}

#[cfg(test)]
mod tests {
    use super::with_errors;
    use crate::limits::Limits;

    /// The quintics that end an error of position, velocity or acceleration have these highest velocities, accelerations and jerks.
    #[test]
    fn wider_limits_admit_what_ends_an_error() {
        let peaks = [[1.875, 1.0, 0.07], [5.78, 3.95, 1.0], [60.0, 36.0, 9.0]];
        let (t, all, tiny) = (0.0625, 0.125, 1.0 / 1_048_576.0);
        let limits = Limits { vmax: 64.0, vmin: -32.0, amax: 64.0, amin: -32.0, jmax: 4.0, jmin: -8.0 };
        let wide = with_errors(&limits, t, all, [tiny, tiny]);
        // By its jerk of 8 the axis gets to an acceleration of 1 in the whole path, and to a velocity of 0.125.
        let errors = [(1.0 + 0.125) * tiny / t, 1.0 * tiny, 8.0 * tiny * t];
        let above = [wide.vmax - limits.vmax, wide.amax - limits.amax, wide.jmax - limits.jmax];
        let below = [limits.vmin - wide.vmin, limits.amin - wide.amin, limits.jmin - wide.jmin];
        for (k, time) in [1.0, t, t * t].into_iter().enumerate() {
            let least: f64 = peaks[k].iter().zip(errors).map(|(peak, error)| peak * error / time).sum();
            assert!([above[k], below[k]].iter().all(|more| (least..2.0 * least).contains(more)));
        }
    }
}
