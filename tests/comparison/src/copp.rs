//! COPP moves along a spline through the points, whose parameter is the number of the point.

use crate::Duration;
use atraj::State;
use copp::diag::CoppError;
use copp::path::{Path, SplineConfig};
use copp::robot::Robot;
use copp::solver::topp2_ra::{ReachSet2OptionsBuilder, Topp2ProblemBuilder, s_to_t_topp2, topp2_ra};
use copp::solver::topp3_socp::{ClarabelOptionsBuilder, Topp3ProblemBuilder, s_to_t_topp3, topp3_socp};
use nalgebra::DMatrix;
use oracle::judge::path::Chain;

const STATIONS: usize = 1001; // points of the spline at which the limits hold

/// What is limited, besides the velocity.
#[derive(PartialEq)]
pub enum Limits {
    Acceleration,
    Jerk,
}

/// How long its motion takes, if it begins and ends at rest.
pub fn duration(chain: &Chain<f64>, limits: Limits) -> Option<Duration> {
    if !is_curve(chain) {
        return None;
    }
    Some(plan(chain, limits).expect("a plan of COPP"))
}

pub fn stations(chain: &Chain<f64>) -> Option<Chain<f64>> {
    if !is_curve(chain) {
        return None;
    }
    let states = points(chain, &parameters()).iter().map(|&position| State::at(position)).collect();
    Some(Chain { states, ..chain.clone() })
}

/// How far its spline leaves the straight lines between the stations, about in their middle.
pub fn deviation(chain: &Chain<f64>) -> f64 {
    let s = parameters();
    let middles: Vec<_> = s.windows(2).map(|ends| 0.5 * (ends[0] + ends[1])).collect();
    let (ends, middles) = (points(chain, &s), points(chain, &middles));
    let away = |k: usize| (middles.column(k) - 0.5 * (ends.column(k) + ends.column(k + 1))).norm();
    (0..middles.ncols()).map(away).fold(0.0, f64::max)
}

fn points(chain: &Chain<f64>, s: &[f64]) -> DMatrix<f64> {
    spline(chain).and_then(|spline| Ok(spline.evaluate_q(s)?.q)).expect("a spline")
}

/// A spline through a row would run back and forth.
pub fn is_curve(chain: &Chain<f64>) -> bool {
    chain.axes > 1 && chain.states.iter().all(|state| *state == State::at(state.position))
}

fn parameters() -> Vec<f64> {
    (0..STATIONS).map(|k| k as f64 / (STATIONS - 1) as f64).collect()
}

fn spline(chain: &Chain<f64>) -> Result<Path, CoppError> {
    let positions = chain.states.iter().map(|state| state.position);
    let points = DMatrix::from_iterator(chain.axes, chain.sections() + 1, positions);
    Ok(Path::from_waypoints_interpolating(&points, SplineConfig::default())?)
}

fn plan(chain: &Chain<f64>, limits: Limits) -> Result<Duration, CoppError> {
    let s = parameters();
    let of_axes =
        |limit: fn(&atraj::online::Limits<f64>) -> f64| -> Vec<_> { chain.limits.iter().map(limit).collect() };
    let [vmax, vmin, amax, amin] = [of_axes(|l| l.vmax), of_axes(|l| l.vmin), of_axes(|l| l.amax), of_axes(|l| l.amin)];
    let [jmax, jmin] = [of_axes(|l| l.jmax), of_axes(|l| l.jmin)];
    let mut robot = Robot::with_capacity(chain.axes, STATIONS);
    robot
        .with_s(s.as_slice())?
        .with_q_from_path_3rd(&spline(chain)?, 0, STATIONS)?
        .with_axial_velocity((vmax.as_slice(), STATIONS), (vmin.as_slice(), STATIONS), 0)?
        .with_axial_acceleration((amax.as_slice(), STATIONS), (amin.as_slice(), STATIONS), 0)?
        .with_axial_jerk((jmax.as_slice(), STATIONS), (jmin.as_slice(), STATIONS), 0)?;
    let problem = Topp2ProblemBuilder::new(&robot, (0, STATIONS - 1), (0.0, 0.0)).build()?;
    let squares = topp2_ra(&problem, &ReachSet2OptionsBuilder::new().build()?)?;
    if limits == Limits::Acceleration {
        return Ok(s_to_t_topp2(&s, &squares, 0.0)?.0);
    }
    let problem =
        Topp3ProblemBuilder::new(&mut robot, 0, &squares, (0.0, 0.0), (0.0, 0.0)).build_with_linearization()?;
    let options = ClarabelOptionsBuilder::new()
        .allow_almost_solved(true)
        .allow_max_time(true)
        .allow_max_iterations(true)
        .allow_insufficient_progress(true)
        .build()?;
    let profile = topp3_socp(&problem, &options)?;
    Ok(s_to_t_topp3(&s, profile.as_parts(), 0.0)?.0)
}
