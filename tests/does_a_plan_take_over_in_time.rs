//! Does a plan of an axis take over in its own tick? The package `handover` asks it of every place where an interrupt may come.

use atraj::machine::{Axis, Ticker};
use atraj::online::{Error, Limits, State};
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;
use support::{Random, online};

/// From the tick of its takeover on, the axis has the states of the move that is planned from there.
#[test]
fn in_its_own_tick() {
    const PERIOD: f64 = 1e-3;
    let limits = Limits::symmetric(30.0, 10.0, 5.0);
    let (start, target) = (State::at(1.0), State::at(2.0));
    let mut axis = Axis::new(PERIOD, start).expect("a period");
    let (mut planner, mut ticker) = axis.split();
    assert_eq!(planner.go(&limits, target, 0), Err(Error::Late));
    planner.go(&limits, target, 3).expect("a plan");
    let planned = online::plan(&limits, start, target);
    let ticks = [(); 300].map(|()| ticker.tick());
    let expected = |tick: usize| planned.state_at(PERIOD * tick.saturating_sub(2) as f64);
    for (tick, state) in ticks.into_iter().enumerate() {
        assert_eq!(state, expected(tick), "{tick}");
    }
    planner.stop(&limits, 2).expect("a stop");
    let stop = online::stop(&limits, expected(301));
    let ticks = [ticker.tick(), ticker.tick(), ticker.tick()];
    let on = |tick: f64| stop.state_at(PERIOD * tick);
    assert_eq!(ticks, [expected(300), on(0.0), on(1.0)]);
}

const TICK: f64 = 1e-3;
const LAST: State<f64> = State { position: 1.0, velocity: 0.0, acceleration: 0.0 };

/// Ticks as fast as it can until the plans are over, and then until the axis is at its last target. While the planner's thread waits, an axis at a
/// velocity goes far, so this may take many ticks. Gives how many setpoints jumped, and the last one.
fn follow(ticker: &mut Ticker<f64>, limits: Limits<f64>, is_over: &AtomicBool) -> (u32, State<f64>) {
    let (mut jumps, mut before, mut left) = (0, ticker.tick(), 1_000_000_000);
    while left > 0 {
        let now = ticker.tick();
        let jump = (now.acceleration - before.acceleration).abs();
        jumps += u32::from(jump > 1.001 * limits.jmax * TICK);
        let moved = now.position - before.position - 0.5 * TICK * (now.velocity + before.velocity);
        jumps += u32::from(moved.abs() > limits.jmax * TICK * TICK * TICK);
        before = now;
        if is_over.load(Ordering::Acquire) {
            left = if now == LAST { 0 } else { left - 1 };
        }
    }
    (jumps, before)
}

/// The halves of an axis are in two threads, without unsafe code: one plans at random, and the other one sees no setpoint that jumps.
#[test]
fn the_halves_are_in_two_threads() {
    let limits = Limits::symmetric(30.0, 10.0, 5.0);
    let mut axis = Axis::new(TICK, State::at(0.0)).expect("a period");
    let (mut planner, mut ticker) = axis.split();
    let is_over = AtomicBool::new(false);
    let (jumps, last, accepted) = thread::scope(|scope| {
        let follower = scope.spawn(|| follow(&mut ticker, limits, &is_over));
        let (mut random, mut accepted) = (Random::seeded(38), 0);
        for _ in 0..100_000 {
            let target = State::at(random.between(-10.0, 10.0));
            let answer = match random.below(8) {
                0 => planner.stop(&limits, 200),
                1 => planner.reach(&limits, random.between(-5.0, 5.0), 0.0, 200),
                _ => planner.go(&limits, target, 200),
            };
            assert!(answer.is_ok() || answer == Err(Error::Late), "{answer:?}");
            accepted += u32::from(answer.is_ok());
            if answer.is_err() {
                thread::yield_now();
            }
        }
        while planner.go(&limits, LAST, 1000).is_err() {}
        is_over.store(true, Ordering::Release);
        let (jumps, last) = follower.join().expect("a thread");
        (jumps, last, accepted)
    });
    println!("{accepted} plans in time, {jumps} jumps");
    assert_eq!((jumps, last), (0, LAST));
    assert!(accepted > 1_000, "{accepted}");
}
