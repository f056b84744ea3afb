//! What the steps make small: the sum of the durations, less `mu` times the weighted logarithms of all slacks.
//!
//! `docs/path.md` has the theory, in "The barrier".

use super::border::{Border, Derivatives, Farthest};
use super::chain::Chain;
use crate::real::Real;

/// Derivatives of terms of the barrier in the states and the duration of one section.
struct Terms<R> {
    derivatives: Derivatives<R>,
    /// The part of the second derivative by the duration that is never negative.
    damping: R,
}

impl<R: Real> Terms<R> {
    fn none() -> Self {
        Self {
            derivatives: Derivatives {
                first: [R::ZERO; 5],
                second: [R::ZERO; 15],
            },
            damping: R::ZERO,
        }
    }

    /// Adds `-mu` times the logarithm of the slack.
    fn add(&mut self, border: &Border<R>, farthest: &Farthest<R>, mu: R) {
        let Derivatives { first, second } = border.derivatives(farthest);
        let per = R::ONE / farthest.slack;
        let first = first.map(|x| x * per);
        let sums = &mut self.derivatives;
        let mut entries = sums.second.iter_mut().zip(&second);
        for (k, (sum, x)) in sums.first.iter_mut().zip(&first).enumerate() {
            *sum = *sum - mu * *x;
            let row = entries.by_ref().zip(first.iter().take(k + 1));
            for ((sum, second), y) in row {
                *sum = *sum + mu * (*x * *y - *second * per);
            }
        }
        let [.., t] = first;
        self.damping = self.damping + mu * t * t;
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
        let [before, behind] = [point - 1, point].map(|section| self.memory.weights.at(section));
        before.at_most(behind)
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
        let ends = [section, section + 1].map(|point| self.at(point, axis));
        let duration = self.memory.durations.at(section);
        let mu = mu * self.memory.weights.at(section);
        let limits = self.limits(section, axis).ok()?;
        let borders = self.borders(limits, (section, axis), ends, duration);
        let mut terms = Terms::none();
        let mut slacks = [R::ZERO; 2];
        for (border, slack) in borders.iter().zip(&mut slacks) {
            let farthest = border.farthest()?;
            *slack = farthest.slack;
            terms.add(border, &farthest, mu);
        }
        let Terms {
            derivatives: Derivatives { first, second },
            damping,
        } = &terms;
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
        memory.damping.add(section, [*damping]);
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
        self.memory.products.put(row, bounds.product(state)?);
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
        let mut logarithms = R::ZERO;
        for axis in 0..self.axes {
            let mut start = self.moved(0, axis, part);
            for section in 0..self.sections {
                let point = section + 1;
                let end = self.moved(point, axis, part);
                let piece = section * self.axes + axis;
                if point < self.sections {
                    let product = self.bounds(point, axis).product(end)?;
                    let ratio = product / self.memory.products.at(piece);
                    logarithms = logarithms + self.weight_of_point(point) * ratio.ln();
                }
                let tried = self.memory.tried.at(section);
                let [upper, lower] = self.slacks(section, axis, [start, end], tried)?;
                let [was_upper, was_lower] = self.memory.slacks.row(piece);
                let ratio = (upper / was_upper) * (lower / was_lower);
                logarithms = logarithms + self.memory.weights.at(section) * ratio.ln();
                start = end;
            }
        }
        Some(change - mu * logarithms)
    }
}
