//! What a plan can spare: how much longer the largest displacement of a section's duration is than the section, and what the state at a waypoint
//! leaves of its limits, with the logarithmic barrier of the latter.

use crate::interval::{border::Border, derivatives::Derivatives, profile::Profile, ramp::PerJerk};
use crate::limits::Limits;
use crate::real::Real;

/// One side of a section of an axis.
pub(super) struct Side<R> {
    border: Border<R>,
    /// The duration, s.
    t: R,
    /// How long the section is.
    h: R,
    /// 1, and -1 in the mirrored axis.
    sign: R,
}

impl<R: Real> Side<R> {
    pub fn upper(limits: &Limits<R>, ends: [[R; 2]; 2], t: R, h: R) -> Self {
        Self { border: Border::between(ends, limits), t, h, sign: R::ONE }
    }

    /// The lower side of an upper one: the upper side of the mirrored axis.
    pub fn lower(&self) -> Self {
        Self { border: self.border.mirrored(), t: self.t, h: -self.h, sign: -self.sign }
    }

    /// The motion with the largest displacement, if there is one, and how much larger this is than the section, if it is.
    pub fn farthest(&self) -> Option<(Profile<R>, R)> {
        let profile = self.border.farthest_of_feasible_ends(self.t)?;
        let change = self.border.change(&profile);
        let slack = (self.border.v0 * self.t - self.h) + change.displacement;
        (slack > R::ZERO).then_some((profile, slack))
    }

    /// Whether this side and the lower one have slack.
    pub fn has_slack(&self) -> bool {
        self.farthest().is_some() && self.lower().farthest().is_some()
    }

    pub fn derivatives(&self, farthest: &Profile<R>) -> Derivatives<R> {
        self.border.derivatives(farthest, self.sign)
    }
}

/// The limits of a waypoint as what they are multiplied by: `1/amax`, `1/amin`, `1/vmax`, `1/vmin`, `gd/2vmax`, `gu/2vmin`. An infinite limit is 0.
pub(super) struct Bounds<R>(pub [R; 6]);

impl<R: Real> Bounds<R> {
    /// The tightest limits of the sections at a waypoint.
    pub fn of(all: impl Iterator<Item = Limits<R>>) -> Self {
        let [mut vmax, mut amax] = [R::INFINITY; 2];
        let [mut vmin, mut amin] = [-R::INFINITY; 2];
        let [mut gu, mut gd] = [R::ZERO; 2];
        for limits in all {
            (vmax, vmin) = (vmax.at_most(limits.vmax), vmin.at_least(limits.vmin));
            (amax, amin) = (amax.at_most(limits.amax), amin.at_least(limits.amin));
            let per_jerk = PerJerk::of(&limits);
            (gu, gd) = (gu.at_least(per_jerk.gu), gd.at_least(per_jerk.gd));
        }
        let [amax, amin, vmax, vmin] = [amax, amin, vmax, vmin].map(|limit| R::ONE / limit);
        Self([amax, amin, vmax, vmin, R::HALF * gd * vmax, -R::HALF * gu * vmin])
    }

    /// What the acceleration, and the velocity once the acceleration is 0, leave of both limits: parts of the limits. An infinite limit leaves 1.
    fn slacks(&self, [v, a]: [R; 2]) -> [R; 4] {
        let Self([amax, amin, vmax, vmin, down, up]) = *self;
        let square = a * a;
        [R::ONE - a * amax, R::ONE - a * amin, R::ONE - (v * vmax + square * down), R::ONE - (v * vmin + square * up)]
    }

    pub fn product(&self, state: [R; 2]) -> Option<R> {
        let [amax, amin, vmax, vmin] = self.slacks(state);
        let is_feasible = amax > R::ZERO && amin > R::ZERO && vmax > R::ZERO && vmin > R::ZERO;
        is_feasible.then_some((amax * amin) * (vmax * vmin))
    }

    /// Whether a state is feasible, up to rounding.
    pub fn hold(&self, state: [R; 2]) -> bool {
        self.slacks(state).iter().all(|slack| *slack >= -R::DOUBT)
    }

    /// Gradient and Hessian of `-mu` times the logarithm of the product, as `v, a` and `vv, va, aa`.
    pub fn barrier(&self, state @ [_, a]: [R; 2], mu: R) -> ([R; 2], [R; 3]) {
        let Self([amax, amin, vmax, vmin, down, up]) = *self;
        let [of_amax, of_amin, of_vmax, of_vmin] = self.slacks(state).map(|slack| R::ONE / slack);
        let accelerations = [amax * of_amax, amin * of_amin];
        let velocities = [vmax * of_vmax, vmin * of_vmin];
        // The change of velocity while the acceleration returns to 0.
        let (down, up) = (down * of_vmax, up * of_vmin);
        let eased = [(a + a) * down, (a + a) * up];
        // Terms of the upper and the lower limit are summed first, so the mirrored axis is rounded alike.
        let sum = |[x, y]: [R; 2]| x + y;
        let dot = |[x, y]: [R; 2], [z, w]: [R; 2]| x * z + y * w;
        (
            [mu * sum(velocities), mu * (sum(accelerations) + sum(eased))],
            [
                mu * dot(velocities, velocities),
                mu * dot(velocities, eased),
                mu * (dot(accelerations, accelerations) + (dot(eased, eased) + ((down + up) + (down + up)))),
            ],
        )
    }
}

#[cfg(test)]
mod tests {
    use super::{Bounds, Side};
    use crate::limits::Limits;

    /// From standstill to standstill the largest displacement in 4 s is 2 units: each second of jerk changes the acceleration by 1.
    #[test]
    fn a_border_is_no_place_for_a_plan() {
        let limits = Limits::symmetric(1.0, 2.0, 3.0);
        for (h, slack) in [(2.0, None), (1.75, Some(0.25))] {
            let upper = Side::upper(&limits, [[0.0; 2]; 2], 4.0, h);
            assert_eq!(upper.farthest().map(|(_, slack)| slack), slack);
            assert_eq!(upper.lower().farthest().map(|(_, slack)| slack), Some(h + 2.0));
        }
    }

    /// A state just within each limit, and one just beyond.
    #[test]
    fn a_state_beyond_one_limit_is_outside() {
        let limits = Limits { vmin: -3.0, amin: -5.0, jmin: -20.0, ..Limits::symmetric(10.0, 4.0, 2.0) };
        let bounds = Bounds::of([limits].into_iter());
        let held = |v, a| (bounds.product([v, a]).is_some(), bounds.hold([v, a]));
        // While an acceleration of 2 falls at a jerk of 20, the velocity rises by 0.1; while one of -2 rises at 10, it falls by 0.2.
        for [v, a] in [[0.0, 4.0], [0.0, -5.0], [2.0, 0.0], [-3.0, 0.0], [1.9, 2.0], [-2.8, -2.0]] {
            assert_eq!(held(0.999 * v, 0.999 * a), (true, true), "{v} {a}");
            assert_eq!(held(1.001 * v, 1.001 * a), (false, false), "{v} {a}");
        }
    }
}
