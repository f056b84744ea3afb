//! Does every profile keep the laws of motion in Biagotti & Melchiorri: the prescribed ends, continuity over the borders of phases, the
//! limits, the mirrored move, and the scaling laws of section 5.2? Do several axes keep the scaling laws?
//!
//! No law needs the original.

use Field::{Of, Time};
use approx::assert_abs_diff_eq;
use atraj::axes::{line, line_stop, synchronise};
use atraj::online::{Limits, Move, Phase};
use atraj::{Bell, Boundary, Error, Findings, Poly3, Poly5, Poly7, State, Trap};
use proptest::prelude::*;
use support::online::{limits_of, numbers_of};
use support::profiles::{Profile, bell, bell_fields, trap, trap_fields};
use support::{Family, Random, online};

/// Relative to the largest number that a value is computed from.
const TOLERANCE: f64 = 1e-9;

#[track_caller]
fn assert_close(x: f64, y: f64, scale: f64) {
    assert_abs_diff_eq!(x, y, epsilon = TOLERANCE * (1.0 + scale.abs()));
}

/// The largest magnitude.
fn size(numbers: &[f64]) -> f64 {
    numbers.iter().fold(0.0, |most, x| x.abs().max(most))
}

fn limits() -> [std::ops::Range<f64>; 3] {
    [0.1..50.0, 0.1..50.0, 0.1..50.0]
}

fn any_boundary() -> impl Strategy<Value = Boundary<f64>> {
    let position = || -100.0..100.0;
    let velocity = || prop_oneof![Just(0.0), -20.0..20.0];
    let ends = (position(), position(), velocity(), velocity());
    ends.prop_map(|(p0, p1, v0, v1)| Boundary { p0, p1, v0, v1 })
}

/// Other units of length and time, and perhaps the other direction. A power of two scales without rounding.
#[derive(Clone, Copy, Debug)]
struct Units {
    length: f64,
    time: f64,
}

fn units() -> impl Strategy<Value = Units> {
    let powers = (-3..3, -3..3, prop_oneof![Just(-1.0), Just(1.0)]);
    powers.prop_map(|(length, time, sign)| Units {
        length: sign * 2_f64.powi(length),
        time: 2_f64.powi(time),
    })
}

impl Units {
    /// A derivative of the position.
    fn of(self, order: i32, x: f64) -> f64 {
        x * (self.length / self.time.powi(order))
    }

    fn of_boundary(self, Boundary { p0, p1, v0, v1 }: Boundary<f64>) -> Boundary<f64> {
        let [p0, p1] = [p0, p1].map(|p| self.of(0, p));
        let [v0, v1] = [v0, v1].map(|v| self.of(1, v));
        Boundary { p0, p1, v0, v1 }
    }

    fn of_state(self, state: &State<f64>) -> State<f64> {
        State {
            position: self.of(0, state.position),
            velocity: self.of(1, state.velocity),
            acceleration: self.of(2, state.acceleration),
        }
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

    fn assert_scaled<const N: usize>(
        self,
        near: &impl Profile<f64, N>,
        far: &impl Profile<f64, N>,
        x: f64,
    ) {
        let scaled = near.each(x).into_iter().zip(0..);
        let scaled: Vec<_> = scaled.map(|(y, order)| self.of(order, y)).collect();
        assert_eq!(far.each(x * self.time)[..], scaled);
    }
}

/// The first quantities do not jump at a border.
fn assert_continuous<const N: usize>(
    profile: &impl Profile<f64, N>,
    borders: &[f64],
    scales: &[f64],
) {
    for &x in borders {
        let rounding = f64::EPSILON * x.abs();
        let [before, after] = [x - rounding, x + rounding].map(|x| profile.each(x));
        for (i, &scale) in scales.iter().enumerate() {
            assert_close(before[i], after[i], scale);
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 5_000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn bells([jm, am, vm] in limits(), boundary in any_boundary(), part in -0.1..1.1_f64, units in units()) {
        let Ok(bell) = Bell::new(jm, am, vm, boundary) else { return Ok(()) };
        let size = size(&[bell.p0, bell.p1, vm * bell.t]);
        let v0 = boundary.v0.clamp(-vm, vm);
        if bell.ta > 0.0 {
            assert_eq!((bell.position(0.0), bell.velocity(0.0)), (boundary.p0, v0));
        } else {
            // The only ramp is computed back from its end.
            assert_close(bell.position(0.0), boundary.p0, size);
            assert_close(bell.velocity(0.0), v0, vm);
        }
        assert_eq!((bell.position(bell.t), bell.velocity(bell.t)), (boundary.p1, boundary.v1.clamp(-vm, vm)));
        assert_eq!((bell.acceleration(0.0), bell.acceleration(bell.t)), (0.0, 0.0));
        assert_continuous(&bell, &Family::Bell.borders(&[], &bell_fields(&bell)), &[size, vm, am]);

        let x = part * bell.t;
        assert!([0.0, jm, -jm].contains(&bell.jerk(x)));
        assert!(bell.velocity(x).abs() <= vm * (1.0 + TOLERANCE), "velocity {}", bell.velocity(x));
        // The end velocities and the jerk determine a ramp that covers the whole distance alone. The book and the original
        // do not check its acceleration.
        if bell.ta > 0.0 && bell.td > 0.0 {
            let acceleration = bell.acceleration(x);
            assert!(acceleration.abs() <= am * (1.0 + TOLERANCE), "acceleration {acceleration}");
        }
        let [j, a, v] = [(3, jm), (2, am), (1, vm)].map(|(order, limit)| units.of(order, limit).abs());
        let scaled = Bell::new(j, a, v, units.of_boundary(boundary)).expect("the scaled move");
        assert_eq!(scaled.t, bell.t * units.time);
        units.assert_scaled(&bell, &scaled, x);
    }

    #[test]
    fn trapezoids([vm, ac, de] in limits(), boundary in any_boundary(), part in -0.1..1.1_f64, units in units()) {
        let forward = (boundary.p1 - boundary.p0).signum();
        let [ac, de] = [forward * ac, -forward * de];
        let Ok(trap) = Trap::new(vm, ac, de, boundary) else { return Ok(()) };
        assert_eq!((trap.position(0.0), trap.velocity(0.0)), (boundary.p0, boundary.v0.clamp(-vm, vm)));
        assert_eq!((trap.position(trap.t), trap.velocity(trap.t)), (boundary.p1, trap.v1));
        let size = size(&[trap.p0, trap.p1, vm * trap.t]);
        assert_continuous(&trap, &Family::Trap.borders(&[], &trap_fields(&trap)), &[size, vm]);

        let v = units.of(1, vm).abs();
        let scaled = Trap::new(v, units.of(2, ac), units.of(2, de), units.of_boundary(boundary));
        let scaled = scaled.expect("the scaled move");
        assert_eq!(scaled.t, trap.t * units.time);
        units.assert_scaled(&trap, &scaled, part * trap.t);
    }

    #[test]
    fn polynomials(
        ts in 0.5..20.0, boundary in any_boundary(), part in -0.5..1.5_f64, units in units(),
        a in prop::array::uniform2(-10.0..10.0_f64), j in prop::array::uniform2(-10.0..10.0_f64),
    ) {
        let Boundary { p0, p1, v0, v1 } = boundary;
        let poly3 = Poly3::new(ts, boundary).expect("finite");
        let poly5 = Poly5::new(ts, boundary, a).expect("finite");
        let poly7 = Poly7::new(ts, boundary, a, j).expect("finite");
        let starts = [poly3.each(0.0), poly5.each(0.0), poly7.each(0.0)];
        let ends = [poly3.each(ts), poly5.each(ts), poly7.each(ts)];
        // At the end, every term of a sum is a multiple of a prescribed value.
        let [t2, t3] = [ts * ts, ts.powi(3)];
        let size = 1e3 * size(&[p0, p1, v0 * ts, v1 * ts, a[0] * t2, a[1] * t2, j[0] * t3, j[1] * t3]);
        let prescribed = [[p0, p1], [v0, v1], a, j];
        for (i, (start, end)) in starts.into_iter().zip(ends).enumerate() {
            for (order, [first, last]) in prescribed.into_iter().take(i + 2).enumerate() {
                if order < 3 {
                    assert_eq!(start[order], first);
                } else {
                    assert_close(start[order], first, first);
                }
                assert_close(end[order], last, size / ts.powi(order as i32));
            }
        }
        let (x, longer, far) = (part * ts, ts * units.time, units.of_boundary(boundary));
        let (far_a, far_j) = (a.map(|a| units.of(2, a)), j.map(|j| units.of(3, j)));
        units.assert_scaled(&poly3, &Poly3::new(longer, far).unwrap(), x);
        units.assert_scaled(&poly5, &Poly5::new(longer, far, far_a).unwrap(), x);
        units.assert_scaled(&poly7, &Poly7::new(longer, far, far_a, far_j).unwrap(), x);
    }
}

/// Limits, starts and ends of several axes.
#[derive(Clone, Debug)]
struct Set {
    limits: Vec<Limits<f64>>,
    ends: [Vec<State<f64>>; 2],
}

impl Set {
    /// A lead, and axes beside it: each by itself, or nearly on a straight line with the lead.
    fn random(random: &mut Random, is_straight: bool) -> Self {
        let count = 1 + random.below(4);
        let lead = online::limits(random);
        let leads = [(); 2].map(|()| online::inside(random, &lead));
        let (mut limits, mut ends) = (vec![lead], leads.map(|end| vec![end]));
        for _ in 1..count {
            let (share, offset) = (
                random.sign() * random.magnitude(-3.0, 0.0),
                random.magnitude(-1.0, 6.0),
            );
            let own = online::limits(random);
            let mirrored = numbers_of(&lead).map(f64::abs);
            let [vmax, v, amax, a, jmax, j] = mirrored;
            let [v, a, j] = [vmax.max(v), amax.max(a), jmax.max(j)];
            let wide = [v, -v, a, -a, j, -j].map(|limit| limit * random.magnitude(0.0, 1.0));
            let wide = limits_of(wide);
            limits.push(if is_straight { wide } else { own });
            for (end, lead) in ends.iter_mut().zip(leads) {
                let beside = nearly_1(random, -17.0);
                let on_line = State {
                    position: offset + share * lead.position,
                    velocity: share * lead.velocity * beside,
                    acceleration: share * lead.acceleration,
                };
                end.push(if is_straight {
                    on_line
                } else {
                    online::inside(random, &own)
                });
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
            ends: self
                .ends
                .clone()
                .map(|ends| ends.iter().map(|end| units.of_state(end)).collect()),
        }
    }

    fn plan(&self, is_straight: bool, duration: f64, cycle: f64) -> Result<Vec<Move<f64>>, Error> {
        let mut axes = vec![Move::default(); self.limits.len()];
        let [from, to] = &self.ends;
        let plan = if is_straight { line } else { synchronise };
        plan(&mut axes, &self.limits, from, to, duration, cycle).map(|_| axes)
    }
}

/// A factor that is `10^least` to `10^-9` beside 1.
fn nearly_1(random: &mut Random, least: f64) -> f64 {
    1.0 + random.sign() * random.magnitude(least, -9.0)
}

/// Units of length and time that are up to 512 times as large or small, and perhaps the other direction.
fn any_units(random: &mut Random) -> Units {
    let mut power = || f64::exp2(random.between(-9.0, 9.0).round());
    let (length, time) = (power(), power());
    Units {
        length: random.sign() * length,
        time,
    }
}

/// The axes take the same time, and are in the same states.
fn assert_alike(near: &[Move<f64>], far: &[Move<f64>]) {
    for (one, other) in near.iter().zip(far) {
        assert_eq!(one.t, other.t);
        let phases = one.phases().iter();
        let most =
            |number: fn(&Phase<f64>) -> f64| size(&phases.clone().map(number).collect::<Vec<_>>());
        let (jerk, a, v) = (
            most(|phase| phase.jerk),
            most(|phase| phase.acceleration),
            most(|phase| phase.velocity),
        );
        let a = a + jerk * one.t;
        let v = v + a * one.t;
        let p = most(|phase| phase.position) + v * one.t;
        for part in 0..=16 {
            let x = one.t * f64::from(part) / 16.0;
            let [one, other] = [one, other].map(|axis| axis.state_at(x));
            for (x, y, scale) in [
                (one.position, other.position, p),
                (one.velocity, other.velocity, v),
                (one.acceleration, other.acceleration, a),
            ] {
                assert_abs_diff_eq!(x, y, epsilon = TOLERANCE * scale);
            }
        }
    }
}

/// Both are refused alike, or the far axes move as the near ones do.
fn assert_scaled_alike(
    units: Units,
    near: &Result<Vec<Move<f64>>, Error>,
    far: Result<Vec<Move<f64>>, Error>,
) {
    let near = near.clone().map(|axes| {
        let scaled = axes.iter().map(|axis| units.of_move(axis));
        scaled.collect::<Vec<_>>()
    });
    match (near, far) {
        (Ok(near), Ok(far)) if units.length < 0.0 => assert_alike(&near, &far),
        (near, far) => assert_eq!(near, far, "{units:?}"),
    }
}

/// Axes that stop on their line from a time on.
fn stopped(
    mut axes: Vec<Move<f64>>,
    limits: &[Limits<f64>],
    x: f64,
) -> Result<Vec<Move<f64>>, Error> {
    line_stop(&mut axes, limits, x).map(|_| axes)
}

/// Several axes move and stop alike in other units, and are refused alike. Mirrored, they move alike up to roundings: the mean of two motions is
/// counted from the other one.
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
        let beside = 1.0 + random.sign() * random.magnitude(-17.0, -3.0);
        let tick =
            fastest.map_or(1.0, |axes| axes[0].t * beside) / (1 + random.below(1_000)) as f64;
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
    println!("{planned:?}, {stops} stops");
    assert!(stops > 300 && stops < planned[0]);
    assert!(planned[0] > 500 && planned[1] > 3_000, "{planned:?}");
}

/// A move is the same in other units, also where the change of velocity alone leads to the target up to roundings.
#[test]
fn nearly_direct() {
    let mut random = Random::seeded(12);
    let mut planned = 0;
    for _ in 0..40_000 {
        let mut set = Set::random(&mut random, false);
        let (limits, [from, to]) = (set.limits[0], set.ends.each_mut());
        let mut direct = Move::default();
        let (velocity, acceleration) = (to[0].velocity, to[0].acceleration);
        if direct
            .reach(&limits, from[0], velocity, acceleration)
            .is_err()
        {
            continue;
        }
        let rounding = random.sign() * random.magnitude(-18.0, -11.0);
        let speed = from[0].velocity.abs() + velocity.abs();
        let end = direct.state_at(direct.t).position;
        to[0].position = end + rounding * (end.abs() + speed * direct.t);
        let alone = Set {
            limits: vec![limits],
            ends: set.ends.map(|ends| vec![ends[0]]),
        };
        let Units { length, time } = any_units(&mut random);
        let units = Units {
            length: length.abs(),
            time,
        };
        let near = alone.plan(false, 0.0, 0.0);
        planned += u32::from(near.is_ok());
        let far = alone.scaled(units).plan(false, 0.0, 0.0);
        assert_scaled_alike(units, &near, far);
    }
    assert!(planned > 30_000, "{planned}");
}

/// A move of which a number is changed by some roundings has the same findings in other units.
#[test]
fn spoiled_moves() {
    let mut random = Random::seeded(10);
    let mut jumps = 0;
    for _ in 0..20_000 {
        let set = Set::random(&mut random, false);
        let Ok(axes) = set.plan(false, 0.0, 0.0) else {
            continue;
        };
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
        let scaled = units.of_move(&spoiled);
        assert_eq!(
            findings,
            scaled.check(&set.scaled(units).limits[0]),
            "{spoiled:?} in {units:?}"
        );
    }
    assert!(jumps > 4_000 && jumps < 16_000, "{jumps}");
}

/// What a field of a profile is: the position or its derivative of this order, or a time.
#[derive(Clone, Copy)]
enum Field {
    Of(i32),
    Time,
}

#[rustfmt::skip]
const FIELDS_OF_BELL: [Field; 14] = [
    Time, Time, Time, Time, Time, Time, Of(0), Of(0), Of(1), Of(1), Of(1), Of(3), Of(2), Of(2),
];
#[rustfmt::skip]
const FIELDS_OF_TRAP: [Field; 12] = [
    Time, Of(0), Of(0), Of(1), Of(1), Of(1), Time, Time, Of(0), Of(0), Of(2), Of(2),
];

/// Changes a field by some roundings. Whether the check finds a jump; it finds the same in other units.
fn spoiled_alike<const N: usize>(
    random: &mut Random,
    units: Units,
    kinds: [Field; N],
    mut near: [f64; N],
    check: impl Fn(&[f64], Units) -> Result<Findings, Error>,
) -> bool {
    near[random.below(N)] *= nearly_1(random, -16.0);
    let far: [f64; N] = std::array::from_fn(|k| match kinds[k] {
        Of(order) => units.of(order, near[k]),
        Time => near[k] * units.time,
    });
    let own = Units {
        length: 1.0,
        time: 1.0,
    };
    let found = check(&near, own);
    assert_eq!(found, check(&far, units), "{near:?} in {units:?}");
    found.is_ok_and(|found| found.contains(Findings::JUMPS))
}

/// A double-S and a trapezoid of which a number is changed by some roundings have the same findings in other units.
#[test]
fn spoiled_profiles() {
    let mut random = Random::seeded(11);
    let mut jumps = 0;
    for _ in 0..20_000 {
        let [j, a, v] = [(); 3].map(|()| random.magnitude(-1.0, 2.0));
        let [p0, p1, v0, v1] = [10.0, 10.0, v, v].map(|most| most * random.between(-1.0, 1.0));
        let boundary = Boundary { p0, p1, v0, v1 };
        let Units { length, time } = any_units(&mut random);
        let units = Units {
            length: length.abs(),
            time,
        };
        let is_spoiled = if random.one_in(2) {
            let fields = bell_fields(&Bell::fastest(j, a, v, boundary).expect("a plan"));
            spoiled_alike(
                &mut random,
                units,
                FIELDS_OF_BELL,
                fields,
                |fields, units| bell(fields).check(units.of(3, j), units.of(2, a), units.of(1, v)),
            )
        } else {
            let fields = trap_fields(&Trap::fastest(v, a, -j, boundary).expect("a plan"));
            spoiled_alike(
                &mut random,
                units,
                FIELDS_OF_TRAP,
                fields,
                |fields, units| trap(fields).check(units.of(1, v), units.of(2, a), units.of(2, -j)),
            )
        };
        jumps += u32::from(is_spoiled);
    }
    assert!(jumps > 4_000 && jumps < 16_000, "{jumps}");
}
