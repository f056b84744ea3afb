//! Does an axis follow a signal by `track`: how near, how smoothly, and never beyond its limits?

use atraj::machine::Axis;
use atraj::online::{Error, Limits, Move};
use atraj::{Findings, State};
use support::{Random, Real, online, test_both_reals};

const TICK: f64 = 1e-3; // s

/// `sin 2t`, with noise of these standard deviations in position, velocity and acceleration.
struct Signal {
    noise: [f64; 3],
    random: Random,
}

impl Signal {
    fn with_noise(noise: [f64; 3]) -> Self {
        let random = Random::seeded(1);
        Self { noise, random }
    }

    /// The sum of 12 even numbers has the variance 1.
    fn gauss(&mut self) -> f64 {
        (0..12).map(|_| self.random.unit()).sum::<f64>() - 6.0
    }

    fn at(&mut self, t: f64) -> State<f64> {
        let (sin, cos) = (2.0 * t).sin_cos();
        let [p, v, a] = [sin, 2.0 * cos, -4.0 * sin];
        let [dp, dv, da] = self.noise.map(|sigma| sigma * self.gauss());
        State {
            position: p + dp,
            velocity: v + dv,
            acceleration: a + da,
        }
    }
}

/// What an axis does behind a signal.
#[derive(Debug)]
struct Followed {
    /// The largest distance from the signal without its noise, after the first two seconds.
    error: f64,
    /// The root of the mean square of the jerk in this time.
    jerk: f64,
}

/// Follows for 8 s within the limits 3, 15 and 150.
fn follow(
    mut signal: Signal,
    mut plan: impl FnMut(&mut Move<f64>, &Limits<f64>, State<f64>, State<f64>),
) -> Followed {
    let limits = Limits::symmetric(150.0, 15.0, 3.0);
    let (mut axis, mut now) = (Move::default(), State::at(0.5));
    let (mut error, mut squares, mut count) = (0.0_f64, 0.0, 0);
    for tick in 0..8000 {
        let t = f64::from(tick) * TICK;
        if t >= 2.0 {
            error = error.max((now.position - (2.0 * t).sin()).abs());
        }
        plan(&mut axis, &limits, now, signal.at(t));
        let next = axis.state_at(TICK);
        if t >= 2.0 {
            squares += ((next.acceleration - now.acceleration) / TICK).powi(2);
            count += 1;
        }
        now = next;
    }
    let jerk = (squares / f64::from(count)).sqrt();
    Followed { error, jerk }
}

fn track(signal: Signal, horizon: f64) -> Followed {
    follow(signal, |axis, limits, now, signal| {
        axis.track(limits, now, signal, horizon).expect("a plan");
    })
}

/// The distances grow with the third power of a short horizon. The jerk of the signal is 5.66.
#[test]
fn a_clean_signal_is_followed_closely() {
    for (horizon, error) in [
        (0.01, 2.6e-7),
        (0.03, 6.9e-6),
        (0.06, 5.5e-5),
        (0.1, 2.6e-4),
    ] {
        let followed = track(Signal::with_noise([0.0; 3]), horizon);
        println!("horizon {horizon} s: {followed:?}");
        assert!(
            followed.error < error && followed.jerk < 5.7,
            "{horizon}: {followed:?}"
        );
    }
}

/// A longer horizon smooths more. A plan to the signal itself makes noise a full jerk in every tick.
#[test]
fn noise_does_not_switch_the_jerk() {
    let noisy = || Signal::with_noise([1e-4, 1e-2, 0.1]);
    let rows = [(0.06, 3e-4, 55.0), (0.1, 6e-4, 20.0), (0.15, 1.2e-3, 10.0)];
    for (horizon, error, jerk) in rows {
        let followed = track(noisy(), horizon);
        println!("with noise, horizon {horizon} s: {followed:?}");
        let is_smooth = followed.error < error && followed.jerk < jerk;
        assert!(is_smooth, "{horizon}: {followed:?}");
    }
    let planned = follow(noisy(), |axis, limits, now, signal| {
        axis.plan(limits, now, signal).expect("a plan");
    });
    println!("with noise, plans to the signal: {planned:?}");
    assert!(planned.error > 0.1 && planned.jerk > 100.0);
}

/// A main loop that plans in every third tick, some ticks ahead, follows nearly as closely as one that plans for the very tick: the signal
/// goes on until the plan takes over.
#[test]
fn a_plan_ahead_follows_too() {
    let limits = Limits::symmetric(150.0, 15.0, 3.0);
    let mut signal = Signal::with_noise([0.0; 3]);
    for (lead, error) in [(1, 1e-5), (4, 4e-5), (10, 4e-5)] {
        let mut axis = Axis::new(TICK, State::at(0.5)).expect("an axis");
        let mut farthest = 0.0_f64;
        for tick in 0..8000 {
            let now = axis.tick();
            let there = signal.at(f64::from(tick) * TICK);
            if tick >= 2000 {
                farthest = farthest.max((now.position - there.position).abs());
            }
            if tick % 3 == 0 {
                axis.track(&limits, there, 0.03, lead).expect("a plan");
            }
        }
        println!("{lead} ticks ahead: {farthest:.1e}");
        assert!(farthest < error, "{lead}: {farthest}");
    }
}

/// A signal that makes a step is met again, and one that is too fast is followed with the highest velocity.
#[test]
fn a_far_or_fast_signal_is_followed_as_well_as_can_be() {
    let limits = Limits::symmetric(150.0, 15.0, 3.0);
    let (mut axis, mut now) = (Move::default(), State::at(0.0));
    for tick in 0..4000 {
        let step = if tick < 1000 { 0.0 } else { 2.0 };
        axis.track(&limits, now, State::at(step), 0.05)
            .expect("a plan");
        now = axis.state_at(TICK);
        assert!(now.velocity <= 3.0 * (1.0 + 1e-12));
    }
    assert!(
        (now.position - 2.0).abs() < 1e-7 && now.velocity.abs() < 1e-7,
        "{now:?}"
    );
    for velocity in [3.0, 5.0, -1e3] {
        for tick in 0..3000 {
            let position = 2.0 + velocity * f64::from(tick) * TICK;
            let signal = State {
                position,
                velocity,
                acceleration: 0.0,
            };
            axis.track(&limits, now, signal, 0.05).expect("a plan");
            now = axis.state_at(TICK);
        }
        assert!(
            (now.velocity - 3.0_f64.copysign(velocity)).abs() < 1e-6,
            "{velocity}: {now:?}"
        );
        now = State::at(2.0);
    }
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
        let signal = State {
            position: from.position + any(1.0),
            velocity: any(2.0),
            acceleration: any(3.0),
        };
        let signal = if random.one_in(2) { from } else { signal };
        let mut axis = Move::default();
        let what = format!("{limits:?} {from:?} {signal:?} {horizon:?}");
        let found = axis.track(&limits, from, signal, horizon).expect(&what);
        assert!(axis.t >= R::of(0.0) && axis.t.widen().is_finite(), "{what}");
        if axis.t > R::of(0.0) {
            assert_eq!(axis.state_at(R::of(0.0)), from, "{what}");
        }
        let checked = axis.check(&limits).expect("an answer");
        let excess = Findings::EXCEEDS_VELOCITY | Findings::EXCEEDS_ACCELERATION;
        let ends = Findings::OVERSHOOTS | Findings::STARTS_OUTSIDE | Findings::ENDS_LEAVING;
        let allowed = if found.contains(Findings::STARTS_OUTSIDE) {
            ends | excess
        } else {
            ends
        };
        assert!(allowed.contains(checked), "{checked:?} {what}");
        on_time += u32::from(axis.t == horizon);
    }
    assert!(on_time > 400, "{on_time}");
}

test_both_reals!(any_signal_is_followed);

fn bad_input_is_refused<R: Real>() {
    let limits = Limits::symmetric(R::of(30.0), R::of(10.0), R::of(5.0));
    let (zero, one) = (R::of(0.0), R::of(1.0));
    let state = State {
        position: one,
        velocity: one,
        acceleration: one,
    };
    let refused = |limits: &Limits<R>, from, signal, horizon| {
        let before = Move {
            t: R::of(-1.0),
            ..Move::default()
        };
        let mut axis = before;
        let error = axis
            .track(limits, from, signal, horizon)
            .expect_err("an error");
        assert_eq!(axis, before);
        error
    };
    for horizon in [0.0, -0.0, -1.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let error = refused(&limits, state, state, R::of(horizon));
        assert_eq!(error, Error::Duration, "{horizon}");
    }
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let bad = R::of(bad);
        let states = [
            State {
                position: bad,
                ..state
            },
            State {
                velocity: bad,
                ..state
            },
            State {
                acceleration: bad,
                ..state
            },
        ];
        for bad in states {
            assert_eq!(refused(&limits, bad, state, one), Error::NotFinite);
            assert_eq!(refused(&limits, state, bad, one), Error::NotFinite);
        }
    }
    let no_limits = Limits {
        vmax: zero,
        ..limits
    };
    assert_eq!(refused(&no_limits, state, state, one), Error::Limits);
}

test_both_reals!(bad_input_is_refused);
