//! Random moves of every kind, the same ones for the same seed.

use crate::common::random::Random;
use crate::comparison::{Case, Moment};
use crate::family::{Family, MOST_ARGUMENTS, MOST_FIELDS};
use crate::real::OracleReal;
use std::marker::PhantomData;

/// What the numbers of a move are like.
#[derive(Clone, Copy)]
enum Distribution {
    /// 2^-7 to 2^7.
    Ordinary,
    /// Ordinary, with a distance within a few roundings of where the plan takes another branch or has no solution.
    NearlyInfeasible,
    /// Near the smallest normal number.
    Tiny,
    /// Near the largest number.
    Huge,
    /// Below the smallest normal number.
    Denormal,
    /// Every argument of another magnitude.
    Wide,
    /// Small multiples of powers of two, on which much arithmetic is exact and many comparisons are ties.
    BinaryFractions,
    /// Ordinary but for one argument.
    OneSpecial,
    /// Every second argument special.
    Special,
    /// Any bit pattern.
    Bits,
}

const DISTRIBUTIONS: [Distribution; 12] = [
    Distribution::Ordinary,
    Distribution::Ordinary,
    Distribution::NearlyInfeasible,
    Distribution::NearlyInfeasible,
    Distribution::Tiny,
    Distribution::Huge,
    Distribution::Denormal,
    Distribution::Wide,
    Distribution::BinaryFractions,
    Distribution::OneSpecial,
    Distribution::Special,
    Distribution::Bits,
];

/// The bell twice, because it has the most branches.
const FAMILIES: [Family; 6] = [
    Family::Bell,
    Family::Bell,
    Family::Trap,
    Family::Poly3,
    Family::Poly5,
    Family::Poly7,
];

/// An endless sequence of cases.
pub struct Moves<R> {
    random: Random,
    real: PhantomData<R>,
}

impl<R: OracleReal> Moves<R> {
    /// The sequence that belongs to `seed`.
    pub fn new(seed: u64) -> Self {
        Self {
            random: Random::seeded(seed),
            real: PhantomData,
        }
    }

    fn case(&mut self) -> Case<R> {
        let family = self.random.pick(&FAMILIES);
        let distribution = self.random.pick(&DISTRIBUTIONS);
        let only_evaluated = matches!(family, Family::Bell | Family::Trap) && self.random.one_in(8);
        Case {
            family,
            arguments: self.arguments(family, distribution),
            before: self.before(distribution, only_evaluated),
            planned: !only_evaluated,
            moments: std::array::from_fn(|_| self.moment()),
        }
    }

    fn arguments(&mut self, family: Family, distribution: Distribution) -> [R; MOST_ARGUMENTS] {
        let zero = R::from(0);
        let names = family.arguments();
        let mut arguments = [zero; MOST_ARGUMENTS];
        for (argument, name) in arguments.iter_mut().zip(names) {
            let limit = matches!(*name, "jm" | "am" | "vm" | "ts" | "ac" | "de");
            let value = self.value(distribution);
            *argument = if limit || self.random.one_in(2) {
                value
            } else {
                -value
            };
            if matches!(*name, "v0" | "v1") && self.random.one_in(4) {
                *argument = zero;
            }
        }
        if let (Family::Trap, [_, ac, de, p0, p1, ..]) = (family, &mut arguments) {
            let backward = if *p1 < *p0 { &mut *ac } else { &mut *de };
            *backward = -*backward;
        }
        match distribution {
            Distribution::NearlyInfeasible => self.pinch(family, &mut arguments),
            Distribution::OneSpecial => {
                arguments[self.random.below(names.len())] = self.random.pick(&R::SPECIAL);
            }
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

    /// Moves the end to where a ramp, or two ramps without cruise, just fit in. The duration of a polynomial becomes
    /// nearly nothing.
    fn pinch(&mut self, family: Family, arguments: &mut [R; MOST_ARGUMENTS]) {
        let wide = arguments.map(R::widen);
        let distance = match family {
            Family::Bell => {
                let [jm, am, vm, _, _, v0, v1, ..] = wide;
                let ramp = |from: f64, to: f64| {
                    let dv = (to - from).abs();
                    let duration = if dv * jm < am * am {
                        2.0 * (dv / jm).sqrt()
                    } else {
                        am / jm + dv / am
                    };
                    0.5 * (from + to) * duration
                };
                let (v0, v1) = (v0.clamp(-vm, vm), v1.clamp(-vm, vm));
                if self.random.one_in(2) {
                    ramp(v0, v1)
                } else {
                    ramp(v0, vm) + ramp(vm, v1)
                }
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
                arguments[0] = R::round(self.random.binade(-60, -7));
                return;
            }
        };
        if self.random.one_in(2) {
            arguments[3] = R::from(0);
        }
        let near = R::round(arguments[3].widen() + distance);
        arguments[4] = near.neighbour(self.random.steps(3));
    }

    fn before(&mut self, distribution: Distribution, read: bool) -> [R; MOST_FIELDS] {
        let mut before = [R::from(0); MOST_FIELDS];
        if read || self.random.one_in(2) {
            for field in &mut before {
                *field = self.value(distribution);
                if self.random.one_in(4) {
                    *field = -*field;
                }
            }
        }
        before
    }

    fn moment(&mut self) -> Moment<R> {
        match self.random.below(8) {
            0..=2 => Moment::Fraction(R::round(1.2 * self.random.unit() - 0.1)),
            3..=6 => Moment::Border {
                index: self.random.below(Moment::<R>::BORDERS),
                steps: self.random.steps(2),
            },
            _ => {
                let distribution = self.random.pick(&DISTRIBUTIONS);
                Moment::At(self.value(distribution))
            }
        }
    }

    /// A number of this kind; positive but where it is special or any bit pattern.
    fn value(&mut self, distribution: Distribution) -> R {
        let random = &mut self.random;
        let (lowest, highest) = R::EXPONENTS;
        match distribution {
            Distribution::Ordinary | Distribution::NearlyInfeasible | Distribution::OneSpecial => {
                R::round(random.binade(-7, 7))
            }
            Distribution::Tiny => R::round(random.binade(lowest, lowest * 3 / 4)),
            Distribution::Huge => R::round(random.binade(highest * 3 / 4, highest)),
            Distribution::Denormal => {
                let shortened = random.below(R::SIGNIFICAND_BITS as usize) as u32;
                R::from_low_bits(random.bits() >> (64 - R::SIGNIFICAND_BITS + shortened))
            }
            Distribution::Wide => R::round(random.binade(lowest, highest)),
            Distribution::BinaryFractions => {
                R::round(random.below(65) as f64 / f64::from(1 << random.below(5)))
            }
            Distribution::Special if random.one_in(2) => random.pick(&R::SPECIAL),
            Distribution::Special => R::round(random.binade(-7, 7)),
            Distribution::Bits => R::from_low_bits(random.bits()),
        }
    }
}

impl<R: OracleReal> Iterator for Moves<R> {
    type Item = Case<R>;

    fn next(&mut self) -> Option<Case<R>> {
        Some(self.case())
    }
}

impl Random {
    /// Seeds one apart give sequences that have nothing in common.
    fn seeded(seed: u64) -> Self {
        let mut seeding = Self(seed);
        seeding.bits();
        Self(seeding.bits() ^ seed.rotate_left(32))
    }

    /// `0..n`
    fn below(&mut self, n: usize) -> usize {
        ((u128::from(self.bits()) * n as u128) >> 64) as usize
    }

    fn one_in(&mut self, n: usize) -> bool {
        self.below(n) == 0
    }

    /// `-most..=most`
    fn steps(&mut self, most: i8) -> i8 {
        self.below(2 * most as usize + 1) as i8 - most
    }

    /// `0..1`
    fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 * (0.5 * f64::EPSILON)
    }

    /// Any significand with an exponent in `lowest..=highest`.
    fn binade(&mut self, lowest: i32, highest: i32) -> f64 {
        let exponent = lowest + self.below((highest - lowest + 1) as usize) as i32;
        f64::from_bits(((exponent + 1023) as u64) << 52 | self.bits() >> 12)
    }
}
