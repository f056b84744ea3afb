//! Are requests refused for which there is no move or no path, of one axis or of several, each with its reason, and is nothing written then?

use atraj::axes::{line, path_size, plan_path, synchronise, synchronise_within};
use atraj::machine::Clock;
use atraj::online::{Error, Limits, Move, State};
use atraj::{Bell, Boundary, Extremes, Findings, Poly3, Trap};
use oracle::judge::axes::problems::{Set, Sets};
use oracle::judge::problem::{Problem, Request, beyond_legal, widened};
use oracle::judge::problems::{Kind, Problems};
use support::{Random, Real};

const PROBLEMS: usize = 20_000;

/// A target a little more than legal.
fn illegal<R: Real>(problem: &Problem<R>, random: &mut Random) -> Option<State<R>> {
    let [vmax, vmin, amax, amin, jmax, jmin] = widened(&problem.limits);
    let a = random.between(amin.max(-1e6), amax.min(1e6));
    let more = 1.0 + random.magnitude(-4.0, 1.0);
    let (v, a) = match random.below(4) {
        0 => (vmax * more, 0.0),
        1 => (vmin * more, 0.0),
        2 => (0.0, random.pick(&[amax, amin]) * more),
        // The acceleration cannot have been built up.
        _ if a > 0.0 => ((vmin + 0.5 * a * a / jmax) * more, a),
        _ => ((vmax + 0.5 * a * a / jmin) * more, a),
    };
    let to = State {
        position: problem.to.position,
        velocity: R::of(v),
        acceleration: R::of(a),
    };
    let rounding = 64.0 * R::MACHINE_EPSILON.widen() * (v.abs() + vmax.min(-vmin));
    let sure = beyond_legal(&problem.limits, to) > rounding;
    (sure && v.is_finite() && a.is_finite()).then_some(to)
}

fn illegal_targets<R: Real>() {
    let mut random = Random::seeded(3);
    let mut refused = 0;
    for problem in Problems::<R>::new(3).take(PROBLEMS) {
        let Some(to) = illegal(&problem, &mut random) else {
            continue;
        };
        let problem = Problem { to, ..problem };
        let Problem { limits, from, .. } = problem;
        let mut planned = Move::default();
        let plan = planned.plan(&limits, from, to);
        assert_eq!(plan.err(), Some(Error::Target), "{problem}");
        let reach = planned.reach(&limits, from, to.velocity, to.acceleration);
        assert_eq!(reach.err(), Some(Error::Target), "{problem}");
        assert_eq!(planned, Move::default());
        refused += 1;
    }
    assert!(refused * 4 > PROBLEMS);
}

#[test]
fn illegal_targets_are_refused() {
    illegal_targets::<f64>();
    illegal_targets::<f32>();
}

/// Numbers of a good problem, with one of them replaced.
fn with_number(index: usize, number: f64) -> Problem<f64> {
    let mut numbers = [
        1.0, -1.0, 2.0, -2.0, 3.0, -3.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0,
    ];
    numbers[index] = number;
    Problem::of(Kind::Rest, Request::Plan, numbers)
}

/// The errors of each planner that takes the whole problem.
fn errors(problem: &Problem<f64>) -> [Option<Error>; 2] {
    #[rustfmt::skip]
    let &Problem { ref limits, from, to, .. } = problem;
    let mut planned = Move::default();
    let errors = [
        planned.plan(limits, from, to),
        planned.meet(limits, from, to),
    ];
    let errors = errors.map(Result::err);
    assert!(errors[0].is_none() || planned == Move::default());
    errors
}

#[test]
fn bad_limits_are_refused() {
    assert_eq!(errors(&with_number(0, 1.0)), [None; 2]);
    for (index, limit) in with_number(0, 1.0).numbers()[..6].iter().enumerate() {
        let errors = |number| errors(&with_number(index, number));
        assert_eq!(errors(0.0), [Some(Error::Limits); 2]);
        assert_eq!(errors(-limit), [Some(Error::Limits); 2]);
        assert_eq!(errors(f64::NAN), [Some(Error::NotFinite); 2]);
        assert_eq!(errors(limit * f64::INFINITY), [None; 2]);
    }
    let free = Limits::symmetric(f64::INFINITY, f64::INFINITY, 1.0);
    let plan = Move::default().plan(&free, State::at(0.0), State::at(1.0));
    assert_eq!(plan.err(), Some(Error::Limits));
}

#[test]
fn profiles_with_a_limit_of_0_are_refused() {
    let boundary = Boundary::rest_to_rest(0.0, 1.0);
    for index in 0..3 {
        let [mut bell, mut trap] = [[30.0, 10.0, 5.0], [5.0, 4.0, -2.0]];
        (bell[index], trap[index]) = (0.0, 0.0);
        let [jerk, acceleration, velocity] = bell;
        let bell = Bell::fastest(jerk, acceleration, velocity, boundary);
        let [velocity, acceleration, deceleration] = trap;
        let trap = Trap::fastest(velocity, acceleration, deceleration, boundary);
        assert_eq!(
            (bell.err(), trap.err()),
            (Some(Error::Limits), Some(Error::Limits)),
            "{index}"
        );
    }
}

fn beside_plans<R: Real>() {
    let mut random = Random::seeded(5);
    for problem in Problems::<R>::new(5).take(PROBLEMS / 10) {
        let Problem {
            limits, from, to, ..
        } = problem;
        let p = to.position;
        let before = Move {
            t: R::of(-1.0),
            ..Move::default()
        };
        let mut planned = before;
        let infinite = R::of(f64::INFINITY);
        let none = R::of(f64::NAN);
        let is_planned = Move::default().plan(&limits, from, to).is_ok();
        for (lowest, highest, error) in [
            (p, p, Error::Limits),
            (infinite, -infinite, Error::Limits),
            (none, p, Error::NotFinite),
            (p, none, Error::NotFinite),
            // The target is outside.
            (p + R::of(1.0 + p.widen().abs()), infinite, Error::Position),
            (-infinite, p - R::of(1.0 + p.widen().abs()), Error::Position),
        ] {
            let within = planned.within(&limits, from, to, lowest, highest).err();
            assert!(within == Some(error) || !is_planned, "{within:?} {problem}");
        }
        let horizon = R::of(random.pick(&[0.0, -1.0, f64::NAN, f64::INFINITY]));
        let track = planned.track(&limits, from, to, horizon);
        assert_eq!(track.err(), Some(Error::Duration), "{problem}");
        assert_eq!(planned, before);
    }
}

#[test]
fn bad_positions_and_horizons_are_refused() {
    beside_plans::<f64>();
    beside_plans::<f32>();
}

#[test]
fn states_that_are_not_finite_are_refused() {
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for index in 6..12 {
            let problem = with_number(index, bad);
            assert_eq!(errors(&problem), [Some(Error::NotFinite); 2]);
            let stop = Move::default().stop(&problem.limits, problem.from);
            let expected = (index < 9).then_some(Error::NotFinite);
            assert_eq!(stop.err(), expected);
        }
    }
}

type Plan<R> =
    fn(&mut [Move<R>], &[Limits<R>], &[State<R>], &[State<R>], R, R) -> Result<Findings, Error>;

/// The planner returns this error and writes nothing.
fn refuses<R: Real>(plan: Plan<R>, set: &Set<R>, error: Error) {
    let (limits, from, to) = set.columns();
    let written = Move {
        t: R::of(1.0),
        ..Move::default()
    };
    let mut axes = vec![written; from.len()];
    let returned = plan(&mut axes, &limits, &from, &to, set.duration, set.cycle);
    assert_eq!(returned.err(), Some(error), "{}", set.show());
    assert!(axes.iter().all(|axis| *axis == written), "{}", set.show());
}

fn bad_numbers<R: Real>() {
    let mut random = Random::seeded(1);
    for set in Sets::<R>::on_lines(1).take(1_000) {
        let k = random.below(set.axes.len());
        let [nan, infinity, below] = [f64::NAN, f64::INFINITY, -1.0].map(R::of);
        for plan in [synchronise::<R> as Plan<R>, line::<R>] {
            let refuses = |change: &dyn Fn(&mut Set<R>), error| {
                let mut changed = set.clone();
                change(&mut changed);
                refuses(plan, &changed, error);
            };
            for bad in [nan, infinity, below] {
                refuses(&|set| set.duration = bad, Error::Duration);
                refuses(&|set| set.cycle = bad, Error::Duration);
            }
            refuses(&|set| set.axes[k].from.position = nan, Error::NotFinite);
            refuses(&|set| set.axes[k].to.velocity = infinity, Error::NotFinite);
            refuses(&|set| set.axes[k].limits.amax = R::of(0.0), Error::Limits);
            let vmax = set.axes[k].limits.vmax;
            if vmax.widen().is_finite() {
                refuses(&|set| set.axes[k].to.velocity = vmax + vmax, Error::Target);
            }
            refuses(&|set| set.axes.clear(), Error::Axes);
        }
    }
}

fn lengths<R: Real>() {
    let limits = [Limits::symmetric(R::ONE, R::ONE, R::ONE); 3];
    let states = [State::at(R::ZERO); 3];
    for plan in [synchronise::<R> as Plan<R>, line::<R>] {
        for [a, l, f, t] in [
            [2, 3, 3, 3],
            [3, 2, 3, 3],
            [3, 3, 2, 3],
            [3, 3, 3, 2],
            [0, 0, 0, 0],
        ] {
            let mut axes = vec![Move::default(); a];
            let (from, to) = (&states[..f], &states[..t]);
            let returned = plan(&mut axes, &limits[..l], from, to, R::ZERO, R::ZERO);
            assert_eq!(returned.err(), Some(Error::Axes));
        }
    }
    for [lowest, highest] in [[2, 3], [3, 2], [4, 3], [3, 4]] {
        let positions = [&[R::ZERO; 4][..lowest], &[R::ONE; 4][..highest]];
        let mut axes = [Move::default(); 3];
        let returned = synchronise_within(
            &mut axes,
            &limits,
            &states,
            &states,
            positions,
            R::ZERO,
            R::ZERO,
        );
        assert_eq!(returned.err(), Some(Error::Axes));
    }
    // A path without an axis, and one with more than there may be.
    for axes in [0, 4097] {
        let limits = vec![limits[0]; axes];
        let mut path = vec![states[0]; 2 * axes];
        let returned = plan_path(&mut path, &mut [R::ONE], &limits, 0, &mut []);
        assert_eq!(returned.err(), Some(Error::Axes));
    }
}

#[test]
fn bad_axes_are_refused() {
    bad_numbers::<f64>();
    bad_numbers::<f32>();
    lengths::<f64>();
    lengths::<f32>();
}

/// A start that is beside the line by far more than the roundings of its motion.
fn beside_the_line<R: Real>() {
    let mut random = Random::seeded(2);
    let mut refused = 0;
    for mut set in Sets::<R>::on_lines(2).take(4_000) {
        let k = random.below(set.axes.len());
        let moves = |axis: usize| set.axes[axis].from.position != set.axes[axis].to.position;
        let has_other = (0..set.axes.len()).any(|axis| axis != k && moves(axis));
        let (limits, from, to) = set.columns();
        let mut axes = vec![Move::default(); from.len()];
        // The fastest motion has the largest numbers.
        let any = R::of(0.0);
        let planned = line(&mut axes, &limits, &from, &to, any, any);
        if !has_other || planned.is_err() {
            continue;
        }
        let Extremes { lowest, highest } = axes[k].extremes();
        let most = |low: R, high: R| f64::max(-low.widen(), high.widen());
        // A motion may have passed the largest numbers within its limits, and has their roundings. Without a limit, none of these sets gets
        // beyond 1e3 roundings of 1e3.
        let within = |reached: f64, limit: f64| {
            if limit.is_finite() {
                reached.max(limit)
            } else {
                reached.max(1e3)
            }
        };
        let own = &limits[k];
        let velocity = within(
            most(lowest.velocity, highest.velocity),
            most(own.vmin, own.vmax),
        );
        let acceleration = within(
            most(lowest.acceleration, highest.acceleration),
            most(own.amin, own.amax),
        );
        // A short way between far positions has a rounded direction, and so has a long way there and back.
        let ways = from
            .iter()
            .zip(&to)
            .map(|(from, to)| (to.position - from.position).widen().abs());
        let longest = ways.fold(0.0, f64::max);
        let mut roundings = 1e4;
        for (axis, (from, to)) in axes.iter().zip(from.iter().zip(&to)) {
            let [p0, p1] = [from, to].map(|end| end.position.widen());
            let Extremes { lowest, highest } = axis.extremes();
            let largest = most(lowest.position, highest.position);
            let way = if p0 == p1 { longest } else { (p1 - p0).abs() };
            roundings += 256.0 * largest / way;
        }
        // A way that is lost in these roundings tells no direction. Then the velocity alone does, and any velocity is right.
        if roundings * R::MACHINE_EPSILON.widen() > 1e-2 {
            continue;
        }
        let far = |most: f64| {
            R::of(if most == 0.0 {
                1.0
            } else {
                roundings * R::MACHINE_EPSILON.widen() * most
            })
        };
        let from = &mut set.axes[k].from;
        if random.one_in(2) {
            from.velocity = from.velocity + far(velocity);
        } else {
            from.acceleration = from.acceleration + far(acceleration);
        }
        refuses(line, &set, Error::Line);
        refused += 1;
    }
    assert!(refused > 1_000);
}

#[test]
fn axes_beside_the_line_are_refused() {
    beside_the_line::<f64>();
    beside_the_line::<f32>();
}

/// A part of the largest exponent.
fn huge<R: Real>(part: f64) -> R {
    R::of(f64::exp2(part * f64::from(R::EXPONENTS.1)))
}

fn beyond_the_range<R: Real>() {
    let still = State::at(R::ZERO);
    let moving = |velocity| State { velocity, ..still };
    let to = [State::at(R::ONE); 2];
    let plan = |limits, from: &[State<R>], duration| {
        let count = from.len();
        let mut axes = [Move::default(); 2];
        let limits = &[limits; 2][..count];
        let plan = synchronise(
            &mut axes[..count],
            limits,
            from,
            &to[..count],
            duration,
            R::ZERO,
        );
        (plan.err(), axes)
    };
    let refused = (Some(Error::NotFinite), [Move::default(); 2]);
    // The second axis is beyond the range of the real type, the first is not.
    let limits = Limits::symmetric(R::ONE, R::ONE, R::ONE);
    assert_eq!(plan(limits, &[still, moving(huge(0.7))], R::ZERO), refused);
    // What an axis without limits could do in a long time is beyond the range. What it does is not, because it cruises.
    let limits = Limits::symmetric(R::ONE, R::INFINITY, R::INFINITY);
    let long = huge(0.95);
    for from in [moving(huge(0.1)), still] {
        let (error, [axis, _]) = plan(limits, &[from], long);
        assert_eq!(error, None);
        assert!(axis.t == long && axis.state_at(long) == to[0] && axis.phases().len() <= 8);
    }
}

#[test]
fn axes_beyond_the_range_are_refused() {
    beyond_the_range::<f64>();
    beyond_the_range::<f32>();
}

/// What a path of one axis returns whose way is over before its last section, or not. On an error nothing is written.
fn path_to<R: Real>(
    positions: &[f64],
    end: [f64; 2],
    limits: &[Limits<R>],
) -> Result<Findings, Error> {
    let mut states: Vec<_> = positions.iter().map(|&p| State::at(R::of(p))).collect();
    let last = states.len() - 1;
    [states[last].velocity, states[last].acceleration] = end.map(R::of);
    let before = states.clone();
    let mut durations = vec![R::of(-1.0); last];
    let mut work = vec![R::ZERO; path_size(1, last).expect("sections")];
    let planned = plan_path(&mut states, &mut durations, limits, 0, &mut work);
    if planned.is_err() {
        assert!(states == before && durations.iter().all(|t| *t == R::of(-1.0)));
    }
    planned
}

/// The end lasts while nothing moves any more, so it is within the limits of the section before too, and the axis can stay.
fn repeated_ends<R: Real>() {
    let limits = Limits::symmetric(R::ONE, R::ONE, R::ONE);
    let slow = Limits {
        vmax: R::of(0.5),
        ..limits
    };
    let leaving = [0.9, 0.9];
    assert_eq!(
        path_to(&[0.0, 1.0], leaving, &[limits]),
        Ok(Findings::ENDS_LEAVING)
    );
    assert_eq!(
        path_to(&[0.0, 1.0, 1.0], leaving, &[limits]),
        Err(Error::Target)
    );
    let fast = [0.8, 0.0];
    assert_eq!(
        path_to(&[0.0, 1.0, 2.0], fast, &[slow, limits]),
        Ok(Findings::default())
    );
    assert_eq!(
        path_to(&[0.0, 1.0, 1.0], fast, &[slow, limits]),
        Err(Error::Target)
    );
}

/// A way beyond the range of the real type is refused, and positions that are far away are not.
fn far_paths<R: Real>() {
    let limits = Limits::symmetric(R::ONE, R::ONE, R::ONE);
    let far = if size_of::<R>() == 4 { 3e38 } else { 1.5e308 };
    let rest = [0.0; 2];
    let beyond = path_to(&[-far, far, 0.0], rest, &[limits]);
    assert_eq!(beyond, Err(Error::NotFinite));
    let there = path_to(&[far; 3], rest, &[limits]);
    assert_eq!(there, Ok(Findings::default()));
}

#[test]
fn paths_that_cannot_be_are_refused() {
    repeated_ends::<f64>();
    repeated_ends::<f32>();
    far_paths::<f64>();
    far_paths::<f32>();
}

/// A way beyond the range of the real type, and what else is no profile.
fn bad_profiles<R: Real>() {
    let [zero, one, infinity, nan] = [0.0, 1.0, f64::INFINITY, f64::NAN].map(R::of);
    let far = R::of(if size_of::<R>() == 4 { 3e38 } else { 1.5e308 });
    let boundary = Boundary::rest_to_rest(-far, far);
    let bell = Bell::fastest(one, one, one, boundary);
    assert_eq!(bell.err(), Some(Error::NotFinite));
    let trap = Trap::fastest(one, one, -one, boundary);
    assert_eq!(trap.err(), Some(Error::NotFinite));
    let slow = R::of(f64::exp2(-10.0));
    for acceleration in [one, infinity] {
        let boundary = Boundary::rest_to_rest(zero, far);
        let bell = Bell::fastest(one, acceleration, slow, boundary);
        assert_eq!(bell.err(), Some(Error::NotFinite));
    }
    // The duration is below the smallest number. liba has plans that take no time, and this library refuses them.
    let least = Boundary::rest_to_rest(zero, zero.neighbour(1));
    let (high, higher) = (R::of(f64::exp2(10.0)), R::of(f64::exp2(30.0)));
    let bell = Bell::fastest(higher, high, one, least);
    assert_eq!(bell.err(), Some(Error::NotFinite));
    let here = Boundary::rest_to_rest(one, one);
    for (fast, acceleration) in [(one, one), (huge(0.95), zero.neighbour(1))] {
        let nothing = Bell::new(fast, acceleration, fast, here);
        assert_eq!(nothing.err(), Some(Error::Unreachable));
    }
    let poly = |duration| Poly3::new(duration, boundary).err();
    assert_eq!(poly(one), Some(Error::NotFinite));
    assert_eq!(poly(zero), Some(Error::Duration));
    assert_eq!(poly(nan), Some(Error::Duration));
    let near = Boundary::rest_to_rest(zero, one);
    for [jerk, acceleration, velocity] in [[zero, one, one], [one, zero, one], [one, one, zero]] {
        let bell = Bell::fastest(jerk, acceleration, velocity, near);
        assert_eq!(bell.err(), Some(Error::Limits));
    }
    for (rise, fall) in [(infinity, -one), (one, -infinity)] {
        let trap = Trap::fastest(one, rise, fall, near);
        assert_eq!(trap.err(), Some(Error::Limits));
    }
}

#[test]
fn profiles_beyond_the_range_are_refused() {
    bad_profiles::<f64>();
    bad_profiles::<f32>();
}

/// A clock of moves that stand, or whose jerk has no limit.
fn bad_clocks<R: Real>() {
    let [zero, one, infinity] = [0.0, 1.0, f64::INFINITY].map(R::of);
    let limits = Limits::symmetric(one, one, one);
    let mut clock = Clock::new();
    let mut refused = |moves: &[Move<R>], limits: &[Limits<R>], error| {
        assert_eq!(clock.rate(moves, limits, zero, zero), Err(error));
        assert_eq!(clock, Clock::new());
    };
    let mut planned = Move::default();
    refused(&[planned], &[limits], Error::Limits);
    planned
        .plan(&limits, State::at(zero), State::at(one))
        .expect("a plan");
    let free = Limits::symmetric(infinity, one, one);
    refused(&[planned], &[free], Error::Limits);
    refused(&[], &[limits], Error::Axes);
    refused(&[planned], &[], Error::Axes);
    refused(&[planned], &[limits, limits], Error::Axes);
    let state = clock.state(&[], 1, zero);
    assert!(state.iter().all(|x| x.widen().is_nan()));
}

#[test]
fn clocks_without_a_motion_are_refused() {
    bad_clocks::<f64>();
    bad_clocks::<f32>();
}
