//! Does a plan of an axis take over in its own tick? The package `handover` asks it of every place where an interrupt may come.

use atraj::machine::Axis;
use atraj::online::{Error, Limits, Move, State};

/// From the tick of its takeover on, the axis has the states of the move that is planned from there.
#[test]
fn in_its_own_tick() {
    const PERIOD: f64 = 1e-3;
    let limits = Limits::symmetric(30.0, 10.0, 5.0);
    let (start, target) = (State::at(1.0), State::at(2.0));
    let mut axis = Axis::new(PERIOD, start).expect("a period");
    assert_eq!(axis.go(&limits, target, 0), Err(Error::Late));
    axis.go(&limits, target, 3).expect("a plan");
    let mut planned = Move::default();
    planned.plan(&limits, start, target).expect("a plan");
    let ticks = [(); 300].map(|()| axis.tick());
    let expected = |tick: usize| planned.state_at(PERIOD * tick.saturating_sub(2) as f64);
    for (tick, state) in ticks.into_iter().enumerate() {
        assert_eq!(state, expected(tick), "{tick}");
    }
    axis.stop(&limits, 2).expect("a stop");
    let mut stop = Move::default();
    stop.stop(&limits, expected(301)).expect("a stop");
    let ticks = [axis.tick(), axis.tick(), axis.tick()];
    let on = |tick: f64| stop.state_at(PERIOD * tick);
    assert_eq!(ticks, [expected(300), on(0.0), on(1.0)]);
}
