//! Input shapers: a move that leaves a load at rest, within the limits of the move. `docs/machine.md` has the theory and the papers.

use crate::findings::Error;
use crate::liba::Bell;
use crate::online::Move;
use crate::real::Real;
use crate::sampling::Sampled;
use crate::state::State;

/// The most impulses of a shaper: two frequencies with four each, or four with two each.
const MOST_IMPULSES: usize = 16;

/// The part of the vibration that the kinds EI and EI2 leave at their frequency: 1/20, as in the papers.
const LEFT: u8 = 20;

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
/// mid-motion, a [`ShaperStream`](super::ShaperStream) shapes it; here it would jump. Before its start and after its end a move is taken to
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

    /// Weights and delays.
    pub(super) fn impulses(&self) -> impl Iterator<Item = (R, R)> {
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
