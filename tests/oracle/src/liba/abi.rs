//! The C ABI of the trajectory functions, declared by hand from the numerical contract, and the libraries linked under it.
//! Every struct is nothing but reals, so a function takes a pointer to the first one.

use atraj::capi::a_float;
use libloading::Library;
use std::path::Path;
use support::{Family, Implementation, Real};

pub struct Abi<R: 'static> {
    pub bell: Gen7<R>,
    pub trap: Gen7<R>,
    pub poly3: unsafe extern "C" fn(*mut R, R, R, R, R, R),
    pub poly5: unsafe extern "C" fn(*mut R, R, R, R, R, R, R, R),
    pub poly7: unsafe extern "C" fn(*mut R, R, R, R, R, R, R, R, R, R),
    /// What has to be called after the polynomials' function above to fill the other coefficient arrays.
    pub derivations: [&'static [Derive<R>]; 3],
    pub evaluations: [&'static [Evaluate<R>]; 5],
}

/// The function of this name.
///
/// # Safety
/// The function has the type `F`, and nobody calls it when the library is no longer loaded.
unsafe fn loaded<F: Copy>(library: &Library, name: &str) -> F {
    // SAFETY: as above.
    *unsafe { library.get(name.as_bytes()) }.unwrap_or_else(|e| panic!("{e}"))
}

pub type Gen7<R> = unsafe extern "C" fn(*mut R, R, R, R, R, R, R, R) -> R;
pub type Evaluate<R> = unsafe extern "C" fn(*const R, R) -> R;

pub enum Derive<R> {
    Within(unsafe extern "C" fn(*mut R)),
    /// `c1`, `c2` or `c3`: from the struct, which holds the coefficients of position alone, into an array.
    Beyond(unsafe extern "C" fn(*const R, *mut R)),
}

impl<R: Real> Implementation<R> for Abi<R> {
    #[inline(always)] // for the benchmark, where each library has its own calls
    fn plan(&self, family: Family, arguments: &[R], fields: &mut [R]) -> R {
        assert_eq!(fields.len(), family.fields().len());
        let ctx = fields.as_mut_ptr();
        // SAFETY: `ctx` points to as many reals as the family's struct has.
        unsafe {
            match (family, arguments) {
                (Family::Bell, &[jm, am, vm, p0, p1, v0, v1]) => return (self.bell)(ctx, jm, am, vm, p0, p1, v0, v1),
                (Family::Trap, &[vm, ac, de, p0, p1, v0, v1]) => return (self.trap)(ctx, vm, ac, de, p0, p1, v0, v1),
                (Family::Poly3, &[ts, p0, p1, v0, v1]) => (self.poly3)(ctx, ts, p0, p1, v0, v1),
                (Family::Poly5, &[ts, p0, p1, v0, v1, a0, a1]) => (self.poly5)(ctx, ts, p0, p1, v0, v1, a0, a1),
                (Family::Poly7, &[ts, p0, p1, v0, v1, a0, a1, j0, j1]) => {
                    (self.poly7)(ctx, ts, p0, p1, v0, v1, a0, a1, j0, j1);
                }
                _ => panic!("{family:?} has not {} arguments", arguments.len()),
            }
        }
        self.derive(family, fields);
        R::ZERO
    }

    fn evaluate(&self, family: Family, fields: &[R], x: R) -> [R; 4] {
        assert_eq!(fields.len(), family.fields().len());
        let mut values = [R::ZERO; 4];
        for (value, function) in values.iter_mut().zip(self.evaluations[family as usize]) {
            // SAFETY: `fields` has as many reals as the family's struct.
            *value = unsafe { function(fields.as_ptr(), x) };
        }
        values
    }
}

impl<R> Abi<R> {
    pub fn load(file: &Path) -> Self {
        // SAFETY: our library runs nothing when it is loaded, its functions have these types, and nothing unloads it.
        unsafe {
            let library = Library::new(file).unwrap_or_else(|e| panic!("{e}"));
            let abi = Self {
                bell: loaded(&library, "a_trajbell_gen"),
                trap: loaded(&library, "a_trajtrap_gen"),
                poly3: loaded(&library, "a_trajpoly3_gen"),
                poly5: loaded(&library, "a_trajpoly5_gen"),
                poly7: loaded(&library, "a_trajpoly7_gen"),
                derivations: [&[]; 3],
                evaluations: Family::ALL.map(|family| {
                    let names = family.quantities().iter().map(|quantity| quantity.c);
                    let names = names.map(|name| format!("a_{}_{name}", family.c_name()));
                    let functions: Vec<_> = names.map(|name| loaded(&library, &name)).collect();
                    &*functions.leak()
                }),
            };
            std::mem::forget(library);
            abi
        }
    }

    fn derive(&self, polynomial: Family, fields: &mut [R]) {
        let (derivations, order) = match polynomial {
            Family::Poly3 => (self.derivations[0], 3),
            Family::Poly5 => (self.derivations[1], 5),
            _ => (self.derivations[2], 7),
        };
        let mut start = order + 1;
        for (index, derivation) in derivations.iter().enumerate() {
            // SAFETY: `fields` has as many reals as the family's struct, all coefficient arrays one after the other.
            unsafe {
                match derivation {
                    Derive::Within(function) => function(fields.as_mut_ptr()),
                    Derive::Beyond(function) => {
                        let (position, derivatives) = fields.split_at_mut(start);
                        function(position.as_ptr(), derivatives.as_mut_ptr());
                    }
                }
            }
            start += order - index;
        }
    }
}

macro_rules! c {
    ($($name:literal)+: fn($($argument:ty),*) $(-> $result:ty)?) => {{
        unsafe extern "C" {
            #[link_name = concat!($($name),+)]
            fn c($(_: $argument),*) $(-> $result)?;
        }
        c as unsafe extern "C" fn($($argument),*) $(-> $result)?
    }};
}

/// The functions of one library. Their names begin with `$prefix`. `$plan` plans a polynomial, and then `$derive`, a macro
/// that makes a [`Derive`] of a name, fills its other arrays.
macro_rules! library {
    ($R:ty, $prefix:literal, $plan:literal, $derive:ident[$($order:literal)*]) => {
        Abi::<$R> {
            bell: c!($prefix "trajbell_gen": fn(*mut $R, $R, $R, $R, $R, $R, $R, $R) -> $R),
            trap: c!($prefix "trajtrap_gen": fn(*mut $R, $R, $R, $R, $R, $R, $R, $R) -> $R),
            poly3: c!($prefix "trajpoly3_" $plan: fn(*mut $R, $R, $R, $R, $R, $R)),
            poly5: c!($prefix "trajpoly5_" $plan: fn(*mut $R, $R, $R, $R, $R, $R, $R, $R)),
            poly7: c!($prefix "trajpoly7_" $plan: fn(*mut $R, $R, $R, $R, $R, $R, $R, $R, $R, $R)),
            derivations: library!(@derivations $R, $prefix, $derive[$($order)*]),
            evaluations: [
                library!(@evaluations $R, $prefix "trajbell_", "pos" "vel" "acc" "jer"),
                library!(@evaluations $R, $prefix "trajtrap_", "pos" "vel" "acc"),
                library!(@evaluations $R, $prefix "trajpoly3_", "pos" "vel" "acc"),
                library!(@evaluations $R, $prefix "trajpoly5_", "pos" "vel" "acc"),
                library!(@evaluations $R, $prefix "trajpoly7_", "pos" "vel" "acc" "jer"),
            ],
        }
    };
    (@evaluations $R:ty, $prefix:literal $family:literal, $($name:literal)*) => {
        &[$(c!($prefix $family $name: fn(*const $R, $R) -> $R)),*]
    };
    (@derivations $R:ty, $prefix:literal, none[]) => {
        [&[], &[], &[]]
    };
    (@derivations $R:ty, $prefix:literal, $derive:ident[$first:literal $second:literal $third:literal]) => {
        [
            &[$derive!($R, $prefix "trajpoly3_" $first), $derive!($R, $prefix "trajpoly3_" $second)],
            &[$derive!($R, $prefix "trajpoly5_" $first), $derive!($R, $prefix "trajpoly5_" $second)],
            &[
                $derive!($R, $prefix "trajpoly7_" $first),
                $derive!($R, $prefix "trajpoly7_" $second),
                $derive!($R, $prefix "trajpoly7_" $third),
            ],
        ]
    };
}

macro_rules! within {
    ($R:ty, $($name:literal)+) => {
        Derive::Within(c!($($name)+: fn(*mut $R)))
    };
}

pub trait Original: Real {
    const ORIGINAL: Abi<Self>;
    const ORIGINAL_STEPWISE: Abi<Self>; // the original with every polynomial planned array by array
    const OPTIMISED: [Abi<Self>; 2]; // the original compiled with `-O2` and with `-O3`
}

impl Original for f64 {
    const ORIGINAL: Abi<f64> = library!(f64, "c8_", "gen", none[]);
    const ORIGINAL_STEPWISE: Abi<f64> = library!(f64, "c8_", "gen0", within["gen1" "gen2" "gen3"]);
    const OPTIMISED: [Abi<f64>; 2] = [library!(f64, "o2c8_", "gen", none[]), library!(f64, "o3c8_", "gen", none[])];
}

impl Original for f32 {
    const ORIGINAL: Abi<f32> = library!(f32, "c4_", "gen", none[]);
    const ORIGINAL_STEPWISE: Abi<f32> = library!(f32, "c4_", "gen0", within["gen1" "gen2" "gen3"]);
    const OPTIMISED: [Abi<f32>; 2] = [library!(f32, "o2c4_", "gen", none[]), library!(f32, "o3c4_", "gen", none[])];
}

/// Our C functions in the polynomial layout of liba 0.1.15.
#[cfg(not(feature = "poly-compact"))]
pub const OURS: Abi<a_float> = library!(a_float, "a_", "gen", none[]);

pub const FASTEST: [Gen7<a_float>; 2] = [
    c!("atraj_bell_gen": fn(*mut a_float, a_float, a_float, a_float, a_float, a_float, a_float, a_float) -> a_float),
    c!("atraj_trap_gen": fn(*mut a_float, a_float, a_float, a_float, a_float, a_float, a_float, a_float) -> a_float),
];

/// Our C functions with every polynomial planned array by array.
#[cfg(not(feature = "poly-compact"))]
pub const OURS_STEPWISE: Abi<a_float> = library!(a_float, "a_", "gen0", within["gen1" "gen2" "gen3"]);

/// Our C functions in the polynomial layout since 2025-03.
#[cfg(feature = "poly-compact")]
pub const OURS: Abi<a_float> = {
    macro_rules! beyond {
        ($R:ty, $($name:literal)+) => {
            Derive::Beyond(c!($($name)+: fn(*const $R, *mut $R)))
        };
    }
    library!(a_float, "a_", "gen", beyond["c1" "c2" "c3"])
};
