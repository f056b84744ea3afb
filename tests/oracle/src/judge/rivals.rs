//! The crate rsruckig next to ours. It computes in binary64 always.

use super::path::Chain;
use super::{Problem, Request, Trial, Verdict, parts, tolerance, widened};
use crate::liba::Original;
use rsruckig::prelude::*;
use support::prelude::*;

const ACCURACY: f64 = 1e-8; // how far off its target a motion of rsruckig may end

/// Whether rsruckig takes these axes. It has one limit of the jerk, and needs finite numbers of moderate size.
pub fn fits_ruckig<R: Real>(axes: &[Problem<R>]) -> bool {
    let moderate = |x: f64| x.abs() < 1e4 && (x.abs() > 1e-4 || x == 0.0);
    axes.iter().all(|axis| {
        let numbers = axis.numbers().map(R::widen);
        axis.request == Request::Plan && numbers.into_iter().all(moderate) && numbers[4] == -numbers[5]
    })
}

/// The duration that rsruckig finds for these axes: at least this one, a multiple of the cycle if that is not 0.
pub fn ruckig<R: Real>(axes: &[Problem<R>], least: f64, cycle: f64) -> Option<f64> {
    let columns = axes.iter().map(|axis| (axis.limits, axis.from, axis.to));
    let (limits, from, to): (Vec<_>, Vec<_>, Vec<_>) = columns.collect();
    let mut input = input(&limits, [&from, &to]);
    input.minimum_duration = (least > 0.0).then_some(least);
    if cycle > 0.0 {
        input.duration_discretization = DurationDiscretization::Discrete;
    }
    calculated(&input, axes.len(), cycle.max(1e-9))
}

fn row(numbers: impl ExactSizeIterator<Item = f64>) -> DataArrayOrVec<f64, 0> {
    let mut row = DataArrayOrVec::new(Some(numbers.len()), 0.0);
    numbers.enumerate().for_each(|(axis, number)| row[axis] = number);
    row
}

fn input<R: Real>(limits: &[Limits<R>], [from, to]: [&[State<R>]; 2]) -> InputParameter<0> {
    let limit = |which: usize| row(limits.iter().map(|limits| widened(limits)[which]));
    let part = |states: &[State<R>], which: usize| row(states.iter().map(|state| parts(*state)[which].widen()));
    let mut input = InputParameter::new(Some(limits.len()));
    (input.current_position, input.target_position) = (part(from, 0), part(to, 0));
    (input.current_velocity, input.target_velocity) = (part(from, 1), part(to, 1));
    (input.current_acceleration, input.target_acceleration) = (part(from, 2), part(to, 2));
    (input.max_velocity, input.min_velocity) = (limit(0), Some(limit(1)));
    (input.max_acceleration, input.min_acceleration) = (limit(2), Some(limit(3)));
    input.max_jerk = limit(4);
    input
}

fn calculated(input: &InputParameter<0>, axes: usize, cycle: f64) -> Option<f64> {
    let mut trajectory = Trajectory::<0>::new(Some(axes));
    match Ruckig::<0, ThrowErrorHandler>::new(Some(axes), cycle).calculate(input, &mut trajectory) {
        Ok(RuckigResult::Working | RuckigResult::Finished) => Some(trajectory.get_duration()),
        _ => None,
    }
}

pub fn path_fits_ruckig<R: Real>(chain: &Chain<R>) -> bool {
    let moderate = |x: f64| x.abs() < 1e3 && (x.abs() > 1e-3 || x == 0.0);
    let of_states = |state: &State<R>| parts(*state).map(R::widen).into_iter().all(moderate);
    let of_limits = |limits: &Limits<R>| {
        let limits = widened(limits);
        limits.into_iter().all(moderate) && limits[4] == -limits[5]
    };
    chain.limits.len() == chain.axes && chain.states.iter().all(of_states) && chain.limits.iter().all(of_limits)
}

pub fn ruckig_path<R: Real>(chain: &Chain<R>) -> Option<f64> {
    let axes = chain.axes;
    let points: Vec<_> = chain.states.chunks(axes).collect();
    let (from, inner, to) = (points[0], &points[1..chain.sections()], points[chain.sections()]);
    let mut input = input(&chain.limits, [from, to]);
    input.intermediate_positions =
        inner.iter().map(|point| row(point.iter().map(|state| state.position.widen()))).collect();
    calculated(&input, axes, 1e-3)
}

#[derive(Clone, Debug, Default)]
pub struct Theirs {
    pub asked: u64,   // problems that it was asked
    pub refused: u64, // plans that are missing
    pub longer: u64,  // durations that are longer than the least one
    pub shorter: u64, // durations that are shorter than the least one, though the start is inside
}

impl Theirs {
    pub fn ask<R: Original>(&mut self, problem: &Problem<R>, trial: &Trial<R>) {
        if !fits_ruckig(&[*problem]) {
            return;
        }
        self.asked += 1;
        let Some(duration) = ruckig(&[*problem], 0.0, 0.0) else {
            self.refused += 1;
            return;
        };
        let inside = trial.best.inside == 0.0;
        let least = trial.best.duration;
        if duration > least * (1.0 + tolerance::<R>()) {
            self.longer += 1;
        } else if inside && duration < least * (1.0 - tolerance::<R>()) {
            self.shorter += u64::from(matches!(trial.duration_near(duration, ACCURACY), Verdict::Shorter(_)));
        }
    }
}
