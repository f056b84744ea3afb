//! `a/trajbell.h`: the double-S profile.

use crate::capi::{Number, SATURATION, a_float, assert_same_layout, boundary, of, of_mut, value};
use crate::liba::Bell;

/// @brief Bell-shaped (double-S) velocity trajectory.
///
/// Jerk, acceleration and velocity are limited. A move towards smaller positions (`p0 > p1`) is planned on the mirrored axis, and
/// `vm`, `jm`, `am` and `dm` belong to the mirrored axis. `v0` and `v1` belong to the caller's axis in every move.
#[repr(C)]
pub struct a_trajbell {
    /// total duration, s
    pub t: a_float,
    /// duration of the phase of constant velocity, s
    pub tv: a_float,
    /// duration of the acceleration phase, s
    pub ta: a_float,
    /// duration of the deceleration phase, s
    pub td: a_float,
    /// duration of each of the two intervals of constant jerk in the acceleration phase, s
    pub taj: a_float,
    /// duration of each of the two intervals of constant jerk in the deceleration phase, s
    pub tdj: a_float,
    /// initial position
    pub p0: a_float,
    /// final position
    pub p1: a_float,
    /// initial velocity
    pub v0: a_float,
    /// final velocity
    pub v1: a_float,
    /// highest velocity that the move reaches
    pub vm: a_float,
    /// jerk
    pub jm: a_float,
    /// highest acceleration that the move reaches
    pub am: a_float,
    /// highest deceleration that the move reaches, negative
    pub dm: a_float,
}
assert_same_layout!(a_trajbell, Bell<Number>, t tv ta td taj tdj p0 p1 v0 v1 vm jm am dm);

/// @brief Plan a bell-shaped velocity trajectory.
///
/// If there is room to cruise, the velocity rises by `D = vm - v0`. If `D*jm < am^2`, the rise has `taj = sqrt(D/jm)`
/// and `ta = 2*taj`; otherwise it has `taj = am/jm` and `ta = taj + D/am`. The fall from `vm` to `v1` has the mirrored
/// form. The cruise lasts `tv = (p1-p0)/vm - ta/2*(1+v0/vm) - td/2*(1+v1/vm)`.
///
/// If there is no room to cruise, a search by halved steps finds the highest acceleration whose ramps fit into the
/// distance.
/// @param jm maximum jerk, unit/s^3; `am` acceleration, unit/s^2; `vm` velocity, unit/s; their signs are ignored
/// @param p0 initial position, unit; `p1` final position
/// @param v0 initial velocity, unit/s; `v1` final velocity; both are limited to -vm .. vm
/// @return total duration, s; 0 if no such trajectory exists or `ctx` is NULL. A NaN argument gives NaN or 0.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajbell_gen(
    ctx: *mut a_trajbell, jm: a_float, am: a_float, vm: a_float, p0: a_float, p1: a_float, v0: a_float, v1: a_float,
) -> a_float {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    let Some(bell) = (unsafe { of_mut(ctx) }) else { return 0.0 };
    let boundary = boundary(p0, p1, v0, v1);
    bell.plan_saturated(jm.into(), am.into(), vm.into(), boundary, SATURATION).map_or(0.0, Into::into)
}

/// @brief Position, unit: `p0` before the start, `p1` after the end and for a NaN `x`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajbell_pos(ctx: *const a_trajbell, x: a_float) -> a_float {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    value(unsafe { of(ctx) }, |bell| bell.position(x.into()))
}

/// @brief Velocity, unit/s: `v0` before the start, `v1` after the end and for a NaN `x`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajbell_vel(ctx: *const a_trajbell, x: a_float) -> a_float {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    value(unsafe { of(ctx) }, |bell| bell.velocity(x.into()))
}

/// @brief Acceleration, unit/s^2: 0 outside the move and for a NaN `x`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajbell_acc(ctx: *const a_trajbell, x: a_float) -> a_float {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    value(unsafe { of(ctx) }, |bell| bell.acceleration(x.into()))
}

/// @brief Jerk, unit/s^3: 0 outside the move and for a NaN `x`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn a_trajbell_jer(ctx: *const a_trajbell, x: a_float) -> a_float {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    value(unsafe { of(ctx) }, |bell| bell.jerk(x.into()))
}
