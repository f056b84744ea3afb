//! Random numbers for moves.

/// SplitMix64: the same numbers from the same seed on every machine.
#[derive(Default)]
pub struct Random(pub u64);

impl Random {
    /// Seeds one apart give sequences that have nothing in common.
    pub fn seeded(seed: u64) -> Self {
        let mut seeding = Self(seed);
        seeding.bits();
        Self(seeding.bits() ^ seed.rotate_left(32))
    }

    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    pub fn below(&mut self, n: usize) -> usize {
        ((u128::from(self.bits()) * n as u128) >> 64) as usize
    }

    pub fn one_in(&mut self, n: usize) -> bool {
        self.below(n) == 0
    }

    /// `-most..=most`
    pub fn steps(&mut self, most: i8) -> i8 {
        self.below(2 * most as usize + 1) as i8 - most
    }

    pub fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 * (0.5 * f64::EPSILON)
    }

    pub fn between(&mut self, lo: f64, hi: f64) -> f64 {
        lo + (hi - lo) * self.unit()
    }

    /// Evenly spread in its logarithm over `10^lo..10^hi`.
    pub fn magnitude(&mut self, lo: f64, hi: f64) -> f64 {
        10f64.powf(self.between(lo, hi))
    }

    /// Any significand with an exponent in `lowest..=highest`.
    pub fn binade(&mut self, lowest: i32, highest: i32) -> f64 {
        let exponent = lowest + self.below((highest - lowest + 1) as usize) as i32;
        f64::from_bits(((exponent + 1023) as u64) << 52 | self.bits() >> 12)
    }

    pub fn sign(&mut self) -> f64 {
        if self.bits() & 1 == 0 { -1.0 } else { 1.0 }
    }

    pub fn pick<T: Copy>(&mut self, choices: &[T]) -> T {
        choices[(self.bits() % choices.len() as u64) as usize]
    }
}
