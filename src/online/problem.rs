//! What is to be planned for one axis: the recovery, and the motions after it.
//!
//! A problem has two clocks. The clock of the move begins at the start. The clock of the border begins where the recovery ends.

use super::motion::Move;
use super::recovery::Recovery;
use super::write::Writer;
use crate::findings::{Error, Findings};
use crate::interval::border::Border;
use crate::interval::crossing::{self, Displacement};
use crate::interval::profile::{Profile, Segment};
use crate::interval::ramp::PerJerk;
use crate::interval::rounding::{of_check, of_state};
use crate::limits::Limits;
use crate::real::Real;
use crate::state::State;

/// A motion from a state to a state within the limits.
#[derive(Clone, Copy)]
pub(crate) struct Problem<R> {
    pub from: State<R>,
    pub to: State<R>,
    /// The sum of the magnitudes of both positions: their rounding is an ulp of it.
    positions: R,
    recovery: Recovery<R>,
    /// The motions after the recovery.
    pub border: Border<R>,
}

impl<R: Real> Problem<R> {
    pub fn new(limits: &Limits<R>, from: &State<R>, to: &State<R>) -> Self {
        let per_jerk = PerJerk::of(limits);
        let recovery = Recovery::from(limits, per_jerk, from);
        let border = recovery.border(limits, per_jerk, from, to);
        Self { from: *from, to: *to, positions: from.position.abs() + to.position.abs(), recovery, border }
    }

    /// The problem of an axis whose positions are counted from its end. Their rounding is an ulp of the sum of the magnitudes of the true ones.
    pub fn with_positions(self, positions: R) -> Self {
        Self { positions, ..self }
    }

    /// The fastest change of velocity, and the position at which it ends.
    pub fn reach(&self) -> (Profile<R>, R) {
        let border = &self.border;
        let beyond = border.beyond_straight();
        let direct = border.direct(if border.is_left_over(beyond) { R::ZERO } else { beyond });
        let displacement = self.displacement_of_recovery() + border.passed(&direct).displacement;
        (border.profile(&direct), self.from.position + displacement)
    }

    fn displacement_of_recovery(&self) -> R {
        let change = &self.recovery.change;
        self.from.velocity * change.duration + change.displacement
    }

    /// The displacement after the recovery.
    pub fn displacement(&self) -> Displacement<R> {
        let h = (self.to.position - self.from.position) - self.displacement_of_recovery();
        Displacement { h, positions: self.positions }
    }

    /// Whether the start may be shifted in time along the first phase of the fastest motion, so that the rest lasts `t`: position, velocity
    /// and acceleration at the start change by rounding errors only.
    pub fn may_shift(&self, fastest: &Move<R>, t: R) -> bool {
        let Self { from, to, ref border, .. } = *self;
        let (first, shift) = (&fastest.phase[1], fastest.t - t);
        if shift > first.duration || fastest.phase_count() < 2 {
            return false;
        }
        let size = shift.abs();
        // An acceleration is known up to its own rounding error, and up to what changes the velocity by its rounding error until the end.
        let acceleration = from.acceleration.abs().at_least(first.acceleration.abs());
        let jerk = first.jerk.abs();
        let velocity = border.rounding_of_velocity();
        let own = of_state(from.acceleration.abs() + to.acceleration.abs());
        let is_known =
            acceleration * size <= velocity && jerk * size <= own + (velocity / t).at_most(of_check(jerk * t));
        // Both ends have rounding errors.
        is_known && from.velocity.abs() * size <= R::from(2) * border.rounding_of_displacement(t, self.positions)
    }

    /// Whether the interval of the duration `t` holds the displacement, up to rounding.
    pub fn takes(&self, t: R) -> bool {
        let after = self.after_recovery(t);
        let lasts = t > R::ZERO && after + of_state(t) >= self.border.shortest();
        lasts && crossing::next_duration(&self.border, after, after, self.displacement()) <= after
    }

    /// The problem after the recovery, with another velocity at its start.
    pub fn starting_faster(&self, change: R) -> Self {
        Self { border: self.border.starting_faster(change), ..*self }
    }

    /// A duration of the move on the clock of the border, s.
    pub fn after_recovery(&self, duration: R) -> R {
        duration - self.recovery.change.duration
    }

    /// A duration on the border on the clock of the move, s.
    pub fn with_recovery(&self, duration: R) -> R {
        self.recovery.change.duration + duration
    }

    pub fn fastest(&self) -> Profile<R> {
        crossing::fastest(&self.border, self.displacement())
    }

    /// Duration of a motion with the recovery, up to rounding, s.
    pub fn duration(&self, profile: &Profile<R>) -> R {
        let per_jerk = self.border.per_jerk.mirrored_if(profile.mirrored);
        self.with_recovery(profile.duration(per_jerk))
    }

    fn recovery(&self) -> [Segment<R>; 2] {
        self.recovery.segments(&self.border.limits, self.from.acceleration)
    }

    /// Whether a motion, and `added` added to any of its numbers, is within the range of the real type.
    #[inline] // a call less in each plan
    pub fn check(&self, profile: &Profile<R>, added: R) -> Result<(), Error> {
        let Self { from, to, .. } = self;
        let t = self.duration(profile);
        // A rise below 0 by rounding moves the accelerations of the fall: see `Border::segments`.
        let moved = profile.first.at_most(profile.last).at_most(R::ZERO);
        let accelerations =
            from.acceleration.abs() + self.border.a0.abs() + profile.peak.abs() + profile.trough.abs() - moved;
        // A segment adds three accelerations.
        let a = R::from(3) * accelerations;
        let v = from.velocity.abs() + to.velocity.abs() + a * t;
        // Twice what the highest acceleration would reach in the whole time.
        let bound = from.position.abs() + to.position.abs() + v * t;
        let is_small = (bound + bound + added).is_finite();
        if is_small || (t + self.sum(profile) + added).is_finite() { Ok(()) } else { Err(Error::NotFinite) }
    }

    /// The sum of the magnitudes of all positions and velocities that [`Problem::write`] writes. An infinity in any term makes it infinite.
    #[cold]
    fn sum(&self, profile: &Profile<R>) -> R {
        let recovery = self.recovery();
        let motion = self.border.segments(profile);
        let State { mut position, mut velocity, .. } = self.to;
        let mut sum = position.abs() + velocity.abs();
        let segments = recovery.iter().chain(&motion).rev();
        for segment in segments.filter(|segment| segment.duration > R::ZERO) {
            (position, velocity) = segment.start(position, velocity);
            sum = sum + position.abs() + velocity.abs();
        }
        sum
    }

    /// Writes the recovery and a motion, unless the numbers are beyond the range of the real type.
    pub fn write(&self, ctx: &mut Move<R>, profile: &Profile<R>) -> Result<(), Error> {
        self.check(profile, R::ZERO)?;
        let mut writer = self.writer(ctx);
        for segment in &self.border.segments(profile) {
            writer.write(segment);
        }
        writer.end(self.to);
        Ok(())
    }

    /// A writer that has written the recovery.
    pub fn writer<'a>(&self, ctx: &'a mut Move<R>) -> Writer<'a, R> {
        let mut writer = Writer::new(ctx, self.from);
        if self.recovery.change.duration > R::ZERO {
            for segment in &self.recovery() {
                writer.write(segment);
            }
        }
        writer
    }

    /// What exceeds the limits before or after the move.
    pub fn outside(&self) -> Findings {
        let is_leaving = self.border.limits.are_left_after(self.to);
        Findings::STARTS_OUTSIDE.when(self.recovery.starts_outside) | Findings::ENDS_LEAVING.when(is_leaving)
    }

    /// The findings of a written move.
    pub fn findings(&self, ctx: &Move<R>) -> Findings {
        ctx.turn_findings() | self.outside()
    }
}
