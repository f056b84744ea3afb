//! `a/trajtrap.h`: the trapezoidal profile.

use crate::capi::{Number, SATURATION, a_float, assert_same_layout, boundary, of, of_mut, value};
use crate::liba::Trap;

/// @brief Trapezoidal velocity trajectory.
///
/// Acceleration and velocity are limited. All values are signed. In a forward move the deceleration is negative; in a backward move
/// the acceleration is negative.
#[repr(C)]
pub struct a_trajtrap {
    /// total duration, s
    pub t: a_float,
    /// initial position
    pub p0: a_float,
    /// final position
    pub p1: a_float,
    /// initial velocity
    pub v0: a_float,
    /// final velocity that the move reaches
    pub v1: a_float,
    /// constant velocity; without a cruise, the highest velocity that the move reaches
    pub vc: a_float,
    /// time before constant velocity, s
    pub ta: a_float,
    /// time after constant velocity, s
    pub td: a_float,
    /// position before constant velocity
    pub pa: a_float,
    /// position after constant velocity
    pub pd: a_float,
    /// acceleration before constant velocity
    pub ac: a_float,
    /// acceleration after constant velocity
    pub de: a_float,
}
assert_same_layout!(a_trajtrap, Trap<Number>, t p0 p1 v0 v1 vc ta td = cruise_end pa pd ac = a0 de = a1);

/// @brief Plan a trapezoidal velocity trajectory.
///
/// Both slopes meet at the squared velocity `c = (v1^2*ac - v0^2*de - 2*(p1-p0)*ac*de)/(ac-de)`. If `c > vm^2`, the
/// move cruises at `vm`. Otherwise it peaks at `sqrt(c)`. If the distance is too short to reach `v1`, the move only
/// speeds up or only slows down, and the struct's `v1` is the velocity at its end.
/// @param vm maximum velocity, unit/s; its sign is ignored
/// @param ac acceleration before constant velocity, unit/s^2, `de` after it; both with their signs; they must differ
/// @param p0 initial position, unit; `p1` final position
/// @param v0 initial velocity, unit/s; `v1` final velocity; both are limited to -vm .. vm
/// @return total duration, s; 0 if no such trajectory exists or `ctx` is NULL. A NaN argument gives NaN or 0.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajtrap_gen(
    ctx: *mut a_trajtrap, vm: a_float, ac: a_float, de: a_float, p0: a_float, p1: a_float, v0: a_float, v1: a_float,
) -> a_float {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    let Some(trap) = (unsafe { of_mut(ctx) }) else { return 0.0 };
    let boundary = boundary(p0, p1, v0, v1);
    trap.plan_saturated(vm.into(), ac.into(), de.into(), boundary, SATURATION).map_or(0.0, Into::into)
}

/// @brief Position, unit: `p0` before the start and for a NaN `x`, `p1` after the end.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajtrap_pos(ctx: *const a_trajtrap, x: a_float) -> a_float {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    value(unsafe { of(ctx) }, |trap| trap.position(x.into()))
}

/// @brief Velocity, unit/s: `v0` before the start and for a NaN `x`, `v1` after the end.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajtrap_vel(ctx: *const a_trajtrap, x: a_float) -> a_float {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    value(unsafe { of(ctx) }, |trap| trap.velocity(x.into()))
}

/// @brief Acceleration, unit/s^2: 0 outside the move and for a NaN `x`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajtrap_acc(ctx: *const a_trajtrap, x: a_float) -> a_float {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    value(unsafe { of(ctx) }, |trap| trap.acceleration(x.into()))
}
