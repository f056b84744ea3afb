//! Do axes that hold, slow down, speed up or go back along their path stay on the path, within their limits, without a jump?

use atraj::axes::{path_size, plan_path, synchronise};
use atraj::machine::Clock;
use atraj::online::{Error, Limits, Move, State};
use support::{Random, Real, online, test_both_reals};

/// Each path has three changes of its rate, so there are 100,000 per real type.
const PATHS: usize = if support::BRIEF { 3_334 } else { 33_334 };
const SAMPLES: usize = 40;
const RESERVES: [f64; 3] = [0.1, 0.2, 0.5];

/// Axes that arrive together, from rest to rest, in one section or in several ones between way points.
struct Path<R> {
    /// Section by section.
    moves: Vec<Move<R>>,
    limits: Vec<Limits<R>>,
    to: Vec<State<R>>,
}

impl<R: Real> Path<R> {
    fn random(random: &mut Random) -> Self {
        let n = 1 + random.below(6);
        let sections = random.pick(&[1, 1, 1, 2, 3, 9]);
        let limits: Vec<Limits<R>> = (0..n).map(|_| online::limits(random)).collect();
        let position = |_| State::at(R::of(random.sign() * random.magnitude(-1.0, 1.0)));
        let mut states: Vec<State<R>> = (0..n * (sections + 1)).map(position).collect();
        let zero = R::of(0.0);
        let mut durations = vec![zero; sections];
        if sections > 1 {
            let mut work = vec![zero; path_size(n, sections).expect("a size")];
            plan_path(&mut states, &mut durations, &limits, n, 6, &mut work).expect("a path");
        }
        let mut moves = vec![Move::default(); n * sections];
        for (section, moves) in moves.chunks_mut(n).enumerate() {
            let [from, to] = [section, section + 1].map(|point| &states[point * n..][..n]);
            synchronise(moves, &limits, from, to, durations[section], zero).expect("a plan");
        }
        let to = states[n * sections..].to_vec();
        Self { moves, limits, to }
    }

    fn axes(&self) -> usize {
        self.limits.len()
    }

    /// The moves of an axis and of those behind it, as `Clock::state` takes them.
    fn axis(&self, axis: usize) -> &[Move<R>] {
        &self.moves[axis..]
    }

    fn duration(&self) -> R {
        let durations = self.moves.iter().step_by(self.axes()).map(|of| of.t);
        durations.fold(R::of(0.0), |sum, t| sum + t)
    }

    /// The state of an axis at a time of the path.
    fn state(&self, axis: usize, s: R) -> State<R> {
        let (mut start, last) = (R::of(0.0), self.moves.len() / self.axes() - 1);
        let mut sections = self.axis(axis).iter().step_by(self.axes()).enumerate();
        let found = sections.find_map(|(section, of)| {
            let local = s - start;
            start = start + of.t;
            (section == last || s < start).then(|| of.state_at(local))
        });
        found.expect("a section")
    }

    /// The limits with a reserve.
    fn wider(&self, reserve: f64) -> Vec<Limits<R>> {
        let wider = |limit: R| R::of(limit.widen() * (1.0 + reserve));
        let each = self.limits.iter().map(|limits| Limits {
            vmax: wider(limits.vmax),
            vmin: wider(limits.vmin),
            amax: wider(limits.amax),
            amin: wider(limits.amin),
            jmax: wider(limits.jmax),
            jmin: wider(limits.jmin),
        });
        each.collect()
    }

    /// Whether each axis can do in one direction what it can do in the other.
    fn is_symmetric(&self) -> bool {
        self.limits.iter().all(|limits| {
            let Limits { vmax, vmin, amax, amin, jmax, jmin } = *limits;
            vmax == -vmin && amax == -amin && jmax == -jmin
        })
    }

    /// The slowest axis' stop at this time, without the path.
    fn free_stop(&self, limits: &[Limits<R>], x: R) -> f64 {
        let stop = |(axis, limits): (usize, &Limits<R>)| {
            let mut stop = Move::default();
            stop.stop(limits, self.state(axis, x)).expect("a stop");
            stop.t.widen()
        };
        limits.iter().enumerate().map(stop).fold(0.0, f64::max)
    }
}

/// Whether a state keeps the limits, up to 256 roundings of them.
fn keeps<R: Real>(state: [R; 4], limits: &Limits<R>) -> bool {
    let pairs = [(limits.vmin, limits.vmax), (limits.amin, limits.amax), (limits.jmin, limits.jmax)];
    state[1..].iter().zip(pairs).all(|(value, (low, high))| {
        let [value, low, high] = [*value, low, high].map(R::widen);
        let slack = 256.0 * R::MACHINE_EPSILON.widen() * (high - low);
        value <= high + slack && value >= low - slack
    })
}

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
                Ok(()) => accepted += 1,
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
            let later = clock.until().widen().max(x) + t * random.between(-0.2, 0.5);
            let later = later.max(x + 1e-3 * t);
            for _ in 0..SAMPLES {
                let y = R::of(random.between(x, later));
                let s = clock.time(y);
                for (axis, limits) in limits.iter().enumerate() {
                    let state = clock.state(path.axis(axis), n, y);
                    assert_eq!(state[0], path.state(axis, s).position, "path {number}: off the path");
                    assert!(
                        keeps(state, limits),
                        "path {number}, change {change}: {state:?} {limits:?} at {y:e}, {clock:?}, axis {axis}"
                    );
                }
            }
            x = later;
        }
        // Wherever the axes were, they end where the plan ends.
        let end = R::of(x + clock.until().widen() + 2.0 * t - clock.time(R::of(x)).widen().min(0.0));
        if clock.time(end).widen() > t {
            for (axis, to) in path.to.iter().enumerate() {
                assert_eq!(clock.state(path.axis(axis), n, end)[..2], [to.position, R::of(0.0)], "path {number}");
            }
        }
    }
    let holds = holds.map(|mut ratios: Vec<f64>| {
        ratios.sort_by(f64::total_cmp);
        ratios[ratios.len() / 2]
    });
    println!(
        "{}: {accepted} changes; refused: {backward} back with other limits, {in_change} in a change of {}; \
         a hold takes {holds:.2?} free stops with reserves of {RESERVES:?}",
        R::NAME,
        3 * PATHS,
    );
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
    println!("{seen} of 500");
    assert!(seen > 100);
}

/// The velocity, acceleration and jerk that a state tells are the derivatives of its position.
#[test]
fn states_are_derivatives() {
    let mut random = Random::seeded(52);
    for _ in 0..500 {
        let path = Path::<f64>::random(&mut random);
        let limits = path.wider(0.5);
        let mut clock = Clock::new();
        let x = path.duration() * random.between(0.1, 0.9);
        let rate = random.pick(&[0.0, 0.5, 1.0]);
        clock.rate(&path.moves, &limits, x, rate).expect("a change");
        let h = 1e-5 * (clock.until() - x);
        if h == 0.0 {
            continue;
        }
        for _ in 0..20 {
            let y = random.between(x + h, clock.until() - h);
            let [early, now, late] = [y - h, y, y + h].map(|y| clock.state(&path.moves, path.axes(), y));
            let limits = &limits[0];
            let sizes = [limits.vmax - limits.vmin, limits.amax - limits.amin, limits.jmax - limits.jmin];
            for k in 0..2 {
                let slope = (late[k] - early[k]) / (2.0 * h);
                let slack = h * sizes[k + 1] + 1e-11 * (sizes[k] * (1.0 + y) + now[k].abs()) / h;
                assert!((slope - now[k + 1]).abs() <= slack, "{k}: {slope} {now:?}");
            }
        }
    }
}

test_both_reals!(limits_are_kept);
