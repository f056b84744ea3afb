//! A shaper of a stream of states, one a tick, whatever makes them.

use super::shaper::Shaper;
use crate::findings::Error;
use crate::real::Real;
use crate::state::State;
use crate::table::Table;

/// Numbers of a state.
const N: usize = 3;

/// The longest shaper, in ticks.
const MOST_TICKS: u32 = 1 << 20;

/// A shaper of a stream of states: of a move, of a clock, of a group, of a jog, retargeted at any time.
///
/// The shaped state is a mean of the states that the stream had before. So it keeps every limit of the stream, and nothing jumps, whatever the
/// stream does. It is late by the duration of the shaper at most.
///
/// A delay that is no multiple of the period is a mean of two ticks. It changes what an impulse leaves by `(2π f period)²/8` at most: 1 % at
/// 50 Hz and 1 kHz. The smoothing of the shaper is the mean of all ticks in it, and lasts a multiple of the period.
///
/// The past is in a delay line of the caller, with [`Shaper::size`] numbers. Each call takes the same one.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct ShaperStream<R> {
    /// The shaper, with its delays in ticks.
    pub(crate) shaper: Shaper<R>,
    /// From one tick to the next, s.
    pub(crate) period: R,
    /// What is added to a position for each unit of the velocity, s.
    pub(crate) ahead: R,
    /// The mean of the last `ticks` states, and the next one while it grows.
    pub(crate) mean: Mean<R>,
    pub(crate) growing: Mean<R>,
    /// Of how many states the mean is, and which of them is replaced next.
    pub(crate) ticks: u32,
    pub(crate) at: u32,
    /// How many means the impulses look back to, and which of them is the newest.
    pub(crate) means: u32,
    pub(crate) at_mean: u32,
    /// For how many ticks the stream stands.
    pub(crate) still: u32,
}

/// A sum of states, kept as offsets from one of them, so that equal states add up to exactly 0.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Mean<R> {
    pub(crate) base: [R; N],
    pub(crate) above: [R; N],
}

impl<R: Real> Mean<R> {
    fn of(base: [R; N]) -> Self {
        Self { base, above: [R::ZERO; N] }
    }

    fn add(&mut self, state: [R; N]) {
        for (sum, (x, base)) in self.above.iter_mut().zip(state.into_iter().zip(self.base)) {
            *sum = *sum + (x - base);
        }
    }

    fn replace(&mut self, old: [R; N], new: [R; N]) {
        for (sum, ((old, new), base)) in self.above.iter_mut().zip(old.into_iter().zip(new).zip(self.base)) {
            *sum = *sum + ((new - base) - (old - base));
        }
    }

    fn mean(&self, count: R) -> [R; N] {
        let mut mean = self.base;
        for (x, above) in mean.iter_mut().zip(self.above) {
            *x = *x + above / count;
        }
        mean
    }
}

impl<R: Real> Shaper<R> {
    /// How many numbers the delay line of a [`ShaperStream`] has, with a state every `period`, s. `None` if the period is not above 0 or not finite, or
    /// if the shaper takes more than 1,048,576 periods.
    pub fn size(&self, period: R) -> Option<usize> {
        self.ticks(period).map(|[ticks, means]| N * (ticks + means))
    }

    /// Of how many states the mean of its smoothing is, and how many means its impulses look back to.
    fn ticks(&self, period: R) -> Option<[usize; 2]> {
        let is_period = period > R::ZERO && period < R::INFINITY;
        (is_period && self.duration / period <= R::from_index(MOST_TICKS as i32)).then_some(())?;
        let last = self.impulses().fold(R::ZERO, |last, (_, delay)| last.at_least(delay));
        let smoothing = (self.smoothing / period + R::HALF).to_index();
        let last = (last / period).to_index();
        Some([smoothing as usize + 1, last as usize + 2])
    }
}

impl<R: Real> ShaperStream<R> {
    /// A stream that is in the state `now`, and gets a state every `period`, s. A stream in motion is taken to have had its velocity for long: so it
    /// starts later than `now` by the mean delay. [`Error::Duration`] if [`Shaper::size`] is `None`; [`Error::Axes`] if the line has fewer numbers;
    /// [`Error::NotFinite`] if the state is not finite, or one that it is taken to have had.
    pub fn new(shaper: &Shaper<R>, period: R, now: State<R>, line: &mut [R]) -> Result<Self, Error> {
        let [ticks, means] = shaper.ticks(period).ok_or(Error::Duration)?;
        Error::Axes.unless(line.len() >= N * (ticks + means))?;
        let longest = R::from_index((ticks + means) as i32) * period;
        Error::NotFinite.unless(now.is_finite() && (now.position - longest * now.velocity).is_finite())?;
        let mut line = Table(line);
        let mut in_ticks = *shaper;
        for delay in &mut in_ticks.delays {
            *delay = *delay / period;
        }
        let earlier = |position: R, ticks: usize| {
            [position - R::from_index(ticks as i32) * period * now.velocity, now.velocity, R::ZERO]
        };
        let mut mean = Mean::of(earlier(now.position, 0));
        for k in 0..ticks {
            let state = earlier(now.position, ticks - 1 - k);
            line.set(k, state);
            mean.add(state);
        }
        let [position, ..] = mean.mean(R::from_index(ticks as i32));
        for k in 0..means {
            line.set(ticks + k, earlier(position, means - 1 - k));
        }
        let (ticks, means) = (ticks as u32, means as u32);
        let growing = Mean::of(earlier(now.position, 0));
        let still = if now.is_at_rest() { ticks + means } else { 0 };
        let (at, at_mean, ahead) = (0, means - 1, R::ZERO);
        Ok(Self { shaper: in_ticks, period, ahead, mean, growing, ticks, at, means, at_mean, still })
    }

    /// Adds `advance` times the velocity to the position, before it is shaped: the pressure advance of an extruder, s. The derivatives follow; the
    /// acceleration has the mean jerk over the smoothing. [`Error::NotFinite`] if it is not finite; [`Error::Moving`] as in [`ShaperStream::change`].
    pub fn advance(&mut self, advance: R) -> Result<(), Error> {
        Error::NotFinite.unless(advance.is_finite())?;
        self.stands()?;
        self.ahead = advance;
        Ok(())
    }

    /// Takes another shaper, while the stream stands. It returns the errors of [`ShaperStream::new`]; [`Error::Moving`] if the stream moves, or moved
    /// so shortly before that the shaped state does. On an error the stream stays as it is.
    pub fn change(&mut self, shaper: &Shaper<R>, line: &mut [R]) -> Result<(), Error> {
        self.stands()?;
        let ahead = self.ahead;
        let [position, ..] = self.growing.base;
        *self = Self { ahead, ..Self::new(shaper, self.period, State::at(position), line)? };
        Ok(())
    }

    fn stands(&self) -> Result<(), Error> {
        // The oldest mean is of the oldest states.
        let past = self.ticks.saturating_add(self.means).saturating_sub(1);
        Error::Moving.unless(self.still >= past)
    }

    /// Takes the next state of the stream, and gives the shaped one. [`Error::NotFinite`] if the state is not finite; [`Error::Axes`] if the line is
    /// shorter than it was. Then the stream stays as it is.
    pub fn tick(&mut self, now: State<R>, line: &mut [R]) -> Result<State<R>, Error> {
        Error::Axes.unless(self.size() > 0 && line.len() >= self.size())?;
        Error::NotFinite.unless(now.is_finite())?;
        let line = &mut Table(line);
        let mean = self.smoothed(now, line);
        self.at_mean = after(self.at_mean, self.means);
        line.set((self.ticks + self.at_mean) as usize, mean);
        Ok(self.shaped(line))
    }

    /// How many numbers its delay line has. 0 if [`ShaperStream::new`] has not made it: then its members may be anything.
    fn size(&self) -> usize {
        let Self { ticks, at, means, at_mean, .. } = *self;
        let is_stream = at < ticks && ticks <= MOST_TICKS + 1 && at_mean < means && means <= MOST_TICKS + 2;
        if is_stream { N * (ticks + means) as usize } else { 0 }
    }

    /// The mean of the last states, with the advance.
    fn smoothed(&mut self, now: State<R>, line: &mut Table<R, N>) -> [R; N] {
        let state = [now.position, now.velocity, now.acceleration];
        let oldest = self.at as usize;
        let old = line.row(oldest);
        let newest = line.row(earlier(self.at, 1, self.ticks) as usize);
        self.still = if newest == state { self.still.saturating_add(1) } else { 1 };
        self.still = if now.is_at_rest() { self.still } else { 0 };
        line.set(oldest, state);
        self.mean.replace(old, state);
        self.growing.add(state);
        self.at = after(self.at, self.ticks);
        if self.at == 0 {
            // A sum of these states alone: rounding errors of earlier ones do not add up.
            self.mean = self.growing;
            self.growing = Mean::of(state);
        }
        let count = R::from_index(self.ticks as i32);
        let [p, v, a] = self.mean.mean(count);
        let jerk = (state[2] - old[2]) / (count * self.period);
        [p + self.ahead * v, v + self.ahead * a, a + self.ahead * jerk]
    }

    /// The mean over the impulses, counted from the newest state: where all are equal, it is exact.
    fn shaped(&self, line: &Table<R, N>) -> State<R> {
        let mean = |back: i32| line.row((self.ticks + earlier(self.at_mean, back as u32, self.means)) as usize);
        let newest = mean(0);
        let mut shaped = newest;
        for (weight, delay) in self.shaper.impulses() {
            let whole = delay.to_index();
            let part = delay - R::from_index(whole);
            let (one, other) = (mean(whole), mean(whole.saturating_add(1)));
            for (x, ((one, other), newest)) in shaped.iter_mut().zip(one.into_iter().zip(other).zip(newest)) {
                *x = *x + weight * ((one - newest) + part * (other - one));
            }
        }
        let [position, velocity, acceleration] = shaped;
        State { position, velocity, acceleration }
    }
}

/// The next place in a ring.
fn after(k: u32, count: u32) -> u32 {
    if k + 1 < count { k + 1 } else { 0 }
}

/// The place so many places before `k`, in a ring.
fn earlier(k: u32, back: u32, count: u32) -> u32 {
    if back <= k { k - back } else { (k + count).saturating_sub(back) }
}
