//! The Rust API under test.

use crate::family::Family;
use crate::implementation::Implementation;
use crate::prelude::*;
use crate::profiles::{Profile, bell, bell_planned, poly3, poly5, poly7, trap, trap_planned};

/// atraj's plain structs and methods, without the C ABI. Its polynomials hold nothing but the coefficients of position, so
/// an evaluation does not read the other fields of a polynomial.
pub struct Ours;

/// The plans of liba since 2025: those of [`Ours`] with another saturation.
pub struct OursNewest;

impl<R: Real> Implementation<R> for OursNewest {
    fn plan(&self, family: Family, arguments: &[R], fields: &mut [R]) -> R {
        let planned = match (family, arguments) {
            (Family::Bell, &[jm, am, vm, p0, p1, v0, v1]) => {
                let boundary = Boundary { p0, p1, v0, v1 };
                bell_planned(fields, |bell| bell.plan_saturated(jm, am, vm, boundary, Saturation::Numbers))
            }
            (Family::Trap, &[vm, ac, de, p0, p1, v0, v1]) => {
                let boundary = Boundary { p0, p1, v0, v1 };
                trap_planned(fields, |trap| trap.plan_saturated(vm, ac, de, boundary, Saturation::Numbers))
            }
            _ => return Ours.plan(family, arguments, fields),
        };
        planned.unwrap_or(R::ZERO)
    }

    fn evaluate(&self, family: Family, fields: &[R], x: R) -> [R; 4] {
        Ours.evaluate(family, fields, x)
    }
}

impl<R: Real> Implementation<R> for Ours {
    fn plan(&self, family: Family, arguments: &[R], fields: &mut [R]) -> R {
        match (family, arguments) {
            (Family::Bell, &[jm, am, vm, p0, p1, v0, v1]) => {
                let planned = bell_planned(fields, |bell| bell.plan(jm, am, vm, Boundary { p0, p1, v0, v1 }));
                return planned.unwrap_or(R::ZERO);
            }
            (Family::Trap, &[vm, ac, de, p0, p1, v0, v1]) => {
                let planned = trap_planned(fields, |trap| trap.plan(vm, ac, de, Boundary { p0, p1, v0, v1 }));
                return planned.unwrap_or(R::ZERO);
            }
            (Family::Poly3, &[ts, p0, p1, v0, v1]) => {
                let mut p = poly3(fields);
                p.plan(ts, Boundary { p0, p1, v0, v1 });
                let v: Poly<R, 3> = p.derivative();
                let a: Poly<R, 2> = v.derivative();
                write(fields, &[&p.c, &v.c, &a.c]);
            }
            (Family::Poly5, &[ts, p0, p1, v0, v1, a0, a1]) => {
                let mut p = poly5(fields);
                p.plan(ts, Boundary { p0, p1, v0, v1 }, [a0, a1]);
                let v: Poly<R, 5> = p.derivative();
                let a: Poly<R, 4> = v.derivative();
                write(fields, &[&p.c, &v.c, &a.c]);
            }
            (Family::Poly7, &[ts, p0, p1, v0, v1, a0, a1, j0, j1]) => {
                let mut p = poly7(fields);
                p.plan(ts, Boundary { p0, p1, v0, v1 }, [a0, a1], [j0, j1]);
                let v: Poly<R, 7> = p.derivative();
                let a: Poly<R, 6> = v.derivative();
                let j: Poly<R, 5> = a.derivative();
                write(fields, &[&p.c, &v.c, &a.c, &j.c]);
            }
            _ => panic!("{family:?} has not {} arguments", arguments.len()),
        }
        R::ZERO
    }

    fn evaluate(&self, family: Family, fields: &[R], x: R) -> [R; 4] {
        match family {
            Family::Bell => padded(bell(fields).each(x)),
            Family::Trap => padded(trap(fields).each(x)),
            Family::Poly3 => padded(poly3(fields).each(x)),
            Family::Poly5 => padded(poly5(fields).each(x)),
            Family::Poly7 => padded(poly7(fields).each(x)),
        }
    }
}

fn write<R: Real>(mut fields: &mut [R], arrays: &[&[R]]) {
    for array in arrays {
        let (written, rest) = fields.split_at_mut(array.len());
        written.copy_from_slice(array);
        fields = rest;
    }
    assert!(fields.is_empty(), "{} fields are left", fields.len());
}

fn padded<R: Real, const N: usize>(quantities: [R; N]) -> [R; 4] {
    let mut all = [R::ZERO; 4];
    all[..N].copy_from_slice(&quantities);
    all
}
