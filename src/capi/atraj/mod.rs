//! `atraj.h`: what liba does not have.

mod axes;
mod bell;
mod codes;
mod r#move;
mod poly;
mod sample;
mod trap;

pub use axes::*;
pub use bell::*;
pub use codes::*;
pub use r#move::*;
pub use poly::*;
pub use sample::*;
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
