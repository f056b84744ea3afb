//! The clock of a path: hold, override and reverse a planned set of moves, on their path.
//!
//! `docs/machine.md` has the theory.

use crate::findings::Error;
use crate::limits::Limits;
use crate::online::{Move, Phase};
use crate::real::Real;
use crate::state::State;

/// The parts in which a phase of the clock is examined. A bound over a part is too large by about a part of the change of the rate in it.
const PARTS: i32 = 16;

/// The limits of the clock are tried from the highest one on, in units of the limits that the path has at its highest speed. Each is half of the one before, down to
/// 1/256: a slower change is no hold. Then the range between the last two is halved, until the change takes 1/16 longer than it must at most.
const HIGHEST_TRIAL: u8 = 16;
const TRIALS: u32 = 12;
const HALVES: u32 = 4;

/// The time of a path as a move itself.
///
/// The clock runs at a rate: 1 as planned, 0 hold, 1/2 override, -1 back along the path. A change of the rate is a move of the time with limits of
/// its own, so nothing jumps: position, velocity and acceleration of each axis are functions of this time, and the path is kept.
///
/// ```
/// use atraj::machine::Clock;
/// use atraj::online::{Limits, Move, State};
/// let limits = Limits::symmetric(30.0, 10.0, 5.0);
/// let planned_within = Limits::symmetric(24.0, 8.0, 4.0); // 20 % are the reserve of the clock
/// let mut axis = [Move::default()];
/// axis[0].plan(&planned_within, State::at(0.0), State::at(10.0))?;
/// let mut clock = Clock::new();
/// clock.rate(&axis, &[limits], 1.0, 0.0)?; // hold at 1 s
/// let held = clock.until();
/// assert!(clock.state(&axis, 1, held + 5.0)[1] == 0.0);
/// clock.rate(&axis, &[limits], held + 5.0, 1.0)?; // resume
/// assert_eq!(clock.state(&axis, 1, held + 20.0), [10.0, 0.0, 0.0, 0.0]);
/// # Ok::<(), atraj::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Clock<R> {
    /// When the last change of the rate began, s.
    pub(crate) begin: R,
    /// The time of the path since then.
    pub(crate) time: Move<R>,
}

impl<R: Real> Default for Clock<R> {
    fn default() -> Self {
        Self::new()
    }
}

impl<R: Real> Clock<R> {
    /// A clock that runs as planned. Its time is the time of the path.
    pub fn new() -> Self {
        let mut time = Move::default();
        time.stay(State {
            velocity: R::ONE,
            ..State::at(R::ZERO)
        });
        Self {
            begin: R::ZERO,
            time,
        }
    }

    /// Goes to another rate from the time `x` on, s, which is not before the last change: 1 as planned, 0 hold, -1 back along the path. The axes have the limits
    /// in `limits`: the limits of their plans and a reserve.
    ///
    /// `moves` has one move for each axis, or the moves of a path section by section: those of all axes for the first section, then those for the second one. Each
    /// move begins where the move of its axis before it ends, and the moves of a section have one duration.
    ///
    /// Until the end of the path, or until its start if the rate is negative, no axis exceeds its limits. This is proved for each part of the motion, not
    /// sampled. [`Error::Target`] if no change of the rate within the limits is found; then the clock goes on as it did. [`Error::Axes`] if there is no
    /// axis or no move, or if the moves are no whole sections; [`Error::NotFinite`] and [`Error::Limits`] as in [`Move::plan`], the latter also if nothing moves.
    pub fn rate(
        &mut self,
        moves: &[Move<R>],
        limits: &[Limits<R>],
        x: R,
        rate: R,
    ) -> Result<(), Error> {
        let n = limits.len();
        if n == 0 || moves.is_empty() || moves.len() % n != 0 {
            return Err(Error::Axes);
        }
        if !(x.is_finite() && rate.is_finite()) {
            return Err(Error::NotFinite);
        }
        // The path's own size: how fast its time may change where an axis is at its highest speed.
        let (mut slowing, mut bending) = (R::INFINITY, R::INFINITY);
        for limits in limits {
            limits.are_limits()?;
        }
        for (of, limits) in moves.iter().zip(limits.iter().cycle()) {
            let speed = of.extremes().speed();
            slowing = slowing.at_most(limits.amax.at_most(-limits.amin) / speed);
            bending = bending.at_most(limits.jmax.at_most(-limits.jmin) / speed);
        }
        if !(slowing < R::INFINITY && bending < R::INFINITY) {
            return Err(Error::Limits);
        }
        let from = self.time.state_at(x - self.begin);
        let mut time = Move::default();
        let mut passes = |scale: R| {
            let endless = R::INFINITY;
            let limits_of_time =
                Limits::symmetric(bending * scale * scale, slowing * scale, endless);
            time.reach(&limits_of_time, from, rate, R::ZERO)?;
            let keeps = |(axis, limits)| {
                Trial {
                    time: &time,
                    axis: Axis::new(moves, n, axis),
                    limits,
                }
                .keeps()
            };
            Ok::<_, Error>(limits.iter().enumerate().all(keeps).then_some(time))
        };
        let (mut high, mut low) = (R::ZERO, R::from(HIGHEST_TRIAL));
        let mut found = passes(low)?;
        for _ in 0..TRIALS {
            if found.is_none() {
                (high, low) = (low, R::HALF * low);
                found = passes(low)?;
            }
        }
        let mut best = found.ok_or(Error::Target)?;
        for _ in 0..HALVES {
            let middle = R::HALF * (low + high);
            if middle > low {
                match passes(middle)? {
                    Some(faster) => (low, best) = (middle, faster),
                    None => high = middle,
                }
            }
        }
        (self.begin, self.time) = (x, best);
        Ok(())
    }

    /// When the last rate is reached, s.
    pub fn until(&self) -> R {
        self.begin + self.time.t
    }

    /// The time of the path at the time `x`, s.
    pub fn time(&self, x: R) -> R {
        self.time.position(x - self.begin)
    }

    /// Position, velocity, acceleration and jerk of an axis of the path at the time `x`, s. The move of the axis in the first section begins `moves`, and its
    /// move in the next section is `n` moves behind: axis `i` of `n` axes has `&moves[i..]`. All are NaN if there is no move.
    pub fn state(&self, moves: &[Move<R>], n: usize, x: R) -> [R; 4] {
        let [s, rate, slowing, bending] = self.time.state(x - self.begin);
        let Some((of, start)) = (Axis { moves, n }).section(s) else {
            return [R::NAN; 4];
        };
        let [position, v, a, j] = of.state(s - start);
        let square = rate * rate;
        [
            position,
            v * rate,
            a * square + v * slowing,
            j * square * rate + R::from(3) * a * rate * slowing + v * bending,
        ]
    }
}

/// The moves of an axis: the first one, and then each `n` moves behind the one before.
#[derive(Clone, Copy)]
struct Axis<'a, R> {
    moves: &'a [Move<R>],
    n: usize,
}

impl<'a, R: Real> Axis<'a, R> {
    /// Axis `index` of `n` axes.
    fn new(moves: &'a [Move<R>], n: usize, index: usize) -> Self {
        let moves = moves.get(index..).unwrap_or_default();
        Self { moves, n }
    }

    /// The moves, each with the time at which it starts and the time at which the next one does. The last move goes on.
    fn sections(self) -> impl Iterator<Item = (&'a Move<R>, R, R)> {
        let last = self.moves.len().saturating_sub(1) / self.n.max(1);
        let mut end = R::ZERO;
        let moves = self.moves.iter().step_by(self.n.max(1)).enumerate();
        moves.map(move |(index, of)| {
            let start = end;
            end = if index < last {
                start + of.t
            } else {
                R::INFINITY
            };
            (of, start, end)
        })
    }

    /// The move at the time `s`, and when it starts. The first move is there before its start, too.
    fn section(self, s: R) -> Option<(&'a Move<R>, R)> {
        let mut found = None;
        for (of, start, end) in self.sections() {
            found = Some((of, start));
            if s < end {
                break;
            }
        }
        found
    }

    /// The duration.
    fn duration(self) -> R {
        self.sections()
            .last()
            .map_or(R::ZERO, |(of, start, _)| start + of.t)
    }
}

/// A change of the rate, to be examined for an axis.
struct Trial<'a, R> {
    time: &'a Move<R>,
    axis: Axis<'a, R>,
    limits: &'a Limits<R>,
}

impl<R: Real> Trial<'_, R> {
    /// Whether the axis surely keeps its limits: during the change, and then at the new rate until the end of the path or its start.
    fn keeps(&self) -> bool {
        let mut phases = self.time.phases().iter();
        phases.all(|phase| self.keeps_in(phase)) && self.keeps_after()
    }

    /// During a phase of the clock.
    fn keeps_in(&self, phase: &Phase<R>) -> bool {
        let part = phase.duration / R::from_index(PARTS);
        (0..PARTS).all(|k| {
            let [from, to] = [k, k + 1].map(|k| R::from_index(k) * part);
            let rate = velocities(phase, from, to);
            let slowing = Range::of(phase.acceleration(from), phase.acceleration(to));
            let way = Range::of(R::ZERO, to - from).times(rate.and(R::ZERO));
            let passed = Range::of(phase.position(from), phase.position(from)).plus(way);
            self.keeps_over(passed, rate, slowing, Range::of(phase.jerk, phase.jerk))
        })
    }

    /// At the new rate.
    fn keeps_after(&self) -> bool {
        let State {
            position: s,
            velocity: rate,
            ..
        } = self.time.state_at(self.time.t);
        let rest = if rate > R::ZERO {
            Range::of(s, s.at_least(self.axis.duration()))
        } else if rate < R::ZERO {
            Range::of(s.at_most(R::ZERO), s)
        } else {
            return true;
        };
        let none = Range::of(R::ZERO, R::ZERO);
        self.keeps_over(rest, Range::of(rate, rate), none, none)
    }

    /// While the time of the path, its rate and their derivatives are in these ranges.
    fn keeps_over(
        &self,
        passed: Range<R>,
        rate: Range<R>,
        slowing: Range<R>,
        bending: Range<R>,
    ) -> bool {
        let touched = self.axis.sections().filter(|(_, start, end)| {
            // Before its start a path stays.
            passed.high >= *start && passed.low <= *end
        });
        touched.into_iter().all(|(of, start, end)| {
            let from = passed.low.at_least(start) - start;
            let to = passed.high.at_most(end) - start;
            self.keeps_in_section(of, [from, to], rate, slowing, bending)
        })
    }

    /// From one time of a section to another one.
    fn keeps_in_section(
        &self,
        of: &Move<R>,
        [from, to]: [R; 2],
        rate: Range<R>,
        slowing: Range<R>,
        bending: Range<R>,
    ) -> bool {
        let square = rate.times(rate);
        let Limits {
            vmax,
            vmin,
            amax,
            amin,
            jmax,
            jmin,
        } = *self.limits;
        let three = Range::of(R::from(3), R::from(3));
        let count = of.phases().len();
        // Phase 0 is the start. The last one, which is the end, goes on.
        let used = of.phase.iter().take(1 + count).skip(1);
        let after = of
            .phase
            .iter()
            .take(1 + count)
            .skip(2)
            .map(|next| next.start);
        used.zip(after.chain([R::INFINITY])).all(|(phase, end)| {
            let from = from.at_least(phase.start) - phase.start;
            let to = to.at_most(end) - phase.start;
            if to < from {
                return true;
            }
            let v = velocities(phase, from, to);
            let a = Range::of(phase.acceleration(from), phase.acceleration(to));
            let j = Range::of(phase.jerk, phase.jerk);
            let acceleration = a.times(square).plus(v.times(slowing));
            let jerk = j
                .times(square.times(rate))
                .plus(three.times(a).times(rate.times(slowing)))
                .plus(v.times(bending));
            v.times(rate).is_between(vmin, vmax)
                && acceleration.is_between(amin, amax)
                && jerk.is_between(jmin, jmax)
        })
    }
}

/// The velocities of a phase between two times.
fn velocities<R: Real>(phase: &Phase<R>, from: R, to: R) -> Range<R> {
    let ends = Range::of(phase.velocity(from), phase.velocity(to));
    let peak = -phase.acceleration / phase.jerk;
    if peak > from && peak < to {
        ends.and(phase.velocity(peak))
    } else {
        ends
    }
}

/// All numbers between two. A product and a sum of ranges hold all products and sums.
#[derive(Clone, Copy)]
struct Range<R> {
    low: R,
    high: R,
}

impl<R: Real> Range<R> {
    /// The numbers between these, whichever is lower.
    fn of(one: R, other: R) -> Self {
        Self {
            low: one.at_most(other),
            high: one.at_least(other),
        }
    }

    /// With another number.
    fn and(self, other: R) -> Self {
        Self {
            low: self.low.at_most(other),
            high: self.high.at_least(other),
        }
    }

    fn plus(self, other: Self) -> Self {
        Self {
            low: self.low + other.low,
            high: self.high + other.high,
        }
    }

    fn times(self, other: Self) -> Self {
        Self::of(self.low * other.low, self.low * other.high)
            .and(self.high * other.low)
            .and(self.high * other.high)
    }

    /// Up to 64 roundings of the limits.
    fn is_between(self, lowest: R, highest: R) -> bool {
        let wider = R::ONE + R::DOUBT;
        self.low >= wider * lowest && self.high <= wider * highest
    }
}
