//! The structs of the Rust API as arrays: their fields, and their functions with any number of quantities.

use crate::prelude::*;

macro_rules! named_fields {
    ($profile:ident, $count:literal, $names:ident, $from:ident, $to:ident, $planned:ident, [$($field:ident = $c:ident),*]) => {
        pub const $names: [&str; $count] = [$(stringify!($c)),*];

        pub fn $from<R: Copy>(fields: &[R]) -> $profile<R> {
            let &[$($field),*] = fields else {
                panic!("{} fields instead of {}", fields.len(), $count);
            };
            $profile { $($field),* }
        }

        pub fn $to<R: Copy>(profile: &$profile<R>) -> [R; $count] {
            [$(profile.$field),*]
        }

        /// Makes a plan in the struct that has these fields, and writes them.
        pub fn $planned<R: Copy, T>(fields: &mut [R], plan: impl FnOnce(&mut $profile<R>) -> T) -> T {
            let mut profile = $from(fields);
            let planned = plan(&mut profile);
            fields.copy_from_slice(&$to(&profile));
            planned
        }
    };
}

#[rustfmt::skip]
named_fields!(
    Bell, 14, BELL_FIELDS, bell, bell_fields, bell_planned,
    [t = t, tv = tv, ta = ta, td = td, taj = taj, tdj = tdj, p0 = p0, p1 = p1, v0 = v0, v1 = v1, vm = vm, jm = jm, am = am, dm = dm]
);
#[rustfmt::skip]
named_fields!(
    Trap, 12, TRAP_FIELDS, trap, trap_fields, trap_planned,
    [t = t, p0 = p0, p1 = p1, v0 = v0, v1 = v1, vc = vc, ta = ta, cruise_end = td, pa = pa, pd = pd, a0 = ac, a1 = de]
);

pub fn poly3<R: Copy>(fields: &[R]) -> Poly3<R> {
    Poly3 { c: head(fields) }
}

pub fn poly5<R: Copy>(fields: &[R]) -> Poly5<R> {
    Poly5 { c: head(fields) }
}

pub fn poly7<R: Copy>(fields: &[R]) -> Poly7<R> {
    Poly7 { c: head(fields) }
}

fn head<R: Copy, const N: usize>(fields: &[R]) -> [R; N] {
    *fields.first_chunk().expect("the family's fields")
}

pub trait Profile<R, const N: usize> {
    fn each(&self, x: R) -> [R; N]; // the quantities at a time, a call each
    fn state(&self, x: R) -> [R; N]; // the quantities at a time, in one call
    fn states(&self, x0: R, dt: R, n: usize) -> Vec<[R; N]>; // the quantities at `n` times from an iterator
    fn sample_into(&self, x0: R, dt: R, outputs: [&mut [R]; N]) -> usize;
}

macro_rules! profile {
    ($profile:ident, $n:literal, $($quantity:ident)*) => {
        impl<R: Real> Profile<R, $n> for $profile<R> {
            fn each(&self, x: R) -> [R; $n] {
                [$(self.$quantity(x)),*]
            }
            fn state(&self, x: R) -> [R; $n] {
                self.state(x)
            }
            fn states(&self, x0: R, dt: R, n: usize) -> Vec<[R; $n]> {
                self.states(x0, dt).take(n).collect()
            }
            fn sample_into(&self, x0: R, dt: R, outputs: [&mut [R]; $n]) -> usize {
                self.sample_into(x0, dt, outputs)
            }
        }
    };
}
profile!(Bell, 4, position velocity acceleration jerk);
profile!(Trap, 3, position velocity acceleration);
profile!(Poly3, 4, position velocity acceleration jerk);
profile!(Poly5, 4, position velocity acceleration jerk);
profile!(Poly7, 4, position velocity acceleration jerk);
profile!(Move, 4, position velocity acceleration jerk);

pub fn move_borders<R: Real>(planned: &Move<R>) -> Vec<R> {
    let count = (planned.count as usize).min(planned.phase.len() - 1);
    planned.phase[..=count].iter().map(|phase| phase.start).collect()
}
