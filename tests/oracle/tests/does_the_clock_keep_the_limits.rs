//! Do axes that hold, slow down, speed up or go back along their path stay on the path, within their limits, without a jump?

use oracle::judge::group::follows;
use support::prelude::*;

/// Each path has three changes of its rate, so there are 50,001 per real type.
const PATHS: usize = if support::BRIEF { 3_334 } else { 16_667 };
const SAMPLES: usize = 40;
const RESERVES: [f64; 3] = [0.1, 0.2, 0.5];

/// Axes that arrive together, from rest to rest, in one section or in several ones between waypoints.
struct Path<R> {
    moves: Vec<Move<R>>, // section by section
    limits: Vec<Limits<R>>,
    to: Vec<State<R>>,
}

impl<R: Real> Path<R> {
    fn random(random: &mut Random) -> Self {
        let n = 1 + random.below(6);
        let sections = random.pick(&[1, 1, 1, 2, 3, 9]);
        let limits: Vec<Limits<R>> = (0..n).map(|_| online::limits(random)).collect();
        let position = |_| State::at(R::of(random.sign() * random.magnitude(-1.0, 1.0)));
        let points: Vec<_> = (0..n * (sections + 1)).map(position).collect();
        let to = points[n * sections..].to_vec();
        Self { moves: online::motions(points, &limits, n, 6), limits, to }
    }

    fn axes(&self) -> usize {
        self.limits.len()
    }

    fn axis(&self, axis: usize) -> &[Move<R>] {
        &self.moves[axis..]
    }

    fn duration(&self) -> R {
        self.moves.iter().step_by(self.axes()).map(|of| of.t).fold(R::ZERO, |sum, t| sum + t)
    }

    fn state(&self, axis: usize, s: R) -> State<R> {
        let (mut start, last) = (R::ZERO, self.moves.len() / self.axes() - 1);
        let mut sections = self.axis(axis).iter().step_by(self.axes()).enumerate();
        let found = sections.find_map(|(section, of)| {
            let local = s - start;
            start = start + of.t;
            // At the end of the path, whatever the difference is rounded to.
            let local = if s < start || local > of.t { local } else { of.t };
            (section == last || s < start).then(|| of.state_at(local))
        });
        found.expect("a section")
    }

    fn wider(&self, reserve: f64) -> Vec<Limits<R>> {
        online::limits_times(&self.limits, 1.0 + reserve)
    }

    /// Whether each axis can do in one direction what it can do in the other.
    fn is_symmetric(&self) -> bool {
        self.limits.iter().all(|limits| {
            let Limits { vmax, vmin, amax, amin, jmax, jmin } = *limits;
            vmax == -vmin && amax == -amin && jmax == -jmin
        })
    }

    fn free_stop(&self, limits: &[Limits<R>], x: R) -> f64 {
        let stop = |(axis, limits): (usize, &Limits<R>)| online::stop(limits, self.state(axis, x)).t.widen();
        limits.iter().enumerate().map(stop).fold(0.0, f64::max)
    }
}

fn keeps<R: Real>(state: [R; 4], limits: &Limits<R>) -> bool {
    let pairs = [(limits.vmin, limits.vmax), (limits.amin, limits.amax), (limits.jmin, limits.jmax)];
    state[1..].iter().zip(pairs).all(|(value, (low, high))| {
        let [value, low, high] = [*value, low, high].map(R::widen);
        let slack = 256.0 * R::MACHINE_EPSILON.widen() * (high - low);
        value <= high + slack && value >= low - slack
    })
}

/// A state follows from the one before only if its velocity and acceleration are the derivatives of the position.
fn limits_are_kept<R: Real>() {
    let mut random = Random::seeded(51);
    let epsilon = R::MACHINE_EPSILON.widen();
    let (mut accepted, mut backward, mut in_change) = (0, 0, 0);
    let mut holds = [const { Vec::new() }; 3];
    for number in 0..PATHS {
        let path = Path::<R>::random(&mut random);
        let reserve = random.below(RESERVES.len());
        let limits = path.wider(RESERVES[reserve]);
        let (n, t) = (path.axes(), path.duration().widen());
        let mut clock = Clock::<R>::new();
        let mut x = t * random.between(0.0, 1.0);
        for change in 0..3 {
            let any = random.pick(&[0.0, 0.0, 0.5, -1.0, 0.1, 1.0]);
            let rate = if change == 2 { 1.0 } else { any };
            let (before, begin) = (clock, R::of(x));
            let is_steady = before.until().widen() <= x;
            match clock.rate(&path.moves, &limits, begin, R::of(rate)) {
                Ok(_) => accepted += 1,
                Err(error) => {
                    assert_eq!((error, before), (Error::Target, clock), "path {number}");
                    // Back along the path, an axis needs in one direction what it had in the other.
                    let is_backward = rate < 0.0 && !path.is_symmetric();
                    assert!(is_backward || !is_steady, "path {number}: {rate}, {before:?}");
                    backward += u32::from(is_backward);
                    in_change += u32::from(!is_backward);
                }
            }
            if change == 0 && rate == 0.0 {
                let free = path.free_stop(&limits, begin);
                if free > 1e-3 * t {
                    holds[reserve].push((clock.until().widen() - x) / free);
                }
            }
            for (axis, limits) in limits.iter().enumerate() {
                let [one, other] = [before, clock].map(|clock| clock.state(path.axis(axis), n, begin));
                let speed = limits.vmax.widen() - limits.vmin.widen();
                let position = one[0].widen().abs() + speed * (x + t);
                let acceleration = limits.amax.widen() - limits.amin.widen();
                for (k, size) in [position, speed + acceleration * x, acceleration].into_iter().enumerate() {
                    let jump = (one[k].widen() - other[k].widen()).abs();
                    // The acceleration changes by its jerk within a rounding of the time.
                    let jerk = limits.jmax.widen() - limits.jmin.widen();
                    let slack = 256.0 * epsilon * (size + if k == 2 { jerk * (x + t) } else { 0.0 });
                    assert!(jump <= slack, "path {number}: {one:?} {other:?}");
                }
            }
            let later = (clock.until().widen().max(x) + t * random.between(-0.2, 0.5)).max(x + 1e-3 * t);
            for (axis, limits) in limits.iter().enumerate() {
                let mut last = None;
                for k in 0..SAMPLES {
                    let part = (k as f64 + random.between(0.0, 0.99)) / SAMPLES as f64;
                    // A short step tells derivatives, a long one jumps.
                    for y in [part, part + 1e-5].map(|part| R::of(x + part * (later - x))) {
                        let state = clock.state(path.axis(axis), n, y);
                        let [position, velocity, acceleration, _] = state;
                        assert_eq!(position, path.state(axis, clock.time(y)).position, "path {number}: off the path");
                        let now = State { position, velocity, acceleration };
                        let follows = last.is_none_or(|(before, then): (_, R)| {
                            follows(before, now, limits, y.widen() - then.widen(), x + t, t)
                        });
                        assert!(
                            follows && keeps(state, limits),
                            "path {number}, change {change}: {last:?} {state:?} {limits:?} at {y:e}, {clock:?}, axis {axis}"
                        );
                        last = Some((now, y));
                    }
                }
            }
            x = later;
        }
        // Wherever the axes were, they end where the plan ends.
        let end = R::of(x + clock.until().widen() + 2.0 * t - clock.time(R::of(x)).widen().min(0.0));
        if clock.time(end).widen() >= t {
            for (axis, to) in path.to.iter().enumerate() {
                assert_eq!(clock.state(path.axis(axis), n, end)[..2], [to.position, R::ZERO], "path {number}");
            }
        }
    }
    let holds = holds.map(|mut ratios: Vec<f64>| {
        ratios.sort_by(f64::total_cmp);
        ratios[ratios.len() / 2]
    });
    println!("{}: {accepted} of {} changes; refused: {backward} back, {in_change} in a change", R::NAME, 3 * PATHS);
    println!("a hold takes {holds:.2?} free stops with reserves of {RESERVES:?}");
    assert!((in_change as usize) < PATHS / 100 && holds.iter().all(|ratio| *ratio < 1.5));
}

/// The clock uses its reserve. So the judge must see it exceed a smaller one.
#[test]
fn a_fault_is_seen() {
    let mut random = Random::seeded(53);
    let mut seen = 0;
    for _ in 0..500 {
        let path = Path::<f64>::random(&mut random);
        let mut clock = Clock::new();
        let x = path.duration() * random.between(0.1, 0.9);
        clock.rate(&path.moves, &path.wider(0.5), x, 0.0).expect("a hold");
        let smaller = path.wider(0.2);
        seen += usize::from((0..200).any(|_| {
            let y = random.between(x, clock.until());
            let mut axes = smaller.iter().enumerate();
            axes.any(|(axis, limits)| !keeps(clock.state(path.axis(axis), path.axes(), y), limits))
        }));
    }
    assert!(seen > 100, "{seen} of 500");
}

fn short_move<R: Real>() -> ([Move<R>; 1], [Limits<R>; 1]) {
    let [limits, planned] = [1.0, 0.9].map(|part| online::symmetric(30.0 * part, 10.0 * part, 5.0 * part));
    let axis = online::plan(&planned, State::at(R::ZERO), State::at(R::of(2.0)));
    ([axis], [limits])
}

/// One axis, and axes on a line, stop as fast as without a path, whenever the hold is pressed, and also without a reserve.
#[test]
fn a_line_stops_exactly() {
    let full = Limits::symmetric(30.0, 10.0, 5.0);
    for part in [0.8, 0.9, 0.95, 1.0] {
        let planned = Limits::symmetric(30.0 * part, 10.0 * part, 5.0 * part);
        let (from, to) = ([State::at(0.0); 3], [2.0, -1.0, 0.5].map(State::at));
        for n in [1, 3] {
            let (moves, limits) = (online::straight(&[planned; 3][..n], &from[..n], &to[..n]), [full; 3]);
            let t = moves[0].t;
            for press in 1..1000 {
                let x = t * f64::from(press) / 1000.0;
                let mut clock = Clock::new();
                let found = clock.rate(&moves[..n], &limits[..n], x, 0.0).expect("a hold");
                assert!(found.is_empty() || part == 1.0);
                let stop = online::stop(&full, moves[0].state_at(x));
                assert!((clock.until() - x - stop.t).abs() < 1e-8 && clock.until() < t + 1e-8, "{n} {part} {x}");
                for k in 0..=20 {
                    let y = x + stop.t * f64::from(k) / 20.0;
                    let s = clock.time(y);
                    for (axis, limits) in limits[..n].iter().enumerate() {
                        let state = clock.state(&moves[axis..n], n, y);
                        assert_eq!(state[0], moves[axis].position(s));
                        let [_, v, a, j] = state;
                        let used = [v / limits.vmax, a / limits.amax, j / limits.jmax];
                        assert!(used.iter().all(|used| used.abs() <= 1.0 + 1e-6), "{n} {part} {x} {k}: {state:?}");
                    }
                    let [position, velocity, acceleration, _] = clock.state(&moves[..n], n, y);
                    let lead = stop.state_at(y - x);
                    let off = [position - lead.position, velocity - lead.velocity, acceleration - lead.acceleration];
                    assert!(off.iter().all(|off| off.abs() < 1e-6), "{n} {part} {x} {k}: {off:?}");
                }
                // It goes on, at the latest when it stands. In the middle the brake is at its limit, where a change may not be proved.
                let mut resumed = clock;
                let is_refused = resumed.rate(&moves[..n], &limits[..n], x + 0.5 * stop.t, 1.0).is_err();
                if is_refused {
                    assert_eq!(resumed, clock);
                    let at_rest = resumed.rate(&moves[..n], &limits[..n], clock.until(), 1.0);
                    assert!(at_rest.is_ok() || at_rest == Err(Error::Target) && part == 1.0, "{n} {part} {x}");
                    if at_rest.is_err() {
                        continue;
                    }
                }
                assert_eq!(resumed.state(&moves[..n], n, 50.0 * t), [2.0, 0.0, 0.0, 0.0], "{n} {part} {x}");
            }
        }
    }
}

fn held_path(random: &mut Random, part: f64) -> (Path<f64>, Vec<Limits<f64>>) {
    let n = 2 + random.below(4);
    let sections = random.pick(&[4, 5, 6, 8]);
    let limits = vec![Limits::symmetric(30.0, 10.0, 5.0); n];
    let planned = vec![Limits::symmetric(30.0 * part, 10.0 * part, 5.0 * part); n];
    let position = |_| State::at(random.between(-4.0, 4.0));
    let points: Vec<_> = (0..n * (sections + 1)).map(position).collect();
    let to = points[n * sections..].to_vec();
    (Path { moves: online::motions(points, &planned, n, 2), limits: planned, to }, limits)
}

/// Holds of random paths of 2 to 5 axes, in stops of the slowest axis: the median, and what 99 % keep. No hold ends after the path.
#[test]
fn holds_are_short() {
    const HOLDS: usize = if support::BRIEF { 300 } else { 2_000 };
    for (part, median, highest) in [(0.8, 1.18, 2.7), (0.9, 1.22, 3.6), (0.95, 1.25, 4.9)] {
        let mut random = Random::seeded(7);
        let (mut ratios, mut late) = (Vec::new(), 0);
        for number in 0..HOLDS {
            let (path, limits) = held_path(&mut random, part);
            let t = path.duration();
            let x = t * random.between(0.0, 1.0);
            let mut clock = Clock::new();
            let found = clock.rate(&path.moves, &limits, x, 0.0).expect("a hold");
            late += usize::from(found == Findings::RATE_NOT_REACHED);
            assert!(clock.until() <= t * (1.0 + 1e-12), "path {number}");
            assert_eq!(clock.state(&path.moves, path.axes(), clock.until() + 1.0)[1..], [0.0; 3], "path {number}");
            ratios.push((clock.until() - x) / path.free_stop(&limits, x));
        }
        ratios.sort_by(f64::total_cmp);
        let [half, most] = [ratios[HOLDS / 2], ratios[HOLDS * 99 / 100]];
        println!("planned at {part}: median {half:.3}, 99 % {most:.2}; {late} of {HOLDS} go to the end");
        assert!(half < median && most < highest && late < HOLDS * 15 / 100, "{part}: {half} {most} {late}");
    }
}

/// A limit of the change that does not bind is not raised: it would bind later, and this change would take 0.541 s.
#[test]
fn no_limit_is_raised_in_vain() {
    let [limits, planned] = [1.0, 0.8].map(|part| Limits::symmetric(14.0 * part, 3.0 * part, 2.0 * part));
    let (moves, mut clock) = ([online::plan(&planned, State::at(0.0), State::at(3.0_f64))], Clock::new());
    clock.rate(&moves, &[limits], 0.9, 0.5).expect("a rate");
    assert!(clock.until() < 0.9 + 0.518, "{}", clock.until());
}

/// A hold never waits for long where a later one stands sooner: presses at each 1/1000 of a path.
#[test]
fn a_later_press_is_hardly_sooner() {
    let mut random = Random::seeded(11);
    let (mut lost, mut presses, mut sooner) = (0.0, 0, 0);
    for _ in 0..if support::BRIEF { 3 } else { 12 } {
        let (path, limits) = held_path(&mut random, 0.9);
        let t = path.duration();
        let mut latest: f64 = 0.0;
        for press in 1..1000 {
            let x = t * f64::from(press) / 1000.0;
            let mut clock = Clock::new();
            clock.rate(&path.moves, &limits, x, 0.0).expect("a hold");
            presses += 1;
            lost += (latest - clock.until()).max(0.0) / path.free_stop(&limits, x);
            sooner += usize::from(latest - clock.until() > 0.5 * path.free_stop(&limits, x));
            latest = latest.max(clock.until());
        }
    }
    let mean = lost / f64::from(presses);
    assert!(mean < 0.15 && sooner < presses as usize / 20, "{presses} presses: {mean} stops, {sooner} by half a stop");
}

/// The time of a path stands at its ends, and the axes with it. It sets off from there at once.
fn the_time_stands_at_its_ends<R: Real>() {
    let (axis, limits) = short_move::<R>();
    let t = axis[0].t;
    let mut clock = Clock::new();
    let of = |clock: &Clock<R>, x: f64| clock.state(&axis, 1, R::of(x));
    assert_eq!(clock.rate(&axis, &limits, R::of(60.0), -R::ONE), Ok(Findings::default()));
    assert_eq!((clock.until(), clock.time(R::of(60.0))), (R::of(60.0), t));
    assert!(of(&clock, 60.5)[0] < R::of(2.0) && clock.time(R::of(60.5)) == t - R::of(0.5));
    assert_eq!((clock.time(R::of(99.0)), of(&clock, 99.0)), (R::ZERO, [R::ZERO; 4]));
    // It is at its start: no way is left.
    assert_eq!(clock.rate(&axis, &limits, R::of(100.0), -R::ONE), Ok(Findings::RATE_NOT_REACHED));
    assert_eq!(clock.until(), R::of(100.0));
    assert_eq!(clock.rate(&axis, &limits, R::of(110.0), R::ONE), Ok(Findings::default()));
    assert_eq!(clock.time(R::of(110.5)), R::of(0.5));
    assert_eq!((clock.time(R::of(119.0)), of(&clock, 119.0)), (t, [R::of(2.0), R::ZERO, R::ZERO, R::ZERO]));
    // A rate that is not reached before the end.
    let mut clock = Clock::new();
    assert_eq!(clock.rate(&axis, &limits, R::of(0.5), R::of(1e9)), Ok(Findings::RATE_NOT_REACHED));
    assert!((clock.until() - t).widen().abs() < 1e-5);
}

/// A change ahead changes nothing before it begins, and one before the last change is refused.
fn a_change_waits<R: Real>() {
    let mut random = Random::seeded(54);
    for _ in 0..200 {
        let path = Path::<R>::random(&mut random);
        let limits = path.wider(0.5);
        let (n, t) = (path.axes(), path.duration().widen());
        let mut clock = Clock::new();
        let first = R::of(t * random.between(0.0, 0.5));
        let rate = random.pick(&[0.0, 0.5]);
        clock.rate(&path.moves, &limits, first, R::of(rate)).expect("a change");
        let (before, x) = (clock, first + R::of(t * random.between(0.01, 0.5)));
        if clock.rate(&path.moves, &limits, x, R::of(random.pick(&[0.0, 1.0]))).is_err() {
            continue;
        }
        for _ in 0..20 {
            let y = R::of(random.between(first.widen(), x.widen()));
            if y < x {
                let [one, other] = [&before, &clock].map(|clock| clock.state(&path.moves, n, y));
                assert_eq!((one, before.time(y)), (other, clock.time(y)));
            }
        }
        let changed = clock;
        assert_eq!(clock.rate(&path.moves, &limits, first, R::ONE), Err(Error::Late));
        assert_eq!(clock, changed);
    }
}

fn infinite_jerks_hold<R: Real>() {
    let mut random = Random::seeded(55);
    for number in 0..200 {
        let n = 1 + random.below(4);
        let mut between = |low, high| R::of(random.between(low, high));
        let of_axis = |_| Limits::symmetric(R::INFINITY, between(2.0, 8.0), between(1.0, 4.0));
        let planned: Vec<Limits<R>> = (0..n).map(of_axis).collect();
        let to: Vec<_> = (0..n).map(|_| State::at(R::of(random.between(-3.0, 3.0)))).collect();
        let moves = online::together(&planned, &vec![State::at(R::ZERO); n], &to, R::ZERO);
        let path = Path { moves, limits: planned, to };
        let limits: Vec<Limits<R>> = path.wider(0.2);
        let x = R::of(path.duration().widen() * random.between(0.05, 0.9));
        let mut clock = Clock::new();
        clock.rate(&path.moves, &limits, x, R::ZERO).expect("a hold");
        assert!(clock.until() <= path.duration() * R::of(1.0 + 1e-5), "path {number}");
        for _ in 0..SAMPLES {
            let y = R::of(random.between(x.widen(), clock.until().widen() + 0.1));
            for (axis, limits) in limits.iter().enumerate() {
                let [_, v, a, _] = clock.state(path.axis(axis), n, y).map(R::widen);
                let [vmax, amax] = [limits.vmax, limits.amax].map(|limit| limit.widen() * (1.0 + 1e-4));
                assert!(v.abs() <= vmax && a.abs() <= amax, "path {number}: {v} {a} {limits:?}");
            }
        }
    }
}

/// After ten hours a clock that was rebased moves evenly.
#[test]
fn a_clock_keeps_its_resolution() {
    let (axis, limits) = short_move::<f32>();
    let mut clock = Clock::new();
    clock.rate(&axis, &limits, 0.5, 0.0).expect("a hold");
    let held = clock.time(36_000.0);
    clock.rebase(36_000.0);
    assert_eq!(clock.time(0.0), held);
    clock.rate(&axis, &limits, 0.0, 1.0).expect("a change");
    let mut ticks = (1_i16..1000).map(|tick| {
        let [one, other] = [-1, 0].map(|k| clock.time(clock.until() + f32::from(tick + k) * 0.001));
        (other, other - one)
    });
    assert!(ticks.by_ref().take_while(|(s, _)| *s < axis[0].t).all(|(_, way)| (way - 0.001).abs() < 1e-6));
    assert!(ticks.next().is_some_and(|(s, way)| s == axis[0].t && way == 0.0));
}

test_both_reals!(limits_are_kept, the_time_stands_at_its_ends, a_change_waits, infinite_jerks_hold);
