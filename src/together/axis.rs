//! One axis among several.

use super::blend::Blend;
use crate::findings::Error;
use crate::limits::Limits;
use crate::online::Move;
use crate::online::problem::Problem;
use crate::real::Real;
use crate::state::State;

/// The limits of an axis, and its states at the start and at the end.
pub(super) type Axis<'a, R> = (&'a Limits<R>, (&'a State<R>, &'a State<R>));

/// Limits and states of the axes, if each of them can be planned.
pub(super) fn checked<'a, R: Real>(
    count: usize,
    limits: &'a [Limits<R>],
    from: &'a [State<R>],
    to: &'a [State<R>],
) -> Result<impl Iterator<Item = Axis<'a, R>> + Clone, Error> {
    let differ = limits.len() != count || from.len() != count || to.len() != count;
    if count == 0 || differ {
        return Err(Error::Axes);
    }
    let ends = limits.iter().zip(from.iter().zip(to));
    for (limits, (&from, &to)) in ends.clone() {
        limits.check(from, to)?;
    }
    Ok(ends)
}

/// Duration of the fastest motion, if numbers are in range.
pub(super) fn shortest<R: Real>(problem: &Problem<R>) -> Result<R, Error> {
    let t = problem.duration(&problem.fastest());
    let (h, positions) = problem.displacement();
    if (t + h.abs() + positions).is_finite() {
        Ok(t)
    } else {
        Err(Error::NotFinite)
    }
}

/// Writes the fastest motion if it takes as long as `t`, else a slower one.
pub(super) fn write<R: Real>(problem: &Problem<R>, axis: &mut Move<R>, t: R) -> Result<(), Error> {
    let fastest = problem.fastest();
    let is_slower = problem.duration(&fastest) < t;
    match Blend::of(problem, t).filter(|_| is_slower) {
        Some(blend) => blend.write(problem, axis, t),
        None => {
            problem.write(axis, &fastest)?;
            axis.end_at(t);
        }
    }
    Ok(())
}
