//! What rounding errors are worth. A plan may be exact for end states that differ from the given ones by rounding errors.
//!
//! An ulp of `x` is `ε |x|`, and one operation adds half an ulp. There are three levels; docs/rounding.md has the tolerances that are none of them.

use crate::real::Real;

/// Of a formula: eight operations.
pub(crate) fn of_formula<R: Real>(size: R) -> R {
    R::from(4) * R::EPSILON * size
}

/// Of a state that a plan gave: eight phases with four operations each.
pub(crate) fn of_state<R: Real>(size: R) -> R {
    R::from(16) * R::EPSILON * size
}

/// Of a check: the states at both ends, which the plan gave and which the check computes.
pub(crate) fn of_check<R: Real>(size: R) -> R {
    R::DOUBT * size
}
