//! The clock of a path: hold, override and reverse a planned set of moves, on their path. `docs/machine.md` has the theory.

use super::change::RateChange;
use super::lead;
use super::sections::{AxisPath, are_whole};
use crate::findings::{Error, Findings};
use crate::limits::Limits;
use crate::online::Move;
use crate::real::Real;
use crate::state::State;

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
    /// When the last change of the rate begins, s.
    pub(crate) begin: R,
    /// When the rate is reached, s.
    pub(crate) until: R,
    /// When the change before the last one began, s.
    pub(crate) begin_before: R,
    /// 1 if `time` is the position of the lead, else 0.
    pub(crate) is_led: u32,
    /// 1 if `before` is the position of the lead, else 0.
    pub(crate) was_led: u32,
    /// The time of the path since the last change.
    pub(crate) time: Move<R>,
    /// The time of the path before the last change, since the change before it.
    pub(crate) before: Move<R>,
    /// The move of the lead, if the axes stop on a straight line.
    pub(crate) lead: Move<R>,
}

impl<R: Real> Default for Clock<R> {
    fn default() -> Self {
        Self::new()
    }
}

impl<R: Real> Clock<R> {
    /// A clock that runs as planned. Its time is the time of the path.
    pub fn new() -> Self {
        let zero = R::ZERO;
        let mut time = Move::default();
        time.stay(State { velocity: R::ONE, ..State::at(zero) });
        Self { begin: zero, until: zero, begin_before: zero, is_led: 0, was_led: 0, time, before: time, lead: time }
    }

    /// Begins again at the time `s` of a path, at this rate, and stands at its end at `length`.
    pub(super) fn begin_at(&mut self, s: R, rate: R, length: R) {
        *self = Self::new();
        self.time.stay(State { velocity: rate, ..State::at(s) });
        self.time.go_to_the_end(length);
    }

    /// Goes on as another clock does from its time `x` on, which is 0 from now on.
    #[inline(never)] // else the compiler copies as if both overlapped, and needs `memmove`
    pub(super) fn go_on_from(&mut self, other: &Self, x: R) {
        *self = *other;
        self.rebase(x);
    }

    /// Goes to another rate from the time `x` on, s: 1 as planned, 0 hold, -1 back along the path. The axes have the limits in `limits`: the limits of
    /// their plans and a reserve. `x` may be ahead: until then the clock goes on as it did. Let one change begin before the next one is planned.
    ///
    /// `moves` has one move for each axis, or the moves of a path section by section: of all axes for the first section, then of all axes for the second one. Each
    /// move begins where the move of its axis before it ends, and the moves of a section have one duration.
    ///
    /// Until the end of the path, or until its start if the rate is negative, no axis exceeds its limits. This is proved for each part of the motion, not
    /// sampled. There the time of the path stands. Only at an end in motion the axes go on.
    ///
    /// Returns [`Findings::RATE_NOT_REACHED`] if the path ends before. [`Error::Target`] if no change within the limits is found that takes at most
    /// 32 times the path and a stop, or if the rate is negative and the path begins in motion; [`Error::Late`] if `x` is before the last change;
    /// [`Error::Axes`] if there is no axis or no move, or no whole sections; [`Error::NotFinite`] and [`Error::Limits`] as in [`Move::plan`]. On an error the clock goes on as it did.
    pub fn rate(&mut self, moves: &[Move<R>], limits: &[Limits<R>], x: R, rate: R) -> Result<Findings, Error> {
        Error::Axes.unless(are_whole(moves, limits.len()))?;
        Error::NotFinite.unless(x.is_finite() && rate.is_finite())?;
        limits.iter().try_for_each(Limits::are_limits)?;
        Error::Late.unless(x >= self.begin)?;
        let change = RateChange::new(moves, limits, rate)?;
        let now = self.state_of_time(x);
        let mut time = Move::default();
        let is_stop = rate == R::ZERO && !change.may_jump(now[0]);
        let stop = if is_stop { lead::stop(moves, limits, now, &mut time)? } else { None };
        let (law, lead) = match stop {
            Some(stop) => stop,
            None => {
                self.go_on(x, now, &mut time)?;
                (change.plan(&mut time)?, None)
            }
        };
        if x > self.begin {
            (self.begin_before, self.was_led, self.before) = (self.begin, self.is_led, self.time);
        }
        (self.begin, self.until, self.time) = (x, x + law.until, time);
        self.is_led = u32::from(lead.is_some());
        if let Some(lead) = lead {
            self.lead = lead;
        }
        Ok(Findings::RATE_NOT_REACHED.when(!law.is_reached))
    }

    /// The time of the path from the time `x` on, if nothing changes. A lead's is only known as it is `now`.
    fn go_on(&self, x: R, now: [R; 4], time: &mut Move<R>) -> Result<(), Error> {
        let [position, velocity, acceleration, _] = now;
        if self.is_led > 0 {
            time.stay(State { position, velocity, acceleration });
            return Ok(());
        }
        *time = self.time;
        time.begin_at(x - self.begin).ok_or(Error::Target)
    }

    /// When the last rate is reached, s; the end of the path if it is not reached.
    pub fn until(&self) -> R {
        self.until
    }

    /// The time `x`, s, is 0 from now on. Times of many hours are rounded coarsely.
    pub fn rebase(&mut self, x: R) {
        for time in [&mut self.begin, &mut self.until, &mut self.begin_before] {
            *time = *time - x;
        }
    }

    /// The time of the path at the time `x`, s. Until the first change it is `x`.
    pub fn time(&self, x: R) -> R {
        let [s, ..] = self.state_of_time(x);
        s
    }

    /// The time of the path and its derivatives.
    pub(super) fn state_of_time(&self, x: R) -> [R; 4] {
        let (of, start, is_led) = if x < self.begin {
            (&self.before, self.begin_before, self.was_led)
        } else {
            (&self.time, self.begin, self.is_led)
        };
        let state = of.state(x - start);
        if is_led > 0 { lead::along(&self.lead, state) } else { state }
    }

    /// The lowest and the highest time of the path from the last change until the time `x`, s.
    pub(super) fn span(&self, x: R) -> [R; 2] {
        let [begin, end] = [self.begin, x].map(|x| self.time(x));
        let (low, high) = (begin.at_most(end), begin.at_least(end));
        if self.is_led > 0 {
            return [low, high];
        }
        let reached = self.time.extremes();
        [low.at_most(reached.lowest.position), high.at_least(reached.highest.position)]
    }

    /// Position, velocity, acceleration and jerk of an axis of the path at the time `x`, s. The move of the axis in the first section begins `moves`, and its
    /// move in the next section is `n` moves later: axis `i` of `n` axes has `&moves[i..]`. All are NaN if there is no move.
    pub fn state(&self, moves: &[Move<R>], n: usize, x: R) -> [R; 4] {
        AxisPath::new(moves, n, 0).state(self.state_of_time(x))
    }
}
