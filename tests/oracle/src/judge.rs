//! What is wrong with a plan of the least time, and how often.

use crate::abi::Original;
use crate::nasty::{Kind, Problem, Problems};
use crate::referee::{self, Best, MOST_PLANNED, Motion};
use atraj::{Bell, Boundary, Findings, Trap};
use std::fmt::{Display, Formatter, Result};
use support::profiles::{bell, bell_fields, trap, trap_fields};
use support::{Family, Implementation, Ours, Random, Real};

/// The fields of a planned struct. The family's own come first.
pub type Fields<R> = [R; MOST_PLANNED];

/// Something that plans for the least time.
pub trait Planner<R> {
    /// The planned struct; `None` if the planner refuses.
    fn plan(&self, family: Family, arguments: &[R; 7]) -> Option<Fields<R>>;
}

/// The planner under test.
pub struct Fastest;

impl<R: Real> Planner<R> for Fastest {
    fn plan(&self, family: Family, arguments: &[R; 7]) -> Option<Fields<R>> {
        let &[x, y, z, p0, p1, v0, v1] = arguments;
        let boundary = Boundary { p0, p1, v0, v1 };
        match family {
            Family::Bell => Bell::fastest(x, y, z, boundary)
                .map(|bell| bell_fields(&bell))
                .ok(),
            _ => Trap::fastest(x, y, z, boundary)
                .map(|trap| {
                    let mut fields = [R::of(0.0); MOST_PLANNED];
                    fields[..12].copy_from_slice(&trap_fields(&trap));
                    fields
                })
                .ok(),
        }
    }
}

/// What `check` finds in these fields.
pub fn findings<R: Real>(
    family: Family,
    fields: &Fields<R>,
    arguments: &[R; 7],
) -> Option<Findings> {
    let &[x, y, z, ..] = arguments;
    match family {
        Family::Bell => bell(fields).check(x, y, z).ok(),
        _ => trap(&fields[..12]).check(x, y, z).ok(),
    }
}

/// A duration that is not the least.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Duration {
    /// The least one, up to this relative error.
    Least(f64),
    /// This factor longer.
    Longer(f64),
    /// This factor shorter.
    Shorter(f64),
}

/// How far a duration may be off, besides what a few roundings of the displacement explain.
fn tolerance<R: Real>() -> f64 {
    if size_of::<R>() == 8 { 1e-9 } else { 1e-5 }
}

/// 64 roundings of 1.
fn doubt<R: Real>() -> f64 {
    64.0 * R::MACHINE_EPSILON.widen()
}

/// A problem with what the referee knows of it.
pub struct Trial<R> {
    problem: Problem<R>,
    motion: Motion,
    best: Best,
}

impl<R: Original> Trial<R> {
    /// Asks the referee.
    pub fn new(problem: Problem<R>) -> Self {
        let motion = Motion::of(problem.family, &problem.arguments);
        let best = motion.best(0.0);
        Self {
            problem,
            motion,
            best,
        }
    }

    /// A problem of any arguments. `None` if a planner may refuse it, or if its numbers are so large or small that a power of time
    /// may overflow.
    pub fn of_any(family: Family, arguments: &[R; 7]) -> Option<Self> {
        let (_, most) = R::EXPONENTS;
        let most = f64::from(most / 8).exp2();
        let is_limit = |index: usize| index < 3;
        let fits = arguments.iter().enumerate().all(|(index, x)| {
            let x = x.widen().abs();
            x <= most && x >= 1.0 / most || x == 0.0 && !is_limit(index)
        });
        let [_, y, z, ..] = arguments.map(R::widen);
        let opposite = family == Family::Bell || (y > 0.0) != (z > 0.0);
        (fits && opposite).then(|| {
            Self::new(Problem {
                kind: Kind::TinyAgainstLarge,
                family,
                arguments: *arguments,
            })
        })
    }

    /// 64 roundings of the positions that the axis passes.
    fn position_doubt(&self) -> f64 {
        let [p0, p1, ..] = self.motion.ends;
        doubt::<R>() * (p0.abs() + p1.abs() + self.best.speed * self.best.duration)
    }

    /// 64 roundings of the velocities that the axis passes.
    fn velocity_doubt(&self) -> f64 {
        let [jerk, rise, fall, _] = self.motion.limits;
        let duration = self.best.duration;
        let acceleration = rise.max(fall).min(jerk * duration);
        doubt::<R>() * (self.best.speed + acceleration * duration)
    }

    /// Compares a duration with the referee's, and if they differ, with the referee's for targets a few roundings away.
    pub fn duration(&self, duration: f64) -> Duration {
        let tolerance = tolerance::<R>();
        let least = self.best.duration;
        let error = if duration == least {
            0.0
        } else {
            (duration / least - 1.0).abs()
        };
        if error <= tolerance {
            return Duration::Least(error);
        }
        let doubt = self.position_doubt();
        let nearby = [-doubt, doubt].map(|beside| self.motion.best(beside).duration);
        // The direct ramp leads to a target this near, and the duration may jump beside it.
        let direct = if self.best.beside_direct.abs() <= doubt {
            self.best.direct_duration
        } else {
            least
        };
        let lowest = nearby[0].min(nearby[1]).min(direct);
        let highest = nearby[0].max(nearby[1]);
        if duration > highest * (1.0 + tolerance) {
            Duration::Longer(duration / highest)
        } else if duration < lowest * (1.0 - tolerance) {
            Duration::Shorter(lowest / duration)
        } else {
            Duration::Least(0.0)
        }
    }

    /// Whether the axis turns and comes again, though the direct ramp ends within 4 roundings of the target.
    pub fn is_detour(&self, duration: f64) -> bool {
        let [p0, p1, v0, v1] = self.motion.ends;
        let [_, _, _, vm] = self.motion.limits;
        let direct = self.best.direct_duration;
        let speed = v0.abs().max(v1.abs()).min(vm);
        let few = doubt::<R>() / 16.0 * (p0.abs() + p1.abs() + speed * direct);
        self.best.beside_direct.abs() <= few && duration > 1.1 * direct
    }

    /// What is wrong with the motion that the plan describes, if something is.
    pub fn wrong_motion(&self, fields: &Fields<R>, random: &mut Random) -> Option<String> {
        let Problem {
            family, arguments, ..
        } = self.problem;
        match findings(family, fields, &arguments) {
            Some(found) if found.bits() | 16 == 16 => {}
            Some(found) => return Some(format!("check finds {}", found.bits())),
            None => return Some("a field is not finite".into()),
        }
        let own = &fields[..family.fields().len()];
        let &[_, _, _, _, p1, _, v1] = &arguments;
        let [_, _, _, vm] = self.motion.limits;
        let v1 = R::of(v1.widen().clamp(-vm, vm));
        let borders = family.borders(&arguments, own);
        let end = borders[borders.len() - 1];
        let [p, v, ..] = Ours.evaluate(family, own, end);
        if p != p1 {
            return Some("the end is not p1".into());
        }
        if v != v1 {
            return Some("the final velocity is not v1".into());
        }
        let within = [R::of(random.unit()) * end, R::of(random.unit()) * end];
        let near = borders.iter().map(|x| x.neighbour(random.steps(2)));
        let times: Vec<R> = near.chain(within).collect();
        let mut wrong = times
            .into_iter()
            .filter_map(|x| self.wrong_state(fields, x));
        wrong.next().map(str::to_owned)
    }

    /// What is wrong with the state at the time `x`, if something is.
    fn wrong_state(&self, fields: &Fields<R>, x: R) -> Option<&'static str> {
        let family = self.problem.family;
        let own = &fields[..family.fields().len()];
        let quantities = family.quantities().len();
        let state = Ours.evaluate(family, own, x);
        let original = R::ORIGINAL.evaluate(family, own, x);
        let pairs = state.iter().zip(original).take(quantities);
        if !pairs.into_iter().all(|(ours, theirs)| ours.same(theirs)) {
            return Some("the original evaluates the struct to other bits");
        }
        let [position, velocity, acceleration] = referee::state(family, fields, x);
        let [jerk, rise, fall, vm] = self.motion.limits;
        let doubt = doubt::<R>();
        if (state[0].widen() - position).abs() > self.position_doubt() {
            return Some("a position is not where the jerk leads");
        }
        if (state[1].widen() - velocity).abs() > self.velocity_doubt() {
            return Some("a velocity is not where the jerk leads");
        }
        if velocity.abs() > vm + self.velocity_doubt() {
            return Some("a velocity is above its limit");
        }
        if acceleration > rise * (1.0 + doubt) || acceleration < -fall * (1.0 + doubt) {
            return Some("an acceleration is above its limit");
        }
        if family == Family::Bell && state[3].widen().abs() > jerk * (1.0 + doubt) {
            return Some("a jerk is above its limit");
        }
        None
    }

    /// Whether the mirrored move, the move with its accelerations in the other order, and the move in other units take other times.
    fn wrong_relative(
        &self,
        planner: &impl Planner<R>,
        duration: R,
        random: &mut Random,
    ) -> Option<&'static str> {
        let Problem {
            family, arguments, ..
        } = self.problem;
        let [x, y, z, p0, p1, v0, v1] = arguments;
        let takes = |arguments| planner.plan(family, &arguments).map(|fields| fields[0]);
        if takes([x, -y, -z, -p0, -p1, -v0, -v1]) != Some(duration) {
            return Some("the mirrored move takes another time");
        }
        if family == Family::Trap && takes([x, z, y, p0, p1, v0, v1]) != Some(duration) {
            return Some("the order of the accelerations changes the time");
        }
        let [length, time] = [(); 2].map(|()| f64::from(random.steps(3)).exp2());
        let powers: [(f64, i32); 3] = match family {
            Family::Bell => [(length, 3), (length, 2), (length, 1)],
            _ => [(length, 1), (length, 2), (length, 2)],
        };
        let [x, y, z] = [0, 1, 2].map(|k| {
            let (length, power) = powers[k];
            R::of(arguments[k].widen() * length / time.powi(power))
        });
        let [p0, p1] = [p0, p1].map(|p| R::of(p.widen() * length));
        let [v0, v1] = [v0, v1].map(|v| R::of(v.widen() * length / time));
        let scaled = R::of(duration.widen() * time);
        (takes([x, y, z, p0, p1, v0, v1]) != Some(scaled)).then_some("the units change the time")
    }
}

/// What the original makes of the same problems.
#[derive(Clone, Debug, Default)]
pub struct Theirs {
    refused: u64,
    breaks: u64,
    longer: u64,
}

/// Counts of what was found in problems of one kind and family.
#[derive(Clone, Debug, Default)]
pub struct Tally {
    /// Problems.
    pub moves: u64,
    /// Plans that are missing.
    pub refused: u64,
    /// Motions that are wrong.
    pub wrong: u64,
    /// Durations that are longer than the least one.
    pub longer: u64,
    /// Durations that are too short to be possible.
    pub shorter: u64,
    /// Moves that turn and come again, though the direct ramp ends within 4 roundings of the target.
    pub detours: u64,
    /// The worst relative error of a duration.
    pub worst: f64,
    original: Theirs,
    /// The first bad problems in words.
    pub examples: Vec<String>,
}

impl Tally {
    /// Problems that are not solved well.
    pub fn bad(&self) -> u64 {
        self.refused + self.wrong + self.longer + self.shorter
    }

    fn add(&mut self, other: Self) {
        self.moves += other.moves;
        self.refused += other.refused;
        self.wrong += other.wrong;
        self.longer += other.longer;
        self.shorter += other.shorter;
        self.detours += other.detours;
        self.worst = self.worst.max(other.worst);
        self.original.refused += other.original.refused;
        self.original.breaks += other.original.breaks;
        self.original.longer += other.original.longer;
        self.examples.extend(other.examples);
        self.examples.truncate(5);
    }

    fn judge<R: Original>(
        &mut self,
        planner: &impl Planner<R>,
        trial: &Trial<R>,
        random: &mut Random,
    ) {
        let Problem {
            family, arguments, ..
        } = trial.problem;
        self.moves += 1;
        let Some(fields) = planner.plan(family, &arguments) else {
            self.refused += 1;
            self.note(trial, "refused");
            return;
        };
        let wrong = trial.wrong_motion(&fields, random);
        let mut relative = || trial.wrong_relative(planner, fields[0], random);
        if let Some(what) = wrong.or_else(|| relative().map(str::to_owned)) {
            self.wrong += 1;
            self.note(trial, &what);
        }
        let duration = fields[0].widen();
        self.detours += u64::from(trial.is_detour(duration));
        match trial.duration(duration) {
            Duration::Least(error) => self.worst = self.worst.max(error),
            Duration::Longer(factor) => {
                self.longer += 1;
                self.worst = self.worst.max(factor - 1.0);
                self.note(trial, &format!("{factor} times as long as possible"));
            }
            Duration::Shorter(factor) => {
                self.shorter += 1;
                self.worst = self.worst.max(factor - 1.0);
                self.note(trial, &format!("{factor} times as fast as possible"));
            }
        }
    }

    fn note<R: Real>(&mut self, trial: &Trial<R>, what: &str) {
        if self.examples.len() < 5 {
            let Problem {
                kind,
                family,
                arguments,
            } = &trial.problem;
            let names = family.arguments().iter().zip(arguments);
            let arguments: Vec<String> = names
                .map(|(name, value)| format!("{name}={value:e}"))
                .collect();
            let (name, arguments) = (family.name(), arguments.join(" "));
            self.examples.push(format!(
                "{name} {} {kind:?} {arguments}: {what}; the best time is {:e}",
                R::NAME,
                trial.best.duration
            ));
        }
    }

    /// Plans the problem with the original. An infinite acceleration is left out, because the original may never return.
    fn judge_original<R: Original>(&mut self, trial: &Trial<R>) {
        let Problem {
            family, arguments, ..
        } = trial.problem;
        let [_, y, .., v1] = arguments;
        if trial.best.duration == 0.0 || y.widen().is_infinite() {
            return;
        }
        let mut fields = [R::of(0.0); MOST_PLANNED];
        let own = &mut fields[..family.fields().len()];
        let duration = R::ORIGINAL.plan(family, &arguments, own).widen();
        // A NaN is no plan either.
        let planned = duration > 0.0;
        if !planned {
            self.original.refused += 1;
            return;
        }
        let v1_planned = match family {
            Family::Bell => fields[9],
            _ => fields[4],
        };
        let [_, _, _, vm] = trial.motion.limits;
        let replaced = v1_planned.widen() != v1.widen().clamp(-vm, vm);
        let found = findings(family, &fields, &arguments).map_or(8, |found| found.bits());
        if replaced || found & !16 != 0 {
            self.original.breaks += 1;
        } else if matches!(trial.duration(duration), Duration::Longer(_)) {
            self.original.longer += 1;
        }
    }
}

/// What was found, by family and kind.
#[derive(Clone, Debug, Default)]
pub struct Tallies {
    of: [[Tally; Kind::ALL.len()]; 2],
}

/// Problems that a seed stands for in long runs: half of them bells, half of them trapezoids.
pub const PROBLEMS_PER_SEED: usize = 1_000_000;

impl Tallies {
    /// Judges the planner by so many problems of a seed.
    pub fn of_seed<R: Original>(planner: &impl Planner<R>, seed: u64, problems: usize) -> Self {
        let mut tallies = Self::default();
        let mut random = Random::seeded(!seed);
        for problem in Problems::<R>::new(seed).take(problems) {
            let tally =
                &mut tallies.of[usize::from(problem.family == Family::Trap)][problem.kind as usize];
            let trial = Trial::new(problem);
            tally.judge(planner, &trial, &mut random);
            tally.judge_original(&trial);
        }
        tallies
    }

    /// Adds what was found in other problems.
    pub fn add(&mut self, other: Self) {
        let mine = self.of.iter_mut().flatten();
        for (tally, other) in mine.zip(other.of.into_iter().flatten()) {
            tally.add(other);
        }
    }

    /// The sum over all families and kinds.
    pub fn total(&self) -> Tally {
        let mut total = Tally::default();
        for tally in self.of.iter().flatten() {
            total.add(tally.clone());
        }
        total
    }
}

impl Display for Tallies {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        for (name, tallies) in ["bell", "trap"].into_iter().zip(&self.of) {
            writeln!(
                f,
                "{name:<22} {:>10} {:>8} {:>6} {:>7} {:>8} {:>8} {:>9} | the original: {:>8} {:>9} {:>9}",
                "moves",
                "refused",
                "wrong",
                "longer",
                "shorter",
                "detours",
                "worst",
                "refused",
                "breaks",
                "longer"
            )?;
            for (kind, tally) in Kind::ALL.iter().zip(tallies) {
                let original = &tally.original;
                writeln!(
                    f,
                    "{:<22} {:>10} {:>8} {:>6} {:>7} {:>8} {:>8} {:>9.1e} | {:>22} {:>9} {:>9}",
                    format!("{kind:?}"),
                    tally.moves,
                    tally.refused,
                    tally.wrong,
                    tally.longer,
                    tally.shorter,
                    tally.detours,
                    tally.worst,
                    original.refused,
                    original.breaks,
                    original.longer
                )?;
            }
        }
        for example in self.of.iter().flatten().flat_map(|tally| &tally.examples) {
            writeln!(f, "{example}")?;
        }
        Ok(())
    }
}
