//! What a microcontroller does in its own way: flash is scarce, and hardly any pipeline waits for a branch.

use super::primitives::Primitives;

/// The square root, correctly rounded; NaN below zero.
pub fn sqrt<R: Primitives>(x: R) -> R {
    x.plain_sqrt()
}

/// The displacement `h` and two velocities in the axis in which the displacement is not below zero.
///
/// A branch skips the work.
pub fn forward<R: Primitives>(h: R, v0: R, v1: R) -> [R; 3] {
    if h < R::ZERO {
        keep_branch();
        [-h, -v0, -v1]
    } else {
        [h, v0, v1]
    }
}

/// Keeps the branch around the call. Otherwise the compiler computes both sides and selects one, which pays only where a processor predicts branches.
pub fn keep_branch() {
    core::sync::atomic::compiler_fence(core::sync::atomic::Ordering::SeqCst);
}

/// Whether the short cut of liba's search pays: a processor with a unit takes a literal round nearly as fast, and has no flash to spare.
pub fn skipping_rounds_pays(has_unit: bool) -> bool {
    !has_unit
}

/// Whether samples are better taken one by one: always, because looking for runs takes flash.
pub fn samples_are_few(_count: i32, _enough: i32) -> bool {
    true
}

/// All quantities of an instant, each by its own function: small.
pub fn state<S>(each: impl FnOnce() -> S, _together: impl FnOnce() -> S) -> S {
    each()
}
