//! The positions that an axis cannot avoid: those of its motion, of its fastest stop and of its fastest motion from rest to the target.

use super::referee::Walk;
use atraj::online::{Limits, Move, State};
use support::Real;

/// The lowest and the highest position of a move that begins in this state, by integration of its phases.
pub fn span<R: Real>(from: State<R>, planned: &Move<R>) -> [f64; 2] {
    let end = planned.position(planned.t).widen();
    let knots = Walk::of(from, planned).knots;
    let positions = || knots.iter().map(|knot| knot[1]).chain([end]);
    [
        positions().fold(f64::INFINITY, f64::min),
        positions().fold(f64::NEG_INFINITY, f64::max),
    ]
}

/// The positions of the fastest stop from the start.
pub fn stop<R: Real>(limits: &Limits<R>, from: State<R>) -> Option<[f64; 2]> {
    let mut planned = Move::default();
    planned.stop(limits, from).ok()?;
    Some(span(from, &planned))
}

/// The positions of the fastest motion from rest to the target. In the other order of time, and mirrored, it is a stop.
pub fn launch<R: Real>(limits: &Limits<R>, to: State<R>) -> Option<[f64; 2]> {
    let reversed = Limits {
        amax: -limits.amin,
        amin: -limits.amax,
        ..*limits
    };
    let state = State {
        position: -to.position,
        acceleration: -to.acceleration,
        ..to
    };
    let [lowest, highest] = stop(&reversed, state)?;
    Some([-highest, -lowest])
}
