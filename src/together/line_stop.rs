//! The stop of axes that move on a straight line, on this line.

use crate::findings::{Error, Findings};
use crate::limits::Limits;
use crate::online::{Move, Phase};
use crate::real::Real;
use crate::state::State;

/// Stops axes that move on a straight line, on this line, from the time `x` on, s: a feed hold. Each move becomes its stop, which begins at its
/// time 0. The lead makes its fastest stop within the tightest limits of all, so no reserve is needed.
///
/// [`Error::Line`] if the moves are not on one straight line. It returns the findings and the other errors of [`Move::stop`], and
/// [`Error::Axes`] if there is no axis or the slices have different lengths. On an error no axis is written.
pub fn line_stop<R: Real>(
    axes: &mut [Move<R>],
    limits: &[Limits<R>],
    x: R,
) -> Result<Findings, Error> {
    if axes.len() != limits.len() {
        return Err(Error::Axes);
    }
    let way = |axis: &Move<R>| axis.position(axis.t) - axis.position(R::ZERO);
    let mut lead = *axes.first().ok_or(Error::Axes)?;
    for axis in axes.iter() {
        if way(axis).abs() > way(&lead).abs() {
            lead = *axis;
        }
    }
    let share = |axis: &Move<R>| {
        if way(&lead) == R::ZERO {
            R::ONE
        } else {
            way(axis) / way(&lead)
        }
    };
    let now = lead.state_at(x);
    let endless = R::INFINITY;
    let mut tightest = Limits::symmetric(endless, endless, endless);
    for (axis, limits) in axes.iter().zip(limits) {
        limits.are_limits()?;
        if !goes_beside(share(axis), axis, &lead) {
            return Err(Error::Line);
        }
        tightest.tighten(limits, share(axis));
    }
    let mut stop = Move::default();
    let found = stop.stop(
        &tightest,
        State {
            position: R::ZERO,
            ..now
        },
    )?;
    for axis in axes {
        let (share, position) = (share(axis), axis.position(x));
        *axis = stop.map(|phase| Phase {
            position: position + share * phase.position,
            velocity: share * phase.velocity,
            acceleration: share * phase.acceleration,
            jerk: share * phase.jerk,
            ..*phase
        });
    }
    Ok(found)
}

/// Whether every phase of the move is that of the lead times `share`.
fn goes_beside<R: Real>(share: R, axis: &Move<R>, lead: &Move<R>) -> bool {
    let state = |phase: &Phase<R>| State {
        position: phase.position,
        velocity: phase.velocity,
        acceleration: phase.acceleration,
    };
    let mut phases = axis
        .phase
        .iter()
        .zip(&lead.phase)
        .take(1 + lead.phases().len());
    let are_beside = phases.all(|(phase, other)| {
        phase.start == other.start && lies_on(share, &state(phase), &state(other))
    });
    are_beside && axis.count == lead.count
}

/// Whether velocity and acceleration are the lead's, times `share`.
fn lies_on<R: Real>(share: R, state: &State<R>, lead: &State<R>) -> bool {
    let agree = |x: R, y: R| (x - share * y).abs() <= R::DOUBT * (x.abs() + (share * y).abs());
    agree(state.velocity, lead.velocity) && agree(state.acceleration, lead.acceleration)
}
