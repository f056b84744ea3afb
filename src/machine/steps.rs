//! The times at which a stepper motor steps: one that follows a move, and one that follows a stream of states, one a tick, whatever makes them.

use crate::findings::{Error, Extremes};
use crate::interval::rounding::of_formula;
use crate::online::{Move, Phase};
use crate::real::Real;
use crate::roots::root_near;
use crate::state::State;

/// Far within the range of the count.
const MOST_STEPS: i32 = 1_000_000_000;

/// The steps of a motor that follows a move.
///
/// Line `k` is the position `offset + k * step`. The motor stands at the line `count` while the axis is between this line and the next
/// one. So it steps up when the axis passes the next line, and down when the axis passes the line of the motor on its way back.
/// With an offset of half a step the motor is never farther than half a step from the axis.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Steps<R> {
    pub(crate) offset: R,
    pub(crate) step: R,
    /// The part of a phase in which the axis does not turn, on the clock of the phase, s. Its steps up to `from` are taken.
    pub(crate) from: R,
    pub(crate) to: R,
    /// The line of the motor.
    pub(crate) count: i32,
    /// The line of the motor at the end of the part.
    pub(crate) far: i32,
    /// Number of the phase; phase 0 is the start.
    pub(crate) phase: u32,
}

/// A step of a motor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step<R> {
    /// Since the start of the move, s.
    pub time: R,
    /// 1 towards larger positions, else -1.
    pub direction: i32,
}

/// A phase, and where and when it ends.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Piece<R> {
    phase: Phase<R>,
    end: R,
    until: R,
}

impl<R: Real> Piece<R> {
    /// A phase of a move and the start of the next one. Phase 1 begins at the start up to rounding; here it begins at the start, so that an axis
    /// on a line does not pass the line by this rounding.
    fn of(of: &Move<R>, phase: u32) -> Option<Self> {
        let (&found, next) = of.phase_and_next(phase as usize)?;
        let start = of.start();
        let State { position, velocity, .. } = if phase == 1 { start } else { found.state() };
        // A phase that is too short to leave the start ends there, too. The end of the move is exact.
        let rounding = of_formula(start.position.abs() + of.end().position.abs());
        let has_left = (next.position - start.position).abs() > rounding || next.start == of.t;
        let end = if has_left { next.position } else { start.position };
        Some(Self { phase: Phase { position, velocity, ..found }, end, until: next.start })
    }
}

impl<R: Real> Steps<R> {
    /// The steps of a move. The motor stands at the last line that is not above the start.
    ///
    /// [`Error::Limits`] if `step` is not above 0; [`Error::NotFinite`] if a number is not finite, or if a position of the move is more
    /// than `1/ε` steps (8,388,608 in `f32`) or 1,000,000,000 steps away from the offset.
    pub fn new(of: &Move<R>, offset: R, step: R) -> Result<Self, Error> {
        let mut steps = Self::at(offset, step)?;
        steps.count = steps.line_below(of.position(R::ZERO));
        steps.follow(of)?;
        Ok(steps)
    }

    /// No steps yet, of a motor at line 0. It returns the errors of the arguments alone.
    fn at(offset: R, step: R) -> Result<Self, Error> {
        Error::NotFinite.unless(offset.is_finite() && step < R::INFINITY)?;
        Error::Limits.unless(step > R::ZERO)?;
        Ok(Self { offset, step, from: R::ZERO, to: R::ZERO, count: 0, far: 0, phase: 0 })
    }

    /// Goes on with another move from its start, and keeps the motor where it is. So no step is lost where the moves meet: a line between
    /// the motor and the start is passed at once. [`Error::NotFinite`] as in [`Steps::new`]; then nothing changes.
    pub fn follow(&mut self, next: &Move<R>) -> Result<(), Error> {
        let Extremes { lowest, highest } = next.extremes();
        let positions = [next.position(R::ZERO), lowest.position, highest.position];
        Error::NotFinite.unless(positions.into_iter().all(|position| self.is_countable(position)))?;
        self.begin_at(0);
        Ok(())
    }

    /// Whether the line of a position has a number.
    fn is_countable(&self, position: R) -> bool {
        let most = (R::ONE / R::EPSILON).at_most(R::from_index(MOST_STEPS));
        ((position - self.offset) / self.step).abs() <= most
    }

    /// Begins with this phase of a motion.
    fn begin_at(&mut self, phase: u32) {
        (self.phase, self.from, self.to) = (phase, R::ZERO, R::ZERO);
        self.far = self.count;
    }

    /// The line of the motor after the steps so far: the steps up less the steps down, from the line at the start on.
    pub fn count(&self) -> i32 {
        self.count
    }

    /// The next step until the end of the move, for the move that the steps belong to. Each has its time up to rounding, and no time is
    /// before the time of the step before. The count after the last step is the line of the end, whatever is rounded on the way.
    pub fn next(&mut self, of: &Move<R>) -> Option<Step<R>> {
        self.next_of(|phase| Piece::of(of, phase))
    }

    /// The next step in the pieces of a motion.
    fn next_of(&mut self, piece: impl Fn(u32) -> Option<Piece<R>>) -> Option<Step<R>> {
        while self.count == self.far {
            self.enter_next_part(&piece)?;
        }
        let Piece { phase, until, .. } = piece(self.phase)?;
        let direction = if self.far > self.count { 1 } else { -1 };
        let line = self.count.max(self.count + direction);
        self.count += direction;
        self.from = self.time_at(&phase, line, R::from_index(direction));
        Some(Step { time: (phase.start + self.from).at_most(until), direction })
    }

    /// Goes on to where the axis turns next in the phase, else to the end of the phase.
    fn enter_next_part(&mut self, piece: &impl Fn(u32) -> Option<Piece<R>>) -> Option<()> {
        let mut entered = piece(self.phase)?;
        let lasts = self.to < entered.phase.duration; // false for NaN
        if !lasts {
            self.phase += 1;
            self.to = R::ZERO;
            entered = piece(self.phase)?;
        }
        let Piece { phase, end, .. } = entered;
        self.from = self.to;
        // An axis that comes to rest turns only by rounding errors.
        let turns = |z: R| (phase.position(z) - end).abs() > of_formula(phase.position.abs() + end.abs());
        let is_ahead = |z: &R| *z > self.from && *z < phase.duration && turns(*z);
        let turn = phase.turns().into_iter().find(is_ahead);
        self.to = turn.unwrap_or(phase.duration);
        self.far = self.line_below(turn.map_or(end, |z| phase.position(z)));
        Some(())
    }

    /// When the axis is at a line, on the clock of the phase, s. It does not turn between `from` and `to`.
    fn time_at(&self, phase: &Phase<R>, line: i32, direction: R) -> R {
        let line = self.offset + R::from_index(line) * self.step;
        // Positions counted from the line have the rounding error of the displacement alone.
        let seen = Phase { position: phase.position - line, ..*phase };
        let beyond = |z: R| (direction * seen.position(z), direction * seen.velocity(z));
        // The part may end at the line.
        if self.count == self.far && beyond(self.to).0 <= R::ZERO {
            return self.to;
        }
        // The quadratic part of the motion from here on.
        let (s, v) = beyond(self.from);
        let a = direction * phase.acceleration(self.from);
        let root = (v * v - (s + s) * a).at_least(R::ZERO).sqrt();
        let guess = self.from - (s + s) / (v + root);
        let guess = guess.at_least(self.from).at_most(self.to);
        root_near(self.from, self.to, guess, guess - self.from, beyond)
    }

    /// The last line that is not above a position.
    fn line_below(&self, position: R) -> i32 {
        let steps = (position - self.offset) / self.step;
        let towards_0 = steps.to_index();
        if steps < R::from_index(towards_0) { towards_0.saturating_sub(1) } else { towards_0 }
    }
}

/// The steps of a motor that follows a stream of states.
///
/// The stream has one state a period: of a move, of a clock, of a group, of a shaper, of a jog. From one tick to the next the axis moves on the
/// cubic through both positions and velocities. The motor is at the line `count`, which is `count` steps from 0, and within half a step of
/// the axis. No step is lost: at each tick the count is compared with the position.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct StepStream<R> {
    /// From one tick to the next, s.
    pub(crate) period: R,
    /// The least time between two steps, s.
    pub(crate) between: R,
    /// The least time before a step in the other direction, s.
    pub(crate) reversal: R,
    /// When the last step was, or the stream began, s after the start of this tick.
    pub(crate) last: R,
    /// The direction of the last step; 0 before the first one.
    pub(crate) direction: i32,
    pub(crate) steps: Steps<R>,
    /// The motion in this tick.
    pub(crate) phase: Phase<R>,
    /// The state at its end.
    pub(crate) end: State<R>,
}

impl<R: Real> StepStream<R> {
    /// A motor at the step that is nearest to the axis, which is in the state `now`. It gets a state every `period`, s. `step` is the length of one.
    /// [`Error::Limits`] if `step` is not above 0; [`Error::Duration`] if the period is not above 0 or not finite; [`Error::NotFinite`] if another
    /// number is not finite, or if the position is more than `1/ε` steps (8,388,608 in `f32`) or 1,000,000,000 steps away from 0.
    pub fn new(step: R, period: R, now: State<R>) -> Result<Self, Error> {
        let mut steps = Steps::at(-R::HALF * step, step)?;
        Error::Duration.unless(period > R::ZERO && period < R::INFINITY)?;
        Error::NotFinite.unless(now.is_finite() && steps.is_countable(now.position))?;
        steps.count = steps.line_below(now.position);
        steps.begin_at(0);
        let (between, reversal, last) = (R::ZERO, R::ZERO, period);
        Ok(Self { period, between, reversal, last, direction: 0, steps, phase: Phase::default(), end: now })
    }

    /// Keeps at least `between`, s, between two steps, and at least `reversal`, s, before a step in the other direction and before the first one: what the
    /// driver of the motor needs. A step for which there is no time in its tick waits for the next one. [`Error::Duration`] if a time is negative or not finite.
    pub fn wait(&mut self, between: R, reversal: R) -> Result<(), Error> {
        let is_time = |time: R| time >= R::ZERO && time < R::INFINITY;
        Error::Duration.unless(is_time(between) && is_time(reversal))?;
        (self.between, self.reversal) = (between, reversal.at_least(between));
        Ok(())
    }

    /// Begins a tick, at whose end the axis is in the state `now`. Steps of the tick before that nobody asked for come at its start.
    /// [`Error::NotFinite`] as in [`StepStream::new`]; then the tick does not begin.
    pub fn tick(&mut self, now: State<R>) -> Result<(), Error> {
        Error::NotFinite.unless(now.is_finite() && self.steps.is_countable(now.position))?;
        self.phase = between(self.end, now, self.period);
        self.end = now;
        // A step that is long over has no effect.
        self.last = (self.last - self.period).at_least(-self.reversal);
        self.steps.begin_at(1);
        Ok(())
    }

    /// The next step of this tick. Its time is that since the start of the tick. Times are in order.
    #[allow(clippy::should_implement_trait)] // as `Steps::next`
    pub fn next(&mut self) -> Option<Step<R>> {
        let piece = Piece { phase: self.phase, end: self.end.position, until: self.period };
        let mut steps = self.steps;
        let Step { time, direction } = steps.next_of(|phase| (phase == 1).then_some(piece))?;
        let wait = if direction == self.direction { self.between } else { self.reversal };
        let time = time.at_least(self.last + wait);
        if time > self.period {
            return None;
        }
        (self.steps, self.last, self.direction) = (steps, time, direction);
        Some(Step { time, direction })
    }

    /// Where the motor is, in steps from 0: the steps up less the steps down, and where it began.
    pub fn count(&self) -> i32 {
        self.steps.count()
    }
}

/// The cubic from one state to another one, as a phase of the duration `t`: with the velocities of both. Rounding of the positions may give an axis
/// that goes one way a turn. A cubic whose velocities at both ends are at most three times the mean does not turn (Fritsch & Carlson 1980).
fn between<R: Real>(from: State<R>, to: State<R>, t: R) -> Phase<R> {
    let mean = (to.position - from.position) / t;
    let three = R::from(3) * mean;
    let agree = |v: R, w: R| v * w >= R::ZERO;
    let (from_v, to_v) = (from.velocity, to.velocity);
    let goes_one_way = agree(mean, from_v) && agree(mean, to_v) && agree(from_v, to_v);
    let [v0, v1] = [from_v, to_v].map(|v| if goes_one_way && v.abs() > three.abs() { three } else { v });
    let half = R::from(3) * mean - (v0 + v0 + v1);
    let jerk = R::from(6) * ((v0 - mean) + (v1 - mean)) / (t * t);
    Phase { start: R::ZERO, duration: t, position: from.position, velocity: v0, acceleration: (half + half) / t, jerk }
}
