//! Are moves of several axes, and the findings of a check, the same in other units of length and time and in the other direction?
//!
//! `is_the_fastest_motion_right` asks this of the plans of one axis, and `is_golden_data_met` keeps the bits of the profiles of liba.

use Field::{Of, Time};
use approx::assert_abs_diff_eq;
use support::online::{limits_of, numbers_of};
use support::prelude::*;
use support::profiles::{bell, bell_fields, trap, trap_fields};

const TOLERANCE: f64 = 1e-9; // relative to the largest number that a value is computed from

/// Other units of length and time, and perhaps the other direction. A power of two scales without rounding.
#[derive(Clone, Copy, Debug)]
struct Units {
    length: f64,
    time: f64,
}

impl Units {
    fn of(self, order: i32, x: f64) -> f64 {
        x * (self.length / self.time.powi(order))
    }

    fn of_state(self, state: &State<f64>) -> State<f64> {
        let State { position, velocity, acceleration } = *state;
        online::state_of([self.of(0, position), self.of(1, velocity), self.of(2, acceleration)])
    }

    fn of_move(self, axis: &Move<f64>) -> Move<f64> {
        let mut scaled = *axis;
        scaled.t *= self.time;
        for phase in &mut scaled.phase {
            phase.start *= self.time;
            phase.duration *= self.time;
            phase.position = self.of(0, phase.position);
            phase.velocity = self.of(1, phase.velocity);
            phase.acceleration = self.of(2, phase.acceleration);
            phase.jerk = self.of(3, phase.jerk);
        }
        scaled
    }
}

#[derive(Clone, Debug)]
struct Set {
    limits: Vec<Limits<f64>>,
    ends: [Vec<State<f64>>; 2],
}

impl Set {
    fn random(random: &mut Random, is_straight: bool) -> Self {
        let count = 1 + random.below(4);
        let lead = online::limits(random);
        let leads = [(); 2].map(|()| online::inside(random, &lead));
        let (mut limits, mut ends) = (vec![lead], leads.map(|end| vec![end]));
        for _ in 1..count {
            let (share, offset) = (random.sign() * random.magnitude(-3.0, 0.0), random.magnitude(-1.0, 6.0));
            let own = online::limits(random);
            let [vmax, v, amax, a, jmax, j] = numbers_of(&lead).map(f64::abs);
            let [v, a, j] = [vmax.max(v), amax.max(a), jmax.max(j)];
            let wide = [v, -v, a, -a, j, -j].map(|limit| limit * random.magnitude(0.0, 1.0));
            limits.push(if is_straight { limits_of(wide) } else { own });
            for (end, lead) in ends.iter_mut().zip(leads) {
                let factor = nearly_1(random, -17.0);
                let State { position, velocity, acceleration } = lead;
                let on_line =
                    online::state_of([offset + share * position, share * velocity * factor, share * acceleration]);
                end.push(if is_straight { on_line } else { online::inside(random, &own) });
            }
        }
        Self { limits, ends }
    }

    fn scaled(&self, units: Units) -> Self {
        let limits = |limits: &Limits<f64>| {
            let orders = [1, 1, 2, 2, 3, 3].into_iter().zip(numbers_of(limits));
            let mut scaled: Vec<_> = orders.map(|(order, x)| units.of(order, x)).collect();
            if units.length < 0.0 {
                scaled.chunks_mut(2).for_each(<[f64]>::reverse);
            }
            limits_of(scaled.try_into().expect("six limits"))
        };
        Self {
            limits: self.limits.iter().map(limits).collect(),
            ends: self.ends.clone().map(|ends| ends.iter().map(|end| units.of_state(end)).collect()),
        }
    }

    fn plan(&self, is_straight: bool, duration: f64, cycle: f64) -> Result<Vec<Move<f64>>, Error> {
        let mut axes = vec![Move::default(); self.limits.len()];
        let [from, to] = &self.ends;
        let plan = if is_straight { line } else { synchronise };
        plan(&mut axes, &self.limits, from, to, duration, cycle).map(|_| axes)
    }
}

/// A factor that is `10^least` to `10^-9` off 1.
fn nearly_1(random: &mut Random, least: f64) -> f64 {
    1.0 + random.sign() * random.magnitude(least, -9.0)
}

fn any_units(random: &mut Random) -> Units {
    let mut power = || f64::exp2(random.between(-9.0, 9.0).round());
    let (length, time) = (power(), power());
    Units { length: random.sign() * length, time }
}

fn assert_alike(near: &[Move<f64>], far: &[Move<f64>]) {
    for (one, other) in near.iter().zip(far) {
        assert_eq!(one.t, other.t);
        let phases = one.phases().iter();
        let most = |number: fn(&Phase<f64>) -> f64| phases.clone().map(|x| number(x).abs()).fold(0.0, f64::max);
        let (jerk, a, v) = (most(|phase| phase.jerk), most(|phase| phase.acceleration), most(|phase| phase.velocity));
        let a = a + jerk * one.t;
        let v = v + a * one.t;
        let p = most(|phase| phase.position) + v * one.t;
        for part in 0..=16 {
            let x = one.t * f64::from(part) / 16.0;
            let [one, other] = [one, other].map(|axis| online::numbers_of_state(axis.state_at(x)));
            for ((x, y), scale) in one.into_iter().zip(other).zip([p, v, a]) {
                assert_abs_diff_eq!(x, y, epsilon = TOLERANCE * scale);
            }
        }
    }
}

/// Both are refused alike, or the far axes move as the near ones do.
fn assert_scaled_alike(units: Units, near: &Result<Vec<Move<f64>>, Error>, far: Result<Vec<Move<f64>>, Error>) {
    let near = near.clone().map(|axes| axes.iter().map(|axis| units.of_move(axis)).collect::<Vec<_>>());
    match (near, far) {
        (Ok(near), Ok(far)) if units.length < 0.0 => assert_alike(&near, &far),
        (near, far) => assert_eq!(near, far, "{units:?}"),
    }
}

fn stopped(mut axes: Vec<Move<f64>>, limits: &[Limits<f64>], x: f64) -> Result<Vec<Move<f64>>, Error> {
    line_stop(&mut axes, limits, x).map(|_| axes)
}

/// Several axes move and stop alike in other units, or are refused alike. Mirrored, they do up to rounding: the mean is counted from the other motion.
#[test]
fn several_axes() {
    let mut random = Random::seeded(9);
    let (mut planned, mut stops) = ([0; 2], 0);
    for k in 0..8_000 {
        let is_straight = k % 2 == 0;
        let set = Set::random(&mut random, is_straight);
        let units = any_units(&mut random);
        let duration = random.pick(&[0.0, 0.0, 1.0, 10.0, 100.0]);
        let fastest = set.plan(is_straight, duration, 0.0);
        // The fastest motion misses a tick by little.
        let factor = 1.0 + random.sign() * random.magnitude(-17.0, -3.0);
        let tick = fastest.map_or(1.0, |axes| axes[0].t * factor) / (1 + random.below(1_000)) as f64;
        let cycle = random.pick(&[0.0, tick]);
        let scaled = set.scaled(units);
        let near = set.plan(is_straight, duration, cycle);
        let far = scaled.plan(is_straight, units.time * duration, units.time * cycle);
        assert_scaled_alike(units, &near, far);
        let Ok(mut axes) = near else { continue };
        planned[k % 2] += 1;
        if is_straight {
            let x = axes[0].t * random.between(-0.1, 1.1);
            let axis = random.below(axes.len());
            let phase = &mut axes[axis].phase[random.below(3)];
            phase.velocity *= nearly_1(&mut random, -17.0);
            let far: Vec<_> = axes.iter().map(|axis| units.of_move(axis)).collect();
            let near = stopped(axes, &set.limits, x);
            stops += u32::from(near.is_ok());
            assert_scaled_alike(units, &near, stopped(far, &scaled.limits, units.time * x));
        }
    }
    assert!(stops > 300 && stops < planned[0] && planned[0] > 500 && planned[1] > 3_000, "{planned:?} {stops}");
}

/// A move of which a number is changed by some ulps has the same findings in other units.
#[test]
fn spoiled_moves() {
    let mut random = Random::seeded(10);
    let mut jumps = 0;
    for _ in 0..20_000 {
        let set = Set::random(&mut random, false);
        let Ok(axes) = set.plan(false, 0.0, 0.0) else { continue };
        let mut spoiled = axes[0];
        let phase = &mut spoiled.phase[random.below(axes[0].count as usize + 1)];
        let number = match random.below(5) {
            0 => &mut phase.position,
            1 => &mut phase.velocity,
            2 => &mut phase.acceleration,
            3 => &mut phase.jerk,
            _ => &mut phase.duration,
        };
        *number *= nearly_1(&mut random, -16.0);
        let units = any_units(&mut random);
        let findings = spoiled.check(&set.limits[0]);
        jumps += usize::from(findings.is_ok_and(|findings| findings.contains(Findings::JUMPS)));
        assert_eq!(findings, units.of_move(&spoiled).check(&set.scaled(units).limits[0]), "{spoiled:?} in {units:?}");
    }
    assert!(jumps > 4_000 && jumps < 16_000, "{jumps}");
}

#[derive(Clone, Copy)]
enum Field {
    Of(i32),
    Time,
}

const FIELDS_OF_BELL: [Field; 14] =
    [Time, Time, Time, Time, Time, Time, Of(0), Of(0), Of(1), Of(1), Of(1), Of(3), Of(2), Of(2)];
const FIELDS_OF_TRAP: [Field; 12] = [Time, Of(0), Of(0), Of(1), Of(1), Of(1), Time, Time, Of(0), Of(0), Of(2), Of(2)];

fn spoiled_alike<const N: usize>(
    random: &mut Random, units: Units, kinds: [Field; N], mut near: [f64; N],
    check: impl Fn(&[f64], Units) -> Result<Findings, Error>,
) -> bool {
    near[random.below(N)] *= nearly_1(random, -16.0);
    let far: [f64; N] = std::array::from_fn(|k| match kinds[k] {
        Of(order) => units.of(order, near[k]),
        Time => near[k] * units.time,
    });
    let found = check(&near, Units { length: 1.0, time: 1.0 });
    assert_eq!(found, check(&far, units), "{near:?} in {units:?}");
    found.is_ok_and(|found| found.contains(Findings::JUMPS))
}

/// A double-S and a trapezoid of which a number is changed by some ulps have the same findings in other units.
#[test]
fn spoiled_profiles() {
    let mut random = Random::seeded(11);
    let mut jumps = 0;
    for _ in 0..20_000 {
        let [j, a, v] = [(); 3].map(|()| random.magnitude(-1.0, 2.0));
        let [p0, p1, v0, v1] = [10.0, 10.0, v, v].map(|most| most * random.between(-1.0, 1.0));
        let boundary = Boundary { p0, p1, v0, v1 };
        let Units { length, time } = any_units(&mut random);
        let units = Units { length: length.abs(), time };
        let is_spoiled = if random.one_in(2) {
            let fields = bell_fields(&Bell::fastest(j, a, v, boundary).expect("a plan"));
            spoiled_alike(&mut random, units, FIELDS_OF_BELL, fields, |fields, units| {
                bell(fields).check(units.of(3, j), units.of(2, a), units.of(1, v))
            })
        } else {
            let fields = trap_fields(&Trap::fastest(v, a, -j, boundary).expect("a plan"));
            spoiled_alike(&mut random, units, FIELDS_OF_TRAP, fields, |fields, units| {
                trap(fields).check(units.of(1, v), units.of(2, a), units.of(2, -j))
            })
        };
        jumps += u32::from(is_spoiled);
    }
    assert!(jumps > 4_000 && jumps < 16_000, "{jumps}");
}
