//! One axis among several.

use super::blend::{self, Blend};
use super::cruise::Cruise;
use crate::findings::Error;
use crate::interval::rounding::of_formula;
use crate::limits::Limits;
use crate::online::Move;
use crate::online::problem::Problem;
use crate::real::Real;
use crate::state::State;

/// What an axis is to do.
#[derive(Clone, Copy)]
pub(crate) struct Task<'a, R> {
    pub limits: &'a Limits<R>,
    pub from: &'a State<R>,
    pub to: &'a State<R>,
}

impl<R: Real> Task<'_, R> {
    pub fn problem(&self) -> Problem<R> {
        Problem::new(self.limits, self.from, self.to)
    }

    /// Whether the numbers of all motions that take at most `duration` longer than necessary are surely between `ε²` and `ε⁻²`, far within the range of
    /// the real type: the way in which the axis brakes, and the time in which it comes back, and one unit of length farther, at the least limits.
    pub fn is_ordinary(&self, duration: R) -> bool {
        let Self { limits, from, to } = *self;
        let Limits { vmax, vmin, amax, amin, jmax, jmin } = *limits;
        let per = |high: R, low: R| R::ONE / high.at_most(-low);
        let (per_v, per_a, per_j) = (per(vmax, vmin), per(amax, amin), per(jmax, jmin));
        let a = from.acceleration.abs() + to.acceleration.abs();
        let v = from.velocity.abs() + to.velocity.abs() + a * a * per_j;
        let t = R::ONE + v * (per_a + per_j) + a * per_j;
        let way = R::ONE + from.position.abs() + to.position.abs() + v * t;
        let t = t + duration + way * (per_v + per_a + per_j);
        // The other axes may have to take as long.
        (way + (t + v + a * t) * t) * R::EPSILON * R::EPSILON < R::ONE
    }
}

/// The tasks of the axes, if each of them can be planned.
pub(crate) fn checked<'a, R: Real>(
    count: usize, limits: &'a [Limits<R>], from: &'a [State<R>], to: &'a [State<R>],
) -> Result<impl ExactSizeIterator<Item = Task<'a, R>> + Clone, Error> {
    let fit = limits.len() == count && from.len() == count && to.len() == count;
    Error::Axes.unless(count > 0 && fit)?;
    let tasks = limits.iter().zip(from).zip(to).map(|((limits, from), to)| Task { limits, from, to });
    tasks.clone().try_for_each(|Task { limits, from, to }| limits.check(*from, *to))?;
    Ok(tasks)
}

/// Whether an axis can wait where it stands.
fn may_wait<R: Real>(problem: &Problem<R>) -> bool {
    problem.from.is_at_rest() || problem.to.is_at_rest()
}

/// The shortest possible duration from `t` on, which is not below that of the fastest motion, s.
pub(crate) fn next_duration<R: Real>(problem: &Problem<R>, t: R) -> R {
    let next = if may_wait(problem) { t } else { blend::next_duration(problem, t) };
    // Rounding and overflow may hide a feasible duration.
    if next > t && Cruise::of(problem, t).is_none() { next } else { t }
}

/// The shortest possible duration from `t` on of an axis that has made its fastest plan, s.
pub(super) fn next_of_plan<R: Real>(axis: &Move<R>, problem: &dyn Fn() -> Problem<R>, t: R) -> R {
    if may_last(axis, t) { t } else { next_duration(&problem(), t) }
}

/// Whether the fastest plan of an axis alone tells that the axis can take the duration `t`, which is not shorter up to rounding.
fn may_last<R: Real>(axis: &Move<R>, t: R) -> bool {
    lasts(axis, t) || axis.start().is_at_rest() || axis.end().is_at_rest()
}

/// Whether a plan takes the duration `t` up to rounding: a tick is early by the rounding of a formula, and its quotient and product add half as much.
pub(super) fn lasts<R: Real>(axis: &Move<R>, t: R) -> bool {
    let rounding = of_formula(t);
    (t - axis.t).abs() <= rounding + R::HALF * rounding
}

/// Whether an axis that has made its fastest plan can take the duration `t`, up to the rounding of its states.
pub(super) fn takes<R: Real>(axis: &Move<R>, problem: &Problem<R>, t: R) -> bool {
    let is_possible = t >= axis.t && (may_last(axis, t) || next_duration(problem, t) <= t);
    is_possible || lasts(axis, t) || problem.may_shift(axis, t) || neighbour(problem, t).is_some()
}

/// The problem, or one whose velocity at the start differs by rounding, if it takes the duration `t`.
fn neighbour<R: Real>(problem: &Problem<R>, t: R) -> Option<Problem<R>> {
    let rounding = problem.border.rounding_of_velocity();
    let fitting = problem.border.faster_for(problem.after_recovery(t));
    let straight = problem.border.faster_for_straight();
    let changes = [fitting, straight, R::ZERO, rounding, -rounding];
    let mut asked = R::INFINITY;
    let is_new = |change: &R| core::mem::replace(&mut asked, *change) != *change;
    changes.into_iter().filter(is_new).map(|change| problem.starting_faster(change)).find(|problem| problem.takes(t))
}

/// Makes the move of an axis, planned as fast as possible, last `t`, which is possible.
pub(super) fn stretch<R: Real>(axis: &mut Move<R>, problem: &dyn Fn() -> Problem<R>, t: R) -> Result<(), Error> {
    let is_slow = axis.start().is_at_rest() && axis.end().is_at_rest();
    if lasts(axis, t) {
        axis.end_at(t);
    } else if is_slow && t > axis.t && axis.t > R::EPSILON * t {
        // The jerk falls by the third power of the factor. It stays within the range of the real type.
        axis.slow_down(t);
    } else {
        let problem = problem();
        if problem.may_shift(axis, t) {
            axis.shift_in_time(t);
        } else if !fill(axis, &problem, t) {
            // A problem that differs by rounding may take the duration.
            let near = neighbour(&problem, t).unwrap_or(problem);
            if !cruises(axis, &near, t) {
                mix(axis, &near, t);
            }
        }
    }
    Error::NotFinite.unless(axis.is_finite())
}

/// As [`stretch`], where nobody has asked whether `t` is possible. Returns whether it is; if not, the axis has no plan.
pub(super) fn stretch_unasked<R: Real>(axis: &mut Move<R>, problem: &dyn Fn() -> Problem<R>, t: R) -> bool {
    if may_last(axis, t) {
        return stretch(axis, problem, t).is_ok();
    }
    let problem = problem();
    !problem.may_shift(axis, t) && fill(axis, &problem, t) && axis.is_finite()
}

/// Makes the move of an axis in motion, planned as fast as possible, last `t`, if this is possible. Returns whether it is.
fn fill<R: Real>(axis: &mut Move<R>, problem: &Problem<R>, t: R) -> bool {
    let has_time = t >= axis.t;
    if has_time && cruises(axis, problem, t) {
        return true;
    }
    let is_possible = has_time && (may_wait(problem) || blend::next_duration(problem, t) <= t);
    if is_possible {
        mix(axis, problem, t);
    }
    is_possible
}

/// Makes the axis cruise for what is left of `t`, if it can. Returns whether it can.
fn cruises<R: Real>(axis: &mut Move<R>, problem: &Problem<R>, t: R) -> bool {
    Cruise::of(problem, t).map(|cruise| cruise.write(problem, axis, t)).is_some()
}

/// Makes the move of an axis in motion last `t`, where it cannot cruise.
#[inline(never)] // for its stack
fn mix<R: Real>(axis: &mut Move<R>, problem: &Problem<R>, t: R) {
    if let Some(blend) = &Blend::of(problem, t) {
        blend.write(problem, axis, t);
    } else if problem.to.is_at_rest() && t >= axis.t {
        // Where rounding hides the wait from both, the axis waits at its target.
        axis.wait_until(t);
    } else {
        axis.shift_in_time(t);
    }
}

#[cfg(test)]
mod tests {
    use super::{Task, next_duration, stretch, takes};
    use crate::limits::Limits;
    use crate::online::Move;
    use crate::online::problem::Problem;
    use crate::state::State;

    /// A gap begins after 1 s. If the start is slower by the rounding error of the velocities, 60 ulps, it begins 120 later. A rise of 40 below
    /// 0 does not exist, which is worth 80 more.
    #[test]
    fn the_start_is_slower_by_a_rounding_error() {
        let limits = Limits::symmetric(1.0, 9.0, 9.0);
        let from = State { position: 0.0, velocity: 1.0, acceleration: 1.0 };
        let to = State { position: 1.375, velocity: 1.75, acceleration: 1.0 };
        let problem = Problem::new(&limits, &from, &to).with_positions(1e3);
        let mut axis = Move::default();
        problem.write(&mut axis, &problem.fastest()).expect("a plan");
        let after = |ulps: f64| 1.0 + ulps * f64::EPSILON;
        assert!(takes(&axis, &problem, after(170.0)) && !takes(&axis, &problem, after(260.0)));
        // So it is 84 ulps slower. If it were shifted in time instead, it would be 170.
        stretch(&mut axis, &|| problem, after(170.0)).expect("a move");
        assert!(axis.phase[1].velocity > 1.0 - 120.0 * f64::EPSILON);
    }

    /// A brake is to last 32 ulps less. It begins slower by a rounding error, and is not shifted in time: the jerk is high.
    #[test]
    fn a_brake_is_shorter_by_a_rounding_error() {
        let from = State { velocity: 4.0, ..State::at(0.0) };
        let problem = Problem::new(&Limits::symmetric(8.0, 0.125, 8.0), &from, &State::at(64.03125));
        let mut axis = Move::default();
        problem.write(&mut axis, &problem.fastest()).expect("a plan");
        let t = axis.t - 1024.0 * f64::EPSILON;
        assert!(takes(&axis, &problem, t) && !problem.may_shift(&axis, t));
        stretch(&mut axis, &|| problem, t).expect("a move");
        assert!(axis.phase[1].velocity < 4.0 && axis.phase[1].acceleration.abs() < f64::EPSILON);
    }

    /// In the time of the shift the acceleration changes by the rounding errors of both accelerations, and by what changes the velocity by rounding.
    #[test]
    fn the_start_is_shifted_by_a_rounding_error() {
        let limits = Limits::symmetric(1.0, 9.0, 9.0);
        let from = State { position: 0.0, velocity: 2.5, acceleration: 1.0 };
        let to = State::at(7.0);
        let mut fastest = Move::default();
        fastest.plan(&limits, from, to).expect("a plan");
        let problem = Problem::new(&limits, &from, &to);
        let of_velocity = 16.0 * (2.5 + 0.5) / fastest.t;
        let may_shift = |own: f64| problem.may_shift(&fastest, fastest.t - (own + of_velocity) * f64::EPSILON);
        assert!(may_shift(11.0) && !may_shift(24.0));
    }

    /// A cruise of 1/1024 s is shifted by what its own way rounds, however long the axis would take to brake.
    #[test]
    fn a_short_cruise_is_shifted_by_its_own_rounding() {
        let limits = Limits::symmetric(1.0 / 1024.0, 1.0, 1.0);
        let [from, to] = [-1.0 / 1024.0, 0.0].map(|position| State { velocity: 1.0, ..State::at(position) });
        let mut fastest = Move::default();
        fastest.plan(&limits, from, to).expect("a plan");
        let problem = Problem::new(&limits, &from, &to).with_positions(0.0);
        let may_shift = |ulps: f64| problem.may_shift(&fastest, fastest.t * (1.0 + ulps * f64::EPSILON));
        assert!(may_shift(60.0) && !may_shift(68.0));
    }

    /// An axis that brakes can wait where it comes to rest. Where one jerk is very small, rounding shows a gap.
    #[test]
    fn an_axis_that_waits_has_no_gap() {
        let limits = Limits { jmin: -1e-9, ..Limits::symmetric(1.0, 1.0, 1.0) };
        let from = State { position: 0.0, velocity: 1.0, acceleration: -0.9 };
        let mut problem = Problem::new(&limits, &from, &State::at(0.0));
        let mut axis = Move::default();
        let (fastest, end) = problem.reach();
        problem.to.position = end;
        problem.write(&mut axis, &fastest).expect("a plan");
        for t in (2..10).map(f64::from) {
            assert_eq!(next_duration(&problem, t), t);
            assert!(takes(&axis, &problem, t));
        }
    }

    /// Limits of 1, a standstill at 0 and no duration, with some numbers larger by octaves: six limits, which are smaller instead, both positions,
    /// velocities and accelerations, and the duration.
    fn is_ordinary_with(larger: &[(usize, i32)]) -> bool {
        let mut all = [0.0; 13];
        all[..6].fill(1.0);
        for &(number, octaves) in larger {
            all[number] = f64::from(if number < 6 { -octaves } else { octaves }).exp2();
        }
        let [vmax, vmin, amax, amin, jmax, jmin, p0, p1, v0, v1, a0, a1, duration] = all;
        let limits = Limits { vmax, vmin: -vmin, amax, amin: -amin, jmax, jmin: -jmin };
        let state = |position, velocity, acceleration| State { position, velocity, acceleration };
        Task { limits: &limits, from: &state(p0, v0, a0), to: &state(p1, v1, a1) }.is_ordinary(duration)
    }

    #[test]
    fn each_number_may_be_extraordinary() {
        for number in 0..13 {
            assert!(is_ordinary_with(&[(number, 8)]), "{number}");
            assert!(!is_ordinary_with(&[(number, 60)]), "{number}");
        }
    }

    #[test]
    fn several_numbers_may_be_extraordinary() {
        // To undo a high acceleration with a low jerk takes a high velocity.
        for (jerk, acceleration) in [(4, 10), (5, 11)] {
            assert!(!is_ordinary_with(&[(jerk, 7), (acceleration, 7)]));
        }
        // A high velocity takes long to end.
        assert!(!is_ordinary_with(&[(2, 24), (4, 24), (8, 24)]));
        assert!(!is_ordinary_with(&[(2, 14), (4, -14), (5, -14), (8, 14)]));
        // It takes the axis far in a second, also where it ends at once, and in a long time.
        assert!(!is_ordinary_with(&[(2, -99), (3, -99), (4, -99), (5, -99), (8, 60)]));
        assert!(!is_ordinary_with(&[(0, -99), (1, -99), (2, -99), (3, -99), (4, -99), (5, -99), (8, 60), (12, 50)]));
        // High jerks undo a high acceleration at once. In a long time it takes the axis far.
        assert!(is_ordinary_with(&[(4, -70), (5, -70), (10, 35)]));
        assert!(!is_ordinary_with(&[(4, -60), (5, -60), (10, 30), (12, 40)]));
        assert!(is_ordinary_with(&[(2, 20), (8, 0), (12, 35)]));
        // High numbers add up. They do not cancel each other.
        let sums: [&[_]; 7] = [
            &[(8, 30), (9, 30)],
            &[(8, 40), (10, 20)],
            &[(6, 60), (7, 60)],
            &[(6, 61), (8, 30)],
            &[(6, 60), (0, 1), (12, 62)],
            &[(6, 60), (2, 1)],
            &[(6, 60), (4, 1)],
        ];
        assert!(!sums.into_iter().any(is_ordinary_with));
        // A low limit counts among high ones.
        for limit in 0..6 {
            let limits = [0, 1, 2, 3, 4, 5].map(|number| (number, if number == limit { 60 } else { -60 }));
            assert!(!is_ordinary_with(&limits), "{limit}");
        }
    }
}
