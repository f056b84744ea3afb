//! A random program of calls to a group, and what is wrong with its ticks and its answers.

use support::prelude::*;

pub const CALLS: usize = 16; // of a program, before its path
const PLANNED: f64 = 0.8; // the limits of a plan that leaves the clock a reserve

/// A path from rest to rest, and the same path with a way back to its start.
struct Paths<R> {
    there: Vec<Move<R>>,
    there_and_back: Vec<Move<R>>,
    torn: Vec<Move<R>>, // a path that jumps
}

impl<R: Real> Paths<R> {
    fn random(random: &mut Random, limits: &[Limits<R>]) -> Self {
        let (n, sections) = (limits.len(), 1 + random.below(4));
        let position = |_| State::at(R::of(random.sign() * random.magnitude(-1.0, 1.0)));
        let points: Vec<_> = (0..n * (sections + 1)).map(position).collect();
        let back = online::together(limits, &points[n * sections..], &points[..n], R::of(0.0));
        let there = online::motions(points, limits, n, 6);
        let there_and_back = [&there[..], &back].concat();
        Self { torn: [&there[..], &there].concat(), there, there_and_back }
    }

    fn start(&self, n: usize) -> Vec<State<R>> {
        self.there[..n].iter().map(|of| of.state_at(R::of(0.0))).collect()
    }
}

/// Between which positions the axes stay: around their starts, with an infinite one for every fourth.
fn positions<R: Real>(random: &mut Random, start: &[State<R>]) -> [Vec<R>; 2] {
    [-1.0, 1.0].map(|side| {
        let mut away = || if random.one_in(4) { f64::INFINITY } else { random.magnitude(-1.0, 1.0) };
        start.iter().map(|now| R::of(now.position.widen() + side * away())).collect()
    })
}

/// What the group is asked to do.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Motion {
    Rest,
    Each,
    Together,
    Line,
    Path,
    Stop,
}

/// What programs did.
#[derive(Debug, Default)]
pub struct Counts {
    pub outside: usize, // motions that are refused because they would leave their positions
    pub steps: u64,
}

/// A motor that follows an axis.
struct Motor<R> {
    stream: StepStream<R>,
    step: f64,
}

impl<R: Real> Motor<R> {
    /// At the highest speed of the axis it takes 1 to 100 steps a tick.
    fn of(now: State<R>, limits: &Limits<R>, period: R, random: &mut Random) -> Self {
        let fastest = limits.vmax.widen().max(-limits.vmin.widen());
        let step = R::of((fastest * period.widen() * random.magnitude(-2.0, 0.0)).max(1e-4));
        let stream = StepStream::new(step, period, now).expect("a motor");
        Self { stream, step: step.widen() }
    }

    /// Takes the steps of a tick, which come in order within it, and lead to the nearest step. Returns how many.
    fn tick(&mut self, now: State<R>, period: f64) -> u64 {
        self.stream.tick(now).expect("a state");
        let (mut last, mut steps) = (0.0, 0);
        while let Some(step) = self.stream.next() {
            let time = step.time.widen();
            assert!(time >= last && time <= period, "{time} after {last}");
            (last, steps) = (time, steps + 1);
        }
        let position = now.position.widen();
        let off = (f64::from(self.stream.count()) * self.step - position).abs();
        let rounding = 8.0 * R::MACHINE_EPSILON.widen() * position.abs();
        assert!(off <= 0.5 * self.step + rounding, "a motor is {off:e} from its axis, in steps of {:e}", self.step);
        steps
    }
}

/// A group whose ticks are judged.
struct Trial<'g, 'a, R> {
    planner: GroupPlanner<'g, 'a, R>,
    ticker: GroupTicker<'g, 'a, R>,
    limits: &'g [Limits<R>],
    positions: [Vec<R>; 2],
    period: R,
    now: Vec<State<R>>,
    line: Option<[Vec<State<R>>; 2]>, // where the motion was planned to begin and to end, if it is to be a line
    has_ended: bool,
    age: u32,     // for how many ticks the motion is in force
    longest: f64, // that a motion of the program takes, s
    motors: Vec<Motor<R>>,
    steps: u64,
}

impl<R: Real> Trial<'_, '_, R> {
    fn tick(&mut self) -> Tick {
        let (before, period) = (self.now.clone(), self.period.widen());
        let tick = self.ticker.tick(&mut self.now);
        self.age = if tick.begins { self.age.max(1) } else { self.age + 1 };
        for ((before, now), limits) in before.iter().zip(&self.now).zip(self.limits) {
            let follows = follows(*before, *now, limits, period, period * f64::from(self.age), self.longest);
            assert!(follows, "{before:?} {now:?} {limits:?}");
        }
        assert!(self.stays_inside(), "{:?} {:?}", self.now, self.positions);
        self.steps += self.motors.iter_mut().zip(&self.now).map(|(motor, now)| motor.tick(*now, period)).sum::<u64>();
        assert!(!(tick.ends && self.has_ended && !tick.begins));
        if self.has_ended && !tick.begins && self.stands() {
            assert_eq!(before, self.now, "a group that stands moves on");
        }
        self.has_ended = tick.ends || self.has_ended && !tick.begins;
        if let Some([from, to]) = &self.line {
            let way = |axis: usize| to[axis].position.widen() - from[axis].position.widen();
            let lead = (0..from.len()).max_by(|a, b| way(*a).abs().total_cmp(&way(*b).abs())).expect("an axis");
            let own = |axis: usize| to[axis].position.widen().abs() + from[axis].position.widen().abs();
            let size = |axis: usize| own(axis).max(self.now[axis].position.widen().abs());
            let share = (self.now[lead].position.widen() - from[lead].position.widen()) / way(lead);
            for (axis, now) in self.now.iter().enumerate() {
                let off = now.position.widen() - (from[axis].position.widen() + share * way(axis));
                let rounding = 256.0 * R::MACHINE_EPSILON.widen() * (size(axis) + size(lead));
                assert!(off.abs() <= rounding, "off the line by {off:e}");
            }
        }
        tick
    }

    /// Whether each axis is between its positions, if there are some.
    fn stays_inside(&self) -> bool {
        let positions = self.positions[0].iter().zip(&self.positions[1]);
        self.now.iter().zip(self.limits).zip(positions).all(|((now, limits), (lowest, highest))| {
            let [p, low, high] = [now.position, *lowest, *highest].map(R::widen);
            let speed = limits.vmax.widen().max(-limits.vmin.widen());
            let rounding = 256.0 * R::MACHINE_EPSILON.widen() * (p.abs() + 10.0 + speed * self.longest);
            p >= low - rounding && p <= high + rounding
        })
    }

    fn stands(&self) -> bool {
        self.now.iter().all(|now| now.velocity.widen() == 0.0 && now.acceleration.widen() == 0.0)
    }

    /// Ticks until the plan takes over, which it does in its own tick.
    fn take_over(&mut self, lead: u32) {
        for tick in 1..=lead {
            assert_eq!(self.tick().begins, tick == lead);
        }
    }

    /// Ticks until the axes stand, which takes at most twice as long as the stop of the slowest axis.
    fn stops_in_time(&mut self) {
        let stop = |(now, limits): (&State<R>, &Limits<R>)| online::stop(limits, *now).t.widen();
        let slowest = self.now.iter().zip(self.limits).map(stop).fold(0.0, f64::max);
        let most = 2.0 * slowest / self.period.widen();
        let ticks = (0..).take_while(|_| !self.has_ended && !self.tick().ends).count();
        assert!(ticks as f64 <= most * (1.0 + 1e-4) + 2.0 && self.stands(), "{ticks} ticks instead of {most}");
    }

    /// Ticks until the motion ends; whether it does in time.
    fn ends(&mut self) -> bool {
        (0..200_000).any(|_| self.has_ended || self.tick().ends)
    }
}

/// Whether an axis can be in one state a period after the other: within its limits, and by no more than its jerk. The time since a
/// takeover, `age`, is rounded, and so are the positions of a motion that lasts up to `longest`, as `Move::check` documents.
pub fn follows<R: Real>(
    before: State<R>, now: State<R>, limits: &Limits<R>, period: f64, age: f64, longest: f64,
) -> bool {
    let [[p0, v0, a0], [p1, v1, a1]] = [before, now].map(online::numbers_of_state);
    let [vmax, vmin, amax, amin, jmax, jmin] = online::numbers_of(limits).map(R::widen);
    let (jerk, speed) = (jmax.max(-jmin), vmax.max(-vmin));
    let ulp = 256.0 * R::MACHINE_EPSILON.widen();
    let is_within = |x: f64, low: f64, high: f64| x >= low - ulp * (high - low) && x <= high + ulp * (high - low);
    let time = ulp * age;
    let acceleration = jerk * period + ulp * (amax - amin) + jerk * time;
    let velocity = jerk * period * period / 4.0 + ulp * speed + (amax - amin) * time;
    let position = jerk * period.powi(3) / 12.0 + ulp * (p0.abs() + p1.abs() + speed * longest) + speed * time;
    let moved = p1 - p0 - period / 2.0 * (v0 + v1) + period * period / 12.0 * (a1 - a0);
    is_within(v1, vmin, vmax)
        && is_within(a1, amin, amax)
        && (a1 - a0).abs() <= acceleration
        && (v1 - v0 - period / 2.0 * (a0 + a1)).abs() <= velocity
        && moved.abs() <= position
}

/// How far the axes are from a path. It may come near them more than once, so the search begins at each of 500 times of a section that is nearer
/// than its neighbours.
fn distance<R: Real>(now: &[State<R>], path: &[Move<R>]) -> f64 {
    const PARTS: usize = 500;
    let n = now.len();
    let away = |section: &[Move<R>], x: f64| {
        let axes = section.iter().zip(now);
        axes.map(|(of, now)| (of.position(R::of(x)).widen() - now.position.widen()).abs()).fold(0.0, f64::max)
    };
    let nearest = |section: &[Move<R>], mut best: f64, mut step: f64| {
        let t = section[0].t.widen();
        for _ in 0..40 {
            let at = |k: i32| (best + f64::from(k) * step).clamp(0.0, t);
            let least = (-4..=4).map(at).min_by(|x, y| away(section, *x).total_cmp(&away(section, *y)));
            (best, step) = (least.expect("a time"), step / 3.0);
        }
        away(section, best)
    };
    let sections = path.chunks(n).flat_map(|section| {
        let part = section[0].t.widen() / PARTS as f64;
        let at: Vec<f64> = (0..=PARTS).map(|k| away(section, k as f64 * part)).collect();
        let is_near = move |k: &usize| at[*k] <= at[k.saturating_sub(1)].min(at[PARTS.min(k + 1)]);
        (0..=PARTS).filter(is_near).map(move |k| nearest(section, k as f64 * part, part / 2.0))
    });
    sections.fold(f64::INFINITY, f64::min)
}

/// Lets axes pass their targets in motion, and go on behind them: all along their line, or each at a velocity of its own.
fn move_on<R: Real>(random: &mut Random, now: &[State<R>], to: &mut [State<R>], limits: &[Limits<R>], is_line: bool) {
    let ways = to.iter().zip(now).map(|(to, now)| to.position.widen() - now.position.widen());
    let most = limits.iter().map(|of| 0.9 * of.vmax.widen().min(-of.vmin.widen()));
    let axes: Vec<_> = ways.zip(most).collect();
    let pace = axes.iter().map(|(way, most)| most / way.abs()).fold(f64::INFINITY, f64::min) * random.unit();
    for (to, (way, most)) in to.iter_mut().zip(axes) {
        let own = random.pick(&[0.0, 1.0]) * most * random.between(-1.0, 1.0);
        to.velocity = R::of(if is_line { pace * way } else { own });
    }
}

/// Whether the moves of whole sections stay between the positions.
fn stay<R: Real>(moves: &[Move<R>], [lowest, highest]: &[Vec<R>; 2]) -> bool {
    moves.iter().zip(lowest.iter().zip(highest).cycle()).all(|(of, (lowest, highest))| {
        let reached = of.extremes();
        reached.lowest.position >= *lowest && reached.highest.position <= *highest
    })
}

/// Runs a program, which panics if a tick, a step or an answer is wrong.
pub fn program<R: Real>(random: &mut Random, counts: &mut Counts) {
    let n = 1 + random.below(6);
    let limits: Vec<Limits<R>> = (0..n).map(|_| online::limits(random)).collect();
    let planned = online::limits_times(&limits, PLANNED);
    let paths = Paths::random(random, &planned);
    let duration: f64 = paths.there.iter().step_by(n).map(|of| of.t.widen()).sum();
    let period = R::of(duration / random.between(50.0, 500.0));
    let start = paths.start(n);
    let positions = if random.one_in(2) { positions(random, &start) } else { [vec![], vec![]] };
    let (mut states, mut moves) = (start.clone(), vec![Move::default(); 3 * n]);
    let mut group = Group::new(period, &mut states, &mut moves).expect("a group");
    let (mut planner, ticker) = group.split();
    planner.within([&positions[0], &positions[1]]).expect("positions");
    let motor = |(now, limits): (&State<R>, &Limits<R>)| Motor::of(*now, limits, period, random);
    let motors = start.iter().zip(&limits).map(motor).collect();
    let mut trial = Trial {
        planner,
        ticker,
        limits: &limits,
        positions: positions.clone(),
        period,
        now: start.clone(),
        line: None,
        has_ended: false,
        age: 0,
        longest: duration,
        motors,
        steps: 0,
    };
    let mut motion = Motion::Rest;
    for _ in 0..CALLS {
        let lead = 1 + random.below(6) as u32;
        let is_at_rest = trial.has_ended && trial.stands();
        let within = if is_at_rest { &planned } else { &limits };
        let anywhere = |_| State::at(R::of(random.sign() * random.magnitude(-1.0, 1.0)));
        let mut to: Vec<State<R>> = (0..n).map(anywhere).collect();
        let are_inside = !random.one_in(4); // most targets are between the positions
        for (to, (lowest, highest)) in to.iter_mut().zip(positions[0].iter().zip(&positions[1])).filter(|_| are_inside)
        {
            to.position = R::of(to.position.widen().clamp(lowest.widen(), highest.widen()));
        }
        let call = random.below(7);
        if positions[0].is_empty() && random.one_in(2) {
            move_on(random, &trial.now, &mut to, &planned, call == 2);
        }
        let targets: Vec<_> = to.iter().zip(&limits).map(|(to, limits)| online::plan(limits, *to, *to)).collect();
        // A motion of the program may last as long as an axis takes to its target.
        for ((now, to), limits) in trial.now.iter().zip(&to).zip(&limits) {
            trial.longest = trial.longest.max(online::plan(limits, *now, *to).t.widen());
        }
        assert_eq!(trial.planner.sync(within, &to, 0), Err(Error::Late));
        let next = match call {
            0 => trial.planner.go(within, &to, lead).map(|_| Motion::Each),
            1 => trial.planner.sync(within, &to, lead).map(|_| Motion::Together),
            2 => trial.planner.line(within, &to, lead).map(|_| Motion::Line),
            3 => trial.planner.go(within, &start, lead).map(|_| Motion::Each),
            4 => trial.planner.path(&limits, &paths.there, R::of(0.0), lead).map(|_| Motion::Path),
            5 => trial.planner.stop(&limits, lead).map(|_| Motion::Stop),
            _ => trial.planner.rate(&limits, R::of(random.pick(&[0.0, 0.5, 1.0, -1.0])), lead).map(|_| motion),
        };
        let from = trial.now.clone();
        match next {
            Ok(next) => {
                assert!(call > 2 || stay(&targets, &positions), "{to:?} {positions:?}");
                trial.line = trial.line.take().filter(|_| call == 6);
                trial.take_over(lead);
                assert!(!is_at_rest || trial.stands(), "a motion from rest does not begin at rest");
                if call == 5 && motion != Motion::Line {
                    trial.stops_in_time();
                }
                motion = next;
                if next == Motion::Line && call == 2 && is_at_rest && from != to {
                    trial.line = Some([from, to]);
                }
            }
            // The axes move on, each for itself or another way.
            Err(Error::Line) => {}
            Err(Error::Target) if call == 4 || call == 6 => {}
            Err(Error::Position) if call < 5 => {
                let stays = if call == 4 { stay(&paths.there, &positions) } else { stay(&targets, &positions) };
                assert!(!stays || call == 2 && !is_at_rest, "{call}: {to:?} {positions:?}");
                counts.outside += 1;
            }
            Err(error) => panic!("{call}: {error}"),
        }
        for _ in 0..random.below(300) {
            trial.tick();
        }
    }
    trial.line = None;
    trial.planner.go(&limits, &start, 1).expect("a plan");
    trial.take_over(1);
    assert!(trial.ends() && trial.now == start);
    trial.planner.within([&[], &[]]).expect("any positions");
    trial.positions = [vec![], vec![]];
    along_the_path(random, &mut trial, &paths, &planned);
    counts.steps += trial.steps;
}

/// The group holds on a path, goes on in the longer one, and arrives.
fn along_the_path<'a, R: Real>(
    random: &mut Random, trial: &mut Trial<'_, 'a, R>, paths: &'a Paths<R>, planned: &[Limits<R>],
) {
    let (n, limits, zero) = (planned.len(), trial.limits, R::of(0.0));
    let size = limits.iter().zip(&trial.now).map(|(_, now)| 10.0 + now.position.widen().abs()).fold(0.0, f64::max);
    assert_eq!(trial.planner.path(limits, &paths.torn, zero, 1), Err(Error::Target));
    trial.planner.path(limits, &paths.there, zero, 1).expect("the path");
    trial.take_over(1);
    let mut ticks = 0;
    for _ in 0..random.below(100) {
        ticks += 1;
        if trial.tick().ends {
            break;
        }
    }
    if !trial.has_ended {
        // The same path as it goes on, from the time at which it takes over.
        let s = R::of(trial.period.widen() * f64::from(ticks + 2));
        let time = trial.planner.time(2).expect("the time of the path");
        let is_on = trial.planner.path(limits, &paths.there_and_back, s, 2);
        if is_on.is_ok() {
            trial.take_over(2);
        }
        let ends_before = s.widen() > paths.there.iter().step_by(n).map(|of| of.t.widen()).sum::<f64>();
        assert!(if ends_before { time < s } else { is_on.is_ok() && time == s }, "{is_on:?}");
        trial.planner.rate(limits, zero, 3).expect("a hold");
        trial.take_over(3);
        assert!(trial.ends() && trial.stands());
        let off = distance(&trial.now, &paths.there_and_back);
        assert!(off <= 1e4 * R::MACHINE_EPSILON.widen() * size, "off the path by {off:e}");
        trial.planner.rate(limits, R::of(1.0), 1).expect("to go on after a hold");
        trial.take_over(1);
        assert!(trial.ends());
    }
}
