//! What is wrong with axes that move together, and how often.

use super::line;
use super::problems::{Family, Set, Sets};
use super::ruckig;
use crate::online::judge::{Scale, Trial, tolerance};
use crate::online::referee::widened;
use atraj::Findings;
use atraj::axes::{line, synchronise};
use atraj::online::{Error, Move};
use std::fmt::{Display, Formatter, Result as Written};
use support::{Random, Real};

/// Something that plans several axes.
pub trait Planner<R: Real> {
    /// Axes that arrive together.
    fn synchronise(&self, set: &Set<R>, axes: &mut [Move<R>]) -> Result<Findings, Error> {
        let (limits, from, to) = set.columns();
        synchronise(axes, &limits, &from, &to, set.duration, set.cycle)
    }

    /// Axes on a straight line.
    fn line(&self, set: &Set<R>, axes: &mut [Move<R>]) -> Result<Findings, Error> {
        let (limits, from, to) = set.columns();
        line(axes, &limits, &from, &to, set.duration, set.cycle)
    }
}

/// The planner under test.
pub struct Together;

impl<R: Real> Planner<R> for Together {}

/// What the judge says of planned axes.
#[derive(Clone, Debug, PartialEq)]
pub enum Verdict {
    /// There is no plan.
    Refused(Error),
    /// The motion of this axis is wrong.
    Wrong(usize, &'static str),
    /// An earlier duration is possible for all axes: the duration is this factor longer.
    Longer(f64),
    /// The duration is not possible for this axis.
    Impossible(usize),
}

/// How much larger the numbers of a stretched motion may be than its own way tells.
///
/// A stretched motion is the mean of two motions. A ramp of one of them may be shorter than a rounding of the duration. Then its acceleration
/// jumps, by as much as the jerk can change it in a rounding of the duration.
pub fn scale_of_short_ramps<R: Real>(axis: &Trial<R>, duration: f64) -> Scale {
    let [.., jmax, jmin] = axis.motion().limits;
    Scale {
        acceleration: if duration > 0.0 {
            jmax.max(-jmin) * duration
        } else {
            0.0
        },
        ..Scale::default()
    }
}

/// The durations of a set.
pub struct Timing<'a, R> {
    /// The axes that share the duration.
    pub axes: &'a [Trial<R>],
    /// The least duration, s.
    pub duration: f64,
    /// The period of the clock, s; 0: none.
    pub cycle: f64,
}

/// Durations that the judge tries between the least one and that of the plan.
const TRIED: u32 = 128;

impl<R: Real> Timing<'_, R> {
    /// What is wrong with the duration, if something is. `other` gives a duration that another library finds.
    /// It is asked only if an axis alone would arrive before: a shorter duration than that of the slowest axis is impossible.
    pub fn wrong(&self, t: f64, other: impl Fn() -> Option<f64>) -> Option<Verdict> {
        // 4 roundings of the number of the tick, and those of the division and of the product.
        let rounding = 6.0 * R::MACHINE_EPSILON.widen() * t;
        if t < self.duration - rounding {
            return Some(Verdict::Wrong(0, "the duration is too short"));
        }
        let ticks = (t / self.cycle).round();
        if self.cycle > 0.0 && (ticks * self.cycle - t).abs() > rounding {
            return Some(Verdict::Wrong(
                0,
                "the duration is not a multiple of the cycle",
            ));
        }
        let impossible = self.axes.iter().position(|axis| !axis.is_possible(t));
        if let Some(axis) = impossible {
            return Some(Verdict::Impossible(axis));
        }
        let earlier = self.earlier(t, other)?;
        Some(Verdict::Longer(t / earlier))
    }

    /// The fastest axis of all cannot arrive before.
    fn least(&self) -> f64 {
        let fastest = self.axes.iter().map(|axis| axis.best().duration);
        fastest.fold(self.duration, f64::max)
    }

    /// A duration before `t` in which all axes can arrive, without doubt.
    fn earlier(&self, t: f64, other: impl Fn() -> Option<f64>) -> Option<f64> {
        let tolerance = tolerance::<R>();
        let least = self.least();
        let is_earlier = |x: &f64| *x < t * (1.0 - tolerance) && *x >= least;
        let mut tried = self.candidates(least, t, other);
        tried.retain(is_earlier);
        let all_arrive = |x: &f64| self.axes.iter().all(|axis| axis.is_surely_possible(*x));
        tried.into_iter().find(all_arrive)
    }

    /// Durations to try: evenly spread ones, and the borders of the gaps; the ticks behind them if there is a clock.
    fn candidates(&self, least: f64, t: f64, other: impl Fn() -> Option<f64>) -> Vec<f64> {
        let beside = 1.0 + 2.0 * tolerance::<R>();
        if t <= least * beside * beside {
            return Vec::new();
        }
        let even = (0..TRIED).map(|k| least + (t - least) * f64::from(k) / f64::from(TRIED));
        let bests = self.axes.iter().map(Trial::best);
        let borders = bests.flat_map(|best| [best.duration, best.gap_begins, best.gap_ends]);
        let others = other()
            .into_iter()
            .filter(|other| *other < t * (1.0 - 1e-7));
        let exact = even.chain(borders).chain(others).filter(|x| x.is_finite());
        if self.cycle > 0.0 {
            exact
                .map(|x| (x / self.cycle).ceil() * self.cycle)
                .collect()
        } else {
            exact.flat_map(|x| [x, x * beside]).collect()
        }
    }
}

/// Judges axes that arrive together.
pub fn judge<R: Real>(
    planner: &impl Planner<R>,
    set: &Set<R>,
    random: &mut Random,
) -> Option<Verdict> {
    let mut axes = vec![Move::default(); set.axes.len()];
    let found = match planner.synchronise(set, &mut axes) {
        Ok(found) => found,
        Err(error) => return Some(Verdict::Refused(error)),
    };
    let trials: Vec<_> = set.axes.iter().map(|axis| Trial::new(*axis)).collect();
    let [duration, cycle] = [set.duration, set.cycle].map(R::widen);
    let timing = Timing {
        axes: &trials,
        duration,
        cycle,
    };
    wrong_motions(&trials, &axes, random)
        .or_else(|| wrong_fastest(set, &axes))
        .or_else(|| wrong_findings(&trials, &axes, found))
        .or_else(|| timing.wrong(axes[0].t.widen(), || ruckig::duration(set)))
}

/// Whether a motion is none, or the axes do not arrive together.
fn wrong_motions<R: Real>(
    trials: &[Trial<R>],
    axes: &[Move<R>],
    random: &mut Random,
) -> Option<Verdict> {
    let t = axes[0].t;
    for (k, (trial, axis)) in trials.iter().zip(axes).enumerate() {
        if axis.t.low_bits() != t.low_bits() {
            return Some(Verdict::Wrong(k, "the axes do not arrive together"));
        }
        let more = scale_of_short_ramps(trial, t.widen());
        if let Some(what) = trial.wrong_states(axis, &more, random) {
            return Some(Verdict::Wrong(k, what));
        }
    }
    None
}

/// Whether an axis whose fastest move takes as long does not make its fastest move.
fn wrong_fastest<R: Real>(set: &Set<R>, axes: &[Move<R>]) -> Option<Verdict> {
    for (k, (problem, axis)) in set.axes.iter().zip(axes).enumerate() {
        let mut fastest = Move::default();
        let planned = fastest.plan(&problem.limits, problem.from, problem.to);
        let is_slowest = planned.is_ok() && fastest.t >= axis.t;
        // A tick may lie a rounding before the end. Then a last phase that is as short starts there.
        for phase in &mut fastest.phase {
            phase.t = if phase.t > axis.t { axis.t } else { phase.t };
        }
        let count = fastest.phases as usize;
        if is_slowest && fastest.phase[..count] != axis.phase[..axis.phases as usize] {
            return Some(Verdict::Wrong(
                k,
                "the slowest axis does not make its fastest move",
            ));
        }
    }
    None
}

/// Whether a finding of an axis is missing, or no axis has the finding.
fn wrong_findings<R: Real>(
    trials: &[Trial<R>],
    axes: &[Move<R>],
    found: Findings,
) -> Option<Verdict> {
    let of = |k: usize, findings| {
        let more = scale_of_short_ramps(&trials[k], axes[k].t.widen());
        trials[k].wrong_findings(&axes[k], findings, &more)
    };
    let count = trials.len();
    let both = Findings::OVERSHOOTS | Findings::STARTS_OUTSIDE;
    if found.bits() & !both.bits() != 0 {
        return Some(Verdict::Wrong(0, "a finding is none of a move"));
    }
    for k in 0..count {
        if let Some(what @ ("it overshoots" | "it starts outside")) = of(k, found) {
            return Some(Verdict::Wrong(k, what));
        }
    }
    // A stretched axis may turn by a rounding of the mean, so a groundless `OVERSHOOTS` is not looked for.
    let groundless = "it does not start outside";
    let outside = found.bits() & Findings::STARTS_OUTSIDE.bits() != 0;
    let nobody = || (0..count).all(|k| of(k, Findings::STARTS_OUTSIDE) == Some(groundless));
    (outside && nobody()).then_some(Verdict::Wrong(0, groundless))
}

/// Counts of what was found in sets of one family.
#[derive(Clone, Debug, Default)]
pub struct Tally {
    /// Sets.
    pub sets: u64,
    /// Axes.
    pub axes: u64,
    /// Plans that are missing.
    pub refused: u64,
    /// Motions that are wrong.
    pub wrong: u64,
    /// Durations that are longer than another that is possible.
    pub longer: u64,
    /// Durations that are impossible.
    pub impossible: u64,
    /// The first bad sets in words.
    pub examples: Vec<String>,
}

/// The bad sets of a family that are shown.
const EXAMPLES: usize = 3;

impl Tally {
    /// Sets that are not planned well.
    pub fn bad(&self) -> u64 {
        self.refused + self.wrong + self.longer + self.impossible
    }

    fn add(&mut self, other: Self) {
        self.sets += other.sets;
        self.axes += other.axes;
        self.refused += other.refused;
        self.wrong += other.wrong;
        self.longer += other.longer;
        self.impossible += other.impossible;
        self.examples.extend(other.examples);
        self.examples.truncate(EXAMPLES);
    }

    fn note<R: Real>(&mut self, set: &Set<R>, verdict: Option<Verdict>) {
        self.sets += 1;
        self.axes += set.axes.len() as u64;
        let Some(verdict) = verdict else {
            return;
        };
        let count = match verdict {
            Verdict::Refused(_) => &mut self.refused,
            Verdict::Wrong(..) => &mut self.wrong,
            Verdict::Longer(_) => &mut self.longer,
            Verdict::Impossible(_) => &mut self.impossible,
        };
        *count += 1;
        if self.examples.len() < EXAMPLES {
            self.examples.push(format!("{verdict:?}: {}", set.show()));
        }
    }
}

/// What was found, by family: of axes that arrive together, and of axes on a straight line.
#[derive(Clone, Debug)]
pub struct Tallies {
    of: [[Tally; Family::ALL.len()]; 2],
}

impl Default for Tallies {
    fn default() -> Self {
        Self {
            of: [(); 2].map(|()| std::array::from_fn(|_| Tally::default())),
        }
    }
}

/// Sets that a seed stands for in long runs: as many that arrive together, and a quarter of them on a line.
pub const SETS_PER_SEED: usize = 10_000;

impl Tallies {
    /// Judges the planner by so many sets of a seed. Every fourth one lies on a line.
    pub fn of_seed<R: Real>(planner: &impl Planner<R>, seed: u64, sets: usize) -> Self {
        let mut tallies = Self::default();
        let mut random = Random::seeded(!seed);
        let [together, lines] = &mut tallies.of;
        for set in Sets::<R>::new(seed).take(sets - sets / 4) {
            let verdict = judge(planner, &set, &mut random);
            together[set.family as usize].note(&set, verdict);
        }
        for set in Sets::<R>::on_lines(seed).take(sets / 4) {
            let verdict = line::judge(planner, &set, &mut random);
            lines[set.family as usize].note(&set, verdict);
        }
        tallies
    }

    /// Adds what was found in other sets.
    pub fn add(&mut self, other: Self) {
        let others = other.of.into_iter().flatten();
        for (tally, other) in self.of.iter_mut().flatten().zip(others) {
            tally.add(other);
        }
    }

    /// The sum over all families.
    pub fn total(&self) -> Tally {
        let mut total = Tally::default();
        for tally in self.of.iter().flatten() {
            total.add(tally.clone());
        }
        total
    }
}

impl Display for Tallies {
    fn fmt(&self, f: &mut Formatter<'_>) -> Written {
        writeln!(
            f,
            "{:<24} {:>9} {:>9} {:>7} {:>7} {:>7} {:>10}",
            "family", "sets", "axes", "refused", "wrong", "longer", "impossible"
        )?;
        let mut write = |name: String, tally: &Tally| {
            let Tally {
                sets,
                axes,
                refused,
                wrong,
                longer,
                impossible,
                ..
            } = tally;
            writeln!(
                f,
                "{name:<24} {sets:>9} {axes:>9} {refused:>7} {wrong:>7} {longer:>7} {impossible:>10}"
            )
        };
        for (way, tallies) in ["", "line "].iter().zip(&self.of) {
            for (family, tally) in Family::ALL.iter().zip(tallies) {
                write(format!("{way}{family:?}"), tally)?;
            }
        }
        write("total".into(), &self.total())?;
        for example in self.of.iter().flatten().flat_map(|tally| &tally.examples) {
            writeln!(f, "{example}")?;
        }
        Ok(())
    }
}

/// The tightest limits, seen from an axis of which the others go `shares`.
pub fn tightest<R: Real>(set: &Set<R>, shares: &[R]) -> [R; 6] {
    let mut tightest = [R::of(f64::INFINITY), R::of(f64::NEG_INFINITY)].repeat(3);
    for (axis, &share) in set.axes.iter().zip(shares) {
        if share.widen() == 0.0 {
            continue;
        }
        let limits = widened(&axis.limits).map(R::of);
        for k in 0..6 {
            let seen = limits[if share.widen() > 0.0 { k } else { k ^ 1 }] / share;
            let is_tighter = seen.widen().abs() < tightest[k].widen().abs();
            tightest[k] = if is_tighter { seen } else { tightest[k] };
        }
    }
    tightest.try_into().expect("six limits")
}
