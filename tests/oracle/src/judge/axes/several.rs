//! What is wrong with axes that arrive together.

use super::Set;
use crate::judge::rivals::{fits_ruckig, ruckig};
use crate::judge::{Check, LEAVES, Plan, Problem, Scale, Trial, Verdict, are_of_a_move, doubt, tolerance};
use crate::liba::Original;
use support::online::tried;
use support::prelude::*;

pub trait Planner<R: Real> {
    fn synchronise(&self, set: &Set<R>, axes: &mut [Move<R>]) -> Result<Findings, Error> {
        let (limits, from, to) = set.columns();
        synchronise(axes, &limits, &from, &to, set.duration, set.cycle)
    }

    fn line(&self, set: &Set<R>, axes: &mut [Move<R>]) -> Result<Findings, Error> {
        let (limits, from, to) = set.columns();
        line(axes, &limits, &from, &to, set.duration, set.cycle)
    }
}

pub struct Together;

impl<R: Real> Planner<R> for Together {}

/// What the judge says of planned axes: the number of the bad axis, and what is wrong with it. 0 stands for the whole set too.
pub type Bad = (usize, Verdict);

pub fn wrong(axis: usize, what: &'static str) -> Check<Bad> {
    Err((axis, Verdict::Wrong(what)))
}

/// How much larger the numbers of a stretched motion may be than its own way tells.
///
/// A stretched motion is the mean of two motions. A ramp of one of them may be shorter than a rounding of the duration. Then its
/// acceleration jumps, by as much as the jerk can change it in a rounding of the duration.
///
/// Just before its end, an axis still has the roundings of the phases that it has passed: it may be off its way by what it travels while
/// an acceleration is eased.
pub fn scale_of_short_ramps<R: Original>(axis: &Trial<R>, duration: f64) -> Scale {
    let motion = axis.motion;
    let [_, _, amax, amin, jmax, jmin] = motion.limits;
    let speed = f64::max(motion.start[1].abs(), motion.target[1].abs());
    let pace = 0.5 * (1.0 / jmax - 1.0 / jmin);
    let easing = f64::min((speed * pace).sqrt(), amax.max(-amin) * pace);
    Scale {
        position: speed * easing,
        acceleration: if duration > 0.0 { jmax.max(-jmin) * duration } else { 0.0 },
        ..Scale::default()
    }
}

/// By how much the numbers of an axis may be larger than their own scale. The axis may be shifted in time, s: it arrives at a tick that its
/// fastest motion misses by rounding errors.
///
/// Then each end changes by up to eight times as many ulps of positions and velocities: 256 ulps of both velocities in sum are 512
/// of the higher one. The motion is followed from its start, so the changes of the velocity at both ends add up. After a shift in time
/// the acceleration changes by what the jerk changes in that time. The positions and the velocities limit the shift.
pub fn scale_of_a_shift<R: Original>(planned: &Trial<R>, axis: &Move<R>, shift: f64) -> Scale {
    let more = scale_of_short_ramps(planned, axis.t.widen());
    if shift == 0.0 {
        return more;
    }
    let [.., jmax, jmin] = planned.motion.limits;
    let own = Scale::of(&planned.problem, &plan_of(axis));
    let of_end = more.and(&own).times(8.0);
    of_end.and(&Scale {
        velocity: of_end.velocity,
        acceleration: jmax.max(-jmin) * shift.abs() / doubt::<R>(),
        ..Scale::default()
    })
}

/// By how much an axis arrives earlier than its fastest move does, or later, at a tick which the move misses by rounding errors, s; 0 if it does
/// not. A shift keeps the way, so an axis that arrives later has the phases of its fastest move behind the first one. On a line, the planner
/// counts the positions from the end, and the shares of the axes are rounded. So the phases are the same up to rounding.
pub fn time_shift<R: Real>(problem: &Problem<R>, axis: &Move<R>) -> f64 {
    let Ok((fastest, _)) = tried(&problem.limits, problem.from, problem.to) else { return 0.0 };
    let t = axis.t.widen();
    let shift = fastest.t.widen() - t;
    let rounding = 6.0 * R::MACHINE_EPSILON.widen() * t;
    let is_shifted = shift.abs() > rounding && (shift > 0.0 || keeps_way(problem, axis, &fastest));
    if is_shifted { shift } else { 0.0 }
}

/// Whether an axis has the phases of its fastest move behind the first one, up to rounding.
fn keeps_way<R: Real>(problem: &Problem<R>, axis: &Move<R>, fastest: &Move<R>) -> bool {
    let scale = Scale::of(problem, &plan_of(fastest));
    let agree = |one: R, other: R, scale: f64| (one.widen() - other.widen()).abs() <= doubt::<R>() * scale;
    let count = (fastest.count as usize).max(1);
    let mut phases = axis.phase[1..count].iter().zip(&fastest.phase[1..count]);
    let mut behind = axis.phase[..count].iter().zip(&fastest.phase).skip(2);
    axis.count == fastest.count
        && phases.all(|(one, other)| agree(one.jerk, other.jerk, other.jerk.widen().abs()))
        && behind.all(|(one, other)| {
            agree(one.position, other.position, scale.position) && agree(one.velocity, other.velocity, scale.velocity)
        })
}

pub struct Timing<'a, R> {
    pub axes: &'a [Trial<R>],   // the axes that share the duration
    pub shifts: &'a [f64],      // by how much each axis is shifted in time, s
    pub planned: &'a [Move<R>], // their motions, whose states have been judged
    pub duration: f64,          // the least duration, s
    pub cycle: f64,             // the period of the clock, s; 0: none
}

const TRIED: u32 = 128; // durations that the judge tries between the least one and that of the plan

impl<R: Original> Timing<'_, R> {
    /// What is wrong with the duration, if something is. `other` gives a duration that another library finds.
    /// It is asked only if an axis alone would arrive before: a shorter duration than that of the slowest axis is impossible.
    pub fn check(&self, t: f64, other: impl Fn() -> Option<f64>) -> Check<Bad> {
        // 4 ulps of the number of the tick, and those of the division and of the product.
        let rounding = 6.0 * R::MACHINE_EPSILON.widen() * t;
        if t < self.duration - rounding {
            return wrong(0, "the duration is too short");
        }
        let ticks = (t / self.cycle).round();
        if self.cycle > 0.0 && (ticks * self.cycle - t).abs() > rounding {
            return wrong(0, "the duration is not a multiple of the cycle");
        }
        // The states of an axis that is shifted are judged by themselves, and so are those of a ramp.
        let mut axes = self.axes.iter().zip(self.shifts).zip(self.planned);
        let impossible = axes.position(|((axis, by), planned)| !axis.is_possible(t + by) && !axis.is_ramp(planned));
        if let Some(axis) = impossible {
            return Err((axis, Verdict::Impossible));
        }
        self.earlier(t, other).map_or(Ok(()), |earlier| Err((0, Verdict::Longer(t / earlier))))
    }

    fn least(&self) -> f64 {
        self.axes.iter().map(|axis| axis.best.duration).fold(self.duration, f64::max)
    }

    fn earlier(&self, t: f64, other: impl Fn() -> Option<f64>) -> Option<f64> {
        let tolerance = tolerance::<R>();
        let least = self.least();
        let is_earlier = |x: &f64| *x < t * (1.0 - tolerance) && *x >= least;
        let mut tried = self.candidates(least, t, other);
        tried.retain(is_earlier);
        // Without the neighbours of the ends, the question is cheap.
        let all_may_arrive = |x: &f64| self.axes.iter().all(|axis| axis.motion.possible(*x));
        let all_arrive = |x: &f64| self.axes.iter().all(|axis| axis.is_surely_possible(*x));
        tried.into_iter().filter(all_may_arrive).find(all_arrive)
    }

    /// Durations to try: evenly spread ones, and the borders of the gaps; the ticks behind them if there is a clock.
    fn candidates(&self, least: f64, t: f64, other: impl Fn() -> Option<f64>) -> Vec<f64> {
        let more = 1.0 + 2.0 * tolerance::<R>();
        if t <= least * more * more {
            return Vec::new();
        }
        let even = (0..TRIED).map(|k| least + (t - least) * f64::from(k) / f64::from(TRIED));
        let borders = self.axes.iter().flat_map(|axis| [axis.best.duration, axis.best.gap_begins, axis.best.gap_ends]);
        let others = other().into_iter().filter(|other| *other < t * (1.0 - 1e-7));
        let exact = even.chain(borders).chain(others).filter(|x| x.is_finite());
        if self.cycle > 0.0 {
            exact.map(|x| (x / self.cycle).ceil() * self.cycle).collect()
        } else {
            exact.flat_map(|x| [x, x * more]).collect()
        }
    }
}

pub fn judge<R: Original>(planner: &impl Planner<R>, set: &Set<R>, random: &mut Random) -> Check<Bad> {
    let mut axes = vec![Move::default(); set.axes.len()];
    let found = planner.synchronise(set, &mut axes).map_err(|error| (0, Verdict::Refused(error)))?;
    let trials: Vec<_> = set.axes.iter().map(|axis| Trial::new(*axis)).collect();
    let [duration, cycle] = [set.duration, set.cycle].map(R::widen);
    let shifts: Vec<_> = set.axes.iter().zip(&axes).map(|(problem, axis)| time_shift(problem, axis)).collect();
    let timing = Timing { axes: &trials, shifts: &shifts, planned: &axes, duration, cycle };
    check_motions(&trials, &shifts, &axes, random)?;
    check_fastest(set, &axes)?;
    check_findings(&trials, &axes, found)?;
    let other = || fits_ruckig(&set.axes).then(|| ruckig(&set.axes, duration, cycle)).flatten();
    timing.check(axes[0].t.widen(), other)
}

pub fn plan_of<R: Real>(axis: &Move<R>) -> Plan<R> {
    Plan::of_move(*axis, Findings::default())
}

pub fn check_motions<R: Original>(
    trials: &[Trial<R>], shifts: &[f64], axes: &[Move<R>], random: &mut Random,
) -> Check<Bad> {
    let t = axes[0].t;
    for (k, (trial, axis)) in trials.iter().zip(axes).enumerate() {
        if axis.t.low_bits() != t.low_bits() {
            return wrong(k, "the axes do not arrive together");
        }
        let more = scale_of_a_shift(trial, axis, shifts[k]);
        trial.check_states(&plan_of(axis), &more, random).or_else(|what| wrong(k, what))?;
    }
    Ok(())
}

/// Whether an axis whose fastest move takes as long does not make its fastest move.
fn check_fastest<R: Real>(set: &Set<R>, axes: &[Move<R>]) -> Check<Bad> {
    for (k, (problem, axis)) in set.axes.iter().zip(axes).enumerate() {
        let Ok((mut fastest, _)) = tried(&problem.limits, problem.from, problem.to) else { continue };
        // An axis that is shifted begins and ends next to its fastest move by rounding errors, and is judged like any other.
        let is_slowest = fastest.t >= axis.t && time_shift(problem, axis) == 0.0;
        // A tick may lie a rounding before the end. Then a last phase that is as short starts there.
        for phase in &mut fastest.phase {
            phase.start = if phase.start > axis.t { axis.t } else { phase.start };
        }
        let count = fastest.count as usize;
        if is_slowest && fastest.phase[..count] != axis.phase[..axis.count as usize] {
            return wrong(k, "the slowest axis does not make its fastest move");
        }
    }
    Ok(())
}

fn check_findings<R: Original>(trials: &[Trial<R>], axes: &[Move<R>], found: Findings) -> Check<Bad> {
    let of = |k: usize, findings| {
        let more = scale_of_short_ramps(&trials[k], axes[k].t.widen());
        trials[k].check_findings(&plan_of(&axes[k]), findings, &more)
    };
    let count = trials.len();
    if !are_of_a_move(found) {
        return wrong(0, "a finding is none of a move");
    }
    for k in 0..count {
        if let Err(what @ ("it overshoots" | "it starts outside" | LEAVES)) = of(k, found) {
            return wrong(k, what);
        }
    }
    // A stretched axis may turn by a rounding of the mean, so a groundless `OVERSHOOTS` is not looked for.
    let leaves = found.bits() & Findings::ENDS_LEAVING.bits() != 0;
    if leaves && trials.iter().all(|trial| trial.leaves_after() == Some(false)) {
        return wrong(0, "no axis leaves its limits afterwards");
    }
    let groundless = "it does not start outside";
    let outside = found.bits() & Findings::STARTS_OUTSIDE.bits() != 0;
    let nobody = || (0..count).all(|k| of(k, Findings::STARTS_OUTSIDE) == Err(groundless));
    if outside && nobody() { wrong(0, groundless) } else { Ok(()) }
}
