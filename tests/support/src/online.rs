//! Random problems for moves from any state to any state, and what every move must be.

use crate::prelude::*;

pub fn limits_of<R>([vmax, vmin, amax, amin, jmax, jmin]: [R; 6]) -> Limits<R> {
    Limits { vmax, vmin, amax, amin, jmax, jmin }
}

/// Limits that are the same in both directions.
pub fn symmetric<R: Real>(jerk: f64, acceleration: f64, velocity: f64) -> Limits<R> {
    Limits::symmetric(R::of(jerk), R::of(acceleration), R::of(velocity))
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

/// The limits seen in a mirror.
pub fn mirrored_limits<R: Real>(limits: &Limits<R>) -> Limits<R> {
    let [vmax, vmin, amax, amin, jmax, jmin] = numbers_of(limits).map(|limit| -limit);
    limits_of([vmin, vmax, amin, amax, jmin, jmax])
}

pub fn mirrored<R: Real>(state: State<R>) -> State<R> {
    State { position: -state.position, velocity: -state.velocity, acceleration: -state.acceleration }
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
    match random.below(6) {
        0 => (fewer.vmax, fewer.vmin) = (R::INFINITY, -R::INFINITY),
        1 => fewer.vmax = R::INFINITY,
        2 => (fewer.amax, fewer.amin) = (R::INFINITY, -R::INFINITY),
        3 => fewer.amin = -R::INFINITY,
        4 => (fewer.jmax, fewer.jmin) = (R::INFINITY, -R::INFINITY),
        _ => fewer.jmax = R::INFINITY,
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
    State { position: R::of(position), velocity: R::of(v.clamp(vmin + below, vmax - above)), acceleration: R::of(a) }
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

/// A plan and what it finds, if there is one.
pub fn tried<R: Real>(limits: &Limits<R>, from: State<R>, to: State<R>) -> Result<(Move<R>, Findings), Error> {
    let mut planned = Move::default();
    let found = planned.plan(limits, from, to)?;
    Ok((planned, found))
}

#[track_caller]
pub fn plan<R: Real>(limits: &Limits<R>, from: State<R>, to: State<R>) -> Move<R> {
    tried(limits, from, to).unwrap_or_else(|error| panic!("{error:?}: {limits:?} {from:?} {to:?}")).0
}

#[track_caller]
pub fn stop<R: Real>(limits: &Limits<R>, from: State<R>) -> Move<R> {
    let mut planned = Move::default();
    let result = planned.stop(limits, from);
    assert!(result.is_ok(), "{result:?}: {limits:?} {from:?}");
    planned
}

/// Limits, starts and targets of several axes.
pub type Columns<R> = (Vec<Limits<R>>, Vec<State<R>>, Vec<State<R>>);

/// `synchronise` or `line`: moves, limits, starts and targets, the least duration and the cycle.
pub type PlannerOfAxes<R> = fn(&mut [Move<R>], &[Limits<R>], &[State<R>], &[State<R>], R, R) -> Result<Findings, Error>;

/// Axes that arrive together, at the duration or later.
#[track_caller]
pub fn together<R: Real>(limits: &[Limits<R>], from: &[State<R>], to: &[State<R>], duration: R) -> Vec<Move<R>> {
    let mut axes = vec![Move::default(); limits.len()];
    let result = synchronise(&mut axes, limits, from, to, duration, R::ZERO);
    assert!(result.is_ok(), "{result:?}: {limits:?} {from:?} {to:?} {duration:?}");
    axes
}

#[track_caller]
pub fn straight<R: Real>(limits: &[Limits<R>], from: &[State<R>], to: &[State<R>]) -> Vec<Move<R>> {
    let mut axes = vec![Move::default(); limits.len()];
    let result = line(&mut axes, limits, from, to, R::ZERO, R::ZERO);
    assert!(result.is_ok(), "{result:?}: {limits:?} {from:?} {to:?}");
    axes
}

/// Plans a path through the states, point by point. Gives the durations of its sections, and what the plan finds.
#[track_caller]
pub fn path<R: Real>(states: &mut [State<R>], limits: &[Limits<R>], axes: usize, steps: u32) -> (Vec<R>, Findings) {
    let sections = states.len() / axes - 1;
    let mut durations = vec![R::NAN; sections];
    let mut work = vec![R::NAN; path_size(axes, sections).expect("a size")];
    let found = plan_path(states, &mut durations, limits, axes, steps, &mut work).expect("a path");
    (durations, found)
}

/// The motions of a path through these points, section by section.
#[track_caller]
pub fn motions<R: Real>(mut points: Vec<State<R>>, limits: &[Limits<R>], axes: usize, steps: u32) -> Vec<Move<R>> {
    let (durations, _) = path(&mut points, limits, axes, steps);
    let mut moves = vec![Move::default(); axes * durations.len()];
    path_moves(&mut moves, limits, &points, &durations, axes).expect("moves");
    moves
}

/// The halves of a group whose axes stand at these positions. Nobody frees its memory.
pub fn group<'a, R: Real>(period: f64, start: &[R]) -> (GroupPlanner<'a, 'a, R>, GroupTicker<'a, 'a, R>) {
    let states: Vec<_> = start.iter().map(|position| State::at(*position)).collect();
    let moves = vec![Move::default(); 3 * start.len()];
    Box::leak(Box::new(Group::new(R::of(period), states.leak(), moves.leak()).expect("a group"))).split()
}

/// What a check may find in a plan that finds this. A start outside the limits exceeds them, but never their jerks, and makes no step.
pub fn allowed(found: Findings) -> Findings {
    let excess = Findings::EXCEEDS_VELOCITY | Findings::EXCEEDS_ACCELERATION;
    let excess = if found.contains(Findings::STARTS_OUTSIDE) { excess } else { Findings::default() };
    found | excess | Findings::OVERSHOOTS
}

/// The largest position, velocity and acceleration of a motion in either direction.
pub fn largest<R: Real>(Extremes { lowest, highest }: Extremes<R>) -> [f64; 3] {
    let [lowest, highest] = [lowest, highest].map(|state| numbers_of_state(state).map(f64::abs));
    std::array::from_fn(|k| lowest[k].max(highest[k]))
}

/// The highest speed of a move in either direction.
pub fn fastest<R: Real>(planned: &Move<R>) -> f64 {
    largest(planned.extremes())[1]
}

pub fn planned<R: Real>(random: &mut Random) -> (Limits<R>, State<R>, Move<R>) {
    let limits = limits(random);
    let limits = if random.one_in(4) { fewer_limits(random, limits) } else { limits };
    let (from, to) = (anywhere(random, &limits), inside(random, &limits));
    let mut planned = Move::default();
    let part = State { velocity: R::HALF * to.velocity, acceleration: R::ZERO, ..to };
    let result = match random.below(5) {
        0 => planned.reach(&limits, from, to.velocity, to.acceleration),
        1 => planned.meet(&limits, from, part),
        _ => planned.plan(&limits, from, to),
    };
    assert!(result.is_ok(), "{result:?}: {limits:?} {from:?} {to:?}");
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
