//! A planned move as phases of constant jerk, and its evaluation.

use super::Move;
use super::border::Change;
use crate::findings::Extremes;
use crate::real::Real;
use crate::roots::root_between;
use crate::sampling::{Edge, Run, Sampled, Sweep};
use crate::state::State;

/// The most phases of a move.
pub(crate) const MOST_PHASES: usize = 15;

/// A phase of constant jerk, and the state of the axis at its start.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(C)]
pub struct Phase<R> {
    /// When it starts, s.
    pub t: R,
    /// How long it lasts, s.
    pub duration: R,
    /// Position at its start.
    pub position: R,
    /// Velocity at its start.
    pub velocity: R,
    /// Acceleration at its start.
    pub acceleration: R,
    /// The jerk.
    pub jerk: R,
}

impl<R: Real> Phase<R> {
    /// The time `x` of the move in the phase, s.
    #[inline(always)]
    fn time(&self, x: R) -> R {
        (x - self.t).at_least(R::ZERO).at_most(self.duration)
    }

    #[inline(always)]
    fn position(&self, z: R) -> R {
        let Self {
            position,
            velocity,
            acceleration,
            jerk,
            ..
        } = *self;
        position + z * (velocity + z * (R::HALF * acceleration + z * jerk * R::SIXTH))
    }

    #[inline(always)]
    fn velocity(&self, z: R) -> R {
        let Self {
            velocity,
            acceleration,
            jerk,
            ..
        } = *self;
        velocity + z * (acceleration + R::HALF * z * jerk)
    }

    #[inline(always)]
    fn acceleration(&self, z: R) -> R {
        self.acceleration + z * self.jerk
    }
}

impl<R: Real> Move<R> {
    /// Position at time `x`, s. Up to the start it is the initial one, after the end and for a NaN the final one.
    pub fn position(&self, x: R) -> R {
        let phase = self.phase_at(x);
        phase.position(phase.time(x))
    }

    /// Velocity at time `x`, s. Up to the start it is the initial one, after the end and for a NaN the final one.
    pub fn velocity(&self, x: R) -> R {
        let phase = self.phase_at(x);
        phase.velocity(phase.time(x))
    }

    /// Acceleration at time `x`, s. Up to the start it is the initial one, after the end and for a NaN the final one.
    pub fn acceleration(&self, x: R) -> R {
        let phase = self.phase_at(x);
        phase.acceleration(phase.time(x))
    }

    /// Jerk at time `x`, s; 0 up to the start, after the end and for a NaN.
    pub fn jerk(&self, x: R) -> R {
        self.phase_at(x).jerk
    }

    /// Position, velocity, acceleration and jerk at time `x`, s.
    #[inline(always)]
    pub fn state(&self, x: R) -> [R; 4] {
        Sampled::state(self, x)
    }

    /// The states at the times `x0`, `x0 + dt`, `x0 + 2*dt`, …, s.
    pub fn states(&self, x0: R, dt: R) -> impl Iterator<Item = [R; 4]> {
        Sweep { x0, dt }.states(|x| self.state(x))
    }

    /// Writes positions, velocities, accelerations and jerks at the times `x0`, `x0 + dt`, `x0 + 2*dt`, …, s, with the
    /// bits of the single calls. Each output is filled to its own end and may be empty.
    ///
    /// Returns the number of samples: the length of the longest output, but at most `i32::MAX`.
    pub fn sample_into(&self, x0: R, dt: R, outputs: [&mut [R]; 4]) -> usize {
        Sweep { x0, dt }.sample(self, outputs)
    }

    /// The lowest and the highest position, velocity and acceleration between 0 and `t`.
    pub fn extremes(&self) -> Extremes<R> {
        let mut reached = Extremes::of(self.end());
        for phase in self.phases() {
            let duration = phase.duration;
            reached.include_velocity(phase.velocity);
            reached.include_acceleration(phase.acceleration);
            reached.include_acceleration(phase.acceleration(duration));
            reached.include_position(phase.position);
            for z in phase.turns() {
                if phase.lasts_beyond(z) {
                    reached.include_position(phase.position(z));
                }
            }
            let peak = -phase.acceleration / phase.jerk;
            if phase.lasts_beyond(peak) {
                reached.include_velocity(phase.velocity(peak));
            }
        }
        reached
    }

    /// The first time at which the axis is at `position`, s; `None` if it never is.
    pub fn time_at(&self, position: R) -> Option<R> {
        if self.phase[0].position == position {
            return Some(R::ZERO);
        }
        let following = self.phase.iter().skip(1);
        for (phase, next) in self.phases().iter().zip(following) {
            let [one, other] = phase.turns();
            let mut from = R::ZERO;
            for to in [one, other, phase.duration] {
                if from < to && to <= phase.duration {
                    let far = if to < phase.duration {
                        phase.position(to)
                    } else {
                        next.position
                    };
                    if let Some(z) = phase.time_between(from, to, far, position) {
                        return Some(phase.t + z);
                    }
                    from = to;
                }
            }
        }
        (self.end().position == position).then_some(self.t)
    }

    /// Lets a move that ends at rest at 0 end beside a moving target instead.
    pub(super) fn shift(&mut self, from: State<R>, target: State<R>) {
        let count = self.count();
        for phase in self.phase.iter_mut().take(1 + count) {
            phase.position = target.position + (phase.position + target.velocity * phase.t);
            phase.velocity = phase.velocity + target.velocity;
        }
        (self.phase[0].position, self.phase[0].velocity) = (from.position, from.velocity);
    }

    /// Lets the move end at `t`, which its duration is but for rounding. A short last phase may begin there.
    pub(crate) fn end_at(&mut self, t: R) {
        let count = self.count();
        for phase in self.phase.iter_mut().take(count) {
            phase.t = phase.t.at_most(t);
        }
        if let Some(end) = self.phase.get_mut(count) {
            end.t = t;
        }
        self.t = t;
    }

    /// Lets the move begin and end in these states, which its own are but for rounding.
    pub(crate) fn set_ends(&mut self, from: State<R>, to: State<R>) {
        let count = self.count();
        for (index, state) in [(count, to), (0, from)] {
            if let Some(phase) = self.phase.get_mut(index) {
                phase.position = state.position;
                phase.velocity = state.velocity;
                phase.acceleration = state.acceleration;
            }
        }
    }

    /// Replaces every state and jerk, those of the start and of the end too.
    pub(crate) fn map(&self, state: impl Fn(&Phase<R>) -> Phase<R>) -> Self {
        let mut mapped = *self;
        let count = self.count();
        for (to, from) in mapped.phase.iter_mut().zip(&self.phase).take(1 + count) {
            *to = state(from);
        }
        mapped
    }

    /// Whether the move leaves the positions between its ends: where the axis turns, it is outside.
    pub(crate) fn overshoots(&self) -> bool {
        let (from, to) = (self.phase[0].position, self.end().position);
        let (near, far) = if from < to { (from, to) } else { (to, from) };
        let phases = self.phases().iter();
        let speed = phases
            .clone()
            .fold(R::ZERO, |speed, phase| speed.at_least(phase.velocity.abs()));
        let rounding = (R::DOUBT + R::DOUBT) * (near.abs() + far.abs() + speed * self.t);
        let is_outside = |position| position < near - rounding || position > far + rounding;
        phases.clone().any(|phase| {
            let turns_outside = |&z: &R| phase.lasts_beyond(z) && is_outside(phase.position(z));
            // An axis may also turn between two phases.
            phase.t > R::ZERO && is_outside(phase.position)
                || phase.may_turn() && phase.turns().iter().any(turns_outside)
        })
    }

    /// The state at the end.
    pub(super) fn end(&self) -> State<R> {
        let end = self.phase_at(R::INFINITY);
        State {
            position: end.position,
            velocity: end.velocity,
            acceleration: end.acceleration,
        }
    }

    pub(super) fn phases(&self) -> &[Phase<R>] {
        self.phase.get(..self.count()).unwrap_or_default()
    }

    /// Number of phases, whatever a foreign struct says.
    fn count(&self) -> usize {
        (self.phases as usize).min(MOST_PHASES)
    }

    /// The phase at the time `x`. Phase 0 is the start. Behind the last phase is one without duration, the end.
    fn phase_at(&self, x: R) -> &Phase<R> {
        let [start, later @ ..] = &self.phase;
        let mut found = start;
        if x <= R::ZERO && self.t > R::ZERO {
            return found;
        }
        for phase in later.get(..self.count()).unwrap_or_default() {
            if x < phase.t {
                break;
            }
            found = phase;
        }
        found
    }
}

impl<R: Real> Phase<R> {
    /// When the axis is at `position` between two times, if it is. It does not turn between them, and it is at `far` in the end.
    fn time_between(&self, from: R, to: R, far: R, position: R) -> Option<R> {
        let near = self.position(from);
        let direction = R::ONE.copysign(far - near);
        let beyond = |z: R| direction * (self.position(z) - position);
        if near == position {
            Some(from)
        } else if beyond(from) < R::ZERO && direction * (far - position) >= R::ZERO {
            Some(root_between(from, to, |z| {
                (beyond(z), direction * self.velocity(z))
            }))
        } else {
            None
        }
    }

    /// Whether the velocity may pass 0 in the phase.
    fn may_turn(&self) -> bool {
        let heads_for_0 = self.acceleration * self.jerk < R::ZERO;
        heads_for_0 || self.velocity * self.velocity(self.duration) < R::ZERO
    }

    /// Whether `z` is a time inside the phase.
    fn lasts_beyond(&self, z: R) -> bool {
        z > R::ZERO && z < self.duration
    }

    /// Where the axis turns, in order: the times in the phase at which its velocity passes 0. Other values mean nothing.
    fn turns(&self) -> [R; 2] {
        let Self {
            velocity,
            acceleration,
            jerk,
            ..
        } = *self;
        let d = acceleration * acceleration - (velocity + velocity) * jerk;
        let sum = -(acceleration + d.sqrt().copysign(acceleration));
        let (one, other) = ((velocity + velocity) / sum, sum / jerk);
        if one < other {
            [one, other]
        } else {
            [other, one]
        }
    }
}

impl<R: Real> Sampled<R, 4, 17> for Move<R> {
    fn borders(&self) -> [Edge<R>; 17] {
        let mut borders = [Edge::Below(R::ZERO); 17];
        let used = self.phase.iter().take(1 + self.count());
        for (border, phase) in borders.iter_mut().zip(used) {
            *border = Edge::Below(phase.t);
        }
        borders[0] = Edge::UpTo(R::ZERO);
        // A NaN is at the end, and this border tells it from a time before the start.
        borders[16] = Edge::UpTo(R::INFINITY);
        borders
    }

    fn each(&self, x: R) -> [R; 4] {
        [
            self.position(x),
            self.velocity(x),
            self.acceleration(x),
            self.jerk(x),
        ]
    }

    #[inline(always)]
    fn together(&self, x: R) -> [R; 4] {
        let phase = self.phase_at(x);
        let z = phase.time(x);
        let jerk = phase.jerk;
        [
            phase.position(z),
            phase.velocity(z),
            phase.acceleration(z),
            jerk,
        ]
    }

    fn fill(&self, run: Run<'_, R, 4>) {
        let phase = *self.phase_at(run.x);
        let jerk = self.jerk(run.x);
        run.fill(|x| {
            let z = phase.time(x);
            [
                phase.position(z),
                phase.velocity(z),
                phase.acceleration(z),
                jerk,
            ]
        })
    }
}

/// A phase before its place in the move is known.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Leg<R> {
    /// Acceleration at the start.
    pub from: R,
    pub jerk: R,
    /// s
    pub duration: R,
}

/// Writes the phases of a move in order of time.
///
/// Phase 0 holds the start. The states of the others are found from the end, so an axis that is planned anew in every cycle does not add up
/// roundings on its way.
pub(crate) struct Pen<'a, R> {
    ctx: &'a mut Move<R>,
    /// The time at the end of what is written.
    t: R,
    count: usize,
}

impl<'a, R: Real> Pen<'a, R> {
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
            count: 1,
        }
    }

    /// Adds a phase, if it has a duration.
    pub fn write(&mut self, leg: Leg<R>) {
        let Leg {
            from,
            jerk,
            duration,
        } = leg;
        if !(duration > R::ZERO && self.count < MOST_PHASES) {
            return;
        }
        if let Some(phase) = self.ctx.phase.get_mut(self.count) {
            phase.t = self.t;
            phase.duration = duration;
            phase.acceleration = from;
            phase.jerk = jerk;
            self.count += 1;
            self.t = self.t + duration;
        }
    }

    /// Ends the move in this state.
    pub fn end(self, to: State<R>) {
        let Self { ctx, t, count } = self;
        let State {
            mut position,
            mut velocity,
            acceleration,
        } = to;
        if let Some(end) = ctx.phase.get_mut(count) {
            *end = Phase {
                t,
                position,
                velocity,
                acceleration,
                ..Phase::default()
            };
        }
        for phase in ctx
            .phase
            .get_mut(1..count)
            .unwrap_or_default()
            .iter_mut()
            .rev()
        {
            let from = phase.acceleration;
            let to = from + phase.jerk * phase.duration;
            // In the other order of time, accelerations have the other sign.
            let mut change = Change::default();
            change.jerk(-to, -from, phase.duration);
            position = position - (velocity * phase.duration + change.displacement);
            velocity = velocity + change.velocity;
            (phase.position, phase.velocity) = (position, velocity);
        }
        ctx.t = t;
        ctx.phases = count as u32;
    }
}
