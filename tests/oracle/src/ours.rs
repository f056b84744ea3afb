//! The Rust API under test, seen through arrays.

use crate::family::{Family, Implementation};
use crate::real::OracleReal;
use atraj::{Bell, Boundary, Poly3, Poly5, Poly7, Trap};

/// atraj's plain structs and methods, without the C ABI. Its polynomials hold the coefficients of position alone, so of
/// the fields of a polynomial only those are read.
pub struct Ours;

impl<R: OracleReal> Implementation<R> for Ours {
    fn plan(&self, family: Family, arguments: &[R], fields: &mut [R]) -> R {
        let zero = R::from(0);
        match (family, arguments) {
            (Family::Bell, &[jm, am, vm, p0, p1, v0, v1]) => {
                let mut bell = bell(fields);
                let duration = bell.plan(jm, am, vm, Boundary { p0, p1, v0, v1 });
                fields.copy_from_slice(&bell_fields(&bell));
                duration.unwrap_or(zero)
            }
            (Family::Trap, &[vm, ac, de, p0, p1, v0, v1]) => {
                let mut trap = trap(fields);
                let duration = trap.plan(vm, ac, de, Boundary { p0, p1, v0, v1 });
                fields.copy_from_slice(&trap_fields(&trap));
                duration.unwrap_or(zero)
            }
            (Family::Poly3, &[ts, p0, p1, v0, v1]) => {
                let c = Poly3::coefficients(ts, Boundary { p0, p1, v0, v1 });
                let poly = Poly3 { c };
                let (p, rest) = fields.split_at_mut(4);
                let (v, a) = rest.split_at_mut(3);
                p.copy_from_slice(&c);
                v.copy_from_slice(&poly.velocity_coefficients());
                a.copy_from_slice(&poly.acceleration_coefficients());
                zero
            }
            (Family::Poly5, &[ts, p0, p1, v0, v1, a0, a1]) => {
                let c = Poly5::coefficients(ts, Boundary { p0, p1, v0, v1 }, [a0, a1]);
                let poly = Poly5 { c };
                let (p, rest) = fields.split_at_mut(6);
                let (v, a) = rest.split_at_mut(5);
                p.copy_from_slice(&c);
                v.copy_from_slice(&poly.velocity_coefficients());
                a.copy_from_slice(&poly.acceleration_coefficients());
                zero
            }
            (Family::Poly7, &[ts, p0, p1, v0, v1, a0, a1, j0, j1]) => {
                let c = Poly7::coefficients(ts, Boundary { p0, p1, v0, v1 }, [a0, a1], [j0, j1]);
                let poly = Poly7 { c };
                let (p, rest) = fields.split_at_mut(8);
                let (v, rest) = rest.split_at_mut(7);
                let (a, j) = rest.split_at_mut(6);
                p.copy_from_slice(&c);
                v.copy_from_slice(&poly.velocity_coefficients());
                a.copy_from_slice(&poly.acceleration_coefficients());
                j.copy_from_slice(&poly.jerk_coefficients());
                zero
            }
            _ => panic!("{family:?} has not {} arguments", arguments.len()),
        }
    }

    fn evaluate(&self, family: Family, fields: &[R], x: R) -> [R; 4] {
        macro_rules! evaluate {
            ($profile:expr, $jerk:expr) => {{
                let profile = $profile;
                [
                    profile.position(x),
                    profile.velocity(x),
                    profile.acceleration(x),
                    $jerk(&profile),
                ]
            }};
            ($profile:expr) => {
                evaluate!($profile, |_| R::from(0))
            };
        }
        match family {
            Family::Bell => evaluate!(bell(fields), |bell: &Bell<R>| bell.jerk(x)),
            Family::Trap => evaluate!(trap(fields)),
            Family::Poly3 => evaluate!(Poly3 { c: head(fields) }),
            Family::Poly5 => evaluate!(Poly5 { c: head(fields) }),
            Family::Poly7 => {
                evaluate!(Poly7 { c: head(fields) }, |poly: &Poly7<R>| poly.jerk(x))
            }
        }
    }
}

fn head<R: Copy, const N: usize>(fields: &[R]) -> [R; N] {
    *fields.first_chunk().expect("the family's fields")
}

/// The struct that these fields are.
#[rustfmt::skip]
pub fn bell<R: Copy>(fields: &[R]) -> Bell<R> {
    let [t, tv, ta, td, taj, tdj, p0, p1, v0, v1, vm, jm, am, dm] = head(fields);
    Bell { t, tv, ta, td, taj, tdj, p0, p1, v0, v1, vm, jm, am, dm }
}

/// The fields of a struct.
#[rustfmt::skip]
pub fn bell_fields<R: Copy>(bell: &Bell<R>) -> [R; 14] {
    let &Bell { t, tv, ta, td, taj, tdj, p0, p1, v0, v1, vm, jm, am, dm } = bell;
    [t, tv, ta, td, taj, tdj, p0, p1, v0, v1, vm, jm, am, dm]
}

#[rustfmt::skip]
fn trap<R: Copy>(fields: &[R]) -> Trap<R> {
    let [t, p0, p1, v0, v1, vc, ta, td, pa, pd, ac, de] = head(fields);
    Trap { t, p0, p1, v0, v1, vc, ta, td, pa, pd, ac, de }
}

#[rustfmt::skip]
fn trap_fields<R: Copy>(trap: &Trap<R>) -> [R; 12] {
    let &Trap { t, p0, p1, v0, v1, vc, ta, td, pa, pd, ac, de } = trap;
    [t, p0, p1, v0, v1, vc, ta, td, pa, pd, ac, de]
}
