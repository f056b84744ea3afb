//! The clock of a path: hold, override and reverse a planned set of moves, on their path.
//!
//! `docs/machine.md` has the theory.

use super::parabola::Parabola;
use crate::findings::Error;
use crate::limits::Limits;
use crate::online::{Move, Phase};
use crate::real::Real;
use crate::state::State;

/// The most parts in which a phase of the clock is examined: a power of 2. More parts find no shorter hold.
const PARTS: i32 = 32;

/// The first limits of a change are `λ A/V` and `q λ² J/V`, as high as they pass: `λ` is halved from 16 down to `16/2^16`, with one `q` after the other.
const RATIOS: [u8; 5] = [16, 4, 64, 1, 255];
const HALVES: u32 = 17;

/// Then each limit is raised alone: by these sixteenths of itself, one after the other.
const RAISES: [u8; 5] = [64, 32, 24, 20, 20];

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
        time.stay(State { velocity: R::ONE, ..State::at(R::ZERO) });
        Self { begin: R::ZERO, time }
    }

    /// Goes to another rate from the time `x` on, s, which is not before the last change: 1 as planned, 0 hold, -1 back along the path. The axes have the limits
    /// in `limits`: the limits of their plans and a reserve.
    ///
    /// `moves` has one move for each axis, or the moves of a path section by section: of all axes for the first section, then of all axes for the second one. Each
    /// move begins where the move of its axis before it ends, and the moves of a section have one duration.
    ///
    /// Until the end of the path, or until its start if the rate is negative, no axis exceeds its limits. This is proved for each part of the motion, not
    /// sampled. [`Error::Target`] if no change of the rate within the limits is found; then the clock goes on as it did. [`Error::Axes`] if there is no
    /// axis or no move, or if the moves are no whole sections; [`Error::NotFinite`] and [`Error::Limits`] as in [`Move::plan`], the latter also if nothing
    /// moves, or if no axis that moves has a finite jerk or acceleration.
    pub fn rate(&mut self, moves: &[Move<R>], limits: &[Limits<R>], x: R, rate: R) -> Result<(), Error> {
        let (n, mut left) = (limits.len(), moves.len());
        while n > 0 && left > n {
            left -= n;
        }
        if n == 0 || left != n {
            return Err(Error::Axes);
        }
        if !(x.is_finite() && rate.is_finite()) {
            return Err(Error::NotFinite);
        }
        for limits in limits {
            limits.are_limits()?;
        }
        let change = Change { moves, limits, from: self.time.state_at(x - self.begin), rate };
        let (time, limits) = change.first()?;
        (self.begin, self.time) = (x, change.faster(time, limits)?);
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
        let jerk = j * square * rate + R::from(3) * a * rate * slowing + v * bending;
        [position, v * rate, a * square + v * slowing, jerk]
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
        let (mut rest, mut end) = (self.moves, R::ZERO);
        core::iter::from_fn(move || {
            let (of, start) = (rest.first()?, end);
            rest = rest.get(self.n.max(1)..).unwrap_or_default();
            let is_last = rest.is_empty();
            end = if is_last { R::INFINITY } else { start + of.t };
            Some((of, start, end))
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
        self.sections().last().map_or(R::ZERO, |(of, start, _)| start + of.t)
    }
}

/// The phases of a move that starts at `start`, each with the time at which it starts and the time at which the next one does. If the move goes on, its end
/// is the last one.
fn phases<R: Real>(of: &Move<R>, start: R, goes_on: bool) -> impl Iterator<Item = (&Phase<R>, R, R)> {
    let count = of.phases().len();
    let used = of.phase.iter().take(count + usize::from(goes_on));
    // Phase 0 is the start.
    let lasting = used.enumerate().skip(1).filter(move |(index, phase)| phase.duration > R::ZERO || *index == count);
    lasting.map(move |(index, phase)| {
        let next = of.phase.get(index + 1).filter(|_| index < count);
        let next = next.map_or(R::INFINITY, |next| start + next.start);
        (phase, start + phase.start, next)
    })
}

/// A change of the rate.
struct Change<'a, R> {
    moves: &'a [Move<R>],
    limits: &'a [Limits<R>],
    from: State<R>,
    rate: R,
}

impl<R: Real> Change<'_, R> {
    /// A change that keeps the limits of the axes, and its own limits: of the jerk upwards and downwards, and of the acceleration.
    fn first(&self) -> Result<(Move<R>, [R; 3]), Error> {
        // How fast the time may change where an axis is at its highest speed.
        let (mut slowing, mut bending) = (R::INFINITY, R::INFINITY);
        for (of, limits) in self.moves.iter().zip(self.limits.iter().cycle()) {
            let speed = of.extremes().speed();
            slowing = slowing.at_most(limits.amax.at_most(-limits.amin) / speed);
            bending = bending.at_most(limits.jmax.at_most(-limits.jmin) / speed);
        }
        if !(slowing < R::INFINITY && bending < R::INFINITY) {
            return Err(Error::Limits);
        }
        for ratio in RATIOS {
            let mut scale = R::from(16);
            for _ in 0..HALVES {
                let bending = R::SIXTEENTH * R::from(ratio) * bending * scale * scale;
                let limits = [bending, bending, slowing * scale];
                let time = self.within(limits)?;
                if self.keeps(&time) {
                    return Ok((time, limits));
                }
                scale = R::HALF * scale;
            }
        }
        Err(Error::Target)
    }

    /// Raises each limit of a change alone, as long as the limits of the axes are kept.
    fn faster(&self, mut time: Move<R>, mut limits: [R; 3]) -> Result<Move<R>, Error> {
        for raise in RAISES {
            for index in 0..limits.len() {
                let mut higher = limits;
                if let Some(limit) = higher.get_mut(index) {
                    *limit = *limit * R::SIXTEENTH * R::from(raise);
                }
                let faster = self.within(higher)?;
                if faster.t < time.t && self.keeps(&faster) {
                    (time, limits) = (faster, higher);
                }
            }
        }
        Ok(time)
    }

    /// The fastest change within limits of its own.
    fn within(&self, [up, down, slowing]: [R; 3]) -> Result<Move<R>, Error> {
        let limits = Limits { jmax: up, jmin: -down, ..Limits::symmetric(R::ONE, slowing, R::INFINITY) };
        let mut time = Move::default();
        time.reach(&limits, self.from, self.rate, R::ZERO)?;
        Ok(time)
    }

    /// Whether all axes surely keep their limits, and the rate does not overshoot by more than 1.
    fn keeps(&self, time: &Move<R>) -> bool {
        let fastest = R::ONE + self.from.velocity.abs().at_least(self.rate.abs());
        let mut axes = self.limits.iter().enumerate();
        time.extremes().speed() <= fastest
            && axes.all(|(index, limits)| {
                let axis = Axis::new(self.moves, self.limits.len(), index);
                Trial { time, axis, limits }.keeps()
            })
    }
}

/// A change of the rate as an axis sees it.
struct Trial<'a, R> {
    time: &'a Move<R>,
    axis: Axis<'a, R>,
    limits: &'a Limits<R>,
}

impl<R: Real> Trial<'_, R> {
    /// Whether the axis surely keeps its limits: during the change, and then at the new rate until the end of the path or its start.
    fn keeps(&self) -> bool {
        let mut phases = self.time.phases().iter();
        phases.all(|phase| self.keeps_in(phase)) && self.keeps_in(&self.after())
    }

    /// The new rate as a phase of the clock.
    fn after(&self) -> Phase<R> {
        let State { position: s, velocity: rate, .. } = self.time.end();
        let way = if rate > R::ZERO { self.axis.duration() - s } else { s };
        let duration = if rate != R::ZERO && way > R::ZERO { way / rate.abs() } else { R::ZERO };
        Phase { duration, position: s, velocity: rate, ..Phase::default() }
    }

    /// During a phase of the clock: as a whole, or else each half of it, and so on.
    fn keeps_in(&self, phase: &Phase<R>) -> bool {
        let least = phase.duration / R::from_index(PARTS);
        let (mut done, mut part) = (0, PARTS);
        while done < PARTS {
            let [from, to] = [done, done + part].map(|k| R::from_index(k) * least);
            if self.keeps_over(phase, Parabola::between(from, to)) {
                done += part;
                part = done & done.wrapping_neg();
            } else if part > 1 {
                part /= 2;
            } else {
                return false;
            }
        }
        true
    }

    /// In a part of a phase of the clock.
    fn keeps_over(&self, of: &Phase<R>, part: Parabola<R>) -> bool {
        let [passed, ..] = part.along(of);
        let [low, high] = passed.range();
        let is_touched = |start: R, end: R| high >= start && low <= end;
        let touched =
            |(section, begin, end)| is_touched(begin, end).then(|| phases(section, begin, end == R::INFINITY));
        self.axis.sections().filter_map(touched).all(|mut phases| {
            phases.all(|(phase, start, end)| {
                let part = part.narrowed(passed.when_between(start, end));
                !is_touched(start, end) || self.keeps_beside(phase, start, part.along(of))
            })
        })
    }

    /// While the axis is in a phase that starts at the time `start` of the path, and the time of the path and its derivatives are in these parts.
    fn keeps_beside(&self, phase: &Phase<R>, start: R, [s, rate, slowing, bending]: [Parabola<R>; 4]) -> bool {
        let [_, v, a, j] = s.plus(Parabola::constant(-start)).along(phase);
        let square = rate.times(rate);
        let three = Parabola::constant(R::from(3));
        let acceleration = a.times(square).plus(v.times(slowing));
        let turning = three.times(a).times(rate.times(slowing));
        let jerk = j.times(square.times(rate)).plus(turning).plus(v.times(bending));
        let limits = self.limits;
        v.times(rate).is_between(limits.vmin, limits.vmax)
            && acceleration.is_between(limits.amin, limits.amax)
            && jerk.is_between(limits.jmin, limits.jmax)
    }
}
