//! What a section can spare: how much longer the largest displacement of its duration is than the section.

use crate::interval::{border::Border, derivatives::Derivatives, profile::Profile};
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

#[cfg(test)]
mod tests {
    use super::Side;
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
}
