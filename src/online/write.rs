//! Writes a move: its phases in order of time, and what a planner corrects in a written move.

use super::motion::{MOST_PHASES, Move};
use super::phase::Phase;
use super::profile::Segment;
use crate::real::Real;
use crate::state::State;

/// Writes the phases of a move in order of time.
///
/// Phase 0 holds the start. The states of the others are found from the end, so an axis that is planned anew in every cycle does not add up
/// roundings on its way.
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
        let State {
            position,
            velocity,
            acceleration,
        } = from;
        ctx.phase[0] = Phase {
            position,
            velocity,
            acceleration,
            ..Phase::default()
        };
        Self {
            ctx,
            t: R::ZERO,
            shortest: R::INFINITY,
            count: 1,
        }
    }

    /// Adds a phase, if it has a duration.
    pub fn write(&mut self, segment: &Segment<R>) {
        let Segment {
            from,
            jerk,
            duration,
        } = *segment;
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
        let Self {
            ctx,
            t,
            shortest,
            mut count,
        } = self;
        let sliver = R::from(4) * R::EPSILON * t;
        if shortest < sliver {
            count = ctx.join_slivers(count, t, sliver);
        }
        let State {
            position,
            velocity,
            acceleration,
        } = to;
        if let Some(end) = ctx.phase.get_mut(count) {
            *end = Phase {
                start: t,
                position,
                velocity,
                acceleration,
                ..Phase::default()
            };
        }
        ctx.find_states(count);
        ctx.t = t;
        ctx.count = count as u32;
    }
}

impl<R: Real> Move<R> {
    /// Lets the move end where it starts.
    pub(crate) fn stay(&mut self, state: State<R>) {
        Writer::new(self, state).end(state);
    }

    /// Lets a move that ends at rest at 0 end beside a moving target instead.
    pub(super) fn shift(&mut self, from: State<R>, target: State<R>) {
        let count = self.phase_count();
        for phase in self.phase.iter_mut().take(1 + count) {
            phase.position = target.position + (phase.position + target.velocity * phase.start);
            phase.velocity = phase.velocity + target.velocity;
        }
        (self.phase[0].position, self.phase[0].velocity) = (from.position, from.velocity);
    }

    /// Lets the move end at `t`. The two durations differ by rounding only. A short last phase may begin there.
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

    /// Lets a move that ends at rest wait there until `t`.
    pub(crate) fn wait_until(&mut self, t: R) {
        let count = self.phase_count();
        if let Some([wait, end]) = self.phase.get_mut(count..count + 2) {
            *end = *wait;
            wait.duration = t - wait.start;
            self.count += 1;
            self.end_at(t);
        }
    }

    /// Lets a move that ends at rest go on with another one, which starts there.
    pub(crate) fn go_on(&mut self, next: &Self) {
        let (count, following) = (self.phase_count(), next.phase_count());
        let places = self.phase.iter_mut().skip(count);
        for (place, phase) in places.zip(next.phase.iter().skip(1).take(following)) {
            *place = *phase;
            place.start = self.t + phase.start;
        }
        self.count = (count + following).saturating_sub(1) as u32;
        self.t = self.t + next.t;
    }

    /// Lets the move take the duration `t`, which differs by roundings of the states at both ends. The move begins later or earlier on its way,
    /// by `at_start` at most, s, and ends later or earlier by the rest. The way stays, so a loop that plans anew in the next tick is on the way
    /// of its fastest move, and slips do not add up.
    pub(crate) fn slip(&mut self, t: R, at_start: R) {
        let slip = self.t - t;
        let count = self.phase_count();
        let mut late = slip.at_most(at_start).at_least(-at_start);
        let mut early = slip - late;
        for phase in self.phase.get_mut(2..count).unwrap_or_default() {
            phase.start = (phase.start - late).at_least(R::ZERO);
        }
        let phases = self.phase.get_mut(1..count).unwrap_or_default();
        for phase in phases.iter_mut() {
            let passed = late.at_most(phase.duration);
            phase.position = phase.position(passed);
            phase.velocity = phase.velocity(passed);
            phase.acceleration = phase.acceleration(passed);
            phase.duration = phase.duration - passed;
            late = late - passed;
        }
        for phase in phases.iter_mut().rev() {
            let left_out = early.at_most(phase.duration);
            phase.duration = phase.duration - left_out;
            early = early - left_out;
        }
        self.end_at(t);
    }

    /// Joins each phase of the duration `t` that is shorter than a `sliver` with the phase behind it, if the states stay the same up to roundings.
    /// Returns what is left of `count`.
    fn join_slivers(&mut self, count: usize, t: R, sliver: R) -> usize {
        let mut kept = 1;
        for index in 1..count {
            let Some(phase) = self.phase.get(index).copied() else {
                break;
            };
            let next = self.phase.get_mut(index + 1).filter(|_| index + 1 < count);
            if let Some(next) = next.filter(|_| phase.duration < sliver) {
                if let Some(joined) = next.joined(&phase, t) {
                    *next = joined;
                    continue;
                }
            }
            if kept < index {
                if let Some(place) = self.phase.get_mut(kept) {
                    *place = phase;
                }
            }
            kept += 1;
        }
        kept
    }

    /// Finds the states at the start of each phase from the end.
    fn find_states(&mut self, count: usize) {
        let end = self.phase.get(count).copied().unwrap_or_default();
        let (mut position, mut velocity) = (end.position, end.velocity);
        let phases = self.phase.get_mut(1..count).unwrap_or_default();
        for phase in phases.iter_mut().rev() {
            let segment = Segment {
                from: phase.acceleration,
                jerk: phase.jerk,
                duration: phase.duration,
            };
            (position, velocity) = segment.start(position, velocity);
            (phase.position, phase.velocity) = (position, velocity);
        }
    }

    /// Lets a move from rest to rest take the longer duration `t`. In slow motion it keeps all limits and makes the same way.
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

    /// Lets the move begin and end in these states. They differ from its own by rounding only.
    pub(crate) fn set_ends(&mut self, from: State<R>, to: State<R>) {
        let count = self.phase_count();
        for (index, state) in [(count, to), (0, from)] {
            if let Some(phase) = self.phase.get_mut(index) {
                phase.position = state.position;
                phase.velocity = state.velocity;
                phase.acceleration = state.acceleration;
            }
        }
    }

    /// The move of an axis that travels `share` times as far, where this move is at 0 while the axis is at `position`.
    pub(crate) fn beside(&self, position: R, share: R) -> Self {
        let mut beside = *self;
        let count = self.phase_count();
        for phase in beside.phase.iter_mut().take(1 + count) {
            phase.position = position + share * phase.position;
            phase.velocity = share * phase.velocity;
            phase.acceleration = share * phase.acceleration;
            phase.jerk = share * phase.jerk;
        }
        beside
    }
}
