//! Does every profile keep the laws of motion in Biagotti & Melchiorri: the prescribed ends, continuity over the borders of phases, the
//! limits, the mirrored move, and the scaling laws of section 5.2? Do several axes keep the scaling laws?
//!
//! No law needs the original.

use approx::assert_abs_diff_eq;
use atraj::axes::{line, synchronise};
use atraj::online::{Limits, Move};
use atraj::{Bell, Boundary, Error, Poly3, Poly5, Poly7, State, Trap};
use proptest::prelude::*;
use support::online::{limits_of, numbers_of};
use support::profiles::{Profile, bell_fields, trap_fields};
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
            let wide = Limits::symmetric(jmax.max(j), amax.max(a), vmax.max(v));
            limits.push(if is_straight { wide } else { own });
            for (end, lead) in ends.iter_mut().zip(leads) {
                let beside = 1.0 + random.sign() * random.magnitude(-17.0, -9.0);
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
            let scaled: Vec<_> = orders.map(|(order, x)| units.of(order, x)).collect();
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

    fn plan(&self, is_straight: bool, duration: f64) -> Result<Vec<Move<f64>>, Error> {
        let mut axes = vec![Move::default(); self.limits.len()];
        let [from, to] = &self.ends;
        let plan = if is_straight { line } else { synchronise };
        plan(&mut axes, &self.limits, from, to, duration, 0.0).map(|_| axes)
    }
}

/// Several axes move alike in other units, and are refused alike.
#[test]
fn several_axes() {
    let mut random = Random::seeded(9);
    let mut planned = [0; 2];
    for k in 0..8_000 {
        let is_straight = k % 2 == 0;
        let set = Set::random(&mut random, is_straight);
        let power = |random: &mut Random| f64::exp2(random.between(-9.0, 9.0).round());
        let units = Units {
            length: power(&mut random),
            time: power(&mut random),
        };
        let duration = random.pick(&[0.0, 0.0, 1.0, 10.0, 100.0]);
        let near = set.plan(is_straight, duration);
        let far = set.scaled(units).plan(is_straight, units.time * duration);
        planned[k % 2] += u32::from(near.is_ok());
        let near = near.map(|axes| {
            axes.iter()
                .map(|axis| units.of_move(axis))
                .collect::<Vec<_>>()
        });
        assert_eq!(near, far, "{set:?} in {units:?}");
    }
    println!("{planned:?}");
    assert!(planned[0] > 500 && planned[1] > 3_000, "{planned:?}");
}
