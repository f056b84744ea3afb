//! Random moves of every kind. The same seed gives the same moves.

use super::{Case, Moment};
use Distribution::*;
use std::marker::PhantomData;
use support::family::{MOST_ARGUMENTS, MOST_BORDERS, MOST_FIELDS};
use support::{Family, Random, Real};

#[derive(Clone, Copy)]
enum Distribution {
    Ordinary, // 2^-7 to 2^7
    /// Ordinary, with a distance at which a few ulps decide the branch of the plan, or whether it has a solution.
    NearlyInfeasible,
    Tiny,     // near the smallest normal number
    Huge,     // near the largest number
    Denormal, // below the smallest normal number
    Wide,     // the magnitude of every argument is different
    /// Small multiples of powers of two, on which much arithmetic is exact and many comparisons are ties.
    BinaryFractions,
    OneSpecial, // all arguments ordinary except one
    Special,    // every second argument special
    Bits,       // any bit pattern
}

const DISTRIBUTIONS: [Distribution; 12] = [
    Ordinary, Ordinary, NearlyInfeasible, NearlyInfeasible, Tiny, Huge, Denormal, Wide, BinaryFractions, OneSpecial,
    Special, Bits,
];

/// The bell comes twice, because it has the most branches.
const FAMILIES: [Family; 6] = [Family::Bell, Family::Bell, Family::Trap, Family::Poly3, Family::Poly5, Family::Poly7];

pub struct Moves<R> {
    random: Random,
    real: PhantomData<R>,
}

impl<R: Real> Moves<R> {
    pub fn new(seed: u64) -> Self {
        Self { random: Random::seeded(seed), real: PhantomData }
    }

    fn arguments(&mut self, family: Family, distribution: Distribution) -> [R; MOST_ARGUMENTS] {
        let names = family.arguments();
        let mut arguments = [R::ZERO; MOST_ARGUMENTS];
        for (argument, name) in arguments.iter_mut().zip(names) {
            let limit = matches!(*name, "jm" | "am" | "vm" | "ts" | "ac" | "de");
            let value = self.value(distribution);
            *argument = if limit || self.random.one_in(2) { value } else { -value };
            if matches!(*name, "v0" | "v1") && self.random.one_in(4) {
                *argument = R::ZERO;
            }
        }
        if let (Family::Trap, [_, ac, de, p0, p1, ..]) = (family, &mut arguments) {
            let backward = if *p1 < *p0 { &mut *ac } else { &mut *de };
            *backward = -*backward;
        }
        match distribution {
            NearlyInfeasible => self.pinch(family, &mut arguments),
            OneSpecial => arguments[self.random.below(names.len())] = self.random.pick(&R::SPECIAL),
            _ => {}
        }
        if self.random.one_in(4) {
            let argument = &mut arguments[self.random.below(names.len())];
            *argument = -*argument;
        }
        if self.random.one_in(8) {
            arguments[self.random.below(names.len())] = arguments[self.random.below(names.len())];
        }
        arguments
    }

    /// Moves the end so that one ramp, or two ramps without cruise, just fit in. A polynomial gets nearly no duration.
    fn pinch(&mut self, family: Family, arguments: &mut [R; MOST_ARGUMENTS]) {
        let wide = arguments.map(R::widen);
        let distance = match family {
            Family::Bell => {
                let [jm, am, vm, _, _, v0, v1, ..] = wide;
                let ramp = |from: f64, to: f64| {
                    let dv = (to - from).abs();
                    let duration = if dv * jm < am * am { 2.0 * (dv / jm).sqrt() } else { am / jm + dv / am };
                    0.5 * (from + to) * duration
                };
                let (v0, v1) = (v0.clamp(-vm, vm), v1.clamp(-vm, vm));
                if self.random.one_in(2) { ramp(v0, v1) } else { ramp(v0, vm) + ramp(vm, v1) }
            }
            Family::Trap => {
                let [vm, ac, de, _, _, v0, v1, ..] = wide;
                let ramp = |from: f64, to: f64, rate: f64| (to * to - from * from) / (2.0 * rate);
                match self.random.below(3) {
                    0 => ramp(v0, v1, ac),
                    1 => ramp(v0, v1, de),
                    _ => ramp(v0, vm, ac) + ramp(vm, v1, de),
                }
            }
            Family::Poly3 | Family::Poly5 | Family::Poly7 => {
                arguments[0] = R::of(self.random.binade(-60, -7));
                return;
            }
        };
        if self.random.one_in(2) {
            arguments[3] = R::ZERO;
        }
        arguments[4] = R::of(arguments[3].widen() + distance).neighbour(self.random.steps(3));
    }

    fn before(&mut self, distribution: Distribution, read: bool) -> [R; MOST_FIELDS] {
        if !read && !self.random.one_in(2) {
            return [R::ZERO; MOST_FIELDS];
        }
        [(); MOST_FIELDS].map(|()| {
            let value = self.value(distribution);
            if self.random.one_in(4) { -value } else { value }
        })
    }

    fn moment(&mut self) -> Moment<R> {
        match self.random.below(8) {
            0..=2 => Moment::Fraction(R::of(1.2 * self.random.unit() - 0.1)),
            3..=6 => Moment::Border { index: self.random.below(MOST_BORDERS), steps: self.random.steps(2) },
            _ => {
                let distribution = self.random.pick(&DISTRIBUTIONS);
                Moment::At(self.value(distribution))
            }
        }
    }

    fn value(&mut self, distribution: Distribution) -> R {
        let random = &mut self.random;
        let (lowest, highest) = R::EXPONENTS;
        match distribution {
            Ordinary | NearlyInfeasible | OneSpecial => R::of(random.binade(-7, 7)),
            Tiny => R::of(random.binade(lowest, lowest * 3 / 4)),
            Huge => R::of(random.binade(highest * 3 / 4, highest)),
            Denormal => {
                let shortened = random.below(R::SIGNIFICAND_BITS as usize) as u32;
                R::from_low_bits(random.bits() >> (64 - R::SIGNIFICAND_BITS + shortened))
            }
            Wide => R::of(random.binade(lowest, highest)),
            BinaryFractions => R::of(random.below(65) as f64 / f64::from(1 << random.below(5))),
            Special if random.one_in(2) => random.pick(&R::SPECIAL),
            Special => R::of(random.binade(-7, 7)),
            Bits => R::from_low_bits(random.bits()),
        }
    }
}

impl<R: Real> Iterator for Moves<R> {
    type Item = Case<R>;

    fn next(&mut self) -> Option<Case<R>> {
        let family = self.random.pick(&FAMILIES);
        let distribution = self.random.pick(&DISTRIBUTIONS);
        let only_evaluated = !family.is_polynomial() && self.random.one_in(8);
        let arguments = self.arguments(family, distribution);
        let before = self.before(distribution, only_evaluated);
        let moments = std::array::from_fn(|_| self.moment());
        Some(Case { family, arguments, before, planned: !only_evaluated, moments })
    }
}
