//! `atraj.h`: what liba does not have.

mod axes;
mod axis;
mod bell;
mod clock;
mod codes;
mod r#move;
mod path;
mod poly;
mod shaper;
mod steps;
mod trap;

pub use axes::*;
pub use axis::*;
pub use bell::*;
pub use clock::*;
pub use codes::*;
pub use r#move::*;
pub use path::*;
pub use poly::*;
pub use shaper::*;
pub use steps::*;
pub use trap::*;

use super::{Number, a_float};
use crate::findings::Extremes;

/// Writes the extremes where an output is not NULL.
///
/// # Safety
/// Each output is NULL or has room for three values.
unsafe fn write_extremes(extremes: Extremes<Number>, lowest: *mut a_float, highest: *mut a_float) {
    for (output, state) in [(lowest, extremes.lowest), (highest, extremes.highest)] {
        if !output.is_null() {
            let values = [state.position, state.velocity, state.acceleration].map(Into::into);
            // SAFETY: by the contract of this function.
            unsafe { output.cast::<[a_float; 3]>().write(values) };
        }
    }
}

/// The `n` values at `output`. A NULL output has no values.
///
/// # Safety
/// `output` is NULL, or has room for `n` values that nobody else uses.
unsafe fn array<'a, T>(output: *mut T, n: usize) -> &'a mut [T] {
    if output.is_null() {
        return &mut [];
    }
    // SAFETY: by the contract of this function.
    unsafe { core::slice::from_raw_parts_mut(output, n) }
}

/// Writes each value to its output. A NULL output gets nothing.
///
/// # Safety
/// Each output is NULL or writable.
unsafe fn write<const N: usize>(outputs: [*mut a_float; N], values: [a_float; N]) {
    for (output, value) in outputs.into_iter().zip(values) {
        if !output.is_null() {
            // SAFETY: by the contract of this function.
            unsafe { output.write(value) };
        }
    }
}
