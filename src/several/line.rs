//! Several axes on a straight line: from their start to their end, and their stop on it.

use super::axis::{Task, checked, next_of_plan, stretch, takes};
use super::cycle::Cycle;
use crate::findings::{Error, Findings};
use crate::interval::rounding::{of_check, of_state};
use crate::limits::Limits;
use crate::online::{Move, Phase, problem::Problem};
use crate::real::Real;
use crate::state::State;

/// Plans all axes on the straight line from their start to their end: the fastest motion on it that lasts at least `duration` and a multiple
/// of `cycle` (0: any), s.
///
/// [`Error::Line`] if the velocities and accelerations do not point along the line. An error of any axis is returned, and then no axis is written.
pub fn line<R: Real>(
    axes: &mut [Move<R>], limits: &[Limits<R>], from: &[State<R>], to: &[State<R>], duration: R, cycle: R,
) -> Result<Findings, Error> {
    let cycle = Cycle::new(duration, cycle)?;
    let tasks = checked(axes.len(), limits, from, to)?;
    let line = Line::through(tasks.clone())?;
    let limits = line.tightest(tasks.clone());
    limits.check(line.from, line.to)?;
    line.check(tasks.clone())?;
    let problem = Problem::new(&limits, &line.from, &line.to).with_positions(line.positions);
    let mut lead = Move::default();
    problem.write(&mut lead, &problem.fastest())?;
    let slowest = duration.at_least(lead.t);
    let t = cycle.until_possible(1, slowest, |t| next_of_plan(&lead, &|| problem, t))?;
    let t = cycle.earlier(t, slowest, [lead.t].into_iter(), |t| takes(&lead, &problem, t));
    stretch(&mut lead, &|| problem, t)?;
    for (Task { from, to, .. }, axis) in tasks.zip(axes) {
        *axis = lead.scaled(to.position, line.share(from, to).times);
        axis.set_ends(*from, *to);
    }
    Ok(problem.findings(&lead))
}

/// A straight line in the space of all axes. Of the axes with a long reach, the one leads whose positions round least relative to its reach:
/// what the lead rounds, all axes do. Its positions are counted from its end, so they have the rounding error of the displacement alone.
struct Line<R> {
    /// The lead at both ends.
    from: State<R>,
    to: State<R>,
    /// The sum of the magnitudes of the lead's true positions: their rounding is an ulp of it.
    positions: R,
    /// How long the slowest axis takes to brake, s.
    braking: R,
    /// The highest velocity and acceleration of the lead. A small one has their rounding errors, because it is a sum of higher ones.
    highest: (R, R),
}

/// How far an axis moves while the lead moves by 1.
#[derive(Clone, Copy)]
struct Share<R> {
    times: R,
    /// The rounding error of the share.
    rounding: R,
}

impl<'a, R: Real + 'a> Line<R> {
    /// The line along which one of the axes leads.
    fn through(tasks: impl Iterator<Item = Task<'a, R>> + Clone) -> Result<Self, Error> {
        let braking = tasks.clone().map(braking).fold(R::ZERO, R::at_least);
        let leads = tasks.map(|Task { limits, from, to }| {
            let line = Self {
                from: State { position: from.position - to.position, ..*from },
                to: State { position: R::ZERO, ..*to },
                positions: from.position.abs() + to.position.abs(),
                braking,
                highest: (R::ZERO, R::ZERO),
            };
            (line, limits)
        });
        let longest = leads.clone().fold(R::ZERO, |longest, (line, _)| line.reach().at_least(longest));
        let finer = |one: (Self, _), other: (Self, _)| {
            let [own, others] = [&one, &other].map(|(line, _)| line.positions / line.reach());
            if others < own || others == own && other.0.reach() > one.0.reach() { other } else { one }
        };
        // A displacement may be a rounding error itself.
        let far = leads.filter(|(line, _)| line.reach() >= R::EPSILON.sqrt() * longest);
        let (mut line, limits) = far.reduce(finer).ok_or(Error::Axes)?;
        let (v, a) = peaks_over(limits, line.reach());
        let jerk = limits.jmax.at_most(-limits.jmin);
        let at_end = |State { velocity, acceleration, .. }: State<R>| {
            let built_up = (acceleration * acceleration / jerk).at_most(limits.vmax - limits.vmin);
            (velocity.abs().at_least(built_up), acceleration.abs())
        };
        let ((v0, a0), (v1, a1)) = (at_end(line.from), at_end(line.to));
        line.highest = (v.at_least(v0).at_least(v1), a.at_least(a0).at_least(a1));
        if line.reach().is_finite() { Ok(line) } else { Err(Error::NotFinite) }
    }

    /// The distance, and what the velocities at both ends travel while the axis brakes. It does not vanish where the axis passes its target.
    fn reach(&self) -> R {
        self.reach_of(&self.from, &self.to)
    }

    fn reach_of(&self, from: &State<R>, to: &State<R>) -> R {
        (from.position - to.position).abs() + self.braking * (from.velocity.abs() + to.velocity.abs())
    }

    /// The slope of the five numbers of the axis (its displacement, and velocity and acceleration at both ends) on those of the lead, by least squares.
    /// Each number counts in units of its rounding error. The share is 0 if nothing moves.
    fn share(&self, from: &State<R>, to: &State<R>) -> Share<R> {
        // The positions of a short axis round more on the scale of the lead.
        let longer = (self.reach() / self.reach_of(from, to)).at_most(R::ONE / R::EPSILON);
        let own_positions = longer * (from.position.abs() + to.position.abs());
        let positions = self.positions + self.reach() + own_positions;
        let (v, a) = self.highest;
        let numbers = [
            (from.position - to.position, self.from.position, positions),
            (from.velocity, self.from.velocity, v),
            (from.acceleration, self.from.acceleration, a),
            (to.velocity, self.to.velocity, v),
            (to.acceleration, self.to.acceleration, a),
        ];
        let (mut product, mut square) = (R::ZERO, R::ZERO);
        let mut largest = if positions > R::ZERO { own_positions / positions } else { R::ZERO };
        for (own, lead, size) in numbers.into_iter().filter(|(.., size)| *size > R::ZERO) {
            let (own, lead) = (own / size, lead / size);
            product = product + own * lead;
            square = square + lead * lead;
            largest = largest.at_least(own.abs());
        }
        if square > R::ZERO {
            // The numbers of the axis are rounded, and those of the lead.
            let times = product / square;
            Share { times, rounding: of_check(largest + times.abs()) / square.sqrt() }
        } else {
            Share { times: R::ZERO, rounding: R::ZERO }
        }
    }

    /// The limits of the lead that keep the limits of all axes.
    fn tightest(&self, mut tasks: impl Iterator<Item = Task<'a, R>>) -> Limits<R> {
        let mut tightest = Limits::endless();
        if self.reach() == R::ZERO {
            return tasks.next().map_or(tightest, |task| *task.limits);
        }
        for Task { limits, from, to } in tasks {
            tightest.tighten(limits, self.share(from, to).times);
        }
        // Each target is within the limits of its axis, so that of the lead is too, up to rounding of the shares.
        tightest.include(self.to);
        tightest
    }

    /// Whether all states lie on the line, up to rounding.
    fn check(&self, mut tasks: impl Iterator<Item = Task<'a, R>>) -> Result<(), Error> {
        let (v, a) = self.highest;
        let is_straight = tasks.all(|Task { from, to, .. }| {
            let Share { times: share, rounding } = self.share(from, to);
            // The lead's positions round less, relative to its reach. What is left is a jump at the start.
            let positions = from.position.abs() + to.position.abs() + self.reach_of(from, to);
            let is_level =
                (from.position - to.position - share * self.from.position).abs() <= of_state(positions + positions);
            let agree = |x: R, y: R, scale: R| (x - share * y).abs() <= of_check(scale) + rounding * y.abs();
            let lies = |own: &State<R>, lead: &State<R>| {
                agree(own.velocity, lead.velocity, own.velocity.abs() + share.abs() * v)
                    && agree(own.acceleration, lead.acceleration, own.acceleration.abs() + share.abs() * a)
            };
            is_level && lies(from, &self.from) && lies(to, &self.to)
        });
        if is_straight { Ok(()) } else { Err(Error::Line) }
    }
}

/// The highest velocity and the highest acceleration that an axis comes to over a distance.
fn peaks_over<R: Real>(limits: &Limits<R>, distance: R) -> (R, R) {
    let [most, least] = [limits.jmax.at_least(-limits.jmin), limits.jmax.at_most(-limits.jmin)];
    // What an infinite jerk builds up, the other one undoes.
    let jerk = if most.is_finite() { most } else { least };
    let v = limits.vmax.at_least(-limits.vmin);
    let a = limits.amax.at_least(-limits.amin).at_most(((v + v) * jerk).sqrt());
    let a = if jerk.is_finite() { a.at_most((jerk * jerk * distance).cube_root_above()) } else { a };
    (v.at_most((a * distance).sqrt()), a)
}

/// How long an axis takes to brake from the higher velocity of both ends, s.
fn braking<R: Real>(Task { limits, from, to }: Task<R>) -> R {
    let speed = from.velocity.abs().at_least(to.velocity.abs());
    let j = limits.jmax.at_most(-limits.jmin);
    let a = limits.amax.at_most(-limits.amin).at_most((speed * j).sqrt());
    if speed > R::ZERO { speed / a + a / j } else { R::ZERO }
}

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
    let mut tightest = Limits::endless();
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

#[cfg(test)]
mod tests {
    use super::{Line, Task, braking, peaks_over};
    use crate::limits::Limits;
    use crate::state::State;

    const LIMITS: Limits<f64> = Limits { vmax: 16.0, vmin: -8.0, amax: 4.0, amin: -2.0, jmax: 4.0, jmin: -8.0 };
    const STAND: State<f64> = State { position: 0.0, velocity: 0.0, acceleration: 0.0 };

    #[test]
    fn limits_tell_how_fast_an_axis_becomes() {
        let slow = Limits { vmax: 0.0625, vmin: -0.0625, ..LIMITS };
        let expected = [(LIMITS, 1e6, 16.0, 4.0), (LIMITS, 0.125, 0.5, 2.0), (slow, 1e6, 0.0625, 1.0)];
        for (limits, distance, v, a) in expected {
            let found = peaks_over(&limits, distance);
            assert!((found.0 - v).abs() < 1e-3 && (found.1 - a).abs() < 1e-3, "{found:?}");
        }
        let from_speed = |velocity| braking(Task { limits: &LIMITS, from: &State { velocity, ..STAND }, to: &STAND });
        assert_eq!([0.0, 0.25, 16.0].map(from_speed), [0.0, 0.5, 8.5]);
        // An acceleration at an end changes the velocity until it is 0.
        let end = State { acceleration: 2.0, ..STAND };
        let line = Line::through([Task { limits: &LIMITS, from: &end, to: &STAND }].into_iter());
        assert_eq!(line.map(|line| line.highest), Ok((1.0, 2.0)));
    }
}
