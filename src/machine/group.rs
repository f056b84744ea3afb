//! Axes that move together while the next motion is planned: on one line, on a path, or each for itself.

use super::axis::{are_ticked, elapsed};
use super::change::RateChange;
use super::clock::Clock;
use super::handover::{Handover, Moment, at};
use super::sections::{AxisPath, are_whole, duration, time_of_rest};
use crate::findings::{Error, Findings};
use crate::interval::rounding::of_check;
use crate::limits::Limits;
use crate::online::{Move, are_in_order};
use crate::real::Real;
use crate::several::{line, line_stop, synchronise, synchronise_within};
use crate::state::State;
use core::cell::{Cell, UnsafeCell};

/// Several axes between a main loop, which plans, and a timer interrupt, which asks for setpoints: [`Group::split`] gives a half to each.
///
/// As for an [`Axis`](super::Axis), a plan starts from the states that the axes will have after `lead` ticks, and all axes take it over
/// together, in this tick or never. The memory is the caller's: a state for each axis, three moves for each axis, and the moves of a path.
///
/// ```
/// use atraj::machine::Group;
/// use atraj::online::{Limits, Move, State};
/// let limits = [Limits::symmetric(30.0, 10.0, 5.0); 2];
/// let (mut states, mut moves) = ([State::at(0.0); 2], [Move::default(); 6]);
/// let mut group = Group::new(0.001, &mut states, &mut moves)?;
/// let (mut planner, mut ticker) = group.split();
/// let mut now = [State::at(0.0); 2];
/// planner.line(&limits, &[State::at(1.0), State::at(2.0)], 5)?;
/// for _ in 0..500 {
///     ticker.tick(&mut now);
/// }
/// planner.rate(&limits, 0.0, 5)?; // a feed hold: the axes stop on the line
/// while !ticker.tick(&mut now).ends {}
/// assert_eq!(now[1].velocity, 0.0);
/// planner.rate(&limits, 1.0, 5)?; // and go on
/// while !ticker.tick(&mut now).ends {}
/// assert_eq!(now, [State::at(1.0), State::at(2.0)]);
/// # Ok::<(), atraj::Error>(())
/// ```
#[repr(C)]
pub struct Group<'a, R> {
    pub(crate) handover: Handover,
    /// From one tick to the next, s.
    pub(crate) period: R,
    /// The planner's: where the axes will be when the next motion takes over.
    pub(crate) states: &'a [Cell<State<R>>],
    /// The moves of all axes at the first place, then at the next one.
    pub(crate) moves: &'a [Cell<Move<R>>],
    /// The planner's: the lowest positions of the axes and the highest ones; empty: any.
    pub(crate) positions: Cell<[&'a [R]; 2]>,
    /// The motions at their places. The handover says who may use which one.
    pub(crate) courses: [UnsafeCell<Course<'a, R>>; 3],
}

/// The memory of the caller: the states of the axes, and room for their moves at each place.
type Memory<'a, R> = (&'a [Cell<State<R>>], &'a [Cell<Move<R>>]);

/// What the axes follow at a place: its moves or a path, by a clock.
#[derive(Debug)]
#[repr(C)]
pub(crate) struct Course<'a, R> {
    /// The caller's path; empty: the moves of the place.
    pub path: &'a [Move<R>],
    /// When it is at its end, s.
    pub end: R,
    pub clock: Clock<R>,
}

/// What is new in a tick of a [`Group`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Tick {
    /// A plan takes over in this tick.
    pub begins: bool,
    /// From this tick on the motion is at its end: all axes are at their targets, or stand in a hold.
    pub ends: bool,
}

/// The half of a group for the main loop.
pub struct GroupPlanner<'g, 'a, R>(&'g Group<'a, R>);

/// The half of a group for the interrupt.
pub struct GroupTicker<'g, 'a, R>(&'g Group<'a, R>);

// SAFETY: as long as there are no halves, the group alone uses its memory, and nobody writes to a path.
unsafe impl<R: Send + Sync> Send for Group<'_, R> {}
// SAFETY: as for the halves of an axis. The states and positions of the group are the planner's alone, and nobody writes to a path.
unsafe impl<R: Send + Sync> Send for GroupPlanner<'_, '_, R> {}
// SAFETY: as above.
unsafe impl<R: Send + Sync> Send for GroupTicker<'_, '_, R> {}

/// What is in force at a takeover.
struct InForce<'g, 'a, R> {
    course: &'g Course<'a, R>,
    moves: &'g [Move<R>],
    /// For how long, s.
    x: R,
    /// The time of its path then, with its derivatives.
    time: [R; 4],
    /// Where the axes are then.
    states: &'g mut [State<R>],
    /// Between which positions the next motion has to stay.
    positions: [&'a [R]; 2],
}

/// The place of the next motion.
struct Next<'g, 'a, R> {
    course: &'g mut Course<'a, R>,
    moves: &'g mut [Move<R>],
}

impl<'a, R: Real> Group<'a, R> {
    /// Axes in these states, which get a tick every `period`, s. An axis in motion goes on so until a plan takes over. `moves` is room for three
    /// moves for each axis. [`Error::Axes`] if there is no axis or the room is another; [`Error::Duration`] if the period is not above 0 or
    /// not finite; [`Error::NotFinite`] if a state is not made of numbers.
    pub fn new(period: R, states: &'a mut [State<R>], moves: &'a mut [Move<R>]) -> Result<Self, Error> {
        let (states, moves) = Self::prepare(period, states, moves)?;
        let course = || UnsafeCell::new(Course { path: &[], end: R::ZERO, clock: Clock::new() });
        let courses = [course(), course(), course()];
        Ok(Self { handover: Handover::new(), period, states, moves, positions: Cell::new([&[]; 2]), courses })
    }

    /// Checks the arguments, and makes the axes go on as they are.
    pub(crate) fn prepare(
        period: R, states: &'a mut [State<R>], moves: &'a mut [Move<R>],
    ) -> Result<Memory<'a, R>, Error> {
        Error::Axes.unless(!states.is_empty() && moves.len() == 3 * states.len())?;
        are_ticked(period, states)?;
        // All three places, because moves are copied whole.
        for (axis, state) in moves.iter_mut().zip(states.iter().cycle()) {
            *axis = Move::default();
            axis.stay(*state);
        }
        Ok((Cell::from_mut(states).as_slice_of_cells(), Cell::from_mut(moves).as_slice_of_cells()))
    }

    /// The axes stand, and get a tick every `period`, s. All numbers of the group are 0.
    #[cfg(feature = "capi")]
    pub(crate) fn begin(&mut self, period: R) {
        self.handover = Handover::new();
        self.period = period;
        self.courses[0].get_mut().clock.time.stay(State { velocity: R::ONE, ..State::at(R::ZERO) });
    }

    /// The halves. Each may go to a thread or to an interrupt of its own. Nobody locks or waits, and nobody sees half a plan.
    pub fn split(&mut self) -> (GroupPlanner<'_, 'a, R>, GroupTicker<'_, 'a, R>) {
        (GroupPlanner(self), GroupTicker(self))
    }

    fn place(&self, place: usize) -> &[Cell<Move<R>>] {
        let n = self.states.len();
        self.moves.get(place * n..).and_then(|moves| moves.get(..n)).unwrap_or_default()
    }

    /// The course at a place, and its moves.
    ///
    /// # Safety
    /// Nobody writes to the place as long as the result lives.
    unsafe fn course(&self, place: usize) -> (&Course<'a, R>, &[Move<R>]) {
        let moves = self.place(place);
        // SAFETY: by the contract of this function; a cell has the layout of its value.
        let (course, moves) = unsafe { (&*at(&self.courses, place).get(), &*(&raw const *moves as *const [Move<R>])) };
        (course, if course.path.is_empty() { moves } else { course.path })
    }
}

impl<'g, 'a, R: Real> GroupTicker<'g, 'a, R> {
    /// # Safety
    /// This is the only ticker of the group.
    #[cfg(feature = "capi")]
    pub(crate) unsafe fn of(group: &'g Group<'a, R>) -> Self {
        Self(group)
    }

    /// The next setpoints: the states of the axes in this tick. Call it once in each tick.
    pub fn tick(&mut self, states: &mut [State<R>]) -> Tick {
        let Group { handover, period, .. } = self.0;
        let moment = handover.tick();
        // SAFETY: nobody writes to what is in force.
        let (course, moves) = unsafe { self.0.course(moment.place) };
        let x = elapsed(*period, moment);
        write_states(states, course.clock.state_of_time(x), moves, self.0.states.len());
        let begins = moment.age == 0;
        let has_ended = !begins && elapsed(*period, Moment { age: moment.age - 1, ..moment }) >= course.end;
        Tick { begins, ends: x >= course.end && !has_ended }
    }
}

/// The states of `n` axes at a time of their path.
fn write_states<R: Real>(states: &mut [State<R>], time: [R; 4], moves: &[Move<R>], n: usize) {
    for (index, state) in states.iter_mut().enumerate() {
        let [position, velocity, acceleration, _] = AxisPath::new(moves, n, index).state(time);
        *state = State { position, velocity, acceleration };
    }
}

impl<'g, 'a, R: Real> GroupPlanner<'g, 'a, R> {
    /// # Safety
    /// This is the only planner of the group.
    #[cfg(feature = "capi")]
    pub(crate) unsafe fn of(group: &'g Group<'a, R>) -> Self {
        Self(group)
    }

    /// Each motion that is planned from now on stays between two positions of each axis until its end, up to 128 ulps: the lowest ones and the highest
    /// ones. An infinite position is no limit, and empty lists are none. A line, path or change of the rate that would leave them is [`Error::Position`],
    /// and so is a target if no motion to it stays between them. An axis that cannot stop between them stops as fast as it can.
    ///
    /// [`Error::Axes`] if a list does not have one element for each axis; [`Error::NotFinite`] if a position is not a number; [`Error::Limits`] if the
    /// lowest is not below the highest. Then the positions stay as they are.
    pub fn within(&mut self, positions: [&'a [R]; 2]) -> Result<(), Error> {
        let [lowest, highest] = positions;
        let count = lowest.len();
        Error::Axes.unless(count == highest.len() && (count == 0 || count == self.0.states.len()))?;
        lowest.iter().zip(highest).try_for_each(|(&lowest, &highest)| are_in_order(lowest, highest))?;
        self.0.positions.set(positions);
        Ok(())
    }

    /// Each axis goes to its state by its fastest move, [`Move::plan`], after `lead` ticks. It returns the findings and errors of [`Move::plan`];
    /// [`Error::Axes`] if a list does not have one element for each axis; [`Error::Late`] as for an axis. On an error the motion goes on.
    pub fn go(&mut self, limits: &[Limits<R>], to: &[State<R>], lead: u32) -> Result<Findings, Error> {
        self.plan(limits, lead, |moves, from| {
            let mut found = Findings::default();
            Error::Axes.unless(to.len() == moves.len())?;
            let axes = moves.iter_mut().zip(limits).zip(&*from.states).zip(to).enumerate();
            for (index, (((axis, limits), state), to)) in axes {
                found |= match of_axis(from.positions, index) {
                    Some([lowest, highest]) => axis.within(limits, *state, *to, lowest, highest)?,
                    None => axis.plan(limits, *state, *to)?,
                };
            }
            Ok(found)
        })
    }

    /// All axes arrive in the same tick, by [`synchronise`] with the period as its cycle. It returns the findings and errors of both.
    pub fn sync(&mut self, limits: &[Limits<R>], to: &[State<R>], lead: u32) -> Result<Findings, Error> {
        let period = self.0.period;
        self.plan(limits, lead, |moves, from| {
            if from.positions[0].is_empty() {
                synchronise(moves, limits, from.states, to, R::ZERO, period)
            } else {
                synchronise_within(moves, limits, from.states, to, from.positions, R::ZERO, period)
            }
        })
    }

    /// The axes move on the straight line to their states, by [`line`](crate::axes::line) with the period as its cycle. It returns the findings and errors of both.
    pub fn line(&mut self, limits: &[Limits<R>], to: &[State<R>], lead: u32) -> Result<Findings, Error> {
        let period = self.0.period;
        self.plan(limits, lead, |moves, from| {
            let found = line(moves, limits, from.states, to, R::ZERO, period)?;
            Error::Position.unless(stay(moves, from.positions))?;
            Ok(found)
        })
    }

    /// Follows a path from its time `s` on, s: 0 from its start. `moves` has the moves of all axes for the first section, then for the second one, as
    /// [`path_moves`](crate::axes::path_moves) writes them. The path may be another than the one in force, if both have the same state at the
    /// takeover: so a path is continued while the axes move. Its clock has the rate 1, else the rate in force. `limits` are those of a change of the
    /// rate; the moves are taken as they are.
    ///
    /// [`Error::Axes`] if the moves are no whole sections; [`Error::Target`] if the moves of a section have several durations, if a section does not
    /// begin where the one before ends, if `s` is not on the path, if the path does not have the state of the axes there,
    /// or while the rate changes. Then the motion goes on.
    pub fn path(&mut self, limits: &[Limits<R>], moves: &'a [Move<R>], s: R, lead: u32) -> Result<Findings, Error> {
        self.next(limits, lead, |from, next| {
            Error::Axes.unless(are_whole(moves, limits.len()))?;
            let is_on_path = s >= R::ZERO && s <= duration(moves, limits.len());
            Error::Target.unless(is_on_path && is_path(moves, limits.len()))?;
            Error::Position.unless(stay(moves, from.positions))?;
            let clock = &from.course.clock;
            Error::Target.unless(from.x >= clock.until())?;
            let [at, rate, slowing, _] = from.time;
            // A motion that is over is no hold.
            let is_over = rate == R::ZERO && (at <= R::ZERO || at >= duration(from.moves, limits.len()));
            let steady = if slowing == R::ZERO && !is_over { rate } else { R::ONE };
            let length = time_of_rest(moves, limits.len());
            next.course.path = moves;
            for rate in [R::ONE, steady] {
                next.course.clock.begin_at(s, rate, length);
                let is_within = || Ok(RateChange::new(moves, limits, rate)?.keeps(&next.course.clock.time));
                let is_planned = rate >= R::ZERO && rate <= R::ONE;
                if from.is_at(moves, s, rate) && (is_planned || is_within()?) {
                    next.course.set_end(moves, limits.len());
                    return Ok(Findings::default());
                }
            }
            Err(Error::Target)
        })
    }

    /// The time of the motion in force after `lead` ticks, s: there [`path`](Self::path) can continue it. Where a tick comes between both calls, the
    /// path is [`Error::Target`]: ask again. [`Error::Late`] as for a plan.
    pub fn time(&self, lead: u32) -> Result<R, Error> {
        let takeover = self.0.handover.prepare(lead).ok_or(Error::Late)?;
        // SAFETY: nobody writes to what is in force.
        let (course, _) = unsafe { self.0.course(takeover.from.place) };
        Ok(course.clock.time(elapsed(self.0.period, takeover.from)))
    }

    /// Goes to another rate of the motion, which stays on its line or path: 1 as planned, 0 hold, 1/2 override, -1 back. `limits` are those of the
    /// plans and a reserve. Where the axes rest, before a motion or after it, a hold has nothing to do, and 1 is [`Findings::RATE_NOT_REACHED`]. It
    /// returns the findings and errors of [`Clock::rate`]; [`Error::Target`] also if the axes move each for itself.
    pub fn rate(&mut self, limits: &[Limits<R>], rate: R, lead: u32) -> Result<Findings, Error> {
        self.next(limits, lead, |from, next| next.change(from, limits, rate))
    }

    /// Stops on the line or path, if all axes then stand within twice the time of the slowest axis' own stop; else on a line that is in force as
    /// planned, by [`line_stop`]; else each axis at once. From a stop on the line or path [`rate`](Self::rate) can lead on. It returns
    /// the findings and errors of [`Move::stop`], and [`Error::Late`].
    pub fn stop(&mut self, limits: &[Limits<R>], lead: u32) -> Result<Findings, Error> {
        self.next(limits, lead, |from, next| {
            next.stop_each(from, limits)?;
            let slowest = next.moves.iter().fold(R::ZERO, |t, axis| t.at_least(axis.t));
            if next.change(from, limits, R::ZERO).is_ok() && next.course.end <= slowest + slowest {
                return Ok(Findings::default());
            }
            let [s, rate, slowing, _] = from.time;
            if from.moves.len() == limits.len() && rate == R::ONE && slowing == R::ZERO {
                next.copy(from);
                let stop = line_stop(next.moves, limits, s);
                if stop.is_ok() && stay(next.moves, from.positions) {
                    next.course.follow_moves(next.moves);
                    return stop;
                }
            }
            // The moves in force have overwritten the stops.
            next.stop_each(from, limits)
        })
    }

    /// `plan` gets the moves to write, and what is in force.
    fn plan(
        &mut self, limits: &[Limits<R>], lead: u32,
        plan: impl FnOnce(&mut [Move<R>], &InForce<'_, 'a, R>) -> Result<Findings, Error>,
    ) -> Result<Findings, Error> {
        self.next(limits, lead, |from, next| {
            from.settle(limits);
            let found = plan(next.moves, from)?;
            next.course.follow_moves(next.moves);
            Ok(found)
        })
    }

    fn next(
        &mut self, limits: &[Limits<R>], lead: u32,
        plan: impl FnOnce(&mut InForce<'_, 'a, R>, &mut Next<'_, 'a, R>) -> Result<Findings, Error>,
    ) -> Result<Findings, Error> {
        let Group { ref handover, period, states, ref positions, ref courses, .. } = *self.0;
        Error::Axes.unless(limits.len() == states.len())?;
        let takeover = handover.prepare(lead).ok_or(Error::Late)?;
        let place = self.0.place(takeover.place);
        // SAFETY: nobody writes to what is in force. Nobody else uses the place of the takeover, which is another one, or the states.
        let ((course, in_force), next, states, moves) = unsafe {
            (
                self.0.course(takeover.from.place),
                &mut *at(courses, takeover.place).get(),
                &mut *(&raw const *states as *mut [State<R>]),
                &mut *(&raw const *place as *mut [Move<R>]),
            )
        };
        let x = elapsed(period, takeover.from);
        let time = course.clock.state_of_time(x);
        write_states(states, time, in_force, limits.len());
        let mut from = InForce { course, moves: in_force, x, time, states, positions: positions.get() };
        let mut next = Next { course: next, moves };
        let findings = plan(&mut from, &mut next)?;
        if handover.publish(&takeover) { Ok(findings) } else { Err(Error::Late) }
    }
}

impl<R: Real> InForce<'_, '_, R> {
    /// Moves an axis back by what its fastest stop ends beyond a position, if that is a rounding of the move in force.
    fn settle(&mut self, limits: &[Limits<R>]) {
        let n = limits.len();
        for (index, (state, limits)) in self.states.iter_mut().zip(limits).enumerate() {
            let Some([lowest, highest]) = of_axis(self.positions, index) else { return };
            let mut stop = Move::default();
            let in_force = AxisPath::new(self.moves, n, index).section(self.time[0]);
            if let (Ok(_), Some((of, _))) = (stop.stop(limits, *state), in_force) {
                let reached = stop.extremes();
                let below = (lowest - reached.lowest.position).at_least(R::ZERO);
                let back = below + (highest - reached.highest.position).at_most(R::ZERO);
                if back.abs() <= of.rounding() {
                    state.position = state.position + back;
                }
            }
        }
    }

    /// Whether the axes are on a path at its time `s`, at this rate.
    fn is_at(&self, moves: &[Move<R>], s: R, rate: R) -> bool {
        let near = |x: R, y: R, slope: R| (x - y).abs() <= of_check(y.abs() + slope.abs() * (s + self.x));
        let mut states = self.states.iter().enumerate();
        states.all(|(index, now)| {
            let axis = |moves| AxisPath::new(moves, self.states.len(), index);
            let [p, v, a, j] = axis(moves).state([s, rate, R::ZERO, R::ZERO]);
            // Where a phase begins, the jerks of both differ.
            let [.., jerk] = axis(self.moves).state(self.time);
            let jerk = j.abs().at_least(jerk.abs());
            near(now.position, p, v) && near(now.velocity, v, a) && near(now.acceleration, a, jerk)
        })
    }
}

impl<'a, R: Real> Next<'_, 'a, R> {
    fn stop_each(&mut self, from: &InForce<'_, 'a, R>, limits: &[Limits<R>]) -> Result<Findings, Error> {
        let mut found = Findings::default();
        for (index, ((axis, limits), state)) in self.moves.iter_mut().zip(limits).zip(&*from.states).enumerate() {
            found |= axis.stop(limits, *state)?;
            let left =
                of_axis(from.positions, index).filter(|[lowest, highest]| axis.leaves(*lowest, *highest, R::ONE));
            let mut inside = Move::default();
            if left.is_some_and(|positions| inside.stop_within(limits, *state, positions).is_ok()) {
                *axis = inside;
            }
        }
        self.course.follow_moves(self.moves);
        Ok(found)
    }

    /// Copies the moves in force, of a path those of the first section.
    fn copy(&mut self, from: &InForce<'_, 'a, R>) {
        self.moves.iter_mut().zip(from.moves).for_each(|(axis, from)| *axis = *from);
    }

    /// Goes on in the moves in force, by a clock that changes its rate.
    fn change(&mut self, from: &InForce<'_, 'a, R>, limits: &[Limits<R>], rate: R) -> Result<Findings, Error> {
        Error::Target.unless(is_path(from.moves, limits.len()))?;
        self.course.path = from.course.path;
        self.copy(from);
        let clock = &mut self.course.clock;
        clock.go_on_from(&from.course.clock, from.x);
        let found = clock.rate(from.moves, limits, R::ZERO, rate)?;
        self.course.set_end(from.moves, limits.len());
        let passed = self.course.clock.span(self.course.end);
        let mut axes = (0..limits.len()).filter_map(|index| Some((index, of_axis(from.positions, index)?)));
        let stays = |(index, positions)| AxisPath::new(from.moves, limits.len(), index).stays(passed, positions);
        Error::Position.unless(axes.all(stays))?;
        Ok(found)
    }
}

/// The lowest position of an axis and its highest one, if the group has positions.
fn of_axis<R: Real>([lowest, highest]: [&[R]; 2], index: usize) -> Option<[R; 2]> {
    Some([*lowest.get(index)?, *highest.get(index)?])
}

/// Whether the moves of whole sections stay between the positions.
fn stay<R: Real>(moves: &[Move<R>], [lowest, highest]: [&[R]; 2]) -> bool {
    let positions = lowest.iter().zip(highest).cycle();
    moves.iter().zip(positions).all(|(axis, (lowest, highest))| !axis.leaves(*lowest, *highest, R::ONE))
}

/// Whether the moves of each section have one duration, and begin where those before them end.
fn is_path<R: Real>(moves: &[Move<R>], n: usize) -> bool {
    let next = moves.get(n..).unwrap_or_default();
    let joins = moves.iter().zip(next).all(|(before, of)| before.end() == of.start());
    let lasts_as_one =
        |section: &[Move<R>]| section.iter().all(|of| section.first().is_some_and(|first| of.t == first.t));
    joins && moves.chunks(n.max(1)).all(lasts_as_one)
}

impl<R: Real> Course<'_, R> {
    /// Follows the moves of its place, as planned.
    fn follow_moves(&mut self, moves: &[Move<R>]) {
        self.path = &[];
        self.clock.begin_at(R::ZERO, R::ONE, time_of_rest(moves, moves.len()));
        self.set_end(moves, moves.len());
    }

    /// When the time of the path stands, or passes the end.
    fn set_end(&mut self, moves: &[Move<R>], n: usize) {
        let State { position, velocity, .. } = self.clock.time.end();
        self.end = if velocity == R::ZERO {
            self.clock.time.t
        } else if velocity > R::ZERO {
            self.clock.time.t + ((duration(moves, n) - position) / velocity).at_least(R::ZERO)
        } else {
            R::INFINITY
        };
    }
}
