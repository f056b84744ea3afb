//! Is any motion of a million random scripts wrong in corrected mode?
//!
//! The definition of a wrong motion knows nothing of how a profile is planned. The listing plans the same moves, for
//! comparison.
//!
//! `cargo test --test is_a_corrected_motion_wrong -- --nocapture` prints the shares of wrong motions.

use approx::abs_diff_eq;
use atraj::State;
use atraj::claraty::{EPS, Mode, Profile, Target, Trajectory, Warnings};
use std::collections::BTreeMap;
use support::real::just_after;
use support::{Random, Real};

const SCRIPTS: usize = 1_000_000;

/// The highest ratio of acceleration and deceleration. Far higher ratios show the cancellation in the listing's formulas.
const RATIO: f64 = 1e6;
/// Above `EPS`, so that no rate is raised.
const LOWEST_RATE: f64 = 1e-9;

/// What a script asks of the axis. The outcomes of each request are counted apart.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Request {
    FirstMove,
    Anywhere,
    Behind,
    TooNear,
    StoppingDistance,
    Tiny,
    Stop,
    VelocityRaised,
    VelocityLowered,
    VelocityAsNow,
    RatesChanged,
}
use Request::*;

/// Every request with its name, in order.
const REQUESTS: [(Request, &str); 11] = [
    (FirstMove, "first move from rest"),
    (Anywhere, "retarget anywhere"),
    (Behind, "retarget to a point behind"),
    (TooNear, "retarget too near to stop"),
    (StoppingDistance, "retarget at the stopping distance"),
    (Tiny, "tiny retarget"),
    (Stop, "stop"),
    (VelocityRaised, "maximum velocity raised"),
    (VelocityLowered, "maximum velocity lowered"),
    (VelocityAsNow, "maximum velocity as now"),
    (RatesChanged, "acceleration and deceleration changed"),
];

impl Request {
    fn name(self) -> &'static str {
        REQUESTS[self as usize].1
    }
}

/// A requested motion: from where, to where, within which limits.
#[derive(Clone, Copy, Debug)]
struct Order {
    start: State<f64>,
    target: Target,
}

impl Order {
    /// A stop is the order to go as far as the axis goes while it brakes.
    fn stop(start: State<f64>, limits: Target) -> Self {
        let v0 = start.velocity;
        let position = start.position + 0.5 * v0 * v0.abs() / limits.deceleration;
        let velocity = v0.abs();
        Self {
            start,
            target: Target {
                position,
                velocity,
                ..limits
            },
        }
    }

    fn distance(&self) -> f64 {
        self.target.position - self.start.position
    }

    fn stopping_distance(&self, rate: f64) -> f64 {
        0.5 * self.start.velocity * self.start.velocity / rate
    }

    /// Whether the target lies within a few roundings of a stopping distance.
    fn is_at_a_stopping_distance(&self) -> bool {
        let ends = self.start.position.abs() + self.target.position.abs();
        let ahead = self.side() * self.distance();
        let rates = [self.target.acceleration, self.target.deceleration];
        let mut stopping = rates.iter().map(|&rate| self.stopping_distance(rate));
        stopping.any(|way| abs_diff_eq!(ahead, way, epsilon = 8.0 * f64::EPSILON * ends))
    }

    /// The side that the motion starts towards: -1 or +1.
    fn side(&self) -> f64 {
        if self.start.velocity == 0.0 {
            self.distance().signum()
        } else {
            self.start.velocity.signum()
        }
    }
}

/// Times at every phase border, just after it, and in between.
fn sample_times([t1, t2, tf]: [f64; 3], random: &mut Random) -> Vec<f64> {
    let mut times = vec![0.0];
    for border in [t1, t2, tf] {
        times.extend([border, just_after(border)]);
    }
    for _ in 0..6 {
        times.push(random.between(0.0, tf));
    }
    times.retain(|&t| t >= 0.0 && t <= tf);
    times.sort_by(f64::total_cmp);
    times
}

/// The bounds of a right motion, and the rounding that `f64` adds.
struct Bounds {
    top_speed: f64,
    /// Both positions are distances from the start, towards the side that the motion starts to.
    nearest: f64,
    farthest: f64,
    /// Whether the axis can stop before the target with one of the rates.
    avoidable: bool,
    /// The target is within rounding of a stopping distance, so two motions are right.
    tie: bool,
    position_rounding: f64,
    velocity_rounding: f64,
}

impl Bounds {
    fn new(order: &Order, duration: f64) -> Self {
        let Order { start, target } = *order;
        let ahead = order.side() * order.distance();
        let way_at_a = order.stopping_distance(target.acceleration);
        let way_at_d = order.stopping_distance(target.deceleration);
        let shortest = way_at_a.min(way_at_d);
        let top_speed = start.velocity.abs().max(target.velocity);
        // An instant is known to half an ulp of the duration, a position to half an ulp of itself.
        let time_rounding = 4.0 * f64::EPSILON * duration;
        let rounding =
            1e-14 * (start.position.abs() + target.position.abs()) + top_speed * time_rounding;
        let avoidable = ahead >= shortest * (1.0 + 1e-9) + rounding;
        let farthest = if avoidable {
            ahead
        } else {
            ahead.max(way_at_a)
        };
        Self {
            top_speed,
            nearest: ahead.min(0.0),
            farthest,
            avoidable,
            tie: [way_at_a, way_at_d]
                .iter()
                .any(|way| abs_diff_eq!(ahead, way, epsilon = 1e-9 * way + rounding)),
            position_rounding: 1e-9 * farthest.max(ahead.abs()) + rounding,
            velocity_rounding: 1e-9 * top_speed
                + target.acceleration.max(target.deceleration) * time_rounding,
        }
    }
}

/// Why a motion is wrong, judged from its setpoints alone. `None` if it is right.
fn fault(
    order: &Order,
    times: &[f64],
    duration: f64,
    mut at: impl FnMut(f64) -> State<f64>,
) -> Option<&'static str> {
    if !(duration >= 0.0 && duration.is_finite()) {
        return Some("no duration");
    }
    let bounds = Bounds::new(order, duration);
    let mut before = order.start;
    let mut then = 0.0;
    for &t in times {
        let now = at(t);
        let fault = fault_between(order, &bounds, &before, &now, t - then);
        if fault.is_some() {
            return fault;
        }
        (before, then) = (now, t);
    }
    let rest = at(just_after(duration));
    if (rest.velocity, rest.acceleration) != (0.0, 0.0) {
        return Some("does not end at rest");
    }
    let near = |x: f64, y: f64| abs_diff_eq!(x, y, epsilon = bounds.position_rounding);
    if !near(rest.position, order.target.position) {
        return Some("ends elsewhere");
    }
    if !(near(before.position, rest.position) && before.velocity.abs() <= bounds.velocity_rounding)
    {
        return Some("jumps to rest");
    }
    None
}

/// Why a piece of a motion is wrong. No phase border lies inside the piece.
fn fault_between(
    order: &Order,
    bounds: &Bounds,
    before: &State<f64>,
    now: &State<f64>,
    passed: f64,
) -> Option<&'static str> {
    let Order { start, target } = *order;
    let position = before.position + 0.5 * (before.velocity + now.velocity) * passed;
    let velocity = before.velocity + now.acceleration * passed;
    let turning = if before.velocity * now.velocity < 0.0 {
        before.position - 0.5 * before.velocity * before.velocity / now.acceleration
    } else {
        now.position
    };
    let allowed = |position: f64| {
        let way = order.side() * (position - start.position);
        bounds.nearest - bounds.position_rounding <= way
            && way <= bounds.farthest + bounds.position_rounding
    };
    let rates = [0.0, target.acceleration, target.deceleration];
    let checks = [
        (
            abs_diff_eq!(now.position, position, epsilon = bounds.position_rounding),
            "position jumps",
        ),
        (
            abs_diff_eq!(now.velocity, velocity, epsilon = bounds.velocity_rounding),
            "velocity jumps",
        ),
        (
            now.velocity.abs() <= bounds.top_speed + bounds.velocity_rounding,
            "too fast",
        ),
        (
            rates.contains(&now.acceleration.abs()),
            "another acceleration",
        ),
        (
            !bounds.avoidable || order.side() * now.velocity >= -bounds.velocity_rounding,
            "needless turn",
        ),
        (allowed(now.position) && allowed(turning), "overshoot"),
    ];
    checks
        .into_iter()
        .find_map(|(right, fault)| (!right).then_some(fault))
}

fn borders(axis: &Trajectory) -> [f64; 3] {
    let profile = axis.profile();
    [profile.t1, profile.t2, profile.tf]
}

#[derive(Default)]
struct Share {
    motions: usize,
    corrected_wrong: usize,
    listing_wrong: usize,
}

#[derive(Default)]
struct Tally {
    shares: BTreeMap<Request, Share>,
    faults: Vec<String>,
    same_bits: usize,
    /// Ties in which the corrected motion brakes to the target and arrives before the listing's.
    braked: usize,
    ties: usize,
    differing: Vec<String>,
}

impl Tally {
    /// Plans one order in both modes from the same state of `axis`, and leaves `axis` on the corrected motion.
    fn run(
        &mut self,
        axis: &mut Trajectory,
        request: Request,
        order: &Order,
        now: f64,
        random: &mut Random,
    ) {
        let mut listed = *axis;
        listed.set_mode(Mode::Listing);
        let [switched, gave_up] = [&mut *axis, &mut listed].map(|axis| {
            let warnings = if request == Stop {
                axis.stop(now)
            } else {
                axis.start(now)
            };
            warnings.bits() & Warnings::SWITCH.bits() != 0
        });
        assert!(!switched, "a switch warning in corrected mode: {order:?}");

        let share = self.shares.entry(request).or_default();
        share.motions += 1;
        let times = sample_times(borders(axis), random);
        if let Some(fault) = fault(order, &times, axis.duration(), |t| axis.setpoint_at(t)) {
            share.corrected_wrong += 1;
            let name = request.name();
            self.faults.push(format!("{name}: {fault}: {order:?}"));
        }
        let listed_times = sample_times(borders(&listed), random);
        let duration = listed.duration();
        if gave_up || fault(order, &listed_times, duration, |t| listed.setpoint_at(t)).is_some() {
            share.listing_wrong += 1;
        } else {
            self.compare(axis, &mut listed, &times, request, order);
        }
    }

    /// Compares a corrected motion with a right motion of the listing. The bits must be the same, except in moves below `EPS`,
    /// in the acceleration at the first instant of a stop, and in ties.
    fn compare(
        &mut self,
        axis: &mut Trajectory,
        listed: &mut Trajectory,
        times: &[f64],
        request: Request,
        order: &Order,
    ) {
        if request != Stop && order.distance().abs() < EPS {
            return;
        }
        let mut same = borders(axis)
            .into_iter()
            .zip(borders(listed))
            .all(|(x, y)| x.same(y));
        for &t in times {
            let (x, y) = (axis.setpoint_at(t), listed.setpoint_at(t));
            let first_of_stop = request == Stop && t == 0.0;
            same &= x.position.same(y.position)
                && x.velocity.same(y.velocity)
                && (first_of_stop || x.acceleration.same(y.acceleration));
        }
        if same {
            self.same_bits += 1;
        } else if order.is_at_a_stopping_distance() && axis.duration() < listed.duration() {
            self.braked += 1;
        } else if Bounds::new(order, axis.duration().max(listed.duration())).tie {
            self.ties += 1;
        } else {
            self.differing.push(format!(
                "{}: {order:?}\n  corrected {:?}\n  listing   {:?}",
                request.name(),
                axis.profile(),
                listed.profile()
            ));
        }
    }

    fn print(&self) {
        println!(
            "{:40} {:>9} {:>16} {:>14}",
            "", "motions", "corrected wrong", "listing wrong"
        );
        for (request, share) in &self.shares {
            println!(
                "{:40} {:9} {:16} {:13.2}%",
                request.name(),
                share.motions,
                share.corrected_wrong,
                100.0 * share.listing_wrong as f64 / share.motions as f64
            );
        }
        println!(
            "where the listing is right: {} with its bits, {} differing, {} at a stopping distance, where two motions \
             are right; {} more, where the corrected \
             motion arrives first",
            self.same_bits,
            self.differing.len(),
            self.ties,
            self.braked
        );
    }
}

fn random_limits(random: &mut Random) -> Target {
    let acceleration = random.magnitude(-3.0, 3.0);
    let ratio = match random.bits() % 4 {
        0 => 1.0,
        1 => random.magnitude(-6.0, 6.0),
        _ => random.magnitude(-0.7, 0.7),
    };
    Target {
        position: 0.0,
        velocity: random.magnitude(-3.0, 3.0),
        acceleration,
        deceleration: acceleration * ratio,
    }
}

/// The distance in which an axis reaches the maximum velocity and stops again.
fn natural_length(limits: Target) -> f64 {
    let rates = 1.0 / limits.acceleration + 1.0 / limits.deceleration;
    0.5 * limits.velocity * limits.velocity * rates
}

/// The target after `request`, for an axis in `state` with the present `target`.
fn next_target(request: Request, state: State<f64>, target: Target, random: &mut Random) -> Target {
    let State {
        position, velocity, ..
    } = state;
    let length = natural_length(target);
    let side = if velocity == 0.0 {
        random.sign()
    } else {
        velocity.signum()
    };
    let stopping = |rate: f64| 0.5 * velocity * velocity / rate;
    let mut next = target;
    match request {
        FirstMove | Anywhere => {
            next.position = position + random.sign() * length * random.magnitude(-3.0, 2.0)
        }
        Behind => next.position = position - side * length * random.magnitude(-6.0, 1.0),
        TooNear => {
            let way = stopping(target.acceleration).max(stopping(target.deceleration));
            next.position = position + side * way * random.between(0.0, 1.0);
        }
        StoppingDistance => {
            let weaker = random.magnitude(-6.0, 0.0);
            next.acceleration *= random.pick(&[1.0, weaker]);
            let way = stopping(random.pick(&[next.acceleration, next.deceleration]));
            let near = random.magnitude(-16.0, -3.0);
            let beyond = random.sign() * random.pick(&[0.0, 1e-16, near]);
            next.position = position + side * way * (1.0 + beyond);
        }
        Tiny => next.position = position + random.sign() * length * random.magnitude(-14.0, -6.0),
        Stop => {}
        VelocityRaised => next.velocity *= random.magnitude(0.0, 2.0),
        VelocityLowered => next.velocity *= random.magnitude(-2.0, 0.0),
        VelocityAsNow => {
            next.velocity = velocity.abs().max(1e-6);
            next.position = position + random.sign() * length * random.magnitude(-3.0, 1.0);
        }
        RatesChanged => {
            next.acceleration *= random.magnitude(-1.0, 1.0);
            next.deceleration *= random.magnitude(-1.0, 1.0);
        }
    }
    next.acceleration = next.acceleration.max(LOWEST_RATE);
    let ratio = next.deceleration / next.acceleration;
    next.deceleration = next.acceleration * ratio.clamp(1.0 / RATIO, RATIO);
    next.deceleration = next.deceleration.max(LOWEST_RATE);
    next
}

fn run_script(tally: &mut Tally, random: &mut Random) {
    let mut now = 0.0;
    let mut axis = Trajectory::new(Mode::Corrected, now);
    let mut target = random_limits(random);
    let mut request = FirstMove;
    for _ in 0..1 + random.bits() % 4 {
        let setpoint = axis.setpoint(now);
        let start = if axis.is_started() {
            setpoint
        } else {
            State::default()
        };
        if request == Stop && !axis.is_started() {
            request = Anywhere;
        }
        target = next_target(request, start, target, random);
        axis.set(target.into(), now).unwrap();
        let order = match request {
            Stop => Order::stop(start, target),
            _ => Order { start, target },
        };
        tally.run(&mut axis, request, &order, now, random);
        now += match random.bits() % 4 {
            0 => random.pick(&borders(&axis)),
            _ => axis.duration() * random.between(0.0, 1.05),
        };
        (request, _) = random.pick(&REQUESTS[1..]);
    }
}

#[test]
fn a_million_scripts_without_a_wrong_motion() {
    let mut random = Random(1);
    let mut tally = Tally::default();
    for _ in 0..SCRIPTS {
        run_script(&mut tally, &mut random);
    }
    println!("{SCRIPTS} scripts");
    tally.print();
    let first = |messages: &[String]| messages[..messages.len().min(8)].join("\n");
    assert!(
        tally.faults.is_empty(),
        "{} wrong:\n{}",
        tally.faults.len(),
        first(&tally.faults)
    );
    assert!(
        tally.differing.is_empty(),
        "{} differ from a right listing:\n{}",
        tally.differing.len(),
        first(&tally.differing)
    );
    assert!(tally.braked > 0, "no target lies a rounding short");
    assert!(
        tally.same_bits > SCRIPTS && tally.ties * 1000 < tally.same_bits,
        "hardly anything was compared"
    );
}

/// The listing's root cancels when the axis has hardly to accelerate. The ratios are higher than in the scripts, so that the
/// cancellation shows.
#[test]
fn no_seam_where_the_switching_time_cancels() {
    for [p0, v0, position, velocity, acceleration, deceleration] in [
        [-0.013582, 0.3878976, -0.013068, 1.5664192, 1e-6, 146.35174],
        [43.839, 9.1787998, 45.523747, 35.450939, 1e-6, 25.003955],
        [
            2.5e-5,
            1.3674366e-3,
            2.5000008e-5,
            4.14323e-3,
            2.338e-6,
            1.1395018e5,
        ],
    ] {
        let order = Order {
            start: State {
                position: p0,
                velocity: v0,
                ..State::default()
            },
            target: Target {
                position,
                velocity,
                acceleration,
                deceleration,
            },
        };
        let mut profile = Profile::default();
        profile.plan_corrected(order.start, order.target);
        let times = sample_times([profile.t1, profile.t2, profile.tf], &mut Random(2));
        let fault = fault(&order, &times, profile.tf, |t| profile.setpoint(t));
        assert_eq!(fault, None, "{order:?}");
    }
}

/// The stopping distance as a C program computes it. Rounding leaves such a target a little short of, or beyond, the distance in
/// which the axis stops.
#[test]
fn a_target_at_the_stopping_distance_is_reached_by_braking() {
    let mut random = Random(7);
    let mut short = 0;
    for _ in 0..300_000 {
        let start = State {
            position: random.between(-10.0, 10.0),
            velocity: random.sign() * random.between(0.1, 5.0),
            acceleration: 0.0,
        };
        let v0 = start.velocity;
        let limits = Target {
            position: 0.0,
            velocity: random.between(0.1, 10.0),
            acceleration: random.between(0.1, 10.0),
            deceleration: random.between(0.1, 10.0),
        };
        let position = start.position + v0 * v0.abs() / (2.0 * limits.deceleration);
        let target = Target { position, ..limits };
        let order = Order { start, target };
        short += usize::from(
            order.side() * order.distance() < order.stopping_distance(limits.deceleration),
        );
        let mut profile = Profile::default();
        profile.plan_corrected(start, target);
        let shortest = time_to_the_stopping_distance(v0.abs(), limits);
        assert!(
            profile.tf <= shortest * (1.0 + 1e-6),
            "{} s instead of {shortest}: {order:?}",
            profile.tf
        );
        for t in sample_times([profile.t1, profile.t2, profile.tf], &mut random) {
            let velocity = order.side() * profile.setpoint(t).velocity;
            assert!(velocity >= -1e-12, "reverses at {t}: {order:?}");
        }
    }
    assert!(short > 50_000, "hardly any target lies a rounding short");
}

/// Braking at the deceleration takes this long. An axis above its maximum velocity slows to it first, and cruises, if the
/// acceleration is the stronger rate.
fn time_to_the_stopping_distance(v0: f64, limits: Target) -> f64 {
    let Target {
        velocity: vm,
        acceleration: a,
        deceleration: d,
        ..
    } = limits;
    if v0 <= vm || a <= d {
        return v0 / d;
    }
    let cruise = 0.5 * (v0 * v0 - vm * vm) * (1.0 / d - 1.0 / a);
    (v0 - vm) / a + cruise / vm + vm / d
}
