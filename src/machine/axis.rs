//! An axis that goes on in its move while the next one is planned.

use super::handover::{Handover, Moment, at};
use crate::findings::{Error, Findings};
use crate::limits::Limits;
use crate::online::Move;
use crate::real::Real;
use crate::state::State;
use core::cell::UnsafeCell;

/// An axis between a main loop, which plans, and a timer interrupt, which asks for a setpoint in each tick: [`Axis::split`] gives a half to each.
///
/// A plan starts from the state that the axis will have after `lead` ticks, and takes over in this tick. `lead` counts the ticks that
/// the main loop needs to plan, and one more. Until then the axis goes on in its move. A plan that takes over later than planned would
/// be a jump. So a plan that comes too late does not take over at all, and the main loop gets [`Error::Late`].
///
/// A plan that was accepted and still waits for its tick is replaced by the next one, which starts from the move in force. It takes over
/// in the tick of the plan that waited, or earlier. So an axis that is planned again at short intervals still follows.
#[derive(Debug)]
#[repr(C)]
pub struct Axis<R> {
    pub(crate) handover: Handover,
    /// From one tick to the next, s.
    pub(crate) period: R,
    /// The moves at their places. The handover says who may use which one.
    pub(crate) moves: [UnsafeCell<Move<R>>; 3],
}

/// The half of an axis for the main loop.
#[derive(Debug)]
pub struct Planner<'a, R>(&'a Axis<R>);

/// The half of an axis for the interrupt.
#[derive(Debug)]
pub struct Ticker<'a, R>(&'a Axis<R>);

// SAFETY: there is one planner and one ticker of an axis. They share words, which are atomic, and moves, of which no thread writes one that the
// other one reads: `handover` has the proof.
unsafe impl<R: Send> Send for Planner<'_, R> {}
// SAFETY: as above.
unsafe impl<R: Send> Send for Ticker<'_, R> {}

impl<R: Real> Axis<R> {
    /// An axis in this state, which gets a tick every `period`, s. [`Error::Duration`] if the period is not above 0 or not finite;
    /// [`Error::NotFinite`] if the state is not made of numbers.
    pub fn new(period: R, state: State<R>) -> Result<Self, Error> {
        let moves = [Move::default(); 3].map(UnsafeCell::new);
        let mut axis = Self { handover: Handover::new(), period, moves };
        axis.init(period, state)?;
        Ok(axis)
    }

    /// Does what [`Axis::new`] does, in place. On an error the axis stays as it is.
    pub(crate) fn init(&mut self, period: R, state: State<R>) -> Result<(), Error> {
        are_ticked(period, &[state])?;
        self.handover = Handover::new();
        self.period = period;
        self.moves[0].get_mut().stay(state);
        Ok(())
    }

    /// The halves. Each may go to a thread or to an interrupt of its own. Nobody locks or waits, and nobody sees half a plan.
    pub fn split(&mut self) -> (Planner<'_, R>, Ticker<'_, R>) {
        (Planner(self), Ticker(self))
    }
}

impl<'a, R: Real> Ticker<'a, R> {
    /// # Safety
    /// This is the only ticker of the axis.
    #[cfg(feature = "capi")]
    pub(crate) unsafe fn of(axis: &'a Axis<R>) -> Self {
        Self(axis)
    }

    /// The next setpoint: the state of the move in force, as many periods after its start as there were ticks. Call it once in each tick.
    pub fn tick(&mut self) -> State<R> {
        let Axis { handover, period, moves } = self.0;
        let moment = handover.tick();
        // SAFETY: nobody writes to the move in force.
        let in_force = unsafe { &*at(moves, moment.place).get() };
        in_force.state_at(elapsed(*period, moment))
    }
}

impl<'a, R: Real> Planner<'a, R> {
    /// # Safety
    /// This is the only planner of the axis.
    #[cfg(feature = "capi")]
    pub(crate) unsafe fn of(axis: &'a Axis<R>) -> Self {
        Self(axis)
    }

    /// Goes to a state, by [`Move::plan`], after `lead` ticks. It returns the findings and errors of [`Move::plan`]; [`Error::Late`] if the plan
    /// came after its tick, or if `lead` is 0, or 134,217,728 or more. On an error the axis goes on in its move.
    pub fn go(&mut self, limits: &Limits<R>, to: State<R>, lead: u32) -> Result<Findings, Error> {
        self.next(lead, |next, from, _| next.plan(limits, from, to))
    }

    /// Goes to a velocity and an acceleration, by [`Move::reach`], after `lead` ticks. It returns the findings and errors of [`Planner::go`].
    pub fn reach(&mut self, limits: &Limits<R>, velocity: R, acceleration: R, lead: u32) -> Result<Findings, Error> {
        self.next(lead, |next, from, _| next.reach(limits, from, velocity, acceleration))
    }

    /// Stops, by [`Move::stop`], after `lead` ticks. It returns the findings and errors of [`Planner::go`].
    pub fn stop(&mut self, limits: &Limits<R>, lead: u32) -> Result<Findings, Error> {
        self.next(lead, |next, from, _| next.stop(limits, from))
    }

    /// Follows a signal, by [`Move::track`], after `lead` ticks. Call it in every round of the main loop. `signal` and `jerk` are those of
    /// the last tick. The signal is taken to go on with its jerk until the plan takes over, and for the time `horizon`, s, from then on: `lead` ticks at
    /// least, up to twice as many if the plan replaces one that waits. It returns the findings and errors of [`Move::track`] and [`Planner::go`];
    /// [`Error::NotFinite`] also if the signal leaves the range of the real type.
    pub fn track(
        &mut self, limits: &Limits<R>, signal: State<R>, jerk: R, horizon: R, lead: u32,
    ) -> Result<Findings, Error> {
        let leading = self.0.period * R::from_index(lead as i32);
        self.next(lead, |next, from, ahead| {
            // Until a call within `lead` takes over. Behind its end a plan may leave the limits, and a chase, which stops there, would never get ahead.
            let horizon = if horizon > R::ZERO { horizon.at_least(leading + (leading - ahead)) } else { horizon };
            next.track(limits, from, signal.after(ahead, jerk), jerk, horizon)
        })
    }

    /// `plan` gets the state and the time in which the next move takes over, s from the last tick.
    fn next(
        &mut self, lead: u32, plan: impl FnOnce(&mut Move<R>, State<R>, R) -> Result<Findings, Error>,
    ) -> Result<Findings, Error> {
        let Axis { ref handover, period, ref moves } = *self.0;
        let takeover = handover.prepare(lead).ok_or(Error::Late)?;
        // SAFETY: nobody writes to the move in force, and nobody else uses the move at the place of the takeover, which is another one.
        let (in_force, next) =
            unsafe { (&*at(moves, takeover.from.place).get(), &mut *at(moves, takeover.place).get()) };
        let from = in_force.state_at(elapsed(period, takeover.from));
        let findings = plan(next, from, period * R::from_index(takeover.ticks as i32))?;
        if handover.publish(&takeover) { Ok(findings) } else { Err(Error::Late) }
    }
}

/// Whether axes in these states can get a tick every `period`, s.
pub(super) fn are_ticked<R: Real>(period: R, states: &[State<R>]) -> Result<(), Error> {
    Error::Duration.unless(period > R::ZERO && period.is_finite())?;
    Error::NotFinite.unless(states.iter().all(|state| state.is_finite()))
}

/// The time since the start of the move, s: a product, because a sum of periods would drift.
pub(super) fn elapsed<R: Real>(period: R, moment: Moment) -> R {
    const UPPER: i32 = 1 << 30;
    let [upper, lower] = [moment.age >> 30, moment.age % UPPER as u64];
    let ticks = R::from_index(upper as i32) * R::from_index(UPPER) + R::from_index(lower as i32);
    period * ticks
}
