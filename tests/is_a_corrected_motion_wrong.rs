//! Is any motion of a million random scripts wrong in corrected mode?
//!
//! The definition of a wrong motion knows nothing of how a profile is planned. The listing plans the same moves, for comparison.
//!
//! `cargo test --test is_a_corrected_motion_wrong -- --nocapture` prints the shares of wrong motions.

use approx::abs_diff_eq;
use atraj::claraty::{EPS, Mode, Target, Trajectory, Warnings};
use std::collections::BTreeMap;
use support::claraty::{borders, corrected, moving, target};
use support::prelude::*;
use support::real::just_after;

const SCRIPTS: usize = if support::BRIEF { 100_000 } else { 1_000_000 };

/// The highest ratio of acceleration and deceleration. Far higher ratios show the cancellation in the listing's formulas.
const RATIO: f64 = 1e6;
const LOWEST_RATE: f64 = 1e-9; // above `EPS`, so that no rate is raised

/// What a script asks of the axis: the first move, then any of the others. The outcomes of each request are counted apart.
const REQUESTS: [&str; 11] = [
    "first move from rest", "retarget anywhere", "retarget to a point behind", "retarget too near to stop",
    "retarget at the stopping distance", "tiny retarget", STOP, "maximum velocity raised", "maximum velocity lowered",
    "maximum velocity as now", "acceleration and deceleration changed",
];
const STOP: &str = "stop";

fn stopping_distance(velocity: f64, rate: f64) -> f64 {
    0.5 * velocity * velocity / rate
}

fn near(x: f64, y: f64, rounding: f64) -> bool {
    abs_diff_eq!(x, y, epsilon = rounding)
}

#[derive(Clone, Copy, Debug)]
struct Order {
    start: State<f64>,
    target: Target,
}

impl Order {
    /// A stop is the order to go as far as the axis goes while it brakes.
    fn stop(start: State<f64>, mut target: Target) -> Self {
        let v0 = start.velocity;
        target.position = start.position + 0.5 * v0 * v0.abs() / target.deceleration;
        target.velocity = v0.abs();
        Self { start, target }
    }

    fn distance(&self) -> f64 {
        self.target.position - self.start.position
    }

    fn side(&self) -> f64 {
        f64::signum(if self.start.velocity == 0.0 { self.distance() } else { self.start.velocity })
    }

    fn ahead(&self) -> f64 {
        self.side() * self.distance()
    }

    fn stopping_distances(&self) -> [f64; 2] {
        [self.target.acceleration, self.target.deceleration].map(|rate| stopping_distance(self.start.velocity, rate))
    }

    fn top_speed(&self) -> f64 {
        self.start.velocity.abs().max(self.target.velocity)
    }

    /// What `f64` adds to a position: half an ulp of itself, and half an ulp of the duration at the top speed.
    fn rounding(&self, duration: f64) -> f64 {
        let ends = self.start.position.abs() + self.target.position.abs();
        1e-14 * ends + self.top_speed() * time_rounding(duration)
    }

    /// Whether the target is within rounding of a stopping distance, so two motions are right.
    fn is_tie(&self, duration: f64) -> bool {
        let rounding = self.rounding(duration);
        let mut ways = self.stopping_distances().into_iter();
        ways.any(|way| near(self.ahead(), way, 1e-9 * way + rounding))
    }
}

fn time_rounding(duration: f64) -> f64 {
    4.0 * f64::EPSILON * duration
}

fn sample_times([t1, t2, tf]: [f64; 3], random: &mut Random) -> Vec<f64> {
    let mut times = vec![0.0];
    times.extend([t1, t2, tf].iter().flat_map(|&t| [t, just_after(t)]));
    times.extend((0..6).map(|_| random.between(0.0, tf)));
    times.retain(|&t| t >= 0.0 && t <= tf);
    times.sort_by(f64::total_cmp);
    times
}

/// What is wrong with a motion, judged from its setpoints alone, if something is. No phase border lies between two times.
fn check(
    order: &Order, times: &[f64], duration: f64, mut at: impl FnMut(f64) -> State<f64>,
) -> Result<(), &'static str> {
    all_of([(duration >= 0.0 && duration.is_finite(), "no duration")])?;
    let Order { start, target } = *order;
    let rates = [target.acceleration, target.deceleration];
    let (side, ahead, ways) = (order.side(), order.ahead(), order.stopping_distances());
    let (top_speed, rounding) = (order.top_speed(), order.rounding(duration));
    let avoidable = ahead >= ways[0].min(ways[1]) * (1.0 + 1e-9) + rounding;
    let farthest = ahead.max(if avoidable { ahead } else { ways[0] });
    let dp = 1e-9 * farthest.max(ahead.abs()) + rounding;
    let dv = 1e-9 * top_speed + rates[0].max(rates[1]) * time_rounding(duration);
    let is_allowed = |position: f64| {
        let way = side * (position - start.position);
        ahead.min(0.0) - dp <= way && way <= farthest + dp
    };
    let (mut before, mut then) = (start, 0.0);
    for &t in times {
        let (now, passed) = (at(t), t - then);
        let (v, a) = (now.velocity, now.acceleration);
        let position = before.position + 0.5 * (before.velocity + v) * passed;
        let turns = before.velocity * v < 0.0;
        let turning = before.position - 0.5 * before.velocity * before.velocity / a;
        let is_turn_allowed = !turns || is_allowed(turning);
        all_of([
            (near(now.position, position, dp), "position jumps"),
            (near(v, before.velocity + a * passed, dv), "velocity jumps"),
            (v.abs() <= top_speed + dv, "too fast"),
            (a == 0.0 || rates.contains(&a.abs()), "another acceleration"),
            (!avoidable || side * v >= -dv, "needless turn"),
            (is_allowed(now.position) && is_turn_allowed, "overshoot"),
        ])?;
        (before, then) = (now, t);
    }
    let rest = at(just_after(duration));
    let is_near = |position| near(position, rest.position, dp);
    let is_slow = before.velocity.abs() <= dv;
    all_of([
        (rest == State::at(rest.position), "does not end at rest"),
        (is_near(target.position), "ends elsewhere"),
        (is_near(before.position) && is_slow, "jumps to rest"),
    ])
}

fn all_of<const N: usize>(checks: [(bool, &'static str); N]) -> Result<(), &'static str> {
    checks.into_iter().find(|(right, _)| !right).map_or(Ok(()), |(_, fault)| Err(fault))
}

#[derive(Default)]
struct Tally {
    /// Of each request: all motions, the wrong corrected ones, the wrong ones of the listing.
    shares: BTreeMap<&'static str, [usize; 3]>,
    faults: Vec<String>,
    same_bits: usize,
    braked: usize, // ties in which the corrected motion arrives before the listing's
    ties: usize,
    differing: Vec<String>,
}

impl Tally {
    /// Plans one order in both modes from the same state of `axis`, and leaves `axis` on the corrected motion.
    fn run(&mut self, axis: &mut Trajectory, (request, order): (&'static str, &Order), now: f64, random: &mut Random) {
        let mut listed = *axis;
        listed.set_mode(Mode::Listing);
        let share = self.shares.entry(request).or_default();
        share[0] += 1;
        let mut all_times = vec![];
        let [wrong, listing_wrong] = [&mut *axis, &mut listed].map(|axis| {
            let warnings = if request == STOP { axis.stop(now) } else { axis.start(now) };
            let times = sample_times(borders(axis.profile()), random);
            let fault = check(order, &times, axis.duration(), |t| axis.setpoint_at(t)).err();
            all_times.push(times);
            warnings.contains(Warnings::SWITCH).then_some("gave up").or(fault)
        });
        if let Some(fault) = wrong {
            share[1] += 1;
            self.faults.push(format!("{request}: {fault}: {order:?}"));
        }
        if listing_wrong.is_some() {
            share[2] += 1;
        } else {
            self.compare(axis, &mut listed, &all_times[0], (request, order));
        }
    }

    /// Compares a corrected motion with a right motion of the listing. The bits must be the same, except in moves below `EPS`,
    /// in the acceleration at the first instant of a stop, and in ties.
    fn compare(
        &mut self, axis: &mut Trajectory, listed: &mut Trajectory, times: &[f64], (request, order): (&str, &Order),
    ) {
        if request != STOP && order.distance().abs() < EPS {
            return;
        }
        let [ends, listed_ends] = [&*axis, &*listed].map(|axis| borders(axis.profile()));
        let mut same = ends.into_iter().zip(listed_ends).all(|(x, y)| x.same(y));
        for &t in times {
            let (x, y) = (axis.setpoint_at(t), listed.setpoint_at(t));
            let is_first_of_stop = request == STOP && t == 0.0;
            same &= x.position.same(y.position) && x.velocity.same(y.velocity);
            same &= is_first_of_stop || x.acceleration.same(y.acceleration);
        }
        let [tf, listed_tf] = [axis.duration(), listed.duration()];
        if same {
            self.same_bits += 1;
        } else if !order.is_tie(tf.max(listed_tf)) {
            let [profile, listing] = [axis.profile(), listed.profile()];
            let plans = format!("corrected {profile:?}\n  listing   {listing:?}");
            self.differing.push(format!("{request}: {order:?}\n  {plans}"));
        } else if tf < listed_tf {
            self.braked += 1;
        } else {
            self.ties += 1;
        }
    }

    fn print(&self) {
        println!("{:40} {:>9} corrected wrong  listing wrong", "", "motions");
        for (request, [motions, wrong, listing_wrong]) in REQUESTS.map(|request| (request, self.shares[request])) {
            let percent = 100.0 * listing_wrong as f64 / motions as f64;
            println!("{request:40} {motions:9} {wrong:15} {percent:13.2}%");
        }
        let (same, differing) = (self.same_bits, self.differing.len());
        println!("where the listing is right: {same} with its bits, {differing} differing,");
        println!("{} at a stopping distance, where two motions are right;", self.ties);
        println!("{} more, where the corrected motion arrives first", self.braked);
    }
}

fn random_limits(random: &mut Random) -> Target {
    let acceleration = random.magnitude(-3.0, 3.0);
    let ratio = match random.bits() % 4 {
        0 => 1.0,
        1 => random.magnitude(-6.0, 6.0),
        _ => random.magnitude(-0.7, 0.7),
    };
    target([0.0, random.magnitude(-3.0, 3.0), acceleration, acceleration * ratio])
}

fn next_target(request: &str, state: State<f64>, mut next: Target, random: &mut Random) -> Target {
    // The axis reaches the maximum velocity and stops again in this distance.
    let length = 0.5 * next.velocity * next.velocity * (1.0 / next.acceleration + 1.0 / next.deceleration);
    let velocity = state.velocity;
    let side = if velocity == 0.0 { random.sign() } else { velocity.signum() };
    let mut go = |distance: f64| next.position = state.position + distance;
    match request {
        "first move from rest" | "retarget anywhere" => go(random.sign() * length * random.magnitude(-3.0, 2.0)),
        "retarget to a point behind" => go(-side * length * random.magnitude(-6.0, 1.0)),
        "retarget too near to stop" => {
            let weaker = next.acceleration.min(next.deceleration);
            go(side * stopping_distance(velocity, weaker) * random.between(0.0, 1.0));
        }
        "retarget at the stopping distance" => {
            let weaker = random.magnitude(-6.0, 0.0);
            next.acceleration *= random.pick(&[1.0, weaker]);
            let rate = random.pick(&[next.acceleration, next.deceleration]);
            let close = random.magnitude(-16.0, -3.0);
            let beyond = random.sign() * random.pick(&[0.0, 1e-16, close]);
            go(side * stopping_distance(velocity, rate) * (1.0 + beyond));
        }
        "tiny retarget" => go(random.sign() * length * random.magnitude(-14.0, -6.0)),
        STOP => {}
        "maximum velocity raised" => next.velocity *= random.magnitude(0.0, 2.0),
        "maximum velocity lowered" => next.velocity *= random.magnitude(-2.0, 0.0),
        "maximum velocity as now" => {
            next.velocity = velocity.abs().max(1e-6);
            go(random.sign() * length * random.magnitude(-3.0, 1.0));
        }
        "acceleration and deceleration changed" => {
            next.acceleration *= random.magnitude(-1.0, 1.0);
            next.deceleration *= random.magnitude(-1.0, 1.0);
        }
        _ => unreachable!("{request}"),
    }
    next.acceleration = next.acceleration.max(LOWEST_RATE);
    let ratio = (next.deceleration / next.acceleration).clamp(1.0 / RATIO, RATIO);
    next.deceleration = (next.acceleration * ratio).max(LOWEST_RATE);
    next
}

fn run_script(tally: &mut Tally, random: &mut Random) {
    let mut now = 0.0;
    let mut axis = Trajectory::new(Mode::Corrected, now);
    let mut target = random_limits(random);
    let mut request = REQUESTS[0];
    for _ in 0..1 + random.bits() % 4 {
        let setpoint = axis.setpoint(now);
        let start = if axis.is_started() { setpoint } else { State::default() };
        if request == STOP && !axis.is_started() {
            request = "retarget anywhere";
        }
        target = next_target(request, start, target, random);
        axis.set(target.into(), now).unwrap();
        let order = if request == STOP { Order::stop(start, target) } else { Order { start, target } };
        tally.run(&mut axis, (request, &order), now, random);
        now += match random.bits() % 4 {
            0 => random.pick(&borders(axis.profile())),
            _ => axis.duration() * random.between(0.0, 1.05),
        };
        request = random.pick(&REQUESTS[1..]);
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
    for (what, all) in [("wrong", &tally.faults), ("differ from a right listing", &tally.differing)] {
        let first = &all[..all.len().min(8)];
        assert!(all.is_empty(), "{} {what}:\n{}", all.len(), first.join("\n"));
    }
    assert!(tally.braked > 0, "the corrected motion never arrives first");
    assert!(tally.same_bits > SCRIPTS && tally.ties * 1000 < tally.same_bits, "hardly anything was compared");
}

/// The listing's root cancels when the axis has hardly to accelerate. The ratios are higher than in the scripts, so that the cancellation shows.
#[test]
fn no_seam_where_the_switching_time_cancels() {
    let moves = [
        ([-0.013582, 0.3878976], [-0.013068, 1.5664192, 1e-6, 146.35174]),
        ([43.839, 9.1787998], [45.523747, 35.450939, 1e-6, 25.003955]),
        ([2.5e-5, 1.3674366e-3], [2.5000008e-5, 4.14323e-3, 2.338e-6, 1.1395018e5]),
    ];
    for ([position, velocity], numbers) in moves {
        let (start, target) = (moving(position, velocity), target(numbers));
        let order = Order { start, target };
        let (profile, _) = corrected(start, target);
        let times = sample_times(borders(&profile), &mut Random(2));
        assert_eq!(check(&order, &times, profile.tf, |t| profile.setpoint(t)), Ok(()), "{order:?}");
    }
}

/// The stopping distance as a C program computes it: the target is a rounding short of the distance in which the axis stops, or beyond.
#[test]
fn a_target_at_the_stopping_distance_is_reached_by_braking() {
    let mut random = Random(7);
    let mut short = 0;
    for _ in 0..300_000 {
        let start = moving(random.between(-10.0, 10.0), random.sign() * random.between(0.1, 5.0));
        let v0 = start.velocity;
        let [vm, a, d] = [(); 3].map(|()| random.between(0.1, 10.0));
        let target = target([start.position + v0 * v0.abs() / (2.0 * d), vm, a, d]);
        let order = Order { start, target };
        short += usize::from(order.ahead() < stopping_distance(v0, d));
        let (profile, _) = corrected(start, target);
        let (tf, shortest) = (profile.tf, time_to_the_stopping_distance(v0.abs(), [vm, a, d]));
        assert!(tf <= shortest * (1.0 + 1e-6), "{tf} s instead of {shortest}: {order:?}");
        for t in sample_times(borders(&profile), &mut random) {
            assert!(order.side() * profile.setpoint(t).velocity >= -1e-12, "reverses at {t}: {order:?}");
        }
    }
    assert!(short > 50_000, "hardly any target lies a rounding short");
}

/// Braking at the deceleration takes this long. An axis above its maximum velocity slows to it first, and cruises, if the
/// acceleration is the stronger rate.
fn time_to_the_stopping_distance(v0: f64, [vm, a, d]: [f64; 3]) -> f64 {
    if v0 <= vm || a <= d {
        return v0 / d;
    }
    let cruise = 0.5 * (v0 * v0 - vm * vm) * (1.0 / d - 1.0 / a);
    (v0 - vm) / a + cruise / vm + vm / d
}
