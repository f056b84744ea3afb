//! Faults planted into the planners, each as small as a fault can be. They show whether the judge sees a fault.

use super::{Fastest, OF_A_MOVE, Plan, Planner, Problem, Profile, Request, Scale};
use support::Family;
use support::prelude::*;

listed! {
    pub enum Fault {
        Refuses, // it refuses a start outside the limits, or a profile without displacement
        Lengthened, // a correct motion within limits that are a little too low
        Detour, // a correct motion that stops first
        WrongSide, // the move turns to the wrong side
        Shortened, // the times are a little too short
        VelocityAboveTheLimit, // the velocity is a little above its limit
        AccelerationAboveTheLimit, // the acceleration is a little above its limit
        JerkAboveTheLimit, // the jerk is a little above its limit
        EndOff, // the move ends a representable number off the target
        EndVelocityOff, // the final velocity is a representable number off
        Jump, // the position jumps 100 ulps
        VelocityJump, // the velocity jumps 100 ulps
        DroppedPhase, // the shortest phase is missing
        Direction, // a move towards smaller positions takes a rounding longer
        AbsoluteTime, // the move takes a little time more, whatever the units are
        SilentOvershoot, // it does not say that the move leaves the positions between its ends
        SilentStart, // it does not say that the start is outside
        SilentEnd, // it does not say that the axis will unavoidably exceed its limits afterwards
    }
}

impl Fault {
    fn change_limits<R: Real>(self, limits: &mut Limits<R>) {
        let wide = size_of::<R>() == 8;
        let less = R::of(1.0 - if wide { 4e-8 } else { 4e-4 });
        let more = R::of(1.0 + if wide { 1e-9 } else { 1e-4 });
        let Limits { vmax, vmin, amax, amin, jmax, jmin } = limits;
        let (changed, factor) = match self {
            Self::Lengthened => (vec![vmax, vmin, amax, amin, jmax, jmin], less),
            Self::VelocityAboveTheLimit => (vec![vmax, vmin], more),
            Self::AccelerationAboveTheLimit => (vec![amax, amin], more),
            Self::JerkAboveTheLimit => (vec![jmax, jmin], more),
            _ => return,
        };
        for limit in changed {
            *limit = *limit * factor;
        }
    }

    pub fn is_possible_in(self, request: Request) -> bool {
        match self {
            Self::Detour | Self::DroppedPhase | Self::SilentOvershoot | Self::SilentStart | Self::SilentEnd => {
                request.profile().is_none()
            }
            Self::JerkAboveTheLimit => request != Request::Trap,
            _ => true,
        }
    }

    fn change_plan<R: Real>(self, problem: &Problem<R>, plan: &mut Plan<R>) {
        let scale = Scale::of(problem, plan);
        if let Some(mut profile) = plan.profile {
            self.change_profile(problem, &mut profile, &scale);
            *plan = Plan::of_profile(problem, profile);
            return;
        }
        let Plan { planned, findings, .. } = plan;
        let count = planned.count as usize;
        let middle = count / 2;
        let end = &mut planned.phase[count];
        match self {
            Self::Shortened => stretch(planned, shortened),
            Self::EndOff => end.position = end.position.neighbour(1),
            Self::EndVelocityOff => shift(&mut end.velocity, scale.velocity),
            Self::Jump if count > 1 => shift(&mut planned.phase[middle].position, scale.position),
            Self::VelocityJump if count > 1 => shift(&mut planned.phase[middle].velocity, scale.velocity),
            Self::DroppedPhase if count > 1 => drop_shortest(planned),
            Self::Direction | Self::AbsoluteTime => {
                planned.t = self.late(problem, planned.t);
                planned.phase[count].start = planned.t;
            }
            Self::SilentOvershoot => *findings = without(*findings, Findings::OVERSHOOTS),
            Self::SilentStart => *findings = without(*findings, Findings::STARTS_OUTSIDE),
            Self::SilentEnd => *findings = without(*findings, Findings::ENDS_LEAVING),
            _ => {}
        }
    }

    fn change_profile<R: Real>(self, problem: &Problem<R>, profile: &mut Profile<R>, scale: &Scale) {
        // `first` is where a part of the move begins that is not measured from its end.
        let (p1, v1, highest, directed, first) = match profile.family {
            Family::Bell => (7, 9, 10, 10..14, 6),
            _ => (2, 4, 5, 10..12, 9),
        };
        let fields = profile.fields();
        match self {
            Self::WrongSide => fields[directed].iter_mut().for_each(|x| *x = -*x),
            Self::Shortened => fields[0] = shortened(fields[0]),
            Self::EndOff => fields[p1] = fields[p1].neighbour(1),
            Self::EndVelocityOff => shift(&mut fields[v1], scale.velocity),
            Self::Jump => shift(&mut fields[first], scale.position),
            Self::VelocityJump => shift(&mut fields[highest], scale.velocity),
            Self::Direction | Self::AbsoluteTime => fields[0] = self.late(problem, fields[0]),
            _ => {}
        }
    }

    fn late<R: Real>(self, problem: &Problem<R>, t: R) -> R {
        match self {
            Self::Direction if problem.to.position < problem.from.position => t.neighbour(1),
            Self::AbsoluteTime => t + R::of(8.0) * R::MACHINE_EPSILON,
            _ => t,
        }
    }
}

/// Adds 100 ulps of a number of this size.
fn shift<R: Real>(x: &mut R, size: f64) {
    *x = *x + R::of(100.0 * R::MACHINE_EPSILON.widen() * size);
}

fn shortened<R: Real>(t: R) -> R {
    R::of(t.widen() * (1.0 - if size_of::<R>() == 8 { 1e-8 } else { 1e-4 }))
}

fn without(findings: Findings, one: Findings) -> Findings {
    let kept = OF_A_MOVE.into_iter().filter(|other| *other != one && findings.bits() & other.bits() != 0);
    kept.fold(Findings::default(), |all, other| all | other)
}

fn stretch<R: Real>(planned: &mut Move<R>, by: impl Fn(R) -> R) {
    for phase in &mut planned.phase {
        (phase.start, phase.duration) = (by(phase.start), by(phase.duration));
    }
    planned.t = by(planned.t);
}

fn drop_shortest<R: Real>(planned: &mut Move<R>) {
    let count = planned.count as usize;
    let phases = &mut planned.phase[..=count];
    let duration = |index: &usize| phases[*index].duration.widen();
    let shortest = (0..count).min_by(|a, b| duration(a).total_cmp(&duration(b))).expect("phases");
    phases.copy_within(shortest + 1.., shortest);
    let mut t = R::ZERO;
    for phase in &mut phases[..count] {
        phase.start = t;
        t = t + phase.duration;
    }
    planned.t = phases[count - 1].start;
    planned.count -= 1;
}

fn detour<R: Real>(problem: &Problem<R>) -> Result<Plan<R>, Error> {
    let mut stop = Move::default();
    let found = stop.stop(&problem.limits, problem.from)?;
    let rest = Fastest.plan(&Problem { from: stop.state_at(stop.t), ..*problem })?;
    let (first, second) = (stop.count as usize, rest.planned.count as usize);
    if first + second > 15 {
        return Fastest.plan(problem);
    }
    let mut both = stop;
    for (index, phase) in rest.planned.phase[..=second].iter().enumerate() {
        both.phase[first + index] = Phase { start: stop.t + phase.start, ..*phase };
    }
    both.count = (first + second) as u32;
    both.t = both.phase[first + second].start;
    Ok(Plan::of_move(both, found | rest.findings))
}

/// Goes as far to the other side. Its end is the target all the same.
fn wrong_side<R: Real>(problem: &Problem<R>) -> Result<Plan<R>, Error> {
    let mut changed = *problem;
    let to = problem.to;
    changed.to.position = problem.from.position - (to.position - problem.from.position);
    changed.to.velocity = -to.velocity;
    let mut plan = Fastest.plan(&changed)?;
    let end = &mut plan.planned.phase[plan.planned.count as usize];
    (end.position, end.velocity) = (to.position, to.velocity);
    Ok(plan)
}

impl<R: Real> Planner<R> for Fault {
    fn plan(&self, problem: &Problem<R>) -> Result<Plan<R>, Error> {
        let mut changed = *problem;
        self.change_limits(&mut changed.limits);
        match self {
            Self::Detour if problem.request == Request::Plan => return detour(problem),
            Self::WrongSide if problem.request == Request::Plan => return wrong_side(problem),
            _ => {}
        }
        let mut plan = Fastest.plan(&changed)?;
        let outside = plan.findings.bits() & Findings::STARTS_OUTSIDE.bits() != 0;
        let still = plan.profile.is_some() && problem.from.position == problem.to.position;
        if *self == Self::Refuses && (outside || still) {
            return Err(Error::Limits);
        }
        self.change_plan(problem, &mut plan);
        Ok(plan)
    }
}
