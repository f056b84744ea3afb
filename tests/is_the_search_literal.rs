//! Does the search without cruise pass over its plain rounds without changing a bit? Against the literal contract, with
//! moves made so that a round of the search is a near tie, or lies at the border of what is passed over at all.

mod common;
#[allow(dead_code, clippy::neg_cmp_op_on_partial_ord)] // literal on purpose, and it tells more than this test asks
#[path = "oracle/src/reference.rs"]
mod reference;

use atraj::{Bell, Boundary};
use common::GoldenReal;

const MOVES: u32 = 300_000;

/// What the moves are made with: computed in binary64, then scaled and rounded to the type under test.
trait Scaled: GoldenReal {
    /// Powers of two that bring an argument to a border of the range, or of what the search passes over.
    const EXTREMES: [i32; 6];
    /// The highest power of two that a unit of time and length changes by.
    const UNITS: i32;
    /// `x * 2^exponent`
    fn scaled(x: f64, exponent: i32) -> Self;
    fn special() -> [Self; 6];
}
impl Scaled for f32 {
    const EXTREMES: [i32; 6] = [-140, -110, -22, 23, 46, 100];
    const UNITS: i32 = 75;
    fn scaled(x: f64, exponent: i32) -> Self {
        (x * 2f64.powi(exponent)) as f32
    }
    fn special() -> [Self; 6] {
        [0.0, -0.0, f32::INFINITY, f32::NAN, 1e-45, f32::MAX]
    }
}
impl Scaled for f64 {
    const EXTREMES: [i32; 6] = [-1060, -900, -51, 52, 104, 900];
    const UNITS: i32 = 550;
    fn scaled(x: f64, exponent: i32) -> Self {
        // In two steps: the factor alone may be out of range.
        x * 2f64.powi(exponent / 2) * 2f64.powi(exponent - exponent / 2)
    }
    fn special() -> [Self; 6] {
        [0.0, -0.0, f64::INFINITY, f64::NAN, 5e-324, f64::MAX]
    }
}

struct Random(common::random::Random);

impl Random {
    fn below(&mut self, n: u64) -> u64 {
        self.0.bits() % n
    }
    fn unit(&mut self) -> f64 {
        self.0.between(0.0, 1.0)
    }
    fn one_of<T: Copy, const N: usize>(&mut self, from: [T; N]) -> T {
        from[self.below(N as u64) as usize]
    }
    /// Any significand, a small fraction or a power of two, up to `2^exponent`.
    fn magnitude(&mut self, exponent: i32) -> f64 {
        let scale = 2f64.powi(self.below(2 * exponent as u64) as i32 - exponent);
        match self.below(4) {
            0 => (1 + self.below(16)) as f64 / 4.0,
            1 => scale,
            _ => (1.0 + self.unit()) * scale,
        }
    }
    fn velocity(&mut self, vm: f64) -> f64 {
        match self.below(4) {
            0 => 0.0,
            1 => vm * (self.below(9) as f64 / 4.0 - 1.0),
            _ => vm * (2.0 * self.unit() - 1.0),
        }
    }
}

/// `jm am vm p0 p1 v0 v1` of a move whose distance makes the round at a trial acceleration, one of those that the search
/// passes, a tie but for a relative difference from 1 down to nothing.
fn near_tie(random: &mut Random) -> [f64; 7] {
    let jm = random.magnitude(8);
    let am = random.magnitude(8);
    let vm = random.magnitude(8);
    let v0 = random.velocity(vm);
    let v1 = match random.below(4) {
        0 => v0,
        1 => v0 * (1.0 + random.magnitude(40)),
        _ => random.velocity(vm),
    };
    let trial = am * (1 + random.below(32)) as f64 / 2f64.powi(5 + random.below(6) as i32);
    let (s, w, k) = (v0 + v1, (v0 - v1).abs(), trial * trial / jm);
    let twice_p_trial = match random.below(2) {
        0 => w * s - w * k,
        _ => w * s + k * (4.0 * k + 4.0 * s + 3.0 * w),
    };
    let off = 2f64.powi(-(random.below(60) as i32)) * random.one_of([-1.0, 0.0, 1.0]);
    let p = twice_p_trial / (2.0 * trial) * (1.0 + off);
    // A short way does not cruise anyway; a high `vm` sees to it.
    let vm = if random.below(2) == 0 { vm } else { 1e6 * vm };
    let p0 = random.one_of([0.0, 0.0, 1.0, -p]);
    [jm, am, vm, p0, p0 + p, v0, v1]
}

fn same_bits_as_the_contract<R: Scaled>() {
    let mut random = Random(common::random::Random(1));
    let mut long = 0;
    for _ in 0..MOVES {
        let extreme = random.one_of(R::EXTREMES) + random.below(12) as i32;
        let unit = random.below(2 * R::UNITS as u64) as i32 - R::UNITS;
        let odd = random.below(7) as usize;
        let exponents = match random.below(6) {
            // Another unit of length and time: the squares of velocities come near overflow or underflow, `am` does not.
            0 => [-1, 0, 1, 2, 2, 1, 1].map(|power| power * unit),
            1 => [extreme; 7],
            2 => std::array::from_fn(|index| if index == odd { extreme } else { 0 }),
            _ => [0; 7],
        };
        let near_tie = near_tie(&mut random);
        let mut arguments: [R; 7] =
            std::array::from_fn(|index| R::scaled(near_tie[index], exponents[index]));
        if random.below(16) == 0 {
            arguments[random.below(7) as usize] = random.one_of(R::special());
        }
        if random.below(4) == 0 {
            for argument in &mut arguments[3..] {
                *argument = -*argument;
            }
        }

        let [jm, am, vm, p0, p1, v0, v1] = arguments;
        let mut ours = Bell::default();
        let duration = ours.plan(jm, am, vm, Boundary { p0, p1, v0, v1 });
        let mut literal = Bell::default();
        let plan = reference::plan(&mut literal, arguments);
        long += u32::from(plan.rounds > 3);

        let written = fields(&ours).into_iter().zip(fields(&literal));
        let pairs = written.chain([(duration.unwrap_or(R::from(0)), plan.duration)]);
        for (index, (ours, literal)) in pairs.enumerate() {
            assert!(
                ours.same(literal),
                "field {index}: {} is not {} of {arguments:?}, {} rounds",
                ours.show(),
                literal.show(),
                plan.rounds,
            );
        }
    }
    assert!(
        long > MOVES / 10,
        "only {long} searches longer than 3 rounds"
    );
}

fn fields<R: Copy>(bell: &Bell<R>) -> [R; 14] {
    let Bell {
        t,
        tv,
        ta,
        td,
        taj,
        tdj,
        p0,
        p1,
        v0,
        v1,
        vm,
        jm,
        am,
        dm,
    } = *bell;
    [t, tv, ta, td, taj, tdj, p0, p1, v0, v1, vm, jm, am, dm]
}

#[test]
fn same_bits_as_the_contract_f32() {
    same_bits_as_the_contract::<f32>();
}

#[test]
fn same_bits_as_the_contract_f64() {
    same_bits_as_the_contract::<f64>();
}
