//! `contour`: a star of five lines as a path through points on its lines, how long it takes, and how far it leaves them. First with as many
//! points on each line, closer together near the corners. Then with points only where they are needed: a section that leaves its line too far gets a
//! point in its middle, and the path is planned again.

use atraj::State;
use atraj::axes::{line, path_deviation, path_moves, path_size, plan_path};
use atraj::online::{Error, Limits, Move};
use std::f64::consts::PI;

/// A point, mm.
type Point = [f64; 2];

/// mm/s³, mm/s², mm/s
const LIMITS: [Limits<f64>; 2] =
    [Limits { vmax: 100.0, vmin: -100.0, amax: 3e3, amin: -3e3, jmax: 6e4, jmin: -6e4 }; 2];

fn main() -> Result<(), Error> {
    println!("points,rounds,s,greatest deviation mm");
    println!("a stop at each corner,,{:.3},0", stopping()?);
    for count in [2, 5, 10, 25, 50] {
        let planned = Contour::through(star(count))?;
        println!("{count} a line,1,{:.3},{:.4}", planned.duration(), planned.deviation());
    }
    for tolerance in [0.2, 0.05, 0.02, 0.01, 0.005] {
        let (mut planned, mut rounds) = (Contour::through(star(2))?, 1);
        while planned.deviation() > tolerance {
            planned = Contour::through(planned.closer(tolerance))?;
            rounds += 1;
        }
        let count = planned.points.len();
        println!("{count} within {tolerance},{rounds},{:.3},{:.4}", planned.duration(), planned.deviation());
    }
    Ok(())
}

/// The corners of a star, 15 to 19 mm from one to the next.
fn corners() -> [Point; 6] {
    [0.0, 2.0, 4.0, 1.0, 3.0, 0.0].map(|corner| {
        let (sin, cos) = (0.4 * PI * corner).sin_cos();
        [8.0 * sin, 10.0 * cos]
    })
}

/// The star with so many sections on each line, shorter ones near the corners.
fn star(sections: u32) -> Vec<Point> {
    let part = |k: u32| 0.5 - 0.5 * (PI * f64::from(k) / f64::from(sections)).cos();
    let corners = corners();
    let lines = corners.iter().zip(&corners[1..]);
    let points = lines.flat_map(|(from, to)| (0..sections).map(move |k| between(from, to, part(k))));
    points.chain([corners[5]]).collect()
}

fn between(from: &Point, to: &Point, part: f64) -> Point {
    [0, 1].map(|axis| from[axis] + part * (to[axis] - from[axis]))
}

/// How long the star takes if the axes stop at each corner, s.
fn stopping() -> Result<f64, Error> {
    let (mut moves, mut t) = ([Move::default(); 2], 0.0);
    for (from, to) in corners().iter().zip(&corners()[1..]) {
        line(&mut moves, &LIMITS, &from.map(State::at), &to.map(State::at), 0.0, 0.0)?;
        t += moves[0].t;
    }
    Ok(t)
}

/// A planned path through points.
struct Contour {
    points: Vec<Point>,
    moves: Vec<Move<f64>>,
}

impl Contour {
    fn through(points: Vec<Point>) -> Result<Self, Error> {
        let sections = points.len() - 1;
        let mut states: Vec<_> = points.iter().flatten().map(|&p| State::at(p)).collect();
        let mut durations = vec![0.0; sections];
        let mut work = vec![0.0; path_size(2, sections).ok_or(Error::Axes)?];
        plan_path(&mut states, &mut durations, &LIMITS, 2, 0, &mut work)?;
        let mut moves = vec![Move::default(); 2 * sections];
        path_moves(&mut moves, &LIMITS, &states, &durations, 2)?;
        Ok(Self { points, moves })
    }

    /// s
    fn duration(&self) -> f64 {
        self.moves.iter().step_by(2).map(|axis| axis.t).sum()
    }

    /// mm
    fn deviation(&self) -> f64 {
        path_deviation(&self.moves, 2)
    }

    /// The points, with another one in each section that leaves its line by more than this, mm.
    fn closer(&self, tolerance: f64) -> Vec<Point> {
        let mut points = vec![self.points[0]];
        for (ends, moves) in self.points.windows(2).zip(self.moves.chunks(2)) {
            if path_deviation(moves, 2) > tolerance {
                points.push(between(&ends[0], &ends[1], 0.5));
            }
            points.push(ends[1]);
        }
        points
    }
}
