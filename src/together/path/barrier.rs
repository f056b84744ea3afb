//! What the steps make small: the sum of the durations, less `mu` times the weighted logarithms of all slacks.
//!
//! `docs/path.md` has the theory, in "The barrier".

use super::border::{Farthest, Gradient, Hessian};
use super::chain::Chain;
use crate::real::Real;

/// Gradient and Hessian of a term of the barrier in the states and the duration of one section.
struct Term<R> {
    gradient: Gradient<R>,
    hessian: Hessian<R>,
    /// The part of the second derivative by the duration that is never negative.
    damping: R,
}

impl<R: Real> Term<R> {
    /// `-mu` times the logarithm of a slack.
    fn of(farthest: &Farthest<R>, mu: R) -> Self {
        let (g, h) = (farthest.gradient(), farthest.hessian());
        let per = R::ONE / farthest.slack;
        let [v0, a0] = g.start.map(|x| x * per);
        let [v1, a1] = g.end.map(|x| x * per);
        let t = g.t * per;
        let second = |product: R, second: R| mu * (product - second * per);
        let [s_vv, s_va, s_aa] = h.start;
        let [e_vv, e_va, e_aa] = h.end;
        let [vv, va, av, aa] = h.cross;
        Self {
            gradient: Gradient {
                start: [-mu * v0, -mu * a0],
                end: [-mu * v1, -mu * a1],
                t: -mu * t,
            },
            hessian: Hessian {
                start: [
                    second(v0 * v0, s_vv),
                    second(v0 * a0, s_va),
                    second(a0 * a0, s_aa),
                ],
                end: [
                    second(v1 * v1, e_vv),
                    second(v1 * a1, e_va),
                    second(a1 * a1, e_aa),
                ],
                cross: [
                    second(v0 * v1, vv),
                    second(v0 * a1, va),
                    second(a0 * v1, av),
                    second(a0 * a1, aa),
                ],
                start_t: [second(v0 * t, h.start_t[0]), second(a0 * t, h.start_t[1])],
                end_t: [second(v1 * t, h.end_t[0]), second(a1 * t, h.end_t[1])],
                t: second(t * t, h.t),
            },
            damping: mu * t * t,
        }
    }

    /// The sum with a term of the mirrored axis.
    fn with_mirrored(self, other: Self) -> Self {
        fn sum<R: Real, const N: usize>(mut x: [R; N], y: [R; N]) -> [R; N] {
            for (x, y) in x.iter_mut().zip(y) {
                *x = *x + y;
            }
            x
        }
        let (g, h) = (self.gradient, self.hessian);
        let (g1, h1) = (other.gradient, other.hessian);
        Self {
            gradient: Gradient {
                start: sum(g.start, g1.start.map(R::neg)),
                end: sum(g.end, g1.end.map(R::neg)),
                t: g.t + g1.t,
            },
            hessian: Hessian {
                start: sum(h.start, h1.start),
                end: sum(h.end, h1.end),
                cross: sum(h.cross, h1.cross),
                start_t: sum(h.start_t, h1.start_t.map(R::neg)),
                end_t: sum(h.end_t, h1.end_t.map(R::neg)),
                t: h.t + h1.t,
            },
            damping: self.damping + other.damping,
        }
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
        self.memory.diagonal.clear();
        self.memory.gradient.clear();
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
        let [upper, lower] = self.borders(section, axis, ends, duration)?;
        let mu = mu * self.memory.weights.at(section);
        let term = Term::of(&upper, mu).with_mirrored(Term::of(&lower, mu));
        let Term {
            gradient,
            hessian,
            damping,
        } = term;
        let piece = section * self.axes + axis;
        let memory = &mut self.memory;
        memory.slacks.set(piece, [upper.slack, lower.slack]);
        memory.gradient_t.add(section, [gradient.t]);
        memory.matrix.add(section, section, hessian.t);
        memory.damping.add(section, [damping]);
        let [[v0, a0], [v1, a1]] = [hessian.start_t, hessian.end_t];
        memory.to_duration.set(piece, [v0, a0, v1, a1]);
        // Way point `k` has the row before that of section `k`.
        if let Some(start) = piece.checked_sub(self.axes) {
            memory.gradient.add(start, gradient.start);
            memory.diagonal.add(start, hessian.start);
            memory.coupling.set(start, hessian.cross);
        }
        if section + 1 < self.sections {
            memory.gradient.add(piece, gradient.end);
            memory.diagonal.add(piece, hessian.end);
        }
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
                let [upper, lower] = self.borders(section, axis, [start, end], tried)?;
                let [was_upper, was_lower] = self.memory.slacks.row(piece);
                let ratio = (upper.slack / was_upper) * (lower.slack / was_lower);
                logarithms = logarithms + self.memory.weights.at(section) * ratio.ln();
                start = end;
            }
        }
        Some(change - mu * logarithms)
    }
}
