//! What an axis can do.

use crate::findings::Error;
use crate::real::Real;
use crate::state::State;

/// What an axis can do. The highest values are above 0, the lowest ones below 0. An infinite limit is no limit. A jerk, or both accelerations, are finite.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Limits<R> {
    /// Highest velocity.
    pub vmax: R,
    /// Lowest velocity, negative.
    pub vmin: R,
    /// Highest acceleration.
    pub amax: R,
    /// Lowest acceleration, negative.
    pub amin: R,
    /// Highest jerk.
    pub jmax: R,
    /// Lowest jerk, negative.
    pub jmin: R,
}

impl<R: Real> Limits<R> {
    /// The same limits in both directions, in liba's order.
    pub fn symmetric(jerk: R, acceleration: R, velocity: R) -> Self {
        let [j, a, v] = [jerk, acceleration, velocity].map(|limit| limit.magnitude());
        Self { vmax: v, vmin: -v, amax: a, amin: -a, jmax: j, jmin: -j }
    }

    /// No limits. They become those of axes by [`Limits::tighten`].
    pub(crate) fn endless() -> Self {
        Self::symmetric(R::INFINITY, R::INFINITY, R::INFINITY)
    }

    pub(crate) fn mirrored(self) -> Self {
        let Self { vmax, vmin, amax, amin, jmax, jmin } = self;
        Self { vmax: -vmin, vmin: -vmax, amax: -amin, amin: -amax, jmax: -jmin, jmin: -jmax }
    }

    /// The limits of the motions in the other order of time: what accelerates then brakes.
    pub(crate) fn reversed(self) -> Self {
        Self { amax: -self.amin, amin: -self.amax, ..self }
    }

    /// Whether a motion between these states can be planned.
    pub(crate) fn check(&self, from: State<R>, to: State<R>) -> Result<(), Error> {
        self.are_limits()?;
        Error::NotFinite.unless(from.is_finite() && to.is_finite())?;
        Error::Target.unless(self.admit(to))
    }

    #[inline] // a call less in each plan
    pub(crate) fn are_limits(&self) -> Result<(), Error> {
        let Self { vmax, vmin, amax, amin, jmax, jmin } = *self;
        let are_around_0 =
            vmax > R::ZERO && vmin < R::ZERO && amax > R::ZERO && amin < R::ZERO && jmax > R::ZERO && jmin < R::ZERO;
        let a_jerk_is_finite = || jmax < R::INFINITY || -jmin < R::INFINITY;
        let accelerations_are_finite = || amax < R::INFINITY && -amin < R::INFINITY;
        if are_around_0 && (a_jerk_is_finite() || accelerations_are_finite()) { Ok(()) } else { Err(self.fault()) }
    }

    /// What is wrong with limits that are not around 0.
    #[cold]
    #[inline(never)]
    fn fault(&self) -> Error {
        let limits = [self.vmax, self.vmin, self.amax, self.amin, self.jmax, self.jmin];
        // The magnitudes have no infinities of both signs, so their sum is NaN only for a NaN.
        let sum = limits.into_iter().fold(R::ZERO, |sum, x| sum + x.abs());
        if sum.partial_cmp(&sum).is_none() { Error::NotFinite } else { Error::Limits }
    }

    /// Widens the limits for an axis which has come to this state.
    pub(crate) fn include(&mut self, state: State<R>) {
        let State { velocity: v, acceleration: a, .. } = state;
        let half_square = R::HALF * a * a;
        let before = if a > R::ZERO { v - half_square / self.jmax } else { v - half_square / self.jmin };
        self.vmax = self.vmax.at_least(v).at_least(before);
        self.vmin = self.vmin.at_most(v).at_most(before);
        self.amax = self.amax.at_least(a);
        self.amin = self.amin.at_most(a);
    }

    /// Whether an axis can come to this state without leaving the limits. It built the acceleration up from 0.
    fn admit(&self, state: State<R>) -> bool {
        let State { velocity, acceleration, .. } = state;
        acceleration <= self.amax
            && acceleration >= self.amin
            && velocity <= self.vmax
            && velocity >= self.vmin
            && (acceleration == R::ZERO
                || self.keep(velocity, -self.change_per_jerk(acceleration, self.jmax, self.jmin)))
    }

    /// Whether an axis in this state will unavoidably exceed the limits, because its acceleration does not vanish at once.
    pub(crate) fn are_left_after(&self, state: State<R>) -> bool {
        let State { velocity, acceleration, .. } = state;
        let change = self.change_per_jerk(acceleration, self.jmin, self.jmax);
        acceleration != R::ZERO && !self.keep(velocity, change)
    }

    /// The change of velocity between this acceleration and 0: with the jerk `along` if it is above 0, else with the jerk `against`.
    fn change_per_jerk(&self, acceleration: R, along: R, against: R) -> R {
        let jerk = if acceleration > R::ZERO { along } else { against };
        R::HALF * acceleration * acceleration.abs() * (R::ONE / jerk).abs()
    }

    /// Whether a velocity that changes by `change` is between the limits, up to rounding.
    fn keep(&self, velocity: R, change: R) -> bool {
        let rounding = R::from(4) * R::EPSILON * (velocity.abs() + change.abs());
        let changed = velocity + change;
        changed <= self.vmax + rounding && changed >= self.vmin - rounding
    }

    /// The speed that the limits allow in the time `t`.
    pub(crate) fn speed_within(&self, t: R) -> R {
        let Self { vmax, vmin, amax, amin, jmax, jmin } = *self;
        let acceleration = (jmax.at_most(-jmin) * t).at_most(amax.at_least(-amin));
        (acceleration * t).at_most(vmax.at_least(-vmin))
    }

    /// Keeps the limits of another axis too, which moves `share` times as far.
    pub(crate) fn tighten(&mut self, other: &Self, share: R) {
        let pairs = [
            (&mut self.vmax, &mut self.vmin, other.vmax, other.vmin),
            (&mut self.amax, &mut self.amin, other.amax, other.amin),
            (&mut self.jmax, &mut self.jmin, other.jmax, other.jmin),
        ];
        if share == R::ZERO {
            return;
        }
        for (highest, lowest, high, low) in pairs {
            let (high, low) = if share > R::ZERO { (high, low) } else { (low, high) };
            *highest = highest.at_most(high / share);
            *lowest = lowest.at_least(low / share);
        }
    }
}
