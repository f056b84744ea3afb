//! The planners under test: of a double-S, of a trapezoid and of a `Move`. The judge sees every plan as phases.

use super::{Problem, Request};
use support::prelude::*;
use support::profiles::{bell, bell_fields, trap, trap_fields};
use support::{Family, Implementation, Ours};

pub trait Planner<R> {
    fn plan(&self, problem: &Problem<R>) -> Result<Plan<R>, Error>; // the planned motion

    /// Whether bad problems are made simple before they are shown, which takes long.
    fn is_worth_simple_examples(&self) -> bool {
        false
    }
}

#[derive(Clone, Copy)]
pub struct Plan<R> {
    pub planned: Move<R>,            // its phases
    pub profile: Option<Profile<R>>, // the struct of liba that holds them, if it is not a `Move`
    pub findings: Findings,          // what the planner found, or what `check` finds in a profile
}

#[derive(Clone, Copy)]
pub struct Profile<R> {
    pub family: Family, // the double-S or the trapezoid
    fields: [R; 14],
}

impl<R: Real> Profile<R> {
    pub fn new(family: Family, own: &[R]) -> Self {
        let mut fields = [R::ZERO; 14];
        fields[..own.len()].copy_from_slice(own);
        Self { family, fields }
    }

    pub fn fields(&mut self) -> &mut [R] {
        &mut self.fields[..self.family.fields().len()]
    }

    pub fn evaluate(&self, implementation: &impl Implementation<R>, x: R) -> [R; 4] {
        implementation.evaluate(self.family, &self.fields[..self.family.fields().len()], x)
    }

    /// What `check` finds; a number that is not finite counts as a jump.
    pub fn check(&self, problem: &Problem<R>) -> Findings {
        let [x, y, z, ..] = problem.arguments();
        let found = match self.family {
            Family::Bell => bell(&self.fields).check(x, y, z),
            _ => trap(&self.fields[..12]).check(x, y, z),
        };
        found.unwrap_or(Findings::JUMPS)
    }

    /// Start, duration, acceleration at the start, and jerk of each phase. Rounding may make neighbouring starts cross.
    fn phases(&self) -> Vec<[R; 4]> {
        let zero = R::ZERO;
        if self.family == Family::Trap {
            let Trap { t, ta, cruise_end: td, a0: ac, a1: de, .. } = trap(&self.fields[..12]);
            return vec![
                [zero, ta, ac, zero],
                [ta, td - ta, zero, zero],
                [td, t - td, de, zero],
                [t, zero, zero, zero],
            ];
        }
        let Bell { t, tv, ta, td, taj, tdj, p0, p1, jm, .. } = bell(&self.fields);
        let jerk = if p0 > p1 { -jm } else { jm };
        let (peak, trough) = (jerk * taj, -(jerk * tdj));
        vec![
            [zero, taj, zero, jerk],
            [taj, ta - taj - taj, peak, zero],
            [ta - taj, taj, peak, -jerk],
            [ta, tv, zero, zero],
            [ta + tv, tdj, zero, -jerk],
            [t - td + tdj, td - tdj - tdj, trough, zero],
            [t - tdj, tdj, trough, jerk],
            [t, zero, zero, zero],
        ]
    }
}

impl<R: Real> Plan<R> {
    pub fn of_move(planned: Move<R>, findings: Findings) -> Self {
        Self { planned, profile: None, findings }
    }

    pub fn of_profile(problem: &Problem<R>, profile: Profile<R>) -> Self {
        let phases = profile.phases();
        let mut planned = Move { t: profile.fields[0], count: phases.len() as u32 - 1, ..Move::default() };
        let mut begin = R::ZERO;
        for (phase, [t, duration, acceleration, jerk]) in planned.phase.iter_mut().zip(phases) {
            begin = if t < begin { begin } else { t };
            let [position, velocity, ..] = profile.evaluate(&Ours, begin);
            let duration = if duration < R::ZERO { R::ZERO } else { duration };
            *phase = Phase { start: begin, duration, position, velocity, acceleration, jerk };
        }
        Self { planned, profile: Some(profile), findings: profile.check(problem) }
    }

    pub fn state(&self, x: R) -> [R; 4] {
        match &self.profile {
            Some(profile) => profile.evaluate(&Ours, x),
            None => self.planned.state(x),
        }
    }
}

pub struct Fastest;

impl<R: Real> Planner<R> for Fastest {
    fn plan(&self, problem: &Problem<R>) -> Result<Plan<R>, Error> {
        let &Problem { ref limits, from, to, .. } = problem;
        let mut planned = Move::default();
        let findings = match problem.request {
            Request::Plan => planned.plan(limits, from, to),
            Request::Reach => planned.reach(limits, from, to.velocity, to.acceleration),
            Request::Stop => planned.stop(limits, from),
            Request::Meet => planned.meet(limits, from, to),
            Request::Bell | Request::Trap => {
                return Ok(Plan::of_profile(problem, fastest(problem).ok_or(Error::NotFinite)?));
            }
        }?;
        Ok(Plan::of_move(planned, findings))
    }

    fn is_worth_simple_examples(&self) -> bool {
        true
    }
}

fn fastest<R: Real>(problem: &Problem<R>) -> Option<Profile<R>> {
    let [x, y, z, p0, p1, v0, v1] = problem.arguments();
    let boundary = Boundary { p0, p1, v0, v1 };
    Some(if problem.request == Request::Bell {
        Profile::new(Family::Bell, &bell_fields(&Bell::fastest(x, y, z, boundary).ok()?))
    } else {
        Profile::new(Family::Trap, &trap_fields(&Trap::fastest(x, y, z, boundary).ok()?))
    })
}
