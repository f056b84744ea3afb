//! Several axes on the straight line from their start to their end.

use super::axis::{Axis, checked, may_slip, next_of_plan, stretch};
use super::cycle::Cycle;
use crate::findings::{Error, Findings};
use crate::limits::Limits;
use crate::online::Move;
use crate::online::problem::Problem;
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
    let line = Line::through(ends.clone())?;
    let limits = line.tightest(ends.clone())?;
    limits.check(line.from, line.to)?;
    line.check(&limits, ends.clone())?;
    let problem = Problem::new(&limits, line.from, line.to).beside(line.positions);
    let mut lead = Move::default();
    problem.write(&mut lead, &problem.fastest())?;
    let t = cycle.until_possible(
        1,
        duration.at_least(lead.t),
        |t| next_of_plan(&lead, &|| problem, t),
        |t, is_detour| may_slip(&lead, &problem, t, is_detour),
    )?;
    stretch(&mut lead, &|| problem, t)?;
    for ((_, (from, to)), axis) in ends.zip(axes) {
        *axis = lead.beside(to.position, line.share(from, to));
        axis.set_ends(*from, *to);
    }
    Ok(problem.findings(&lead))
}

/// A straight line in the space of all axes. The axis with the longest way leads; of ways that are as long, the one with the finest
/// roundings. Its positions are counted from its end, so they have the roundings of the way alone.
struct Line<R> {
    /// The lead at the start.
    from: State<R>,
    /// The lead at the end.
    to: State<R>,
    /// The sum of the magnitudes of the lead's true positions, which tells their rounding.
    positions: R,
    /// How long the slowest axis takes to brake, s.
    braking: R,
    /// How far the velocity at the start tells the direction of the line, beside the way, s. A way that is much shorter than the axis takes
    /// to brake has the roundings of all the numbers before, so it tells the direction badly.
    by_start: R,
    /// How far the velocity at the end tells it, s, and the acceleration there, s². Both stay in a loop, in which the roundings of all ticks
    /// turn the way.
    by_end: (R, R),
}

impl<'a, R: Real + 'a> Line<R> {
    /// The line along which the axis with the longest way leads.
    fn through(ends: impl Iterator<Item = Axis<'a, R>> + Clone) -> Result<Self, Error> {
        let braking = ends.clone().map(braking).fold(R::ZERO, R::at_least);
        let leads = ends.map(|(limits, (from, to))| {
            let line = Self {
                from: State {
                    position: from.position - to.position,
                    ..*from
                },
                to: State {
                    position: R::ZERO,
                    ..*to
                },
                positions: from.position.abs() + to.position.abs(),
                braking,
                by_start: braking,
                by_end: (braking, R::ZERO),
            };
            (line, limits)
        });
        let longer = |one: (Self, _), other: (Self, _)| {
            let (certain, least) = (other.0.certain(), one.0.certain());
            if certain > least || certain == least && other.0.positions < one.0.positions {
                other
            } else {
                one
            }
        };
        let (mut line, limits) = leads.reduce(longer).ok_or(Error::Axes)?;
        let way = line.from.position.abs();
        if way > R::HALF * line.reach() {
            line.by_start = R::ZERO;
            line.by_end = line.weights_of_end(limits);
        }
        if line.base().is_finite() && line.reach().is_finite() {
            Ok(line)
        } else {
            Err(Error::NotFinite)
        }
    }

    /// How far the velocity and the acceleration at the end tell the direction of a long way: as much as the way. A small number tells less,
    /// because it has the roundings of higher ones.
    fn weights_of_end(&self, limits: &Limits<R>) -> (R, R) {
        if self.to.is_at_rest() {
            return (R::ZERO, R::ZERO);
        }
        let way = self.from.position.abs();
        let (v, a) = highest(limits, way);
        let weight = |x: R, highest: R| {
            let weight = (way / x.abs()).at_most(R::from(4) * way / highest);
            if weight.is_finite() { weight } else { R::ZERO }
        };
        (weight(self.to.velocity, v), weight(self.to.acceleration, a))
    }

    /// The way, and what the velocities at both ends travel while the axis brakes. It does not vanish where the axis passes its target.
    fn reach(&self) -> R {
        self.from.position.abs() + self.braking * self.speeds()
    }

    /// The reach without the part that the roundings of the positions make uncertain.
    fn certain(&self) -> R {
        let reach = self.reach();
        // Both positions and their difference are rounded.
        let uncertain = R::from(4) * R::EPSILON * self.positions;
        let part = reach / (reach + uncertain);
        if part > R::ZERO { reach * part } else { reach }
    }

    fn speeds(&self) -> R {
        self.from.velocity.abs() + self.to.velocity.abs()
    }

    /// How far an axis moves while the lead moves by 1; 0 if nothing moves.
    fn share(&self, from: &State<R>, to: &State<R>) -> R {
        let along = |x: R, lead: R| x * R::ONE.copysign(lead);
        let start = self.by_start * along(from.velocity, self.from.velocity);
        let end = self.by_end.0 * along(to.velocity, self.to.velocity)
            + self.by_end.1 * along(to.acceleration, self.to.acceleration);
        let way = along(from.position - to.position, self.from.position);
        if self.base() > R::ZERO {
            (way + start + end) / self.base()
        } else {
            R::ZERO
        }
    }

    /// What of the lead the shares of the axes are parts of.
    fn base(&self) -> R {
        let start = self.by_start * self.from.velocity.abs();
        let (by_velocity, by_acceleration) = self.by_end;
        let end =
            by_velocity * self.to.velocity.abs() + by_acceleration * self.to.acceleration.abs();
        self.from.position.abs() + start + end
    }

    /// The limits of the lead that keep the limits of all axes.
    fn tightest(
        &self,
        ends: impl Iterator<Item = Axis<'a, R>> + Clone,
    ) -> Result<Limits<R>, Error> {
        let (first, _) = ends.clone().next().ok_or(Error::Axes)?;
        if self.reach() == R::ZERO {
            return Ok(*first);
        }
        let endless = R::INFINITY;
        let mut tightest = Limits::symmetric(endless, endless, endless);
        for (limits, (from, to)) in ends {
            tightest.tighten(limits, self.share(from, to));
        }
        // Every axis may be in its target. So the lead may, and only roundings of the shares deny it.
        tightest.include(self.to);
        Ok(tightest)
    }

    /// Whether all states lie on the line, up to rounding. Behind a phase, a small number has the roundings of the numbers in the phase.
    fn check(
        &self,
        limits: &Limits<R>,
        mut ends: impl Iterator<Item = Axis<'a, R>>,
    ) -> Result<(), Error> {
        let reach = self.reach();
        // Where nothing moves, no share is uncertain.
        let per_base = if self.base() > R::ZERO {
            R::ONE / self.base()
        } else {
            R::ZERO
        };
        let (v, a) = highest(limits, reach);
        let is_straight = ends.all(|(_, (from, to))| {
            let share = self.share(from, to);
            let positions =
                from.position.abs() + to.position.abs() + share.abs() * (self.positions + reach);
            let agree = |x: R, y: R, scale: R| {
                let of_share = R::from(16) * R::EPSILON * positions * per_base;
                (x - share * y).abs() <= R::DOUBT * scale + of_share * y.abs()
            };
            let lies = |state: &State<R>, lead: &State<R>| {
                let v = state.velocity.abs() + share.abs() * v.at_least(lead.velocity.abs());
                let a =
                    state.acceleration.abs() + share.abs() * a.at_least(lead.acceleration.abs());
                agree(state.velocity, lead.velocity, v)
                    && agree(state.acceleration, lead.acceleration, a)
            };
            let way = from.position - to.position;
            agree(way, self.from.position, positions)
                && lies(from, &self.from)
                && lies(to, &self.to)
        });
        if is_straight {
            Ok(())
        } else {
            Err(Error::Line)
        }
    }
}

/// The highest velocity and the highest acceleration that an axis comes to on a way.
fn highest<R: Real>(limits: &Limits<R>, way: R) -> (R, R) {
    let jerk = limits.jmax.at_least(-limits.jmin);
    let v = limits.vmax.at_least(-limits.vmin);
    let a = limits
        .amax
        .at_least(-limits.amin)
        .at_most(((v + v) * jerk).sqrt());
    let a = if jerk.is_finite() {
        a.at_most((jerk * jerk * way).cube_root_above())
    } else {
        a
    };
    (v.at_most((a * way).sqrt()), a)
}

/// How long an axis takes to brake from the higher velocity of both ends, s.
fn braking<R: Real>((limits, (from, to)): Axis<R>) -> R {
    let speed = from.velocity.abs().at_least(to.velocity.abs());
    let j = limits.jmax.at_most(-limits.jmin);
    let a = limits
        .amax
        .at_most(-limits.amin)
        .at_most((speed * j).sqrt());
    if speed > R::ZERO {
        speed / a + a / j
    } else {
        R::ZERO
    }
}
