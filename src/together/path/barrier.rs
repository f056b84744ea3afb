//! What the steps make small: the sum of the durations, less `mu` times the weighted logarithms of all slacks.
//!
//! `docs/path.md` has the theory, in "The barrier".

use super::border::Derivatives;
use super::chain::Chain;
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

/// Replaces the derivatives of a slack and of the opposite one by the derivatives of `-mu` times the sum of their logarithms. Gives the part of the second
/// derivative by the duration that is never negative.
fn take_logarithms<R: Real>(
    [above, below]: [R; 2],
    upper: &mut Derivatives<R>,
    lower: &Derivatives<R>,
    mu: R,
) -> R {
    let (per_above, per_below) = (R::ONE / above, R::ONE / below);
    let (x, z) = (
        scaled(upper.first, per_above),
        scaled(lower.first, per_below),
    );
    let products = products(x).into_iter().zip(products(z));
    let entries = upper.second.iter_mut().zip(&lower.second);
    for ((entry, other), (xx, zz)) in entries.zip(products) {
        *entry = mu * ((xx - per_above * *entry) + (zz - per_below * *other));
    }
    let ([x0, x1, x2, x3, x_t], [z0, z1, z2, z3, z_t]) = (x, z);
    let sums = [x0 + z0, x1 + z1, x2 + z2, x3 + z3, x_t + z_t];
    upper.first = scaled(sums, -mu);
    mu * (x_t * x_t + z_t * z_t)
}

/// A sum of logarithms: products, and few logarithms.
struct Logarithms<R> {
    sum: R,
    product: R,
}

impl<R: Real> Logarithms<R> {
    fn none() -> Self {
        Self {
            sum: R::ZERO,
            product: R::ONE,
        }
    }

    fn add(&mut self, factor: R) {
        self.product = self.product * factor;
        // The next factor must not leave the range of binary32.
        let most = R::from(1 << 7) * R::from(1 << 7) * R::from(1 << 7);
        let is_small = self.product < most && self.product * most > R::ONE;
        if !is_small {
            *self = Self {
                sum: self.sum(),
                product: R::ONE,
            };
        }
    }

    fn sum(&self) -> R {
        self.sum + self.product.ln()
    }
}

impl<R: Real> Chain<'_, '_, R> {
    /// How many logarithms the barrier has.
    pub fn logarithms(&self) -> usize {
        self.axes * (2 * self.sections + 4 * (self.sections - 1))
    }

    /// Weighs the logarithms of a section as its duration: long sections must not crowd out short ones.
    pub fn weigh(&mut self) {
        let mean = self.duration() / R::from_index(self.sections as i32);
        for section in 0..self.sections {
            let weight = self.memory.durations.at(section) / mean;
            self.memory.weights.put(section, weight);
        }
    }

    /// The weight of a way point.
    fn weight_of_point(&self, point: usize) -> R {
        let weights = &self.memory.weights;
        weights.at(point - 1).at_most(weights.at(point))
    }

    /// Finds slacks, gradient and Hessian of the plan as it stands. `None` if the plan is not inside.
    pub fn assemble(&mut self, mu: R) -> Option<()> {
        self.memory.matrix.clear();
        self.memory.damping.clear();
        self.memory.gradient_t.numbers_mut().fill(R::ONE);
        for axis in 0..self.axes {
            for section in 0..self.sections {
                self.assemble_section(section, axis, mu)?;
            }
            for point in 1..self.sections {
                self.assemble_point(point, axis, mu)?;
            }
        }
        Some(())
    }

    fn assemble_section(&mut self, section: usize, axis: usize, mu: R) -> Option<()> {
        let ends = [self.at(section, axis), self.at(section + 1, axis)];
        let duration = self.memory.durations.at(section);
        let mu = mu * self.memory.weights.at(section);
        let limits = self.limits(section, axis).ok()?;
        let [upper, lower] = &self.borders(limits, (section, axis), ends, duration);
        let (above, below) = (upper.farthest()?, lower.farthest()?);
        let slacks = [above.slack, below.slack];
        let mut terms = upper.derivatives(&above);
        let damping = take_logarithms(slacks, &mut terms, &lower.derivatives(&below), mu);
        let Derivatives { first, second } = &terms;
        let [g_v0, g_a0, g_v1, g_a1, g_t] = *first;
        let [
            v0v0,
            a0v0,
            a0a0,
            v1v0,
            v1a0,
            v1v1,
            a1v0,
            a1a0,
            a1v1,
            a1a1,
            tv0,
            ta0,
            tv1,
            ta1,
            tt,
        ] = *second;
        let piece = section * self.axes + axis;
        let memory = &mut self.memory;
        memory.slacks.set(piece, slacks);
        memory.gradient_t.add(section, [g_t]);
        memory.matrix.add(section, section, tt);
        memory.damping.add(section, [damping]);
        memory.to_duration.set(piece, [tv0, ta0, tv1, ta1]);
        // Way point `k` has the row before that of section `k`.
        if let Some(start) = piece.checked_sub(self.axes) {
            memory.gradient.add(start, [g_v0, g_a0]);
            memory.diagonal.add(start, [v0v0, a0v0, a0a0]);
            memory.coupling.set(start, [v1v0, a1v0, v1a0, a1a0]);
        }
        memory.gradient.set(piece, [g_v1, g_a1]);
        memory.diagonal.set(piece, [v1v1, a1v1, a1a1]);
        Some(())
    }

    fn assemble_point(&mut self, point: usize, axis: usize, mu: R) -> Option<()> {
        let row = (point - 1) * self.axes + axis;
        let (bounds, state) = (self.bounds(point, axis), self.at(point, axis));
        let (gradient, hessian) = bounds.barrier(state, mu * self.weight_of_point(point));
        self.memory.gradient.add(row, gradient);
        self.memory.diagonal.add(row, hessian);
        if self.is_narrow(point, axis) {
            let [g_v, g_a] = self.memory.gradient.row(row);
            let [before, mixed, behind] = self
                .parabola(point, axis, &self.memory.durations)
                .bends(g_v, g_a);
            self.memory.matrix.add(point - 1, point - 1, before);
            self.memory.matrix.add(point, point - 1, mixed);
            self.memory.matrix.add(point, point, behind);
        }
        Some(())
    }

    /// How the plan changes if it takes the part `part` of the step: the change of the objective. `None` if it is not inside then.
    pub fn try_step(&mut self, part: R, mu: R) -> Option<R> {
        let mut change = R::ZERO;
        for section in 0..self.sections {
            let duration = self.memory.durations.at(section);
            let tried = duration + part * self.memory.changes.at(section);
            self.memory.tried.put(section, tried);
            change = change + (tried - duration);
        }
        for point in 1..self.sections {
            for axis in 0..self.axes {
                let moved = self.moved(point, axis, part);
                let row = point * self.axes + axis;
                self.memory.tried_states.set(row, moved);
            }
        }
        let mut logarithms = R::ZERO;
        for section in 0..self.sections {
            let weight = self.memory.weights.at(section);
            logarithms = logarithms + weight * self.try_section(section)?;
        }
        for point in 1..self.sections {
            logarithms = logarithms + self.weight_of_point(point) * self.try_point(point)?;
        }
        Some(change - mu * logarithms)
    }

    /// The change of the logarithms of a section's slacks.
    fn try_section(&self, section: usize) -> Option<R> {
        let tried = self.memory.tried.at(section);
        let mut logarithms = Logarithms::none();
        for axis in 0..self.axes {
            let piece = section * self.axes + axis;
            let states = &self.memory.tried_states;
            let ends = [states.row(piece), states.row(piece + self.axes)];
            let [upper, lower] = self.slacks(section, axis, ends, tried)?;
            let [was_upper, was_lower] = self.memory.slacks.row(piece);
            logarithms.add((upper / was_upper) * (lower / was_lower));
        }
        Some(logarithms.sum())
    }

    /// The change of the logarithms of a way point's slacks.
    fn try_point(&self, point: usize) -> Option<R> {
        let mut logarithms = Logarithms::none();
        for axis in 0..self.axes {
            let bounds = self.bounds(point, axis);
            let tried = self.memory.tried_states.row(point * self.axes + axis);
            logarithms.add(bounds.product(tried)? / bounds.product(self.at(point, axis))?);
        }
        Some(logarithms.sum())
    }
}

#[cfg(test)]
mod tests {
    use super::super::chain::{Chain, Request};
    use super::super::elimination::tests::errors;
    use super::super::steps::Steps;
    use super::Logarithms;
    use crate::limits::Limits;
    use crate::state::State;

    /// Each factor is far within the range of binary32, and the product of all is far beyond it.
    #[test]
    fn no_sum_of_logarithms_leaves_the_range() {
        for factor in [1e-9_f32, 0.5, 3.0, 1e9] {
            let mut logarithms = Logarithms::none();
            (0..200).for_each(|_| logarithms.add(factor));
            let sum = 200.0 * f64::from(factor).ln();
            let off = (f64::from(logarithms.sum()) - sum) / sum;
            assert!(off.abs() < 1e-5, "{factor}: {off}");
        }
    }

    /// A path of two axes that differ, with two way points close to each other, in which the plan is inside.
    fn with_path(judge: impl FnOnce(&mut Chain<f64>)) {
        let symmetric = Limits::symmetric(40.0, 10.0, 3.0);
        let limits = [
            symmetric,
            Limits {
                vmin: -4.0,
                amin: -6.0,
                jmin: -25.0,
                ..symmetric
            },
        ];
        let positions = [0.0, 0.0, 3.0, -1.0, 3.2, -1.1, 6.0, 2.0, 5.0, 4.0];
        let mut states = positions.map(State::at);
        (states[0].velocity, states[9].velocity) = (1.0, 0.5);
        let request = Request {
            axes: 2,
            sections: 4,
            states: &states,
            limits: &limits,
        };
        let mut work = [0.0; 1_000];
        let mut chain = Chain::of(request, &mut work).expect("room");
        chain.stop_everywhere().expect("a plan");
        assert!(chain.come_inside());
        chain.shorten(Steps::of(8, 4), 0);
        judge(&mut chain);
    }

    /// Six states and four durations.
    type Step = [[f64; 2]; 8];

    /// The first and the second derivative along a step, from gradient and Hessian.
    fn derivatives(chain: &mut Chain<f64>, step: &Step) -> [f64; 2] {
        let (states, durations) = step.split_at(6);
        for (row, &state) in states.iter().enumerate() {
            chain.memory.directions.set(row, state);
        }
        let changes = chain.memory.changes.numbers_mut();
        changes.copy_from_slice(durations.as_flattened());
        let memory = &chain.memory;
        let durations = memory.gradient_t.numbers().iter().copied();
        let gradient = memory.gradient.rows(6).flatten().chain(durations);
        let product = |(number, step): (f64, &f64)| number * step;
        let slope: f64 = gradient.zip(step.as_flattened()).map(product).sum();
        // The equations miss the gradient, and the Hessian times the step.
        let missed = errors(memory, chain, 0.0).zip(step.as_flattened());
        [slope, missed.map(product).sum::<f64>() - slope]
    }

    /// Gradient and Hessian are those of what a step changes, by differences, also where a way point is moved along a curve.
    #[test]
    fn the_tables_are_derivatives() {
        with_path(|chain| {
            let is_narrow = |point| [0, 1].map(|axis| chain.is_narrow(point, axis));
            let narrow = [[true; 2], [true; 2], [false, true]];
            assert_eq!([1, 2, 3].map(is_narrow), narrow);
            let (mu, little) = (0.05, 1e-5);
            chain.assemble(mu).expect("a plan inside");
            for (one, other) in (0..16).flat_map(|one| (0..=one).map(move |other| (one, other))) {
                let mut step = Step::default();
                for unknown in [one, other] {
                    step[unknown / 2][unknown % 2] += if unknown < 12 { 1.0 } else { 0.1 };
                }
                let found = derivatives(chain, &step);
                let mut change = |part| chain.try_step(part, mu).expect("a plan inside");
                let (ahead, back) = (change(little), change(-little));
                let slope = (ahead - back) / (2.0 * little);
                let curvature = (ahead + back) / (little * little);
                for (number, expected) in found.into_iter().zip([slope, curvature]) {
                    let off = (number - expected).abs() / (1.0 + expected.abs());
                    assert!(off < 1e-4, "{one} {other}: {number} {expected}");
                }
            }
        });
    }
}
