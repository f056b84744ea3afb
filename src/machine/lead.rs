//! The stop of axes on one straight line: that of the axis with the largest displacement, which needs no reserve.

use super::change::Law;
use crate::findings::Error;
use crate::interval::rounding::of_check;
use crate::limits::Limits;
use crate::online::Move;
use crate::real::Real;
use crate::several::line::goes_along;
use crate::state::State;

/// A law, and the lead whose positions it gives; no lead if the axes go on to the end.
type Stop<R> = (Law<R>, Option<Move<R>>);

/// Writes the lead's fastest stop to `stop`, if the path is one straight section from rest to rest. `time` is its time and its derivatives. The
/// positions of the lead count from its start.
#[inline(never)] // for its stack
pub(super) fn stop<R: Real>(
    moves: &[Move<R>], limits: &[Limits<R>], time: [R; 4], stop: &mut Move<R>,
) -> Result<Option<Stop<R>>, Error> {
    let displacement = |of: &Move<R>| of.end().position - of.start().position;
    let Some(first) = moves.first().filter(|_| moves.len() == limits.len()) else { return Ok(None) };
    let farther = |one: &Move<R>, other: &Move<R>| displacement(one).abs() < displacement(other).abs();
    let lead = moves.iter().fold(first, |lead, of| if farther(lead, of) { of } else { lead });
    let mut tightest = Limits::endless();
    for (of, limits) in moves.iter().zip(limits) {
        let share = displacement(of) / displacement(lead);
        // Phase 1 begins at the start too.
        let is_along = of.t == lead.t && goes_along(share, of, lead, 2);
        if !(of.start().is_at_rest() && of.end().is_at_rest() && is_along) {
            return Ok(None);
        }
        tightest.tighten(limits, share);
    }
    let mut lead = *lead;
    lead.count_from_start();
    let [s, rate, slowing, _] = time;
    let State { position, velocity, acceleration } = lead.state_at(s);
    let from =
        State { position, velocity: velocity * rate, acceleration: acceleration * rate * rate + velocity * slowing };
    let is_plain = stop.stop(&tightest, from)?.is_empty();
    let end = lead.end().position;
    let is_within = is_plain && !stop.extremes().overshoots(R::ZERO, end, of_check(end.abs()));
    // Without a reserve the rest of a brake is the stop, and on the way back the rest of the first ramp.
    let border = if rate > R::ZERO { end } else { R::ZERO };
    let ends_at_border = (border - stop.end().position).abs() <= of_check(end.abs());
    if is_within && rate.abs() == R::ONE && slowing == R::ZERO && ends_at_border {
        stop.stay(State { velocity: rate, ..State::at(s) });
        stop.go_to_the_end(lead.t).ok_or(Error::Target)?;
        return Ok(Some((Law { until: stop.t, is_reached: false }, None)));
    }
    // A low velocity of the lead, compared with its highest, has a large rounding error where the rate is divided by it. And the time since a later
    // phase began is not known before it has passed many rounding errors of its positions: 64 times those of a check.
    let extremes = lead.extremes();
    let least = R::EPSILON.sqrt() * extremes.speed();
    let least_now = least.at_least((R::from(64) * of_check(end.abs()) * extremes.acceleration()).sqrt());
    let [stands, ..] = along(&lead, stop.state(stop.t));
    let is_exact = |x: R, least: R| x < lead.phase[2].start || lead.velocity(x).abs() > least;
    let is_exact = is_exact(s, least_now) && is_exact(stands, least);
    let law = Law { until: stop.t, is_reached: stands < lead.t };
    Ok((is_within && is_exact).then_some((law, Some(lead))))
}

/// The time of the path and its derivatives where the lead has these position, velocity, acceleration and jerk.
pub(super) fn along<R: Real>(lead: &Move<R>, [position, velocity, acceleration, jerk]: [R; 4]) -> [R; 4] {
    let (zero, end) = (R::ZERO, lead.end().position);
    let beyond = (position - end).abs() <= (position - lead.start().position).abs();
    let s = lead.time_at(position).unwrap_or(if beyond { lead.t } else { zero });
    let [_, v, a, j] = lead.state(s);
    if v == zero {
        return [s, zero, zero, zero];
    }
    let rate = velocity / v;
    let square = rate * rate;
    let slowing = (acceleration - a * square) / v;
    [s, rate, slowing, (jerk - j * square * rate - R::from(3) * a * rate * slowing) / v]
}
