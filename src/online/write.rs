//! Writes a move: its phases in order of time, and what a planner corrects in a written move.

use super::motion::{MOST_PHASES, Move};
use super::phase::Phase;
use crate::findings::Error;
use crate::interval::profile::Segment;
use crate::interval::rounding::{of_check, of_formula};
use crate::real::Real;
use crate::state::State;

/// Writes the phases of a move in order of time.
///
/// Phase 0 holds the start. The states of the others are found from the end, so an axis that is planned again in every cycle does not add up
/// rounding errors on its way.
pub(crate) struct Writer<'a, R> {
    ctx: &'a mut Move<R>,
    /// The time at the end of what is written.
    t: R,
    /// The duration of the shortest phase that is written.
    shortest: R,
    count: usize,
}

impl<'a, R: Real> Writer<'a, R> {
    pub fn new(ctx: &'a mut Move<R>, from: State<R>) -> Self {
        let State { position, velocity, acceleration } = from;
        ctx.phase[0] = Phase { position, velocity, acceleration, ..Phase::default() };
        Self { ctx, t: R::ZERO, shortest: R::INFINITY, count: 1 }
    }

    /// Adds a phase, if it has a duration. There is room: a mean of two motions has 13 at most, and a recovery takes as many from them as it has.
    pub fn write(&mut self, segment: &Segment<R>) {
        let Segment { from, jerk, duration } = *segment;
        if !(duration > R::ZERO && self.count < MOST_PHASES) {
            return;
        }
        if let Some(phase) = self.ctx.phase.get_mut(self.count) {
            phase.start = self.t;
            phase.duration = duration;
            phase.acceleration = from;
            phase.jerk = jerk;
            self.count += 1;
            self.t = self.t + duration;
            self.shortest = self.shortest.at_most(duration);
        }
    }

    /// Ends the move in this state.
    pub fn end(self, to: State<R>) {
        let Self { ctx, t, shortest, mut count } = self;
        let sliver = of_formula(t);
        if shortest < sliver {
            count = ctx.join_slivers(count, t, sliver);
        }
        let State { position, velocity, acceleration } = to;
        if let Some(end) = ctx.phase.get_mut(count) {
            *end = Phase { start: t, position, velocity, acceleration, ..Phase::default() };
        }
        ctx.find_states(count);
        ctx.t = t;
        ctx.count = count as u32;
    }
}

impl<R: Real> Move<R> {
    /// Makes the move end where it starts.
    pub(crate) fn stay(&mut self, state: State<R>) {
        Writer::new(self, state).end(state);
    }

    /// Counts the positions from the start. So they have the rounding errors of the displacement alone, and near the start they tell the time.
    pub(crate) fn count_from_start(&mut self) {
        let (start, count) = (self.phase[0].position, self.phase_count());
        if let Some(end) = self.phase.get_mut(count) {
            end.position = end.position - start;
        }
        self.find_states(count);
        (self.phase[0].position, self.phase[1].position) = (R::ZERO, R::ZERO);
    }

    /// Makes a move that ends at rest at 0 end level with a moving target instead.
    pub(super) fn shift(&mut self, from: State<R>, target: State<R>) {
        let count = self.phase_count();
        for phase in self.phase.iter_mut().take(1 + count) {
            phase.position = target.position + (phase.position + target.velocity * phase.start);
            phase.velocity = phase.velocity + target.velocity;
        }
        (self.phase[0].position, self.phase[0].velocity) = (from.position, from.velocity);
    }

    /// Adds the motion of a `signal` of constant jerk, and begins at `from`, where the axis is. The sums have the rounding of both motions, so each
    /// phase begins where the one before it leads. A step of the acceleration stays, where a jerk is infinite.
    pub(crate) fn add(&mut self, signal: &Phase<R>, from: State<R>) {
        let State { position, velocity, acceleration } = from;
        let [first, later @ ..] = &mut self.phase;
        *first = Phase { position, velocity, acceleration, ..Phase::default() };
        // As that of a plan, the velocity is found from the end. So a loop does not add up rounding errors.
        let is_steady = signal.acceleration == R::ZERO && signal.jerk == R::ZERO;
        let velocity = if is_steady { later[0].velocity + signal.velocity } else { velocity };
        let mut before = Phase { velocity, ..*first };
        for phase in later.iter_mut().take(self.count as usize) {
            let [own, other] = [phase.acceleration, signal.acceleration(phase.start)];
            let (sum, led) = (own + other, before.acceleration(before.duration));
            let is_step = (sum - led).abs() > of_check(own.abs() + other.abs());
            phase.position = before.position(before.duration);
            phase.velocity = before.velocity(before.duration);
            phase.acceleration = if is_step { sum } else { led };
            if phase.duration > R::ZERO {
                phase.jerk = phase.jerk + signal.jerk;
            }
            before = *phase;
        }
    }

    /// Makes a move that ends at rest end at `t`: it ends on its way, or waits.
    pub(crate) fn cut(&mut self, t: R) {
        if t >= self.t {
            return self.wait_until(t);
        }
        let count = self.phase_count();
        let begun = |phase: &&Phase<R>| phase.start < t;
        let last = self.phase.iter().skip(1).take(count.saturating_sub(1)).filter(begun).count();
        if let Some([phase, end]) = self.phase.get_mut(last..last + 2) {
            let z = t - phase.start;
            phase.duration = z;
            let [position, velocity, acceleration] = [phase.position(z), phase.velocity(z), phase.acceleration(z)];
            *end = Phase { start: t, position, velocity, acceleration, ..Phase::default() };
        }
        self.count = 1 + last as u32;
        self.t = t;
    }

    /// Makes the move end at `t`. The two durations differ by rounding only. A short last phase may begin there.
    pub(crate) fn end_at(&mut self, t: R) {
        let count = self.phase_count();
        for phase in self.phase.iter_mut().take(count) {
            phase.start = phase.start.at_most(t);
        }
        if let Some(end) = self.phase.get_mut(count) {
            end.start = t;
        }
        self.t = t;
    }

    /// Makes a move that ends at rest wait there until `t`.
    pub(crate) fn wait_until(&mut self, t: R) {
        let count = self.phase_count();
        if let Some([wait, end]) = self.phase.get_mut(count..count + 2) {
            *end = *wait;
            wait.duration = t - wait.start;
            self.count += 1;
            self.end_at(t);
        }
    }

    /// Goes on with a move that starts where this one ends. [`Error::Position`] if there are too many phases.
    pub(crate) fn append(&mut self, next: &Self) -> Result<(), Error> {
        let (count, following) = (self.phase_count(), next.phase_count());
        Error::Position.unless(count + following <= 1 + MOST_PHASES)?;
        let places = self.phase.iter_mut().skip(count);
        for (place, phase) in places.zip(next.phase.iter().skip(1).take(following)) {
            *place = *phase;
            place.start = self.t + phase.start;
        }
        self.count = (count + following).saturating_sub(1) as u32;
        self.t = self.t + next.t;
        Ok(())
    }

    /// Shifts the start in time along the move, which then lasts `t`.
    pub(crate) fn shift_in_time(&mut self, t: R) {
        let mut late = self.t - t;
        let count = self.phase_count();
        for phase in self.phase.get_mut(2..count).unwrap_or_default() {
            phase.start = (phase.start - late).at_least(R::ZERO);
        }
        for phase in self.phase.get_mut(1..count).unwrap_or_default() {
            let passed = late.at_most(phase.duration);
            phase.position = phase.position(passed);
            phase.velocity = phase.velocity(passed);
            phase.acceleration = phase.acceleration(passed);
            phase.duration = phase.duration - passed;
            late = late - passed;
        }
        self.end_at(t);
    }

    /// Joins each phase of the duration `t` that is shorter than a `sliver` with the phase after it, if the states stay the same up to rounding.
    /// Returns what is left of `count`.
    #[cold]
    #[inline(never)] // the end of most moves saves no registers for it
    fn join_slivers(&mut self, count: usize, t: R, sliver: R) -> usize {
        let mut kept = 1;
        for index in 1..count {
            let Some([phase, next]) = self.phase.get_mut(index..index + 2) else { break };
            if phase.duration < sliver && index + 1 < count && next.join(phase, t) {
                continue;
            }
            let Phase { start, duration, acceleration, jerk, .. } = *phase;
            if let Some(place) = self.phase.get_mut(kept) {
                *place = Phase { start, duration, acceleration, jerk, ..*place };
            }
            kept += 1;
        }
        kept
    }

    /// Finds the states at the start of each phase from the end.
    #[inline] // a call less in each plan
    fn find_states(&mut self, count: usize) {
        let end = self.phase.get(count).copied().unwrap_or_default();
        let (mut way, mut velocity) = (R::ZERO, end.velocity);
        let phases = self.phase.get_mut(1..count).unwrap_or_default();
        for phase in phases.iter_mut().rev() {
            let segment = Segment { from: phase.acceleration, jerk: phase.jerk, duration: phase.duration };
            (way, velocity) = segment.start(way, velocity);
            (phase.position, phase.velocity) = (end.position + way, velocity);
        }
    }

    /// Slows a move from rest to rest down, so that it takes the longer duration `t`. In slow motion it keeps all limits and its displacement.
    pub(crate) fn slow_down(&mut self, t: R) {
        let longer = t / self.t;
        let rate = self.t / t;
        let count = self.phase_count();
        for phase in self.phase.iter_mut().take(count) {
            phase.start = phase.start * longer;
            phase.duration = phase.duration * longer;
            phase.velocity = phase.velocity * rate;
            phase.acceleration = phase.acceleration * rate * rate;
            phase.jerk = phase.jerk * rate * rate * rate;
        }
        self.t = self.t * longer;
        self.end_at(t);
    }

    /// Makes the move begin and end in these states. They differ from its own by rounding only.
    pub(crate) fn set_ends(&mut self, from: State<R>, to: State<R>) {
        let count = self.phase_count();
        for (index, state) in [(count, to), (0, from)] {
            if let Some(phase) = self.phase.get_mut(index) {
                let State { position, velocity, acceleration } = state;
                *phase = Phase { position, velocity, acceleration, ..*phase };
            }
        }
    }

    /// The move of an axis that travels `share` times as far, where this move is at 0 while the axis is at `position`.
    pub(crate) fn scaled(&self, position: R, share: R) -> Self {
        let mut scaled = *self;
        let count = self.phase_count();
        for phase in scaled.phase.iter_mut().take(1 + count) {
            phase.position = position + share * phase.position;
            phase.velocity = share * phase.velocity;
            phase.acceleration = share * phase.acceleration;
            phase.jerk = share * phase.jerk;
        }
        scaled
    }
}
