//! Does a plan of an axis take over in its own tick? The package `handover` asks it of every place where an interrupt may come, and
//! `do_two_threads_share_an_axis` of two threads.

use std::thread;
use support::prelude::*;

/// From the tick of its takeover on, the axis has the states of the move that is planned from there. Its halves may go to two threads.
#[test]
fn in_its_own_tick() {
    const PERIOD: f64 = 1e-3;
    let limits = Limits::symmetric(30.0, 10.0, 5.0);
    let (start, target) = (State::at(1.0), State::at(2.0));
    let mut axis = Axis::new(PERIOD, start).expect("a period");
    let (mut planner, mut ticker) = axis.split();
    assert_eq!(planner.go(&limits, target, 0), Err(Error::Late));
    thread::scope(|scope| scope.spawn(|| planner.go(&limits, target, 3)).join()).expect("a thread").expect("a plan");
    let planned = online::plan(&limits, start, target);
    let ticks = thread::scope(|scope| scope.spawn(|| [(); 300].map(|()| ticker.tick())).join()).expect("a thread");
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
