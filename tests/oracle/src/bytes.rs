//! Cases as strings of bytes, which is what a fuzzer changes.
//!
//! The first byte is the real type: odd for `f32`. The arguments of the family's `gen` follow in little endian, and then a byte and a number for each
//! time. Missing bytes are 0. A problem for the planners of the fastest moves has no times. In a problem for `Move`, the first byte names the planner
//! too, and the numbers are the limits, the start and the target, and two more: the positions between which it stays, or the horizon.

use crate::judge::{Fastest, Planner, Problem, Request, Trial, Verdict};
use crate::liba::{Case, MOMENTS, Moment, Original, Report};
use atraj::axes;
use support::family::{MOST_ARGUMENTS, MOST_FIELDS};
use support::prelude::*;
use support::{Family, Ours};

pub fn compare(family: Family, bytes: &[u8]) {
    match bytes.split_first() {
        Some((real, case)) if real % 2 == 1 => compare_as::<f32>(family, case),
        Some((_, case)) => compare_as::<f64>(family, case),
        None => {}
    }
}

fn compare_as<R: Original>(family: Family, bytes: &[u8]) {
    let mut report = Report::default();
    report.compare(&Ours, &R::ORIGINAL, &decode(family, bytes));
    report.assert_same();
}

/// Functions of all bytes. The first byte is the real type, and the number of a kind above it.
macro_rules! of_bytes {
    ($($(#[$doc:meta])* $name:ident => $of:ident;)*) => {$(
        $(#[$doc])*
        pub fn $name(bytes: &[u8]) {
            match bytes.split_first() {
                Some((kind, case)) if kind % 2 == 1 => $of::<f32>(kind / 2, case),
                Some((kind, case)) => $of::<f64>(kind / 2, case),
                None => {}
            }
        }
    )*};
}

of_bytes! {
    /// Plans the move for the least time as a bell and as a trapezoid. Panics if numbers are refused, or if the motion is wrong.
    plan => plan_as;
    /// Plans a move from any state, and asks for all there is to know of it. Panics if a motion breaks the contract of `Move`, or goes
    /// farther than its velocity can, though its numbers are of ordinary size.
    move_from_any_state => move_as;
    /// Plans several axes together. Panics if an error writes an axis, or if axes arrive at different times or elsewhere.
    several_axes => axes_as;
    /// Ticks an axis between nonsensical plans. Panics if an answer or a setpoint is another than that of moves planned one by one, or if a
    /// move does not begin where the one before it is at the takeover.
    axis_in_a_machine => axis_as;
    /// Plans a move from any state, counts its steps, shapes it. Panics if a step is lost, the shaped motion ends elsewhere, or a refusal leaves a trace.
    steps_and_shapes => machine_as;
    /// Plans a path through waypoints, and improves it. Panics if an error writes anything, or if a promised duration is refused.
    waypoints => path_as;
}

fn plan_as<R: Original>(_: u8, mut bytes: &[u8]) {
    let arguments: [R; 7] = std::array::from_fn(|_| number(&mut bytes));
    let mut random = Random::seeded(0);
    let most = f64::from(R::EXPONENTS.1 / 8).exp2(); // a power of time may overflow beyond this range
    let fits = arguments.iter().enumerate().all(|(index, x)| {
        let (x, is_limit) = (x.widen().abs(), index < 3);
        (1.0 / most..=most).contains(&x) || x == 0.0 && !is_limit
    });
    for request in [Request::Bell, Request::Trap] {
        let problem = Problem::of_arguments(request, arguments);
        let plan = Fastest.plan(&problem); // any bits must not panic
        if !fits || problem.limits.amax <= R::ZERO || problem.limits.amin >= R::ZERO {
            continue;
        }
        let plan = plan.unwrap_or_else(|error| panic!("{problem}: {error:?}"));
        let trial = Trial::new(problem);
        let checked = trial.check_motion(&plan, &mut random);
        assert!(checked.is_ok(), "{problem}: {checked:?}");
        let duration = trial.duration(plan.planned.t.widen());
        assert!(matches!(duration, Verdict::Good { .. }), "{problem}: {duration:?}");
    }
}

pub const PLANNERS: u8 = 6;

fn move_as<R: Real>(planner: u8, mut bytes: &[u8]) {
    let limits: Limits<R> = limits_from(&mut bytes);
    let [from, to] = [(); 2].map(|()| state(&mut bytes));
    let before = Move::default();
    let mut planned = before;
    let [one, other] = [(); 2].map(|()| number::<R>(&mut bytes));
    let planner = planner % PLANNERS;
    let result = match planner {
        0 => planned.plan(&limits, from, to),
        1 => planned.reach(&limits, from, to.velocity, to.acceleration),
        2 => planned.stop(&limits, from),
        3 => planned.meet(&limits, from, to),
        4 => planned.within(&limits, from, to, one, other),
        _ => planned.track(&limits, from, to, other, one),
    };
    let problem = format!("planner {planner} {limits:?} {from:?} {to:?} {one:?} {other:?}");
    if result.is_err() {
        assert!(planned == before, "{problem}: touched, {result:?}");
        return;
    }
    assert!(planned.t >= R::ZERO && planned.t < R::INFINITY, "{problem}: {planned:?}");
    assert_order(&planned, &problem);
    // A move without duration is at its start at 0.
    let end = planned.state_at(R::INFINITY);
    let there = match planner {
        0 | 4 => to,
        1 => State { position: end.position, ..to },
        2 => State::at(end.position),
        3 => State { position: to.position + to.velocity * planned.t, ..to },
        _ => end,
    };
    assert!(end == there, "{problem}: ends at {end:?}");
    // Nothing here may panic.
    let reached = planned.extremes();
    let [_, speed, _] = online::largest(reached);
    let [p0, p1] = [from, end].map(|state| state.position.widen());
    let rounding = 1e3 * R::MACHINE_EPSILON.widen() * (p0.abs() + p1.abs());
    let jumps = (p1 - p0).abs() > 1.01 * speed * planned.t.widen() + rounding;
    let is_ordinary = are_ordinary(&[limits], &[from, to]); // else a power of the time need not be a number
    assert!(!(jumps && is_ordinary), "{problem}: too far for {planned:?}");
    let _ = planned.time_at(reached.highest.position);
    let _ = planned.time_at(to.position);
    let _ = planned.check(&limits);
    let mut positions = [R::ZERO; 16];
    planned.sample_into(R::ZERO, planned.t / R::of(15.0), [&mut positions, &mut [], &mut [], &mut []]);
}

fn assert_order<R: Real>(planned: &Move<R>, problem: &str) {
    let (zero, count) = (R::ZERO, planned.count as usize);
    assert!(count <= 15, "{problem}: {count} phases");
    let phases = &planned.phase[..=count];
    let in_order = phases.windows(2).all(|pair| pair[0].start <= pair[1].start && pair[0].duration >= zero);
    assert!(in_order && phases[0].start == zero && phases[count].start == planned.t, "{problem}: {planned:?}");
}

fn are_ordinary<R: Real>(limits: &[Limits<R>], states: &[State<R>]) -> bool {
    let range = f64::from(R::EXPONENTS.1 / 8).exp2();
    let of_states = states.iter().flat_map(|state| [state.position, state.velocity, state.acceleration]);
    of_states.chain(limits.iter().flat_map(online::numbers_of)).all(|x| {
        let size = x.widen().abs();
        size == 0.0 || size == f64::INFINITY || (range.recip()..range).contains(&size)
    })
}

pub const PLANNERS_OF_AXES: u8 = 3;

/// The kind names the planner and the number of axes. The duration, the cycle, and the limits, start, end and positions of each axis follow.
fn axes_as<R: Real>(kind: u8, mut bytes: &[u8]) {
    let planner = kind % PLANNERS_OF_AXES;
    let count = 1 + usize::from(kind / PLANNERS_OF_AXES % 3);
    let [duration, cycle] = [(); 2].map(|()| number::<R>(&mut bytes));
    let mut limits = Vec::new();
    let mut ends = [Vec::new(), Vec::new()];
    let mut bounds = [Vec::new(), Vec::new()];
    for _ in 0..count {
        limits.push(limits_from(&mut bytes));
        for end in &mut ends {
            end.push(state(&mut bytes));
        }
        for bound in &mut bounds {
            bound.push(number(&mut bytes));
        }
    }
    let ([from, to], [lowest, highest]) = (ends, bounds);
    let before = Move { t: R::of(-1.0), ..Move::default() };
    let mut moves = vec![before; count];
    let result = match planner {
        0 => axes::synchronise(&mut moves, &limits, &from, &to, duration, cycle),
        1 => axes::line(&mut moves, &limits, &from, &to, duration, cycle),
        _ => axes::synchronise_within(&mut moves, &limits, &from, &to, [&lowest, &highest], duration, cycle),
    };
    let problem = format!("planner {planner} {limits:?} {from:?} {to:?} {lowest:?} {highest:?} {duration:?} {cycle:?}");
    if result.is_err() {
        assert!(moves.iter().all(|axis| *axis == before), "{problem}: touched, {result:?}");
        return;
    }
    let t = moves[0].t;
    assert!(t >= R::ZERO && t < R::INFINITY, "{problem}: {t:?}");
    for (axis, (from, to)) in moves.iter().zip(from.iter().zip(&to)) {
        assert!(axis.t.low_bits() == t.low_bits(), "{problem}: {axis:?}");
        assert_order(axis, &problem);
        let end = axis.state_at(R::INFINITY);
        assert!(end == *to, "{problem}: ends at {end:?}");
        let start = axis.state_at(R::of(-1.0));
        assert!(start == *from || t == R::ZERO, "{problem}: starts at {start:?}");
        let _ = axis.time_at(axis.extremes().highest.position); // nothing here may panic
    }
}

pub const REQUESTS: u8 = 6; // how many requests an axis gets: four plans, other limits, and ticks

struct Model<R> {
    period: R,
    in_force: Move<R>,
    age: u16,                     // for how many ticks the move is in force
    next: Option<(Move<R>, u16)>, // the move that waits, and for how many ticks
}

impl<R: Real> Model<R> {
    fn state_after(&self, ticks: u16) -> State<R> {
        self.in_force.state_at(self.period * R::of(f64::from(self.age) + f64::from(ticks)))
    }

    fn tick(&mut self) -> State<R> {
        self.age += 1;
        match &mut self.next {
            Some((next, 1)) => {
                (self.in_force, self.age) = (*next, 0);
                self.next = None;
            }
            Some((_, until)) => *until -= 1,
            None => {}
        }
        self.state_after(0)
    }

    /// Plans from the state in which the move takes over. `plan` also gets the time until then.
    fn plan(
        &mut self, lead: u16, plan: impl FnOnce(&mut Move<R>, State<R>, R) -> Result<Findings, Error>,
    ) -> Result<Findings, Error> {
        if lead == 0 {
            return Err(Error::Late);
        }
        let ticks = self.next.map_or(lead, |(_, until)| lead.min(until));
        let from = self.state_after(ticks);
        let mut planned = Move::default();
        let found = plan(&mut planned, from, self.period * R::of(f64::from(ticks)))?;
        // A move that takes no time is at its end.
        assert!(planned.t == R::ZERO || planned.state_at(R::ZERO) == from, "{planned:?} does not begin at {from:?}");
        self.next = Some((planned, ticks));
        Ok(found)
    }
}

/// Period, start and limits. Then requests: a byte for what and for the lead, or for the number of ticks, and its numbers.
fn axis_as<R: Real>(_: u8, mut bytes: &[u8]) {
    let period = number::<R>(&mut bytes);
    let start = state(&mut bytes);
    let mut limits = limits_from(&mut bytes);
    let Ok(mut axis) = Axis::new(period, start) else { return };
    let (mut planner, mut ticker) = axis.split();
    let mut in_force = Move::default();
    // A plan to where the axis stands takes no time. So does the move of a new axis, which may have any velocity.
    let State { position, velocity, acceleration } = start;
    in_force.phase[1] = Phase { position, velocity, acceleration, ..Phase::default() };
    in_force.count = 1;
    let mut model = Model { period, in_force, age: 0, next: None };
    while !bytes.is_empty() {
        let byte = take(&mut bytes, 1) as u8;
        let (request, lead) = (byte % REQUESTS, u16::from(byte / REQUESTS));
        let to = if request < 4 { state(&mut bytes) } else { State::default() };
        let ahead = u32::from(lead);
        let [answer, expected] = match request {
            0 => [planner.go(&limits, to, ahead), model.plan(lead, |next, from, _| next.plan(&limits, from, to))],
            1 => {
                let (v, a) = (to.velocity, to.acceleration);
                [planner.reach(&limits, v, a, ahead), model.plan(lead, |next, from, _| next.reach(&limits, from, v, a))]
            }
            2 => [planner.stop(&limits, ahead), model.plan(lead, |next, from, _| next.stop(&limits, from))],
            3 => {
                let [jerk, horizon] = [(); 2].map(|()| number::<R>(&mut bytes));
                let State { position, velocity, acceleration } = to;
                [
                    planner.track(&limits, to, jerk, horizon, ahead),
                    model.plan(lead, |next, from, t| {
                        let [half, sixth] = [0.5, 1.0 / 6.0].map(R::of);
                        let p = position + t * (velocity + t * (half * acceleration + t * jerk * sixth));
                        let (v, a) = (velocity + t * (acceleration + half * t * jerk), acceleration + t * jerk);
                        // The plan lasts until a call within `lead` takes over.
                        let leading = period * R::of(f64::from(lead));
                        let least = leading + (leading - t);
                        let is_enough = horizon > least || horizon.is_nan() || horizon <= R::ZERO;
                        let horizon = if is_enough { horizon } else { least };
                        next.track(&limits, from, State { position: p, velocity: v, acceleration: a }, jerk, horizon)
                    }),
                ]
            }
            4 => {
                limits = limits_from(&mut bytes);
                continue;
            }
            _ => {
                for _ in 0..lead {
                    let (now, expected) = (ticker.tick(), model.tick());
                    let is_number = expected.position * R::ZERO == R::ZERO;
                    assert!(now == expected || !is_number, "{now:?} is not {expected:?}");
                }
                continue;
            }
        };
        assert_eq!(answer, expected, "request {request} {to:?} {limits:?}");
    }
}

fn limits_from<R: Real>(bytes: &mut &[u8]) -> Limits<R> {
    online::limits_of([(); 6].map(|()| number(bytes)))
}

fn state<R: Real>(bytes: &mut &[u8]) -> State<R> {
    State { position: number(bytes), velocity: number(bytes), acceleration: number(bytes) }
}

const STEPS: usize = 1_000; // more steps than this are not asked for

/// The kind names the kind of the shaper. Offset and step, frequency, damping and smoothing, and the move follow.
fn machine_as<R: Real>(kind: u8, mut bytes: &[u8]) {
    let [offset, step, frequency, damping, smoothing] = [(); 5].map(|()| number::<R>(&mut bytes));
    let limits = limits_from(&mut bytes);
    let [from, to] = [(); 2].map(|()| state(&mut bytes));
    let Ok((planned, _)) = online::tried(&limits, from, to) else { return };
    let problem = format!("{offset:?} {step:?} {frequency:?} {damping:?} {smoothing:?} {planned:?}");
    if let Ok(mut steps) = Steps::new(&planned, offset, step) {
        let (mut count, mut last) = (steps.count(), R::ZERO);
        let taken = (0..STEPS).map_while(|_| steps.next(&planned).map(|taken| (taken, steps.count())));
        for (Step { time, direction }, now) in taken {
            count += direction;
            assert!(count == now && time >= last && time <= planned.t, "{problem}: {time:?}");
            last = time;
        }
        if steps.next(&planned).is_none() {
            let end = planned.position(R::INFINITY);
            let there = Move { phase: [Phase { position: end, ..Phase::default() }; 16], ..Move::default() };
            assert_eq!(Steps::new(&there, offset, step).map(|steps| steps.count()), Ok(steps.count()), "{problem}");
        }
    }
    let kinds = [ShaperKind::Zv, ShaperKind::Zvd, ShaperKind::Mzv, ShaperKind::Ei, ShaperKind::Ei2];
    let mut shaper = Shaper::smooth(smoothing).unwrap_or_default();
    for kind in [kind, kind / 5].map(|kind| kinds[usize::from(kind) % kinds.len()]) {
        let before = shaper;
        assert!(shaper.add(kind, frequency, damping).is_ok() || shaper == before, "{problem}");
    }
    let mut clock = Clock::new();
    let before = clock;
    let changed = clock.rate(&[planned], &[limits], offset, step);
    assert!(changed.is_ok() || clock == before, "{problem}");
    // There and back are two sections, and two axes of one.
    let before = clock;
    let mut path = [planned, planned];
    let _ = path[1].plan(&limits, to, from);
    for axes in [1, 2] {
        let changed = clock.rate(&path, &[limits; 2][..axes], offset, frequency);
        assert!(changed.is_ok() || clock == before, "{problem}");
        clock = before;
    }
    let _ = [0, 1, 2].map(|axes| clock.state(&path, axes, smoothing)); // nothing here may panic
    let _ = shaper.state(&planned, frequency);
    if to.velocity == R::ZERO && to.acceleration == R::ZERO {
        let end = shaper.state(&planned, R::INFINITY);
        assert!(end == to, "{problem}: ends at {end:?}");
    }
}

/// The kind names the number of axes and of sections. The limits of each axis follow, the start and the end of each axis, and the positions between.
fn path_as<R: Real>(kind: u8, mut bytes: &[u8]) {
    let (axes, sections) = (1 + usize::from(kind % 2), 1 + usize::from(kind / 2 % 4));
    let limits: Vec<_> = (0..axes).map(|_| limits_from(&mut bytes)).collect();
    let mut states = vec![State::default(); axes * (sections + 1)];
    for end in (0..axes).chain(sections * axes..(sections + 1) * axes) {
        states[end] = state(&mut bytes);
    }
    for state in &mut states[axes..sections * axes] {
        *state = State::at(number(&mut bytes));
    }
    let problem = format!("{limits:?} {states:?}");
    let mut durations = vec![R::of(-1.0); sections];
    let mut work = vec![R::NAN; axes::path_size(axes, sections).expect("a size")];
    let before = (states.clone(), durations.clone());
    let planned = axes::plan_path(&mut states, &mut durations, &limits, axes, 0, &mut work);
    if planned.is_err() {
        let untouched = durations == before.1 && format!("{:?}", before.0) == format!("{states:?}");
        assert!(untouched, "{problem}: touched, {planned:?}");
        return;
    }
    let is_ordinary = are_promises_kept(&problem, &states, &durations, &limits);
    let before = durations.iter().fold(R::ZERO, |sum, t| sum + *t);
    let given = (states.clone(), durations.clone());
    let improved = axes::improve_path(&mut states, &mut durations, &limits, axes, 4, &mut work);
    // A path whose powers are beyond the range may be refused as such. Then it stays.
    let stays = !is_ordinary && improved == Err(Error::NotFinite) && (&states, &durations) == (&given.0, &given.1);
    assert!(improved.is_ok() || stays, "{problem}: {improved:?}");
    are_promises_kept(&problem, &states, &durations, &limits);
    let after = durations.iter().fold(R::ZERO, |sum, t| sum + *t);
    let is_longer = after > before && is_ordinary;
    assert!(!is_longer, "{problem}: {after:?} after {before:?}");
}

/// Panics if a section does not take what was promised. Whether no power of a number is beyond the range; else nothing is promised.
fn are_promises_kept<R: Real>(problem: &str, states: &[State<R>], durations: &[R], limits: &[Limits<R>]) -> bool {
    let is_ordinary = are_ordinary(limits, states);
    let mut moves = vec![Move::default(); limits.len()];
    for (section, &duration) in durations.iter().enumerate() {
        assert!(duration >= R::ZERO && duration < R::INFINITY, "{problem}: {duration:?}");
        let [from, to] = [section, section + 1].map(|point| &states[point * limits.len()..][..limits.len()]);
        let taken = axes::synchronise(&mut moves, limits, from, to, duration, R::ZERO);
        let t = moves[0].t.widen();
        let tolerance = if size_of::<R>() == 8 { 1e-6 } else { 1e-3 };
        let is_kept = taken.is_ok() && t <= duration.widen() * (1.0 + tolerance);
        assert!(is_kept || !is_ordinary, "{problem}: section {section} takes {t:e} instead of {duration:?}: {taken:?}");
    }
    is_ordinary
}

fn decode<R: Real>(family: Family, mut bytes: &[u8]) -> Case<R> {
    let mut arguments = [R::ZERO; MOST_ARGUMENTS];
    arguments[..family.arguments().len()].fill_with(|| number(&mut bytes));
    let mut moment = || {
        let kind = take(&mut bytes, 1) as usize;
        let number = number::<R>(&mut bytes);
        match kind % 3 {
            0 => Moment::At(number),
            1 => Moment::Fraction(number),
            _ => Moment::Border { index: kind / 3, steps: kind as i8 / 43 },
        }
    };
    Case { family, arguments, before: [R::ZERO; MOST_FIELDS], planned: true, moments: [(); MOMENTS].map(|()| moment()) }
}

fn number<R: Real>(bytes: &mut &[u8]) -> R {
    R::from_low_bits(take(bytes, size_of::<R>()))
}

fn take(bytes: &mut &[u8], count: usize) -> u64 {
    let (taken, rest) = bytes.split_at(count.min(bytes.len()));
    *bytes = rest;
    taken.iter().rev().fold(0, |number, &byte| number << 8 | u64::from(byte))
}

pub fn encode<R: Real>(arguments: &[R], times: &[R]) -> Vec<u8> {
    let of = |number: &R| number.low_bits().to_le_bytes()[..size_of::<R>()].to_vec();
    let mut bytes = vec![u8::from(size_of::<R>() == 4)];
    bytes.extend(arguments.iter().flat_map(of));
    bytes.extend(times.iter().take(MOMENTS).flat_map(|time| [vec![0], of(time)].concat()));
    bytes
}
