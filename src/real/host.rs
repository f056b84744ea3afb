//! What a processor with an operating system does in its own way: it predicts branches and computes ahead of them, and has room for code.

use super::primitives::Primitives;

/// The square root, correctly rounded; NaN below zero.
///
/// LLVM emits a bare instruction only if the argument cannot be negative. Any other root comes with a call for negative
/// arguments, and values have to be saved around the call.
pub fn sqrt<R: Primitives>(x: R) -> R {
    if x < R::ZERO { R::NAN } else { x.abs().plain_sqrt().copysign(x) }
}

/// The displacement `h` and two velocities in the axis in which the displacement is not below zero.
///
/// Moves back and forth mispredict a branch. A product with the direction does not.
pub fn forward<R: Primitives>(h: R, v0: R, v1: R) -> [R; 3] {
    let direction = R::ONE.copysign(if h < R::ZERO { h } else { R::ZERO });
    [h * direction, v0 * direction, v1 * direction]
}

/// Leaves a branch to the compiler, which may compute both sides and select one.
pub fn keep_branch() {}

/// Whether the short cut of liba's search pays: one division serves all rounds that it skips.
pub fn skipping_rounds_pays(_has_unit: bool) -> bool {
    true
}

/// Whether samples are better taken one by one: in fewer samples than `enough`, looking for runs takes longer than it saves.
pub fn samples_are_few(count: i32, enough: i32) -> bool {
    count < enough
}

/// All quantities of an instant, computed in one place for every phase: fast and large.
pub fn state<S>(_each: impl FnOnce() -> S, together: impl FnOnce() -> S) -> S {
    together()
}
