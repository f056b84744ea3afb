//! The recovery: the fastest motion to a state from which the limits can be kept.

use crate::interval::border::Border;
use crate::interval::profile::Segment;
use crate::interval::ramp::{Change, PerJerk, Ramp};
use crate::interval::rounding::of_state;
use crate::limits::Limits;
use crate::real::Real;
use crate::state::State;

/// The recovery back within the limits: the acceleration changes, and then holds. It is the ramp to the limit of the velocity without its last part.
#[derive(Clone, Copy, Default)]
pub(crate) struct Recovery<R> {
    /// The acceleration at the end of the recovery.
    acceleration: R,
    /// Whether the acceleration rises. A slow jerk may change it by less than a rounding.
    rises: bool,
    /// How long the acceleration changes, s.
    ramp: R,
    /// How long the acceleration holds, s.
    hold: R,
    /// What the recovery changes.
    pub change: Change<R>,
    /// Whether the start is outside the limits, or will unavoidably exceed them.
    pub starts_outside: bool,
}

impl<R: Real> Recovery<R> {
    /// The recovery from the state `from`. It has no duration if `from` is within them.
    pub fn from(limits: &Limits<R>, per_jerk: PerJerk<R>, from: &State<R>) -> Self {
        let State { velocity: v, acceleration: a, .. } = *from;
        // The velocity once the acceleration is 0.
        let v_at_a_zero = v + per_jerk.straight(a, R::ZERO);
        let (fastest, slowest) = (v_at_a_zero.at_least(v), v_at_a_zero.at_most(v));
        let Limits { vmax, vmin, amax, amin, .. } = *limits;
        if a <= amax && a >= amin && fastest <= vmax && slowest >= vmin {
            return Self { acceleration: a, ..Self::default() };
        }
        let (above, below) = ((a - amax).at_least(R::ZERO), (amin - a).at_least(R::ZERO));
        // A start beyond a velocity by rounding stays there. A recovery would overshoot a target next to it.
        let rounding = of_state(v.abs() + (v_at_a_zero - v).abs());
        let (highest, lowest) = (vmax + rounding, vmin - rounding);
        // Where the acceleration goes, how far that is, whether it rises, and how long it stays there.
        let (to, far, rises, hold) = if v_at_a_zero > highest || v_at_a_zero < lowest {
            let falls = v_at_a_zero > highest;
            let (beyond, limit, farther) =
                if falls { (v_at_a_zero - vmax, -amin, below) } else { (vmin - v_at_a_zero, amax, above) };
            let ramp = Ramp::over(beyond, a.negate_if(falls).at_most(limit), R::ZERO, limit, per_jerk);
            let turns = farther > R::ZERO;
            (ramp.peak.negate_if(falls), ramp.rise + farther, turns == falls, ramp.hold)
        } else {
            let limited = a.at_most(amax).at_least(amin);
            (limited, above + below, below > R::ZERO, R::ZERO)
        };
        let ramp = far * if rises { per_jerk.gu } else { per_jerk.gd };
        let change = Change::of(a, to, ramp).hold(to, hold);
        let starts_outside = fastest > highest || slowest < lowest || above > of_state(amax) || below > of_state(-amin);
        Self { acceleration: to, rises, ramp, hold, change, starts_outside }
    }

    /// The motions from the end of the recovery on.
    pub fn border(&self, limits: &Limits<R>, per_jerk: PerJerk<R>, from: &State<R>, to: &State<R>) -> Border<R> {
        let ends = [[from.velocity, self.acceleration], [to.velocity, to.acceleration]];
        Border::new(ends, limits, per_jerk).starting_faster(self.change.velocity)
    }

    /// The segments of the recovery from the acceleration `from`, in order of time.
    pub fn segments(&self, limits: &Limits<R>, from: R) -> [Segment<R>; 2] {
        let jerk = if self.rises { limits.jmax } else { limits.jmin };
        [Segment::new(from, jerk, self.ramp), Segment::new(self.acceleration, R::ZERO, self.hold)]
    }
}
