//! The motion of a given duration that cruises: a ramp to one velocity, the cruise, and a ramp to the end.
//! `docs/planner.md` has the theory, in "Several axes".

use crate::interval::border::Border;
use crate::interval::profile::{MOST_SEGMENTS, Segment};
use crate::interval::ramp::{Passed, PerJerk, Ramp, seen};
use crate::interval::rounding::of_formula;
use crate::online::Move;
use crate::online::problem::Problem;
use crate::real::Real;

/// A motion at the velocity `v` between two ramps.
pub(super) struct Cruise<R> {
    v: R,
    /// How long the axis cruises, s.
    c: R,
    /// From the start to the cruise.
    start: Side<R>,
    /// From the end to the cruise, in the other order of time.
    end: Side<R>,
}

/// A ramp between one end of the motion and the cruise.
struct Side<R> {
    ramp: Ramp<R>,
    /// The jerks in the ramp's own axis.
    per_jerk: PerJerk<R>,
    /// s
    duration: R,
    displacement: R,
}

/// The range that holds the velocity of a cruise.
struct Bracket<R> {
    low: R,
    high: R,
    is_end_asked: bool,
}

/// More rounds than the velocity of a cruise takes.
const MOST_ROUNDS: u32 = 24;

impl<R: Real> Cruise<R> {
    /// The motion of a problem in the duration `duration`. `None` if the ramps take longer at the velocity that travels the displacement.
    pub fn of(problem: &Problem<R>, duration: R) -> Option<Self> {
        let (h, t) = (problem.displacement().h, problem.after_recovery(duration));
        Self::over(&problem.border, h, t)
    }

    /// The ramps leave time for a cruise at velocities around the one that the start leads to, around the one that leads to the end, and perhaps between.
    fn over(border: &Border<R>, h: R, t: R) -> Option<Self> {
        let reversed = border.reversed();
        let steady = |border: &Border<R>| border.v0 + border.per_jerk.straight(border.a0, R::ZERO);
        let guesses = [h / t, steady(border), steady(&reversed)];
        guesses.into_iter().find_map(|guess| Self::near(border, &reversed, guess, h, t))
    }

    /// The motion at a velocity that is as far from the guess as the axis cruises. There the slope of the displacement is positive.
    fn near(border: &Border<R>, reversed: &Border<R>, guess: R, h: R, t: R) -> Option<Self> {
        let ends = border.v0.abs() + border.v1.abs();
        // A ramp's mean velocity is at least a third of the cruise's, plus what its own end adds: a half, if both jerks are equal. So the cruise is no faster.
        let fastest = R::from(3) * ((h / t).abs() + ends + border.eased);
        let [low, high] = [border.limits.vmin.at_least(-fastest), border.limits.vmax.at_most(fastest)];
        let mut v = guess.at_least(low).at_most(high);
        let mut bracket = Bracket { low, high, is_end_asked: false };
        for round in 0..MOST_ROUNDS {
            let cruise = Self::at(border, reversed, v, t);
            let beyond = cruise.displacement() - h;
            let cruises = cruise.c >= R::ZERO;
            if cruises && beyond.abs() <= of_formula(h.abs() + (ends + v.abs()) * t) {
                return Some(cruise);
            }
            if !cruises && round == 0 {
                break;
            }
            let is_high = if cruises { beyond > R::ZERO } else { v > guess };
            let newton = cruises.then(|| v - cruise.step(beyond));
            v = bracket.next(v, is_high, newton);
        }
        None
    }

    fn at(border: &Border<R>, reversed: &Border<R>, v: R, t: R) -> Self {
        let (start, end) = (Side::to(border, v), Side::to(reversed, v));
        let c = t - start.duration - end.duration;
        Self { v, c, start, end }
    }

    fn displacement(&self) -> R {
        self.start.displacement + self.v * self.c + self.end.displacement
    }

    /// How much the velocity is to fall for the displacement to fall by `beyond`, where the displacement is taken for a quadratic.
    fn step(&self, beyond: R) -> R {
        let slope = self.c + R::HALF * (self.start.next_to_cruise() + self.end.next_to_cruise());
        let newton = beyond / slope;
        let bend = newton * (self.start.curvature() + self.end.curvature()) / slope;
        if bend.abs() < R::HALF { (newton + newton) / (R::ONE + (R::ONE - (bend + bend)).sqrt()) } else { newton }
    }

    /// Writes the recovery and the motion.
    pub fn write(&self, problem: &Problem<R>, axis: &mut Move<R>, duration: R) {
        let mut writer = problem.writer(axis);
        for segment in &self.segments(&problem.border) {
            writer.write(segment);
        }
        writer.end(problem.to);
        axis.end_at(duration);
    }

    /// The segments in order of time. In the other order of time an acceleration has the other sign, and a jerk has the same.
    fn segments(&self, border: &Border<R>) -> [Segment<R>; MOST_SEGMENTS] {
        let (jmax, jmin) = (border.limits.jmax, border.limits.jmin);
        let jerks = |side: &Side<R>| {
            if side.ramp.mirrored { (jmin, jmax) } else { (jmax, jmin) }
        };
        let (start, end) = (&self.start, &self.end);
        let ((away, back), (off, onto)) = (jerks(start), jerks(end));
        let peak = start.ramp.peak.negate_if(start.ramp.mirrored);
        let trough = -end.ramp.peak.negate_if(end.ramp.mirrored);
        [
            Segment::new(border.a0, away, start.per_jerk.gu * start.ramp.rise),
            Segment::new(peak, R::ZERO, start.ramp.hold),
            Segment::new(peak, back, start.next_to_cruise()),
            Segment::new(R::ZERO, R::ZERO, self.c),
            Segment::new(R::ZERO, onto, end.next_to_cruise()),
            Segment::new(trough, R::ZERO, end.ramp.hold),
            Segment::new(trough, off, end.per_jerk.gu * end.ramp.rise),
        ]
    }
}

impl<R: Real> Bracket<R> {
    /// The velocity to ask after `v`, which is too high or else too low: where a step of Newton's method leads, if there is one and it stays in the range. The
    /// first step that leaves the range becomes a step to its end, and each later one a halving of the range.
    fn next(&mut self, v: R, is_high: bool, newton: Option<R>) -> R {
        let end = if is_high { self.low } else { self.high };
        let is_end = v == end;
        // If `v` is the end itself, the velocity is between it and the velocities before.
        if !is_end {
            if is_high { self.high = v } else { self.low = v }
        }
        let Self { low, high, .. } = *self;
        match newton {
            Some(newton) if !is_end && newton > low && newton < high => newton,
            Some(_) if !self.is_end_asked => {
                self.is_end_asked = true;
                end
            }
            _ => low + R::HALF * (high - low),
        }
    }
}

impl<R: Real> Side<R> {
    /// From the start of the border to the cruise at `v`.
    fn to(border: &Border<R>, v: R) -> Self {
        let beyond = (v - border.v0) - border.per_jerk.straight(border.a0, R::ZERO);
        let mirrored = beyond < R::ZERO;
        let limit = if mirrored { -border.limits.amin } else { border.limits.amax };
        let [beyond, a0, v0] = seen([beyond, border.a0, border.v0], mirrored);
        let per_jerk = border.per_jerk.mirrored_if(mirrored);
        let ramp = Ramp::over(beyond, a0, R::ZERO, limit, per_jerk);
        let Passed { duration, displacement } = ramp.passed(v0, a0, R::ZERO, per_jerk);
        Self { ramp: ramp.mirrored_if(mirrored), per_jerk, duration, displacement: displacement.negate_if(mirrored) }
    }

    /// How long the phase next to the cruise lasts, s.
    fn next_to_cruise(&self) -> R {
        self.per_jerk.gd * self.ramp.fall
    }

    /// What the side adds to the second derivative of the displacement with respect to the velocity of the cruise.
    fn curvature(&self) -> R {
        let shape = if self.ramp.hold > R::ZERO {
            R::ONE
        } else {
            R::ONE - R::HALF * R::HALF * self.per_jerk.gd / self.per_jerk.q()
        };
        -(shape / self.ramp.peak).negate_if(self.ramp.mirrored)
    }
}

#[cfg(test)]
mod tests {
    use super::Cruise;
    use crate::interval::border::Border;
    use crate::limits::Limits;
    use support::Random;

    /// The step is wrong by the third order of its length: it knows the slope of the displacement, and how the slope changes.
    #[test]
    fn a_step_fits_a_quadratic() {
        let limits = Limits { jmin: -2.0, jmax: 3.0, ..Limits::symmetric(1.0, 1.0, 9.0) };
        for [v0, v1] in [[0.0, 0.1], [-3.0, 0.2], [3.0, 4.0]] {
            let border = Border::between([[v0, 0.3], [v1, 0.1]], &limits);
            let at = |v: f64| Cruise::at(&border, &border.reversed(), v, 20.0);
            let beyond = at(0.4).displacement() - at(0.3999).displacement();
            assert!((1e4 * at(0.4).step(beyond) - 1.0).abs() < 1e-8, "{v0} {v1}");
        }
    }

    /// Duration and displacement tell the velocity of each cruise that lasts as long as its ramps.
    #[test]
    fn a_long_cruise_is_found() {
        let mut random = Random::seeded(0);
        for _ in 0..100_000 {
            let [vm, am, jm] = [(); 3].map(|()| random.magnitude(-2.0, 2.0));
            let limits = Limits { jmin: -1.0, ..Limits::symmetric(jm, am, vm) };
            let mut end = || [vm, am].map(|most| random.pick(&[0.0, most]) * random.between(-1.0, 1.0));
            let border = Border::between([end(), end()], &limits);
            let v = random.between(-vm, vm);
            let at = |t| Cruise::at(&border, &border.reversed(), v, t);
            let t = -at(0.0).c * (2.0 + random.magnitude(-5.0, 5.0));
            let found = Cruise::over(&border, at(t).displacement(), t);
            assert!(found.is_some_and(|found| (found.v - v).abs() < 1e-9), "{border:?} {v} {t}");
        }
    }

    /// Cruises are possible near the start and near the end, and not at the mean velocity between. So an axis that cruises goes on.
    #[test]
    fn a_cruise_goes_on() {
        let border = Border::between([[-1.0_f64, 0.0], [2.0, 0.0]], &Limits::symmetric(12.0, 8.0, 4.0));
        let ramp = Cruise::at(&border, &border.reversed(), -1.0, 0.0);
        for c in [0.01_f64, 0.1] {
            let found = Cruise::over(&border, ramp.displacement() + ramp.c - c, c - ramp.c);
            assert!(found.is_some_and(|found| (found.v + 1.0).abs() < 1e-9), "{c}");
        }
    }

    /// An axis that comes back to its start has the rounding error of its way there.
    #[test]
    fn a_cruise_back_is_found() {
        for unit in [1e-6, 1.0] {
            let border = Border::between([[100.0 * unit, 0.0]; 2], &Limits::symmetric(unit, unit, 1e3 * unit));
            assert!((450..650).all(|t| Cruise::over(&border, 0.0, f64::from(t)).is_some()));
        }
    }
}
