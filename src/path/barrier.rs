//! What the steps make small: the sum of the durations over `mu`, less the weighted logarithms of all slacks.
//! `docs/path-theory.md` has the theory, in "The barrier".

use super::chain::Chain;
use super::memory::{group, tile};
use crate::interval::derivatives::Derivatives;
use crate::real::Real;

/// The products of two numbers each, row by row up to the diagonal.
#[rustfmt::skip]
fn products<R: Real>([v0, a0, v1, a1, t]: [R; 5]) -> [R; 15] {
    [
        v0 * v0,
        a0 * v0, a0 * a0,
        v1 * v0, v1 * a0, v1 * v1,
        a1 * v0, a1 * a0, a1 * v1, a1 * a1,
        t * v0, t * a0, t * v1, t * a1, t * t,
    ]
}

fn scaled<R: Real>([v0, a0, v1, a1, t]: [R; 5], by: R) -> [R; 5] {
    [by * v0, by * a0, by * v1, by * a1, by * t]
}

/// Replaces the derivatives of a slack and of the opposite one by those of the sum of their logarithms times `-weight`. Gives both gradients.
fn take_logarithms<R: Real>(
    [above, below]: [R; 2], upper: &mut Derivatives<R>, lower: &Derivatives<R>, weight: R,
) -> [[R; 5]; 2] {
    let (per_above, per_below) = (R::ONE / above, R::ONE / below);
    let (x, z) = (scaled(upper.first, per_above), scaled(lower.first, per_below));
    let products = products(x).into_iter().zip(products(z));
    let entries = upper.second.iter_mut().zip(&lower.second);
    for ((entry, other), (xx, zz)) in entries.zip(products) {
        *entry = weight * ((xx - per_above * *entry) + (zz - per_below * *other));
    }
    let ([x0, x1, x2, x3, x_t], [z0, z1, z2, z3, z_t]) = (x, z);
    let sums = [x0 + z0, x1 + z1, x2 + z2, x3 + z3, x_t + z_t];
    upper.first = scaled(sums, -weight);
    [x, z]
}

/// The derivatives of the sum of both logarithms times `-weight` by the displacement `h`: the first one, those by `h` and `v0`, `a0`, `v1`, `a1`, `t`,
/// and the second one. The gradients of the logarithms are given. The slack above falls by what the displacement grows, and the one below grows.
fn by_displacement<R: Real>([above, below]: [R; 2], [x, z]: [[R; 5]; 2], weight: R) -> (R, [R; 5], R) {
    let (per_above, per_below) = (R::ONE / above, R::ONE / below);
    let mut mixed = x;
    for (x, z) in mixed.iter_mut().zip(z) {
        *x = weight * (per_below * z - per_above * *x);
    }
    (weight * (per_above - per_below), mixed, weight * (per_above * per_above + per_below * per_below))
}

/// The duration `t` changed by `change` on a curve that is `t exp(change/t)` up to the second order and never reaches 0. `None` if it would change
/// by more than a factor of 31.
fn along_curve<R: Real>(t: R, change: R) -> Option<R> {
    let half = R::HALF * change / t;
    let is_near = half.abs() <= R::ONE - R::SIXTEENTH;
    is_near.then(|| t * (R::ONE + half) / (R::ONE - half))
}

impl<R: Real, const K: usize> Chain<'_, '_, R, K> {
    pub fn logarithms(&self) -> usize {
        self.axes * (2 * self.sections + 2 * K * (self.sections - 1))
    }

    /// Weighs the logarithms of a section as its duration: long sections must not crowd out short ones.
    pub fn weigh(&mut self) {
        let mean = self.duration() / R::from_index(self.sections as i32);
        for section in 0..self.sections {
            let weight = self.memory.plan.durations.at(section) / mean;
            self.memory.weights.put(section, weight);
        }
    }

    /// Finds slacks, gradient and Hessian of the logarithms. Gives how much they grow since the plan before. `None` if the plan is not feasible.
    pub fn assemble(&mut self) -> Option<R> {
        self.memory.of_durations.clear();
        self.memory.mixed.clear();
        self.memory.convex_part.clear();
        self.memory.gradient_t.clear();
        self.memory.gradient.clear();
        self.memory.diagonal.clear();
        self.memory.of_offsets.clear();
        let mut growth = R::ZERO;
        // If a whole step is infeasible, half of it often is too, in the same section.
        let first = self.last_assembled;
        for section in (first..self.sections).chain(0..first) {
            for axis in 0..self.axes {
                self.last_assembled = section;
                growth = growth + self.assemble_section(section, axis)?;
            }
        }
        for point in 1..self.sections {
            for axis in 0..self.axes {
                growth = growth + self.assemble_point(point, axis)?;
            }
        }
        Some(growth)
    }

    /// Adds the durations over `mu` to gradient and Hessian.
    pub fn add_durations(&mut self, mu: R) {
        let per_mu = R::ONE / mu;
        for section in 0..self.sections {
            let memory = &mut self.memory;
            let slope = memory.gradient_t.at(section) + per_mu;
            memory.gradient_t.put(section, slope);
            // What the curve of the duration adds.
            memory.of_durations.add(section, [slope / memory.plan.durations.at(section)]);
        }
    }

    /// How much the logarithms of both slacks of a section grow since the plan before.
    fn assemble_section(&mut self, section: usize, axis: usize) -> Option<R> {
        let duration = self.memory.plan.durations.at(section);
        let weight = self.memory.weights.at(section);
        let upper = self.upper(&self.limits(section, axis), (section, axis), duration);
        let lower = upper.lower();
        let ((farthest, above), (nearest, below)) = (upper.farthest()?, lower.farthest()?);
        let slacks = [above, below];
        let mut terms = upper.derivatives(&farthest);
        let logarithms = take_logarithms(slacks, &mut terms, &lower.derivatives(&nearest), weight);
        self.add_convex_part((section, axis), logarithms, weight);
        let (g_h, [hv0, ha0, hv1, ha1, ht], hh) = by_displacement(slacks, logarithms, weight);
        let Derivatives { first, second } = &terms;
        let [g_v0, g_a0, g_v1, g_a1, g_t] = *first;
        let [v0v0, a0v0, a0a0, v1v0, v1a0, v1v1, a1v0, a1a0, a1v1, a1a1, tv0, ta0, tv1, ta1, tt] = *second;
        let piece = section * self.axes + axis;
        let memory = &mut self.memory;
        // What the offsets of both ends change of the displacement.
        let y = memory.tolerances.at(piece);
        let x = piece.checked_sub(self.axes).map_or(R::ZERO, |start| -memory.tolerances.at(start));
        memory.plan.slacks.set(piece, slacks);
        memory.gradient_t.add(section, [g_t]);
        memory.of_durations.add(section, [tt]);
        memory.to_duration.set(2 * piece, group([tv0, ta0, x * ht]));
        memory.to_duration.set(2 * piece + 1, group([tv1, ta1, y * ht]));
        // Waypoint `k` has the row before that of section `k`.
        if let Some(start) = piece.checked_sub(self.axes) {
            memory.gradient.add(start, group([g_v0, g_a0, x * g_h]));
            memory.diagonal.add(start, [v0v0, a0v0, a0a0]);
            if K > 2 {
                memory.of_offsets.add(start, [x * hv0, x * ha0, x * x * hh]);
            }
            let coupling = [[v1v0, a1v0, y * hv0], [v1a0, a1a0, y * ha0], [x * hv1, x * ha1, x * y * hh]];
            memory.coupling.set_tile(start, tile(coupling));
        }
        memory.gradient.add(piece, group([g_v1, g_a1, y * g_h]));
        memory.diagonal.add(piece, [v1v1, a1v1, a1a1]);
        if K > 2 {
            memory.of_offsets.add(piece, [y * hv1, y * ha1, y * y * hh]);
        }
        let [was_above, was_below] = memory.other.slacks.row(piece);
        Some(weight * ((above / was_above) * (below / was_below)).ln())
    }

    /// Adds the part of the second derivatives by the durations that is never negative: along the motion on which they bend the narrow points next to
    /// the section, which is that of the step before.
    fn add_convex_part(&mut self, (section, axis): (usize, usize), logarithms: [[R; 5]; 2], weight: R) {
        let [before, start] = self.slopes(section, axis);
        let [end, after] = self.slopes(section + 1, axis);
        let products = logarithms.map(|[v0, a0, v1, a1, t]| {
            let of_start = |[v, a]: [R; 2]| v0 * v + a0 * a;
            let of_end = |[v, a]: [R; 2]| v1 * v + a1 * a;
            [of_start(before), t + of_start(start) + of_end(end), of_end(after)]
        });
        let [[before, own, after], [other_before, other_own, other_after]] = products;
        let squares = |x: R, z: R| [weight * (x * x + z * z)];
        let convex_part = &mut self.memory.convex_part;
        if let Some(previous) = section.checked_sub(1) {
            convex_part.add(previous, squares(before, other_before));
        }
        convex_part.add(section, squares(own, other_own));
        convex_part.add(section + 1, squares(after, other_after));
    }

    /// How much the logarithms of a waypoint grow since the plan before.
    fn assemble_point(&mut self, point: usize, axis: usize) -> Option<R> {
        let row = (point - 1) * self.axes + axis;
        let (bounds, state) = (self.bounds(point, axis), self.at(point, axis));
        let before = self.memory.other.states.row(point * self.axes + axis);
        let mut growth = (bounds.product(state)? / bounds.product(before)?).ln();
        let weights = &self.memory.weights;
        let weight = weights.at(point - 1).at_most(weights.at(point));
        let ([g_v, g_a], hessian) = bounds.barrier(state, weight);
        self.memory.diagonal.add(row, hessian);
        let mut gradient = [g_v, g_a, R::ZERO];
        if K > 2 {
            let (offset, before) = (self.memory.plan.offsets.at(row), self.memory.other.offsets.at(row));
            let left = |offset: R| (R::ONE - offset) * (R::ONE + offset);
            (left(offset) > R::ZERO).then_some(())?;
            growth = growth + (left(offset) / left(before)).ln();
            let (x, z) = (R::ONE / (R::ONE - offset), R::ONE / (R::ONE + offset));
            gradient[2] = weight * (x - z);
            self.memory.of_offsets.add(row, [R::ZERO, R::ZERO, weight * (x * x + z * z)]);
        }
        self.memory.gradient.add(row, group(gradient));
        if self.is_narrow(point, axis) {
            let gradient = self.memory.gradient.row(row);
            let (g_v, g_a) = (gradient[0], gradient[1]);
            let parabola = self.parabola(point, axis, &self.memory.plan.durations);
            let [before, mixed, later] = parabola.bends(g_v, g_a);
            // What the curves of the durations add.
            let curves = [point - 1, point].map(|section| R::ONE / self.memory.plan.durations.at(section));
            let [first, second] = parabola.slopes.map(|[v, a]| g_v * v + g_a * a);
            self.memory.of_durations.add(point - 1, [before + first * curves[0]]);
            self.memory.mixed.add(point - 1, [mixed]);
            self.memory.of_durations.add(point, [later + second * curves[1]]);
        }
        Some(weight * growth)
    }

    /// Moves the plan by the part `part` of the step. Gives the change of the objective. `None` if the plan would not be feasible: then it stays.
    pub fn try_step(&mut self, part: R, mu: R) -> Option<R> {
        let mut longer = R::ZERO;
        for section in 0..self.sections {
            let duration = self.memory.plan.durations.at(section);
            let tried = along_curve(duration, part * self.change(section))?;
            self.memory.other.durations.put(section, tried);
            longer = longer + (tried - duration);
        }
        for point in 1..self.sections {
            for axis in 0..self.axes {
                let moved = self.moved(point, axis, part);
                let row = point * self.axes + axis;
                self.memory.other.states.set(row, moved);
                if K > 2 {
                    let offset =
                        self.memory.plan.offsets.at(row - self.axes) + part * self.direction(point, axis)[K - 1];
                    self.memory.other.offsets.put(row - self.axes, offset);
                }
            }
        }
        self.swap_plans();
        // A section counts as narrow as before until its slacks are known.
        self.memory.plan.slacks.copy(&self.memory.other.slacks);
        let growth = self.assemble();
        if growth.is_none() {
            self.swap_plans();
        }
        Some(longer / mu - growth?)
    }
}

#[cfg(test)]
mod tests {
    use super::super::chain::{Chain, Request};
    use super::super::elimination::tests::errors;
    use super::super::{plan_path, steps::NewtonBudget};
    use crate::limits::Limits;
    use crate::state::State;

    /// The first and the second derivative along a step of six states and four durations, from gradient and Hessian.
    fn derivatives<const K: usize>(chain: &mut Chain<f64, K>, step: &[f64]) -> [f64; 2] {
        let (states, durations) = step.split_at(6 * K);
        for (k, number) in states.iter().enumerate() {
            chain.memory.step.put(chain.row(1 + k / (2 * K), 0) + k % (2 * K), *number);
        }
        for (section, duration) in durations.iter().enumerate() {
            chain.memory.step.put(chain.row(section, 2), *duration);
        }
        // The equations miss the gradient, and the Hessian times the step.
        let missed: f64 = errors(&chain.memory, chain, 0.0).zip(step).map(|(error, step)| error * step).sum();
        [chain.slope(), missed - chain.slope()]
    }

    /// A path of two axes that differ, with two waypoints close together, in which the plan is feasible. With three unknowns one position alone is exact.
    fn tables_are_derivatives<const K: usize>() {
        let symmetric = Limits::symmetric(40.0, 10.0, 3.0);
        let limits = [symmetric, Limits { vmin: -4.0, amin: -6.0, jmin: -25.0, ..symmetric }];
        let positions = [0.0, 0.0, 3.0, -1.0, 3.05, -1.02, 6.0, 2.0, 5.0, 4.0];
        let mut states = positions.map(State::at);
        (states[0].velocity, states[9].velocity) = (1.0, 0.5);
        let mut durations = [0.0; 4];
        let mut work = [0.0; 2_000];
        plan_path(&mut states, &mut durations, &limits, 2, 4, &mut work).expect("a plan");
        let request = Request::of(&states, &durations, &limits, 2).expect("a request");
        let request = Request { tolerances: &[0.02, 0.1, 0.02, 0.1, 0.0, 0.1], ..request };
        let chain = &mut Chain::<f64, K>::of(request, &mut work).expect("room");
        chain.slow_down(&durations, 48).expect("a feasible plan");
        chain.shorten(NewtonBudget::of(2, 4), 0);
        let is_narrow = |point| [0, 1].map(|axis| chain.is_narrow(point, axis));
        let narrow = [[true, false], [true, false], [false; 2]];
        assert_eq!([1, 2, 3].map(is_narrow), narrow);
        let (mu, little) = (0.05, 1e-5);
        let unknowns = 6 * K + 4;
        for (one, other) in (0..unknowns).flat_map(|one| (0..=one).map(move |other| (one, other))) {
            let mut step = [0.0; 22];
            for unknown in [one, other] {
                step[unknown] += if unknown < 6 * K { 1.0 } else { 0.1 };
            }
            chain.assemble().expect("a feasible plan");
            chain.add_durations(mu);
            let found = derivatives(chain, &step[..unknowns]);
            let mut change = |part| {
                let change = chain.try_step(part, mu).expect("a feasible plan");
                chain.swap_plans();
                change
            };
            let (ahead, back) = (change(little), change(-little));
            let slope = (ahead - back) / (2.0 * little);
            let curvature = (ahead + back) / (little * little);
            for (number, expected) in found.into_iter().zip([slope, curvature]) {
                let off = (number - expected).abs() / (1.0 + expected.abs());
                assert!(off < 1e-4, "{one} {other}: {number} {expected}");
            }
        }
    }

    /// Gradient and Hessian are those of what a step changes, by differences, also where a waypoint is moved along a curve.
    #[test]
    fn the_tables_are_derivatives() {
        tables_are_derivatives::<2>();
        tables_are_derivatives::<3>();
    }
}
