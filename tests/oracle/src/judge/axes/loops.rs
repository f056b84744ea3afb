//! Loops that plan at every tick of a control loop, until they arrive.
//!
//! Limits over a decade, unequal ones in one set of four; 1 to 6 axes; ticks from 125 µs to 4 ms; positions up to 10 from 0, some of the
//! targets at 0; most targets are passed in motion.

use std::fmt::{Display, Formatter, Result as Written};
use support::online::{limits_of, numbers_of_state, plan};
use support::prelude::*;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Way {
    Alone,    // one axis, without a cycle
    Meeting,  // one axis that meets a target that moves steadily
    Changing, // one axis that changes its velocity and acceleration
    Together, // axes that arrive together
    Straight, // axes on a line
    Inside,   // axes that arrive together, each between two positions
}

/// Which targets are at 0, where positions have the finest roundings.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AtZero {
    None,
    Passed,      // at a steady velocity
    Accelerated, // with an acceleration
    AtRest,
}

#[derive(Clone, Copy, Debug)]
pub struct Family {
    pub way: Way,         // how they plan
    pub on_ticks: bool,   // whether they arrive on ticks
    pub is_general: bool, // whether limits may differ in both directions
    pub at_zero: AtZero,
}

impl Family {
    pub fn all() -> Vec<Self> {
        use Way::*;
        let ways = [(Alone, false), (Together, true), (Together, false), (Straight, true), (Straight, false)];
        let family = |(way, on_ticks), (is_general, at_zero)| Self { way, on_ticks, is_general, at_zero };
        let kinds = [
            (false, AtZero::None),
            (true, AtZero::None),
            (false, AtZero::Passed),
            (true, AtZero::Passed),
            (true, AtZero::Accelerated),
            (true, AtZero::AtRest),
        ];
        let single =
            [Meeting, Changing].into_iter().flat_map(|way| [kinds[0], kinds[1]].map(|kind| family((way, false), kind)));
        let inside = [(Inside, true), (Inside, false)];
        let inside = inside.into_iter().flat_map(|way| [kinds[0], kinds[1]].map(|kind| family(way, kind)));
        ways.into_iter().flat_map(|way| kinds.map(|kind| family(way, kind))).chain(single).chain(inside).collect()
    }

    fn is_single(&self) -> bool {
        matches!(self.way, Way::Alone | Way::Meeting | Way::Changing)
    }

    /// Whether several axes come to rest at 0. Then a loop follows its last plan in the last two ticks: a known limit.
    pub fn is_limited(&self) -> bool {
        matches!(self.at_zero, AtZero::AtRest) && !self.is_single()
    }
}

#[derive(Clone, Debug)]
pub struct Set<R> {
    pub limits: Vec<Limits<R>>, // their limits
    pub from: Vec<State<R>>,    // where they are
    pub to: Vec<State<R>>,      // where they go
    pub positions: [Vec<R>; 2], // the lowest ones and the highest ones
    pub tick: f64,              // the period of the loop, s
}

const SPARE: f64 = 2.0; // how many ticks later than the first plan said a loop may arrive
/// A loop goes on with its last plan when less than these ticks are left. A state has the rounding errors of the tick before it. For a plan
/// that lasts a small part of a tick, they are too large.
const LAST: f64 = 1.125;
const LAST_AT_ZERO: f64 = 2.0;
/// By how many times what the jerk changes in a tick an acceleration may change from tick to tick. An arrival on a tick is half a tick away at most.
const MOST_STEP: f64 = 1.5;
const MOST_TICKS: f64 = 1500.0; // The longest first plan, in ticks. A longer loop comes no nearer to its end.

impl Family {
    pub fn plan<R: Real>(&self, set: &Set<R>, axes: &mut [Move<R>]) -> Result<Findings, Error> {
        let Set { limits, from, to, positions: [lowest, highest], tick } = set;
        let (zero, cycle) = (R::of(0.0), R::of(if self.on_ticks { *tick } else { 0.0 }));
        match self.way {
            Way::Alone => axes[0].plan(&limits[0], from[0], to[0]),
            Way::Meeting => axes[0].meet(&limits[0], from[0], to[0]),
            Way::Changing => axes[0].reach(&limits[0], from[0], to[0].velocity, to[0].acceleration),
            Way::Together => synchronise(axes, limits, from, to, zero, cycle),
            Way::Straight => line(axes, limits, from, to, zero, cycle),
            Way::Inside => synchronise_within(axes, limits, from, to, [lowest, highest], zero, cycle),
        }
    }

    pub fn set<R: Real>(&self, random: &mut Random) -> (Set<R>, Vec<Move<R>>) {
        loop {
            let set: Set<R> = self.draw(random);
            let mut axes = vec![Move::default(); set.limits.len()];
            let planned = self.plan(&set, &mut axes);
            // An axis that will unavoidably exceed its limits after its end is outside before it arrives.
            let stays = planned.is_ok_and(|found| !found.contains(Findings::ENDS_LEAVING));
            if stays && axes[0].t.widen() <= MOST_TICKS * set.tick {
                return (set, axes);
            }
        }
    }

    fn draw<R: Real>(&self, random: &mut Random) -> Set<R> {
        let count = if self.is_single() { 1 } else { 1 + random.below(6) };
        let tick = random.pick(&[0.125e-3, 0.25e-3, 0.5e-3, 1e-3, 2e-3, 4e-3]);
        let is_unequal = self.is_general && random.one_in(4);
        let offset = random.pick(&[0.0, 1.0, 10.0]);
        let limits: Vec<_> = (0..count).map(|_| limits(random, is_unequal)).collect();
        let shares: Vec<_> = (0..count).map(|_| random.sign() * random.between(0.1, 1.0)).collect();
        let ends: Vec<_> = if self.way == Way::Straight {
            let lead = ends(random, &tightest(&limits, &shares));
            shares.iter().map(|share| lead.map(|end| end.map(|x| share * x))).collect()
        } else {
            limits.iter().map(|limits| ends(random, limits)).collect()
        };
        let mut states = [Vec::new(), Vec::new()];
        for axis in ends {
            let [_, v, a] = axis[1];
            let is_at_zero = match self.at_zero {
                AtZero::None => false,
                AtZero::Passed => v != 0.0 && a == 0.0,
                AtZero::Accelerated => a != 0.0,
                AtZero::AtRest => v == 0.0 && a == 0.0,
            };
            let offset = if is_at_zero { -axis[1][0] } else { offset * random.between(-1.0, 1.0) };
            for (states, [p, v, a]) in states.iter_mut().zip(axis) {
                states.push(State { position: R::of(offset + p), velocity: R::of(v), acceleration: R::of(a) });
            }
        }
        let [from, mut to] = states;
        if self.way == Way::Meeting {
            to[0].acceleration = R::of(0.0);
        }
        let limits: Vec<_> = limits.into_iter().map(|limits| limits_of(limits.map(R::of))).collect();
        let mut positions = [Vec::new(), Vec::new()];
        if self.way == Way::Inside {
            // A little farther than each axis goes alone.
            for ((limits, from), to) in limits.iter().zip(&from).zip(&to) {
                let Extremes { lowest, highest } = plan(limits, *from, *to).extremes();
                let room = R::of(random.pick(&[0.01, 0.1, 1.0]));
                positions[0].push(lowest.position - room);
                positions[1].push(highest.position + room);
            }
        }
        Set { limits, from, to, positions, tick }
    }
}

/// `[vmax, vmin, amax, amin, jmax, jmin]`
fn limits(random: &mut Random, is_unequal: bool) -> [f64; 6] {
    let mut pair = |low: f64, high: f64| {
        let most = low * (high / low).powf(random.unit());
        let least = if is_unequal { most * random.between(0.5, 2.0) } else { most };
        [most, -least]
    };
    let [[vmax, vmin], [amax, amin], [jmax, jmin]] = [pair(0.5, 5.0), pair(1.0, 10.0), pair(5.0, 50.0)];
    [vmax, vmin, amax, amin, jmax, jmin]
}

fn tightest(limits: &[[f64; 6]], shares: &[f64]) -> [f64; 6] {
    std::array::from_fn(|k| {
        let seen = limits.iter().zip(shares).map(|(axis, share)| axis[if *share > 0.0 { k } else { k ^ 1 }] / share);
        seen.fold(if k % 2 == 0 { f64::INFINITY } else { f64::NEG_INFINITY }, |one, other| {
            if one.abs() < other.abs() { one } else { other }
        })
    })
}

fn ends(random: &mut Random, &[vmax, vmin, amax, amin, jmax, jmin]: &[f64; 6]) -> [[f64; 3]; 2] {
    let mut state = || {
        let kind = random.below(3); // a third accelerates, a third moves uniformly, a third is at rest
        let a = if kind == 0 { random.between(amin, amax) } else { 0.0 };
        // What undoing the acceleration adds stays within the limits.
        let (above, below) = (0.51 * a * a / -jmin, 0.51 * a * a / jmax);
        let (a, above, below) = if vmin + below < vmax - above { (a, above, below) } else { (0.0, 0.0, 0.0) };
        let v = if kind < 2 { random.between(vmin + below, vmax - above) } else { 0.0 };
        [random.between(-1.0, 1.0), v, a]
    };
    [state(), state()]
}

#[derive(Clone, Copy, Debug)]
pub enum Outcome {
    InTime,                // it arrived when its first plan said
    Late,                  // it was late by more than two ticks
    Refused(usize, Error), // a tick had no plan
}

pub fn run<R: Real>(family: &Family, set: &mut Set<R>, axes: &mut [Move<R>]) -> Outcome {
    let promised = (axes[0].t.widen() / set.tick).ceil();
    let target = set.to[0];
    let last = if family.is_limited() { LAST_AT_ZERO } else { LAST };
    for tick in 0.. {
        let left = axes[0].t.widen() / set.tick;
        if left <= last {
            return Outcome::InTime;
        }
        if tick as f64 > promised + SPARE {
            return Outcome::Late;
        }
        for ((from, axis), limits) in set.from.iter_mut().zip(&*axes).zip(&set.limits) {
            let next = axis.state_at(R::of(set.tick));
            assert!(!steps(limits, from, &next, set.tick), "{tick} {left}: {family:?} {limits:?} {from:?} {next:?}");
            *from = next;
        }
        if family.way == Way::Meeting {
            let passed = (tick + 1) as f64 * set.tick;
            set.to[0].position = R::of(target.position.widen() + passed * target.velocity.widen());
        }
        if let Err(error) = family.plan(set, axes) {
            return Outcome::Refused(tick, error);
        }
    }
    unreachable!()
}

/// Whether an axis steps from a setpoint to the next: its position, velocity or acceleration changes by more than its derivatives allow.
fn steps<R: Real>(limits: &Limits<R>, from: &State<R>, to: &State<R>, tick: f64) -> bool {
    let [[p0, v0, a0], [p1, v1, a1]] = [*from, *to].map(numbers_of_state);
    let jerk = f64::max(limits.jmax.widen(), -limits.jmin.widen());
    // By the trapezoidal rule. Each plan may step by the roundings of both ends of a tie: 256 of the velocity.
    let step = 256.0 * R::MACHINE_EPSILON.widen();
    let of_positions = p1 - p0 - tick * (v0 + v1) / 2.0;
    let of_velocities = v1 - v0 - tick * (a0 + a1) / 2.0;
    // The velocities at both ends, and what undoing the accelerations adds.
    let speed = 3.0 * f64::max(limits.vmax.widen(), -limits.vmin.widen());
    of_positions.abs() > jerk * tick.powi(3) / 12.0 + step * (p0.abs() + p1.abs() + speed)
        || of_velocities.abs() > MOST_STEP * jerk * tick.powi(2) / 4.0 + step * speed
        || (a1 - a0).abs() > MOST_STEP * jerk * tick
}

#[derive(Debug, Default)]
pub struct Loops {
    pub loops: u64,            // loops
    pub late: u64,             // loops that were late by more than two ticks
    pub refused: u64,          // loops with a tick that has no plan
    pub examples: Vec<String>, // the last state of the first bad loops
}

impl Loops {
    pub fn of_seed<R: Real>(family: &Family, seed: u64, loops: u64) -> Self {
        let mut random = Random::seeded(seed);
        let mut all = Self { loops, ..Self::default() };
        for _ in 0..loops {
            let (first, axes) = family.set::<R>(&mut random);
            let outcome = run(family, &mut first.clone(), &mut axes.clone());
            match outcome {
                Outcome::InTime => continue,
                Outcome::Late => all.late += 1,
                Outcome::Refused(..) => all.refused += 1,
            }
            if all.examples.len() < 5 {
                all.examples.push(format!("{outcome:?} {:?} {first:?}", axes[0].t));
            }
        }
        all
    }
}

impl Display for Loops {
    fn fmt(&self, f: &mut Formatter<'_>) -> Written {
        let Self { loops, late, refused, .. } = self;
        write!(f, "{late} of {loops} loops late, {refused} refused")
    }
}
