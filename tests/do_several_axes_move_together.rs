//! Do several axes that are planned together take the same time, end exactly where they are told, keep their limits, and stay on their
//! line? Does an error leave every axis as it was?

use atraj::axes::{line, synchronise};
use atraj::online::{Error, Limits, Move};
use atraj::{Findings, State};
use support::{Random, Real, online};

const SETS: usize = 20_000;
const MOST_AXES: usize = 6;
/// How many roundings are allowed.
const ROUNDINGS: f64 = 64.0;
const SAMPLES: usize = 64;

/// Limits, starts and ends of some axes, and what time they are given.
struct Set<R> {
    limits: Vec<Limits<R>>,
    from: Vec<State<R>>,
    to: Vec<State<R>>,
    duration: R,
    cycle: R,
}

impl<R: Real> Set<R> {
    fn new(random: &mut Random) -> Self {
        let count = 1 + random.below(MOST_AXES);
        let mut duration = || random.magnitude(-2.0, 2.0);
        let (duration, cycle) = (duration(), duration());
        let mut set = Self {
            limits: Vec::new(),
            from: Vec::new(),
            to: Vec::new(),
            duration: R::of(random.pick(&[0.0, duration])),
            cycle: R::of(random.pick(&[0.0, 0.001, cycle])),
        };
        for _ in 0..count {
            let limits = online::limits(random);
            let limits = if random.one_in(8) {
                online::fewer_limits(random, limits)
            } else {
                limits
            };
            set.from.push(online::anywhere(random, &limits));
            set.to.push(online::inside(random, &limits));
            set.limits.push(limits);
        }
        set
    }

    /// Axes whose ends lie on a line: each moves a share of the way of an axis that keeps the limits of all. One share is 0 at times.
    fn on_a_line(random: &mut Random) -> Self {
        let mut set = Self::new(random);
        let lead = online::limits::<R>(random);
        let (lead_from, lead_to) = (online::inside(random, &lead), online::inside(random, &lead));
        let axes = set.limits.iter_mut().zip(&mut set.from).zip(&mut set.to);
        for ((limits, from), to) in axes {
            let share = random.pick(&[0.0, 0.5, 1.0, 1.0]) * random.sign();
            let at = random.between(-10.0, 10.0);
            let of = |state: State<R>| State {
                position: R::of(at + share * state.position.widen()),
                velocity: R::of(share * state.velocity.widen()),
                acceleration: R::of(share * state.acceleration.widen()),
            };
            (*from, *to) = (of(lead_from), of(lead_to));
            // Every axis may do what the lead does.
            let wider = 1.0 + random.magnitude(-3.0, 1.0);
            let [v, a, j] = [
                (lead.vmax, lead.vmin),
                (lead.amax, lead.amin),
                (lead.jmax, lead.jmin),
            ]
            .map(|(high, low)| R::of(wider * high.widen().max(-low.widen())));
            *limits = Limits::symmetric(j, a, v);
        }
        set
    }

    fn plan(&self, planner: Planner<R>, axes: &mut [Move<R>]) -> Result<Findings, Error> {
        planner(
            axes,
            &self.limits,
            &self.from,
            &self.to,
            self.duration,
            self.cycle,
        )
    }

    fn describe(&self) -> String {
        let Self {
            limits,
            from,
            to,
            duration,
            cycle,
        } = self;
        format!("{limits:?} from {from:?} to {to:?} at least {duration:?} on {cycle:?}")
    }
}

type Planner<R> =
    fn(&mut [Move<R>], &[Limits<R>], &[State<R>], &[State<R>], R, R) -> Result<Findings, Error>;

/// What no plan leaves behind.
fn untouched<R: Real>() -> Move<R> {
    Move {
        t: R::of(-1.0),
        ..Move::default()
    }
}

/// All axes last as long, to the bit, and begin and end exactly where they are told. The time is what is asked for.
fn assert_met<R: Real>(set: &Set<R>, axes: &[Move<R>]) {
    let t = axes[0].t;
    for ((axis, &from), &to) in axes.iter().zip(&set.from).zip(&set.to) {
        let same_time = axis.t.low_bits() == t.low_bits();
        let ends = axis.state_at(t) == to && axis.state_at(R::of(f64::INFINITY)) == to;
        let starts = axis.state_at(R::of(-1.0)) == from;
        let count = axis.phases as usize;
        let phases = axis.phase[..=count].windows(2);
        let in_order = phases.clone().all(|pair| pair[0].t <= pair[1].t)
            && axis.phase[..count]
                .iter()
                .all(|phase| phase.duration >= R::of(0.0))
            && axis.phase[count].t == t;
        assert!(
            same_time && ends && starts && in_order,
            "{axis:?} of {}",
            set.describe()
        );
    }
    let rounding = 8.0 * R::MACHINE_EPSILON.widen();
    let (t, duration, cycle) = (t.widen(), set.duration.widen(), set.cycle.widen());
    assert!(t >= duration * (1.0 - rounding), "{t}: {}", set.describe());
    if cycle > 0.0 {
        let count = t / cycle;
        let off = (count - count.round()).abs();
        assert!(off <= rounding * count, "{t}: {}", set.describe());
    }
}

/// By how many times a rounding an axis jumps between phases, and exceeds a limit though it starts inside. A rounding is that of the largest
/// numbers of the motion, as in `does_a_retarget_jump`.
fn worst<R: Real>(set: &Set<R>, axes: &[Move<R>]) -> [f64; 2] {
    let mut worst = [0.0; 2];
    for ((axis, limits), &from) in axes.iter().zip(&set.limits).zip(&set.from) {
        let found = Move::default()
            .stop(limits, from)
            .expect("the set was planned");
        let starts_inside = found.bits() & Findings::STARTS_OUTSIDE.bits() == 0;
        let reached = axis.extremes();
        let values = |s: State<R>| [s.position, s.velocity, s.acceleration].map(R::widen);
        let [low, high] = [reached.lowest, reached.highest].map(values);
        let [p, v, a] = std::array::from_fn(|i| f64::max(low[i].abs(), high[i].abs()));
        let t = axis.t.widen();
        let phases = &axis.phase[..=axis.phases as usize];
        let j = phases
            .iter()
            .map(|phase| phase.jerk.widen().abs())
            .fold(0.0, f64::max);
        let sizes = [p + v * t, v + a * t.min(1.0), a + j * t.min(1.0)];
        let of = |over: f64, i: usize| {
            if over > 0.0 {
                over / (R::MACHINE_EPSILON.widen() * sizes[i])
            } else {
                0.0
            }
        };
        for pair in phases.windows(2) {
            let (now, x) = (&pair[0], pair[0].duration.widen());
            let [p0, v0, a0, j0] =
                [now.position, now.velocity, now.acceleration, now.jerk].map(R::widen);
            let p1 = p0 + x * (v0 + x * (a0 / 2.0 + x * j0 / 6.0));
            let v1 = v0 + x * (a0 + x * j0 / 2.0);
            worst[0] = f64::max(worst[0], of((p1 - pair[1].position.widen()).abs(), 0));
            worst[0] = f64::max(worst[0], of((v1 - pair[1].velocity.widen()).abs(), 1));
        }
        let bounds = [(limits.vmin, limits.vmax), (limits.amin, limits.amax)];
        for (i, (least, most)) in (1..).zip(bounds).filter(|_| starts_inside) {
            let over = f64::max(least.widen() - low[i], high[i] - most.widen());
            worst[1] = f64::max(worst[1], of(over, i));
        }
    }
    worst
}

/// No axis jumps by more than roundings, or exceeds a limit by more. Counts all that do.
fn smooth<R: Real>() {
    let mut wrong = [0; 2];
    let mut worst_of_all = [0.0; 2];
    let mut random = Random::seeded(5);
    for _ in 0..SETS {
        let set = Set::<R>::new(&mut random);
        let mut axes = vec![untouched(); set.limits.len()];
        set.plan(synchronise, &mut axes).expect("numbers");
        for (i, times) in worst(&set, &axes).into_iter().enumerate() {
            wrong[i] += usize::from(times > ROUNDINGS);
            worst_of_all[i] = f64::max(worst_of_all[i], times);
        }
    }
    assert_eq!(
        wrong, [0; 2],
        "of {SETS} sets jump and exceed, by {worst_of_all:?} roundings"
    );
}

#[test]
fn no_axis_jumps_or_exceeds_a_limit_f64() {
    smooth::<f64>();
}

#[test]
fn no_axis_jumps_or_exceeds_a_limit_f32() {
    smooth::<f32>();
}

fn synchronised<R: Real>() {
    let mut random = Random::seeded(1);
    for _ in 0..SETS {
        let set = Set::<R>::new(&mut random);
        let mut axes = vec![untouched(); set.limits.len()];
        let result = set.plan(synchronise, &mut axes);
        assert!(result.is_ok(), "{result:?}: {}", set.describe());
        assert_met(&set, &axes);
        // No axis is faster than it can be.
        let fastest: Vec<f64> = (0..axes.len())
            .map(|i| {
                let mut alone = Move::default();
                let found = alone.plan(&set.limits[i], set.from[i], set.to[i]);
                found.expect("the set was planned");
                alone.t.widen()
            })
            .collect();
        let slowest = fastest.iter().copied().fold(0.0, f64::max);
        let rounding = 1.0 - 64.0 * R::MACHINE_EPSILON.widen();
        assert!(
            axes[0].t.widen() >= rounding * slowest,
            "{:?} is less than {slowest}: {}",
            axes[0].t,
            set.describe()
        );
    }
}

/// The duration is the shortest: no time between the longest of the fastest moves and it is a duration for all axes.
fn shortest<R: Real>() {
    let mut random = Random::seeded(6);
    let (mut late, mut example) = (0, String::new());
    for _ in 0..SETS {
        let mut set = Set::<R>::new(&mut random);
        (set.duration, set.cycle) = (R::of(0.0), R::of(0.0));
        let mut axes = vec![untouched(); set.limits.len()];
        set.plan(synchronise, &mut axes).expect("numbers");
        let t = axes[0].t.widen();
        let alone = (0..axes.len()).map(|i| {
            let mut alone = Move::default();
            let found = alone.plan(&set.limits[i], set.from[i], set.to[i]);
            found.expect("the set was planned");
            alone.t.widen()
        });
        let slowest = alone.fold(0.0, f64::max);
        for part in [0.01, 0.1, 0.5, 0.9] {
            let duration = R::of(slowest + part * (t - slowest));
            set.duration = duration;
            set.plan(synchronise, &mut axes).expect("numbers");
            let rounding = 1.0 - 1e4 * R::MACHINE_EPSILON.widen();
            if axes[0].t.widen() < rounding * t {
                late += 1;
                example = format!(
                    "{t} instead of {:?}, slowest {slowest}: {}",
                    axes[0].t,
                    set.describe()
                );
                break;
            }
        }
    }
    assert_eq!(late, 0, "of {SETS} sets are late, one is {example}");
}

#[test]
fn no_shorter_time_is_possible_f64() {
    shortest::<f64>();
}

#[test]
fn no_shorter_time_is_possible_f32() {
    shortest::<f32>();
}

#[test]
fn synchronised_f64() {
    synchronised::<f64>();
}

#[test]
fn synchronised_f32() {
    synchronised::<f32>();
}

/// Every axis is as far on its way as the axis with the longest way, and its velocity and acceleration are that share.
fn on_a_line<R: Real>() {
    let mut random = Random::seeded(2);
    let mut planned = 0;
    for _ in 0..SETS {
        let set = Set::<R>::on_a_line(&mut random);
        let mut axes = vec![untouched(); set.limits.len()];
        match set.plan(line, &mut axes) {
            Ok(_) => planned += 1,
            // In the real type, rounded positions may be off the line of the velocities.
            Err(Error::Line) => continue,
            Err(error) => panic!("{error:?}: {}", set.describe()),
        }
        assert_met(&set, &axes);
        let ways: Vec<f64> = set
            .from
            .iter()
            .zip(&set.to)
            .map(|(from, to)| to.position.widen() - from.position.widen())
            .collect();
        let lead = (0..ways.len())
            .max_by(|&i, &j| ways[i].abs().total_cmp(&ways[j].abs()))
            .expect("an axis");
        for sample in 0..=SAMPLES {
            let x = R::of(axes[0].t.widen() * sample as f64 / SAMPLES as f64);
            let of_lead = axes[lead].state_at(x);
            for (i, axis) in axes.iter().enumerate() {
                let share = if ways[lead] == 0.0 {
                    0.0
                } else {
                    ways[i] / ways[lead]
                };
                let now = axis.state_at(x);
                let reached = axes[lead].extremes();
                let size = [reached.lowest, reached.highest]
                    .map(|state| state.position.widen().abs())
                    .into_iter()
                    .fold(10.0, f64::max)
                    + axes[0].t.widen() * reached.highest.velocity.widen().abs();
                let off = now.position.widen()
                    - set.to[i].position.widen()
                    - share * (of_lead.position.widen() - set.to[lead].position.widen());
                let rounding = 64.0 * R::MACHINE_EPSILON.widen() * size;
                assert!(
                    off.abs() <= rounding,
                    "axis {i} is off by {off}, more than {rounding}, at {x:?}: {}",
                    set.describe()
                );
            }
        }
    }
    assert!(planned > SETS / 4, "{planned} of {SETS}");
}

#[test]
fn on_a_line_f64() {
    on_a_line::<f64>();
}

#[test]
fn on_a_line_f32() {
    on_a_line::<f32>();
}

#[test]
fn at_rest_every_line_is_planned() {
    let mut random = Random::seeded(3);
    for _ in 0..SETS {
        let mut set = Set::<f64>::new(&mut random);
        for state in set.from.iter_mut().chain(&mut set.to) {
            *state = State::at(state.position);
        }
        let mut axes = vec![untouched(); set.limits.len()];
        let result = set.plan(line, &mut axes);
        assert!(result.is_ok(), "{result:?}: {}", set.describe());
        assert_met(&set, &axes);
    }
}

/// From rest to rest an axis is no faster than twice its mean velocity, if its jerks are equal.
fn slow<R: Real>() {
    let mut random = Random::seeded(7);
    for _ in 0..SETS {
        let mut set = Set::<R>::new(&mut random);
        for state in set.from.iter_mut().chain(&mut set.to) {
            *state = State::at(state.position);
        }
        for limits in &mut set.limits {
            limits.jmin = -limits.jmax;
        }
        let mut axes = vec![untouched(); set.limits.len()];
        set.plan(synchronise, &mut axes).expect("numbers");
        for ((axis, from), to) in axes.iter().zip(&set.from).zip(&set.to) {
            let way = to.position.widen() - from.position.widen();
            let reached = axis.extremes();
            let [low, high] = [reached.lowest, reached.highest].map(|state| state.velocity.widen());
            let rounding = 1.0 + 64.0 * R::MACHINE_EPSILON.widen();
            assert!(
                axis.t.widen() * f64::max(high, -low) <= 2.0 * way.abs() * rounding,
                "{axis:?} of {}",
                set.describe()
            );
        }
    }
}

#[test]
fn an_axis_at_rest_moves_slowly_f64() {
    slow::<f64>();
}

#[test]
fn an_axis_at_rest_moves_slowly_f32() {
    slow::<f32>();
}

#[test]
fn an_error_writes_no_axis() {
    let mut random = Random::seeded(4);
    let nan = f64::NAN;
    let mut refused = 0;
    for _ in 0..SETS {
        let mut set = Set::<f64>::new(&mut random);
        let axis = random.below(set.limits.len());
        let expected = match random.below(6) {
            0 => {
                set.limits[axis].jmax = -1.0;
                Error::Limits
            }
            1 => {
                set.from[axis].acceleration = nan;
                Error::NotFinite
            }
            2 => {
                set.to[axis].velocity = f64::MAX;
                set.limits[axis].vmax = 1.0;
                Error::Target
            }
            3 => {
                set.duration = random.pick(&[-1.0, nan, f64::INFINITY]);
                Error::Duration
            }
            4 => {
                set.cycle = random.pick(&[-1.0, nan, f64::INFINITY]);
                Error::Duration
            }
            _ => {
                set.to.pop();
                Error::Axes
            }
        };
        for planner in [synchronise, line] {
            let mut axes = vec![untouched(); set.limits.len()];
            assert_eq!(set.plan(planner, &mut axes), Err(expected));
            assert!(axes.iter().all(|axis| *axis == untouched()));
            refused += 1;
        }
    }
    assert_eq!(refused, 2 * SETS);
    assert_eq!(
        synchronise::<f64>(&mut [], &[], &[], &[], 0.0, 0.0),
        Err(Error::Axes)
    );
}
