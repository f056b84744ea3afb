//! Changes of velocity by way of one acceleration, and what a jerk changes. `docs/planner.md` has the letters: `gu`, `gd` and `q`.

use crate::limits::Limits;
use crate::real::Real;
use crate::roots::larger_root;

/// The durations in which the acceleration changes by 1: the reciprocals of the jerks, in seconds per unit of acceleration; 0 if the jerk is infinite.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PerJerk<R> {
    /// Of a rise.
    pub gu: R,
    /// Of a fall.
    pub gd: R,
}

impl<R: Real> PerJerk<R> {
    pub fn of(limits: &Limits<R>) -> Self {
        Self { gu: R::ONE / limits.jmax, gd: -(R::ONE / limits.jmin) }
    }

    pub fn mirrored(self) -> Self {
        Self { gu: self.gd, gd: self.gu }
    }

    pub fn mirrored_if(self, mirrored: bool) -> Self {
        if mirrored { self.mirrored() } else { self }
    }

    /// The mean of both durations.
    pub fn q(self) -> R {
        R::HALF * (self.gu + self.gd)
    }

    /// The change of velocity while the acceleration goes straight from `from` to `to`.
    pub fn straight(self, from: R, to: R) -> R {
        let per_jerk = if to > from { self.gu } else { self.gd };
        R::HALF * (from + to) * (to - from).abs() * per_jerk
    }
}

/// Three numbers as the mirrored axis sees them, if `mirrored`.
pub(crate) fn seen<R: Real>([x, y, z]: [R; 3], mirrored: bool) -> [R; 3] {
    if mirrored { [-x, -y, -z] } else { [x, y, z] }
}

/// Changes since the start. A constant velocity is left out.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Change<R> {
    /// s
    pub duration: R,
    /// Of the velocity.
    pub velocity: R,
    /// Without the displacement at the velocity of the start.
    pub displacement: R,
}

impl<R: Real> Change<R> {
    /// A phase of the duration `t`, in which the acceleration goes from `from` to `to`.
    pub fn of(from: R, to: R, t: R) -> Self {
        let half = R::HALF * t;
        let third = (R::SIXTH + R::SIXTH) * t;
        let sum = from + to;
        Self { duration: t, velocity: half * sum, displacement: half * (third * (from + sum)) }
    }

    /// And then a phase of the duration `t`, in which the acceleration goes from `from` to `to`.
    pub fn then(self, from: R, to: R, t: R) -> Self {
        let phase = Self::of(from, to, t);
        Self {
            duration: self.duration + t,
            velocity: self.velocity + phase.velocity,
            displacement: self.displacement + t * self.velocity + phase.displacement,
        }
    }

    /// And then a phase of the duration `t` with one acceleration.
    pub fn hold(self, acceleration: R, t: R) -> Self {
        let change = acceleration * t;
        Self {
            duration: self.duration + t,
            velocity: self.velocity + change,
            displacement: self.displacement + t * (self.velocity + R::HALF * change),
        }
    }
}

#[derive(Clone, Copy, Debug)]
pub(crate) struct Passed<R> {
    /// s
    pub duration: R,
    pub displacement: R,
}

/// A ramp that differs from another one by rounding.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Fitted<R> {
    pub ramp: Ramp<R>,
    /// By how much more it changes the velocity.
    pub faster: R,
}

/// The fastest change of velocity by way of a higher acceleration: the acceleration rises, (holds) and falls.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Ramp<R> {
    /// The ramp belongs to the mirrored axis: in the caller's axis the acceleration falls, (holds) and rises.
    pub mirrored: bool,
    /// How far the acceleration rises.
    pub rise: R,
    /// The highest acceleration.
    pub peak: R,
    /// How long the highest acceleration holds, s.
    pub hold: R,
    /// How far the acceleration falls.
    pub fall: R,
}

impl<R: Real> Ramp<R> {
    /// From the acceleration `a0` up and down to `a1`. The change of velocity exceeds the one of the straight change by `beyond`.
    pub fn over(beyond: R, a0: R, a1: R, limit: R, per_jerk: PerJerk<R>) -> Self {
        let q = per_jerk.q();
        let higher = a0.at_least(a1);
        let most = (limit - higher).at_least(R::ZERO);
        let without_hold = q * most * (higher + limit);
        let (z, peak, hold) = if beyond < without_hold {
            let z = larger_root(higher, -(beyond / q)).at_most(most);
            let z = z.at_least(R::ZERO); // by rounding
            (z, higher + z, R::ZERO)
        } else {
            // An infinite limit holds for no time, also where the change is infinite.
            (most, limit, ((beyond - without_hold) / limit).at_least(R::ZERO))
        };
        Self { mirrored: false, rise: higher - a0 + z, peak, hold, fall: higher - a1 + z }
    }

    /// The straight change of the acceleration.
    pub fn straight(a0: R, a1: R) -> Self {
        let peak = a0.at_least(a1);
        Self { mirrored: false, rise: peak - a0, peak, hold: R::ZERO, fall: peak - a1 }
    }

    /// Whether the acceleration only rises, or only falls.
    pub fn is_straight(&self) -> bool {
        self.hold == R::ZERO && (self.rise == R::ZERO || self.fall == R::ZERO)
    }

    /// The ramp that is `longer` at its highest acceleration, s. `None` if it does not exist, or if it is faster by more than `most`.
    #[inline] // a call less in each plan
    pub fn longer(self, longer: R, limit: R, most: R, per_jerk: PerJerk<R>) -> Option<Fitted<R>> {
        let holds = self.hold > R::ZERO;
        let z = if holds { R::ZERO } else { R::HALF * longer / per_jerk.q() };
        let faster = longer * (self.peak + R::HALF * z);
        if faster.abs() > most {
            return None;
        }
        let (rise, peak, fall) = (self.rise + z, self.peak + z, self.fall + z);
        let hold = if holds { self.hold + longer } else { R::ZERO };
        let ramp = Self { rise, peak, hold, fall, ..self };
        let exists = rise >= R::ZERO && fall >= R::ZERO && hold >= R::ZERO;
        (exists && (holds || peak <= limit)).then_some(Fitted { ramp, faster })
    }

    pub fn mirrored_if(self, mirrored: bool) -> Self {
        Self { mirrored: self.mirrored != mirrored, ..self }
    }

    /// What the ramp passes from the velocity `v` and the acceleration `a0` to the acceleration `a1`, in the ramp's own axis.
    pub fn passed(&self, v: R, a0: R, a1: R, per_jerk: PerJerk<R>) -> Passed<R> {
        let rise = Change::of(a0, self.peak, per_jerk.gu * self.rise).hold(self.peak, self.hold);
        let change = rise.then(self.peak, a1, per_jerk.gd * self.fall);
        Passed { duration: change.duration, displacement: v * change.duration + change.displacement }
    }
}
