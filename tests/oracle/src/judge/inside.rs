//! The positions that an axis cannot avoid: those of its motion, of its fastest stop and of its fastest motion from rest to the target.

use super::referee::Walk;
use atraj::online::{Limits, Move, State};
use support::Real;

/// The lowest and the highest position of a move that begins in this state, by integration of its phases.
pub fn span<R: Real>(from: State<R>, planned: &Move<R>) -> [f64; 2] {
    let end = planned.position(planned.t).widen();
    let knots = Walk::of(from, planned).knots;
    let positions = || knots.iter().map(|knot| knot[1]).chain([end]);
    [positions().fold(f64::INFINITY, f64::min), positions().fold(f64::NEG_INFINITY, f64::max)]
}

/// The positions of the fastest stop from the start.
pub fn stop<R: Real>(limits: &Limits<R>, from: State<R>) -> Option<[f64; 2]> {
    let mut planned = Move::default();
    planned.stop(limits, from).ok()?;
    Some(span(from, &planned))
}

/// The highest position of the hardest brake from the start, where the acceleration falls, and then holds, until the axis stands. No motion within the
/// limits turns lower. NaN if the velocity after the turn would be below its limit. In `f64`, from a state inside the limits.
fn highest_of_brake<R: Real>(limits: &Limits<R>, from: State<R>) -> f64 {
    let [p, v, a] = [from.position, from.velocity, from.acceleration].map(R::widen);
    let [amin, jerk] = [limits.amin.widen(), -limits.jmin.widen()];
    let square = a * a + 2.0 * jerk * v;
    if square < 0.0 || (v <= 0.0 && a <= 0.0) {
        return p;
    }
    let lowest = (-square.sqrt()).max(amin);
    if 0.5 * lowest * lowest / limits.jmax.widen() > -limits.vmin.widen() {
        return f64::NAN;
    }
    let fall = if jerk.is_finite() { (a - lowest) / jerk } else { 0.0 };
    let jerk = if jerk.is_finite() { jerk } else { 0.0 };
    let left = v + fall * (a - 0.5 * fall * jerk);
    let hold = if lowest > amin { 0.0 } else { left.max(0.0) / -amin };
    let fallen = p + fall * (v + fall * (0.5 * a - fall * jerk / 6.0));
    p.max(if hold > 0.0 { fallen + 0.5 * hold * left } else { fallen })
}

/// The positions that no axis in this state can avoid.
pub fn brake<R: Real>(limits: &Limits<R>, from: State<R>) -> [f64; 2] {
    let State { position, velocity, acceleration } = from;
    let mirrored = State { position: -position, velocity: -velocity, acceleration: -acceleration };
    let Limits { vmax, vmin, amax, amin, jmax, jmin } = *limits;
    let other = Limits { vmax: -vmin, vmin: -vmax, amax: -amin, amin: -amax, jmax: -jmin, jmin: -jmax };
    [-highest_of_brake(&other, mirrored), highest_of_brake(limits, from)]
}

/// The positions that no axis can avoid before this state.
pub fn approach<R: Real>(limits: &Limits<R>, to: State<R>) -> [f64; 2] {
    let reversed = Limits { amax: -limits.amin, amin: -limits.amax, ..*limits };
    let state = State { position: -to.position, acceleration: -to.acceleration, ..to };
    let [lowest, highest] = brake(&reversed, state);
    [-highest, -lowest]
}

/// The positions of the fastest motion from rest to the target. In the other order of time, and mirrored, it is a stop.
pub fn launch<R: Real>(limits: &Limits<R>, to: State<R>) -> Option<[f64; 2]> {
    let reversed = Limits { amax: -limits.amin, amin: -limits.amax, ..*limits };
    let state = State { position: -to.position, acceleration: -to.acceleration, ..to };
    let [lowest, highest] = stop(&reversed, state)?;
    Some([-highest, -lowest])
}
