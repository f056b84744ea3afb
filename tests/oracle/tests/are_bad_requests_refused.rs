//! Are requests refused for which there is no move or no path, of one axis or of several, each with its reason, and is nothing written then?

use oracle::judge::axes::{Set, Sets};
use oracle::judge::{Kind, Problem, Problems, Request, beyond_legal, widened};
use support::online::PlannerOfAxes as Plan;
use support::prelude::*;

const PROBLEMS: usize = 20_000;

fn illegal<R: Real>(problem: &Problem<R>, random: &mut Random) -> Option<State<R>> {
    let [vmax, vmin, amax, amin, jmax, jmin] = widened(&problem.limits);
    let a = random.between(amin.max(-1e6), amax.min(1e6));
    let more = 1.0 + random.magnitude(-4.0, 1.0);
    let (v, a) = match random.below(4) {
        0 => (vmax * more, 0.0),
        1 => (vmin * more, 0.0),
        2 => (0.0, random.pick(&[amax, amin]) * more),
        _ if a > 0.0 => ((vmin + 0.5 * a * a / jmax) * more, a), // the acceleration cannot have been built up
        _ => ((vmax + 0.5 * a * a / jmin) * more, a),
    };
    let to = State { position: problem.to.position, velocity: R::of(v), acceleration: R::of(a) };
    let rounding = 64.0 * R::MACHINE_EPSILON.widen() * (v.abs() + vmax.min(-vmin));
    (beyond_legal(&problem.limits, to) > rounding && v.is_finite() && a.is_finite()).then_some(to)
}

fn illegal_targets<R: Real>() {
    let mut random = Random::seeded(3);
    let mut refused = 0;
    for problem in Problems::<R>::new(3).take(PROBLEMS) {
        let Some(to) = illegal(&problem, &mut random) else { continue };
        let problem = Problem { to, ..problem };
        let Problem { limits, from, .. } = problem;
        let mut planned = Move::default();
        let answers = [
            planned.plan(&limits, from, to),
            planned.reach(&limits, from, to.velocity, to.acceleration),
            planned.meet(&limits, from, to),
        ];
        assert_eq!((answers, planned), ([Err(Error::Target); 3], Move::default()), "{problem}");
        refused += 1;
    }
    assert!(refused * 4 > PROBLEMS);
}

fn with_number<R: Real>(index: usize, number: f64) -> Problem<R> {
    let mut numbers = [1.0, -1.0, 2.0, -2.0, 3.0, -3.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0];
    numbers[index] = number;
    Problem::of(Kind::Rest, Request::Plan, numbers.map(R::of))
}

/// The errors of each planner that takes the whole problem. The last one follows it as a signal.
fn errors<R: Real>(problem: &Problem<R>) -> [Option<Error>; 3] {
    let &Problem { ref limits, from, to, .. } = problem;
    [0, 1, 2].map(|planner| {
        let mut planned = Move::default();
        let result = match planner {
            0 => planned.plan(limits, from, to),
            1 => planned.meet(limits, from, to),
            _ => planned.track(limits, from, to, R::ONE, R::ONE),
        };
        assert!(result.is_ok() || planned == Move::default(), "{problem}");
        result.err()
    })
}

fn bad_limits_and_states<R: Real>() {
    let good = with_number::<R>(0, 1.0);
    assert_eq!(errors(&good), [None; 3]);
    for (index, limit) in good.numbers()[..6].iter().map(|limit| limit.widen()).enumerate() {
        let errors = |number| errors(&with_number::<R>(index, number));
        assert_eq!(errors(0.0), [Some(Error::Limits); 3]);
        assert_eq!(errors(-limit), [Some(Error::Limits); 3]);
        assert_eq!(errors(f64::NAN), [Some(Error::NotFinite); 3]);
        assert_eq!(errors(limit * f64::INFINITY), [None; 3]);
    }
    // A target that is met has no acceleration, and is slower than the axis can be.
    for (index, number) in [(10, 1.0), (11, 0.5)] {
        assert_eq!(errors(&with_number::<R>(index, number)), [None, Some(Error::Target), None]);
    }
    let free = Limits::symmetric(R::INFINITY, R::INFINITY, R::ONE);
    assert_eq!(Move::default().plan(&free, State::at(R::ZERO), State::at(R::ONE)).err(), Some(Error::Limits));
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for index in 6..12 {
            let problem = with_number::<R>(index, bad);
            assert_eq!(errors(&problem), [Some(Error::NotFinite); 3]);
            let stop = Move::default().stop(&problem.limits, problem.from);
            assert_eq!(stop.err(), (index < 9).then_some(Error::NotFinite));
        }
    }
}

#[test]
fn bad_numbers_of_profiles_are_refused() {
    let (none, endless) = (f64::NAN, f64::INFINITY);
    for (numbers, bad, error) in [
        (0..3, 0.0, Error::Limits),
        (0..7, none, Error::NotFinite),
        (3..5, endless, Error::NotFinite),
        (3..5, -endless, Error::NotFinite),
    ] {
        for index in numbers {
            let with = |[x, y, z]: [f64; 3]| {
                let mut numbers = [x, y, z, 0.0, 1.0, 0.0, 0.0];
                numbers[index] = bad;
                let [x, y, z, p0, p1, v0, v1] = numbers;
                (x, y, z, Boundary { p0, p1, v0, v1 })
            };
            let ((jm, am, vm, of_bell), (v, ac, de, of_trap)) = (with([30.0, 10.0, 5.0]), with([5.0, 4.0, -2.0]));
            let errors = [Bell::fastest(jm, am, vm, of_bell).err(), Trap::fastest(v, ac, de, of_trap).err()];
            assert_eq!(errors, [Some(error); 2], "{index} {bad}");
        }
    }
}

fn beside_plans<R: Real>() {
    for problem in Problems::<R>::new(5).take(PROBLEMS / 10) {
        let Problem { limits, from, to, .. } = problem;
        let p = to.position;
        let before = Move { t: R::of(-1.0), ..Move::default() };
        let mut planned = before;
        let is_planned = Move::default().plan(&limits, from, to).is_ok();
        for (lowest, highest, error) in [
            (p, p, Error::Limits),
            (R::INFINITY, -R::INFINITY, Error::Limits),
            (R::NAN, p, Error::NotFinite),
            (p, R::NAN, Error::NotFinite),
            (p + R::of(1.0 + p.widen().abs()), R::INFINITY, Error::Position), // the target is outside
            (-R::INFINITY, p - R::of(1.0 + p.widen().abs()), Error::Position),
        ] {
            let within = planned.within(&limits, from, to, lowest, highest).err();
            assert!(within == Some(error) || !is_planned, "{within:?} {problem}");
        }
        for bad in [0.0, -0.0, -1.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            let mut track = |jerk, horizon| planned.track(&limits, from, to, R::of(jerk), R::of(horizon)).err();
            assert_eq!(track(0.0, bad), Some(Error::Duration), "{problem}");
            assert!(bad.is_finite() || track(bad, 1.0) == Some(Error::NotFinite), "{problem}");
        }
        assert_eq!(planned, before);
    }
}

fn refuses<R: Real>(plan: Plan<R>, set: &Set<R>, error: Error) {
    let (limits, from, to) = set.columns();
    let written = Move { t: R::ONE, ..Move::default() };
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
            refuses(&|set| set.axes[k].limits.amax = R::ZERO, Error::Limits);
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
        for [a, l, f, t] in [[2, 3, 3, 3], [3, 2, 3, 3], [3, 3, 2, 3], [3, 3, 3, 2], [0, 0, 0, 0]] {
            let mut axes = vec![Move::default(); a];
            let returned = plan(&mut axes, &limits[..l], &states[..f], &states[..t], R::ZERO, R::ZERO);
            assert_eq!(returned, Err(Error::Axes));
        }
    }
    for [lowest, highest] in [[2, 3], [3, 2], [4, 3], [3, 4]] {
        let positions = [&[R::ZERO; 4][..lowest], &[R::ONE; 4][..highest]];
        let mut axes = [Move::default(); 3];
        let returned = synchronise_within(&mut axes, &limits, &states, &states, positions, R::ZERO, R::ZERO);
        assert_eq!(returned.err(), Some(Error::Axes));
    }
    // A path without an axis, one with more than there may be, and lists of other lengths than two axes in three sections have.
    let of_two = [[2, 3, 7, 2], [2, 3, 9, 2], [2, 3, 8, 1], [2, 3, 8, 3], [2, 3, 8, 8], [2, 0, 2, 2]];
    for [axes, sections, s, l] in [[0, 1, 0, 0], [4097, 1, 8194, 4097]].into_iter().chain(of_two) {
        let (limits, mut path) = (vec![limits[0]; l], vec![states[0]; s]);
        let mut work = vec![R::ZERO; path_size(2, 3).expect("a short path")];
        let returned = plan_path(&mut path, &mut vec![R::ONE; sections], &limits, axes, 0, &mut work);
        assert_eq!(returned.err(), Some(Error::Axes));
    }
}

/// A start that is off the line by far more than the roundings of its motion.
fn off_the_line<R: Real>() {
    let mut random = Random::seeded(2);
    let mut refused = 0;
    for mut set in Sets::<R>::on_lines(2).take(4_000) {
        let k = random.below(set.axes.len());
        let moves = |axis: usize| set.axes[axis].from.position != set.axes[axis].to.position;
        let has_other = (0..set.axes.len()).any(|axis| axis != k && moves(axis));
        let (limits, from, to) = set.columns();
        let mut axes = vec![Move::default(); from.len()];
        let any = R::ZERO; // the fastest motion has the largest numbers
        let planned = line(&mut axes, &limits, &from, &to, any, any);
        if !has_other || planned.is_err() {
            continue;
        }
        let [_, reached_velocity, reached_acceleration] = online::largest(axes[k].extremes());
        let most = |low: R, high: R| f64::max(-low.widen(), high.widen());
        // A motion may have passed the largest numbers within its limits, and has their roundings. Without a limit they are below 1e3 roundings of 1e3.
        let within = |reached: f64, limit: f64| {
            if limit.is_finite() { reached.max(limit) } else { reached.max(1e3) }
        };
        let own = &limits[k];
        let velocity = within(reached_velocity, most(own.vmin, own.vmax));
        let acceleration = within(reached_acceleration, most(own.amin, own.amax));
        // A short way between far positions has a rounded direction, and so has a long way there and back.
        let ways = from.iter().zip(&to).map(|(from, to)| (to.position - from.position).widen().abs());
        let longest = ways.fold(0.0, f64::max);
        let mut roundings = 1e4;
        for (axis, (from, to)) in axes.iter().zip(from.iter().zip(&to)) {
            let [p0, p1] = [from, to].map(|end| end.position.widen());
            let [largest, ..] = online::largest(axis.extremes());
            let way = if p0 == p1 { longest } else { (p1 - p0).abs() };
            roundings += 256.0 * largest / way;
        }
        // A way that is lost in these roundings tells no direction. Then the velocity alone does, and any velocity is right.
        if roundings * R::MACHINE_EPSILON.widen() > 1e-2 {
            continue;
        }
        let far = |most: f64| R::of(if most == 0.0 { 1.0 } else { roundings * R::MACHINE_EPSILON.widen() * most });
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

fn huge<R: Real>(part: f64) -> R {
    R::of(f64::exp2(part * f64::from(R::EXPONENTS.1)))
}

/// The way from the one side to the other is beyond the range.
fn far<R: Real>() -> R {
    R::of(if size_of::<R>() == 4 { 3e38 } else { 1.5e308 })
}

fn beyond_the_range<R: Real>() {
    let still = State::at(R::ZERO);
    let moving = |velocity| State { velocity, ..still };
    let to = [State::at(R::ONE); 2];
    let plan = |limits, from: &[State<R>], duration| {
        let count = from.len();
        let mut axes = [Move::default(); 2];
        (synchronise(&mut axes[..count], &[limits; 2][..count], from, &to[..count], duration, R::ZERO).err(), axes)
    };
    let refused = (Some(Error::NotFinite), [Move::default(); 2]);
    // The second axis is beyond the range of the real type, the first is not.
    let limits = Limits::symmetric(R::ONE, R::ONE, R::ONE);
    assert_eq!(plan(limits, &[still, moving(huge(0.7))], R::ZERO), refused);
    let (far, none) = (State::at(far::<R>()), R::ZERO);
    for planner in [synchronise::<R> as Plan<R>, line::<R>] {
        let mut axes = [Move::default(); 2];
        let [from, to] = [[still, State::at(-far.position)], [to[0], far]];
        assert_eq!(planner(&mut axes, &[limits; 2], &from, &to, none, none), Err(Error::NotFinite));
        assert_eq!(axes, refused.1);
    }
    // The first axis takes so long to brake that the way of the second, which stands, is NaN.
    let (weak, from) = (Limits::symmetric(huge(-0.2), huge(-0.2), huge(0.95)), [moving(huge(0.9)), still]);
    let returned = line(&mut [Move::default(); 2], &[weak, limits], &from, &to, none, none);
    assert_eq!(returned, Err(Error::NotFinite));
    // What an axis without limits could do in a long time is beyond the range. What it does is not, because it cruises.
    let limits = Limits::symmetric(R::ONE, R::INFINITY, R::INFINITY);
    let long = huge(0.95);
    for from in [moving(huge(0.1)), still] {
        let (error, [axis, _]) = plan(limits, &[from], long);
        assert_eq!(error, None);
        assert!(axis.t == long && axis.state_at(long) == to[0] && axis.phases().len() <= 8);
    }
}

/// What a path of one axis returns whose way is over before its last section, or not. On an error nothing is written.
fn path_to<R: Real>(positions: &[f64], end: [f64; 2], limits: &[Limits<R>]) -> Result<Findings, Error> {
    let mut states: Vec<_> = positions.iter().map(|&p| State::at(R::of(p))).collect();
    let last = states.len() - 1;
    [states[last].velocity, states[last].acceleration] = end.map(R::of);
    let before = states.clone();
    let mut durations = vec![R::of(-1.0); last];
    let mut work = vec![R::ZERO; path_size(1, last).expect("sections")];
    let planned = plan_path(&mut states, &mut durations, limits, 1, 0, &mut work);
    if planned.is_err() {
        assert!(states == before && durations.iter().all(|t| *t == R::of(-1.0)));
    }
    planned
}

fn repeated_ends_and_far_points<R: Real>() {
    let limits = Limits::symmetric(R::ONE, R::ONE, R::ONE);
    let slow = Limits { vmax: R::of(0.5), ..limits };
    let ([rest, leaving, fast], far) = ([[0.0; 2], [0.9; 2], [0.8, 0.0]], far::<R>().widen());
    // Where the axis cannot be in the state of the end earlier, the last section lasts, though nothing has to move in it. Such paths were refused.
    assert_eq!(path_to(&[0.0, 1.0], leaving, &[limits]), Ok(Findings::ENDS_LEAVING));
    assert_eq!(path_to(&[0.0, 1.0, 1.0], leaving, &[limits]), Ok(Findings::ENDS_LEAVING));
    assert_eq!(path_to(&[0.0, 1.0, 2.0], fast, &[slow, limits]), Ok(Findings::default()));
    assert_eq!(path_to(&[0.0, 1.0, 1.0], fast, &[slow, limits]), Ok(Findings::default()));
    assert_eq!(path_to(&[0.0, 1.0, 1.0], fast, &[limits, slow]), Err(Error::Target));
    // A way beyond the range of the real type is refused, and positions that are far away are not.
    assert_eq!(path_to(&[-far, far, 0.0], rest, &[limits]), Err(Error::NotFinite));
    assert_eq!(path_to(&[far; 3], rest, &[limits]), Ok(Findings::default()));
}

type Change<'a, R> = &'a dyn Fn(&mut [State<R>], &mut [R], &mut [Limits<R>]);
const AXES: usize = 2;
const SECTIONS: usize = 3;
const POINTS: usize = AXES * (SECTIONS + 1);

fn path<R: Real>(
    zones: usize, duration: f64, change: Change<R>,
) -> ([State<R>; POINTS], [R; SECTIONS], Vec<Limits<R>>) {
    let mut limits = vec![Limits::symmetric(R::of(6.0), R::of(3.0), R::ONE); AXES * zones];
    let mut states = [0.0, 0.0, 1.0, 2.0, -1.0, 2.0, 0.5, 1.0].map(|p| State::at(R::of(p)));
    let mut durations = [R::of(duration); SECTIONS];
    change(&mut states, &mut durations, &mut limits);
    (states, durations, limits)
}

/// Between the ends a plan reads the positions alone, and an improvement all.
fn bad_paths<R: Real>() {
    let [none, endless, zero, fast] = [f64::NAN, f64::INFINITY, 0.0, 8.0].map(R::of);
    let answer = |planner: usize, change: Change<R>| {
        let (mut states, mut durations, limits) = path(if planner == 2 { SECTIONS } else { 1 }, 3.0, change);
        let before = format!("{states:?} {durations:?}");
        let mut work = vec![zero; path_size(AXES, SECTIONS).expect("a size")];
        let plan = if planner == 1 { improve_path } else { plan_path };
        let planned = plan(&mut states, &mut durations, &limits, AXES, 0, &mut work);
        assert_eq!(planned.is_err(), format!("{states:?} {durations:?}") == before);
        planned
    };
    for planner in 0..3 {
        for k in 0..POINTS {
            for bad in [none, endless, -endless] {
                assert_eq!(answer(planner, &|states, _, _| states[k].position = bad), Err(Error::NotFinite));
                let is_read = planner == 1 || !(AXES..AXES * SECTIONS).contains(&k);
                let expected = if is_read { Err(Error::NotFinite) } else { Ok(Findings::default()) };
                assert_eq!(answer(planner, &|states, _, _| states[k].velocity = bad), expected);
            }
        }
        for k in 0..AXES {
            let end = AXES * SECTIONS + k;
            assert_eq!(answer(planner, &|_, _, limits| limits[k].jmin = zero), Err(Error::Limits));
            assert_eq!(answer(planner, &|_, _, limits| limits[k].jmin = none), Err(Error::NotFinite));
            assert_eq!(answer(planner, &|states, _, _| states[end].velocity = fast), Err(Error::Target));
            assert_eq!(answer(planner, &|states, _, _| states[k].velocity = fast), Ok(Findings::STARTS_OUTSIDE));
            let leaving = answer(planner, &|states, _, _| {
                (states[end].velocity, states[end].acceleration) = (R::ONE, R::ONE);
            });
            assert_eq!(leaving, Ok(Findings::ENDS_LEAVING));
        }
    }
    for (k, bad) in [-R::ONE, endless, none].into_iter().enumerate() {
        assert_eq!(answer(1, &|_, durations, _| durations[k] = bad), Err(Error::Duration));
        assert_eq!(answer(0, &|_, durations, _| durations[k] = bad), Ok(Findings::default()));
    }
    for size in [path_size, path_size_near] {
        assert_eq!([size(0, 1), size(1, 0), size(usize::MAX, 2), size(2, usize::MAX)], [None; 4]);
    }
}

fn bad_tolerances<R: Real>() {
    let limits = [Limits::symmetric(R::of(6.0), R::of(3.0), R::ONE)];
    let answer = |tolerances: &[R], size: usize| {
        let (mut states, mut durations) = ([0.0, 1.0, 0.5].map(|p| State::at(R::of(p))), [R::of(3.0); 2]);
        let before = (states, durations);
        let mut work = vec![R::NAN; size];
        let planned = plan_path_near(&mut states, &mut durations, &limits, tolerances, 1, 0, &mut work);
        assert_eq!(planned.is_err(), (states, durations) == before);
        planned.err()
    };
    let size = path_size_near(1, 2).expect("a size");
    assert_eq!(answer(&[R::of(-0.125)], size), Some(Error::Limits));
    for bad in [f64::NEG_INFINITY, f64::INFINITY, f64::NAN] {
        assert_eq!(answer(&[R::of(bad)], size), Some(Error::NotFinite), "{bad}");
    }
    for good in [0.0, -0.0, 0.125, 1e30] {
        assert_eq!(answer(&[R::of(good)], size), None, "{good}");
    }
    assert_eq!([answer(&[], size), answer(&[R::ONE; 2], size), answer(&[R::ONE], size - 1)], [Some(Error::Axes); 3]);
}

/// The motions of a path with a number replaced. What is wrong with a number is found before a move is written.
fn bad_motions<R: Real>() {
    let [none, endless, zero, fast, short] = [f64::NAN, f64::INFINITY, 0.0, 8.0, 0.1].map(R::of);
    let good = Limits::symmetric(R::of(6.0), R::of(3.0), R::ONE);
    let untouched = [Move { t: none, ..Move::default() }; AXES * SECTIONS];
    // What it returns, and how many moves are written.
    let answer = |zones: usize, change: Change<R>| {
        let (states, durations, limits) = path(zones, 99.0, change);
        let mut moves = untouched;
        let made = path_moves(&mut moves, &limits, &states, &durations, AXES);
        (made, moves.iter().filter(|axis| axis.t.widen().is_finite()).count())
    };
    let parts: [fn(&mut State<R>) -> &mut R; 3] =
        [|state| &mut state.position, |state| &mut state.velocity, |state| &mut state.acceleration];
    for zones in [1, SECTIONS] {
        for k in 0..POINTS {
            for (bad, part) in [none, endless, -endless].into_iter().flat_map(|bad| parts.map(|part| (bad, part))) {
                let answer = answer(zones, &|states, _, _| *part(&mut states[k]) = bad);
                assert_eq!(answer, (Err(Error::NotFinite), 0));
            }
            // The start returns within its limits.
            let starts = (Ok(Findings::STARTS_OUTSIDE | Findings::OVERSHOOTS), 6);
            let expected = if k < AXES { starts } else { (Err(Error::Target), 0) };
            assert_eq!(answer(zones, &|states, _, _| states[k].velocity = fast), expected);
        }
        for k in 0..AXES * zones {
            assert_eq!(answer(zones, &|_, _, limits| limits[k].jmin = zero), (Err(Error::Limits), 0));
            assert_eq!(answer(zones, &|_, _, limits| limits[k].jmin = none), (Err(Error::NotFinite), 0));
        }
        for k in 0..SECTIONS {
            for bad in [-R::ONE, endless, none] {
                assert_eq!(answer(zones, &|_, durations, _| durations[k] = bad), (Err(Error::Duration), 0));
            }
            // Sections that take longer are written up to the first one.
            for bad in [zero, short] {
                let expected = (Err(Error::Duration), AXES * (k + 1));
                assert_eq!(answer(zones, &|_, durations, _| durations[k] = bad), expected);
            }
        }
    }
    let mut moves = untouched;
    let (states, durations) = ([State::at(zero); 8], [zero; SECTIONS]);
    for count in [0, 5] {
        assert_eq!(path_moves(&mut moves[..count], &[good; AXES], &states, &durations, AXES), Err(Error::Axes));
    }
    // A path that stands.
    assert_eq!(path_moves(&mut moves, &[good; AXES], &states, &durations, AXES), Ok(Findings::default()));
    assert!(moves.iter().all(|axis| axis.t == zero) && path_deviation(&moves, AXES) == zero);
    for (count, axes) in [(0, 1), (6, 0), (6, 4), (6, 7), (6, 129)] {
        assert!(path_deviation(&moves[..count], axes).widen().is_nan());
    }
    for bad in [none, endless] {
        let changes: [fn(&mut Move<R>, R); 5] = [
            |axis, bad| axis.t = bad,
            |axis, bad| axis.phase[0].position = bad,
            |axis, bad| axis.phase[1].position = bad,
            |axis, bad| axis.phase[1].velocity = bad,
            |axis, bad| axis.phase[1].jerk = bad,
        ];
        for change in changes {
            let [from, to] = [[0.0, 0.0], [1.0, 2.0]].map(|point| point.map(|p| State::at(R::of(p))));
            let mut moves = online::together(&[good; AXES], &from, &to, zero);
            assert!(path_deviation(&moves, AXES).widen().is_finite());
            change(&mut moves[1], bad);
            assert!(path_deviation(&moves, AXES).widen().is_nan());
        }
    }
}

fn bad_profiles<R: Real>() {
    let [zero, one, infinity, nan] = [0.0, 1.0, f64::INFINITY, f64::NAN].map(R::of);
    let far = far::<R>();
    let boundary = Boundary::rest_to_rest(-far, far);
    assert_eq!(Bell::fastest(one, one, one, boundary).err(), Some(Error::NotFinite));
    assert_eq!(Trap::fastest(one, one, -one, boundary).err(), Some(Error::NotFinite));
    let slow = R::of(f64::exp2(-10.0));
    for acceleration in [one, infinity] {
        let bell = Bell::fastest(one, acceleration, slow, Boundary::rest_to_rest(zero, far));
        assert_eq!(bell.err(), Some(Error::NotFinite));
    }
    // The duration is below the smallest number. liba has plans that take no time, and this library refuses them.
    let least = Boundary::rest_to_rest(zero, zero.neighbour(1));
    let (high, higher) = (R::of(f64::exp2(10.0)), R::of(f64::exp2(30.0)));
    assert_eq!(Bell::fastest(higher, high, one, least).err(), Some(Error::NotFinite));
    let here = Boundary::rest_to_rest(one, one);
    for (fast, acceleration) in [(one, one), (huge(0.95), zero.neighbour(1))] {
        assert_eq!(Bell::new(fast, acceleration, fast, here).err(), Some(Error::Unreachable));
    }
    for (duration, error) in [(one, Error::NotFinite), (zero, Error::Duration), (nan, Error::Duration)] {
        assert_eq!(Poly3::new(duration, boundary).err(), Some(error));
    }
    let near = Boundary::rest_to_rest(zero, one);
    let unlimited = [infinity, infinity, one];
    for [jerk, acceleration, velocity] in [[zero, one, one], [one, zero, one], [one, one, zero], unlimited] {
        assert_eq!(Bell::fastest(jerk, acceleration, velocity, near).err(), Some(Error::Limits));
    }
    for (rise, fall) in [(infinity, -one), (one, -infinity)] {
        assert_eq!(Trap::fastest(one, rise, fall, near).err(), Some(Error::Limits));
    }
}

fn bad_clocks<R: Real>() {
    let [zero, one] = [0.0, 1.0].map(R::of);
    let limits = Limits::symmetric(one, one, one);
    let mut clock = Clock::new();
    let mut refused = |moves: &[Move<R>], limits: &[Limits<R>], error| {
        assert_eq!(clock.rate(moves, limits, zero, zero), Err(error));
        assert_eq!(clock, Clock::new());
    };
    assert_eq!(Clock::new().rate(&[Move::default()], &[limits], zero, zero), Ok(Findings::default()));
    let planned = online::plan(&limits, State::at(zero), State::at(one));
    refused(&[], &[limits], Error::Axes);
    refused(&[planned], &[], Error::Axes);
    refused(&[planned], &[limits, limits], Error::Axes);
    refused(&[planned], &[Limits { amax: zero, ..limits }], Error::Limits);
    refused(&[planned], &[Limits { vmax: R::NAN, ..limits }], Error::NotFinite);
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY].map(R::of) {
        assert_eq!(clock.rate(&[planned], &[limits], bad, zero), Err(Error::NotFinite));
        assert_eq!(clock.rate(&[planned], &[limits], zero, bad), Err(Error::NotFinite));
    }
    let slow = Limits { vmax: R::of(0.1), ..limits }; // the axis is already too fast
    assert_eq!(clock.rate(&[planned], &[slow], one, zero), Err(Error::Target));
    assert_eq!(clock, Clock::new());
    assert_eq!(clock.rate(&[planned], &[limits], -one, zero), Err(Error::Late));
    assert!(clock.state(&[], 1, zero).iter().all(|x| x.widen().is_nan()));
}

fn bad_axes_and_motors<R: Real>() {
    let [zero, one, none, endless] = [0.0, 1.0, f64::NAN, f64::INFINITY].map(R::of);
    let (still, limits) = (State::at(one), Limits::symmetric(one, one, one));
    for bad in [zero, -one, none, endless, -endless] {
        assert_eq!(Axis::new(bad, still).err(), Some(Error::Duration));
        let mut axis = Axis::new(one, still).expect("a period");
        let (mut planner, _) = axis.split();
        assert_eq!(planner.track(&limits, still, zero, bad, 1), Err(Error::Duration));
        if bad == zero || bad == -one {
            continue;
        }
        for k in 0..3 {
            let mut state = still;
            *[&mut state.position, &mut state.velocity, &mut state.acceleration][k] = bad;
            assert_eq!(Axis::new(one, state).err(), Some(Error::NotFinite));
            assert_eq!(planner.go(&limits, state, 1), Err(Error::NotFinite));
        }
    }
    let mut axis = Axis::new(one, still).expect("a period");
    let (mut planner, mut ticker) = axis.split();
    let most = far::<R>();
    let beyond = State { position: most, velocity: most, acceleration: most };
    assert_eq!(planner.track(&limits, beyond, zero, one, 2), Err(Error::NotFinite));
    assert_eq!(planner.stop(&Limits { amax: zero, ..limits }, 1), Err(Error::Limits));
    for lead in [0, 1 << 27, u32::MAX] {
        let late = [
            planner.go(&limits, State::at(zero), lead),
            planner.reach(&limits, one, zero, lead),
            planner.stop(&limits, lead),
            planner.track(&limits, still, zero, one, lead),
        ];
        assert_eq!(late, [Err(Error::Late); 4]);
    }
    assert_eq!([(); 4].map(|()| ticker.tick()), [still; 4]);

    // Where the stream would have come from is beyond the range.
    let shaper = Shaper::new(ShaperKind::Zv, one, zero).expect("a shaper");
    let mut line = vec![zero; shaper.size(one).expect("a size")];
    let fast = State { velocity: -most, ..State::at(most) };
    assert_eq!(ShaperStream::new(&shaper, one, fast, &mut line).err(), Some(Error::NotFinite));

    let [near, far] = &[0.0, 2e9].map(|p| online::plan(&limits, still, State::at(R::of(p))));
    for step in [zero, -zero, -one, -zero.neighbour(1), -endless] {
        assert_eq!(Steps::new(near, zero, step).err(), Some(Error::Limits));
    }
    let bad = [(none, one), (endless, one), (-endless, one), (zero, none), (zero, endless), (zero, zero.neighbour(1))];
    for (of, offset, step) in bad.map(|(offset, step)| (near, offset, step)).into_iter().chain([(far, zero, one)]) {
        assert_eq!(Steps::new(of, offset, step).err(), Some(Error::NotFinite), "{offset:?} {step:?}");
    }
    let mut motor = Steps::new(near, zero, one).expect("a line");
    assert_eq!((motor.follow(far), motor.count()), (Err(Error::NotFinite), 1));
}

/// Lists of another length, which only a program in Rust can give.
fn bad_lists<R: Real>() {
    let [zero, one] = [0.0, 1.0].map(R::of);
    let (mut limits, points) = ([Limits::symmetric(one, one, one); 2], [0.0, 1.0, 0.5].map(|p| State::at(R::of(p))));
    let before = limits;
    assert_eq!(limit_feed(&mut limits[..1], &points, &[one; 2], 1), Err(Error::Axes));
    assert_eq!(limit_feed(&mut limits, &points, &[one, R::NAN], 1), Err(Error::NotFinite));
    assert_eq!(limit_feed(&mut limits, &points, &[one, zero], 1), Err(Error::Limits));
    assert_eq!(limits, before);

    let contour = |moves: usize, states: usize, tolerance: f64| {
        let (mut room, mut durations, mut places) = ([State::at(zero); 10], [zero; 8], [0; 3]);
        room[..3].copy_from_slice(&points);
        let path = Contour {
            moves: &mut vec![Move::default(); moves],
            states: &mut room[..states],
            durations: &mut durations,
            places: &mut places,
        };
        let mut work = vec![zero; path_size(1, 8).expect("a size")];
        plan_contour(path, &limits[..1], R::of(tolerance), 1, 4, &mut work).err()
    };
    assert_eq!(contour(8, 9, 1.0), None);
    assert_eq!([(7, 9), (8, 8), (8, 10)].map(|(moves, states)| contour(moves, states, 1.0)), [Some(Error::Axes); 3]);
    assert_eq!([0.0, -1.0].map(|tolerance| contour(8, 9, tolerance)), [Some(Error::Limits); 2]);
    assert_eq!(contour(8, 9, f64::NAN), Some(Error::NotFinite));
}

fn bad_groups<R: Real>() {
    let [zero, one, none, endless] = [0.0, 1.0, f64::NAN, f64::INFINITY].map(R::of);
    let (limits, to, still) = ([Limits::symmetric(one, one, one); 2], [State::at(one); 2], [State::at(zero); 2]);
    let (mut states, mut moves) = (still, [Move::default(); 6]);
    for count in [0, 3, 5] {
        assert_eq!(Group::new(one, &mut states, &mut moves[..count]).err(), Some(Error::Axes));
    }
    assert_eq!(Group::<R>::new(one, &mut [], &mut []).err(), Some(Error::Axes));
    for bad in [zero, -one, none, endless] {
        assert_eq!(Group::new(bad, &mut states, &mut moves).err(), Some(Error::Duration));
    }
    assert_eq!(Group::new(one, &mut [State::at(none); 2], &mut moves).err(), Some(Error::NotFinite));
    let positions = [
        (vec![zero], vec![one; 2], Error::Axes),
        (vec![], vec![one; 2], Error::Axes),
        (vec![zero; 3], vec![one; 3], Error::Axes),
        (vec![zero, none], vec![one; 2], Error::NotFinite),
        (vec![zero, one], vec![one; 2], Error::Limits),
    ];
    let (lowest, highest) = ([zero; 2], [one; 2]);
    let mut group = Group::new(one, &mut states, &mut moves).expect("a group");
    let (mut planner, mut ticker) = group.split();
    let path = [Move::default(); 3];
    let refused = [
        planner.go(&limits, &to[..1], 1),
        planner.sync(&limits, &to[..1], 1),
        planner.line(&limits, &to[..1], 1),
        planner.go(&limits[..1], &to, 1),
        planner.sync(&limits[..1], &to, 1),
        planner.line(&limits[..1], &to, 1),
        planner.path(&limits[..1], &path[..2], zero, 1),
        planner.rate(&limits[..1], zero, 1),
        planner.stop(&limits[..1], 1),
        planner.path(&limits, &path, zero, 1),
        planner.path(&limits, &[], zero, 1),
    ];
    assert_eq!(refused, [Err(Error::Axes); 11]);
    for (lowest, highest, error) in &positions {
        assert_eq!(planner.within([lowest, highest]), Err(*error));
    }
    for lead in [0, 1 << 27, u32::MAX] {
        assert_eq!([planner.go(&limits, &to, lead), planner.stop(&limits, lead)], [Err(Error::Late); 2]);
    }
    planner.within([&lowest, &highest]).expect("positions");
    let limits = [limits[0], Limits { vmax: zero, ..limits[1] }];
    assert_eq!([planner.sync(&limits, &to, 1), planner.stop(&limits, 1)], [Err(Error::Limits); 2]);
    let mut now = to;
    ticker.tick(&mut now);
    assert_eq!(now, still);
}

test_both_reals!(
    illegal_targets, beside_plans, bad_limits_and_states, bad_numbers, lengths, off_the_line, beyond_the_range,
    repeated_ends_and_far_points, bad_paths, bad_tolerances, bad_motions, bad_profiles, bad_clocks,
    bad_axes_and_motors, bad_lists, bad_groups
);
