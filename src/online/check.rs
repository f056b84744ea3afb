//! What is wrong with a move, found in its phases alone. Nothing here plans, so a monitor can ask before it runs a plan.

use super::motion::{MOST_PHASES, Move};
use super::phase::Phase;
use crate::findings::{Error, Findings};
use crate::limits::Limits;
use crate::real::Real;

/// Magnitudes of a move. Its errors are measured in ulps of them.
struct Scale<R> {
    position: R,
    velocity: R,
    acceleration: R,
}

impl<R: Real> Move<R> {
    /// Examines the move against limits: what it exceeds, whether it jumps or ends elsewhere than its phases lead, and what the findings of
    /// a plan are. A step of the acceleration exceeds a finite jerk. Any struct may be examined: its numbers are judged, not its plan.
    ///
    /// A move that starts outside the limits has the finding of what it exceeds, and [`Findings::STARTS_OUTSIDE`]. [`Error::NotFinite`] if
    /// a number of the move is not finite or a limit is NaN, [`Error::Limits`] if the limits are not around 0.
    ///
    /// Up to 64 ulps are allowed: of |p| + |v| T for positions; for velocities of |v|, what the accelerations add, the velocities in which the
    /// jerk ends those at the start and at the end, and what the limits allow in the time T of the move; of |a| + |j| T for accelerations, where
    /// a step counts the limit of the jerk; of the limits for jerks; 128 where the move turns outside of its ends.
    ///
    /// ```
    /// use atraj::Findings;
    /// use atraj::online::{Limits, Move, State};
    /// let limits = Limits::symmetric(30.0, 10.0, 5.0);
    /// let mut axis = Move::default();
    /// axis.plan(&limits, State::at(0.0), State::at(10.0))?;
    /// assert!(axis.check(&limits)?.is_empty());
    /// axis.phase[3].velocity += 1e-6;
    /// assert!(axis.check(&limits)?.contains(Findings::JUMPS));
    /// # Ok::<(), atraj::Error>(())
    /// ```
    pub fn check(&self, limits: &Limits<R>) -> Result<Findings, Error> {
        limits.are_limits()?;
        let mut used = self.phase.iter().take(1 + self.phase_count());
        Error::NotFinite.unless(self.t.is_finite() && used.all(is_finite))?;
        let scale = self.scale(limits);
        let reached = self.extremes();
        let (lowest, highest) = (reached.lowest, reached.highest);
        let few = R::DOUBT; // 64 ulps
        let exceeds = |x: R, y: R, low: R, high: R, rounding: R| x < low - few * rounding || y > high + few * rounding;
        let Limits { vmax, vmin, amax, amin, .. } = *limits;
        let (a0, a1) = (lowest.acceleration, highest.acceleration);
        // A phase may end faster than the next one begins.
        let ends = self.phases().iter().map(|phase| phase.velocity(phase.duration));
        let (v0, v1) = ends.fold((lowest.velocity, highest.velocity), |(v0, v1), v| (v.at_most(v0), v.at_least(v1)));
        Ok(Findings::EXCEEDS_JERK.when(self.exceeds_jerk(limits, &scale))
            | Findings::EXCEEDS_ACCELERATION.when(exceeds(a0, a1, amin, amax, scale.acceleration))
            | Findings::EXCEEDS_VELOCITY.when(exceeds(v0, v1, vmin, vmax, scale.velocity))
            | Findings::JUMPS.when(self.is_no_sequence() || self.jumps(&scale))
            | Findings::OVERSHOOTS.when(self.overshoots())
            | Findings::STARTS_OUTSIDE.when(self.starts_outside(limits))
            | Findings::ENDS_LEAVING.when(limits.are_left_after(self.end())))
    }

    fn scale(&self, limits: &Limits<R>) -> Scale<R> {
        let reached = self.extremes();
        let acceleration = reached.acceleration();
        let (mut changes, mut jerk) = (R::ZERO, R::ZERO);
        for phase in self.phases() {
            // An acceleration that changes has an error in proportion to the highest one. An acceleration that holds is exact.
            let holds = phase.jerk == R::ZERO;
            let a = if holds { phase.acceleration.abs() } else { acceleration };
            changes = changes + phase.duration.abs() * a;
            jerk = jerk.at_least(phase.jerk.abs());
        }
        let (a0, a1) = (self.phase[0].acceleration, self.end().acceleration);
        let per_jerk = R::ONE / limits.jmax - R::ONE / limits.jmin;
        let eased = R::HALF * (a0 * a0 + a1 * a1) * per_jerk;
        // A mean of two motions has the rounding errors of both, and they may use the limits fully.
        let velocity = reached.speed() + changes + eased + limits.speed_within(self.t);
        let positions = reached.lowest.position.abs() + reached.highest.position.abs();
        Scale { position: positions + velocity * self.t, velocity, acceleration: acceleration + jerk * self.t }
    }

    /// Whether a jerk is beyond its limit, or the acceleration makes a step though the jerk has a limit.
    fn exceeds_jerk(&self, limits: &Limits<R>, scale: &Scale<R>) -> bool {
        let few = R::DOUBT;
        let (most, least) = (limits.jmax + few * limits.jmax, limits.jmin + few * limits.jmin);
        let beyond = self.phases().iter().any(|phase| phase.jerk > most || phase.jerk < least);
        let steps = self.neighbours(0).any(|[before, after]| {
            let step = after.acceleration - before.acceleration(before.duration);
            let jerk = if step > R::ZERO { limits.jmax } else { -limits.jmin };
            jerk.is_finite() && step.abs() > few * (scale.acceleration + jerk * self.t)
        });
        beyond || steps
    }

    /// Whether the phases do not follow each other in time, from 0 to `t`.
    fn is_no_sequence(&self) -> bool {
        let (start, end) = (&self.phase[0], self.phase.get(self.phase_count()));
        let follow = self.neighbours(0).all(|[before, after]| {
            let gap = after.start - (before.start + before.duration);
            // A phase of no duration would go on in a gap.
            let late = if before.duration > R::ZERO { R::DOUBT * self.t } else { R::ZERO };
            before.duration >= R::ZERO && before.start <= after.start && gap.abs() <= late
        });
        let ends = end.is_some_and(|end| end.start == self.t && end.duration == R::ZERO && end.jerk == R::ZERO);
        let starts = start.start == R::ZERO && start.duration == R::ZERO;
        let is_count = self.count as usize <= MOST_PHASES;
        !(follow && starts && ends && is_count)
    }

    /// Whether a phase begins elsewhere than the one before it leads.
    fn jumps(&self, scale: &Scale<R>) -> bool {
        let few = R::DOUBT;
        !self.neighbours(0).all(|[before, after]| {
            let z = before.duration;
            (after.position - before.position(z)).abs() <= few * scale.position
                && (after.velocity - before.velocity(z)).abs() <= few * scale.velocity
        })
    }

    /// Whether the start is outside the limits, or will unavoidably exceed them.
    fn starts_outside(&self, limits: &Limits<R>) -> bool {
        let Phase { velocity: v, acceleration: a, .. } = self.phase[0];
        let few = R::DOUBT;
        let jerk = if a > R::ZERO { -limits.jmin } else { limits.jmax };
        let change = R::HALF * a * a.abs() / jerk;
        let rounding = few * (v.abs() + change.abs());
        v.at_least(v + change) > limits.vmax + rounding
            || v.at_most(v + change) < limits.vmin - rounding
            || a > limits.amax + few * limits.amax
            || a < limits.amin + few * limits.amin
    }
}

fn is_finite<R: Real>(phase: &Phase<R>) -> bool {
    let Phase { start, duration, position, velocity, acceleration, jerk } = *phase;
    let numbers = [start, duration, position, velocity, acceleration, jerk];
    numbers.iter().all(|x| x.is_finite())
}
