//! Does every move keep the laws of motion in Biagotti & Melchiorri: the prescribed ends, continuity over the borders of
//! phases, the limits, the mirrored move, and the scaling laws of section 5.2?
//!
//! No law needs the original.

use atraj::{Bell, Boundary, Poly3, Poly5, Poly7, Trap};
use proptest::prelude::*;
use support::Family;
use support::profiles::{bell_fields, trap_fields};

/// Relative to the largest number that a value is computed from.
const TOLERANCE: f64 = 1e-9;

fn close(x: f64, y: f64, scale: f64) -> bool {
    (x - y).abs() <= TOLERANCE * (1.0 + scale.abs())
}

/// The largest magnitude.
fn size(numbers: &[f64]) -> f64 {
    numbers.iter().fold(0.0, |most, x| x.abs().max(most))
}

fn limit() -> impl Strategy<Value = f64> {
    0.1..50.0
}

fn any_boundary() -> impl Strategy<Value = Boundary<f64>> {
    let position = || -100.0..100.0;
    let velocity = || prop_oneof![Just(0.0), -20.0..20.0];
    (position(), position(), velocity(), velocity()).prop_map(|(p0, p1, v0, v1)| Boundary {
        p0,
        p1,
        v0,
        v1,
    })
}

fn scaled(boundary: Boundary<f64>, position: f64, velocity: f64) -> Boundary<f64> {
    Boundary {
        p0: boundary.p0 * position,
        p1: boundary.p1 * position,
        v0: boundary.v0 * velocity,
        v1: boundary.v1 * velocity,
    }
}

/// The change of `f` across the border `x`.
fn jump(f: impl Fn(f64) -> f64, x: f64) -> f64 {
    let rounding = f64::EPSILON * x.abs();
    f(x + rounding) - f(x - rounding)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 5_000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn bell_begins_and_ends_as_prescribed(jm in limit(), am in limit(), vm in limit(), boundary in any_boundary()) {
        let Ok(bell) = Bell::new(jm, am, vm, boundary) else { return Ok(()) };
        let v0 = boundary.v0.clamp(-vm, vm);
        if bell.ta > 0.0 {
            prop_assert_eq!((bell.position(0.0), bell.velocity(0.0)), (boundary.p0, v0));
        } else {
            // The only ramp is computed back from its end.
            let size = size(&[bell.p0, bell.p1, vm * bell.t]);
            prop_assert!(close(bell.position(0.0), boundary.p0, size));
            prop_assert!(close(bell.velocity(0.0), v0, vm));
        }
        prop_assert_eq!(bell.position(bell.t), boundary.p1);
        prop_assert_eq!(bell.velocity(bell.t), boundary.v1.clamp(-vm, vm));
        prop_assert_eq!((bell.acceleration(0.0), bell.acceleration(bell.t)), (0.0, 0.0));
    }

    #[test]
    fn bell_is_continuous(jm in limit(), am in limit(), vm in limit(), boundary in any_boundary()) {
        let Ok(bell) = Bell::new(jm, am, vm, boundary) else { return Ok(()) };
        let size = size(&[bell.p0, bell.p1, vm * bell.t]);
        for x in Family::Bell.borders(&[], &bell_fields(&bell)) {
            let p = jump(|x| bell.position(x), x);
            let v = jump(|x| bell.velocity(x), x);
            let a = jump(|x| bell.acceleration(x), x);
            prop_assert!(close(p, 0.0, size), "position jumps by {p} at {x} in {bell:?}");
            prop_assert!(close(v, 0.0, vm), "velocity jumps by {v} at {x} in {bell:?}");
            prop_assert!(close(a, 0.0, am), "acceleration jumps by {a} at {x} in {bell:?}");
        }
    }

    #[test]
    fn bell_keeps_its_limits(
        jm in limit(), am in limit(), vm in limit(), boundary in any_boundary(), part in 0.0..1.0_f64,
    ) {
        let Ok(bell) = Bell::new(jm, am, vm, boundary) else { return Ok(()) };
        let x = part * bell.t;
        prop_assert!([0.0, jm, -jm].contains(&bell.jerk(x)));
        prop_assert!(bell.velocity(x).abs() <= vm * (1.0 + TOLERANCE), "velocity {}", bell.velocity(x));
        // The end velocities and the jerk determine a ramp that covers the whole distance alone. The book and the original
        // do not check its acceleration.
        if bell.ta > 0.0 && bell.td > 0.0 {
            let acceleration = bell.acceleration(x);
            prop_assert!(acceleration.abs() <= am * (1.0 + TOLERANCE), "acceleration {acceleration}");
        }
    }

    #[test]
    fn bell_mirrors(
        jm in limit(), am in limit(), vm in limit(), boundary in any_boundary(), part in -0.1..1.1_f64,
    ) {
        let Ok(bell) = Bell::new(jm, am, vm, boundary) else { return Ok(()) };
        let mirrored = Bell::new(jm, am, vm, scaled(boundary, -1.0, -1.0)).expect("the mirrored move");
        prop_assert_eq!(mirrored.t, bell.t);
        let x = part * bell.t;
        prop_assert_eq!(mirrored.position(x), -bell.position(x));
        prop_assert_eq!(mirrored.velocity(x), -bell.velocity(x));
        prop_assert_eq!(mirrored.acceleration(x), -bell.acceleration(x));
        prop_assert_eq!(mirrored.jerk(x), -bell.jerk(x));
    }

    /// A power of two scales without rounding.
    #[test]
    fn bell_scales(
        jm in limit(), am in limit(), vm in limit(), boundary in any_boundary(), part in -0.1..1.1_f64,
        length in -3..3, time in -3..3,
    ) {
        let Ok(bell) = Bell::new(jm, am, vm, boundary) else { return Ok(()) };
        let (l, s) = (2_f64.powi(length), 2_f64.powi(time));
        let of_time = |order: i32| l / s.powi(order);
        let boundary = scaled(boundary, l, of_time(1));
        let scaled = Bell::new(jm * of_time(3), am * of_time(2), vm * of_time(1), boundary);
        let scaled = scaled.expect("the scaled move");
        prop_assert_eq!(scaled.t, bell.t * s);
        let x = part * bell.t;
        prop_assert_eq!(scaled.position(x * s), bell.position(x) * l);
        prop_assert_eq!(scaled.velocity(x * s), bell.velocity(x) * of_time(1));
        prop_assert_eq!(scaled.acceleration(x * s), bell.acceleration(x) * of_time(2));
        prop_assert_eq!(scaled.jerk(x * s), bell.jerk(x) * of_time(3));
    }

    #[test]
    fn trap_begins_ends_and_is_continuous(
        vm in limit(), ac in limit(), de in limit(), boundary in any_boundary(),
    ) {
        let forward = (boundary.p1 - boundary.p0).signum();
        let Ok(trap) = Trap::new(vm, ac * forward, -de * forward, boundary) else { return Ok(()) };
        prop_assert_eq!(trap.position(0.0), boundary.p0);
        prop_assert_eq!(trap.velocity(0.0), boundary.v0.clamp(-vm, vm));
        prop_assert_eq!(trap.position(trap.t), boundary.p1);
        prop_assert_eq!(trap.velocity(trap.t), trap.v1);
        let size = size(&[trap.p0, trap.p1, vm * trap.t]);
        for x in Family::Trap.borders(&[], &trap_fields(&trap)) {
            let p = jump(|x| trap.position(x), x);
            let v = jump(|x| trap.velocity(x), x);
            prop_assert!(close(p, 0.0, size), "position jumps by {p} at {x} in {trap:?}");
            prop_assert!(close(v, 0.0, vm), "velocity jumps by {v} at {x} in {trap:?}");
        }
    }

    #[test]
    fn trap_mirrors_and_scales(
        vm in limit(), ac in limit(), de in limit(), boundary in any_boundary(), part in -0.1..1.1_f64,
        length in -3..3, time in -3..3,
    ) {
        let forward = (boundary.p1 - boundary.p0).signum();
        let Ok(trap) = Trap::new(vm, ac * forward, -de * forward, boundary) else { return Ok(()) };
        let (l, s) = (-(2_f64.powi(length)), 2_f64.powi(time));
        let of_time = |order: i32| l / s.powi(order);
        let rate = forward * of_time(2);
        let scaled = Trap::new(vm * of_time(1), ac * rate, -de * rate, scaled(boundary, l, of_time(1)));
        let scaled = scaled.expect("the scaled move");
        prop_assert_eq!(scaled.t, trap.t * s);
        let x = part * trap.t;
        prop_assert_eq!(scaled.position(x * s), trap.position(x) * l);
        prop_assert_eq!(scaled.velocity(x * s), trap.velocity(x) * of_time(1));
        prop_assert_eq!(scaled.acceleration(x * s), trap.acceleration(x) * of_time(2));
    }

    #[test]
    fn polynomials_begin_and_end_as_prescribed(
        ts in 0.5..20.0, boundary in any_boundary(),
        a in prop::array::uniform2(-10.0..10.0_f64), j in prop::array::uniform2(-10.0..10.0_f64),
    ) {
        let Boundary { p0, p1, v0, v1 } = boundary;
        let poly3 = Poly3::new(ts, boundary).expect("finite");
        let poly5 = Poly5::new(ts, boundary, a).expect("finite");
        let poly7 = Poly7::new(ts, boundary, a, j).expect("finite");
        prop_assert_eq!((poly3.position(0.0), poly5.position(0.0), poly7.position(0.0)), (p0, p0, p0));
        prop_assert_eq!((poly3.velocity(0.0), poly5.velocity(0.0), poly7.velocity(0.0)), (v0, v0, v0));
        prop_assert_eq!((poly5.acceleration(0.0), poly7.acceleration(0.0)), (a[0], a[0]));
        prop_assert!(close(poly7.jerk(0.0), j[0], j[0]));
        // At the end, every term of a sum is a multiple of a prescribed value.
        let size = 1e3 * size(&[p0, p1, v0 * ts, v1 * ts, a[0] * ts * ts, a[1] * ts * ts, j[0] * ts.powi(3), j[1] * ts.powi(3)]);
        for p in [poly3.position(ts), poly5.position(ts), poly7.position(ts)] {
            prop_assert!(close(p, p1, size), "{p} for {p1}");
        }
        for v in [poly3.velocity(ts), poly5.velocity(ts), poly7.velocity(ts)] {
            prop_assert!(close(v, v1, size / ts), "{v} for {v1}");
        }
        for acceleration in [poly5.acceleration(ts), poly7.acceleration(ts)] {
            prop_assert!(close(acceleration, a[1], size / (ts * ts)), "{acceleration} for {}", a[1]);
        }
        prop_assert!(close(poly7.jerk(ts), j[1], size / ts.powi(3)), "{} for {}", poly7.jerk(ts), j[1]);
    }

    #[test]
    fn polynomials_mirror_and_scale(
        ts in 0.5..20.0, boundary in any_boundary(), part in -0.5..1.5_f64,
        a in prop::array::uniform2(-10.0..10.0_f64), j in prop::array::uniform2(-10.0..10.0_f64),
        length in -3..3, time in -3..3,
    ) {
        let (l, s) = (-(2_f64.powi(length)), 2_f64.powi(time));
        let of_time = |order: i32| l / s.powi(order);
        let far = scaled(boundary, l, of_time(1));
        let (far_a, far_j) = (a.map(|a| a * of_time(2)), j.map(|j| j * of_time(3)));
        let x = part * ts;
        let (near, far3) = (Poly3::new(ts, boundary).unwrap(), Poly3::new(ts * s, far).unwrap());
        prop_assert_eq!(far3.position(x * s), near.position(x) * l);
        prop_assert_eq!(far3.velocity(x * s), near.velocity(x) * of_time(1));
        prop_assert_eq!(far3.acceleration(x * s), near.acceleration(x) * of_time(2));
        let (near, far5) = (Poly5::new(ts, boundary, a).unwrap(), Poly5::new(ts * s, far, far_a).unwrap());
        prop_assert_eq!(far5.position(x * s), near.position(x) * l);
        prop_assert_eq!(far5.velocity(x * s), near.velocity(x) * of_time(1));
        prop_assert_eq!(far5.acceleration(x * s), near.acceleration(x) * of_time(2));
        let (near, far7) =
            (Poly7::new(ts, boundary, a, j).unwrap(), Poly7::new(ts * s, far, far_a, far_j).unwrap());
        prop_assert_eq!(far7.position(x * s), near.position(x) * l);
        prop_assert_eq!(far7.velocity(x * s), near.velocity(x) * of_time(1));
        prop_assert_eq!(far7.acceleration(x * s), near.acceleration(x) * of_time(2));
        prop_assert_eq!(far7.jerk(x * s), near.jerk(x) * of_time(3));
    }
}
