//! Faults planted into the planner of several axes. They show whether the judge sees a fault.

use super::Set;
use super::several::{Planner, Together};
use support::online::tried;
use support::prelude::*;

listed! {
    pub enum Fault {
        Refuses, // it refuses sets of many axes
        Alone, // the last axis makes its fastest move
        Late, // the duration is twice the least one
        OffTheClock, // the duration is a little longer than demanded, and no tick
        TooShort, // it plans for a little less than the demanded duration
        /// The first axis moves for as long, but the end of its last axis is a representable number off the target.
        EndOff,
        Waits, // a stretched axis stands still and then makes its fastest move
        WideLimits, // the limits of the last axis are a little wider
        OneLate, // the last axis ends a representable number later
        Silent, // it finds nothing
        OffTheLine, // on the line, the last axis is a little off it
        ShiftedTooFar, // it arrives a tick too early: an axis that misses the tick is shifted by more than its roundings
    }
}

impl Fault {
    fn changed<R: Real>(self, set: &Set<R>, least: R) -> Set<R> {
        let mut changed = set.clone();
        let little = if size_of::<R>() == 8 { 1e-6 } else { 1e-3 };
        match self {
            Self::Late => changed.duration = R::of(2.0) * least,
            Self::OffTheClock => {
                changed.cycle = R::ZERO;
                changed.duration = least * R::of(1.0 + little);
            }
            Self::TooShort => changed.duration = set.duration * R::of(1.0 - little),
            Self::WideLimits => {
                let Limits { vmax, vmin, jmax, jmin, .. } = &mut changed.axes.last_mut().expect("an axis").limits;
                for limit in [vmax, vmin, jmax, jmin] {
                    *limit = *limit * R::of(1.0 + little);
                }
            }
            _ => {}
        }
        changed
    }

    fn spoil<R: Real>(self, set: &Set<R>, axes: &mut [Move<R>]) {
        let Some((axis, problem)) = axes.last_mut().zip(set.axes.last()) else { return };
        let count = axis.count as usize;
        match self {
            Self::Alone => {
                let _ = axis.plan(&problem.limits, problem.from, problem.to);
            }
            Self::EndOff => axis.phase[count].position = axis.phase[count].position.neighbour(1),
            Self::OneLate => {
                axis.t = axis.t.neighbour(1);
                axis.phase[count].start = axis.t;
            }
            Self::Waits if problem.from == State::at(problem.from.position) => {
                let Ok((fastest, _)) = tried(&problem.limits, problem.from, problem.to) else { return };
                if fastest.t < axis.t && fastest.count < 15 {
                    *axis = after(&fastest, axis.t - fastest.t, axis.t, problem.from);
                }
            }
            Self::OffTheLine => {
                let little = R::of(1e4) * R::MACHINE_EPSILON;
                for phase in &mut axis.phase[1..count.max(1)] {
                    phase.position = phase.position + little * (phase.position + problem.limits.vmax * axis.t);
                }
            }
            _ => {}
        }
    }
}

fn after<R: Real>(planned: &Move<R>, wait: R, t: R, from: State<R>) -> Move<R> {
    let mut later = *planned;
    let count = planned.count as usize;
    for (k, phase) in planned.phase[..=count].iter().enumerate() {
        later.phase[k + 1] = Phase { start: wait + phase.start, ..*phase };
    }
    later.phase[0] = Phase { duration: wait, position: from.position, ..Phase::default() };
    later.phase[count + 1].start = t;
    (later.count, later.t) = (planned.count + 1, t);
    later
}

fn a_tick_earlier<R: Real>(set: &Set<R>, axes: &mut [Move<R>]) {
    let (zero, t) = (R::ZERO, axes[0].t - set.cycle);
    if set.cycle == zero || t < set.duration || t <= zero {
        return;
    }
    for (axis, problem) in axes.iter_mut().zip(&set.axes) {
        let (limits, from, to) = ([problem.limits], [problem.from], [problem.to]);
        synchronise(std::slice::from_mut(axis), &limits, &from, &to, t, zero).expect("an axis that was planned");
        if axis.t > t {
            cut_off(axis, t);
        }
    }
}

/// Leaves the last part of a move out, and finds the states at the start of each phase from the end.
fn cut_off<R: Real>(axis: &mut Move<R>, t: R) {
    let count = axis.count as usize;
    let mut early = axis.t - t;
    let [phases @ .., end] = &mut axis.phase[..=count] else { return };
    end.start = t;
    let (mut position, mut velocity) = (end.position, end.velocity);
    for phase in phases.iter_mut().skip(1).rev() {
        let left_out = if early < phase.duration { early } else { phase.duration };
        early = early - left_out;
        phase.duration = phase.duration - left_out;
        phase.start = if phase.start < t { phase.start } else { t };
        let (z, a) = (phase.duration, phase.acceleration);
        let to = a + z * phase.jerk;
        position = position - z * (velocity - z * (to + to + a) / R::of(6.0));
        velocity = velocity - z * (a + to) / R::of(2.0);
        (phase.position, phase.velocity) = (position, velocity);
    }
    axis.t = t;
}

impl Fault {
    fn plan<R: Real>(
        self, set: &Set<R>, axes: &mut [Move<R>], plan: impl Fn(&Set<R>, &mut [Move<R>]) -> Result<Findings, Error>,
    ) -> Result<Findings, Error> {
        if self == Self::Refuses && set.axes.len() > 8 {
            return Err(Error::Axes);
        }
        plan(set, axes)?;
        let found = plan(&self.changed(set, axes[0].t), axes)?;
        self.spoil(set, axes);
        Ok(if self == Self::Silent { Findings::default() } else { found })
    }
}

impl<R: Real> Planner<R> for Fault {
    fn synchronise(&self, set: &Set<R>, axes: &mut [Move<R>]) -> Result<Findings, Error> {
        let found = self.plan(set, axes, |set, axes| Together.synchronise(set, axes))?;
        if *self == Self::ShiftedTooFar {
            a_tick_earlier(set, axes);
        }
        Ok(found)
    }

    fn line(&self, set: &Set<R>, axes: &mut [Move<R>]) -> Result<Findings, Error> {
        self.plan(set, axes, |set, axes| Together.line(set, axes))
    }
}
