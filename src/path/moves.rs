//! The motions of a planned path.

use super::chain::{Request, most_late, total};
use crate::findings::{Error, Findings};
use crate::limits::Limits;
use crate::online::Move;
use crate::real::Real;
use crate::several::axis::checked;
use crate::several::cycle::Cycle;
use crate::several::synchronise;
use crate::state::State;

/// Plans the motions of a path: the moves of all axes for the first section, then of all axes for the second one, as
/// [`machine::Clock`](crate::machine::Clock) takes them.
///
/// `limits`, `states` and `durations` are those of [`plan_path`](crate::axes::plan_path) or [`improve_path`](crate::axes::improve_path), and
/// `moves` has an entry for each axis and section. [`synchronise`](crate::axes::synchronise) makes the motions of a section, with its
/// duration as the least one. In a section of the duration 0 the moves stand.
///
/// Returns the findings of all sections, and the errors of [`plan_path`](crate::axes::plan_path) and
/// [`synchronise`](crate::axes::synchronise). Then no move is written. Two errors are found while the moves are written, section by section,
/// and leave those up to this section: [`Error::Duration`] if a section takes longer than its duration, by more than `sqrt(ε)` times the
/// duration of the path, and [`Error::NotFinite`] if a motion is beyond the range of the real type.
pub fn path_moves<R: Real>(
    moves: &mut [Move<R>], limits: &[Limits<R>], states: &[State<R>], durations: &[R], axes: usize,
) -> Result<Findings, Error> {
    write_moves(moves, Request::of(states, durations, limits, axes)?, durations)
}

pub(super) fn write_moves<R: Real>(
    moves: &mut [Move<R>], request: Request<R>, durations: &[R],
) -> Result<Findings, Error> {
    let axes = request.axes;
    Error::Axes.unless(moves.len() == axes * durations.len())?;
    for (section, &duration) in durations.iter().enumerate() {
        let [from, to] = request.ends(section);
        checked(axes, request.zone(section), from, to).map(drop)?;
        Cycle::new(duration, R::ZERO)?;
    }
    let late = most_late(total(durations));
    let mut found = Findings::default();
    let mut rest = moves;
    for (section, &duration) in durations.iter().enumerate() {
        let (moves, later) = rest.split_at_mut_checked(axes).ok_or(Error::Axes)?;
        rest = later;
        let [from, to] = request.ends(section);
        found |= synchronise(moves, request.zone(section), from, to, duration, R::ZERO)?;
        let lasts = moves.first().map_or(R::ZERO, |first| first.t);
        Error::Duration.unless(lasts <= duration + late)?;
    }
    Ok(found)
}
