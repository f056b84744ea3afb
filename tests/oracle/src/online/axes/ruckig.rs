//! The crate rsruckig with several axes. It computes in binary64 always.

use super::problems::Set;
use crate::online::referee::widened;
use rsruckig::prelude::*;
use support::Real;

/// The duration that rsruckig finds, if it takes the set. It has one limit of the jerk, and needs finite numbers of moderate size.
pub fn duration<R: Real>(set: &Set<R>) -> Option<f64> {
    let axes = set.axes.len();
    let [least, cycle] = [set.duration, set.cycle].map(R::widen);
    let mut input = InputParameter::<0>::new(Some(axes));
    let zeros = || DataArrayOrVec::<f64, 0>::new(Some(axes), 0.0);
    let (mut vmins, mut amins) = (zeros(), zeros());
    for (k, axis) in set.axes.iter().enumerate() {
        let [vmax, vmin, amax, amin, jmax, jmin] = widened(&axis.limits);
        let state = |state: atraj::online::State<R>| {
            [state.position, state.velocity, state.acceleration].map(R::widen)
        };
        let ([p0, v0, a0], [p1, v1, a1]) = (state(axis.from), state(axis.to));
        let numbers = [vmax, vmin, amax, amin, jmax, p0, v0, a0, p1, v1, a1];
        let moderate = |x: &f64| x.abs() < 1e4 && (x.abs() > 1e-4 || *x == 0.0);
        if !numbers.iter().all(moderate) || jmin != -jmax {
            return None;
        }
        (input.max_velocity[k], vmins[k]) = (vmax, vmin);
        (input.max_acceleration[k], amins[k]) = (amax, amin);
        input.max_jerk[k] = jmax;
        (input.current_position[k], input.target_position[k]) = (p0, p1);
        (input.current_velocity[k], input.target_velocity[k]) = (v0, v1);
        (input.current_acceleration[k], input.target_acceleration[k]) = (a0, a1);
    }
    (input.min_velocity, input.min_acceleration) = (Some(vmins), Some(amins));
    input.minimum_duration = (least > 0.0).then_some(least);
    if cycle > 0.0 {
        input.duration_discretization = DurationDiscretization::Discrete;
    }
    let mut ruckig = Ruckig::<0, ThrowErrorHandler>::new(Some(axes), cycle.max(1e-9));
    let mut trajectory = Trajectory::<0>::new(Some(axes));
    match ruckig.calculate(&input, &mut trajectory) {
        Ok(RuckigResult::Working | RuckigResult::Finished) => Some(trajectory.get_duration()),
        _ => None,
    }
}
