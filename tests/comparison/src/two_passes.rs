//! Two passes over the speeds at the points, without acceleration there: how CNC controllers plan a row of one axis.

use crate::Duration;
use atraj::State;
use atraj::online::{Limits, Move};
use oracle::judge::path::Chain;

/// How long such a plan takes, if the points are a row in one direction.
pub fn duration(chain: &Chain<f64>) -> Option<Duration> {
    let ways: Vec<_> = chain.states.windows(2).map(|ends| ends[1].position - ends[0].position).collect();
    if chain.axes > 1 || ways.iter().any(|&way| way <= 0.0) {
        return None;
    }
    let limits = &chain.limits[0];
    let last = ways.len();
    let mut speeds = vec![limits.vmax; last + 1];
    (speeds[0], speeds[last]) = (0.0, 0.0);
    for k in 0..last {
        speeds[k + 1] = speeds[k + 1].min(reach(limits, speeds[k], ways[k]));
    }
    for k in (0..last).rev() {
        speeds[k] = speeds[k].min(reach(limits, speeds[k + 1], ways[k]));
    }
    let states = chain.states.iter().zip(speeds).map(|(state, velocity)| State { velocity, ..*state });
    let states: Vec<_> = states.collect();
    let mut motion = Move::default();
    let mut section = |from, to| motion.plan(limits, from, to).map(|_| motion.t).ok();
    states.windows(2).map(|ends| section(ends[0], ends[1])).sum()
}

fn reach(limits: &Limits<f64>, start: f64, way: f64) -> f64 {
    let (mut low, mut high) = (start, limits.vmax);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if ramp(limits, start, middle) < way { low = middle } else { high = middle }
    }
    low
}

/// The way from one speed to a higher one, both without acceleration.
fn ramp(limits: &Limits<f64>, from: f64, to: f64) -> f64 {
    let (rise, a, j) = (to - from, limits.amax, limits.jmax);
    let time = if rise * j < a * a { 2.0 * (rise / j).sqrt() } else { rise / a + a / j };
    0.5 * (from + to) * time
}
