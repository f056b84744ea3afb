//! A planned move as phases of constant jerk, and its evaluation.

use super::phase::Phase;
use crate::findings::{Extremes, Findings};
use crate::real::Real;
use crate::sampling::{Edge, Run, Sampled, sampled};
use crate::state::State;

pub(crate) const MOST_PHASES: usize = 15;

/// A move: phases of constant jerk from one state to another.
///
/// Before the start the axis is at the start. After the end it moves on with the acceleration of the end: an axis that ends at rest stays, and an axis
/// that ends with a velocity keeps it. So the state at any time is the start of another plan. A NaN and an infinite time are at the end.
///
/// ```
/// use atraj::State;
/// use atraj::online::{Limits, Move};
/// let mut jog = Move::default();
/// jog.reach(&Limits::symmetric(30.0, 10.0, 5.0), State::at(0.0), 2.0, 0.0)?;
/// let (end, later) = (jog.state_at(jog.t), jog.state_at(jog.t + 3.0));
/// assert_eq!((later.velocity, later.acceleration), (2.0, 0.0));
/// assert!((later.position - (end.position + 6.0_f64)).abs() < 1e-12);
/// # Ok::<(), atraj::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Move<R> {
    /// Duration, s.
    pub t: R,
    /// Number of phases.
    pub count: u32,
    /// The phases in order of time. After the last one is a phase without duration, the end.
    pub phase: [Phase<R>; 16],
}

impl<R: Real> Default for Move<R> {
    fn default() -> Self {
        Self { t: R::ZERO, count: 0, phase: [Phase::default(); 16] }
    }
}

impl<R: Real> Move<R> {
    /// Position at time `x`, s. Up to the start it is the initial one. After the end the axis moves on.
    pub fn position(&self, x: R) -> R {
        let phase = self.phase_at(x);
        phase.position(phase.time(x))
    }

    /// Velocity at time `x`, s. Up to the start it is the initial one. After the end the axis moves on.
    pub fn velocity(&self, x: R) -> R {
        let phase = self.phase_at(x);
        phase.velocity(phase.time(x))
    }

    /// Acceleration at time `x`, s. Up to the start it is the initial one, after the end the final one.
    pub fn acceleration(&self, x: R) -> R {
        let phase = self.phase_at(x);
        phase.acceleration(phase.time(x))
    }

    /// Jerk at time `x`, s; 0 up to the start, after the end and for a NaN.
    pub fn jerk(&self, x: R) -> R {
        self.phase_at(x).jerk
    }

    sampled! { 4, "Position, velocity, acceleration and jerk" }

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

    /// The first time from 0 to `t` at which the axis is at `position`, s; `None` if it never is. A motion after the end does not count.
    pub fn time_at(&self, position: R) -> Option<R> {
        // Phase 1 begins at the start up to rounding. A position in this gap is passed at once.
        let [start, first] = [&self.phase[0], &self.phase[1]].map(|phase| phase.position);
        if position >= start.at_most(first) && position <= start.at_least(first) {
            return Some(R::ZERO);
        }
        for [phase, next] in self.neighbours(0) {
            let [one, other] = phase.turns();
            let mut from = R::ZERO;
            for to in [one, other, phase.duration] {
                // A phase of no duration begins an ulp next to the next one, and the axis passes this gap at once.
                if from <= to && to <= phase.duration {
                    let far = if to < phase.duration { phase.position(to) } else { next.position };
                    if let Some(z) = phase.time_between(from, to, far, position) {
                        return Some((phase.start + z).at_most(next.start));
                    }
                    from = to;
                }
            }
        }
        (self.end().position == position).then_some(self.t)
    }

    /// The finding that a plan overshoots, if it does. From rest to rest a planned axis does not turn.
    pub(crate) fn turn_findings(&self) -> Findings {
        let may_turn = !(self.start().is_at_rest() && self.end().is_at_rest());
        Findings::OVERSHOOTS.when(may_turn && self.overshoots())
    }

    /// Whether the move leaves the positions between its ends: where the axis turns, it is outside.
    #[inline] // a call less in each plan
    pub(crate) fn overshoots(&self) -> bool {
        let (from, to) = (self.phase[0].position, self.end().position);
        let direction = R::ONE.copysign(to - from);
        let goes_back = |velocity: R| direction * velocity < R::ZERO;
        let beyond = R::ONE + R::DOUBT;
        let turns_between = |[phase, next]: &[Phase<R>; 2]| {
            let Phase { acceleration, jerk, duration, .. } = *phase;
            // The velocity may be lowest in the phase, if the acceleration passes 0 by more than rounding, or at its end.
            let dips = goes_back(acceleration) && direction * (beyond * acceleration + jerk * duration) > R::ZERO;
            dips || goes_back(next.velocity)
        };
        let turns = goes_back(self.phase[0].velocity) || self.neighbours(1).any(turns_between);
        turns && self.turns_outside(from.at_most(to), from.at_least(to), self.rounding())
    }

    /// Whether the end is outside of two positions, or the axis turns outside by a part of the rounding error. The start may be another move's.
    pub(crate) fn leaves(&self, lowest: R, highest: R, part: R) -> bool {
        let (from, to) = (self.phase[0].position, self.end().position);
        let rounding = self.rounding();
        let starts_outside = from < lowest - rounding || from > highest + rounding;
        starts_outside || to < lowest || to > highest || self.turns_outside(lowest, highest, part * rounding)
    }

    /// Whether the axis turns outside of two positions, by more than `leeway`.
    #[inline(never)]
    pub(crate) fn turns_outside(&self, lowest: R, highest: R, leeway: R) -> bool {
        let (lowest, highest) = (lowest - leeway, highest + leeway);
        let is_outside = |position: R| position < lowest || position > highest;
        self.neighbours(1).any(|[before, next]| {
            let turns = |z: R| before.lasts_beyond(z) && is_outside(before.position(z));
            // An axis may also turn between two phases.
            is_outside(next.position) || before.may_turn(next) && before.turns().into_iter().any(turns)
        })
    }

    /// 128 ulps of a position of the move: of its ends, and of its highest speed times its duration, but of no more than four times its way.
    #[inline] // a call less in each plan
    pub(crate) fn rounding(&self) -> R {
        let ends = self.phase[0].position.abs() + self.end().position.abs();
        let (mut way, mut highest) = (R::ZERO, R::ZERO);
        for [phase, next] in self.neighbours(1) {
            let speed = phase.velocity.abs().at_least(next.velocity.abs());
            way = way + speed * phase.duration;
            highest = highest.at_least(speed);
        }
        (R::DOUBT + R::DOUBT) * (ends + (highest * self.t).at_most(R::from(4) * way))
    }

    /// Each two phases that follow each other, from phase `first` to the end. Phase 1 is the first that lasts. It begins at the start up to rounding.
    pub(super) fn neighbours(&self, first: usize) -> impl Iterator<Item = &[Phase<R>; 2]> {
        let phases = self.phase.get(first..=self.phase_count()).unwrap_or_default();
        phases.windows(2).filter_map(|pair| pair.try_into().ok())
    }

    /// Whether a written move is within the range of the real type. Its states are sums from the end, and an infinity in any term makes the sum infinite.
    pub(crate) fn is_finite(&self) -> bool {
        let first = &self.phase[1];
        (self.t + first.position.abs() + first.velocity.abs()).is_finite()
    }

    pub(crate) fn start(&self) -> State<R> {
        self.phase[0].state()
    }

    pub(crate) fn end(&self) -> State<R> {
        let [start, ..] = &self.phase;
        self.phase.get(self.phase_count()).unwrap_or(start).state()
    }

    /// The phases in order of time. The first one has no duration and holds the start.
    pub fn phases(&self) -> &[Phase<R>] {
        self.phase.get(..self.phase_count()).unwrap_or_default()
    }

    /// A phase and the next one, which begins where it ends.
    pub(crate) fn phase_and_next(&self, index: usize) -> Option<(&Phase<R>, &Phase<R>)> {
        let phase = self.phases().get(index)?;
        Some((phase, self.phase.get(index + 1)?))
    }

    /// Number of phases, whatever a foreign struct says.
    pub(super) fn phase_count(&self) -> usize {
        (self.count as usize).min(MOST_PHASES)
    }

    /// When the first phase after the time `x` begins, s. The end is the last one.
    pub(crate) fn border_after(&self, x: R) -> Option<R> {
        let mut later = self.phase.iter().skip(1).take(self.phase_count()).map(|phase| phase.start);
        later.find(|start| *start > x)
    }

    /// The phase at the time `x`. Phase 0 is the start. After the last phase is one without duration, the end.
    #[cfg_attr(target_os = "none", inline(never))] // one copy for all evaluations
    pub(crate) fn phase_at(&self, x: R) -> &Phase<R> {
        let [start, later @ ..] = &self.phase;
        let mut found = start;
        if x <= R::ZERO && self.t > R::ZERO {
            return found;
        }
        for phase in later.get(..self.phase_count()).unwrap_or_default() {
            if x < phase.start {
                break;
            }
            found = phase;
        }
        found
    }
}

impl<R: Real> Sampled<R, 4, 17> for Move<R> {
    fn borders(&self) -> [Edge<R>; 17] {
        let mut borders = [Edge::Below(R::ZERO); 17];
        let used = self.phase.iter().take(1 + self.phase_count());
        for (border, phase) in borders.iter_mut().zip(used) {
            *border = Edge::Below(phase.start);
        }
        borders[0] = Edge::UpTo(R::ZERO);
        // A NaN is at the end, and this border separates it from a time before the start.
        borders[16] = Edge::UpTo(R::INFINITY);
        borders
    }

    fn each(&self, x: R) -> [R; 4] {
        [self.position(x), self.velocity(x), self.acceleration(x), self.jerk(x)]
    }

    #[inline(always)]
    fn together(&self, x: R) -> [R; 4] {
        let phase = self.phase_at(x);
        let z = phase.time(x);
        let jerk = phase.jerk;
        [phase.position(z), phase.velocity(z), phase.acceleration(z), jerk]
    }

    fn fill(&self, run: Run<'_, R, 4>) {
        let phase = *self.phase_at(run.x);
        run.fill(|x| {
            let z = phase.time(x);
            [phase.position(z), phase.velocity(z), phase.acceleration(z), phase.jerk]
        })
    }
}
