//! The positions that an axis cannot avoid: those of its motion, of its fastest stop and of its fastest motion from rest to the target.

use super::solver::Walk;
use support::online::{mirrored, mirrored_limits, numbers_of_state};
use support::prelude::*;

/// The lowest and the highest position of a move that begins in this state, by integration of its phases.
pub fn span<R: Real>(from: State<R>, planned: &Move<R>) -> [f64; 2] {
    let end = planned.position(planned.t).widen();
    let knots = Walk::of(from, planned).knots;
    let positions = || knots.iter().map(|knot| knot[1]).chain([end]);
    [positions().fold(f64::INFINITY, f64::min), positions().fold(f64::NEG_INFINITY, f64::max)]
}

pub fn stop<R: Real>(limits: &Limits<R>, from: State<R>) -> Option<[f64; 2]> {
    let mut planned = Move::default();
    planned.stop(limits, from).ok()?;
    Some(span(from, &planned))
}

/// The highest position of the hardest brake from the start, where the acceleration falls, and then holds, until the axis stands. No motion within the
/// limits turns lower. NaN if the velocity after the turn would be below its limit. In `f64`, from a state inside the limits.
fn highest_of_brake<R: Real>(limits: &Limits<R>, from: State<R>) -> f64 {
    let [p, v, a] = numbers_of_state(from);
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

pub fn brake<R: Real>(limits: &Limits<R>, from: State<R>) -> [f64; 2] {
    [-highest_of_brake(&mirrored_limits(limits), mirrored(from)), highest_of_brake(limits, from)]
}

/// The limits and the state in the other order of time, seen in a mirror: velocities stay.
pub fn backwards<R: Real>(limits: &Limits<R>, state: State<R>) -> (Limits<R>, State<R>) {
    let State { position, velocity, acceleration } = state;
    let limits = Limits { amax: -limits.amin, amin: -limits.amax, ..*limits };
    (limits, State { position: -position, velocity, acceleration: -acceleration })
}

pub fn approach<R: Real>(limits: &Limits<R>, to: State<R>) -> [f64; 2] {
    let (limits, state) = backwards(limits, to);
    let [lowest, highest] = brake(&limits, state);
    [-highest, -lowest]
}

/// The positions of the fastest motion from rest to the target. In the other order of time, and mirrored, it is a stop.
pub fn launch<R: Real>(limits: &Limits<R>, to: State<R>) -> Option<[f64; 2]> {
    let (limits, state) = backwards(limits, to);
    let [lowest, highest] = stop(&limits, state)?;
    Some([-highest, -lowest])
}

/// The states from which an axis stays between 0 and 1, by dynamic programming: for velocities and accelerations on a grid the lowest and the highest
/// position. A step takes one of three jerks. Between the points of the grid the positions are linear, because a mean of two motions between
/// the position limits is between them too.
pub struct Viable {
    limits: Limits<f64>,
    spans: Vec<[f64; 2]>,
}

impl Viable {
    const CELLS: usize = 30;

    pub fn new(limits: Limits<f64>) -> Self {
        let mut found = Self { limits, spans: vec![[0.0, 1.0]; (Self::CELLS + 1) * (Self::CELLS + 1)] };
        // An acceleration passes a cell in one step, and its range in a sixth of all steps.
        let slowest = limits.jmax.min(-limits.jmin);
        let dt = (limits.amax - limits.amin) / Self::CELLS as f64 / limits.jmax.max(-limits.jmin);
        for _ in 0..(6.0 * (limits.amax - limits.amin) / slowest / dt) as usize {
            found.spans = (0..found.spans.len()).map(|index| found.before(index, dt)).collect();
        }
        found
    }

    /// The positions at a point of the grid from which one step leads to a state that has been viable so far; else the nearest ones.
    fn before(&self, index: usize, dt: f64) -> [f64; 2] {
        let Limits { vmax, vmin, amax, amin, jmax, jmin } = self.limits;
        let part = |cell: usize| cell as f64 / Self::CELLS as f64;
        let v = vmin + (vmax - vmin) * part(index / (Self::CELLS + 1));
        let a = amin + (amax - amin) * part(index % (Self::CELLS + 1));
        let spans = [jmin, 0.0, jmax].map(|jerk| {
            let jerk = ((a + jerk * dt).clamp(amin, amax) - a) / dt;
            let next = v + dt * (a + 0.5 * jerk * dt);
            let way = dt * (v + dt * (0.5 * a + jerk * dt / 6.0));
            let beyond = 10.0 * (next - next.clamp(vmin, vmax)).abs() / (vmax - vmin);
            let [low, high] = self.positions(next, a + jerk * dt);
            [low + beyond - way, high - beyond - way]
        });
        let [mut low, mut high] =
            spans.into_iter().max_by(|x, y| (x[1] - x[0]).total_cmp(&(y[1] - y[0]))).expect("three spans");
        for span in spans.iter().filter(|span| span[0] <= span[1]) {
            (low, high) = (low.min(span[0]), high.max(span[1]));
        }
        [low.max(0.0), high.min(1.0)]
    }

    /// The positions from which an axis stays between the position limits; none if the first one is above the second one.
    pub fn positions(&self, velocity: f64, acceleration: f64) -> [f64; 2] {
        let Limits { vmax, vmin, amax, amin, .. } = self.limits;
        let cell = |x: f64, low: f64, high: f64| {
            let x = ((x - low) / (high - low)).clamp(0.0, 1.0) * Self::CELLS as f64;
            let index = (x as usize).min(Self::CELLS - 1);
            (index, x - index as f64)
        };
        let ((row, x), (column, y)) = (cell(velocity, vmin, vmax), cell(acceleration, amin, amax));
        let at = |row: usize, column: usize| self.spans[row * (Self::CELLS + 1) + column];
        let corners = [at(row, column), at(row, column + 1), at(row + 1, column), at(row + 1, column + 1)];
        let weights = [(1.0 - x) * (1.0 - y), (1.0 - x) * y, x * (1.0 - y), x * y];
        [0, 1].map(|end| corners.iter().zip(weights).map(|(span, weight)| weight * span[end]).sum())
    }

    /// Whether an axis in this state stays between the position limits, by more than the grid is wrong.
    pub fn is_surely(&self, State { position, velocity, acceleration }: State<f64>) -> bool {
        let [low, high] = self.positions(velocity, acceleration);
        position > low + 0.01 && position < high - 0.01 && high - low > 0.01
    }
}
