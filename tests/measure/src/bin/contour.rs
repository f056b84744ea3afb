//! `contour`: paths that stay near their lines: a star of five lines, and a gear wheel of 1,000 segments, as CAM gives it. How long they take, how
//! far they leave their lines, how many points they need, and how long they are planned. Then the same wheel with tolerances of its points, and
//! with a feed.
//!
//! `contour FILE SCALE JERK ACCELERATION VELOCITY TOLERANCE` plans the contour of the points of a file, two numbers each, times SCALE: with
//! this velocity of each axis, and with this feed.

use oracle::judge::path::contour::contour;
use oracle::judge::path::{Chain, Paths, Planner, stopping};
use std::f64::consts::PI;
use std::path::Path;
use std::time::Instant;
use std::{env, fs};
use support::prelude::*;

type Point = [f64; 2]; // a point, mm
type Axes = [Limits<f64>; 2]; // mm/s³, mm/s², mm/s

const TEETH: u32 = 20;
const RADII: [f64; 2] = [18.0, 22.0]; // the circles on which the flanks of a tooth begin and end, mm

fn main() -> Result<(), Error> {
    println!("part,points given,within mm,points,s,largest deviation mm,highest speed mm/s,ms");
    let arguments: Vec<String> = env::args().skip(1).collect();
    match &arguments[..] {
        [file, numbers @ ..] if numbers.len() == 5 => of_a_file(file, numbers),
        _ => parts(),
    }
}

fn parts() -> Result<(), Error> {
    let limits = [Limits::symmetric(6e4, 3e3, 100.0); 2];
    for (part, points) in [("star", star()), ("gear wheel", gear_wheel())] {
        println!("{part} with a stop at each point,{},,,{:.3},0,,", points.len(), stopping(&chain(&limits, &points)));
        through(part, &limits, &points)?;
        for tolerance in [0.1, 0.05, 0.02, 0.01, 0.005] {
            within(part, &limits, &points, tolerance, f64::INFINITY)?;
        }
    }
    let points = gear_wheel();
    for tolerance in [0.05, 0.02, 0.01] {
        near(&limits, &points, tolerance)?;
    }
    for feed in [60.0, 20.0] {
        within(&format!("gear wheel at {feed} mm/s"), &limits, &points, 0.01, feed)?;
        within(&format!("circle of 314 mm at {feed} mm/s"), &limits, &circle(), 0.1, feed)?;
    }
    Ok(())
}

fn of_a_file(file: &str, numbers: &[String]) -> Result<(), Error> {
    let number = |text: &str| text.trim().parse::<f64>().expect("a number");
    let [scale, jerk, acceleration, velocity, tolerance] = [0, 1, 2, 3, 4].map(|k| number(&numbers[k]));
    let text = fs::read_to_string(file).expect("a file of points");
    let coordinates = text.split(|c: char| c == ',' || c.is_whitespace()).filter(|field| !field.is_empty());
    let coordinates: Vec<f64> = coordinates.map(|field| scale * number(field)).collect();
    let points: Vec<Point> = coordinates.chunks_exact(2).map(|point| [point[0], point[1]]).collect();
    let limits = [Limits::symmetric(jerk, acceleration, velocity); 2];
    let name = Path::new(file).file_stem().unwrap_or_default().to_string_lossy();
    let part = format!("{name} at {velocity} mm/s");
    println!("{part} with a stop at each point,{},,,{:.3},0,,", points.len(), stopping(&chain(&limits, &points)));
    within(&part, &limits, &points, tolerance, f64::INFINITY)?;
    within(&format!("{part} along the path"), &limits, &points, tolerance, velocity)
}

/// A star: its corners are 15 to 19 mm from one to the next.
fn star() -> Vec<Point> {
    let corner = |corner| {
        let (sin, cos) = f64::sin_cos(0.4 * PI * corner);
        [8.0 * sin, 10.0 * cos]
    };
    [0.0, 2.0, 4.0, 1.0, 3.0, 0.0].map(corner).to_vec()
}

fn circle() -> Vec<Point> {
    let point = |k| {
        let (sin, cos) = (f64::from(k) * PI / 32.0).sin_cos();
        [50.0 * cos, 50.0 * sin]
    };
    (0..=64).map(point).collect()
}

/// A wheel with 50 segments for each tooth: 18 for each flank, which is an involute, 7 at the tip, and 7 at the root.
fn gear_wheel() -> Vec<Point> {
    let [root, tip] = RADII;
    let end = (tip * tip / (root * root) - 1.0).sqrt();
    let half = PI / f64::from(2 * TEETH) + (PI / 9.0).tan() - PI / 9.0;
    let gap = 2.0 * PI / f64::from(TEETH) - 2.0 * half;
    let rolled = |t: f64| t - t.atan();
    let flank = |t: f64, side: f64| (root * (1.0 + t * t).sqrt(), side * (half - rolled(t)));
    let mut points = Vec::new();
    for tooth in 0..TEETH {
        let parts = |count: u32| (0..count).map(move |k| f64::from(k) / f64::from(count));
        let up = parts(18).map(|part| flank(end * part, -1.0));
        let across = parts(7).map(|part| (tip, (half - rolled(end)) * (2.0 * part - 1.0)));
        let down = parts(18).map(|part| flank(end * (1.0 - part), 1.0));
        let to_next = parts(7).map(|part| (root, half + gap * part));
        for (radius, angle) in up.chain(across).chain(down).chain(to_next) {
            let (sin, cos) = (angle + 2.0 * PI * f64::from(tooth) / f64::from(TEETH)).sin_cos();
            points.push([radius * cos, radius * sin]);
        }
    }
    points.push(points[0]);
    points
}

fn chain(limits: &Axes, points: &[Point]) -> Chain<f64> {
    Chain::at_rest(limits.to_vec(), points.iter().flatten().copied())
}

fn through(part: &str, limits: &Axes, points: &[Point]) -> Result<(), Error> {
    let (chain, start) = (chain(limits, points), Instant::now());
    let (moves, _) = Paths.plan(&chain, 0)?.0.moves(&chain)?;
    print(part, points, "", &moves, start);
    Ok(())
}

fn within(part: &str, limits: &Axes, points: &[Point], tolerance: f64, feed: f64) -> Result<(), Error> {
    let (mut chain, start) = (chain(limits, points), Instant::now());
    chain.limits = limits.repeat(chain.sections());
    let feeds = vec![feed; chain.sections()];
    limit_feed(&mut chain.limits, &chain.states, &feeds, 2)?;
    print(part, points, &tolerance.to_string(), &near_lines(&chain, tolerance)?, start);
    Ok(())
}

/// Prints the path whose points are passed within half of a tolerance, and that stays within the other half of their lines.
fn near(limits: &Axes, points: &[Point], tolerance: f64) -> Result<(), Error> {
    let (chain, start) = (chain(limits, points), Instant::now());
    let tolerances = vec![0.5 * tolerance / f64::sqrt(2.0); 2 * (chain.sections() - 1)];
    let states = Paths.plan_near(&chain, &tolerances, 0)?.0.states;
    let moves = near_lines(&Chain { states, ..chain }, 0.5 * tolerance)?;
    print("gear wheel with tolerances", points, &tolerance.to_string(), &moves, start);
    Ok(())
}

fn near_lines(chain: &Chain<f64>, tolerance: f64) -> Result<Vec<Move<f64>>, Error> {
    let planned = contour(chain, tolerance, 4 * chain.sections() + 200, 0);
    planned.answer.map(|_| planned.moves)
}

fn print(part: &str, points: &[Point], tolerance: &str, moves: &[Move<f64>], start: Instant) {
    let took = start.elapsed().as_secs_f64() * 1e3;
    let duration: f64 = moves.iter().step_by(2).map(|axis| axis.t).sum();
    let [given, count] = [points.len(), moves.len() / 2 + 1];
    let speed = |section: &[Move<f64>], x: f64| section[0].velocity(x).hypot(section[1].velocity(x));
    let time = |section: &[Move<f64>], k: i32| 0.01 * f64::from(k) * section[0].t;
    let speeds = moves.chunks(2).flat_map(|section| (0..=100).map(move |k| speed(section, time(section, k))));
    let (deviation, highest) = (path_deviation(moves, 2), speeds.fold(0.0, f64::max));
    println!("{part},{given},{tolerance},{count},{duration:.3},{deviation:.4},{highest:.2},{took:.0}");
}
