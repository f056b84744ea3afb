//! Steps along a curve, where a straight one would leave the narrow passage between close points. `docs/path-theory.md` has the theory, in "Close points".

use super::chain::Chain;
use crate::real::Real;
use crate::table::Column;

/// The parabola through three points: its velocity and acceleration at the middle one, and what the durations of both sections change.
pub(super) struct Parabola<R> {
    /// The durations of both sections, s: `T1`, `T2`.
    t: [R; 2],
    /// The mean velocities of both sections: `m1`, `m2`.
    means: [R; 2],
    /// 1/(T1 + T2)
    per: R,
    /// Velocity and acceleration: `v̂`, `â`.
    state: [R; 2],
    /// The derivatives of velocity and acceleration by `T1` and by `T2`.
    pub slopes: [[R; 2]; 2],
}

impl<R: Real> Parabola<R> {
    fn through([h1, h2]: [R; 2], t: [R; 2]) -> Self {
        let [t1, t2] = t;
        let (m1, m2) = (h1 / t1, h2 / t2);
        let per = R::ONE / (t1 + t2);
        let v = (m1 * t2 + m2 * t1) * per;
        let half_a = (m2 - m1) * per;
        let a = half_a + half_a;
        let doubled = |x: R| x + x;
        Self {
            t,
            means: [m1, m2],
            per,
            state: [v, a],
            slopes: [
                [(m2 - m1 * t2 / t1 - v) * per, (doubled(m1 / t1) - a) * per],
                [(m1 - m2 * t1 / t2 - v) * per, (-doubled(m2 / t2) - a) * per],
            ],
        }
    }

    /// The second derivatives of `g_v v̂ + g_a â` by `T1 T1`, `T1 T2` and `T2 T2`.
    pub fn bends(&self, g_v: R, g_a: R) -> [R; 3] {
        let ([t1, t2], [m1, m2]) = (self.t, self.means);
        let [[v1, a1], [v2, a2]] = self.slopes;
        let doubled = |x: R| x + x;
        let (per_1, per_2) = (m1 / (t1 * t1), m2 / (t2 * t2));
        let of = |v: R, a: R| self.per * (g_v * v + g_a * a);
        [
            of(doubled(per_1 * t2 - v1), -doubled(doubled(per_1) + a1)),
            of(-(m1 / t1 + m2 / t2) - (v1 + v2), -(a1 + a2)),
            of(doubled(per_2 * t1 - v2), doubled(doubled(per_2) - a2)),
        ]
    }
}

impl<R: Real, const K: usize> Chain<'_, '_, R, K> {
    /// The state at a waypoint, moved by the part `part` of the step.
    pub fn moved(&self, point: usize, axis: usize, part: R) -> [R; 2] {
        let [v, a] = self.at(point, axis);
        let step = self.direction(point, axis);
        let straight = [v + part * step[0], a + part * step[1]];
        if !self.is_narrow(point, axis) {
            return straight;
        }
        let now = self.parabola(point, axis, &self.memory.plan.durations);
        let then = self.parabola(point, axis, &self.memory.other.durations);
        let before = part * self.change(point - 1);
        let after = part * self.change(point);
        let [[v1, a1], [v2, a2]] = now.slopes;
        let ([v, a], [to_v, to_a]) = (now.state, then.state);
        let [moved_v, moved_a] = straight;
        [moved_v + ((to_v - v) - (v1 * before + v2 * after)), moved_a + ((to_a - a) - (a1 * before + a2 * after))]
    }

    /// What the durations of both sections change of velocity and acceleration at a point, if it is narrow.
    pub fn slopes(&self, point: usize, axis: usize) -> [[R; 2]; 2] {
        let is_bent = point > 0 && point < self.sections && self.is_narrow(point, axis);
        if is_bent { self.parabola(point, axis, &self.memory.plan.durations).slopes } else { [[R::ZERO; 2]; 2] }
    }

    /// Whether the possible displacements of a section next to a waypoint spread less than half of its displacement.
    pub fn is_narrow(&self, point: usize, axis: usize) -> bool {
        let is_narrow = |section| {
            let [above, below] = self.memory.plan.slacks.row(section * self.axes + axis);
            let h = self.displacement(section, axis);
            above + below < R::HALF * h.abs()
        };
        is_narrow(point - 1) || is_narrow(point)
    }

    pub fn parabola(&self, point: usize, axis: usize, durations: &Column<R>) -> Parabola<R> {
        let displacement = |section| self.displacement(section, axis);
        let lasting = |section| self.after_recovery(section, axis, durations.at(section));
        Parabola::through([displacement(point - 1), displacement(point)], [lasting(point - 1), lasting(point)])
    }
}
