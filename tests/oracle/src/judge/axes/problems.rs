//! Random sets of axes, in families. The same seed gives the same sets.

use crate::judge::{Kind, Problem, Problems};
use support::online::{Columns, numbers_of, tried};
use support::prelude::*;

macro_rules! families {
    ($($(#[$doc:meta])* $family:ident: $kinds:expr,)*) => {
        listed! {
            pub enum Family {
                $($(#[$doc])* $family,)*
            }
        }

        impl Family {
            fn kinds(self) -> &'static [Kind] {
                use Kind::*;
                match self {
                    $(Self::$family => &$kinds,)*
                }
            }
        }
    };
}

families! {
    AtRest: [Rest], // at rest at both ends
    Moves: [Moving, Rest, EqualVelocities, OppositeVelocities, FullVelocity], // velocities at both ends
    AcceleratedEnds: [AcceleratedStart, Accelerated, FullAcceleration, Straight, TinyAcceleration],
    AcceleratedTargets: [AcceleratedTarget, Lens, Lens, BorderOfGap, RiseAndFall],
    Limited: [Asymmetric], // the limits depend on the direction
    Outside: [OutsideVelocity, OutsideAcceleration, BoundToLeave, FarOutside, ComingInside],
    Unlimited: [InfiniteVelocity, InfiniteAcceleration, OneInfiniteJerk, InfiniteJerk], // some limits are infinite
    OneAtTarget: [Rest, Moving, Accelerated], // one axis is at its target
    UnderWay: [Remainder, NextCycle], // the rests of planned moves
    Adversarial: [NoDisplacement, DirectTie, BorderOfCruise, BorderOfShape, BorderOfHold, TargetOnTheBoundary, Tiny, Offset, NeverReached,
            WeakLimits, HugeJerk, Lens, Rest, Moving],
}

#[derive(Clone, Debug)]
pub struct Set<R> {
    pub family: Family, // what the axes have in common
    pub axes: Vec<Problem<R>>,
    pub duration: R, // the least duration, s
    pub cycle: R,    // the period of the clock, s; 0: none
}

pub const MOST_AXES: usize = 12;

impl<R: Real> Set<R> {
    pub fn columns(&self) -> Columns<R> {
        self.axes.iter().map(|axis| (axis.limits, axis.from, axis.to)).collect()
    }

    pub fn show(&self) -> String {
        let axes: Vec<_> = self.axes.iter().map(Problem::to_string).collect();
        let axes = axes.join("\n    ");
        let Self { family, duration, cycle, .. } = self;
        format!("{} {family:?} duration {duration:?} cycle {cycle:?}\n    {axes}", R::NAME)
    }
}

pub struct Sets<R> {
    axes: Problems<R>,
    random: Random,
    turn: usize,
    straight: bool,
}

impl<R: Real> Sets<R> {
    pub fn new(seed: u64) -> Self {
        Self { axes: Problems::new(seed), random: Random::seeded(seed ^ 0x5e75), turn: 0, straight: false }
    }

    pub fn on_lines(seed: u64) -> Self {
        Self { straight: true, ..Self::new(seed) }
    }

    fn set(&mut self, family: Family) -> Set<R> {
        let count = 1 + self.random.below(MOST_AXES);
        let axes = if self.straight { self.line(family, count) } else { self.independent(family, count) };
        let plans = axes.iter().filter_map(|axis| tried(&axis.limits, axis.from, axis.to).ok());
        let fastest = plans.map(|(planned, _)| planned.t.widen()).fold(0.0, f64::max);
        let random = &mut self.random;
        let duration = if random.one_in(2) { 0.0 } else { fastest * random.magnitude(-0.5, 1.0) };
        let cycle = if random.one_in(2) {
            0.0
        } else {
            let ticks = random.magnitude(-0.5, 4.0);
            random.pick(&[0.001, fastest / ticks])
        };
        let [duration, cycle] = [duration, cycle].map(R::of);
        Set { family, axes, duration, cycle }
    }

    fn independent(&mut self, family: Family, count: usize) -> Vec<Problem<R>> {
        let mut axes: Vec<_> = (0..count).map(|_| self.axis(family)).collect();
        if family == Family::OneAtTarget {
            let axis = &mut axes[self.random.below(count)];
            axis.from = axis.to;
        }
        axes
    }

    fn axis(&mut self, family: Family) -> Problem<R> {
        self.axes.of_kind(self.random.pick(family.kinds()))
    }

    /// Axes on a straight line, within limits that are as wide as those of the lead, or wider.
    fn line(&mut self, family: Family, count: usize) -> Vec<Problem<R>> {
        let mut lead = self.axis(family);
        if lead.to.position == lead.from.position {
            (lead.from, lead.to) = (State::at(lead.from.position), State::at(lead.from.position));
        }
        let mut axes: Vec<_> = (1..count).map(|_| self.follower(&lead)).collect();
        axes.insert(self.random.below(count), lead);
        if lead.to.position == lead.from.position {
            for axis in &mut axes {
                (axis.from.velocity, axis.from.acceleration) = (R::ZERO, R::ZERO);
                axis.to = axis.from;
            }
        }
        axes
    }

    fn follower(&mut self, lead: &Problem<R>) -> Problem<R> {
        let random = &mut self.random;
        let part = random.pick(&[0.0, 1.0, -1.0, 2.0, 2.0, 2.0, 2.0, 2.0]);
        let part = if part == 2.0 { random.sign() * random.magnitude(-3.0, 0.0) } else { part };
        let way = lead.to.position - lead.from.position;
        let p0 = R::of(if random.one_in(2) { 0.0 } else { random.between(-10.0, 10.0) });
        let mut p1 = p0 + R::of(part) * way;
        if (p1 - p0).widen().abs() > way.widen().abs() {
            p1 = p0;
        }
        let share = if way == R::ZERO { way } else { (p1 - p0) / way };
        let state = |position, lead: State<R>| State {
            position,
            velocity: share * lead.velocity,
            acceleration: share * lead.acceleration,
        };
        let (from, to) = (state(p0, lead.from), state(p1, lead.to));
        Problem { limits: wider(&lead.limits, share.widen(), random), from, to, ..*lead }
    }
}

/// Limits that an axis keeps if it moves `share` times as far as one that keeps these.
fn wider<R: Real>(limits: &Limits<R>, share: f64, random: &mut Random) -> Limits<R> {
    let share = if share == 0.0 { 1.0 } else { share };
    let mut pair = |high: R, low: R| {
        let [one, other] = [high, low].map(|limit| limit.widen() * (1.001 * random.magnitude(0.0, 1.0) * share));
        [one.max(other), one.min(other)].map(R::of)
    };
    let [vmax, vmin, amax, amin, jmax, jmin] = numbers_of(limits);
    let [[vmax, vmin], [amax, amin], [jmax, jmin]] = [pair(vmax, vmin), pair(amax, amin), pair(jmax, jmin)];
    Limits { vmax, vmin, amax, amin, jmax, jmin }
}

impl<R: Real> Iterator for Sets<R> {
    type Item = Set<R>;

    fn next(&mut self) -> Option<Set<R>> {
        let family = Family::ALL[self.turn % Family::ALL.len()];
        self.turn += 1;
        Some(self.set(family))
    }
}
