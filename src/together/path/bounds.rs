//! The limits of the states at a way point, and their logarithmic barrier.

use crate::limits::Limits;
use crate::online::ramp::PerJerk;
use crate::real::Real;

/// The tightest limits of the sections at a way point.
pub(super) struct Bounds<R> {
    vmax: R,
    vmin: R,
    amax: R,
    amin: R,
    /// In which the acceleration rises by 1, s³ per unit.
    gu: R,
    /// In which the acceleration falls by 1, s³ per unit.
    gd: R,
}

impl<R: Real> Default for Bounds<R> {
    fn default() -> Self {
        let endless = R::INFINITY;
        Self {
            vmax: endless,
            vmin: -endless,
            amax: endless,
            amin: -endless,
            gu: R::ZERO,
            gd: R::ZERO,
        }
    }
}

impl<R: Real> Bounds<R> {
    pub fn tighten(&mut self, limits: &Limits<R>) {
        let PerJerk { gu, gd } = PerJerk::of(limits);
        self.vmax = self.vmax.at_most(limits.vmax);
        self.vmin = self.vmin.at_least(limits.vmin);
        self.amax = self.amax.at_most(limits.amax);
        self.amin = self.amin.at_least(limits.amin);
        self.gu = self.gu.at_least(gu);
        self.gd = self.gd.at_least(gd);
    }

    /// What the acceleration, and the velocity after the acceleration is undone, leave of both limits: parts of the limits. An infinite limit
    /// leaves 1.
    fn slacks(&self, [v, a]: [R; 2]) -> [R; 4] {
        let half_square = R::HALF * a * a;
        [
            R::ONE - a / self.amax,
            R::ONE - a / self.amin,
            R::ONE - (v + self.gd * half_square) / self.vmax,
            R::ONE - (v - self.gu * half_square) / self.vmin,
        ]
    }

    /// The product of the slacks, if the state is inside.
    pub fn product(&self, state: [R; 2]) -> Option<R> {
        let slacks @ [amax, amin, vmax, vmin] = self.slacks(state);
        let is_inside = slacks.iter().all(|slack| *slack > R::ZERO);
        is_inside.then_some((amax * amin) * (vmax * vmin))
    }

    /// Whether a state is inside, but for roundings.
    pub fn hold(&self, state: [R; 2]) -> bool {
        self.slacks(state).iter().all(|slack| *slack >= -R::DOUBT)
    }

    /// Gradient and Hessian of `-mu` times the logarithm of the product, as `v, a` and `vv, va, aa`.
    pub fn barrier(&self, state @ [_, a]: [R; 2], mu: R) -> ([R; 2], [R; 3]) {
        let [amax, amin, vmax, vmin] = self.slacks(state);
        let zero = R::ZERO;
        let term = |slack: R, v: R, a: R, aa: R| {
            let [v, a] = [v / slack, a / slack];
            (
                [-mu * v, -mu * a],
                [mu * v * v, mu * v * a, mu * (a * a - aa / slack)],
            )
        };
        let both = |(f, e): ([R; 2], [R; 3]), (g, h): ([R; 2], [R; 3])| {
            let ([v, a], [vv, va, aa]) = (f, e);
            ([v + g[0], a + g[1]], [vv + h[0], va + h[1], aa + h[2]])
        };
        // The upper and the lower limit are summed first, so the mirrored axis has the same roundings.
        let accelerations = both(
            term(amax, zero, -(R::ONE / self.amax), zero),
            term(amin, zero, -(R::ONE / self.amin), zero),
        );
        let (up, down) = (self.gu / self.vmin, -(self.gd / self.vmax));
        let velocities = both(
            term(vmax, -(R::ONE / self.vmax), a * down, down),
            term(vmin, -(R::ONE / self.vmin), a * up, up),
        );
        both(accelerations, velocities)
    }
}
