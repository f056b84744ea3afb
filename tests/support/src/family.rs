//! The five families of profiles: their arguments, fields, borders and quantities.

use crate::prelude::*;
use crate::profiles::{BELL_FIELDS, TRAP_FIELDS, bell, trap};

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Family {
    Bell,
    Trap,
    Poly3,
    Poly5,
    Poly7,
}

pub const MOST_ARGUMENTS: usize = Family::Poly7.arguments().len(); // the most arguments a family's `gen` has
pub const MOST_FIELDS: usize = Family::Poly7.fields().len(); // the most reals a family's struct holds
pub const MOST_BORDERS: usize = 9; // the most borders a family has, which are the borders of the bell

pub struct Quantity {
    pub name: &'static str, // its name
    pub c: &'static str,    // how the name of its C function ends
}

pub const QUANTITIES: [Quantity; 4] = [
    Quantity { name: "position", c: "pos" },
    Quantity { name: "velocity", c: "vel" },
    Quantity { name: "acceleration", c: "acc" },
    Quantity { name: "jerk", c: "jer" },
];

struct Description {
    name: &'static str,
    c_name: &'static str,
    arguments: &'static [&'static str],
    quantities: usize,
    fields: &'static [&'static str],
}

#[rustfmt::skip]
const DESCRIPTIONS: &[Description; 5] = &[
    Description { name: "bell", c_name: "trajbell", quantities: 4, fields: &BELL_FIELDS,
        arguments: &["jm", "am", "vm", "p0", "p1", "v0", "v1"] },
    Description { name: "trap", c_name: "trajtrap", quantities: 3, fields: &TRAP_FIELDS,
        arguments: &["vm", "ac", "de", "p0", "p1", "v0", "v1"] },
    Description { name: "poly3", c_name: "trajpoly3", quantities: 3,
        arguments: &["ts", "p0", "p1", "v0", "v1"], fields: &[
            "p[0]", "p[1]", "p[2]", "p[3]",
            "v[0]", "v[1]", "v[2]",
            "a[0]", "a[1]",
        ] },
    Description { name: "poly5", c_name: "trajpoly5", quantities: 3,
        arguments: &["ts", "p0", "p1", "v0", "v1", "a0", "a1"], fields: &[
            "p[0]", "p[1]", "p[2]", "p[3]", "p[4]", "p[5]",
            "v[0]", "v[1]", "v[2]", "v[3]", "v[4]",
            "a[0]", "a[1]", "a[2]", "a[3]",
        ] },
    Description { name: "poly7", c_name: "trajpoly7", quantities: 4,
        arguments: &["ts", "p0", "p1", "v0", "v1", "a0", "a1", "j0", "j1"], fields: &[
            "p[0]", "p[1]", "p[2]", "p[3]", "p[4]", "p[5]", "p[6]", "p[7]",
            "v[0]", "v[1]", "v[2]", "v[3]", "v[4]", "v[5]", "v[6]",
            "a[0]", "a[1]", "a[2]", "a[3]", "a[4]", "a[5]",
            "j[0]", "j[1]", "j[2]", "j[3]", "j[4]",
        ] },
];

impl Family {
    pub const ALL: [Self; 5] = [Self::Bell, Self::Trap, Self::Poly3, Self::Poly5, Self::Poly7];

    const fn description(self) -> &'static Description {
        &DESCRIPTIONS[self as usize]
    }

    pub const fn name(self) -> &'static str {
        self.description().name
    }

    pub const fn c_name(self) -> &'static str {
        self.description().c_name
    }

    pub const fn arguments(self) -> &'static [&'static str] {
        self.description().arguments
    }

    /// Fields of the struct, in order of memory. A C struct is nothing but reals, so their array is its layout.
    pub const fn fields(self) -> &'static [&'static str] {
        self.description().fields
    }

    pub fn quantities(self) -> &'static [Quantity] {
        &QUANTITIES[..self.description().quantities]
    }

    pub const fn is_polynomial(self) -> bool {
        !matches!(self, Self::Bell | Self::Trap)
    }

    pub fn borders<R: Real>(self, arguments: &[R], fields: &[R]) -> Vec<R> {
        let start = R::ZERO;
        match self {
            Self::Bell => {
                let Bell { t, tv, ta, td, taj, tdj, .. } = bell(fields);
                let borders: [R; MOST_BORDERS] = [start, taj, ta - taj, ta, ta + tv, t - td, t - td + tdj, t - tdj, t];
                borders.to_vec()
            }
            Self::Trap => {
                let Trap { t, ta, cruise_end, .. } = trap(fields);
                vec![start, ta, cruise_end, t]
            }
            Self::Poly3 | Self::Poly5 | Self::Poly7 => vec![start, arguments[0]],
        }
    }
}
