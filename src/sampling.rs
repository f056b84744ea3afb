//! Evaluation at evenly spaced times, with the bits of the single calls.
//!
//! Sample `k` is taken at `x0 + k*dt`: `k` is converted, multiplied and added with one rounding each. Each of these steps
//! is monotone. The times are therefore monotone too, and a comparison of time with a constant changes its result at most once
//! in a sweep. Between two such changes every sample takes the same path through the profile, in a loop without branches.

use crate::real::{Real, processor, target};
use core::ops::Range;

/// A profile whose motion changes at borders in time.
pub(crate) trait Sampled<R: Real, const QUANTITIES: usize, const BORDERS: usize> {
    /// Everything that an evaluation compares times with.
    fn borders(&self) -> [Edge<R>; BORDERS];

    /// Position, velocity, acceleration and, if the profile has it, jerk at time `x`, s: a call each.
    fn each(&self, x: R) -> [R; QUANTITIES];

    /// The quantities at time `x`, computed in one place for every phase: fast and large.
    fn together(&self, x: R) -> [R; QUANTITIES];

    /// The quantities at time `x`, in the way that suits the processor.
    #[inline(always)]
    fn state(&self, x: R) -> [R; QUANTITIES] {
        target::state(|| self.each(x), || self.together(x))
    }

    /// Fills `run`, whose times all lie between the same borders.
    fn fill(&self, run: Run<'_, R, QUANTITIES>);
}

/// `$value` with the constant `$PHASE` in the place of `$phase`, compiled for each of these phases. A loop over such a value has no branches.
macro_rules! in_phase {
    ($phase:expr, $PHASE:ident of $($name:ident)+ => $value:expr) => {
        match $phase {
            $(Phase::$name => {
                const $PHASE: Phase = Phase::$name;
                $value
            })+
        }
    };
}
pub(crate) use in_phase;

/// What a profile with so many quantities makes of its `state`.
macro_rules! states {
    ($QUANTITIES:literal) => {
        /// Position, velocity and acceleration at time `x`, s: the start of another plan.
        pub fn state_at(&self, x: R) -> $crate::state::State<R> {
            let [position, velocity, acceleration, ..] = self.state(x);
            $crate::state::State { position, velocity, acceleration }
        }

        /// The states at the times `x0`, `x0 + dt`, `x0 + 2*dt`, …, s.
        pub fn states(&self, x0: R, dt: R) -> impl Iterator<Item = [R; $QUANTITIES]> {
            let sweep = $crate::sampling::Sweep { x0, dt };
            (0..i32::MAX).map(move |k| self.state(sweep.time(k)))
        }
    };
}
pub(crate) use states;

/// What a profile with borders has for its quantities: their number and their names.
macro_rules! sampled {
    ($QUANTITIES:literal, $quantities:literal) => {
        #[doc = concat!($quantities, " at time `x`, s.")]
        #[inline(always)]
        pub fn state(&self, x: R) -> [R; $QUANTITIES] {
            $crate::sampling::Sampled::state(self, x)
        }

        $crate::sampling::states! { $QUANTITIES }

        /// Writes the quantities of `state` at the times `x0`, `x0 + dt`, `x0 + 2*dt`, …, s, with the bits of the single calls. Each output is
        /// filled to its own end and may be empty.
        ///
        /// Returns the number of samples: the length of the longest output, but at most `i32::MAX`.
        pub fn sample_into(&self, x0: R, dt: R, outputs: [&mut [R]; $QUANTITIES]) -> usize {
            $crate::sampling::Sweep { x0, dt }.sample(self, outputs)
        }
    };
}
pub(crate) use sampled;

/// Samples are numbered in 32 bits, which processors convert to reals fastest.
pub(crate) const MOST_SAMPLES: usize = i32::MAX as usize;

#[derive(Clone, Copy)]
pub(crate) struct Sweep<R> {
    /// Time of sample 0, s.
    pub x0: R,
    /// From one sample to the next, s.
    pub dt: R,
}

impl<R: Real> Sweep<R> {
    /// Samples in the longest vector of common processors.
    const VECTOR: i32 = (processor::VECTOR_BYTES / size_of::<R>()) as i32;

    /// It does not pay to look for runs in fewer samples.
    const FEW: i32 = 32;

    /// Fills every output to its end, run by run; the number of samples. Where too few samples are alike for a loop, it takes them one by one.
    pub fn sample<const N: usize, const B: usize>(
        self, profile: &impl Sampled<R, N, B>, mut outputs: [&mut [R]; N],
    ) -> usize {
        let borders = profile.borders();
        let count = Self::count(&outputs);
        if target::samples_are_few(count, Self::FEW) {
            self.sample_each(0..count, &mut outputs, profile);
            return count as usize;
        }
        let rate = R::ONE / self.dt;
        let crossings = sorted(borders.map(|border| self.crossing(border, rate, count)));
        let mut start = 0;
        for end in crossings.into_iter().chain([count]) {
            if target::samples_are_few(end - start, Self::VECTOR) {
                self.sample_each(start..end, &mut outputs, profile);
            } else {
                profile.fill(self.run(start..end, &mut outputs));
            }
            start = end;
        }
        count as usize
    }

    /// Fills every output of a profile without borders to its end; the number of samples.
    #[inline(always)]
    pub fn fill<const N: usize>(self, mut outputs: [&mut [R]; N], state: impl Fn(R) -> [R; N]) -> usize {
        let count = Self::count(&outputs);
        self.run(0..count, &mut outputs).fill(state);
        count as usize
    }

    fn count<const N: usize>(outputs: &[&mut [R]; N]) -> i32 {
        let longest = outputs.iter().map(|output| output.len()).max();
        longest.unwrap_or(0).min(MOST_SAMPLES) as i32
    }

    fn run<'a, const N: usize>(self, numbers: Range<i32>, outputs: &'a mut [&mut [R]; N]) -> Run<'a, R, N> {
        let Range { start, end } = numbers;
        Run {
            sweep: self,
            x: self.time(start),
            start,
            outputs: outputs.each_mut().map(|output| {
                let end = output.len().min(end as usize);
                output.get_mut(start as usize..end).unwrap_or_default()
            }),
        }
    }

    // A separate function keeps this loop out of the way of the fast ones.
    #[inline(never)]
    fn sample_each<const N: usize, const B: usize>(
        self, numbers: Range<i32>, outputs: &mut [&mut [R]; N], profile: &impl Sampled<R, N, B>,
    ) {
        for k in numbers {
            for (output, value) in outputs.iter_mut().zip(profile.state(self.time(k))) {
                if let Some(y) = output.get_mut(k as usize) {
                    *y = value;
                }
            }
        }
    }

    /// The first of `count` samples beyond `border`, seen from sample 0, or `count`. `rate` is `1/dt`.
    fn crossing(self, border: Edge<R>, rate: R, count: i32) -> i32 {
        let first = border.is_ahead(self.time(0));
        let is_same = |k| border.is_ahead(self.time(k)) == first;
        let last = count - 1;
        if is_same(last) {
            return count;
        }
        let narrow = |(same, crossed), probe| {
            if probe <= same || crossed <= probe {
                (same, crossed)
            } else if is_same(probe) {
                (probe, crossed)
            } else {
                (same, probe)
            }
        };
        // The border is the crossing up to rounding. Halving finds the crossing wherever it is.
        let guess = ((border.time() - self.x0) * rate).to_index();
        let mut range = narrow((0, last), guess);
        let neighbour = if range.1 == guess { guess - 1 } else { guess.saturating_add(1) };
        range = narrow(range, neighbour);
        while range.1 - range.0 > 1 {
            range = narrow(range, range.0 + (range.1 - range.0) / 2);
        }
        range.1
    }

    #[inline(always)]
    fn fill_one(self, start: i32, output: &mut [R], value: impl Fn(R) -> Option<R>) {
        for (y, k) in output.iter_mut().zip(start..) {
            if let Some(value) = value(self.time(k)) {
                *y = value;
            }
        }
    }

    /// Time of sample `k`, s.
    #[inline(always)]
    pub fn time(self, k: i32) -> R {
        self.x0 + R::from_index(k) * self.dt
    }
}

/// The numbers in ascending order. They come nearly in order, or nearly in the opposite one.
fn sorted<const N: usize>(mut numbers: [i32; N]) -> [i32; N] {
    for end in 1..N {
        for place in (0..end).rev() {
            match numbers.get_mut(place..) {
                Some([one, other, ..]) if *one > *other => core::mem::swap(one, other),
                _ => break,
            }
        }
    }
    numbers
}

/// A comparison of time with a constant: true before it, false after it and for a NaN.
#[derive(Clone, Copy)]
pub(crate) enum Edge<R> {
    /// `x < border`
    Below(R),
    /// `x <= border`
    UpTo(R),
}

impl<R: Real> Edge<R> {
    fn is_ahead(self, x: R) -> bool {
        match self {
            Self::Below(border) => x < border,
            Self::UpTo(border) => x <= border,
        }
    }

    pub(crate) fn time(self) -> R {
        match self {
            Self::Below(border) | Self::UpTo(border) => border,
        }
    }
}

/// Neighbouring samples between the same borders, and the outputs for them.
pub(crate) struct Run<'a, R, const N: usize> {
    sweep: Sweep<R>,
    /// A time between these borders.
    pub x: R,
    start: i32,
    /// Position, velocity, acceleration and, if the profile has it, jerk; empty where not wanted.
    outputs: [&'a mut [R]; N],
}

impl<R: Real, const N: usize> Run<'_, R, N> {
    /// Fills the outputs with the states at their times.
    #[inline(always)]
    pub fn fill(self, state: impl Fn(R) -> [R; N]) {
        let len = self.outputs.first().map_or(0, |output| output.len());
        let alike = self.outputs.iter().all(|output| output.len() == len);
        let Self { sweep, start, mut outputs, .. } = self;
        match outputs.as_mut_slice() {
            // One loop computes each time once.
            [p, v, a] if alike => {
                let outputs = p.iter_mut().zip(v.iter_mut()).zip(a.iter_mut());
                for (((p, v), a), k) in outputs.zip(start..) {
                    if let [position, velocity, acceleration] = state(sweep.time(k))[..] {
                        (*p, *v, *a) = (position, velocity, acceleration);
                    }
                }
            }
            [p, v, a, j] if alike => {
                let outputs = p.iter_mut().zip(v.iter_mut()).zip(a.iter_mut()).zip(j.iter_mut());
                for ((((p, v), a), j), k) in outputs.zip(start..) {
                    if let [position, velocity, acceleration, jerk] = state(sweep.time(k))[..] {
                        (*p, *v, *a, *j) = (position, velocity, acceleration, jerk);
                    }
                }
            }
            [p, v, a, j @ ..] => {
                sweep.fill_one(start, p, |x| state(x).first().copied());
                sweep.fill_one(start, v, |x| state(x).get(1).copied());
                sweep.fill_one(start, a, |x| state(x).get(2).copied());
                for j in j {
                    sweep.fill_one(start, j, |x| state(x).get(3).copied());
                }
            }
            _ => {}
        }
    }
}
