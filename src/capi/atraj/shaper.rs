//! `atraj/shaper.h`: input shapers.

use super::r#move::{atraj_move, atraj_state};
use super::{answer, put, write_state};
use crate::capi::a::trajbell::a_trajbell;
use crate::capi::{Number, a_float, assert_same_layout, of, of_mut};
use crate::findings::{Error, Findings};
use crate::machine::shaper::{Shaper, ShaperKind};
use core::ffi::{c_int, c_uint};

/// How a shaper meets a frequency that is not exactly known.
#[repr(C)]
pub enum atraj_shaper_kind {
    /// zero vibration: 1/2 period longer; less than 5 % is left of the vibration of an undamped load whose frequency is wrong by 3 %
    ATRAJ_SHAPER_ZV,
    /// zero vibration and zero derivative: 1 period longer, 14 %
    ATRAJ_SHAPER_ZVD,
    /// zero vibration by three impulses, 3/8 of a period apart: 3/4 period longer, 5 %
    ATRAJ_SHAPER_MZV,
    /// extra insensitive: 1 period longer, 20 %
    ATRAJ_SHAPER_EI,
    /// extra insensitive with two humps: 3/2 periods longer, 36 %
    ATRAJ_SHAPER_EI2,
}

/// @brief A mean of a move at several times. It leaves little vibration at its frequencies.
#[repr(C)]
pub struct atraj_shaper {
    /// how much longer a shaped move takes, s
    pub t: a_float,
    /// each impulse is a mean over this time, s
    pub smoothing: a_float,
    /// number of impulses
    pub count: c_uint,
    /// the weights of the impulses; their sum is 1
    pub weights: [a_float; 16],
    /// when the impulses come, s
    pub delays: [a_float; 16],
}
assert_same_layout!(atraj_shaper, Shaper<Number>, t = duration smoothing count weights delays);

/// @brief Make a shaper for a load that swings.
/// @param kind one of `atraj_shaper_kind`
/// @param frequency of the load, Hz; `damping`: a part of the critical damping
/// @return 0; else an `atraj_error`: `ATRAJ_ERR_NULL`, `ATRAJ_ERR_DURATION` if the frequency is not above 0 or has no
/// finite period, or `ATRAJ_ERR_LIMITS` if there is no such kind or the damping is not from 0 to below 1
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_shaper_init(
    ctx: *mut atraj_shaper, kind: c_int, frequency: a_float, damping: a_float,
) -> c_int {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    unsafe { put(ctx, || Shaper::new(kind_of(kind)?, frequency.into(), damping.into())) }
}

/// @brief Shape the shaped motion once more: for another frequency of the load. The impulses of both are multiplied.
/// @return as `atraj_shaper_init`; `ATRAJ_ERR_LIMITS` also if there are more than 16 impulses
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_shaper_add(
    ctx: *mut atraj_shaper, kind: c_int, frequency: a_float, damping: a_float,
) -> c_int {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    answer(|| unsafe {
        let shaper = of_mut(ctx)?;
        let added = kind_of(kind).and_then(|kind| shaper.add(kind, frequency.into(), damping.into()));
        Some(added.map(|()| Findings::default()))
    })
}

/// @brief Make a shaper without a frequency: the motion becomes its mean over a time, so that its acceleration changes evenly.
///
/// The derivative of the jerk is at most twice the limit of the jerk, divided by the time. `atraj_shaper_add` adds frequencies.
/// @param time over which the mean is taken, s; 0: the shaper changes nothing
/// @return 0; else an `atraj_error`: `ATRAJ_ERR_NULL`, or `ATRAJ_ERR_DURATION` if the time is negative or not finite
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_shaper_smooth(ctx: *mut atraj_shaper, time: a_float) -> c_int {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    unsafe { put(ctx, || Shaper::smooth(time.into())) }
}

/// @brief The shaped motion of a move at the time `x`: it keeps every limit of the move, starts and ends where the move
/// does, and takes `t` of the shaper longer. Before its start a move is taken to go on with the velocity that it has
/// there.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_shaper_state(
    ctx: *const atraj_shaper, r#move: *const atraj_move, x: a_float, now: *mut atraj_state,
) {
    // SAFETY: the pointers are NULL or valid by the contract of this module.
    unsafe { write_state(now, of(ctx).zip(of(r#move)).map(|(shaper, of)| shaper.state(of, x.into()))) };
}

/// @brief The shaped motion of a bell-shaped velocity trajectory, as of a move. After its end, too, it is taken to go
/// on with the velocity that it has there.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_shaper_bell_state(
    ctx: *const atraj_shaper, bell: *const a_trajbell, x: a_float, now: *mut atraj_state,
) {
    // SAFETY: the pointers are NULL or valid by the contract of this module.
    unsafe { write_state(now, of(ctx).zip(of(bell)).map(|(shaper, of)| shaper.bell_state(of, x.into()))) };
}

fn kind_of(kind: c_int) -> Result<ShaperKind, Error> {
    use atraj_shaper_kind::*;
    let kinds = [
        (ATRAJ_SHAPER_ZV, ShaperKind::Zv),
        (ATRAJ_SHAPER_ZVD, ShaperKind::Zvd),
        (ATRAJ_SHAPER_MZV, ShaperKind::Mzv),
        (ATRAJ_SHAPER_EI, ShaperKind::Ei),
        (ATRAJ_SHAPER_EI2, ShaperKind::Ei2),
    ];
    let mut named = kinds.into_iter().map(|(name, kind)| (name as c_int, kind));
    named.find_map(|(name, named)| (name == kind).then_some(named)).ok_or(Error::Limits)
}
