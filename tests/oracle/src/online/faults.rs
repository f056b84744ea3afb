//! Faults planted into the planner of moves from any state to any state, each as small as a fault can be. They show whether the judge
//! sees a fault.

use super::judge::{Fastest, Plan, Planner, Scale, mirrored};
use super::problems::{Problem, Wish};
use atraj::Findings;
use atraj::online::{Error, Limits, Move, Phase, State};
use support::Real;

/// The planner with one fault.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fault {
    /// It refuses a start outside the limits.
    Refuses,
    /// A correct motion within limits that are a little too low.
    Lengthened,
    /// A correct motion that stops first.
    Detour,
    /// The move turns to the wrong side.
    WrongSide,
    /// The times are a little too short.
    Shortened,
    /// The velocity is a little above its limit.
    VelocityAboveTheLimit,
    /// The acceleration is a little above its limit.
    AccelerationAboveTheLimit,
    /// The jerk is a little above its limit.
    JerkAboveTheLimit,
    /// The move ends a representable number beside the target.
    EndOff,
    /// The final velocity is a representable number off.
    EndVelocityOff,
    /// The position jumps 100 roundings.
    Jump,
    /// The velocity jumps 100 roundings.
    VelocityJump,
    /// The shortest phase is missing.
    DroppedPhase,
    /// A move towards smaller positions takes a rounding longer.
    Direction,
    /// The move takes a little time more, whatever the units are.
    AbsoluteTime,
    /// It does not say that the move leaves the positions between its ends.
    SilentOvershoot,
    /// It does not say that the start is outside.
    SilentStart,
}

impl Fault {
    /// Every fault.
    pub const ALL: [Self; 17] = [
        Self::Refuses,
        Self::Lengthened,
        Self::Detour,
        Self::WrongSide,
        Self::Shortened,
        Self::VelocityAboveTheLimit,
        Self::AccelerationAboveTheLimit,
        Self::JerkAboveTheLimit,
        Self::EndOff,
        Self::EndVelocityOff,
        Self::Jump,
        Self::VelocityJump,
        Self::DroppedPhase,
        Self::Direction,
        Self::AbsoluteTime,
        Self::SilentOvershoot,
        Self::SilentStart,
    ];

    /// The limits within which the planner plans.
    fn change_limits<R: Real>(self, limits: &mut Limits<R>) {
        let wide = size_of::<R>() == 8;
        let less = R::of(1.0 - if wide { 4e-8 } else { 4e-4 });
        let more = R::of(1.0 + if wide { 1e-9 } else { 1e-4 });
        let Limits {
            vmax,
            vmin,
            amax,
            amin,
            jmax,
            jmin,
        } = limits;
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

    /// What becomes of a correct plan.
    fn change_plan<R: Real>(self, problem: &Problem<R>, plan: &mut Plan<R>) {
        let (planned, findings) = plan;
        let scale = Scale::of(&problem.limits, problem.from, planned);
        let off = |scale: f64| R::of(100.0 * R::MACHINE_EPSILON.widen() * scale);
        let count = planned.phases as usize;
        let middle = count / 2;
        let end = &mut planned.phase[count];
        match self {
            Self::Shortened => {
                let less = 1.0 - if size_of::<R>() == 8 { 1e-8 } else { 1e-4 };
                stretch(planned, |t| t * less);
            }
            Self::EndOff => end.position = end.position.neighbour(1),
            Self::EndVelocityOff => end.velocity = end.velocity + off(scale.velocity),
            Self::Jump if count > 1 => {
                let phase = &mut planned.phase[middle];
                phase.position = phase.position + off(scale.position);
            }
            Self::VelocityJump if count > 1 => {
                let phase = &mut planned.phase[middle];
                phase.velocity = phase.velocity + off(scale.velocity);
            }
            Self::DroppedPhase if count > 1 => drop_shortest(planned),
            Self::Direction if problem.to.position < problem.from.position => {
                planned.t = planned.t.neighbour(1);
                planned.phase[count].t = planned.t;
            }
            Self::AbsoluteTime => {
                planned.t = planned.t + R::of(8.0) * R::MACHINE_EPSILON;
                planned.phase[count].t = planned.t;
            }
            Self::SilentOvershoot => *findings = without(*findings, Findings::OVERSHOOTS),
            Self::SilentStart => *findings = without(*findings, Findings::STARTS_OUTSIDE),
            _ => {}
        }
    }
}

/// The findings but for one.
fn without(findings: Findings, one: Findings) -> Findings {
    let others = [Findings::OVERSHOOTS, Findings::STARTS_OUTSIDE];
    let kept = others
        .into_iter()
        .filter(|other| *other != one && findings.bits() & other.bits() != 0);
    kept.fold(Findings::default(), |all, other| all | other)
}

/// Changes all times.
fn stretch<R: Real>(planned: &mut Move<R>, by: impl Fn(f64) -> f64) {
    let change = |t: &mut R| *t = R::of(by(t.widen()));
    for phase in &mut planned.phase {
        change(&mut phase.t);
        change(&mut phase.duration);
    }
    change(&mut planned.t);
}

/// Leaves the shortest phase out; the phases behind it are earlier.
fn drop_shortest<R: Real>(planned: &mut Move<R>) {
    let count = planned.phases as usize;
    let phases = &mut planned.phase[..=count];
    let shorter = |a: &usize, b: &usize| {
        let [a, b] = [a, b].map(|index| phases[*index].duration.widen());
        a.total_cmp(&b)
    };
    let shortest = (0..count).min_by(shorter).expect("phases");
    phases.copy_within(shortest + 1.., shortest);
    let mut t = R::of(0.0);
    for phase in &mut phases[..count] {
        phase.t = t;
        t = t + phase.duration;
    }
    planned.t = phases[count - 1].t;
    planned.phases -= 1;
}

/// Stops, and goes from there to the target.
fn detour<R: Real>(problem: &Problem<R>) -> Result<Plan<R>, Error> {
    let mut stop = Move::default();
    let found = stop.stop(&problem.limits, problem.from)?;
    let from = stop.state_at(stop.t);
    let (rest, findings) = Fastest.plan(&Problem { from, ..*problem })?;
    let (first, second) = (stop.phases as usize, rest.phases as usize);
    if first + second > 15 {
        return Fastest.plan(problem);
    }
    let mut both = stop;
    for (index, phase) in rest.phase[..=second].iter().enumerate() {
        let t = stop.t + phase.t;
        both.phase[first + index] = Phase { t, ..*phase };
    }
    both.phases = (first + second) as u32;
    both.t = both.phase[first + second].t;
    Ok((both, found | findings))
}

impl<R: Real> Planner<R> for Fault {
    fn plan(&self, problem: &Problem<R>) -> Result<Plan<R>, Error> {
        let mut changed = *problem;
        self.change_limits(&mut changed.limits);
        if *self == Self::Detour && problem.wish == Wish::Plan {
            return detour(problem);
        }
        if *self == Self::WrongSide && problem.wish == Wish::Plan {
            let other = mirrored(&changed);
            let displacement = problem.to.position - problem.from.position;
            changed.to.position = problem.from.position - displacement;
            changed.to.velocity = other.to.velocity;
        }
        let mut plan = Fastest.plan(&changed)?;
        if *self == Self::WrongSide && problem.wish == Wish::Plan {
            let State {
                position, velocity, ..
            } = problem.to;
            let end = &mut plan.0.phase[plan.0.phases as usize];
            (end.position, end.velocity) = (position, velocity);
        }
        let outside = plan.1.bits() & Findings::STARTS_OUTSIDE.bits() != 0;
        if *self == Self::Refuses && outside {
            return Err(Error::Limits);
        }
        self.change_plan(problem, &mut plan);
        Ok(plan)
    }
}
