//! Random problems for moves from any state to any state, and what every move must be.

use crate::random::Random;
use crate::real::Real;
use atraj::State;
use atraj::online::{Limits, Move, Phase};

pub fn limits_of<R>([vmax, vmin, amax, amin, jmax, jmin]: [R; 6]) -> Limits<R> {
    Limits { vmax, vmin, amax, amin, jmax, jmin }
}

pub fn state_of<R: Real>(numbers: [f64; 3]) -> State<R> {
    let [position, velocity, acceleration] = numbers.map(R::of);
    State { position, velocity, acceleration }
}

pub fn numbers_of_state<R: Real>(state: State<R>) -> [f64; 3] {
    [state.position, state.velocity, state.acceleration].map(R::widen)
}

pub fn numbers_of_phase<R: Copy>(phase: &Phase<R>) -> [R; 6] {
    [phase.start, phase.duration, phase.position, phase.velocity, phase.acceleration, phase.jerk]
}

/// `[vmax, vmin, amax, amin, jmax, jmin]`
pub fn numbers_of<R: Copy>(limits: &Limits<R>) -> [R; 6] {
    [limits.vmax, limits.vmin, limits.amax, limits.amin, limits.jmax, limits.jmin]
}

pub fn limits_times<R: Real>(limits: &[Limits<R>], by: f64) -> Vec<Limits<R>> {
    let times = |limit: R| R::of(limit.widen() * by);
    limits.iter().map(|limits| limits_of(numbers_of(limits).map(times))).collect()
}

/// Limits over two decades, one problem in four with the same ones in both directions.
pub fn limits<R: Real>(random: &mut Random) -> Limits<R> {
    let mut pair = || [(); 2].map(|()| R::of(random.magnitude(-1.0, 1.0)));
    let [[vmax, v], [amax, a], [jmax, j]] = [pair(), pair(), pair()];
    if random.one_in(4) {
        return Limits::symmetric(jmax, amax, vmax);
    }
    limits_of([vmax, -v, amax, -a, jmax, -j])
}

/// The limits without one of them or without two. A jerk or both accelerations stay finite.
pub fn fewer_limits<R: Real>(random: &mut Random, limits: Limits<R>) -> Limits<R> {
    let mut fewer = limits;
    let none = R::of(f64::INFINITY);
    match random.below(6) {
        0 => (fewer.vmax, fewer.vmin) = (none, -none),
        1 => fewer.vmax = none,
        2 => (fewer.amax, fewer.amin) = (none, -none),
        3 => fewer.amin = -none,
        4 => (fewer.jmax, fewer.jmin) = (none, -none),
        _ => fewer.jmax = none,
    }
    fewer
}

/// A state in which an axis can be without having left the limits before, and without exceeding them unavoidably.
pub fn inside<R: Real>(random: &mut Random, limits: &Limits<R>) -> State<R> {
    let [vmax, vmin, amax, amin, jmax, jmin] = finite(limits);
    let position = random.sign() * random.magnitude(-2.0, 1.5);
    let a = random.pick(&[0.0, 0.0, 0.5, 1.0]) * random.between(amin, amax);
    let (above, below) = (0.51 * a * a / -jmin, 0.51 * a * a / jmax);
    let (a, above, below) = if vmin + below < vmax - above { (a, above, below) } else { (0.0, 0.0, 0.0) };
    let v = random.pick(&[0.0, 1.0, 1.0]) * random.between(vmin, vmax);
    let v = v.clamp(vmin + below, vmax - above);
    State { position: R::of(position), velocity: R::of(v), acceleration: R::of(a) }
}

/// Any state, one in four outside the limits.
pub fn anywhere<R: Real>(random: &mut Random, limits: &Limits<R>) -> State<R> {
    let state = inside(random, limits);
    if !random.one_in(4) {
        return state;
    }
    let [vmax, vmin, amax, amin, ..] = finite(limits);
    let [v, a] = [(vmin, vmax), (amin, amax)].map(|(low, high)| R::of(2.0 * random.between(low, high)));
    State { velocity: v, acceleration: a, ..state }
}

/// The highest speed of a move in either direction.
pub fn fastest<R: Real>(planned: &Move<R>) -> f64 {
    let reached = planned.extremes();
    f64::max(reached.highest.velocity.widen(), -reached.lowest.velocity.widen())
}

pub fn planned<R: Real>(random: &mut Random) -> (Limits<R>, State<R>, Move<R>) {
    let limits = limits(random);
    let limits = if random.one_in(4) { fewer_limits(random, limits) } else { limits };
    let (from, to) = (anywhere(random, &limits), inside(random, &limits));
    let mut planned = Move::default();
    let half = R::of(0.5);
    let part = State { velocity: half * to.velocity, acceleration: R::of(0.0), ..to };
    let result = match random.below(5) {
        0 => planned.reach(&limits, from, to.velocity, to.acceleration),
        1 => planned.meet(&limits, from, part),
        _ => planned.plan(&limits, from, to),
    };
    if let Err(error) = result {
        panic!("{error:?}: {limits:?} {from:?} {to:?}");
    }
    (limits, from, planned)
}

/// The limits, 10 in place of an infinite one.
fn finite<R: Real>(limits: &Limits<R>) -> [f64; 6] {
    numbers_of(limits).map(|limit| match limit.widen() {
        f64::INFINITY => 10.0,
        f64::NEG_INFINITY => -10.0,
        limit => limit,
    })
}
