//! A path that stays near its lines: points are added on the lines that it leaves too far.

use super::{chain::Request, deviation::path_deviation, moves::write_moves, path_size, plan};
use crate::findings::{Error, Findings};
use crate::limits::Limits;
use crate::online::Move;
use crate::real::Real;
use crate::state::State;

/// How often a section is halved at most: then its parts are as short as the rounding errors of binary32. A star needs 11 for 1/10,000 of its lines.
const MOST_ROUNDS: u32 = 24;

/// A path with room for more points. [`plan_contour`] writes what is planned to the front of the lists.
pub struct Contour<'a, R> {
    /// The moves of all axes, section by section: room for as many sections as the path may get.
    pub moves: &'a mut [Move<R>],
    /// The states of all axes, point by point: the given points, and room for all of the path. The states between start and end are written.
    pub states: &'a mut [State<R>],
    /// The durations of the sections, s.
    pub durations: &'a mut [R],
    /// At which point of the path each given point stands. The last number is how many sections the path has.
    pub places: &'a mut [usize],
}

/// Plans a path that stays within `tolerance` of the straight lines between its points, unit, and the moves of its sections. Where it leaves a line
/// too far, points are added in the middle of the section, as often as it is necessary.
///
/// The given points, one for each of [`places`](Contour::places), stand at the front of [`states`](Contour::states). `limits` has an entry for each of the
/// `axes`, or for each axis given section by given section; both parts of a section keep its limits. `work` has
/// [`path_size`](super::path_size) numbers for as many sections as there are [`durations`](Contour::durations). Each of at most 24 rounds plans a path
/// with `steps` steps. Points that [`plan_path_near`](super::plan_path_near) has moved by at most `r` may be given: the path is within
/// `tolerance + r` of the lines between those that it was given.
///
/// Returns the findings of [`path_moves`](super::path_moves), whose motions are written, and the errors of [`plan_path`](super::plan_path).
/// [`Error::Axes`] also if a list has another length, or there is no room for the given points; [`Error::Limits`] also if the tolerance is not above 0,
/// [`Error::NotFinite`] if it is not a number. [`Error::Position`] if the room or the rounds end before the path is near enough. Then a path that leaves
/// its lines farther is written, and [`path_deviation`](super::path_deviation) says how far: give more room, or ends that do not leave their lines.
///
/// `examples/23_contour.rs` is a program.
pub fn plan_contour<R: Real>(
    path: Contour<R>, limits: &[Limits<R>], tolerance: R, axes: usize, steps: u32, work: &mut [R],
) -> Result<Findings, Error> {
    let Contour { moves, states, durations, places } = path;
    let room = durations.len();
    path_size(axes, room).filter(|&size| size <= work.len()).ok_or(Error::Axes)?;
    Error::Axes.unless(moves.len() == axes * room && states.len() == axes * (room + 1))?;
    Error::NotFinite.unless(tolerance.is_finite())?;
    Error::Limits.unless(tolerance > R::ZERO)?;
    let given = places.len().saturating_sub(1);
    let points = states.get(..axes * (given + 1)).ok_or(Error::Axes)?;
    Request::of(points, durations.get(..given).ok_or(Error::Axes)?, limits, axes)?;
    // `path_deviation` may exceed the bound of each section by a 256th.
    let most = tolerance - R::SIXTEENTH * R::SIXTEENTH * tolerance;
    for (point, place) in places.iter_mut().enumerate() {
        *place = point;
    }
    for round in 1..=MOST_ROUNDS {
        let sections = places.last().copied().unwrap_or(0);
        let (planned, _) = states.split_at_mut_checked(axes * (sections + 1)).ok_or(Error::Axes)?;
        let (lasting, _) = durations.split_at_mut_checked(sections).ok_or(Error::Axes)?;
        let (moves, _) = moves.split_at_mut_checked(axes * sections).ok_or(Error::Axes)?;
        plan(Request::of_parts(planned, lasting, limits, axes, places)?, steps, work)?.write(planned, lasting);
        let found = write_moves(moves, Request::of_parts(planned, lasting, limits, axes, places)?, lasting)?;
        let is_far = |section: usize| {
            let moves = moves.get(section * axes..(section + 1) * axes).unwrap_or_default();
            let stays = path_deviation(moves, axes) <= most; // false for NaN
            !stays
        };
        let mut far = 0;
        for section in 0..sections {
            far += usize::from(is_far(section));
        }
        if far == 0 {
            return Ok(found);
        }
        if sections + far > room || round == MOST_ROUNDS {
            break;
        }
        let mut end = sections + far;
        for section in (0..sections).rev() {
            if let Some(place) = places.binary_search(&(section + 1)).ok().and_then(|given| places.get_mut(given)) {
                *place = end;
            }
            let is_far = is_far(section);
            move_end(states, axes, section, end, is_far);
            end -= 1 + usize::from(is_far);
        }
    }
    Err(Error::Position)
}

/// Moves the states at the end of a section to the point `to`, and writes the middle of the section to the point before it, if it is halved.
fn move_end<R: Real>(states: &mut [State<R>], axes: usize, section: usize, to: usize, is_halved: bool) {
    for axis in 0..axes {
        let [start, end] =
            [section, section + 1].map(|point| states.get(point * axes + axis).copied().unwrap_or_default());
        let middle = State::at(start.position + R::HALF * (end.position - start.position));
        let written = [(to, end), (to - 1, middle)];
        for (point, state) in written.into_iter().take(if is_halved { 2 } else { 1 }) {
            if let Some(place) = states.get_mut(point * axes + axis) {
                *place = state;
            }
        }
    }
}
