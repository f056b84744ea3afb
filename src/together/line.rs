//! Several axes on the straight line from their start to their end.

use super::axis::{checked, next_duration, stretch};
use super::cycle::Cycle;
use crate::findings::{Error, Findings};
use crate::limits::Limits;
use crate::online::problem::Problem;
use crate::online::{Move, Phase};
use crate::real::Real;
use crate::state::State;

/// Plans all axes on the straight line from their start to their end: the fastest motion on it that lasts at least `duration` and a multiple
/// of `cycle` (0: any), s.
///
/// [`Error::Line`] if the velocities and accelerations do not point along the line. An error of any axis is returned, and then no axis is
/// written.
pub fn line<R: Real>(
    axes: &mut [Move<R>],
    limits: &[Limits<R>],
    from: &[State<R>],
    to: &[State<R>],
    duration: R,
    cycle: R,
) -> Result<Findings, Error> {
    let cycle = Cycle::new(duration, cycle)?;
    let ends = checked(axes.len(), limits, from, to)?;
    let line = Line::through(from, to)?;
    let limits = line.tightest(limits, from, to)?;
    limits.check(line.from, line.to)?;
    let problem = Problem::new(&limits, line.from, line.to);
    let mut lead = Move::default();
    problem.write(&mut lead, &problem.fastest())?;
    let ends_of_lead = (&limits, (&line.from, &line.to));
    let slowest = duration.at_least(lead.t);
    let t = cycle.until_possible(1, slowest, |t| next_duration(ends_of_lead, t))?;
    stretch(&mut lead, t, ends_of_lead)?;
    for ((_, (from, to)), axis) in ends.zip(axes) {
        let share = line.share(from, to);
        *axis = lead.map(|phase| Phase {
            position: to.position + share * phase.position,
            velocity: share * phase.velocity,
            acceleration: share * phase.acceleration,
            jerk: share * phase.jerk,
            ..*phase
        });
        axis.set_ends(*from, *to);
    }
    Ok(problem.findings(&lead))
}

/// A straight line in the space of all axes. The axis with the longest way leads. Its positions are counted from its end, so they have the
/// roundings of the way alone.
struct Line<R> {
    /// The lead at the start.
    from: State<R>,
    /// The lead at the end.
    to: State<R>,
}

impl<R: Real> Line<R> {
    /// The line through both ends, if all velocities and accelerations point along it.
    fn through(from: &[State<R>], to: &[State<R>]) -> Result<Self, Error> {
        let mut line = Self {
            from: State::default(),
            to: State::default(),
        };
        for (from, to) in from.iter().zip(to) {
            let way = to.position - from.position;
            if way.abs() >= line.way().abs() {
                let position = -way;
                line.from = State { position, ..*from };
                line.to = State {
                    position: R::ZERO,
                    ..*to
                };
            }
        }
        if !line.way().is_finite() {
            return Err(Error::NotFinite);
        }
        let mut ends = from.iter().zip(to);
        let is_straight = ends.all(|(from, to)| {
            let share = line.share(from, to);
            lies_on(share, from, &line.from) && lies_on(share, to, &line.to)
        });
        if is_straight {
            Ok(line)
        } else {
            Err(Error::Line)
        }
    }

    fn way(&self) -> R {
        self.to.position - self.from.position
    }

    /// How far an axis moves while the lead moves by 1; 0 if nothing moves.
    fn share(&self, from: &State<R>, to: &State<R>) -> R {
        if self.way() == R::ZERO {
            R::ZERO
        } else {
            (to.position - from.position) / self.way()
        }
    }

    /// The limits of the lead that keep those of all axes.
    fn tightest(
        &self,
        limits: &[Limits<R>],
        from: &[State<R>],
        to: &[State<R>],
    ) -> Result<Limits<R>, Error> {
        let first = *limits.first().ok_or(Error::Axes)?;
        if self.way() == R::ZERO {
            return Ok(first);
        }
        let endless = R::INFINITY;
        let mut tightest = Limits::symmetric(endless, endless, endless);
        for (limits, (from, to)) in limits.iter().zip(from.iter().zip(to)) {
            tightest.tighten(limits, self.share(from, to));
        }
        Ok(tightest)
    }
}

/// Whether velocity and acceleration are those of the lead times `share`.
fn lies_on<R: Real>(share: R, state: &State<R>, lead: &State<R>) -> bool {
    let agree = |x: R, y: R| (x - share * y).abs() <= R::DOUBT * (x.abs() + (share * y).abs());
    agree(state.velocity, lead.velocity) && agree(state.acceleration, lead.acceleration)
}
