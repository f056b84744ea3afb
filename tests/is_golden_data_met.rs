//! Does the Rust API give the bits of the original C library on every golden row?

mod common;

use atraj::{Bell, Boundary, Poly3, Poly5, Poly7, Trap};
use common::{Comparison, GoldenReal, Row, golden};

const BELL_FIELDS: [&str; 14] = [
    "t", "tv", "ta", "td", "taj", "tdj", "p0", "p1", "v0", "v1", "vm", "jm", "am", "dm",
];
const TRAP_FIELDS: [&str; 12] = [
    "t", "p0", "p1", "v0", "v1", "vc", "ta", "td", "pa", "pd", "ac", "de",
];

fn bell_fields<R: Copy>(b: &Bell<R>) -> [R; 14] {
    [
        b.t, b.tv, b.ta, b.td, b.taj, b.tdj, b.p0, b.p1, b.v0, b.v1, b.vm, b.jm, b.am, b.dm,
    ]
}

fn trap_fields<R: Copy>(c: &Trap<R>) -> [R; 12] {
    [
        c.t, c.p0, c.p1, c.v0, c.v1, c.vc, c.ta, c.td, c.pa, c.pd, c.ac, c.de,
    ]
}

fn planned_bell<R: GoldenReal>(row: &Row<R>) -> (Option<R>, Bell<R>) {
    let [jm, am, vm, p0, p1, v0, v1] = row.head();
    let mut bell = Bell::default();
    let duration = bell.plan(jm, am, vm, Boundary { p0, p1, v0, v1 });
    (duration, bell)
}

fn planned_trap<R: GoldenReal>(row: &Row<R>) -> (Option<R>, Trap<R>) {
    let [vm, ac, de, p0, p1, v0, v1] = row.head();
    let mut trap = Trap::default();
    let duration = trap.plan(vm, ac, de, Boundary { p0, p1, v0, v1 });
    (duration, trap)
}

fn bell<R: GoldenReal>() {
    let mut comparison = Comparison::default();
    let moves = golden::<R>("bell_gen", 2, 7 + 1 + 14);
    for row in &moves {
        let (duration, bell) = planned_bell(row);
        let duration = duration.unwrap_or(R::from(0));
        comparison.check(&row.place, "duration", duration, row.values[7]);
        for (i, name) in BELL_FIELDS.iter().enumerate() {
            comparison.check(&row.place, name, bell_fields(&bell)[i], row.values[8 + i]);
        }
    }
    for row in golden::<R>("bell_eval", 1, 5) {
        let (_, bell) = planned_bell(&moves[row.case]);
        let [x, p, v, a, j] = row.head();
        comparison.check(&row.place, "position", bell.position(x), p);
        comparison.check(&row.place, "velocity", bell.velocity(x), v);
        comparison.check(&row.place, "acceleration", bell.acceleration(x), a);
        comparison.check(&row.place, "jerk", bell.jerk(x), j);
    }
    comparison.finish("bell");
}

fn trap<R: GoldenReal>() {
    let mut comparison = Comparison::default();
    let moves = golden::<R>("trap_gen", 2, 7 + 1 + 12);
    for row in &moves {
        let (duration, trap) = planned_trap(row);
        let duration = duration.unwrap_or(R::from(0));
        comparison.check(&row.place, "duration", duration, row.values[7]);
        for (i, name) in TRAP_FIELDS.iter().enumerate() {
            comparison.check(&row.place, name, trap_fields(&trap)[i], row.values[8 + i]);
        }
    }
    for row in golden::<R>("trap_eval", 1, 4) {
        let (_, trap) = planned_trap(&moves[row.case]);
        let [x, p, v, a] = row.head();
        comparison.check(&row.place, "position", trap.position(x), p);
        comparison.check(&row.place, "velocity", trap.velocity(x), v);
        comparison.check(&row.place, "acceleration", trap.acceleration(x), a);
    }
    comparison.finish("trap");
}

fn check_coefficients<R: GoldenReal>(
    comparison: &mut Comparison,
    row: &Row<R>,
    arguments: usize,
    coefficients: &[&[R]],
) {
    let coefficients = coefficients.concat();
    assert_eq!(arguments + coefficients.len(), row.values.len());
    for (i, (&got, &want)) in coefficients
        .iter()
        .zip(&row.values[arguments..])
        .enumerate()
    {
        comparison.check(&row.place, &format!("coefficient {i}"), got, want);
    }
}

fn poly3<R: GoldenReal>() {
    let mut comparison = Comparison::default();
    let moves = golden::<R>("poly3_gen", 1, 5 + 9);
    let poly = |row: &Row<R>| {
        let [ts, p0, p1, v0, v1] = row.head();
        let c = Poly3::coefficients(ts, Boundary { p0, p1, v0, v1 });
        Poly3 { c }
    };
    for row in &moves {
        let poly = poly(row);
        let (v, a) = (
            poly.velocity_coefficients(),
            poly.acceleration_coefficients(),
        );
        check_coefficients(&mut comparison, row, 5, &[&poly.c, &v, &a]);
    }
    for row in golden::<R>("poly3_eval", 1, 4) {
        let poly = poly(&moves[row.case]);
        let [x, p, v, a] = row.head();
        comparison.check(&row.place, "position", poly.position(x), p);
        comparison.check(&row.place, "velocity", poly.velocity(x), v);
        comparison.check(&row.place, "acceleration", poly.acceleration(x), a);
    }
    comparison.finish("poly3");
}

fn poly5<R: GoldenReal>() {
    let mut comparison = Comparison::default();
    let moves = golden::<R>("poly5_gen", 1, 7 + 15);
    let poly = |row: &Row<R>| {
        let [ts, p0, p1, v0, v1, a0, a1] = row.head();
        let c = Poly5::coefficients(ts, Boundary { p0, p1, v0, v1 }, [a0, a1]);
        Poly5 { c }
    };
    for row in &moves {
        let poly = poly(row);
        let (v, a) = (
            poly.velocity_coefficients(),
            poly.acceleration_coefficients(),
        );
        check_coefficients(&mut comparison, row, 7, &[&poly.c, &v, &a]);
    }
    for row in golden::<R>("poly5_eval", 1, 4) {
        let poly = poly(&moves[row.case]);
        let [x, p, v, a] = row.head();
        comparison.check(&row.place, "position", poly.position(x), p);
        comparison.check(&row.place, "velocity", poly.velocity(x), v);
        comparison.check(&row.place, "acceleration", poly.acceleration(x), a);
    }
    comparison.finish("poly5");
}

fn poly7<R: GoldenReal>() {
    let mut comparison = Comparison::default();
    let moves = golden::<R>("poly7_gen", 1, 9 + 26);
    let poly = |row: &Row<R>| {
        let [ts, p0, p1, v0, v1, a0, a1, j0, j1] = row.head();
        let c = Poly7::coefficients(ts, Boundary { p0, p1, v0, v1 }, [a0, a1], [j0, j1]);
        Poly7 { c }
    };
    for row in &moves {
        let poly = poly(row);
        let (v, a) = (
            poly.velocity_coefficients(),
            poly.acceleration_coefficients(),
        );
        let j = poly.jerk_coefficients();
        check_coefficients(&mut comparison, row, 9, &[&poly.c, &v, &a, &j]);
    }
    for row in golden::<R>("poly7_eval", 1, 5) {
        let poly = poly(&moves[row.case]);
        let [x, p, v, a, j] = row.head();
        comparison.check(&row.place, "position", poly.position(x), p);
        comparison.check(&row.place, "velocity", poly.velocity(x), v);
        comparison.check(&row.place, "acceleration", poly.acceleration(x), a);
        comparison.check(&row.place, "jerk", poly.jerk(x), j);
    }
    comparison.finish("poly7");
}

macro_rules! for_both_reals {
    ($($name:ident)*) => {$(
        mod $name {
            #[test]
            fn f32() {
                super::$name::<f32>();
            }
            #[test]
            fn f64() {
                super::$name::<f64>();
            }
        }
    )*};
}
for_both_reals!(bell trap poly3 poly5 poly7);

#[test]
#[should_panic(expected = "no_such_table_f64.csv")]
fn a_missing_golden_file_fails() {
    golden::<f64>("no_such_table", 1, 1);
}

#[test]
#[should_panic(
    expected = "row 7: position is -0e0 (8000000000000000), golden 0e0 (0000000000000000)"
)]
fn a_differing_sign_of_zero_fails_and_shows_both() {
    let mut comparison = Comparison::default();
    comparison.check("row 7", "position", -0.0, 0.0);
    comparison.finish("self-check");
}

#[test]
#[should_panic(expected = "nothing was compared")]
fn comparing_nothing_fails() {
    Comparison::default().finish("self-check");
}
