//! Faults planted into the planner of paths. They show whether the judge sees a fault.

use super::{Chain, Path, Paths, Planner};
use support::prelude::*;

listed! {
    pub enum Fault {
        Refuses, // it refuses paths of many points
        Waits, // it stops at every point, and takes a little longer
        TooShort, // it promises a little less than a section takes
        TooFast, // an axis passes a waypoint a little too fast
        WideLimits, // the limits are a little wider
        NoZones, // the limits of the first section hold everywhere
        WaypointOff, // a waypoint is a representable number off the given one
        EndOff, // the end has another velocity
        Silent, // it finds nothing
    }
}

impl<R: Real> Planner<R> for Fault {
    fn plan(&self, chain: &Chain<R>, steps: u32) -> Result<(Path<R>, Findings), Error> {
        let mut changed = chain.clone();
        match self {
            Self::Refuses if chain.sections() > 5 => return Err(Error::Axes),
            Self::WideLimits => {
                for limits in &mut changed.limits {
                    limits.vmax = limits.vmax * R::of(1.01);
                    limits.jmax = limits.jmax * R::of(1.01);
                }
            }
            Self::NoZones => changed.limits.truncate(chain.axes),
            _ => {}
        }
        let (mut path, found) = Paths.plan(&changed, steps)?;
        let sections = chain.sections();
        let middle = path.states.len() / 2;
        match self {
            Self::Waits => {
                for state in &mut path.states[chain.axes..sections * chain.axes] {
                    (state.velocity, state.acceleration) = (R::ZERO, R::ZERO);
                }
                path.durations.iter_mut().for_each(|t| *t = R::of(1.01) * *t);
            }
            Self::TooShort => path.durations.iter_mut().for_each(|t| *t = *t * R::of(0.99)),
            Self::TooFast => path.states[middle].velocity = path.states[middle].velocity * R::of(1.05),
            Self::WaypointOff => path.states[middle].position = path.states[middle].position.neighbour(1),
            Self::EndOff => {
                let end = path.states.last_mut().expect("an end");
                end.velocity = end.velocity + R::of(1e-3);
            }
            _ => {}
        }
        let is_silent = *self == Self::Silent;
        Ok((path, if is_silent { Findings::default() } else { found }))
    }
}
