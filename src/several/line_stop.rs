//! The stop of axes that move on a straight line, on this line.

use crate::findings::{Error, Findings};
use crate::interval::rounding::of_check;
use crate::limits::Limits;
use crate::online::{Move, Phase};
use crate::real::Real;
use crate::state::State;

/// Stops axes that move on a straight line, on this line, from the time `x` on, s: a feed hold. Each move becomes its stop, which begins at its
/// time 0. The lead makes its fastest stop within the tightest limits of all, so no reserve is needed.
///
/// A time before the start is the start; after the end, the axes move on. An infinite time and NaN are the end.
///
/// [`Error::Line`] if the moves are not on one straight line. It returns the findings and the other errors of [`Move::stop`], and
/// [`Error::Axes`] if there is no axis or the slices have different lengths. On an error no axis is written.
pub fn line_stop<R: Real>(axes: &mut [Move<R>], limits: &[Limits<R>], x: R) -> Result<Findings, Error> {
    Error::Axes.unless(axes.len() == limits.len())?;
    let Highest { lead, place, order } = find_highest(axes);
    let lead = *axes.get(lead).ok_or(Error::Axes)?;
    let number = |axis: &Move<R>| axis.phase.get(place).map_or(R::ZERO, |phase| derivative(phase, order));
    let share = |axis: &Move<R>| if number(&lead) == R::ZERO { R::ONE } else { number(axis) / number(&lead) };
    let now = lead.state_at(x);
    let mut tightest = Limits::symmetric(R::INFINITY, R::INFINITY, R::INFINITY);
    // The states at both ends are the caller's, with rounding errors of their own, so they count only where there are no others.
    let first = usize::from(lead.phases().len() > 1);
    for (axis, limits) in axes.iter().zip(limits) {
        limits.are_limits()?;
        Error::Line.unless(goes_along(share(axis), axis, &lead, first))?;
        tightest.tighten(limits, share(axis));
    }
    let mut stop = Move::default();
    let found = stop.stop(&tightest, State { position: R::ZERO, ..now })?;
    let scaled = |axis: &Move<R>| stop.scaled(axis.position(x), share(axis));
    let is_finite = |axis: &Move<R>| scaled(axis).end().position.is_finite();
    Error::NotFinite.unless(axes.iter().all(is_finite))?;
    for axis in axes {
        *axis = scaled(axis);
    }
    Ok(found)
}

/// Where the highest number of all axes is: the axis, the number of its phase, and the order of the derivative.
struct Highest {
    lead: usize,
    place: usize,
    order: u8,
}

/// A derivative of the position at the start of a phase: velocity, acceleration, jerk.
fn derivative<R: Real>(phase: &Phase<R>, order: u8) -> R {
    match order {
        1 => phase.velocity,
        2 => phase.acceleration,
        _ => phase.jerk,
    }
}

/// The highest number in the phases of all axes: of the jerks, else of the accelerations, else of the velocities. Each has one rounding, so it
/// gives the shares of the axes. Their displacements may be so short that rounding hides them.
fn find_highest<R: Real>(axes: &[Move<R>]) -> Highest {
    let (mut size, mut highest) = (R::ZERO, Highest { lead: 0, place: 0, order: 1 });
    for order in [3, 2, 1] {
        for (lead, axis) in axes.iter().enumerate() {
            for (place, phase) in axis.phases().iter().enumerate() {
                let number = derivative(phase, order).abs();
                if number > size {
                    (size, highest) = (number, Highest { lead, place, order });
                }
            }
        }
        if size > R::ZERO {
            break;
        }
    }
    highest
}

/// Whether every phase of the move, from number `first` on, is that of the lead times `share`.
pub(crate) fn goes_along<R: Real>(share: R, axis: &Move<R>, lead: &Move<R>, first: usize) -> bool {
    let agree = |x: R, y: R| (x - share * y).abs() <= of_check(x.abs() + (share * y).abs());
    let go_along = |(one, other): (&Phase<R>, &Phase<R>)| {
        one.start == other.start && agree(one.velocity, other.velocity) && agree(one.acceleration, other.acceleration)
    };
    axis.count == lead.count && axis.phases().iter().zip(lead.phases()).skip(first).all(go_along)
}
