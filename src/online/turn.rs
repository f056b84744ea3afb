//! A wall that binds: the fastest stop would leave a position, and a harder brake turns there.
//!
//! The fastest stop eases its brake before the axis stands. The fastest motion that stays inside does not: it comes to the wall at a standstill that
//! does not last, with an acceleration away from the wall. `docs/planner.md` has the theory, in "Between two positions".

use super::motion::{MOST_PHASES, Move};
use super::problem::Problem;
use crate::findings::Error;
use crate::limits::Limits;
use crate::real::Real;
use crate::state::State;

/// More halvings than a range of accelerations has.
const MOST_HALVES: u32 = 64;

/// Where an axis turns, if its fastest stop leaves the positions. [`Error::Position`] if the hardest brake leaves them too.
fn turn_after<R: Real>(
    limits: &Limits<R>, from: State<R>, [lowest, highest]: [R; 2],
) -> Result<Option<State<R>>, Error> {
    let mut stop = Move::default();
    stop.stop(limits, from)?;
    if !stop.leaves(lowest, highest) {
        return Ok(None);
    }
    let turn = if stop.leaves(-R::INFINITY, highest) {
        turn_below(limits, from, highest)
    } else {
        turn_below(&limits.mirrored(), from.mirrored(), -lowest).map(State::mirrored)
    };
    turn.map(Some).ok_or(Error::Position)
}

/// Where an axis comes from that ends in the state `to`, if its fastest launch from rest leaves the positions.
fn turn_before<R: Real>(
    limits: &Limits<R>, to: State<R>, [lowest, highest]: [R; 2],
) -> Result<Option<State<R>>, Error> {
    // In the other order of time, seen in a mirror, velocities stay.
    let reversed = |State { position, velocity, acceleration }: State<R>| State {
        position: -position,
        velocity,
        acceleration: -acceleration,
    };
    let turn = turn_after(&limits.reversed(), reversed(to), [-highest, -lowest])?;
    Ok(turn.map(reversed))
}

/// The turn at `highest`: its acceleration is the one whose fastest ramp ends there. `None` if no ramp does.
fn turn_below<R: Real>(limits: &Limits<R>, from: State<R>, highest: R) -> Option<State<R>> {
    let State { velocity: v, acceleration: a, .. } = from;
    let after = |acceleration: R| {
        let to = State { velocity: R::ZERO, acceleration, ..from };
        let mut problem = Problem::new(limits, from, to);
        problem.reach();
        problem.to()
    };
    // The accelerations of an axis that eases its brake, and that brakes harder, all the time until it stands, and the one that leads to the lowest
    // velocity after the turn.
    let root = |square: R| square.at_least(R::ZERO).sqrt();
    let eased = if a < R::ZERO { root(a * a - (v + v) * limits.jmax) } else { R::ZERO };
    let fallen = root(a * a - (v + v) * limits.jmin);
    let kept = (-(limits.vmin + limits.vmin) * limits.jmax).sqrt();
    let (mut hard, mut soft) = ((-fallen.at_most(kept)).at_least(limits.amin), -eased);
    let rounding = R::DOUBT * (from.position.abs() + highest.abs());
    if after(hard).position > highest + rounding {
        return None;
    }
    for _ in 0..MOST_HALVES {
        let half = R::HALF * (hard + soft);
        if half <= hard || half >= soft {
            break;
        }
        *(if after(half).position > highest { &mut soft } else { &mut hard }) = half;
    }
    Some(State { position: highest.at_most(after(hard).position), ..after(hard) })
}

impl<R: Real> Move<R> {
    /// Plans the fastest motion that turns at one of the positions, or at both, and stays between them.
    #[cold]
    #[inline(never)] // for its stack
    pub(super) fn plan_with_turns(
        &mut self, limits: &Limits<R>, from: State<R>, to: State<R>, positions: [R; 2],
    ) -> Result<(), Error> {
        let turns = [turn_after(limits, from, positions)?, turn_before(limits, to, positions)?];
        let [lowest, highest] = positions;
        let mut answer = Err(Error::Position);
        for turns in [[turns[0], None], [None, turns[1]], turns] {
            let mut planned = Self::default();
            let is_planned = planned.turn(limits, from, turns, to).is_ok();
            let is_better = answer.is_err() || planned.t < self.t;
            if is_planned && is_better && !planned.leaves(lowest, highest) {
                *self = planned;
                answer = Ok(());
            }
        }
        answer
    }

    /// Plans the fastest motion by way of these turns.
    fn turn(
        &mut self, limits: &Limits<R>, from: State<R>, [first, last]: [Option<State<R>>; 2], to: State<R>,
    ) -> Result<(), Error> {
        self.stay(from);
        if let Some(turn) = first {
            self.ramp(limits, from, turn)?;
        }
        let mut next = Self::default();
        next.plan(limits, first.unwrap_or(from), last.unwrap_or(to))?;
        self.append(&next)?;
        last.map_or(Ok(()), |turn| self.ramp(limits, turn, to))
    }

    /// Plans the fastest stop, by way of a turn if it would leave the positions. [`Error::Position`] if the hardest brake leaves them too.
    pub(crate) fn stop_within(&mut self, limits: &Limits<R>, from: State<R>, positions: [R; 2]) -> Result<(), Error> {
        let Some(turn) = turn_after(limits, from, positions)? else {
            return self.stop(limits, from).map(|_| ());
        };
        self.stay(from);
        self.ramp(limits, from, turn)?;
        let mut next = Self::default();
        next.stop(limits, turn)?;
        self.append(&next)
    }

    /// Goes on with the fastest ramp from one state to another, whose positions it meets.
    fn ramp(&mut self, limits: &Limits<R>, from: State<R>, to: State<R>) -> Result<(), Error> {
        let problem = Problem::new(limits, from, to);
        let mut next = Self::default();
        problem.write(&mut next, &{ problem }.reach())?;
        self.append(&next)
    }

    /// Goes on with a move that starts where this one ends. [`Error::Position`] if there are too many phases.
    pub(crate) fn append(&mut self, next: &Self) -> Result<(), Error> {
        if self.phase_count() + next.phase_count() > 1 + MOST_PHASES {
            return Err(Error::Position);
        }
        self.go_on(next);
        Ok(())
    }
}
