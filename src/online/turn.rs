//! Position limits that bind: the fastest stop would pass one, and a harder brake turns there.
//!
//! The fastest stop eases its brake before the axis stands. The fastest motion that stays inside does not: it comes to the limit at a standstill that
//! does not last, with an acceleration away from it. If the limits are close, the fastest stop from there passes the other one, and so on.
//! `docs/planner.md` has the theory, in "Between two positions".

use super::motion::Move;
use super::problem::Problem;
use crate::findings::Error;
use crate::interval::rounding::{of_check, of_formula};
use crate::limits::Limits;
use crate::real::Real;
use crate::state::State;

/// More halvings than a range of accelerations has.
const MOST_HALVES: u32 = 64;

/// More turns than an axis makes before it can stop, or cannot be saved. What the position limits are farther apart than they must be, as a part of
/// this, grows from `x` to `√x` with each turn, and 3 % are enough to stop: from a rounding error that takes four turns.
const MOST_TURNS: usize = 6;

/// An end of a motion, and where the axis turns from there on.
pub(crate) struct Turns<R> {
    states: [State<R>; 1 + MOST_TURNS],
    count: usize,
}

impl<R: Real> Turns<R> {
    /// The turns after the start and before the end of a motion.
    pub fn of(limits: &Limits<R>, from: State<R>, to: State<R>, positions: [R; 2]) -> Result<[Self; 2], Error> {
        Ok([Self::after(limits, from, positions)?, Self::before(limits, to, positions)?])
    }

    /// Each end and its turns, for each way to make the motion. The way without turns is the first.
    pub fn ways([first, last]: &[Self; 2]) -> impl Iterator<Item = [&[State<R>]; 2]> {
        (0..=first.count).flat_map(move |most| (0..=last.count).map(move |rest| [first.first(most), last.first(rest)]))
    }

    /// The turns after the state `from`, until the fastest stop stays between the positions, or the hardest brake leaves them.
    fn after(limits: &Limits<R>, from: State<R>, positions: [R; 2]) -> Result<Self, Error> {
        let mut turns = Self { states: [from; 1 + MOST_TURNS], count: 0 };
        while let Some([last, next]) = turns.states.get_mut(turns.count..turns.count + 2) {
            let Some(turn) = turn_after(limits, *last, positions)? else { break };
            *next = turn;
            turns.count += 1;
        }
        Ok(turns)
    }

    /// The turns before the state `to`, from the last one on.
    fn before(limits: &Limits<R>, to: State<R>, [lowest, highest]: [R; 2]) -> Result<Self, Error> {
        let turns = Self::after(&limits.reversed(), to.reversed(), [-highest, -lowest])?;
        Ok(Self { states: turns.states.map(State::reversed), ..turns })
    }

    /// The end and the first turns, as many as `count`.
    fn first(&self, count: usize) -> &[State<R>] {
        self.states.get(..=count).unwrap_or_default()
    }
}

/// Between which states a motion is free: between its last turns, or its ends.
pub(crate) fn free<R: Real>(turns: [&[State<R>]; 2]) -> [State<R>; 2] {
    turns.map(|states| states.last().copied().unwrap_or_default())
}

/// Where an axis turns, if its fastest stop leaves the positions, by a sixteenth of its rounding error, and its hardest brake does not.
fn turn_after<R: Real>(
    limits: &Limits<R>, from: State<R>, [lowest, highest]: [R; 2],
) -> Result<Option<State<R>>, Error> {
    let mut stop = Move::default();
    stop.stop(limits, from)?;
    let is_above = stop.leaves(-R::INFINITY, highest, R::SIXTEENTH);
    let is_below = stop.leaves(lowest, R::INFINITY, R::SIXTEENTH);
    // If it leaves both, it leaves first the one to which it moves.
    Ok(if is_below && (from.velocity < R::ZERO || !is_above) {
        turn_below(&limits.mirrored(), from.mirrored(), -lowest).map(State::mirrored)
    } else if is_above {
        turn_below(limits, from, highest)
    } else {
        None
    })
}

/// The turn at `highest`: its acceleration is the one whose fastest ramp ends there. `None` if no ramp does.
fn turn_below<R: Real>(limits: &Limits<R>, from: State<R>, highest: R) -> Option<State<R>> {
    let State { velocity: v, acceleration: a, .. } = from;
    let after = |acceleration: R| {
        let to = State { velocity: R::ZERO, acceleration, ..from };
        State { position: Problem::new(limits, &from, &to).reach().1, ..to }
    };
    // The accelerations of an axis that eases its brake, and that brakes harder, all the time until it stands, and the one that leads to the lowest
    // velocity after the turn.
    let root = |square: R| square.at_least(R::ZERO).sqrt();
    let eased = if a < R::ZERO { root(a * a - (v + v) * limits.jmax) } else { R::ZERO };
    // If the acceleration may jump, twice the constant brake is hard enough.
    let jumped = v * v / (highest - from.position).abs();
    let fallen = if limits.jmin > -R::INFINITY { root(a * a - (v + v) * limits.jmin) } else { jumped };
    let kept = (-(limits.vmin + limits.vmin) * limits.jmax).sqrt();
    let (hardest, mut soft) = ((-fallen.at_most(kept)).at_least(limits.amin), -eased);
    let rounding = of_check(from.position.abs() + highest.abs());
    let stays = |acceleration: &R| after(*acceleration).position <= highest + rounding;
    // If it is too hard by a rounding error, the axis speeds up first, for the root of this error, and turns as much farther.
    let mut hard = [hardest, hardest - of_formula(hardest)].into_iter().find(stays)?;
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
    /// Plans the fastest motion that turns at the positions and stays between them. [`Error::Position`] if none does.
    #[cold]
    #[inline(never)] // for its stack
    pub(super) fn plan_with_turns(
        &mut self, limits: &Limits<R>, from: State<R>, to: State<R>, positions: [R; 2],
    ) -> Result<(), Error> {
        let [lowest, highest] = positions;
        let turns = Turns::of(limits, from, to, positions)?;
        let mut shortest = R::INFINITY;
        // In the next tick of a loop the rounding error may be smaller. So most of it is left, unless this is a detour.
        for (part, gain) in [(R::SIXTEENTH, R::ZERO), (R::ONE, R::EPSILON.sqrt())] {
            for turns in Turns::ways(&turns) {
                let [start, end] = free(turns);
                let mut planned = Self::default();
                let mut between = Self::default();
                let found = between.plan(limits, start, end).and_then(|_| planned.turn(limits, turns, &between));
                let t = found.map_or(R::INFINITY, |()| planned.t);
                if t + gain * t < shortest && !planned.leaves(lowest, highest, part) {
                    *self = planned;
                    shortest = t;
                }
            }
        }
        Error::Position.unless(shortest < R::INFINITY)
    }

    /// Plans the fastest motion by way of turns, with a free motion `between` them.
    pub(crate) fn turn(
        &mut self, limits: &Limits<R>, [first, last]: [&[State<R>]; 2], between: &Self,
    ) -> Result<(), Error> {
        self.ramps(limits, first)?;
        self.append(between)?;
        let mut now = between.end();
        for &end in last.iter().rev().skip(1) {
            // Both may be bound for a velocity beyond the limits.
            let mut limits = limits.reversed();
            limits.include(now.reversed());
            limits.include(end.reversed());
            self.ramp(&limits.reversed(), now, end)?;
            now = end;
        }
        Ok(())
    }

    /// Plans the fastest ramps from the start from turn to turn.
    fn ramps(&mut self, limits: &Limits<R>, states: &[State<R>]) -> Result<(), Error> {
        let mut now = states.first().copied().unwrap_or_default();
        self.stay(now);
        for &turn in states.iter().skip(1) {
            self.ramp(limits, now, turn)?;
            now = turn;
        }
        Ok(())
    }

    /// Plans the fastest stop, by way of turns if it would leave the positions. [`Error::Position`] if the hardest brake leaves them too.
    pub(crate) fn stop_within(&mut self, limits: &Limits<R>, from: State<R>, positions: [R; 2]) -> Result<(), Error> {
        let turns = Turns::after(limits, from, positions)?;
        // The last turn may be for a rounding error, and lead to the other position.
        for count in (0..=turns.count).rev() {
            let states = turns.first(count);
            self.ramps(limits, states)?;
            let mut next = Self::default();
            next.stop(limits, states.last().copied().unwrap_or(from))?;
            self.append(&next)?;
            if !self.leaves(positions[0], positions[1], R::ONE) {
                return Ok(());
            }
        }
        Err(Error::Position)
    }

    /// Goes on with the fastest ramp from one state to another one. Their positions fit it.
    fn ramp(&mut self, limits: &Limits<R>, from: State<R>, to: State<R>) -> Result<(), Error> {
        let problem = Problem::new(limits, &from, &to);
        let mut next = Self::default();
        let (direct, _) = problem.reach();
        problem.write(&mut next, &direct)?;
        self.append(&next)
    }
}
