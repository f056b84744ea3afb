//! Does a group keep its limits, its line and its path, and do its answers hold, whatever the main loop plans, at whatever tick?

use oracle::judge::group::{CALLS, Counts, program};
use support::prelude::*;

const PERIOD: f64 = 1.0 / 64.0; // of a tick, s
const PROGRAMS: usize = if support::BRIEF { 800 } else { 4_000 };

fn programs<R: Real>() {
    let mut random = Random::seeded(61);
    let mut counts = Counts::default();
    for _ in 0..PROGRAMS {
        program::<R>(&mut random, &mut counts);
    }
    let Counts { outside, steps } = counts;
    println!("{}: {PROGRAMS} programs of {CALLS} calls, {steps} steps, {outside} motions refused", R::NAME);
    assert!(steps > 5_000 * PROGRAMS as u64 && outside > PROGRAMS);
}

/// A path may be given again while its time runs at another rate, from where the axis is in the next tick, and not from elsewhere.
fn a_path_goes_on_at_the_rate_in_force<R: Real>() {
    let zero = R::ZERO;
    let limits = [Limits::symmetric(R::of(30.0), R::of(10.0), R::of(5.0))];
    let to_the_end = |v| online::plan(&online::symmetric(2.0, 1.0, v), State::at(zero), State::at(R::of(20.0)));
    let [slow, path] = &[0.5, 1.5].map(to_the_end);
    let next_time = |of: &Move<R>, now: &State<R>, rate: f64| {
        R::of(of.time_at(now.position).expect("a position of the path").widen() + rate * PERIOD)
    };
    for rate in [0.5, 1.5, -1.0] {
        let ((mut planner, mut ticker), mut now) = (online::group(PERIOD, &[zero]), [State::at(zero)]);
        let path = std::slice::from_ref(path);
        planner.path(&limits, path, zero, 1).expect("the path");
        (0..300).for_each(|_| assert!(!ticker.tick(&mut now).ends));
        planner.rate(&limits, R::of(rate), 1).expect("a rate");
        (0..3).for_each(|_| assert!(!ticker.tick(&mut now).ends));
        let s = next_time(&path[0], &now[0], rate);
        assert_eq!(planner.path(&limits, path, s, 1), Err(Error::Target), "while the rate changes");
        (0..97).for_each(|_| assert!(!ticker.tick(&mut now).ends));
        let s = planner.time(1).expect("the time of the path");
        let off = s.widen() - next_time(&path[0], &now[0], rate).widen();
        assert!(off.abs() < 1e3 * R::MACHINE_EPSILON.widen(), "{off:?}");
        assert_eq!(planner.time(0), Err(Error::Late));
        assert_eq!(planner.path(&limits, path, R::of(s.widen() + 0.25), 1), Err(Error::Target), "from elsewhere");
        // It may be off by 64 ulps of the position and of speed times time.
        let size = path[0].position(s).widen() + 1.5 * rate.abs() * (s.widen() + 401.0 * PERIOD);
        for (part, is_near) in [(0.5, true), (2.0, false)] {
            let off = R::of(s.widen() + part * 64.0 * R::MACHINE_EPSILON.widen() * size / 1.5);
            assert_eq!(planner.path(&limits, path, off, 1).is_ok(), is_near, "{part} {rate}");
        }
        let at = next_time(slow, &now[0], rate);
        assert_eq!(planner.path(&limits, std::slice::from_ref(slow), at, 1), Err(Error::Target), "at another speed");
        if rate > 1.0 {
            let tight = [Limits::symmetric(R::of(2.0), R::of(1.0), R::of(1.5))];
            assert_eq!(planner.path(&tight, path, s, 1), Err(Error::Target), "beyond the limits");
        }
        planner.path(&limits, path, s, 1).expect("the path at its rate");
        let tick = ticker.tick(&mut now);
        let off = [now[0].position.widen() - path[0].position(s).widen(), now[0].velocity.widen() - rate * 1.5];
        assert!(tick.begins && off.iter().all(|off| off.abs() < 1e3 * R::MACHINE_EPSILON.widen()), "{off:?}");
        assert!((0..2_000).any(|_| ticker.tick(&mut now).ends));
        assert_eq!(now, [State::at(R::of(if rate < 0.0 { 0.0 } else { 20.0 }))]);
    }
}

/// The fastest stop takes 1.5 m, and the hardest brake turns after 1.4896 m. So one axis can stay before 1.495 m, and the other not before 1.48 m.
fn a_stop_turns_at_a_position<R: Real>() {
    let zero = R::ZERO;
    let limits = [Limits::symmetric(R::of(2.0), R::of(1.0), R::of(1.5)); 2];
    let ((mut planner, mut ticker), mut now) = (online::group(PERIOD, &[zero; 2]), [State::at(zero); 2]);
    let start = online::plan(&limits[0], State::at(zero), State::at(R::of(20.0))).position(R::of(3.0)).widen();
    let [lowest, highest] = [[-R::INFINITY; 2], [1.495, 1.48].map(|way| R::of(start + way))];
    planner.go(&limits, &[20.0, 21.0].map(|to| State::at(R::of(to))), 1).expect("a plan");
    (0..192).for_each(|_| assert!(!ticker.tick(&mut now).ends));
    planner.within([&lowest, &highest]).expect("positions");
    planner.stop(&limits, 1).expect("a stop");
    let mut farthest = 0.0;
    while !ticker.tick(&mut now).ends {
        farthest = f64::max(farthest, now[0].position.widen() - start);
    }
    let stops = now.map(|now| now.position.widen() - start);
    assert!(farthest > 1.49 && farthest < 1.495001 && stops[0] < farthest - 0.005, "{farthest} {stops:?}");
    assert!((stops[1] - 1.5).abs() < 1e-5 && now.iter().all(|now| now.velocity == zero), "{stops:?} {now:?}");
    // The second one stands outside by more than a rounding.
    assert_eq!(planner.go(&limits, &[State::at(zero); 2], 1), Err(Error::Position));
}

/// A hold begins at the target, which the axis passes while it brakes. It is refused exactly if the axis would leave the positions meanwhile.
fn a_hold_behind_the_target_stays_inside<R: Real>() {
    let zero = R::ZERO;
    let limits = [Limits::symmetric(R::of(30.0), R::of(10.0), R::of(5.0))];
    let target = State { position: R::of(10.0), velocity: R::of(2.0), acceleration: R::of(-4.0) };
    let hold = |highest: R| {
        let ((mut planner, mut ticker), mut now) = (online::group(PERIOD, &[zero]), [State::at(zero)]);
        let positions = [[-R::INFINITY], [highest]];
        planner.go(&online::limits_times(&limits, 0.7), &[target], 1).expect("a plan");
        while !ticker.tick(&mut now).ends {}
        planner.within([&positions[0], &positions[1]]).expect("positions");
        planner.rate(&limits, zero, 1)?;
        let mut farthest = now[0].position.widen();
        while !ticker.tick(&mut now).ends {
            farthest = farthest.max(now[0].position.widen());
        }
        Ok(farthest)
    };
    let farthest = hold(R::INFINITY).expect("a hold");
    assert!(farthest > 10.1, "{farthest}");
    assert_eq!(hold(R::of(farthest - 1e-3)), Err(Error::Position));
    assert_eq!(hold(R::of(farthest + 1e-3)), Ok(farthest));
}

/// A change of the rate is refused exactly if the axis would leave the positions on what is left of its path: to 10 m, and back.
fn a_rate_stays_inside<R: Real>() {
    let limits = [Limits::symmetric(R::of(30.0), R::of(10.0), R::of(5.0))];
    let planned = online::limits_times(&limits, 0.7)[0];
    let moves = [[0.0, 10.0], [10.0, 0.0]].map(|ends| ends.map(|end| State::at(R::of(end))));
    let moves = moves.map(|[from, to]| online::plan(&planned, from, to));
    // After 1 s the axis is at 2 m. Then it is about to brake for 10 m. On its way back it is at 8 m, and at last at 4 m.
    let (there, brakes, back, late) = (64, 170, 300, 376);
    for (tick, highest, rate, stays) in [
        (there, 5.0, 0.5, false),
        (there, 5.0, 0.0, true),
        (there, 2.5, 0.0, false),
        (there, 5.0, -1.0, true),
        (there, 2.5, -1.0, false),
        (brakes, 9.4, 0.0, true),
        (back, 5.0, 0.5, false),
        (late, 5.0, 0.5, true),
    ] {
        // A path that is one straight section has a stop of its own.
        let sections = [&moves[..], &moves[..1]].into_iter().filter(|path| tick < back || path.len() > 1);
        for path in sections {
            let ((mut planner, mut ticker), mut now) = (online::group(PERIOD, &[R::ZERO]), [State::at(R::ZERO)]);
            let positions = [[-R::ONE], [R::of(highest)]];
            planner.path(&limits, path, R::ZERO, 1).expect("a path");
            (0..tick).for_each(|_| assert!(!ticker.tick(&mut now).ends));
            planner.within([&positions[0], &positions[1]]).expect("positions");
            let changed = planner.rate(&limits, R::of(rate), 1);
            assert!(if stays { changed.is_ok() } else { changed == Err(Error::Position) }, "{tick} {highest} {rate}");
        }
    }
}

/// A line at the limits leaves no reserve for a change of its time, and ends in motion. Its stop stays on the line.
fn a_stop_stays_on_a_line<R: Real>() {
    let limits = [(2.0, 1.0, 1.5), (3.0, 1.0, 1.0)].map(|(j, a, v)| online::symmetric::<R>(j, a, v));
    let to = [1.0, 0.5].map(|share| online::state_of([10.0 * share, share, 0.0]));
    for ticks in (16..480).step_by(16) {
        let ((mut planner, mut ticker), mut now) = (online::group(PERIOD, &[R::ZERO; 2]), [State::at(R::ZERO); 2]);
        planner.line(&limits, &to, 1).expect("a line");
        (0..ticks).for_each(|_| assert!(!ticker.tick(&mut now).ends));
        planner.stop(&limits, 1).expect("a stop");
        while !ticker.tick(&mut now).ends {}
        let off = now[0].position.widen() - 2.0 * now[1].position.widen();
        assert!(off.abs() < 64.0 * R::MACHINE_EPSILON.widen() && now[0].velocity == R::ZERO, "{ticks}: {now:?}");
    }
}

test_both_reals!(
    programs, a_path_goes_on_at_the_rate_in_force, a_stop_turns_at_a_position, a_hold_behind_the_target_stays_inside,
    a_rate_stays_inside, a_stop_stays_on_a_line
);
