//! Does a move that is planned between two positions stay between them, is it the fastest one that does, and is it refused only where none does?

use oracle::judge::inside::{Viable, approach, backwards, brake, launch, span, stop};
use oracle::judge::{Plan, Problem, Problems, Request, Scale, doubt};
use oracle::liba::Original;
use support::online::{allowed, largest, state_of, tried};
use support::prelude::*;

const PROBLEMS: usize = 60_000;

fn near(random: &mut Random, spans: &[[f64; 2]; 3]) -> f64 {
    let span = random.pick(spans);
    let width = (span[1] - span[0]).abs() + 1e-3 * span[0].abs();
    random.pick(&span) + random.between(-1.0, 1.0) * width * random.magnitude(-3.0, 0.0)
}

/// A bound between the turns of the hardest brake and of the fastest stop, and the target at rest near it; or the same for the hardest approach to
/// the target, and the start. Answers the bounds.
fn bind<R: Original>(random: &mut Random, problem: &mut Problem<R>) -> Option<[f64; 2]> {
    let Problem { limits, from, to, .. } = *problem;
    let is_start = random.one_in(2);
    let (hard, easy) = if is_start {
        (brake(&limits, from), stop(&limits, from)?)
    } else {
        (approach(&limits, to), launch(&limits, to)?)
    };
    let side = random.below(2);
    let (span, inwards) = (easy[side] - hard[side], [1.0, -1.0][side]);
    let bound = hard[side] + random.unit() * span;
    let rest = State::at(R::of(bound + inwards * span.abs() * random.magnitude(-2.0, 1.5)));
    let far = bound + inwards * (easy[1] - easy[0] + 10.0 * span.abs()) * random.magnitude(1.0, 2.0);
    *(if is_start { &mut problem.to } else { &mut problem.from }) = rest;
    (span != 0.0 && bound.is_finite() && far.is_finite()).then_some(if side == 0 { [bound, far] } else { [far, bound] })
}

/// A faster motion by way of a state near the planned motion, or at a bound, if there is one: its duration and this state.
fn faster_by_way_of<R: Original>(
    random: &mut Random, limits: &Limits<R>, planned: &Move<R>, to: State<R>, bounds: [R; 2], slack: f64,
    stays: impl Fn(&Move<R>, State<R>) -> bool,
) -> Option<(R, State<R>)> {
    let from = planned.state_at(R::ZERO);
    let mut eased = Move::default(); // between bounds that are farther apart by a rounding error, which may be worth much
    eased.within(limits, from, to, bounds[0] - R::of(slack), bounds[1] + R::of(slack)).expect("a plan");
    (0..20).find_map(|_| {
        let State { position, velocity, acceleration } = planned.state_at(planned.t * R::of(random.unit()));
        let by = random.magnitude(-5.0, -1.0);
        let mut near = |x: R| x * R::of(1.0 + by * random.between(-1.0, 1.0));
        let acceleration = near(acceleration);
        let near = State { position: near(position), velocity: near(velocity), acceleration };
        let turn = State { position: random.pick(&bounds), velocity: R::ZERO, acceleration };
        let via = random.pick(&[near, turn]);
        let [mut one, mut other] = [Move::default(); 2];
        let found = one.plan(limits, from, via).and(other.plan(limits, via, to)).ok()?;
        if found.contains(Findings::STARTS_OUTSIDE) {
            return None; // the limits of this way are wider
        }
        let t = one.t + other.t;
        // At a turn the root of a rounding of the position is time.
        let [_, _, steepest] = largest(planned.extremes());
        let rounding = 4.0 * (slack / steepest).sqrt() + 16.0 * R::MACHINE_EPSILON.widen() * planned.t.widen();
        let is_faster = t.widen() < planned.t.widen().min(eased.t.widen()) - rounding;
        (is_faster && stays(&one, from) && stays(&other, via)).then_some((t, via))
    })
}

/// Whether an axis cannot stop between the bounds: it turns where its fastest stop would leave them, and then its hardest brake leaves them.
fn cannot_stop<R: Original>(limits: &Limits<R>, mut from: State<R>, [lowest, highest]: [R; 2], slack: f64) -> bool {
    let [low, high] = [lowest.widen() + slack, highest.widen() - slack];
    for _ in 0..8 {
        let [least, most] = brake(limits, from);
        if least.is_nan() || most.is_nan() || least < low || most > high {
            return true;
        }
        let Some(of_stop) = stop(limits, from) else { return false };
        let far = R::of(10.0 * (of_stop[1] - of_stop[0] + high - low));
        let (bound, bounds, inwards) = if of_stop[1] > high {
            (highest, [-R::INFINITY, highest], -far)
        } else if of_stop[0] < low {
            (lowest, [lowest, R::INFINITY], far)
        } else {
            return false;
        };
        let mut turning = Move::default();
        let answer = turning.within(limits, from, State::at(bound + inwards), bounds[0], bounds[1]);
        let Some(turn) = answer.ok().and(turning.time_at(bound)) else { return true };
        from = turning.state_at(turn);
    }
    true
}

fn moves_stay_inside<R: Original>() {
    let mut random = Random::seeded(11);
    let (mut inside, mut turned, mut refused) = (0, 0, 0);
    for mut problem in Problems::<R>::new(11).take(PROBLEMS) {
        let mut binding = None;
        if problem.request == Request::Plan && random.one_in(2) {
            binding = bind(&mut random, &mut problem);
        }
        let Problem { limits, from, to, .. } = problem;
        let (Ok((fastest, findings)), Request::Plan) = (tried(&limits, from, to), problem.request) else { continue };
        let of_plan = span(from, &fastest);
        let (of_stop, of_launch) = stop(&limits, from).zip(launch(&limits, to)).expect("a stop and a launch");
        let spans = [of_plan, of_stop, of_launch];
        let [one, other] = binding.unwrap_or_else(|| [(); 2].map(|()| near(&mut random, &spans))).map(R::of);
        let (lowest, highest) = if one < other { (one, other) } else { (other, one) };
        if lowest == highest {
            continue;
        }
        let untouched = Move { t: R::of(-1.0), ..Move::default() };
        let mut planned = untouched;
        let result = planned.within(&limits, from, to, lowest, highest);
        let slack = 4.0 * doubt::<R>() * Scale::of(&problem, &Plan::of_move(fastest, findings)).position;
        let [low, high] = [lowest, highest].map(R::widen);
        let leaves = |[least, most]: [f64; 2], by: f64| least < low - by || most > high + by;
        match result {
            Ok(found) if planned != fastest => {
                assert!(leaves(of_plan, -slack), "{low} {high} {of_plan:?} {problem}");
                let longer = Scale::of(&problem, &Plan::of_move(planned, found)).position;
                let reached = span(from, &planned);
                assert!(!leaves(reached, slack + 4.0 * doubt::<R>() * longer), "{low} {high} {reached:?} {problem}");
                let checked = planned.check(&limits).expect("numbers");
                assert!(allowed(found).contains(checked), "{checked:?} {low} {high} {problem}");
                let [start, end] = [R::ZERO, planned.t].map(|x| planned.state_at(x));
                assert_eq!((start, end), (from, to), "{problem}");
                let stays = |axis: &Move<R>, from| !leaves(span(from, axis), 0.0);
                let faster = faster_by_way_of(&mut random, &limits, &planned, to, [lowest, highest], slack, stays);
                assert!(faster.is_none(), "{:?} {faster:?} {low} {high} {problem}", planned.t);
                turned += 1;
            }
            Ok(_) => {
                assert_eq!((result, planned), (Ok(findings), fastest), "{problem}");
                assert!(!leaves(of_plan, slack), "{low} {high} {of_plan:?} {problem}");
                inside += 1;
            }
            Err(error) => {
                assert_eq!((error, planned), (Error::Position, untouched), "{problem}");
                assert!(leaves(of_plan, -slack), "{low} {high} {of_plan:?} {problem}");
                let is_reason = leaves(of_stop, -slack) || leaves(of_launch, -slack);
                assert!(is_reason, "{low} {high} {spans:?} {problem}");
                let start = cannot_stop(&limits, from, [lowest, highest], slack);
                let (limits, before) = backwards(&limits, to);
                let end = cannot_stop(&limits, before, [-highest, -lowest], slack);
                let is_reason = start || end || findings.contains(Findings::STARTS_OUTSIDE);
                assert!(is_reason, "{low} {high} {problem}");
                refused += 1;
            }
        }
    }
    let is_enough = inside > PROBLEMS / 10 && turned > PROBLEMS / 50 && refused > PROBLEMS / 10;
    assert!(is_enough, "{inside} stay inside, {turned} turn at a bound, {refused} are refused");
}

/// Limits with which an axis between 0 and 1 may turn at both of them before it stops.
fn tight(random: &mut Random) -> Limits<f64> {
    let jmax = random.magnitude(0.0, 0.6);
    let jmin = if random.one_in(2) { -jmax } else { -random.magnitude(0.0, 0.6) };
    let mut acceleration = |jerk: f64| (1.5 * jerk * jerk).cbrt() * random.between(0.6, 1.3);
    let (amax, amin) = (acceleration(jmax), -acceleration(jmin));
    let mut velocity = || 0.5 * amax.max(-amin).powi(2) / jmax.min(-jmin) * random.between(0.7, 1.3);
    Limits { vmax: velocity(), vmin: -velocity(), amax, amin, jmax, jmin }
}

/// Dynamic programming knows nothing of turns, stops and bounds.
#[test]
fn refused_moves_leave_in_every_motion() {
    let mut random = Random::seeded(28);
    let (mut planned, mut refused) = (0, 0);
    for _ in 0..30 {
        let limits = tight(&mut random);
        let [start, end] = [limits, backwards(&limits, State::at(0.0)).0].map(Viable::new);
        for _ in 0..5_000 {
            let Limits { vmax, vmin, amax, amin, .. } = limits;
            let mut state = || state_of::<f64>([random.unit(), random.between(vmin, vmax), random.between(amin, amax)]);
            let (from, to) = (state(), state());
            let to = if random.one_in(2) { to } else { State::at(to.position) };
            let before_end = backwards(&limits, State { position: to.position - 1.0, ..to }).1;
            let answer = Move::default().within(&limits, from, to, 0.0, 1.0);
            let stays = start.is_surely(from) && end.is_surely(before_end);
            assert!(answer != Err(Error::Position) || !stays, "{limits:?} {from:?} {to:?}");
            *(if answer.is_ok() { &mut planned } else { &mut refused }) += 1;
        }
    }
    assert!(planned > 10_000 && refused > 10_000, "{planned} {refused}");
}

/// An axis that leaves a bound with the acceleration `a` cannot be saved if the other bound is nearer than `2 a³/3 j²`, where `j` is the jerk that
/// brakes it. With the least more, it turns at both bounds, each time with a lower acceleration.
fn axes_turn_at_both_bounds<R: Original>() {
    let mut random = Random::seeded(29);
    let finest = (4096.0 * R::MACHINE_EPSILON.widen()).log10();
    for _ in 0..20_000 {
        let [jerk, a, more] = [(); 3].map(|()| random.magnitude(-1.0, 1.0));
        let amax = if random.one_in(2) { a } else { 1e3 };
        let other = if random.one_in(2) { jerk } else { jerk * (1.0 + more) };
        let [jerk, other, a, amax, vmax] = [jerk, other, a, amax, 1e4].map(R::of);
        let limits = Limits { vmax, vmin: -vmax, amax, amin: -amax, jmax: jerk, jmin: -other };
        let least = 2.0 * a.widen().powi(3) / (3.0 * jerk.widen().powi(2));
        let from = State { position: R::ZERO, velocity: R::ZERO, acceleration: -a };
        for (sign, is_possible) in [(1.0, true), (-1.0, false)] {
            let bound = R::of(-least * (1.0 + sign * random.magnitude(finest, -0.01)));
            let to = State::at(bound * R::of(random.unit()));
            let mut axis = Move::default();
            let answer = axis.within(&limits, from, to, bound, from.position);
            let what = format!("{answer:?} {limits:?} {from:?} {to:?} {bound:?}");
            assert_eq!(answer.is_ok(), is_possible, "{what}");
            // With time the axis stops between the bounds, waits and goes.
            let velocity = R::of(0.1 * a.widen().powi(2) / other.widen());
            let to = State { position: bound * R::of(0.5), velocity, ..to };
            let (bounds, duration) = ([&[bound][..], &[from.position]], R::of(100.0) * a / jerk);
            let answer = synchronise_within(&mut [axis], &[limits], &[from], &[to], bounds, duration, R::ZERO);
            assert_eq!(answer.is_ok(), is_possible, "{what}");
        }
    }
}

test_both_reals!(moves_stay_inside, axes_turn_at_both_bounds);
