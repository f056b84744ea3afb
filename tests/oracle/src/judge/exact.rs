//! The exact judge: it follows the phases of a plan without rounding. Every number of a plan is a whole number times a power of two, so the states
//! at the borders of the phases are exact. Only where the axis turns, or is fastest, within a phase, a root or a quotient is taken, to 500 bits.

use super::axes::Sets;
use super::axes::several::{Planner as _, Together};
use super::{Fastest, Plan, Planner, Problem, Problems, Request, Scale, parts, widened};
use crate::liba::Original;
use dashu_float::FBig;
use std::fmt::{Display, Formatter, Result as Written};
use support::prelude::*;

type Exact = FBig;
const BITS_OF_A_ROOT: usize = 500;

fn exact(x: f64) -> Exact {
    Exact::try_from(x).expect("a finite number").with_precision(0).value()
}

fn rounded(x: &Exact) -> f64 {
    x.to_f64().value()
}

/// By how many roundings a plan misses what it promises. One rounding is `EPSILON` times the size of a position, a velocity or an acceleration
/// of the motion, or of a limit of the jerk.
#[derive(Clone, Copy, Debug, Default)]
pub struct Misses {
    pub start: f64,  // the first phase begins elsewhere than the start
    pub border: f64, // a phase begins elsewhere than the one before it leads
    pub end: f64,    // the motion from the start, phase by phase, does not lead to the target
    pub limits: f64, // a velocity, an acceleration or a jerk is beyond its limit
    pub turns: f64,  // the axis turns outside of its ends, and the findings say that it does not
}

impl Misses {
    pub fn most(self, other: Self) -> Self {
        let Self { start, border, end, limits, turns } = self;
        let (start, border, end) = (start.max(other.start), border.max(other.border), end.max(other.end));
        Self { start, border, end, limits: limits.max(other.limits), turns: turns.max(other.turns) }
    }

    pub fn each(&self) -> [f64; 5] {
        [self.start, self.border, self.end, self.limits, self.turns]
    }

    /// The largest of the first three, which ask nothing of the findings.
    pub fn jump(&self) -> f64 {
        self.start.max(self.border).max(self.end)
    }

    /// The misses of a plan that answers this problem. Its numbers may be larger than its own sizes by `more`.
    pub fn of<R: Real>(problem: &Problem<R>, plan: &Plan<R>, more: &Scale) -> Self {
        let phases = phases_of(&plan.planned);
        let walk = walk(problem, &phases);
        let size = Size::of(&walk, &problem.limits, plan.planned.t.widen()).and(more);
        let ulp = R::MACHINE_EPSILON.widen();
        let ulps = |miss: [f64; 3]| size.relative(miss) / ulp;
        let gap = |one: &Point, other: &Point| ulps(jump(&problem.limits, one, other));
        let start = phases.iter().find(|phase| phase.duration > exact(0.0)).map_or(0.0, |phase| gap(&walk[0], phase));
        let neighbours = phases.windows(2).map(|pair| gap(&pair[0].at(&pair[0].duration), &pair[1]));
        let end = walk.last().expect("a start");
        let passed: Vec<_> = walk.iter().flat_map(Point::passed).collect();
        Self {
            start,
            border: neighbours.fold(0.0, f64::max),
            end: ulps(missed(problem, end, plan.planned.t.widen())),
            limits: beyond(problem, plan, &passed, &size) / ulp,
            turns: turned(problem, plan, [&walk[0], end], &passed, &size) / ulp,
        }
    }
}

#[derive(Clone)]
struct Point {
    six_p: Exact, // six times the position: so its polynomial has no fraction
    v: Exact,
    a: Exact,
    jerk: Exact,
    duration: Exact,
}

impl Point {
    fn of<R: Real>(phase: &Phase<R>) -> Self {
        let Phase { position, velocity, acceleration, jerk, duration, .. } = *phase;
        let [p, v, a, jerk, duration] = [position, velocity, acceleration, jerk, duration].map(|x| exact(x.widen()));
        Self { six_p: p * exact(6.0), v, a, jerk, duration }
    }

    fn at(&self, z: &Exact) -> Self {
        let Self { six_p, v, a, jerk, duration } = self;
        Self {
            six_p: six_p + z * (exact(6.0) * v + z * (exact(3.0) * a + z * jerk)),
            v: v + z * (a + exact(0.5) * z * jerk),
            a: a + z * jerk,
            jerk: jerk.clone(),
            duration: duration.clone(),
        }
    }

    fn state(&self) -> [f64; 3] {
        [rounded(&self.six_p) / 6.0, rounded(&self.v), rounded(&self.a)]
    }

    fn gap(&self, other: &Self) -> [f64; 3] {
        let gaps = [&self.six_p - &other.six_p, &self.v - &other.v, &self.a - &other.a];
        let [six_p, v, a] = gaps.map(|gap| rounded(&gap).abs());
        [six_p / 6.0, v, a]
    }

    /// The states at both ends of the phase, and between them where the axis turns, and where it is fastest.
    fn passed(&self) -> Vec<Self> {
        let Self { v, a, jerk, duration, .. } = self;
        let finely = |x: Exact| x.with_precision(BITS_OF_A_ROOT).value();
        let zero = exact(0.0);
        let mut times = Vec::new();
        if *jerk != zero {
            times.push(finely(-a.clone()) / jerk);
            let square = a * a - exact(2.0) * v * jerk;
            if square >= zero {
                let root = finely(square).sqrt();
                times.push((-a - &root) / jerk);
                times.push((-a + &root) / jerk);
            }
        } else if *a != zero {
            times.push(finely(-v.clone()) / a);
        }
        times.retain(|z| *z > zero && z < duration);
        times.push(duration.clone());
        [self.clone()].into_iter().chain(times.iter().map(|z| self.at(z))).collect()
    }
}

fn phases_of<R: Real>(planned: &Move<R>) -> Vec<Point> {
    planned.phase[..=planned.count as usize].iter().map(Point::of).collect()
}

/// By how much a state differs from the next one. Where a jerk has no limit, the acceleration may make a step.
fn jump<R: Real>(limits: &Limits<R>, before: &Point, after: &Point) -> [f64; 3] {
    let jerk = if after.a > before.a { limits.jmax } else { limits.jmin };
    let [p, v, a] = before.gap(after);
    [p, v, if jerk.widen().is_finite() { a } else { 0.0 }]
}

/// The motion from the start: each phase begins where the one before it leads, with the acceleration that the struct gives it.
fn walk<R: Real>(problem: &Problem<R>, phases: &[Point]) -> Vec<Point> {
    let [p, v, a] = parts(problem.ends()[0]).map(|x| exact(x.widen()));
    let zero = exact(0.0);
    let mut walk = vec![Point { six_p: p * exact(6.0), v, a, jerk: zero.clone(), duration: zero }];
    for phase in phases {
        let last = &walk[walk.len() - 1];
        let Point { six_p, v, .. } = last.at(&last.duration);
        walk.push(Point { six_p, v, ..phase.clone() });
    }
    walk
}

/// How far the state at the end is from the target, in what is asked for.
fn missed<R: Real>(problem: &Problem<R>, reached: &Point, t: f64) -> [f64; 3] {
    let [p, v, a] = parts(problem.ends()[1]).map(|x| exact(x.widen()));
    let zero = exact(0.0);
    let (p, v, a) = match problem.request {
        Request::Stop => (p, zero.clone(), zero.clone()),
        Request::Meet => (p + &v * exact(t), v, a),
        _ => (p, v, a),
    };
    let [p, v, a] = reached.gap(&Point { six_p: p * exact(6.0), v, a, jerk: zero.clone(), duration: zero });
    let is_free = matches!(problem.request, Request::Reach | Request::Stop);
    let steps = problem.request == Request::Trap; // a trapezoid ends with its acceleration
    [if is_free { 0.0 } else { p }, v, if steps { 0.0 } else { a }]
}

/// How large the numbers of a motion are, as `Move::check` documents it.
struct Size([f64; 3]);

impl Size {
    fn of<R: Real>(walk: &[Point], limits: &Limits<R>, t: f64) -> Self {
        let [vmax, vmin, amax, amin, jmax, jmin] = widened(limits);
        let states: Vec<_> = walk.iter().map(Point::state).collect();
        let most = |k: usize| states.iter().map(|state| state[k].abs()).fold(0.0, f64::max);
        let jerk = walk.iter().map(|point| rounded(&point.jerk).abs()).fold(0.0, f64::max);
        let ends = [&walk[0], &walk[walk.len() - 1]].map(|point| rounded(&point.a));
        let eased: f64 = ends.iter().map(|a| 0.5 * a * a * (1.0 / jmax - 1.0 / jmin)).sum();
        let changes: f64 = walk.iter().map(|point| rounded(&point.duration)).sum::<f64>() * most(2);
        let within = (vmax - vmin).min((amax - amin) * t).min((jmax - jmin) * t * t);
        let velocity = most(1) + changes + eased + within;
        Self([2.0 * most(0) + velocity * t, velocity, most(2) + jerk * t])
    }

    fn and(&self, more: &Scale) -> Self {
        let Self([position, velocity, acceleration]) = *self;
        Self([position + more.position, velocity + more.velocity, acceleration + more.acceleration])
    }

    fn relative(&self, differences: [f64; 3]) -> f64 {
        let over = |(difference, size): (f64, f64)| if difference == 0.0 { 0.0 } else { difference / size };
        differences.into_iter().zip(self.0).map(over).fold(0.0, f64::max)
    }
}

/// How far the motion is beyond the limits. A start outside of them excuses velocities and accelerations.
fn beyond<R: Real>(problem: &Problem<R>, plan: &Plan<R>, passed: &[Point], size: &Size) -> f64 {
    let [vmax, vmin, amax, amin, jmax, jmin] = widened(&problem.limits);
    let over = |x: &Exact, low: f64, high: f64| {
        let above = if high.is_finite() { rounded(&(x - exact(high))) } else { 0.0 };
        let below = if low.is_finite() { rounded(&(exact(low) - x)) } else { 0.0 };
        above.max(below).max(0.0)
    };
    let starts_outside = plan.findings.contains(Findings::STARTS_OUTSIDE);
    let excess = |Point { v, a, jerk, .. }: &Point| {
        let beyond_jerk = over(jerk, jmin, jmax) / jmax.max(-jmin);
        let state = [0.0, over(v, vmin, vmax), over(a, amin, amax)];
        if starts_outside { beyond_jerk } else { beyond_jerk.max(size.relative(state)) }
    };
    passed.iter().map(excess).fold(0.0, f64::max)
}

/// How far the axis turns outside of its ends, if the findings say that it stays between them.
fn turned<R: Real>(problem: &Problem<R>, plan: &Plan<R>, ends: [&Point; 2], passed: &[Point], size: &Size) -> f64 {
    if plan.findings.contains(Findings::OVERSHOOTS) || problem.request == Request::Meet {
        return 0.0;
    }
    let [one, other] = ends.map(|point| &point.six_p);
    let (lowest, highest) = if one < other { (one, other) } else { (other, one) };
    let outside = |Point { six_p, .. }: &Point| {
        let excess = rounded(&(lowest - six_p)).max(rounded(&(six_p - highest))).max(0.0);
        size.relative([excess / 6.0, 0.0, 0.0])
    };
    passed.iter().map(outside).fold(0.0, f64::max)
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Part {
    JerkUp,
    JerkDown,
    HighestAcceleration,
    LowestAcceleration,
    HighestVelocity,
    LowestVelocity,
}

use Part::{HighestAcceleration, HighestVelocity, JerkDown, JerkUp, LowestAcceleration, LowestVelocity};

/// The motion that goes farthest in its time. Its jerk has the sign of one parabola, which passes 0 twice at most: up, down, up. The acceleration
/// holds where it is at a limit between two signs, and the velocity where it is at its limit, amid the falling acceleration.
const FARTHEST: [Part; 7] =
    [JerkUp, HighestAcceleration, JerkDown, HighestVelocity, JerkDown, LowestAcceleration, JerkUp];
/// The same, mirrored.
const NEAREST: [Part; 7] =
    [JerkDown, LowestAcceleration, JerkUp, LowestVelocity, JerkUp, HighestAcceleration, JerkDown];

/// Whether no motion within the limits gets farther in the same time between the same velocities and accelerations, or none stays nearer: the
/// principle of Pontryagin, checked on the phases. A fastest motion has this property: else its target could be had earlier, too. A move
/// that starts outside the limits first returns within them, and is not asked.
pub fn is_extremal<R: Real>(problem: &Problem<R>, plan: &Plan<R>) -> bool {
    let walk = walk(problem, &phases_of(&plan.planned));
    let size = Size::of(&walk, &problem.limits, plan.planned.t.widen());
    let lasting: Vec<_> = walk.iter().filter(|point| point.duration > exact(0.0)).collect();
    let follows = |order: &[Part; 7]| {
        let mut later = order.iter();
        lasting.iter().all(|point| later.any(|part| part.is(&problem.limits, point, &size)))
    };
    follows(&FARTHEST) || follows(&NEAREST)
}

impl Part {
    /// Whether an axis does it in a phase, up to 64 roundings.
    fn is<R: Real>(self, limits: &Limits<R>, point: &Point, size: &Size) -> bool {
        let few = 64.0 * R::MACHINE_EPSILON.widen();
        let [vmax, vmin, amax, amin, jmax, jmin] = widened(limits);
        let at =
            |x: &Exact, limit: f64, size: f64| limit.is_finite() && rounded(&(x - exact(limit))).abs() <= few * size;
        let Point { v, a, jerk, .. } = point;
        let zero = exact(0.0);
        let (holds, cruises) = (*jerk == zero, *jerk == zero && *a == zero);
        let Size([_, velocity, _]) = *size;
        match self {
            JerkUp => at(jerk, jmax, jmax),
            JerkDown => at(jerk, jmin, -jmin),
            HighestAcceleration => holds && at(a, amax, amax),
            LowestAcceleration => holds && at(a, amin, -amin),
            HighestVelocity => cruises && at(v, vmax, velocity),
            LowestVelocity => cruises && at(v, vmin, velocity),
        }
    }
}

#[derive(Clone, Debug)]
pub struct Row {
    pub kind: String, // which function plans them
    real: &'static str,
    pub motions: u64,
    pub most: Misses,  // their worst misses
    pub asked: u64,    // motions that have to be extremal: a `Move` or a trapezoid alone, from within the limits
    pub extremal: u64, // those of them that are
}

impl Row {
    pub const HEADER: &'static str = "function,real type,motions,start,border,end,limits,turns,have to be extremal,are";

    pub fn of_every_kind<R: Original>(motions: usize) -> Vec<Self> {
        use Request::{Bell, Meet, Plan, Reach, Stop, Trap};
        let alone = [Plan, Reach, Stop, Meet, Bell, Trap];
        let alone = alone.map(|request| Self::of_request::<R>(&Fastest, request, motions));
        alone.into_iter().chain([false, true].map(|is_line| Self::of_axes::<R>(is_line, motions))).collect()
    }

    /// The row of a planner of one axis. Other tests ask whether a plan is refused.
    pub fn of_request<R: Original>(planner: &impl Planner<R>, request: Request, motions: usize) -> Self {
        let sequence = if request.profile().is_some() { Problems::<R>::of_profiles } else { Problems::new };
        let problems = (0..).flat_map(|seed| sequence(seed).take(1_000_000));
        let mut row = Self::named::<R>(format!("{request:?}").to_lowercase());
        let problems = problems.filter(|problem| problem.request == request);
        let planned = problems.filter_map(|problem| Some((problem, planner.plan(&problem).ok()?)));
        for (problem, plan) in planned.take(motions) {
            row.note(&problem, &plan);
            // The times of a double-S are rounded in its struct, and a phase shorter than their rounding has a lower jerk.
            if request != Request::Bell && !plan.findings.contains(Findings::STARTS_OUTSIDE) {
                row.asked += 1;
                row.extremal += u64::from(is_extremal(&problem, &plan));
            }
        }
        row
    }

    fn of_axes<R: Original>(is_line: bool, motions: usize) -> Self {
        let mut sets = if is_line { Sets::<R>::on_lines(0) } else { Sets::new(0) };
        let mut row = Self::named::<R>(if is_line { "line" } else { "sync" }.into());
        while row.motions < motions as u64 {
            let set = sets.next().expect("endless sets");
            let mut axes = vec![Move::default(); set.axes.len()];
            let planned = if is_line { Together.line(&set, &mut axes) } else { Together.synchronise(&set, &mut axes) };
            let findings = planned.expect("a plan of all axes");
            for (problem, axis) in set.axes.iter().zip(&axes) {
                row.note(problem, &Plan::of_move(*axis, findings));
            }
        }
        row
    }

    fn named<R: Real>(kind: String) -> Self {
        Self { kind, real: R::NAME, motions: 0, most: Misses::default(), asked: 0, extremal: 0 }
    }

    fn note<R: Real>(&mut self, problem: &Problem<R>, plan: &Plan<R>) {
        self.motions += 1;
        self.most = self.most.most(Misses::of(problem, plan, &Scale::default()));
    }

    /// Whether no motion misses more than the documented 64 roundings, or 128 where it turns, and all that have to be are extremal.
    pub fn is_clean(&self) -> bool {
        let misses = self.most.jump() > 64.0 || self.most.limits > 64.0 || self.most.turns > 130.0;
        self.motions > 0 && !misses && self.extremal == self.asked
    }
}

impl Display for Row {
    fn fmt(&self, f: &mut Formatter<'_>) -> Written {
        let Self { kind, real, motions, most, asked, extremal } = self;
        let most = most.each().map(|miss| format!("{miss:.1}")).join(",");
        let asked = if *asked > 0 { format!("{asked},{extremal}") } else { ",".into() };
        write!(f, "{kind},{real},{motions},{most},{asked}")
    }
}
