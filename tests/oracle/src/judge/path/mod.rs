//! The judge of paths: are all sections possible in their durations, and is the path not longer than one that stops?

pub mod contour;
pub mod faults;
pub mod problems;
pub mod windows;

use super::axes::several::{plan_of, scale_of_short_ramps};
use super::{Check, Kind, Problem, Request, Trial};
use crate::liba::Original;
use support::prelude::*;

pub use problems::{Chain, Chains, Family, example_of_ruckig};

#[derive(Clone, Debug, PartialEq)]
pub struct Path<R> {
    pub states: Vec<State<R>>, // point by point
    pub durations: Vec<R>,     // of the sections, s
}

impl<R: Real> Path<R> {
    pub fn duration(&self) -> f64 {
        self.durations.iter().map(|t| t.widen()).sum()
    }

    /// Its motions, section by section, and what they find.
    pub fn moves(&self, chain: &Chain<R>) -> Result<(Vec<Move<R>>, Findings), Error> {
        let mut moves = vec![Move::default(); chain.axes * self.durations.len()];
        let found = path_moves(&mut moves, &chain.limits, &self.states, &self.durations, chain.axes)?;
        Ok((moves, found))
    }
}

pub trait Planner<R: Real> {
    fn plan(&self, chain: &Chain<R>, steps: u32) -> Result<(Path<R>, Findings), Error> {
        let mut path = Path { states: chain.states.clone(), durations: vec![R::NAN; chain.sections()] };
        let mut work = vec![R::NAN; path_size(chain.axes, chain.sections()).expect("a size")];
        let found = plan_path(&mut path.states, &mut path.durations, &chain.limits, chain.axes, steps, &mut work)?;
        Ok((path, found))
    }

    /// The path through zones around the points.
    fn plan_near(&self, chain: &Chain<R>, tolerances: &[R], steps: u32) -> Result<(Path<R>, Findings), Error> {
        let mut path = Path { states: chain.states.clone(), durations: vec![R::NAN; chain.sections()] };
        let mut work = vec![R::NAN; path_size_near(chain.axes, chain.sections()).expect("a size")];
        let Path { states, durations } = &mut path;
        let found = plan_path_near(states, durations, &chain.limits, tolerances, chain.axes, steps, &mut work)?;
        Ok((path, found))
    }

    fn improve(&self, chain: &Chain<R>, path: &mut Path<R>, steps: u32) -> Result<Findings, Error> {
        let mut work = vec![R::NAN; path_size(chain.axes, chain.sections()).expect("a size")];
        improve_path(&mut path.states, &mut path.durations, &chain.limits, chain.axes, steps, &mut work)
    }
}

pub struct Paths;

impl<R: Real> Planner<R> for Paths {}

/// What is left of a path that is followed, `left` seconds before the end of its first section.
pub fn under_way<R: Original>(limits: &[Limits<R>], path: &Path<R>, left: R) -> Path<R> {
    let axes = limits.len();
    let (from, to) = (&path.states[..axes], &path.states[axes..2 * axes]);
    let moves = online::together(limits, from, to, path.durations[0]);
    let now = path.durations[0] - left;
    let mut rest = path.clone();
    let at_once = moves.iter().map(|axis| axis.state_at(now));
    rest.states.splice(..axes, at_once);
    rest.durations[0] = path.durations[0] - now;
    rest
}

/// How far a point is from the straight line between two others.
pub fn distance(point: &[f64], [from, to]: [&[f64]; 2]) -> f64 {
    let dot = |x: &dyn Fn(usize) -> f64, y: &dyn Fn(usize) -> f64| (0..point.len()).map(|k| x(k) * y(k)).sum::<f64>();
    let (line, offset) = (|k: usize| to[k] - from[k], |k: usize| point[k] - from[k]);
    let square = dot(&line, &line);
    let part = if square > 0.0 { (dot(&offset, &line) / square).clamp(0.0, 1.0) } else { 0.0 };
    let off = |k: usize| offset(k) - part * line(k);
    dot(&off, &off).sqrt()
}

/// By which part of its promised duration a section may last longer or shorter: 4 ulps.
pub fn promised<R: Real>() -> f64 {
    4.0 * R::MACHINE_EPSILON.widen()
}

/// What is wrong with a path, if something is.
pub fn check<R: Original>(chain: &Chain<R>, path: &Path<R>, found: Findings, random: &mut Random) -> Check<String> {
    let exact = vec![R::ZERO; chain.axes * (chain.sections() - 1)];
    check_near(chain, &exact, path, found, random)
}

/// What is wrong with a path through zones around the points, if something is.
pub fn check_near<R: Original>(
    chain: &Chain<R>, tolerances: &[R], path: &Path<R>, found: Findings, random: &mut Random,
) -> Check<String> {
    let axes = chain.axes;
    let last = chain.sections() * axes;
    let ends = |states: &[State<R>]| [states[..axes].to_vec(), states[last..].to_vec()];
    if ends(&path.states) != ends(&chain.states) {
        return Err("an end is not the given one".into());
    }
    let positions = path.states.iter().zip(&chain.states).map(|(x, y)| [x.position, y.position]);
    let none = vec![R::ZERO; axes];
    let tolerances = none.iter().chain(tolerances).chain(&none);
    for ([x, y], tolerance) in positions.zip(tolerances) {
        let is_exact = x.low_bits() == y.low_bits();
        let is_near = (x.widen() - y.widen()).abs() <= tolerance.widen();
        if !(is_exact || is_near && tolerance.widen() > 0.0) {
            return Err(format!("a position is {x:?} instead of {y:?}, and the tolerance is {tolerance:?}"));
        }
    }
    for section in 0..chain.sections() {
        check_section(chain, path, section, found, random).map_err(|what| format!("section {section}: {what}"))?;
    }
    Ok(())
}

fn check_section<R: Original>(
    chain: &Chain<R>, path: &Path<R>, section: usize, found: Findings, random: &mut Random,
) -> Check<String> {
    let axes = chain.axes;
    let limits = chain.limits(section);
    let [from, to] = [section, section + 1].map(|point| &path.states[point * axes..][..axes]);
    let promise = path.durations[section];
    let mut moves = vec![Move::default(); axes];
    let planned = synchronise(&mut moves, limits, from, to, promise, R::ZERO).map_err(|error| format!("{error:?}"))?;
    let outside = |found: Findings| found.contains(Findings::STARTS_OUTSIDE);
    if outside(planned) != (section == 0 && outside(found)) && (section > 0 || !outside(found)) {
        return Err("STARTS_OUTSIDE is not what it finds".into());
    }
    let leaves = |found: Findings| found.contains(Findings::ENDS_LEAVING);
    let is_last = section + 1 == chain.sections();
    if leaves(planned) != (is_last && leaves(found)) {
        return Err("ENDS_LEAVING is not what it finds".into());
    }
    let (t, promise) = (moves[0].t.widen(), promise.widen());
    let tolerance = promised::<R>();
    if !(t <= promise * (1.0 + tolerance) && t >= promise * (1.0 - tolerance)) {
        return Err(format!("it takes {t:e} instead of {promise:e}"));
    }
    for (axis, planned) in moves.iter().enumerate() {
        let (limits, from, to) = (limits[axis], from[axis], to[axis]);
        let trial = Trial::new(Problem { kind: Kind::Accelerated, request: Request::Plan, limits, from, to });
        let more = scale_of_short_ramps(&trial, t);
        trial.check_states(&plan_of(planned), &more, random).map_err(|what| format!("axis {axis}: {what}"))?;
    }
    Ok(())
}

/// How long the path takes that stops at every waypoint, s. A section in which nothing moves takes no time.
pub fn stopping<R: Real>(chain: &Chain<R>) -> f64 {
    let (axes, sections) = (chain.axes, chain.sections());
    let mut states = chain.states.clone();
    for state in &mut states[axes..sections * axes] {
        *state = State::at(state.position);
    }
    let duration = |section: usize| {
        let [from, to] = [section, section + 1].map(|point| &states[point * axes..][..axes]);
        let mut moves = vec![Move::default(); axes];
        let planned = synchronise(&mut moves, chain.limits(section), from, to, R::ZERO, R::ZERO);
        planned.map_or(f64::INFINITY, |_| moves[0].t.widen())
    };
    (0..sections).map(duration).sum()
}

/// What is wrong with the plan of a path, and how long it takes compared with stops.
pub fn judge<R: Original>(planner: &impl Planner<R>, chain: &Chain<R>, random: &mut Random) -> Result<f64, String> {
    let (path, found) = planner.plan(chain, 0).map_err(|error| format!("{error:?}"))?;
    check(chain, &path, found, random)?;
    let part = path.duration() / stopping(chain);
    // Sums have roundings, and the shortest duration of a section is known up to some.
    let roundings = 64.0 * R::MACHINE_EPSILON.widen();
    if part > 1.0 + roundings {
        return Err(format!("it takes {part} of the path with stops"));
    }
    Ok(if part.is_nan() { 1.0 } else { part })
}

/// What is wrong with the plan of a path through zones around the points, and how long it takes compared with the path through the points.
pub fn judge_near<R: Original>(chain: &Chain<R>, tolerances: &[R], random: &mut Random) -> Result<f64, String> {
    let (path, found) = Paths.plan_near(chain, tolerances, 0).map_err(|error| format!("{error:?}"))?;
    check_near(chain, tolerances, &path, found, random)?;
    let (exact, expected) = Paths.plan(chain, 0).map_err(|error| format!("{error:?}"))?;
    // The sums have other roundings here.
    let longest = exact.duration() * (1.0 + 4.0 * R::MACHINE_EPSILON.widen());
    if found != expected || path.duration() > longest {
        return Err(format!("it takes {} s, and {} s through the points", path.duration(), exact.duration()));
    }
    Ok(if exact.duration() > 0.0 { path.duration() / exact.duration() } else { 1.0 })
}
