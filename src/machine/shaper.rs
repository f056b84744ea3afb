//! Input shapers: a move, or a stream of states, that leaves a load at rest, within its limits. `docs/machine.md` has the theory and the papers.

use crate::findings::Error;
use crate::liba::Bell;
use crate::online::Move;
use crate::real::Real;
use crate::sampling::Sampled;
use crate::state::State;
use crate::table::Table;

/// The most impulses of a shaper: two frequencies with four each, or four with two each.
const MOST_IMPULSES: usize = 16;

/// The part of the vibration that the kinds EI and EI2 leave at their frequency: 1/20, as in the papers.
const LEFT: u8 = 20;

/// Numbers of a state.
const N: usize = 3;

/// The longest shaper, in ticks.
const MOST_TICKS: u32 = 1 << 20;

/// How a shaper meets a frequency that is not exactly known. The last column says by how much the frequency may be wrong while less than 5 %
/// of the vibration of an undamped load is left.
///
/// | kind | impulses | longer by | wrong by |
/// |---|---|---|---|
/// | `Zv` | 2 | 1/2 period | 3 % |
/// | `Mzv` | 3 | 3/4 period | 5 % |
/// | `Zvd` | 3 | 1 period | 14 % |
/// | `Ei` | 3 | 1 period | 20 % |
/// | `Ei2` | 4 | 3/2 periods | 36 % |
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ShaperKind {
    /// Zero vibration.
    Zv,
    /// Zero vibration and zero derivative.
    Zvd,
    /// Zero vibration by three impulses, each 3/8 of a period after the one before.
    Mzv,
    /// Extra insensitive.
    Ei,
    /// Extra insensitive with two humps.
    Ei2,
}

/// A mean of a move at several times. It leaves little vibration at its frequencies.
///
/// A mean of motions that keep the limits keeps the limits. So the shaped motion of a move from rest to rest keeps every limit of the move: of
/// velocity, acceleration and jerk. It starts and ends where the move does, and takes `duration` longer. Where an axis is retargeted in
/// mid-motion, a [`ShaperStream`] shapes it; here it would jump. Before its start and after its end a move is taken to
/// go on with the velocity that it has there; a [`Move`] goes on after its end with its acceleration, too.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Shaper<R> {
    /// How much longer a shaped move takes, s.
    pub(crate) duration: R,
    /// Each impulse is a mean over this time, s.
    pub(crate) smoothing: R,
    pub(crate) count: u32,
    /// The weights of the impulses. Their sum is 1.
    pub(crate) weights: [R; MOST_IMPULSES],
    /// When the impulses come, s.
    pub(crate) delays: [R; MOST_IMPULSES],
}

impl<R: Real> Default for Shaper<R> {
    /// The shaper that changes nothing.
    fn default() -> Self {
        let zeros = [R::ZERO; MOST_IMPULSES];
        let mut weights = zeros;
        weights[0] = R::ONE;
        Self { duration: R::ZERO, smoothing: R::ZERO, count: 1, weights, delays: zeros }
    }
}

impl<R: Real> Shaper<R> {
    /// A shaper for a load that swings with this frequency, Hz, and this damping, a part of the critical one. Its errors are those of [`Shaper::add`].
    pub fn new(kind: ShaperKind, frequency: R, damping: R) -> Result<Self, Error> {
        let mut shaper = Self::default();
        shaper.add(kind, frequency, damping)?;
        Ok(shaper)
    }

    /// Shapes the shaped motion once more: for another frequency of the load. The impulses of both are multiplied. [`Error::Duration`] if the
    /// frequency is not above 0 or has no finite period; [`Error::Limits`] if the damping is not from 0 to below 1, or if there are more than 16
    /// impulses. On an error the shaper stays as it is.
    pub fn add(&mut self, kind: ShaperKind, frequency: R, damping: R) -> Result<(), Error> {
        Error::Limits.unless(damping >= R::ZERO && damping < R::ONE)?;
        let other = Impulses::of(kind, frequency, damping);
        let mut shaper = Self {
            duration: self.duration + other.step * R::from(other.count as u8 - 1),
            // No product wraps, whatever the bytes of the shaper are.
            count: self.count.min(MOST_IMPULSES as u32 + 1) * other.count,
            ..*self
        };
        Error::Duration.unless(frequency > R::ZERO && frequency < R::INFINITY && shaper.duration < R::INFINITY)?;
        Error::Limits.unless(shaper.count as usize <= MOST_IMPULSES)?;
        let places = shaper.weights.iter_mut().zip(&mut shaper.delays);
        let pairs = other.each().flat_map(|other| self.impulses().map(move |own| (own, other)));
        for ((weight, delay), (own, other)) in places.zip(pairs) {
            *weight = own.0 * other.0;
            *delay = own.1 + other.1;
        }
        *self = shaper;
        Ok(())
    }

    /// A shaper without a frequency: the motion becomes its mean over this time, s. So its acceleration changes evenly, and the derivative of its
    /// jerk is at most twice the limit of the jerk, divided by the time. A time of 0 changes nothing. [`Shaper::add`] adds frequencies.
    /// [`Error::Duration`] if the time is negative or not finite.
    pub fn smooth(time: R) -> Result<Self, Error> {
        Error::Duration.unless(time >= R::ZERO && time < R::INFINITY)?;
        Ok(Self { duration: time, smoothing: time, ..Self::default() })
    }

    /// How much longer a shaped move takes, s.
    pub fn duration(&self) -> R {
        self.duration
    }

    /// The shaped motion at time `x`, s, since the start of the move.
    pub fn state(&self, of: &Move<R>, x: R) -> State<R> {
        self.mean(x, || of.borders().map(|border| border.time()), |x| beyond(of.state_at(x), x.at_most(R::ZERO)))
    }

    /// The shaped motion of a double-S at time `x`, s.
    pub fn bell_state(&self, of: &Bell<R>, x: R) -> State<R> {
        let outside = |x: R| x.at_most(R::ZERO) + (x - of.t).at_least(R::ZERO);
        self.mean(x, || of.borders().map(|border| border.time()), |x| beyond(of.state_at(x), outside(x)))
    }

    /// The mean over the impulses, counted from the last one: where all are equal, it is exact.
    fn mean<const N: usize>(&self, x: R, borders: impl Fn() -> [R; N], state: impl Fn(R) -> State<R>) -> State<R> {
        let last = self.window(x - (self.duration - self.smoothing), &borders, &state);
        let mut mean = last;
        for (weight, delay) in self.impulses() {
            let one = self.window(x - delay, &borders, &state);
            mean.position = mean.position + weight * (one.position - last.position);
            mean.velocity = mean.velocity + weight * (one.velocity - last.velocity);
            mean.acceleration = mean.acceleration + weight * (one.acceleration - last.acceleration);
        }
        mean
    }

    /// The mean over the smoothing before `x`. Simpson's rule is exact between two borders, where position and velocity are polynomials of the
    /// third degree at most. The acceleration is a mean of accelerations: a difference of velocities would lose digits and leave the limit.
    fn window<const N: usize>(&self, x: R, borders: &impl Fn() -> [R; N], state: &impl Fn(R) -> State<R>) -> State<R> {
        let (end, mut from) = (state(x), x - self.smoothing);
        if from >= x || !from.is_finite() {
            return end;
        }
        let (mut mean, mut left, borders) = (end, state(from), borders());
        // Rounded from `x - smoothing`, so that the weights of the parts have the sum 1.
        let whole = x - from;
        // Each round passes a border.
        for _ in 0..=N {
            let ahead = borders.into_iter().filter(|border| *border > from);
            let to = ahead.fold(x, R::at_most);
            let (middle, right) = (state(from + R::HALF * (to - from)), state(to));
            let part = (to - from) / whole;
            let sixth = part * R::SIXTH;
            let simpson = |left: R, middle: R, right: R, end: R| {
                sixth * ((left - end) + R::from(4) * (middle - end) + (right - end))
            };
            mean.position = mean.position + simpson(left.position, middle.position, right.position, end.position);
            mean.velocity = mean.velocity + simpson(left.velocity, middle.velocity, right.velocity, end.velocity);
            mean.acceleration = mean.acceleration + part * (middle.acceleration - end.acceleration);
            if to >= x {
                break;
            }
            (from, left) = (to, right);
        }
        mean
    }

    /// How many numbers the delay line of a [`ShaperStream`] has, with a state every `period`, s. `None` if the period is not above 0 or not finite, or
    /// if the shaper takes more than 1,048,576 periods.
    pub fn size(&self, period: R) -> Option<usize> {
        self.ticks(period).map(|[ticks, means]| N * (ticks + means))
    }

    /// Of how many states the mean of its smoothing is, and how many means its impulses look back to.
    fn ticks(&self, period: R) -> Option<[usize; 2]> {
        let is_period = period > R::ZERO && period < R::INFINITY;
        let last = self.impulses().fold(R::ZERO, |last, (_, delay)| last.at_least(delay));
        // Each time, because the bytes of a shaper may be anything.
        let is_short = |time: R| time >= R::ZERO && time / period <= R::from_index(MOST_TICKS as i32);
        (is_period && [self.duration, self.smoothing, last].into_iter().all(is_short)).then_some(())?;
        let smoothing = (self.smoothing / period + R::HALF).to_index();
        let last = (last / period).to_index();
        Some([smoothing as usize + 1, last as usize + 2])
    }

    /// Weights and delays.
    fn impulses(&self) -> impl Iterator<Item = (R, R)> {
        let all = self.weights.iter().zip(&self.delays);
        all.map(|(&weight, &delay)| (weight, delay)).take(self.count as usize)
    }
}

/// Extrapolates at constant velocity before the start and after the end.
fn beyond<R: Real>(end: State<R>, time: R) -> State<R> {
    if time == R::ZERO || !time.is_finite() {
        return end;
    }
    State { position: end.position + time * end.velocity, acceleration: R::ZERO, ..end }
}

/// The impulses of one frequency.
struct Impulses<R> {
    count: u32,
    /// Their weights without damping. They are the same in both orders.
    outer: R,
    inner: R,
    /// From one impulse to the next, s.
    step: R,
    /// By how much the vibration falls from one impulse to the next.
    decay: R,
}

impl<R: Real> Impulses<R> {
    fn of(kind: ShaperKind, frequency: R, damping: R) -> Self {
        let (half, quarter) = (R::HALF, R::HALF * R::HALF);
        let left = R::ONE / R::from(LEFT);
        let (count, outer, inner, spacing) = match kind {
            ShaperKind::Zv => (2, half, half, half),
            ShaperKind::Zvd => (3, quarter, half, half),
            // Where each impulse comes 3/8 of a period, 135°, later: 2 outer cos 135° + inner = 0.
            ShaperKind::Mzv => {
                let cos = R::HALF.sqrt();
                let outer = half / (R::ONE + cos);
                (3, outer, R::ONE - (outer + outer), half - half * quarter)
            }
            ShaperKind::Ei => (3, quarter * (R::ONE + left), half * (R::ONE - left), half),
            ShaperKind::Ei2 => {
                let square = left * left;
                let x = (square * (R::ONE + (R::ONE - square).sqrt())).cube_root();
                let three = R::from(3);
                let outer = (three * x * x + (x + x) + three * square) / (R::from(16) * x);
                (4, outer, half - outer, half)
            }
        };
        let swing = (R::ONE - damping * damping).sqrt();
        Self {
            count,
            outer,
            inner,
            // `spacing` damped periods.
            step: R::ONE / (frequency * swing) * spacing,
            // e^(-ζ ω t), where t is the spacing.
            decay: ((R::PI + R::PI) * spacing * damping / swing).exp_of_negative(),
        }
    }

    /// Weights and delays. Each weight falls as the vibration of the impulses before it does, and the sum is 1.
    fn each(&self) -> impl Iterator<Item = (R, R)> {
        let weight = move |k: u32| {
            let is_outer = k == 0 || k + 1 == self.count;
            let undamped = if is_outer { self.outer } else { self.inner };
            (0..k).fold(undamped, |weight, _| weight * self.decay)
        };
        let sum = (0..self.count).fold(R::ZERO, |sum, k| sum + weight(k));
        (0..self.count).map(move |k| (weight(k) / sum, self.step * R::from(k as u8)))
    }
}

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
