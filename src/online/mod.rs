//! One axis from any state to any state, planned in motion: [`Move::plan`] finds the fastest motion within limits of velocity, acceleration and
//! jerk. The programs of `docs/moves.md` plan, and plan again in mid-motion.

mod check;
mod motion;
mod phase;
pub(crate) mod problem;
mod recovery;
mod track;
pub(crate) mod turn;
mod write;

pub use crate::findings::Error;
pub use crate::limits::Limits;
pub use crate::state::State;
pub use motion::Move;
pub use phase::Phase;

use crate::findings::Findings;
use crate::real::Real;
use problem::Problem;

/// [`Error::NotFinite`] if one of two positions is not a number, [`Error::Limits`] if the lowest is not below the highest.
pub(crate) fn are_in_order<R: Real>(lowest: R, highest: R) -> Result<(), Error> {
    Error::NotFinite.unless(lowest.partial_cmp(&highest).is_some())?;
    Error::Limits.unless(lowest < highest)
}

impl<R: Real> Move<R> {
    /// Plans the fastest motion to a state, from any state. If the start violates the limits, the axis returns within them in minimum time and
    /// then stays within them. The target may be behind the axis, or nearer than it can stop.
    ///
    /// Returns [`Findings::OVERSHOOTS`], [`Findings::STARTS_OUTSIDE`] and [`Findings::ENDS_LEAVING`], each if it exceeds the rounding.
    /// [`Error::NotFinite`] if a state is not made of numbers, or the motion is beyond the range of the real type; [`Error::Limits`] if the limits are not
    /// around 0; [`Error::Target`] if the target is outside the limits, or the axis must have left them before. On an error the move stays as it is.
    ///
    /// ```
    /// use atraj::online::{Limits, Move, State};
    /// let limits = Limits { vmax: 2.0, vmin: -1.0, amax: 4.0, amin: -8.0, jmax: 50.0, jmin: -100.0 };
    /// let now = State { position: 0.0, velocity: 1.5, acceleration: 2.0 };
    /// let mut axis = Move::default();
    /// axis.plan(&limits, now, State::at(3.0))?;
    /// assert_eq!((axis.position(axis.t), axis.velocity(axis.t)), (3.0, 0.0));
    /// # Ok::<(), atraj::Error>(())
    /// ```
    #[inline] // a call less in each plan
    pub fn plan(&mut self, limits: &Limits<R>, from: State<R>, to: State<R>) -> Result<Findings, Error> {
        limits.check(from, to)?;
        let problem = Problem::new(limits, &from, &to);
        problem.write(self, &problem.fastest())?;
        Ok(problem.findings(self))
    }

    /// Plans the fastest motion to a state, as [`Move::plan`] does, that stays between two positions until its end, up to 128 ulps. An
    /// infinite position is no limit. It returns the findings and errors of [`Move::plan`]; [`Error::NotFinite`] also if a position is not a
    /// number, [`Error::Limits`] if `lowest` is not below `highest`.
    ///
    /// Where the fastest stop from the start would leave a position, the axis brakes harder, and turns at this position, then at the other one if it must.
    /// [`Error::Position`] if no motion stays between the positions: the hardest brake leaves them, or the target cannot be reached from within them.
    pub fn within(
        &mut self, limits: &Limits<R>, from: State<R>, to: State<R>, lowest: R, highest: R,
    ) -> Result<Findings, Error> {
        are_in_order(lowest, highest)?;
        let mut planned = Self::default();
        let mut found = planned.plan(limits, from, to)?;
        if planned.leaves(lowest, highest, R::SIXTEENTH) {
            planned.plan_with_turns(limits, from, to, [lowest, highest])?;
            found = Problem::new(limits, &from, &to).findings(&planned);
        }
        *self = planned;
        Ok(found)
    }

    /// Plans the fastest motion to a velocity and an acceleration. The position is free. It returns the findings and errors of [`Move::plan`].
    #[inline] // a call less in each plan
    pub fn reach(
        &mut self, limits: &Limits<R>, from: State<R>, velocity: R, acceleration: R,
    ) -> Result<Findings, Error> {
        let to = State { velocity, acceleration, ..from };
        limits.check(from, to)?;
        let mut problem = Problem::new(limits, &from, &to);
        let (direct, end) = problem.reach();
        problem.to.position = end;
        problem.write(self, &direct)?;
        Ok(problem.findings(self))
    }

    /// Plans the fastest stop. The position is free. It returns the findings and errors of [`Move::plan`].
    pub fn stop(&mut self, limits: &Limits<R>, from: State<R>) -> Result<Findings, Error> {
        self.reach(limits, from, R::ZERO, R::ZERO)
    }

    /// Plans the fastest motion to a target that moves on at its velocity. The motion ends level with the target, with its velocity, at the
    /// position `target.position + t * target.velocity`. It returns the findings and errors of [`Move::plan`]; [`Error::Target`] also if the
    /// target accelerates, or if its velocity is on a limit.
    ///
    /// Seen from the target, the limits of the velocity are shifted and the target is at rest.
    pub fn meet(&mut self, limits: &Limits<R>, from: State<R>, target: State<R>) -> Result<Findings, Error> {
        limits.check(from, target)?;
        let v = target.velocity;
        let seen = Limits { vmax: limits.vmax - v, vmin: limits.vmin - v, ..*limits };
        Error::Target.unless(seen.are_limits().is_ok() && target.acceleration == R::ZERO)?;
        let seen_from = State { position: from.position - target.position, velocity: from.velocity - v, ..from };
        let problem = Problem::new(&seen, &seen_from, &State::at(R::ZERO))
            .with_positions(from.position.abs() + target.position.abs());
        let profile = problem.fastest();
        let travelled = v.abs() * problem.duration(&profile);
        problem.check(&profile, target.position.abs() + v.abs() + travelled)?;
        problem.write(self, &profile)?;
        self.shift(from, target);
        Ok(problem.findings(self))
    }
}
