//! What is wrong with a motion: longer, shorter or other than the reference solver's, a jump, a limit that it leaves, an end that it misses,
//! other durations if it is mirrored or in other units.

use super::exact::Misses;
use super::solver::{Best, Grid, Knot, Motion, Walk};
use super::{Kind, Plan, Planner, Problem, Request};
use crate::liba::Original;
use support::online::numbers_of_phase;
use support::prelude::*;

pub const OF_A_MOVE: [Findings; 3] = [Findings::OVERSHOOTS, Findings::STARTS_OUTSIDE, Findings::ENDS_LEAVING];

pub fn are_of_a_move(findings: Findings) -> bool {
    let all = OF_A_MOVE.into_iter().reduce(|all, one| all | one);
    all.is_some_and(|all| all.contains(findings))
}

/// `Ok` if nothing is wrong, else the first thing that is.
pub type Check<Wrong = &'static str> = Result<(), Wrong>;

/// The verdict if the finding is missing that the axis will unavoidably exceed its limits after the target.
pub const LEAVES: &str = "it leaves the limits afterwards";

#[derive(Clone, Debug, PartialEq)]
pub enum Verdict {
    Good {
        error: f64,   // its relative error
        detour: bool, // whether the axis turns and comes again, though a ramp ends within 4 ulps of the target
    },
    Refused(Error),      // there is no plan
    Wrong(&'static str), // the motion is wrong
    Longer(f64),         // the duration is this factor longer than the least one
    Shorter(f64),        // the duration is this factor shorter than the least one
    Impossible,          // an axis that moves together with others cannot reach its target in this duration
}

impl Verdict {
    fn is_like(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Longer(mine), Self::Longer(theirs)) | (Self::Shorter(mine), Self::Shorter(theirs)) => {
                mine - 1.0 > 0.1 * (theirs - 1.0)
            }
            (Self::Good { .. }, Self::Good { .. }) => true,
            _ => self == other,
        }
    }
}

/// How far a duration may be off, besides what a few ulps of the target explain.
pub fn tolerance<R: Real>() -> f64 {
    if size_of::<R>() == 8 { 1e-9 } else { 1e-5 }
}

pub fn doubt<R: Real>() -> f64 {
    64.0 * R::MACHINE_EPSILON.widen()
}

/// How large the numbers of a motion are. Its errors are measured in ulps of them.
#[derive(Clone, Copy, Debug, Default)]
pub struct Scale {
    pub position: f64,     // of its positions
    pub velocity: f64,     // of its velocities
    pub acceleration: f64, // of its accelerations
}

impl Scale {
    pub fn of<R: Real>(problem: &Problem<R>, plan: &Plan<R>) -> Self {
        Self::of_walk(&problem.limits, plan, &Walk::of(problem.ends()[0], &plan.planned))
    }

    pub fn times(self, factor: f64) -> Self {
        let Self { position, velocity, acceleration } = self;
        Self { position: factor * position, velocity: factor * velocity, acceleration: factor * acceleration }
    }

    pub fn and(self, more: &Self) -> Self {
        self.with(more, |own, more| own + more)
    }

    /// By how much this scale is larger than another one.
    pub fn beyond(self, other: &Self) -> Self {
        self.with(other, |own, other| (own - other).max(0.0))
    }

    fn with(self, other: &Self, number: impl Fn(f64, f64) -> f64) -> Self {
        Self {
            position: number(self.position, other.position),
            velocity: number(self.velocity, other.velocity),
            acceleration: number(self.acceleration, other.acceleration),
        }
    }

    fn of_walk<R: Real>(limits: &Limits<R>, plan: &Plan<R>, walk: &Walk) -> Self {
        let planned = &plan.planned;
        let pace = 1.0 / limits.jmax.widen() - 1.0 / limits.jmin.widen();
        let knots = walk.knots.iter();
        let most = |k: usize| knots.clone().map(|knot| knot[k].abs()).fold(0.0, f64::max);
        let t = planned.t.widen();
        // The velocities once the acceleration is 0, at the start or at the end are the axis' own too.
        let [first, last] = [0, planned.count as usize].map(|k| planned.phase[k].acceleration.widen());
        let at_zero_a = 0.25 * pace * (first * first + last * last);
        let mut fastest = most(2);
        let (mut changes, mut most_jerk): (f64, f64) = (0.0, 0.0);
        for phase in &planned.phase[..planned.count as usize] {
            // A ramp that is shorter than the rounding of the duration takes no time, but the axis gets its velocity.
            fastest = fastest.max(phase.velocity.widen().abs());
            let [duration, a, jerk] = [phase.duration, phase.acceleration, phase.jerk].map(R::widen);
            // An acceleration that changes has an error in proportion to the highest one. An acceleration that holds is exact.
            changes += duration * if jerk == 0.0 { a.abs() } else { most(3) };
            most_jerk = most_jerk.max(jerk.abs());
        }
        // A profile counts from both of its ends: errors do not add up from phase to phase, but the time is rounded.
        let is_profile = plan.profile.is_some();
        let velocity = fastest + at_zero_a + if is_profile { 0.0 } else { changes };
        Self {
            position: 2.0 * most(1) + velocity * t,
            velocity: velocity + if is_profile { most(3) * t } else { 0.0 },
            acceleration: most(3) + most_jerk * t,
        }
    }
}

pub struct Trial<R> {
    pub problem: Problem<R>,
    pub motion: Motion,
    pub best: Best, // its fastest motion
}

impl<R: Original> Trial<R> {
    pub fn new(problem: Problem<R>) -> Self {
        let motion = Motion::of(&problem);
        Self { problem, best: motion.best(), motion }
    }

    fn has_position(&self) -> bool {
        !matches!(self.problem.request, Request::Reach | Request::Stop)
    }

    pub fn least(&self, best: &Best) -> f64 {
        if self.has_position() { best.duration } else { best.direct }
    }

    fn passed(&self) -> [f64; 2] {
        let Best { duration, speed, variation, changing, .. } = self.best;
        let is_profile = self.problem.request.profile().is_some();
        let velocity = if is_profile { speed } else { speed + variation + changing };
        let ends = self.motion.start[0].abs() + self.motion.target[0].abs();
        [ends + velocity * duration, velocity]
    }

    /// The least duration, and the durations that are as good because the target is a few ulps away.
    fn possible(&self, best: &Best, position: f64, velocity: f64) -> impl Iterator<Item = f64> {
        let near = |off: f64| !self.has_position() || off.abs() <= position;
        let direct = near(best.past_direct);
        let gap_begins = near(best.past_begin) && best.gap_begins.is_finite();
        let gap_ends = near(best.past_end) && best.gap_ends.is_finite();
        let straight = near(best.past_straight) && best.faster.abs() <= velocity;
        let others = [
            (direct, best.direct),
            (gap_begins && self.has_position(), best.gap_begins),
            (gap_ends && self.has_position(), best.gap_ends),
            (straight, best.straight),
        ];
        let others = others.into_iter().filter(|(is_near, _)| *is_near);
        [self.least(best)].into_iter().chain(others.map(|(_, duration)| duration))
    }

    pub fn is_possible(&self, duration: f64) -> bool {
        let tolerance = tolerance::<R>();
        let [position, velocity] = self.roundings(duration);
        let reached = |t: f64, offset| self.motion.lacks(t, offset).abs() <= position;
        let times = [1.0, 1.0 + tolerance, 1.0 - tolerance].map(|factor| factor * duration);
        times.iter().any(|&t| reached(t, [0.0; 3]))
            || offsets(position, velocity).any(|offset| times.iter().any(|&t| reached(t, offset)))
            || matches!(self.duration(duration), Verdict::Good { .. })
    }

    /// Whether the target, and whatever is a few ulps from it, can be reached in this duration.
    pub fn is_surely_possible(&self, duration: f64) -> bool {
        let [position, velocity] = self.roundings(duration);
        self.motion.possible(duration)
            && offsets(position, velocity).all(|offset| self.motion.lacks(duration, offset) == 0.0)
    }

    /// 64 ulps of the positions and of the velocities of a motion that lasts as long, or more if the reference solver knows them no better.
    fn roundings(&self, duration: f64) -> [f64; 2] {
        let doubt = doubt::<R>().max(4.0 * self.best.wrong);
        let [position, velocity] = self.passed();
        let longer = (duration - self.best.duration).max(0.0);
        [position + velocity * longer, velocity].map(|scale| scale * doubt)
    }

    /// Whether the axis turns and comes again, though a ramp ends within 4 ulps of the target.
    pub fn is_detour(&self, duration: f64) -> bool {
        let [p0, v0, _] = self.motion.start.map(f64::abs);
        let [p1, v1, _] = self.motion.target.map(f64::abs);
        let few = doubt::<R>() / 16.0;
        let way = p0 + p1 + v0.max(v1) * self.best.direct;
        let shortest = self.possible(&self.best, few * way, few * v0.max(v1));
        duration > 1.1 * shortest.fold(f64::INFINITY, f64::min)
    }

    /// Compares a duration with the reference solver's, and if they differ, with the solver's for ends a few ulps away.
    pub fn duration(&self, duration: f64) -> Verdict {
        self.duration_near(duration, 0.0)
    }

    pub fn duration_near(&self, duration: f64, accuracy: f64) -> Verdict {
        let tolerance = tolerance::<R>();
        let error = |least: f64| {
            if duration == least { 0.0 } else { (duration / least - 1.0).abs() }
        };
        let good = |least| Verdict::Good { error: error(least), detour: self.is_detour(duration) };
        let least = self.least(&self.best);
        if error(least) <= tolerance {
            return good(least);
        }
        // Where the reference solver's own motion misses the ends, it knows the ends no better.
        let doubt = doubt::<R>().max(4.0 * self.best.wrong);
        let near = |scale: f64| (scale * doubt).max(accuracy);
        let [position, velocity] = self.passed().map(near);
        // The velocities of a profile are taken as they are, and its displacement does not rise and fall.
        let is_profile = self.problem.request.profile().is_some();
        let (velocity, coarse, fine) = if is_profile { (0.0, 3, 0) } else { (velocity, 27, 3) };
        let (mut lowest, mut highest) = (f64::INFINITY, 0f64);
        let coarse = (0..coarse).map(|index| (index, Grid::COARSE));
        for (index, grid) in coarse.chain((0..fine).map(|index| (index, Grid::FINE))) {
            let best = self.motion.best_at(offset(index, position, velocity), grid);
            for least in self.possible(&best, position, velocity) {
                if error(least) <= tolerance {
                    return good(least);
                }
                (lowest, highest) = (lowest.min(least), highest.max(least));
            }
        }
        if duration > highest * (1.0 + tolerance) {
            Verdict::Longer(duration / highest)
        } else if duration < lowest * (1.0 - tolerance) {
            Verdict::Shorter(lowest / duration)
        } else if duration.is_finite() {
            good(duration)
        } else {
            Verdict::Wrong("the duration is not finite")
        }
    }

    pub fn check_motion(&self, plan: &Plan<R>, random: &mut Random) -> Check {
        let own = Scale::default();
        self.check_states(plan, &own, random)?;
        self.check_findings(plan, plan.findings, &own)
    }

    /// What is wrong with the states of the motion, if something is. Its numbers may be larger than its own scale by `more`.
    pub fn check_states(&self, plan: &Plan<R>, more: &Scale, random: &mut Random) -> Check {
        let planned = &plan.planned;
        check_phases(planned)?;
        self.check_ends(plan)?;
        let (walk, scale) = self.walk(plan, more);
        self.check_borders(planned, &walk, &scale)?;
        self.check_limits(planned, &walk, &scale)?;
        check_evaluation(plan, &walk, &scale, random)?;
        // Exact arithmetic takes long, so one motion in 16 is asked.
        let jumps = || Misses::of(&self.problem, plan, more).jump() > 64.0;
        none_of([(random.one_in(16) && jumps(), "the exact motion jumps or misses its end")])
    }

    fn walk(&self, plan: &Plan<R>, more: &Scale) -> (Walk, Scale) {
        let walk = Walk::of(self.problem.ends()[0], &plan.planned);
        let scale = Scale::of_walk(&self.problem.limits, plan, &walk).and(more);
        (walk, scale)
    }

    fn check_ends(&self, plan: &Plan<R>) -> Check {
        let zero = R::ZERO;
        let [from, to] = self.problem.ends();
        let request = self.problem.request;
        let (v1, a1) = if request == Request::Stop { (zero, zero) } else { (to.velocity, to.acceleration) };
        let t = plan.planned.t;
        let [position, velocity, acceleration, _] = plan.state(t);
        let has_position = self.has_position() && request != Request::Meet;
        let [start, speed, ..] = plan.state(zero);
        // A trapezoid ends with its acceleration, and one ramp alone of a double-S is counted from its end.
        let is_move = plan.profile.is_none();
        none_of([
            (has_position && position != to.position, "the end is not p1"),
            (velocity != v1, "the final velocity is not v1"),
            (is_move && acceleration != a1, "the final acceleration is not a1"),
            (is_move && t > zero && (start, speed) != (from.position, from.velocity), "the start is not the given one"),
        ])
    }

    fn check_borders(&self, planned: &Move<R>, walk: &Walk, scale: &Scale) -> Check {
        let [.., jmax, jmin] = self.motion.limits;
        let doubt = doubt::<R>();
        for (phase, &[p, v, a]) in planned.phase.iter().zip(&walk.borders).take(planned.count as usize + 1) {
            let [dp, dv] = [phase.position.widen() - p, phase.velocity.widen() - v];
            let jump = phase.acceleration.widen() - a;
            let may_jump = if jump > 0.0 { jmax } else { jmin }.is_infinite();
            none_of([
                (dp.abs() > doubt * scale.position, "the position jumps"),
                (dv.abs() > doubt * scale.velocity, "the velocity jumps"),
                (!may_jump && jump.abs() > doubt * scale.acceleration, "the acceleration jumps"),
            ])?;
        }
        let end = planned.state_at(planned.t).position.widen();
        let Request::Meet = self.problem.request else { return Ok(()) };
        let [p1, v1, _] = self.motion.target;
        let met = p1 + v1 * planned.t.widen();
        none_of([((end - met).abs() > doubt * (scale.position + p1.abs()), "the target is missed")])
    }

    fn check_limits(&self, planned: &Move<R>, walk: &Walk, scale: &Scale) -> Check {
        let [vmax, vmin, amax, amin, jmax, jmin] = self.motion.limits;
        let [_, v0, a0] = self.motion.start;
        let above =
            Side { sign: 1.0, velocity: vmax, acceleration: amax, unavoidable: v0 - 0.5 * a0.max(0.0) * a0 / jmin };
        let below =
            Side { sign: -1.0, velocity: -vmin, acceleration: -amin, unavoidable: -v0 + 0.5 * a0.min(0.0) * a0 / jmax };
        above.check(&walk.knots, scale, doubt::<R>())?;
        below.check(&walk.knots, scale, doubt::<R>())?;
        let slack = 1.0 + doubt::<R>();
        let mut jerks = planned.phases().iter().map(|phase| phase.jerk.widen());
        let is_beyond = jerks.any(|jerk| jerk > jmax * slack || jerk < jmin * slack);
        none_of([(is_beyond, "a jerk is beyond its limit")])
    }

    /// Whether the axis will unavoidably exceed its limits after the target; `None` if roundings decide.
    pub fn leaves_after(&self) -> Option<bool> {
        let [vmax, vmin, _, _, jmax, jmin] = self.motion.limits;
        let [_, v1, a1] = self.motion.target;
        let change = 0.5 * a1 * a1.abs() / if a1 > 0.0 { -jmin } else { jmax };
        let beyond = (v1 + change - vmax).max(vmin - v1 - change);
        let sure = beyond.abs() > doubt::<R>() * (v1.abs() + change.abs());
        (sure || a1 == 0.0).then_some(beyond > 0.0)
    }

    /// What is wrong with the findings, if they are not those of the motion. Its numbers may be larger than its own scale by `more`.
    pub fn check_findings(&self, plan: &Plan<R>, findings: Findings, more: &Scale) -> Check {
        let (walk, scale) = self.walk(plan, more);
        let found = |finding: Findings| findings.bits() & finding.bits() != 0;
        let leaves = self.leaves_after();
        let [vmax, vmin, amax, amin, jmax, jmin] = self.motion.limits;
        let [p0, v0, a0] = self.motion.start;
        let doubt = doubt::<R>();
        let at_zero_a = v0 - 0.5 * a0.abs() * a0 / if a0 > 0.0 { jmin } else { -jmax };
        let beyond = (v0.max(at_zero_a) - vmax).max(vmin - v0.min(at_zero_a));
        let slack = doubt * (v0.abs() + at_zero_a.abs());
        let accelerated = a0 > amax || a0 < amin;
        let [outside, leaving] = [Findings::STARTS_OUTSIDE, Findings::ENDS_LEAVING].map(found);
        none_of([
            (!are_of_a_move(findings), "a finding is none of a move"),
            (leaves == Some(true) && !leaving, LEAVES),
            (leaves == Some(false) && leaving, "it does not leave the limits afterwards"),
            (outside && !accelerated && beyond < -slack, "it does not start outside"),
            (!outside && (accelerated || beyond > slack), "it starts outside"),
        ])?;
        if matches!(self.problem.request, Request::Meet) {
            return Ok(());
        }
        let [p1, ..] = plan.state(plan.planned.t).map(R::widen);
        let excess = walk.knots.iter().map(|&[_, p, ..]| (p - p0.max(p1)).max(p0.min(p1) - p));
        let excess = excess.fold(0.0, f64::max);
        let overshoots = found(Findings::OVERSHOOTS);
        // An axis that starts against its way, or arrives from beyond, overshoots by as little as a rounding.
        let [_, v1, a1] = self.motion.target;
        let before = v1 - 0.5 * a1.abs() * a1 / if a1 > 0.0 { jmax } else { -jmin };
        let way = p1 - p0;
        let against = way == 0.0 || [v0, at_zero_a, v1, before].iter().any(|v| way * v < 0.0);
        // Compared with the velocities that an acceleration leads to afterwards, those of the move may be as small as roundings.
        none_of([
            (overshoots && excess == 0.0 && !(against || leaves == Some(true)), "it does not overshoot"),
            (!overshoots && excess > 4.0 * doubt * scale.position, "it overshoots"),
        ])
    }

    /// Whether the mirrored motion, the motion in other units, or the trapezoid with its accelerations in the other order takes another time.
    fn check_relatives(&self, planner: &impl Planner<R>, t: R, random: &mut Random) -> Check {
        let problem = &self.problem;
        let takes = |problem: &Problem<R>| planner.plan(problem).ok().map(|plan| plan.planned.t);
        none_of([(takes(&problem.mirrored()) != Some(t), "the mirrored motion takes another time")])?;
        let [length, time] = [(); 2].map(|()| random.steps(3));
        let expected = t.widen() * f64::from(time).exp2();
        // Near the border of the range a product is infinite in some units only. Then the motion is found in another way, up to rounding.
        let is_extreme = problem.kind == Kind::ExtremeScale;
        let rounding = if is_extreme { 4.0 * R::MACHINE_EPSILON.widen() * expected } else { 0.0 };
        let is_expected = |t: R| (t.widen() - expected).abs() <= rounding;
        let is_right = takes(&problem.scaled(length, time)).is_some_and(is_expected);
        none_of([(!is_right, "the units change the time")])?;
        let mut other = *problem;
        (other.limits.amax, other.limits.amin) = (problem.limits.amin, problem.limits.amax);
        let differs = problem.request == Request::Trap && takes(&other) != Some(t);
        none_of([(differs, "the order of the accelerations changes the time")])
    }

    pub fn judge(&self, planner: &impl Planner<R>, random: &mut Random) -> Verdict {
        let plan = match planner.plan(&self.problem) {
            Ok(plan) => plan,
            Err(error) => return Verdict::Refused(error),
        };
        let t = plan.planned.t;
        if let Err(what) = self.check_motion(&plan, random).and_then(|()| self.check_relatives(planner, t, random)) {
            return Verdict::Wrong(what);
        }
        match self.duration(t.widen()) {
            Verdict::Shorter(factor) if self.is_ramp(&plan.planned) => {
                Verdict::Good { error: factor - 1.0, detour: false }
            }
            verdict => verdict,
        }
    }

    /// Whether the acceleration makes one ramp: it changes, (holds) and changes back. The duration of a ramp allows one displacement only, and a
    /// ramp whose states are right up to rounding of both ends shows itself that such ends can be joined in its duration. The reference solver tries
    /// some of them only.
    pub fn is_ramp(&self, planned: &Move<R>) -> bool {
        self.problem.request.profile().is_none() && planned.count <= 4
    }

    pub fn simple_example(&self, planner: &impl Planner<R>, verdict: &Verdict) -> String {
        let simple = self.problem.simplified(|problem| {
            let seen = || Self::new(*problem).judge(planner, &mut Random::seeded(0));
            planner.is_worth_simple_examples() && seen().is_like(verdict)
        });
        let best = Self::new(simple);
        let least = best.least(&best.best);
        format!("{simple}; the least duration is {least:e}")
    }
}

/// How much further and faster the target is, and how much faster the start, in the neighbour of this number of a problem.
fn offset(index: usize, position: f64, velocity: f64) -> [f64; 3] {
    let shift = |of: usize| [0.0, -1.0, 1.0][index / of % 3];
    [shift(1) * position, shift(3) * velocity, shift(9) * velocity]
}

fn offsets(position: f64, velocity: f64) -> impl Iterator<Item = [f64; 3]> {
    (0..27).map(move |index| offset(index, position, velocity))
}

struct Side {
    sign: f64,
    velocity: f64,
    acceleration: f64,
    unavoidable: f64, // the velocity that the start makes unavoidable
}

impl Side {
    /// Whether the motion leaves the limits on this side. A start outside may return within them, but not go further out.
    fn check(&self, knots: &[Knot], scale: &Scale, doubt: f64) -> Check {
        let mut velocity = self.velocity.max(self.unavoidable);
        let mut acceleration = self.acceleration.max(self.sign * knots[0][3]);
        for &[_, _, v, a] in knots {
            let (v, a) = (self.sign * v, self.sign * a);
            none_of([
                (v > velocity + doubt * scale.velocity, "a velocity is beyond its limit"),
                (a > acceleration + doubt * scale.acceleration, "an acceleration is beyond its limit"),
            ])?;
            if a <= 0.0 {
                velocity = velocity.min(v.max(self.velocity));
            }
            acceleration = acceleration.min(a.max(self.acceleration));
        }
        Ok(())
    }
}

fn check_phases<R: Real>(planned: &Move<R>) -> Check {
    let count = planned.count as usize;
    none_of([(count > 15, "there are too many phases")])?;
    let phases = &planned.phase[..=count];
    let mut t = 0.0;
    for phase in phases {
        let rounding = 8.0 * R::MACHINE_EPSILON.widen() * planned.t.widen();
        let follows = (phase.start.widen() - t).abs() <= rounding && phase.duration.widen() >= 0.0;
        none_of([
            (!numbers_of_phase(phase).iter().all(|x| x.widen().is_finite()), "a number of a phase is not finite"),
            (!follows, "a phase does not follow the one before it"),
        ])?;
        t = phase.start.widen() + phase.duration.widen();
    }
    let end = &phases[count];
    let is_end = end.start == planned.t && end.duration.widen() == 0.0 && end.jerk.widen() == 0.0;
    none_of([
        (phases.windows(2).any(|pair| pair[0].start > pair[1].start), "the phases are not in order"),
        (!is_end, "the last phase is not the end"),
    ])
}

fn none_of<const N: usize>(faults: [(bool, &'static str); N]) -> Check {
    faults.into_iter().find(|(is_there, _)| *is_there).map_or(Ok(()), |(_, what)| Err(what))
}

/// Whether the evaluation differs from the integrated motion somewhere, or one of another kind has other bits.
fn check_evaluation<R: Original>(plan: &Plan<R>, walk: &Walk, scale: &Scale, random: &mut Random) -> Check {
    let planned = &plan.planned;
    let phases = &planned.phase[..=planned.count as usize];
    let t = planned.t.widen();
    let is_profile = plan.profile.is_some();
    let doubt = doubt::<R>() * if is_profile { 1.0 } else { 2.0 };
    // The rounding of the time.
    let accelerations = phases.iter().map(|phase| phase.acceleration.widen().abs());
    let velocity = doubt * (scale.velocity + accelerations.fold(0.0, f64::max) * t);
    let acceleration = doubt * scale.acceleration;
    let within = [(); 2].map(|()| R::of(random.unit()) * planned.t);
    let near = phases.iter().map(|phase| phase.start.neighbour(random.steps(2)));
    let is_over = |x: &R| !is_profile && *x > planned.t; // `does_a_move_go_on.rs` asks what comes after the end
    let times: Vec<R> = near.chain(within).filter(|x| !is_over(x)).collect();
    times.into_iter().try_for_each(|x| {
        let under_way = phases.iter().rposition(|phase| phase.start <= x); // phase 0 is the start
        let index = under_way.filter(|_| x > R::ZERO || t == 0.0).unwrap_or(0);
        let phase = &phases[index];
        let z = (x.widen() - phase.start.widen()).min(phase.duration.widen());
        let [p, v, _] = walk.borders[index];
        let [a, jerk] = [phase.acceleration, phase.jerk].map(R::widen);
        let state = plan.state(x);
        let [position, speed, accelerated, jerked] = state.map(R::widen);
        let expected = p + z * (v + z * (0.5 * a + z * jerk / 6.0));
        let [dv, da] = [speed - (v + z * (a + 0.5 * z * jerk)), accelerated - (a + z * jerk)];
        // At its ends a profile stands still, and rounding may make the borders of its phases cross.
        let stands = is_profile && (x <= R::ZERO || x >= planned.t);
        let mut others = other_evaluation(plan, x).into_iter().zip(state);
        none_of([
            ((position - expected).abs() > doubt * scale.position, "a position is not where the jerk leads"),
            (dv.abs() > velocity, "a velocity is not where the jerk leads"),
            (!stands && da.abs() > acceleration, "an acceleration is not where the jerk leads"),
            (!is_profile && jerked != jerk, "the jerk is not that of the phase"),
            (!others.all(|(other, own)| other.same(own)), "another evaluation has other bits"),
        ])
    })
}

/// The quantities at the time `x`, of a profile by the original, of a `Move` by single calls.
fn other_evaluation<R: Original>(plan: &Plan<R>, x: R) -> [R; 4] {
    let planned = &plan.planned;
    match &plan.profile {
        Some(profile) => profile.evaluate(&R::ORIGINAL, x),
        None => [planned.position(x), planned.velocity(x), planned.acceleration(x), planned.jerk(x)],
    }
}
