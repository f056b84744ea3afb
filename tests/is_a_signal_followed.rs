//! Does an axis follow a signal by `track`: how near, how smoothly, and never beyond its limits?

use support::prelude::*;

const TICK: f64 = 1e-3; // s

/// `sin 2t`, with noise of these standard deviations in position, velocity and acceleration.
struct Signal {
    noise: [f64; 3],
    random: Random,
}

impl Signal {
    fn with_noise(noise: [f64; 3]) -> Self {
        Self { noise, random: Random::seeded(1) }
    }

    fn jerk(t: f64) -> f64 {
        -8.0 * (2.0 * t).cos()
    }

    fn at(&mut self, t: f64) -> State<f64> {
        let (sin, cos) = (2.0 * t).sin_cos();
        let [p, v, a] = [sin, 2.0 * cos, -4.0 * sin];
        // The sum of 12 even numbers has the variance 1.
        let mut gauss = || (0..12).map(|_| self.random.unit()).sum::<f64>() - 6.0;
        let [dp, dv, da] = self.noise.map(|sigma| sigma * gauss());
        State { position: p + dp, velocity: v + dv, acceleration: a + da }
    }
}

#[derive(Debug)]
struct Followed {
    error: f64, // the largest distance from the signal without its noise, after the first two seconds
    jerk: f64,  // the root of the mean square of the jerk in this time
}

fn follow(
    mut signal: Signal, mut plan: impl FnMut(&mut Move<f64>, &Limits<f64>, State<f64>, State<f64>, f64),
) -> Followed {
    let limits = Limits::symmetric(150.0, 15.0, 3.0);
    let (mut axis, mut now) = (Move::default(), State::at(0.5));
    let (mut error, mut squares, mut count) = (0.0_f64, 0.0, 0);
    for tick in 0..8000 {
        let t = f64::from(tick) * TICK;
        if t >= 2.0 {
            error = error.max((now.position - (2.0 * t).sin()).abs());
        }
        plan(&mut axis, &limits, now, signal.at(t), Signal::jerk(t));
        let next = axis.state_at(TICK);
        if t >= 2.0 {
            squares += ((next.acceleration - now.acceleration) / TICK).powi(2);
            count += 1;
        }
        now = next;
    }
    Followed { error, jerk: (squares / f64::from(count)).sqrt() }
}

fn track(signal: Signal, known: f64, horizon: f64) -> Followed {
    follow(signal, |axis, limits, now, signal, jerk| {
        axis.track(limits, now, signal, known * jerk, horizon).expect("a plan");
    })
}

/// An axis that does not know the jerk of the signal, 8 at most, is `8 h³/27` away at most. One that knows it is a thousandth of this away, because
/// the jerk changes in half a tick. The jerk of the signal is 5.66.
#[test]
fn a_clean_signal_is_followed_closely() {
    for horizon in [0.01_f64, 0.03, 0.06, 0.1] {
        for (known, most) in [(0.0, 1.001), (1.0, 1e-3)] {
            let followed = track(Signal::with_noise([0.0; 3]), known, horizon);
            println!("horizon {horizon} s, {known} of the jerk: {followed:?}");
            let error = most * 8.0 * horizon.powi(3) / 27.0;
            assert!(followed.error < error && followed.jerk < 5.7, "{horizon}: {followed:?}");
        }
    }
}

/// A longer horizon smooths more, as the rule in `docs/moves.md` says. A plan to the signal itself makes noise a full jerk in every tick.
#[test]
fn noise_does_not_switch_the_jerk() {
    let noise = [1e-4, 1e-2, 0.1];
    let noisy = || Signal::with_noise(noise);
    for (horizon, error) in [(0.06_f64, 3e-4), (0.1, 6e-4), (0.15, 1.2e-3)] {
        let followed = track(noisy(), 0.0, horizon);
        println!("with noise, horizon {horizon} s: {followed:?}");
        let [p, v, a] = noise;
        let shares = [27.0 * p / horizon.powi(3), 18.0 * v / horizon.powi(2), 5.5 * a / horizon, 5.66];
        let jerk = shares.iter().map(|share| share * share).sum::<f64>().sqrt();
        let is_smooth = followed.error < error && (followed.jerk / jerk - 1.0).abs() < 0.03;
        assert!(is_smooth, "{horizon}: {followed:?}, {jerk}");
    }
    let planned = follow(noisy(), |axis, limits, now, signal, _| {
        axis.plan(limits, now, signal).expect("a plan");
    });
    println!("with noise, plans to the signal: {planned:?}");
    assert!(planned.error > 0.1 && planned.jerk > 100.0);
}

/// A main loop that plans in some ticks, some ahead, follows as closely: the signal goes on until the plan takes over. A horizon that was shorter
/// than the time until then never followed.
#[test]
fn a_plan_ahead_follows_too() {
    let limits = Limits::symmetric(150.0, 15.0, 3.0);
    let mut signal = Signal::with_noise([0.0; 3]);
    for (lead, horizon, round) in [(1, 0.03, 3), (4, 0.03, 3), (10, 0.03, 3), (2, 0.0005, 2), (10, 0.003, 10)] {
        let mut axis = Axis::new(TICK, State::at(0.5)).expect("an axis");
        let (mut planner, mut ticker) = axis.split();
        let mut farthest = 0.0_f64;
        for tick in 0..8000 {
            let now = ticker.tick();
            let there = signal.at(f64::from(tick) * TICK);
            if tick >= 2000 {
                farthest = farthest.max((now.position - there.position).abs());
            }
            if tick % round == 0 {
                planner.track(&limits, there, Signal::jerk(f64::from(tick) * TICK), horizon, lead).expect("a plan");
            }
        }
        assert!(farthest < 2e-7, "{lead} ticks ahead, every {round}: {farthest}");
    }
}

/// A plan is in force for less than twice `lead` ticks. One that lasted for what was left of `lead` ended before, and the axis went on accelerating.
#[test]
fn a_plan_ahead_keeps_the_limits() {
    let limits = Limits::symmetric(1200.0, 15.0, 0.6);
    for (lead, round) in [(2, 1), (4, 3)] {
        let mut axis = Axis::new(TICK, State::at(0.0)).expect("an axis");
        let (mut planner, mut ticker) = axis.split();
        for tick in 0..600 {
            let now = ticker.tick();
            assert!(now.velocity <= 0.6 * (1.0 + 1e-12), "{lead} ticks ahead, every {round}: {now:?}");
            let (jerk, t) = (9.0, f64::from(tick) * TICK);
            let signal =
                State { position: jerk * t.powi(3) / 6.0, velocity: jerk * t * t / 2.0, acceleration: jerk * t };
            if tick % round == 0 {
                planner.track(&limits, signal, jerk, 0.0011, lead).expect("a plan");
            }
        }
    }
}

/// The signal leaves the range of binary32 within the horizon. The plan ended at an infinite acceleration, without a finding.
#[test]
fn a_plan_ends_within_the_range() {
    let limits = Limits { jmin: -8e31, ..Limits::symmetric(1.2_f32, 3.7, 1.2) };
    let from = State { acceleration: 3.0, ..State::at(1.4e36) };
    let mut planned = Move::default();
    let tracked = planned.track(&limits, from, State::at(-0.5), -1e15, 7e37);
    assert!(planned.check(&limits).is_ok(), "{tracked:?}, {planned:?}");
}

/// In binary32 a tick's way may be less than a rounding error of the position. The axis set off again and again, at full jerk.
#[test]
fn an_axis_far_from_0_comes_to_rest() {
    let limits = Limits::symmetric(3000.0_f32, 200.0, 50.0);
    for (offset, horizon) in [(200.0_f32, 0.01), (500.0, 0.005), (1000.0, 0.005), (1000.0, 0.03)] {
        for k in 0..40_u8 {
            let (mut axis, mut now, signal) = (Move::default(), State::at(offset), offset + 1.0 + 0.01 * f32::from(k));
            for tick in 0..1000 {
                axis.track(&limits, now, State::at(signal), 0.0, horizon).expect("a plan");
                now = axis.state_at(0.001);
                let error = (now.position - signal).abs();
                let rests = now.acceleration.abs() < 1e-3 && error < 10.0 * f32::EPSILON * (offset + signal);
                assert!(tick < 900 || rests, "{now:?} {signal}");
            }
        }
    }
}

/// A chase may exceed a low limit by a rounding error of high velocities. Three of these were dropped for a plan to where the signal was: it took 93 s.
#[test]
fn a_fast_signal_is_chased_from_every_velocity() {
    let limits = Limits { vmax: 0.5, vmin: -40.0, amax: 0.4, amin: -60.0, jmax: 10.0, jmin: -30.0 };
    let signal = State { velocity: -24.0, ..State::at(10.0) };
    for velocity in (0..2_000).map(|k| 0.0002 * f64::from(k)) {
        let (mut axis, from) = (Move::default(), State { position: 0.0, velocity, acceleration: -0.1 });
        axis.track(&limits, from, signal, 0.0, 0.01).expect("a plan");
        assert!(axis.t < 11.0, "{velocity}: {} s", axis.t);
    }
}

const UNEQUAL: Limits<f64> = Limits { vmax: 3.0, vmin: -2.0, amax: 15.0, amin: -12.0, jmax: 150.0, jmin: -75.0 };

/// A loop that comes late leaves the axis within its limits: far from a signal that accelerates, a plan ends with a stop.
#[test]
fn a_late_loop_keeps_the_limits() {
    let mut axis = Move::default();
    let places = [-5.0, -0.5, 0.5, 5.0];
    let all = [Limits::symmetric(150.0, 15.0, 3.0), UNEQUAL];
    for (limits, position) in all.into_iter().flat_map(|limits| places.map(|position| (limits, position))) {
        let signal = State { position, velocity: 1.0, acceleration: 2.0 };
        axis.track(&limits, State::at(0.0), signal, -3.0, 0.05).expect("a plan");
        let late = axis.state_at(60.0);
        assert_eq!((late.velocity, late.acceleration), (0.0, 0.0), "{position}");
    }
}

/// A signal that makes a step is met again, and one that is too fast is followed with the highest velocity.
#[test]
fn a_far_or_fast_signal_is_followed_as_well_as_can_be() {
    for limits in &[Limits::symmetric(150.0, 15.0, 3.0), UNEQUAL] {
        let (mut axis, mut now) = (Move::default(), State::at(0.0));
        for tick in 0..4000 {
            let step = if tick < 1000 { 0.0 } else { 2.0 };
            axis.track(limits, now, State::at(step), 0.0, 0.05).expect("a plan");
            now = axis.state_at(TICK);
            assert!(now.velocity <= 3.0 * (1.0 + 1e-12));
        }
        assert!((now.position - 2.0).abs() < 1e-7 && now.velocity.abs() < 1e-7, "{now:?}");
        for velocity in [3.0, 5.0, -1e3] {
            for tick in 0..3000 {
                let signal = State { position: 2.0 + velocity * f64::from(tick) * TICK, velocity, acceleration: 0.0 };
                axis.track(limits, now, signal, 0.0, 0.05).expect("a plan");
                now = axis.state_at(TICK);
            }
            let fastest = if velocity > 0.0 { limits.vmax } else { limits.vmin };
            assert!((now.velocity - fastest).abs() < 1e-6, "{velocity}: {now:?}");
            now = State::at(2.0);
        }
    }
}

/// The plan of a chase ends on a signal that cruises. Nobody knows what another signal does after the horizon, so its plan ends at rest.
#[test]
fn a_chase_ends_on_the_signal_or_at_rest() {
    let signal = State { position: 2.0, velocity: 1.0, acceleration: 0.0 };
    for (jerk, end) in [(0.0, 1.0), (1e-9, 0.0)] {
        let mut axis = Move::<f64>::default();
        axis.track(&Limits::symmetric(150.0, 15.0, 3.0), State::at(0.0), signal, jerk, 0.05).expect("a plan");
        let last: State<f64> = axis.state_at(axis.t);
        assert!((last.velocity - end).abs() < 1e-12, "{last:?}");
        assert_eq!((last.position - 2.0 - axis.t).abs() < 1e-12, jerk == 0.0, "{last:?}");
    }
}

/// The limits differ each way, and the axis stands on its signal or moves with it: it stays there. It stood next to it for ever, and turned back
/// before one at its highest velocity.
#[test]
fn an_axis_stays_on_a_signal_that_stands_or_cruises() {
    let limits = Limits { vmin: -3.0, amin: -15.0, ..UNEQUAL };
    for (velocity, most) in [(0.0, 1e-13), (1.0, 1e-13), (-2.5, 1e-13), (3.0, 1e-3), (-3.0, 1e-3)] {
        let (mut axis, mut now) = (Move::default(), State { velocity, ..State::at(0.0) });
        for tick in 0..2000 {
            let position = velocity * f64::from(tick) * TICK;
            let signal = State { position, velocity, acceleration: 0.0 };
            let error = (now.position - position).abs();
            assert!(error < most, "{error} at {tick}");
            axis.track(&limits, now, signal, 0.0, 0.1).expect("a plan");
            now = axis.state_at(TICK);
        }
    }
}

/// `amplitude sin(w t + phase)`
struct Sine {
    amplitude: f64,
    w: f64,
    phase: f64,
}

impl Sine {
    /// A sine that needs this share of one of the limits, and at most as much of the others.
    fn within(limits: &Limits<f64>, need: f64, w: f64, phase: f64) -> Self {
        let [v, a, j] = [(limits.vmax, limits.vmin), (limits.amax, limits.amin), (limits.jmax, limits.jmin)]
            .map(|(x, y)| x.min(-y));
        Self { amplitude: need * (v / w).min(a / w.powi(2)).min(j / w.powi(3)), w, phase }
    }

    fn at(&self, t: f64) -> (State<f64>, f64) {
        let Self { amplitude, w, phase } = *self;
        let (sin, cos) = (w * t + phase).sin_cos();
        let (v, a) = (amplitude * w * cos, -amplitude * w * w * sin);
        (State { position: amplitude * sin, velocity: v, acceleration: a }, -w * w * v)
    }

    /// The largest distance in the last quarter of the time, in amplitudes. The axis keeps the limits in every tick.
    fn followed(&self, limits: &Limits<f64>, mut now: State<f64>, horizon: f64, time: f64) -> f64 {
        let (mut axis, mut error) = (Move::default(), 0.0_f64);
        let ticks = (time / TICK) as u32;
        for tick in 0..ticks {
            let (signal, jerk) = self.at(f64::from(tick) * TICK);
            if tick > ticks - ticks / 4 {
                error = error.max((now.position - signal.position).abs());
            }
            axis.track(limits, now, signal, jerk, horizon).expect("a plan");
            let next = axis.state_at(TICK);
            let [v, a, j] = [next.velocity, next.acceleration, (next.acceleration - now.acceleration) / TICK];
            let mut needs = [v, v, a, a, j, j].into_iter().zip(online::numbers_of(limits)).map(|(x, limit)| x / limit);
            assert!(needs.all(|need| need < 1.0 + 1e-9), "{v} {a} {j} {limits:?}");
            now = next;
        }
        error / self.amplitude
    }
}

/// Sines that need up to 80 % of the tightest limit are caught, whatever the axis does at first. The limits differ each way in half of them.
#[test]
fn a_signal_within_the_limits_is_caught() {
    let never_caught = Sine { amplitude: 0.4, w: 3.25, phase: 0.0 };
    let error = never_caught.followed(&Limits::symmetric(25.0, 7.5, 3.5), State::at(0.0), 0.1, 20.0);
    assert!(error < 1e-3, "{error}");
    let mut random = Random::seeded(5);
    let mut worst = 0.0_f64;
    for k in 0..400 {
        let v = random.magnitude(0.0, 1.0);
        let a = v * random.magnitude(0.3, 1.0);
        let j = a * random.magnitude(0.5, 1.5);
        let mut wider = |limit: f64| limit * if k % 2 == 0 { 1.0 } else { random.between(1.0, 3.0) };
        let [vmax, vmin, amax, amin, jmax, jmin] = [v, -v, a, -a, j, -j].map(&mut wider);
        let limits = Limits { vmax, vmin, amax, amin, jmax, jmin };
        let (w, phase) = (random.magnitude(-0.3, 0.8), random.between(0.0, 6.3));
        let sine = Sine::within(&limits, random.between(0.1, 0.8), w, phase);
        let start = State::at(random.between(-5.0, 5.0) * sine.amplitude);
        let error = sine.followed(&limits, start, random.magnitude(-1.7, -0.82), 4.0 * std::f64::consts::TAU / w);
        worst = worst.max(error);
        assert!(error < 0.05, "{k}: {error} amplitudes, {limits:?}");
    }
    println!("the farthest of 400 axes: {worst:.1e} amplitudes");
}

/// Any signal gets a motion that goes on from the state of the axis, keeps the limits and makes no step.
fn any_signal_is_followed<R: Real>() {
    let mut random = Random::seeded(3);
    let mut on_time = 0;
    for _ in 0..4_000 {
        let limits = online::limits::<R>(&mut random);
        let from = online::anywhere(&mut random, &limits);
        let horizon = R::of(random.magnitude(-4.0, 1.0));
        let mut any = |most: f64| R::of(random.sign() * random.magnitude(-3.0, most));
        // Near the axis, or anywhere.
        let signal = State { position: from.position + any(1.0), velocity: any(2.0), acceleration: any(3.0) };
        let jerk = any(3.0);
        let jerk = if random.one_in(2) { R::ZERO } else { jerk };
        let signal = if random.one_in(2) { from } else { signal };
        let mut axis = Move::default();
        let what = format!("{limits:?} {from:?} {signal:?} {jerk:?} {horizon:?}");
        let found = axis.track(&limits, from, signal, jerk, horizon).expect(&what);
        assert!(axis.t >= R::ZERO && axis.t.widen().is_finite(), "{what}");
        if axis.t > R::ZERO {
            assert_eq!(axis.state_at(R::ZERO), from, "{what}");
        }
        let checked = axis.check(&limits).expect("an answer");
        assert!(online::allowed(found).contains(checked), "{checked:?} {what}");
        on_time += u32::from(axis.t == horizon);
    }
    assert!(on_time > 400, "{on_time}");
}

test_both_reals!(any_signal_is_followed);
