//! The C ABI of the trajectory functions, declared by hand from the numerical contract, and the libraries linked under it.
//! Every struct is nothing but reals, so a pointer to the first one stands for it.

use crate::family::{Family, Implementation};
use crate::real::OracleReal;

/// The functions of one library in one real type.
#[allow(missing_docs)]
pub struct Abi<R: 'static> {
    pub bell: Gen7<R>,
    pub trap: Gen7<R>,
    pub poly3: unsafe extern "C" fn(*mut R, R, R, R, R, R),
    pub poly5: unsafe extern "C" fn(*mut R, R, R, R, R, R, R, R),
    pub poly7: unsafe extern "C" fn(*mut R, R, R, R, R, R, R, R, R, R),
    pub evaluations: [&'static [Evaluate<R>]; 5],
}

/// `gen` of the bell and of the trapezoid.
pub type Gen7<R> = unsafe extern "C" fn(*mut R, R, R, R, R, R, R, R) -> R;
/// `pos`, `vel`, `acc` or `jer`.
pub type Evaluate<R> = unsafe extern "C" fn(*const R, R) -> R;

impl<R: Copy + From<u8>> Implementation<R> for Abi<R> {
    fn plan(&self, family: Family, arguments: &[R], fields: &mut [R]) -> R {
        assert_eq!(fields.len(), family.fields().len());
        let ctx = fields.as_mut_ptr();
        // SAFETY: `ctx` points to as many reals as the family's struct has.
        unsafe {
            match (family, arguments) {
                (Family::Bell, &[jm, am, vm, p0, p1, v0, v1]) => {
                    return (self.bell)(ctx, jm, am, vm, p0, p1, v0, v1);
                }
                (Family::Trap, &[vm, ac, de, p0, p1, v0, v1]) => {
                    return (self.trap)(ctx, vm, ac, de, p0, p1, v0, v1);
                }
                (Family::Poly3, &[ts, p0, p1, v0, v1]) => (self.poly3)(ctx, ts, p0, p1, v0, v1),
                (Family::Poly5, &[ts, p0, p1, v0, v1, a0, a1]) => {
                    (self.poly5)(ctx, ts, p0, p1, v0, v1, a0, a1);
                }
                (Family::Poly7, &[ts, p0, p1, v0, v1, a0, a1, j0, j1]) => {
                    (self.poly7)(ctx, ts, p0, p1, v0, v1, a0, a1, j0, j1);
                }
                _ => panic!("{family:?} has not {} arguments", arguments.len()),
            }
        }
        R::from(0)
    }

    fn evaluate(&self, family: Family, fields: &[R], x: R) -> [R; 4] {
        assert_eq!(fields.len(), family.fields().len());
        let mut values = [R::from(0); 4];
        for (value, function) in values.iter_mut().zip(self.evaluations[family as usize]) {
            // SAFETY: `fields` has as many reals as the family's struct.
            *value = unsafe { function(fields.as_ptr(), x) };
        }
        values
    }
}

/// The functions of one real type whose names begin with a prefix.
macro_rules! library {
    ($real:ident, $prefix:literal) => {
        {
            type R = $real;
            unsafe extern "C" {
                #[link_name = concat!($prefix, "trajbell_gen")]
                fn bell_gen(_: *mut R, _: R, _: R, _: R, _: R, _: R, _: R, _: R) -> R;
                #[link_name = concat!($prefix, "trajtrap_gen")]
                fn trap_gen(_: *mut R, _: R, _: R, _: R, _: R, _: R, _: R, _: R) -> R;
                #[link_name = concat!($prefix, "trajpoly3_gen")]
                fn poly3_gen(_: *mut R, _: R, _: R, _: R, _: R, _: R);
                #[link_name = concat!($prefix, "trajpoly5_gen")]
                fn poly5_gen(_: *mut R, _: R, _: R, _: R, _: R, _: R, _: R, _: R);
                #[link_name = concat!($prefix, "trajpoly7_gen")]
                fn poly7_gen(_: *mut R, _: R, _: R, _: R, _: R, _: R, _: R, _: R, _: R, _: R);
            }
            library!(@evaluations $prefix,
                BELL "trajbell_pos" "trajbell_vel" "trajbell_acc" "trajbell_jer",
                TRAP "trajtrap_pos" "trajtrap_vel" "trajtrap_acc",
                POLY3 "trajpoly3_pos" "trajpoly3_vel" "trajpoly3_acc",
                POLY5 "trajpoly5_pos" "trajpoly5_vel" "trajpoly5_acc",
                POLY7 "trajpoly7_pos" "trajpoly7_vel" "trajpoly7_acc" "trajpoly7_jer");
            Abi {
                bell: bell_gen,
                trap: trap_gen,
                poly3: poly3_gen,
                poly5: poly5_gen,
                poly7: poly7_gen,
                evaluations: [BELL, TRAP, POLY3, POLY5, POLY7],
            }
        }
    };
    (@evaluations $prefix:literal, $($family:ident $($symbol:literal)*),*) => {$(
        const $family: &[Evaluate<R>] = &[$({
            unsafe extern "C" {
                #[link_name = concat!($prefix, $symbol)]
                fn evaluate(_: *const R, _: R) -> R;
            }
            evaluate
        }),*];
    )*};
}

/// A real type in which the original is linked.
pub trait Original: OracleReal {
    /// The original's functions.
    const ORIGINAL: Abi<Self>;
}
impl Original for f64 {
    const ORIGINAL: Abi<f64> = library!(f64, "c8_");
}
impl Original for f32 {
    const ORIGINAL: Abi<f32> = library!(f32, "c4_");
}
