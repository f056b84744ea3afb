//! A path through a window over a row of points, which moves along and is updated 20 times a second.

use super::{Chain, Path, Paths, Planner, under_way};
use crate::liba::Original;
use std::f64::consts::TAU;
use std::time::{Duration, Instant};
use support::prelude::*;

const PERIOD: f64 = 0.05; // the time between two updates, s
/// mm/s, mm/s², mm/s³
const LIMITS: Limits<f64> = Limits { vmax: 100.0, vmin: -100.0, amax: 3e3, amin: -3e3, jmax: 6e4, jmin: -6e4 };

pub type Row = Vec<Vec<f64>>; // points, each with its positions, mm

/// Rows of so many points of several kinds.
pub fn rows(count: usize) -> [(&'static str, Row); 5] {
    let mut random = Random::seeded(20);
    let mut line = |octaves: f64| {
        let mut position = 0.0;
        let mut next = || {
            position += 0.1 * random.magnitude(1.0 - octaves, 1.0 + octaves);
            vec![position]
        };
        (0..count).map(|_| next()).collect()
    };
    let (even, uneven) = (line(0.0), line(1.0));
    let around = |radius: fn(f64) -> f64| {
        let angles = (0..count).map(|k| TAU * k as f64 / (count - 1) as f64);
        angles.map(|angle| vec![radius(angle) * angle.cos(), radius(angle) * angle.sin()]).collect()
    };
    let cube = (0..count).map(|_| (0..3).map(|_| random.between(0.0, 20.0)).collect()).collect();
    [
        ("one axis, 1 mm apart", even),
        ("one axis, 0.1 to 10 mm apart", uneven),
        ("a circle of 314 mm", around(|_| 50.0)),
        ("a flower of five leaves", around(|angle| 40.0 + 15.0 * (5.0 * angle).cos())),
        ("three axes, at random in a cube of 20 mm", cube),
    ]
}

fn chain(row: &[Vec<f64>]) -> Chain<f64> {
    Chain::at_rest(vec![LIMITS; row[0].len()], row.iter().flatten().copied())
}

fn plan(row: &[Vec<f64>]) -> Path<f64> {
    Paths.plan(&chain(row), 0).expect("a plan").0
}

/// How long the whole path takes, s.
pub fn whole(row: &Row) -> f64 {
    plan(row).duration()
}

/// How long the path takes through a window of so many points, s, and how long its longest update.
pub fn through_window(row: &Row, size: usize) -> (f64, Duration) {
    let (mut chain, mut path) = (chain(&row[..size]), plan(&row[..size]));
    let (mut next, mut time, mut longest) = (size, 0.0, Duration::ZERO);
    while next < row.len() {
        path = after(&chain.limits, path, PERIOD);
        time += PERIOD;
        while path.durations.len() + 1 < size && next < row.len() {
            path.states.extend(row[next].iter().map(|&position| State::at(position)));
            path.durations.push(0.0);
            next += 1;
        }
        chain.states.clone_from(&path.states);
        let start = Instant::now();
        Paths.improve(&chain, &mut path, 0).expect("a plan");
        longest = longest.max(start.elapsed());
    }
    (time + path.duration(), longest)
}

/// What is left of a path after so many seconds.
pub fn after<R: Original>(limits: &[Limits<R>], mut path: Path<R>, mut time: f64) -> Path<R> {
    while path.durations.len() > 1 && path.durations[0].widen() <= time {
        time -= path.durations.remove(0).widen();
        path.states.drain(..limits.len());
    }
    let passed = R::of(time.min(path.durations[0].widen()));
    under_way(limits, &path, path.durations[0] - passed)
}
