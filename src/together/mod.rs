//! Several axes that move together: in the same time, or on a straight line.
//!
//! ```
//! use atraj::axes::synchronise;
//! use atraj::online::{Limits, Move, State};
//! let limits = [Limits::symmetric(30.0, 10.0, 5.0), Limits::symmetric(60.0, 20.0, 5.0)];
//! let (from, to) = ([State::at(0.0), State::at(0.0)], [State::at(10.0), State::at(-1.0)]);
//! let mut axes = [Move::default(); 2];
//! synchronise(&mut axes, &limits, &from, &to, 0.0, 0.001).expect("numbers");
//! assert_eq!(axes[0].t, axes[1].t);
//! ```

use crate::findings::Findings;
use crate::online::plan::Task;
use crate::online::{Error, Limits, Move, Phase, State};
use crate::real::Real;

/// Plans all axes for the same duration: the shortest one that is possible for each, is at least `duration`, and is a multiple of `cycle`
/// (0: any), s. An axis whose fastest move takes as long makes its fastest move. An axis with more time moves slowly: from rest to rest no
/// faster than twice its mean velocity, if its jerks are equal.
///
/// An error of any axis is returned, and then no axis is written.
pub fn synchronise<R: Real>(
    axes: &mut [Move<R>],
    limits: &[Limits<R>],
    from: &[State<R>],
    to: &[State<R>],
    duration: R,
    cycle: R,
) -> Result<Findings, Error> {
    let ticks = Ticks::new(duration, cycle)?;
    let ends = checked(axes.len(), limits, from, to)?;
    let tasks = || {
        ends.clone()
            .map(|(limits, (&from, &to))| Task::new(limits, from, to))
    };

    let mut slowest = duration;
    for task in tasks() {
        slowest = slowest.at_least(shortest(&task)?);
    }
    let t = ticks.until_possible(axes.len(), slowest, |t| {
        tasks().fold(t, |latest, task| latest.at_least(task.next_duration(t)))
    });
    if !t.is_finite() {
        return Err(Error::NotFinite);
    }
    let mut found = Findings::default();
    for (task, axis) in tasks().zip(axes) {
        write(&task, axis, t)?;
        found |= task.findings(axis);
    }
    Ok(found)
}

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
    let ticks = Ticks::new(duration, cycle)?;
    let ends = checked(axes.len(), limits, from, to)?;
    let line = Line::through(from, to)?;
    let limits = line.tightest(limits, from, to)?;
    limits.check(line.from, line.to)?;
    let task = Task::new(&limits, line.from, line.to);
    let slowest = shortest(&task)?.at_least(duration);
    let t = ticks.until_possible(1, slowest, |t| task.next_duration(t));
    if !t.is_finite() {
        return Err(Error::NotFinite);
    }
    let mut lead = Move::default();
    write(&task, &mut lead, t)?;
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
    Ok(task.findings(&lead))
}

/// The limits of an axis, and its states at the start and at the end.
type Axis<'a, R> = (&'a Limits<R>, (&'a State<R>, &'a State<R>));

/// Limits and states of the axes, if each of them can be planned.
fn checked<'a, R: Real>(
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
fn shortest<R: Real>(task: &Task<R>) -> Result<R, Error> {
    let t = task.duration(&task.fastest());
    let (h, positions) = task.displacement();
    if (t + h.abs() + positions).is_finite() {
        Ok(t)
    } else {
        Err(Error::NotFinite)
    }
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

/// Writes the fastest motion if it takes as long as `t`, else a slower one.
fn write<R: Real>(task: &Task<R>, axis: &mut Move<R>, t: R) -> Result<(), Error> {
    let fastest = task.fastest();
    let is_slower = task.duration(&fastest) < t;
    match task.mean(t).filter(|_| is_slower) {
        Some(mean) => task.write_mean(axis, t, &mean),
        None => {
            task.write(axis, &fastest)?;
            axis.end_at(t);
        }
    }
    Ok(())
}

/// Whether velocity and acceleration are those of the lead times `share`.
fn lies_on<R: Real>(share: R, state: &State<R>, lead: &State<R>) -> bool {
    let agree = |x: R, y: R| (x - share * y).abs() <= R::DOUBT * (x.abs() + (share * y).abs());
    agree(state.velocity, lead.velocity) && agree(state.acceleration, lead.acceleration)
}

/// The clock of a machine.
struct Ticks<R> {
    /// s; 0 if any time will do.
    cycle: R,
}

impl<R: Real> Ticks<R> {
    fn new(duration: R, cycle: R) -> Result<Self, Error> {
        let is_time = |t: R| t >= R::ZERO && t.is_finite();
        if is_time(duration) && is_time(cycle) {
            Ok(Self { cycle })
        } else {
            Err(Error::Duration)
        }
    }

    /// The first tick from `t` on, but for rounding.
    fn from(&self, t: R) -> R {
        let count = t / self.cycle;
        // Adding and subtracting this number rounds to a whole number. Larger numbers are whole.
        let whole = R::ONE / R::EPSILON;
        if !(self.cycle > R::ZERO && count < whole) {
            return t;
        }
        let nearest = (count + whole) - whole;
        let is_early = nearest < count - R::from(4) * R::EPSILON * count;
        self.cycle * if is_early { nearest + R::ONE } else { nearest }
    }

    /// The first tick from `t` on at which all axes can arrive. `next_duration` gives the shortest possible duration of the slowest axis.
    fn until_possible(&self, axes: usize, t: R, next_duration: impl Fn(R) -> R) -> R {
        let mut t = self.from(t);
        // Every round passes a gap of an axis. An axis has at most one to each side.
        for _ in 0..2 * axes + 2 {
            let next = self.from(next_duration(t));
            if next <= t {
                break;
            }
            t = next;
        }
        t
    }
}
