//! How the clock of a path goes to another rate: a few changes in a row, each proved to keep the limits of all axes. `docs/machine.md` has the theory.

use super::enclosure::Enclosure;
use super::sections::{AxisPath, start_at_rest, time_of_rest};
use crate::findings::{Error, Extremes};
use crate::interval::rounding::{of_check, of_formula};
use crate::limits::Limits;
use crate::online::{Move, Phase};
use crate::real::Real;
use crate::state::State;

/// A faster change is tried at most so often, each time a twelfth of the slowest axis' free stop later, or a sixteenth of what is left.
const SEARCHES: u32 = 32;
const STEPS: u8 = 12;

/// The first limits of a change are these 256ths of `J/|v|`, and `λ` times the lower of `A/|v|` and `J/|a|`. `λ` is the first of 2, 1, 1/2, … that
/// passes, raised by bisection, in so many trials.
const SHARES: [u8; 5] = [200, 100, 40, 16, 4];
const TRIALS: u32 = 12;

/// Where no change is found so, its limits are `λ A/V` and `q λ² J/V` with the highest speeds of the whole path: `λ` is halved from 16 down to
/// `16/2^16`, with one `q` in sixteenths after the other.
const RATIOS: [u8; 5] = [16, 4, 64, 1, 255];
const SCALES: u32 = 17;

/// Then each limit is raised alone: by these sixteenths of itself, one after the other.
const RAISES: [u8; 6] = [64, 32, 24, 20, 20, 18];

/// A change takes at most so many times the slowest axis' free stop and the path. A slower one costs less than the rounding errors of the limits,
/// which in binary32 allowed a hold of half an hour.
const LONGEST: i32 = 32;

/// The most parts in which a phase of the clock is examined: a power of 2. More parts find no shorter hold.
const PARTS: i32 = 32;

/// How the time of a path comes to a rate.
pub(super) struct Law<R> {
    /// When the rate is reached, s, or else the end of the path.
    pub until: R,
    pub is_reached: bool,
}

pub(super) struct RateChange<'a, R> {
    moves: &'a [Move<R>],
    limits: &'a [Limits<R>],
    rate: R,
    /// The duration of the path; infinite if it ends in motion.
    length: R,
    /// The least `A/|v|` and `J/|v|` of the axes at their highest speeds.
    least: [R; 2],
    /// The new rate surely keeps the limits from this time of the path on; NaN if this is not known.
    kept_from: R,
    /// A fast change stays between these rates. So the time does not turn, unless the motion or the new rate makes it turn, or no change is found.
    rates: [R; 2],
}

impl<'a, R: Real> RateChange<'a, R> {
    pub fn new(moves: &'a [Move<R>], limits: &'a [Limits<R>], rate: R) -> Result<Self, Error> {
        let length = time_of_rest(moves, limits.len());
        Error::Target.unless(rate >= R::ZERO || start_at_rest(moves, limits.len()))?;
        let speeds =
            moves.iter().zip(limits.iter().cycle()).map(|(of, limits)| (of.extremes().speed(), R::ZERO, limits));
        let least = slowest([R::INFINITY; 2], speeds);
        Ok(Self { moves, limits, rate, length, least, kept_from: R::NAN, rates: [-R::INFINITY, R::INFINITY] })
    }

    /// Plans the change in `time`, which is the motion as it would go on. It does so until a faster change is found.
    pub fn plan(mut self, time: &mut Move<R>) -> Result<Law<R>, Error> {
        let from = time.start();
        if self.may_jump(from.position) {
            return self.leave(from.position, time);
        }
        // Once, and not again for each change that is tried.
        let is_kept = self.keeps_after(State { velocity: self.rate, ..from });
        self.kept_from = if is_kept { from.position } else { R::NAN };
        let stop = self.free_stop(from.position)?;
        let Extremes { lowest, highest } = time.extremes();
        let rounding = of_check(R::ONE);
        let bound = |turns: bool| if turns { R::INFINITY } else { rounding };
        let [low, high] = [lowest.velocity.at_most(self.rate), highest.velocity.at_least(self.rate)];
        self.rates = [-bound(low < -rounding), bound(high > rounding)];
        let mut found = self.faster_later(stop, time)?;
        if found.is_none() {
            self.rates = [-R::INFINITY, R::INFINITY];
            found = self.faster_later(stop, time)?;
        }
        let Some(law) = found else { return self.slow(from, stop, time) };
        // From a low rate the motion takes long to the places where a change is searched.
        let is_low = |phase: &&Phase<R>| {
            let Phase { duration, velocity, acceleration, jerk, .. } = **phase;
            let is_steady = duration > R::ZERO && acceleration == R::ZERO && jerk == R::ZERO;
            is_steady && velocity != R::ZERO && velocity.abs() < self.rate.abs()
        };
        match time.phases().iter().find(is_low).copied() {
            Some(low) => self.sooner(&low, stop, law, time),
            None => Ok(law),
        }
    }

    /// What is sooner: the law, or a change from the start of its steady phase on.
    #[inline(never)] // for its stack
    fn sooner(&self, steady: &Phase<R>, stop: R, law: Law<R>, time: &mut Move<R>) -> Result<Law<R>, Error> {
        let (from, mut change, mut joined) = (steady.state(), Move::default(), *time);
        let is_fast = self.fastest(from, stop, law.until - steady.start, &mut change)?;
        let fast = Law { until: change.t, is_reached: true };
        let found = if is_fast { Ok(fast) } else { self.slow(from, stop, &mut change) };
        let Ok(Law { until, is_reached }) = found else { return Ok(law) };
        let until = steady.start + until;
        let is_joined = until < law.until && joined.change_at(steady.start, &change).is_some();
        if !is_joined || joined.go_to_the_end(self.length).is_none() {
            return Ok(law);
        }
        *time = joined;
        Ok(Law { until, is_reached })
    }

    /// A faster change, which may begin later; `stop` is the slowest axis' free stop. `None` if none is found and the motion cannot go on.
    #[inline(never)] // for its stack
    fn faster_later(&self, stop: R, time: &mut Move<R>) -> Result<Option<Law<R>>, Error> {
        let start = time.start();
        time.go_to_the_end(self.length).ok_or(Error::Target)?;
        let goes_on = self.keeps(time);
        let (end, is_hold) = (time.end(), self.rate == R::ZERO);
        let ends = self.may_jump(end.position);
        let stands = end.velocity == R::ZERO && (is_hold || ends);
        let mut until = if goes_on && stands { time.t } else { R::INFINITY };
        let mut is_reached = is_hold && !ends;
        let step = stop / R::from(STEPS);
        let (mut change, mut t) = (Move::default(), R::ZERO);
        // From a standstill the first change is taken: a later one arrives hardly sooner, and each place costs a search.
        let searches = if goes_on && !start.is_at_rest() { SEARCHES } else { 1 };
        for _ in 0..searches {
            let most = (until - t).at_most(self.longest(stop));
            let is_found = self.fastest(time.state_at(t), stop, most, &mut change)?;
            // A little gain is not worth a phase.
            let reached = t + change.t;
            if is_found && reached + R::SIXTEENTH * step < until {
                let mut joined = *time;
                if joined.change_at(t, &change).and_then(|()| joined.go_to_the_end(self.length)).is_some() {
                    (until, is_reached) = (reached, true);
                    *time = joined;
                }
            }
            if t >= time.t.at_most(until) {
                break;
            }
            // The last place is the end of the motion.
            let later = step
                .at_least(R::HALF * R::HALF * R::HALF * t)
                .at_least(R::SIXTEENTH * R::HALF * R::HALF * (until - t).at_most(time.t));
            t = (t + later).at_most(time.t);
        }
        Ok((until < R::INFINITY).then_some(Law { until, is_reached }))
    }

    /// A change within limits for the whole path, which may be so slow that it passes an end before it has the rate. There the path stands.
    #[inline(never)] // for its stack
    fn slow(&self, from: State<R>, stop: R, time: &mut Move<R>) -> Result<Law<R>, Error> {
        self.first_slow(from, time)?;
        if self.is_on_path(time) {
            let until = time.t;
            Error::Target.unless(until <= self.longest(stop))?;
            time.go_to_the_end(self.length).ok_or(Error::Target)?;
            return Ok(Law { until, is_reached: true });
        }
        // A hold passes the end to which the path goes.
        let goes = if self.rate == R::ZERO { from.velocity } else { self.rate };
        let border = if goes > R::ZERO { self.length } else { R::ZERO };
        let until = time.time_at(border).ok_or(Error::Target)?;
        time.keep_until(until);
        time.push(Phase { start: until, position: border, ..Phase::default() }).ok_or(Error::Target)?;
        Ok(Law { until, is_reached: false })
    }

    fn first_slow(&self, from: State<R>, time: &mut Move<R>) -> Result<(), Error> {
        let [acceleration, jerk] = self.least;
        for ratio in RATIOS {
            let mut scale = R::from(16);
            for _ in 0..SCALES {
                let jerk = R::SIXTEENTH * R::from(ratio) * jerk * scale * scale;
                let limits = [jerk, jerk, acceleration * scale];
                self.within(from, limits, time)?;
                if self.keeps(time) {
                    return self.raise(from, time, limits);
                }
                scale = R::HALF * scale;
            }
        }
        Err(Error::Target)
    }

    /// Whether the rate may jump at the time `s`, because the path rests there at its end or start, or because nothing moves.
    pub fn may_jump(&self, s: R) -> bool {
        self.least == [R::INFINITY; 2]
            || s >= self.length
            || s <= R::ZERO && start_at_rest(self.moves, self.limits.len())
    }

    /// From where the rate may jump.
    fn leave(&self, s: R, time: &mut Move<R>) -> Result<Law<R>, Error> {
        let s = s.at_least(R::ZERO).at_most(self.length);
        let away = self.rate > R::ZERO && s < self.length || self.rate < R::ZERO && s > R::ZERO;
        time.stay(State { velocity: if away { self.rate } else { R::ZERO }, ..State::at(s) });
        if !self.keeps(time) {
            return self.slow(State::at(s), self.free_stop(s)?, time);
        }
        time.go_to_the_end(self.length).ok_or(Error::Target)?;
        Ok(Law { until: R::ZERO, is_reached: away || self.rate == R::ZERO })
    }

    /// How long the slowest axis takes for its stop at the time `s` of the path.
    #[inline(never)] // for its stack
    fn free_stop(&self, s: R) -> Result<R, Error> {
        let mut longest = R::ZERO;
        for (index, limits) in self.limits.iter().enumerate() {
            if let Some((of, start)) = self.axis(index).section(s) {
                let mut stop = Move::default();
                stop.stop(limits, of.state_at(s - start))?;
                longest = longest.at_least(stop.t);
            }
        }
        Ok(longest)
    }

    fn longest(&self, stop: R) -> R {
        R::from_index(LONGEST) * (stop + self.axis(0).duration())
    }

    fn axis(&self, index: usize) -> AxisPath<'a, R> {
        AxisPath::new(self.moves, self.limits.len(), index)
    }

    /// The fastest change, which takes about as long as a stop, and whether one is found: not much longer than `most`.
    #[inline(never)] // for its stack
    fn fastest(&self, from: State<R>, stop: R, most: R, change: &mut Move<R>) -> Result<bool, Error> {
        let [acceleration, first_jerk] = self.limits_at(from.position);
        // Where the axes get faster meanwhile, the rate must bend less at the end.
        let [_, last_jerk] = self.limits_at(from.position + R::HALF * (from.velocity + self.rate) * stop);
        let last_jerk = last_jerk.at_most(first_jerk);
        let [up, down] = if self.rate < from.velocity { [last_jerk, first_jerk] } else { [first_jerk, last_jerk] };
        let mut shortest = most + R::HALF * most;
        let (mut time, mut best) = (Move::default(), None);
        for share in SHARES {
            let share = R::from(share) * R::SIXTEENTH * R::SIXTEENTH;
            // The highest scale that passed, or 0, and the lowest one above it that did not.
            let (mut low, mut high) = (R::ZERO, R::from(4));
            for _ in 0..TRIALS {
                // 2, 1, 1/2, … until one passes, then the geometric mean of both. From above: where the axes get faster, only a fast change may be possible.
                let scale = if low > R::ZERO { (low * high).sqrt() } else { R::HALF * high };
                let limits = [share * up, share * down, acceleration * scale];
                self.within(from, limits, &mut time)?;
                let is_shorter = time.t < shortest;
                if is_shorter && self.is_along_path(&time) && self.keeps(&time) {
                    (shortest, best, low) = (time.t, Some(limits), scale);
                    *change = time;
                } else if is_shorter || low > R::ZERO {
                    high = scale;
                } else {
                    break; // a lower scale takes even longer
                }
            }
        }
        let Some(limits) = best else { return Ok(false) };
        self.raise(from, change, limits)?;
        Ok(true)
    }

    /// How fast the rate may change at this time of the path.
    fn limits_at(&self, s: R) -> [R; 2] {
        let most = self.least.map(|least| R::from(16) * R::from(16) * R::from(16) * least);
        let here = self.limits.iter().enumerate().map(|(index, limits)| {
            let state = self.axis(index).section(s).map(|(of, start)| of.state_at(s - start)).unwrap_or_default();
            (state.velocity, state.acceleration, limits)
        });
        slowest(most, here)
    }

    /// Raises each limit of a change alone, as long as the limits of the axes are kept.
    #[inline(never)] // for its stack
    fn raise(&self, from: State<R>, time: &mut Move<R>, mut limits: [R; 3]) -> Result<(), Error> {
        let mut faster = Move::default();
        for raise in RAISES {
            for index in 0..limits.len() {
                let mut higher = limits;
                if let Some(limit) = higher.get_mut(index) {
                    *limit = *limit * R::SIXTEENTH * R::from(raise);
                }
                self.within(from, higher, &mut faster)?;
                let is_better = faster.t < time.t && (self.is_along_path(&faster) || !self.is_on_path(time));
                if is_better && self.keeps(&faster) {
                    (*time, limits) = (faster, higher);
                }
            }
        }
        Ok(())
    }

    /// The fastest change within limits of its own: of its jerk up and down, and of its acceleration.
    fn within(&self, from: State<R>, [up, down, acceleration]: [R; 3], time: &mut Move<R>) -> Result<(), Error> {
        let limits = Limits { jmax: up, jmin: -down, ..Limits::symmetric(R::ONE, acceleration, R::INFINITY) };
        time.reach(&limits, from, self.rate, R::ZERO)?;
        time.begin_from(from.position);
        Ok(())
    }

    /// Whether the time stays between the ends of the path.
    fn is_on_path(&self, time: &Move<R>) -> bool {
        let extremes = time.extremes();
        let rounding = of_check(self.axis(0).duration());
        extremes.lowest.position >= -rounding && extremes.highest.position <= self.length + rounding
    }

    /// Whether the time stays between the ends of the path and its rate between its bounds.
    fn is_along_path(&self, time: &Move<R>) -> bool {
        let (Extremes { lowest, highest }, [low, high]) = (time.extremes(), self.rates);
        lowest.velocity >= low && highest.velocity <= high && self.is_on_path(time)
    }

    /// Whether the rate does not overshoot by more than 1, and all axes surely keep their limits.
    pub fn keeps(&self, time: &Move<R>) -> bool {
        let fastest = R::ONE + time.start().velocity.abs().at_least(self.rate.abs());
        time.extremes().speed() <= fastest
            && self.trials().all(|trial| time.phases().iter().all(|phase| trial.may_keep(phase)))
            && self.trials().all(|trial| time.phases().iter().all(|phase| trial.keeps_in(phase)))
            && self.keeps_after(time.end())
    }

    /// Whether all axes surely keep their limits at a steady rate until the end of the path or its start.
    fn keeps_after(&self, State { position: s, velocity: rate, .. }: State<R>) -> bool {
        rate == self.rate && (s - self.kept_from) * rate >= R::ZERO
            || self.trials().all(|trial| {
                let left = if rate > R::ZERO { trial.axis.duration() - s } else { s };
                let duration = if rate != R::ZERO && left > R::ZERO { left / rate.abs() } else { R::ZERO };
                trial.keeps_in(&Phase { duration, position: s, velocity: rate, ..Phase::default() })
            })
    }

    fn trials(&self) -> impl Iterator<Item = Trial<'a, R>> {
        self.limits.iter().enumerate().map(|(index, limits)| Trial { axis: self.axis(index), limits })
    }
}

/// The lower of the least `A/|v|` and `J/|a|`, and the least `J/|v|`, of axes with these velocities and accelerations. Both are `most` at most.
fn slowest<'a, R: Real + 'a>(most: [R; 2], axes: impl Iterator<Item = (R, R, &'a Limits<R>)>) -> [R; 2] {
    axes.fold(most, |[acceleration, jerk], (v, a, limits)| {
        let [most_a, most_j] = [limits.amax.at_most(-limits.amin), limits.jmax.at_most(-limits.jmin)];
        [acceleration.at_most(most_a / v.abs()).at_most(most_j / a.abs()), jerk.at_most(most_j / v.abs())]
    })
}

impl<R: Real> Move<R> {
    /// Forgets the motion before the time `x`, which is 0 from now on.
    pub(super) fn begin_at(&mut self, x: R) -> Option<()> {
        let State { position, velocity, acceleration } = self.state_at(x);
        let end = self.phases().len();
        self.count = 0;
        for index in 1..=end {
            let phase = *self.phase.get(index)?;
            let lasts = phase.duration > R::ZERO && phase.start + phase.duration > x;
            if lasts || index == end {
                let passed = (x - phase.start).at_least(R::ZERO);
                let State { position, velocity, acceleration } = phase.state().after(passed, phase.jerk);
                let duration = (phase.duration - passed).at_least(R::ZERO);
                let start = (phase.start - x).at_least(R::ZERO);
                self.push(Phase { start, duration, position, velocity, acceleration, jerk: phase.jerk })?;
            }
        }
        self.phase[0] = Phase { position, velocity, acceleration, ..Phase::default() };
        Some(())
    }

    /// Shifts the motion to a position at its start. Its end may be so far away that the start has large rounding errors.
    fn begin_from(&mut self, position: R) {
        let (off, end) = (position - self.phase[1].position, self.phases().len());
        for phase in self.phase.get_mut(1..=end).unwrap_or_default() {
            phase.position = phase.position + off;
        }
    }

    /// Makes the time of a path go on at its last rate to the end of the path at `length`, or to its start, and stand there.
    pub(super) fn go_to_the_end(&mut self, length: R) -> Option<()> {
        let State { position, velocity, acceleration } = self.end();
        let border = if velocity > R::ZERO { length } else { R::ZERO };
        let duration = (border - position) / velocity;
        if velocity == R::ZERO || acceleration != R::ZERO || duration == R::INFINITY {
            return Some(());
        }
        let (start, duration) = (self.t, duration.at_least(R::ZERO));
        self.keep_until(start);
        self.push(Phase { start, duration, position, velocity, ..Phase::default() })?;
        self.push(Phase { start: start + duration, position: border, ..Phase::default() })
    }

    /// The motion between two of its times. Behind its end it goes on. `None` if it has too many phases.
    pub(super) fn between(&self, from: R, to: R) -> Option<Self> {
        let phase_at = |x: R| {
            let State { position, velocity, acceleration } = self.state_at(x);
            Phase { start: x - from, position, velocity, acceleration, ..Phase::default() }
        };
        let mut part = *self;
        part.begin_at(from)?;
        part.keep_until(to - from);
        let end = self.t.at_least(from);
        if to > end {
            part.push(Phase { duration: to - end, ..phase_at(end) })?;
        }
        part.push(phase_at(to))?;
        Some(part)
    }

    /// At the time `t` another motion begins. `None` if it has too many phases.
    fn change_at(&mut self, t: R, other: &Self) -> Option<()> {
        self.keep_until(t);
        let end = other.phases().len();
        for phase in other.phase.get(1..=end).unwrap_or_default() {
            self.push(Phase { start: t + phase.start, ..*phase })?;
        }
        Some(())
    }

    /// Forgets the motion after the time `t`. What follows is to be pushed.
    fn keep_until(&mut self, t: R) {
        let end = self.phases().len();
        self.count = 0;
        for phase in self.phase.get_mut(1..end).unwrap_or_default() {
            if !(phase.duration > R::ZERO && phase.start < t) {
                break;
            }
            phase.duration = phase.duration.at_most(t - phase.start);
            self.count += 1;
        }
    }

    /// Adds a phase, or the end. `None` if there is no room for it.
    fn push(&mut self, phase: Phase<R>) -> Option<()> {
        self.count += 1;
        self.t = phase.start;
        *self.phase.get_mut(self.count as usize)? = phase;
        Some(())
    }
}

/// The phases of a move that starts at `start`, each with its start and that of the next one. If the move goes on, its end is the last one.
fn phases<R: Real>(of: &Move<R>, start: R, goes_on: bool) -> impl Iterator<Item = (&Phase<R>, R, R)> {
    let count = of.phases().len();
    let used = of.phase.iter().take(count + usize::from(goes_on));
    // Phase 0 is the start.
    let lasting = used.enumerate().skip(1).filter(move |(index, phase)| phase.duration > R::ZERO || *index == count);
    lasting.map(move |(index, phase)| {
        let next = of.phase.get(index + 1).filter(|_| index < count);
        let next = next.map_or(R::INFINITY, |next| start + next.start);
        (phase, start + phase.start, next)
    })
}

/// An axis whose limits the clock is to keep.
struct Trial<'a, R> {
    axis: AxisPath<'a, R>,
    limits: &'a Limits<R>,
}

impl<R: Real> Trial<'_, R> {
    /// Whether the axis keeps its limits near both ends of a phase of the clock. Nearly all changes that are too fast do not, and need no proof.
    fn may_keep(&self, phase: &Phase<R>) -> bool {
        [1, 31].iter().all(|part| {
            let x = phase.duration * R::SIXTEENTH * R::HALF * R::from(*part);
            let time = [phase.position(x), phase.velocity(x), phase.acceleration(x), phase.jerk];
            let [_, v, a, j] = self.axis.state(time).map(Enclosure::constant);
            self.is_within(v, a, j)
        })
    }

    /// Whether the axis surely keeps its limits during a phase of the clock: as a whole, or else each half of it, and so on.
    fn keeps_in(&self, phase: &Phase<R>) -> bool {
        let least = phase.duration / R::from_index(PARTS);
        let (mut done, mut part) = (0, PARTS);
        while done < PARTS {
            let [from, to] = [done, done + part].map(|k| R::from_index(k) * least);
            if self.keeps_over(phase, Enclosure::between(from, to)) {
                done += part;
                // The largest part that begins here: the lowest bit that is set.
                part = done & done.wrapping_neg();
            } else if part > 1 {
                part /= 2;
            } else {
                return false;
            }
        }
        true
    }

    fn keeps_over(&self, of: &Phase<R>, part: Enclosure<R>) -> bool {
        let [passed, ..] = part.along(of);
        let [low, high] = passed.range();
        // Of a part that begins at the end of a phase up to rounding, the next phase has all.
        let later = low + of_formula(low.abs());
        let is_touched = |start: R, end: R| high >= start && (high <= end || later < end);
        let mut sections = self.axis.sections().filter(|(_, begin, end)| is_touched(*begin, *end));
        sections.all(|(section, begin, end)| {
            let all = phases(section, begin, end == R::INFINITY);
            all.filter(|(_, start, end)| is_touched(*start, *end)).all(|(phase, start, end)| {
                let part = part.narrowed(passed.when_between(start, end));
                self.keeps_within(phase, start, part.along(of), of.jerk)
            })
        })
    }

    /// While the axis is in a phase that starts at the time `start` of the path, and the time of the path and its derivatives are in these parts.
    fn keeps_within(&self, phase: &Phase<R>, start: R, [s, rate, slowing, _]: [Enclosure<R>; 4], bending: R) -> bool {
        let [_, v, a, _] = s.plus(Enclosure::constant(-start)).along(phase);
        let square = rate.times(rate);
        let acceleration = a.times(square).plus(v.times(slowing));
        let turning = a.scaled(R::from(3)).times(rate.times(slowing));
        let jerk = square.times(rate).scaled(phase.jerk).plus(turning).plus(v.scaled(bending));
        self.is_within(v.times(rate), acceleration, jerk)
    }

    fn is_within(&self, velocity: Enclosure<R>, acceleration: Enclosure<R>, jerk: Enclosure<R>) -> bool {
        let limits = self.limits;
        velocity.is_between(limits.vmin, limits.vmax)
            && acceleration.is_between(limits.amin, limits.amax)
            && jerk.is_between(limits.jmin, limits.jmax)
    }
}

#[cfg(test)]
mod tests {
    use super::RateChange;
    use crate::limits::Limits;
    use crate::online::Move;
    use crate::state::State;

    /// The path ends before its time stands still, and the other way its start comes first.
    #[test]
    fn a_slow_hold_passes_an_end() {
        let limits = [Limits::symmetric(30.0, 10.0, 5.0)];
        let mut moves = [Move::default()];
        moves[0].plan(&limits[0], State::at(0.0), State::at(1.0)).expect("a plan");
        let hold = RateChange::new(&moves, &limits, 0.0).expect("a path");
        let end: f64 = moves[0].t;
        for (position, velocity, border) in [(end - 1e-6, 1.0, end), (1e-6, -1.0, 0.0)] {
            let mut time = Move::default();
            let law = hold.slow(State { velocity, ..State::at(position) }, 1.0, &mut time).expect("a change");
            assert!(!law.is_reached && (law.until - 1e-6_f64).abs() < 1e-9);
            assert_eq!(time.end(), State::at(border));
        }
    }

    /// The phase that is cut lasts until then.
    #[test]
    fn what_comes_later_is_forgotten() {
        let mut of = Move::default();
        of.plan(&Limits::symmetric(30.0, 10.0, 5.0), State::at(0.0), State::at(5.0)).expect("a plan");
        let t = 0.75 * of.t;
        of.keep_until(t);
        let last = of.phase[of.count as usize];
        assert!(of.count > 2 && last.start < t && last.start + last.duration == t);
    }
}
