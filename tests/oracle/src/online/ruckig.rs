//! The crate rsruckig beside ours. It computes in binary64 always.

use super::judge::{Trial, Verdict, tolerance};
use super::problems::{Problem, Wish};
use super::referee::widened;
use rsruckig::prelude::*;
use std::fmt::{Display, Formatter, Result as Written};
use support::Real;

/// How far beside its target a motion of rsruckig may end.
const ACCURACY: f64 = 1e-8;

/// rsruckig with one axis.
pub struct Rival {
    ruckig: Ruckig<1, ThrowErrorHandler>,
    input: InputParameter<1>,
    trajectory: Trajectory<1>,
}

impl Default for Rival {
    fn default() -> Self {
        Self::new()
    }
}

impl Rival {
    /// Without a plan.
    pub fn new() -> Self {
        Self {
            ruckig: Ruckig::new(None, 0.001),
            input: InputParameter::new(None),
            trajectory: Trajectory::new(None),
        }
    }

    /// The duration that rsruckig finds. It has one limit of the jerk, and needs finite ones.
    fn duration<R: Real>(&mut self, problem: &Problem<R>) -> Option<f64> {
        let [vmax, vmin, amax, amin, jmax, _] = widened(&problem.limits);
        let state = |state: atraj::online::State<R>| {
            [state.position, state.velocity, state.acceleration].map(R::widen)
        };
        let input = &mut self.input;
        input.max_velocity[0] = vmax;
        input.min_velocity = Some(DataArrayOrVec::Stack([vmin]));
        input.max_acceleration[0] = amax;
        input.min_acceleration = Some(DataArrayOrVec::Stack([amin]));
        input.max_jerk[0] = jmax;
        let [p0, v0, a0] = state(problem.from);
        let [p1, v1, a1] = state(problem.to);
        (input.current_position[0], input.target_position[0]) = (p0, p1);
        (input.current_velocity[0], input.target_velocity[0]) = (v0, v1);
        (input.current_acceleration[0], input.target_acceleration[0]) = (a0, a1);
        let result = self.ruckig.calculate(input, &mut self.trajectory);
        match result {
            Ok(RuckigResult::Working | RuckigResult::Finished) => {
                Some(self.trajectory.get_duration())
            }
            _ => None,
        }
    }
}

/// What rsruckig makes of the same problems.
#[derive(Clone, Debug, Default)]
pub struct Theirs {
    /// Problems that it was asked.
    pub asked: u64,
    /// Plans that are missing.
    pub refused: u64,
    /// Durations that are longer than the least one.
    pub longer: u64,
    /// Durations that are shorter than the least one, though the start is inside.
    pub shorter: u64,
}

impl Theirs {
    /// The heading of these counts in a table.
    pub const HEADING: &str = "rsruckig:  asked refused  longer shorter";

    /// Adds other counts.
    pub fn add(&mut self, other: &Self) {
        self.asked += other.asked;
        self.refused += other.refused;
        self.longer += other.longer;
        self.shorter += other.shorter;
    }

    /// Plans the problem with rsruckig, if it has no infinite limit and the same jerk in both directions.
    pub fn ask<R: Real>(&mut self, rival: &mut Rival, problem: &Problem<R>, trial: &Trial<R>) {
        let limits = widened(&problem.limits);
        let moderate = |x: &f64| x.abs() < 1e4 && (x.abs() > 1e-4 || *x == 0.0);
        let motion = trial.motion();
        let numbers = limits.iter().chain(&motion.start).chain(&motion.target);
        let fits = numbers.into_iter().all(moderate) && limits[4] == -limits[5];
        if !fits || problem.wish != Wish::Plan {
            return;
        }
        self.asked += 1;
        let Some(duration) = rival.duration(problem) else {
            self.refused += 1;
            return;
        };
        let inside = trial.best().inside == 0.0;
        let least = trial.best().duration;
        if duration > least * (1.0 + tolerance::<R>()) {
            self.longer += 1;
        } else if inside && duration < least * (1.0 - tolerance::<R>()) {
            let shorter = matches!(trial.duration_near(duration, ACCURACY), Verdict::Shorter(_));
            self.shorter += u64::from(shorter);
        }
    }
}

impl Display for Theirs {
    fn fmt(&self, f: &mut Formatter<'_>) -> Written {
        let Self {
            asked,
            refused,
            longer,
            shorter,
        } = self;
        write!(f, "{asked:>16} {refused:>7} {longer:>7} {shorter:>7}")
    }
}
