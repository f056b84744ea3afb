//! The steps of a motor that follows a stream of states, one a tick, whatever makes them.

use super::steps::{Piece, Step, Steps};
use crate::findings::Error;
use crate::online::Phase;
use crate::real::Real;
use crate::state::State;

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
