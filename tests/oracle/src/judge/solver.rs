//! The reference solver, which is in C because Rust has no `long double`: `c/solver.c`.

use super::{Problem, Request, parts, widened};
use support::prelude::*;

#[derive(Clone, Copy, Debug)]
pub struct Motion {
    pub limits: [f64; 6],
    pub start: [f64; 3],
    pub target: [f64; 3],
    pub frame: f64, // velocity of the frame in which the target has to be reached at the end's velocity
}

#[derive(Clone, Copy, Debug, Default)]
#[repr(C)]
pub struct Best {
    pub duration: f64,  // the least duration
    pub speed: f64,     // the highest speed of the fastest motion
    pub variation: f64, // the sum of the magnitudes of all changes of its velocity
    /// Its highest acceleration times how long the acceleration changes. A rounding of the acceleration changes the velocity by so many.
    pub changing: f64,
    pub inside: f64,        // how long the recovery lasts
    pub direct: f64,        // the duration with the direct ramp. From here on the end can be reached.
    pub gap_begins: f64,    // from here on the end can not be reached; infinite if there is no such gap
    pub gap_ends: f64,      // from here on the end can be reached again
    pub past_direct: f64,   // how much further than the end of the direct ramp the target is
    pub past_begin: f64,    // how much further than the displacement where the gap begins
    pub past_end: f64,      // how much further than the displacement where the gap ends
    pub straight: f64,      // the duration in which the acceleration goes straight from one end to the other
    pub past_straight: f64, // how much further than the end of the straight change the target is
    pub faster: f64,        // how much faster than the end of the straight change the target is
    /// The largest relative error of the motion that was found: of its end, of its limits, of its phases.
    pub wrong: f64,
}

/// When the reference solver looks at the border: first this part of its beginning later, then always this factor later.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct Grid {
    part: f64,
    factor: f64,
}

impl Grid {
    /// Enough where the displacement falls at first or not at all, and then rises: without acceleration at the target, from inside the limits.
    const SPARSE: Self = Self { part: 1.0, factor: 4.0 };
    /// Enough for most problems: twice an octave.
    pub const COARSE: Self = Self { part: 1.0 / 262_144.0, factor: std::f64::consts::SQRT_2 };
    /// Enough where the displacement rises and falls at once: 64 times an octave.
    pub const FINE: Self = Self { part: 1.0 / 262_144.0, factor: 1.010_889_286_051_700_5 };
}

/// Position, velocity and acceleration where the phases of a move meet, and at its end.
pub type Borders = [[f64; 3]; 17];
pub type Knot = [f64; 4]; // time, position, velocity and acceleration

pub struct Walk {
    /// The states at the start of each phase, before the acceleration of the phase, and at the end.
    pub borders: Borders,
    /// In order of time: these states, once more with the acceleration of the phase, the highest and the lowest velocities, and where the axis turns.
    pub knots: Vec<Knot>,
}

unsafe extern "C" {
    safe fn solver_fastest(
        limits: &[f64; 6], start: &[f64; 3], target: &[f64; 3], offset: &[f64; 3], frame: f64, grid: &Grid,
        results: &mut Best,
    );
    safe fn solver_possible(
        limits: &[f64; 6], start: &[f64; 3], target: &[f64; 3], offset: &[f64; 3], duration: f64,
    ) -> f64;
    safe fn solver_interval(
        limits: &[f64; 6], start: &[f64; 3], target: &[f64; 3], duration: f64, interval: &mut [f64; 2],
    ) -> i32;
    safe fn solver_knees(
        limits: &[f64; 6], start: &[f64; 3], target: &[f64; 3], lower: i32, knees: &mut [f64; 8],
    ) -> i32;
    safe fn solver_derivatives(
        limits: &[f64; 6], start: &[f64; 3], target: &[f64; 3], duration: f64, lower: i32, first: &mut [f64; 5],
        second: &mut [f64; 15],
    ) -> i32;
    safe fn solver_walk(
        start: &[f64; 3], phases: &[[f64; 3]; 17], count: i32, borders: &mut Borders, knots: &mut [Knot; 96],
    ) -> i32;
}

impl Motion {
    pub fn of<R: Real>(problem: &Problem<R>) -> Self {
        let [start, mut target] = problem.ends().map(|end| parts(end).map(R::widen));
        let mut frame = 0.0;
        match problem.request {
            Request::Stop => target = [0.0; 3],
            Request::Meet => frame = target[1],
            _ => {}
        }
        Self { limits: widened(&problem.limits), start, target, frame }
    }

    pub fn best(&self) -> Best {
        self.best_at([0.0; 3], Grid::COARSE)
    }

    /// The fastest motion to a target that is so much further and so much faster, from a start that is so much faster.
    pub fn best_at(&self, offset: [f64; 3], grid: Grid) -> Best {
        let mut best = Best::default();
        let [_, v0, a0] = self.start;
        let [vmax, vmin, ..] = self.limits;
        let comes_inside = v0 > vmax || v0 < vmin; // a start beyond a velocity recovers with an acceleration
        let is_accelerated = a0 != 0.0 || self.target[2] != 0.0 || comes_inside;
        let grid = if is_accelerated { grid } else { Grid::SPARSE };
        solver_fastest(&self.limits, &self.start, &self.target, &offset, self.frame, &grid, &mut best);
        best
    }

    /// How much further the target is than the displacements of this duration: 0 if it is among them, infinite if the end cannot be reached
    /// in this duration. The target is so much further and so much faster, and the start is so much faster.
    pub fn lacks(&self, duration: f64, offset: [f64; 3]) -> f64 {
        solver_possible(&self.limits, &self.start, &self.target, &offset, duration)
    }

    pub fn possible(&self, duration: f64) -> bool {
        self.lacks(duration, [0.0; 3]) == 0.0
    }

    /// The lowest and the highest displacement of this duration, if the end can be reached in it.
    pub fn interval(&self, duration: f64) -> Option<[f64; 2]> {
        let mut interval = [0.0; 2];
        let exists = solver_interval(&self.limits, &self.start, &self.target, duration, &mut interval);
        (exists != 0).then_some(interval)
    }

    /// The shape of the upper or the lower border at this duration, with the derivatives of its distance from the start: by velocity and acceleration
    /// at the start, at the end, and by the duration; then by two of them, row by row up to the diagonal. `None` near a change of shape.
    pub fn derivatives(&self, duration: f64, lower: bool) -> Option<(usize, [f64; 5], [f64; 15])> {
        let (mut first, mut second) = ([0.0; 5], [0.0; 15]);
        let Self { limits, start, target, .. } = self;
        let shape = solver_derivatives(limits, start, target, duration, i32::from(lower), &mut first, &mut second);
        Some((usize::try_from(shape).ok()?, first, second))
    }

    pub fn knees(&self, lower: bool) -> Vec<f64> {
        let mut knees = [0.0; 8];
        let count = solver_knees(&self.limits, &self.start, &self.target, lower.into(), &mut knees);
        knees[..count as usize].to_vec()
    }
}

impl Walk {
    pub fn of<R: Real>(from: State<R>, planned: &Move<R>) -> Self {
        let phases = planned.phase.map(|phase| [phase.duration, phase.acceleration, phase.jerk].map(R::widen));
        let mut all = [[0.0; 3]; 17];
        all[..16].copy_from_slice(&phases);
        let start = parts(from).map(R::widen);
        let mut borders = [[0.0; 3]; 17];
        let mut knots = [[0.0; 4]; 96];
        let noted = solver_walk(&start, &all, (planned.count as i32).min(15), &mut borders, &mut knots);
        Self { borders, knots: knots[..noted as usize].to_vec() }
    }
}
