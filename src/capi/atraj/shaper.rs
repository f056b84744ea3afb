//! `atraj/shaper.h`: input shapers.

use super::r#move::{atraj_move, atraj_state};
use super::{answer, done, list_mut, put, write_state};
use crate::capi::{Number, a::trajbell::a_trajbell, a_float, assert_same_layout, of, of_mut};
use crate::findings::Error;
use crate::machine::{Shaper, ShaperKind, ShaperStream};
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
    unsafe { put(ctx, || Some(kind_of(kind).and_then(|kind| Shaper::new(kind, frequency.into(), damping.into())))) }
}

/// @brief Add another frequency of the load: the shaper is convolved with a second one.
/// @return as `atraj_shaper_init`; `ATRAJ_ERR_LIMITS` also if there are more than 16 impulses
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_shaper_add(
    ctx: *mut atraj_shaper, kind: c_int, frequency: a_float, damping: a_float,
) -> c_int {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    answer(|| unsafe {
        let shaper = of_mut(ctx)?;
        done(kind_of(kind).and_then(|kind| shaper.add(kind, frequency.into(), damping.into())))
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
    unsafe { put(ctx, || Some(Shaper::smooth(time.into()))) }
}

/// @brief The shaped motion of a move at `time`.
///
/// From rest to rest it keeps every limit of the move, starts and ends where the move does, and takes `t` of the shaper
/// longer. Before its start a move is taken to go on with the velocity that it has there. So an axis that is retargeted
/// in mid-motion would jump: `atraj_shaper_stream_tick` shapes it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_shaper_state(
    ctx: *const atraj_shaper, r#move: *const atraj_move, time: a_float, now: *mut atraj_state,
) {
    // SAFETY: the pointers are NULL or valid by the contract of this module.
    unsafe { write_state(now, of(ctx).zip(of(r#move)).map(|(shaper, of)| shaper.state(of, time.into()))) };
}

/// @brief The shaped motion of a bell-shaped velocity trajectory, as of a move. After its end, too, it is taken to go
/// on with the velocity that it has there.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_shaper_bell_state(
    ctx: *const atraj_shaper, bell: *const a_trajbell, time: a_float, now: *mut atraj_state,
) {
    // SAFETY: the pointers are NULL or valid by the contract of this module.
    unsafe { write_state(now, of(ctx).zip(of(bell)).map(|(shaper, of)| shaper.bell_state(of, time.into()))) };
}

/// @brief A shaper of a stream of states, one a tick, whatever makes them. Its members are the library's own.
#[repr(C)]
pub struct atraj_shaper_stream {
    /// the shaper, with its delays in ticks
    pub shaper: atraj_shaper,
    /// from one tick to the next, s
    pub period: a_float,
    /// what is added to a position for each unit of the velocity, s
    pub ahead: a_float,
    /// the sum of the last states
    pub mean: [a_float; 6],
    /// the next sum while it grows
    pub growing: [a_float; 6],
    /// of how many states the sum is
    pub ticks: c_uint,
    /// which of them is replaced next
    pub at: c_uint,
    /// how many means the impulses look back to
    pub means: c_uint,
    /// which of them is the newest
    pub at_mean: c_uint,
    /// for how many ticks the stream stands
    pub still: c_uint,
}
assert_same_layout!(atraj_shaper_stream, ShaperStream<Number>,
    shaper period ahead mean growing ticks at means at_mean still);

/// @brief How many numbers the delay line of a stream has.
/// @param period from one tick to the next, s
/// @return how many `a_float` the array `line` has; 0 if `ctx` is NULL, if the period is not above 0 or not finite, or if the
/// shaper takes more than 1048576 periods
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_shaper_size(ctx: *const atraj_shaper, period: a_float) -> usize {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    unsafe { of(ctx) }.and_then(|shaper| shaper.size(period.into())).unwrap_or(0)
}

/// @brief Begin to shape a stream of states, one a tick: of a move, of a clock, of a jog, retargeted at any time.
///
/// The shaped state is a mean of the states that the stream had before. So it keeps every limit of the stream, and
/// nothing jumps, whatever the stream does. A delay that is no multiple of the period is a mean of two ticks. A stream
/// in motion is taken to have had its velocity for long: so it starts later than `now` by the mean delay.
/// @param shaper points to the shaper, which is copied
/// @param period from one tick to the next, s
/// @param now points to the state of the stream
/// @param line points to `size` numbers, which need not be initialised. Each call for this stream takes the same ones.
/// @param size at least `atraj_shaper_size(shaper, period)`
/// @return 0; else an `atraj_error`: `ATRAJ_ERR_NULL` also if `size` is too small, `ATRAJ_ERR_DURATION` if
/// `atraj_shaper_size` is 0, or `ATRAJ_ERR_NOT_FINITE`
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_shaper_stream_init(
    ctx: *mut atraj_shaper_stream, shaper: *const atraj_shaper, period: a_float, now: *const atraj_state,
    line: *mut a_float, size: usize,
) -> c_int {
    // SAFETY: the pointers are NULL or valid by the contract of this module.
    unsafe { put(ctx, || Some(ShaperStream::new(of(shaper)?, period.into(), *of(now)?, list_mut(line, size)?))) }
}

/// @brief Add `advance` times the velocity to the position before it is shaped: the pressure advance of an extruder.
///
/// Velocity and acceleration follow; the acceleration follows the mean jerk over the smoothing time, so set one.
/// @param advance s; 0 at the start
/// @return 0; else `ATRAJ_ERR_NULL`, `ATRAJ_ERR_NOT_FINITE`, or `ATRAJ_ERR_MOVING` as in `atraj_shaper_stream_change`
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_shaper_stream_advance(ctx: *mut atraj_shaper_stream, advance: a_float) -> c_int {
    // SAFETY: `ctx` is NULL or valid by the contract of this module.
    answer(|| unsafe { done(of_mut(ctx)?.advance(advance.into())) })
}

/// @brief Take another shaper, while the stream stands.
/// @param shaper points to the shaper, which is copied
/// @param line points to `size` numbers: those of the stream
/// @return 0; else an `atraj_error`: `ATRAJ_ERR_NULL` also if `size` is below `atraj_shaper_size` of the new shaper,
/// `ATRAJ_ERR_DURATION` if that is 0, or `ATRAJ_ERR_MOVING` if the stream moves, or moved so shortly before that the
/// shaped state does. On an error the stream stays as it is.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_shaper_stream_change(
    ctx: *mut atraj_shaper_stream, shaper: *const atraj_shaper, line: *mut a_float, size: usize,
) -> c_int {
    // SAFETY: the pointers are NULL or valid by the contract of this module.
    answer(|| unsafe { done(of_mut(ctx)?.change(of(shaper)?, list_mut(line, size)?)) })
}

/// @brief Take the next state of the stream, and give the shaped one.
/// @param now points to the state of the stream in this tick
/// @param line points to the `size` numbers of the stream
/// @param shaped NULL or the place for the shaped state; NaN on an error. It may be `now`.
/// @return 0; else an `atraj_error`: `ATRAJ_ERR_NULL`, or `ATRAJ_ERR_NOT_FINITE`. Then the stream stays as it is.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_shaper_stream_tick(
    ctx: *mut atraj_shaper_stream, now: *const atraj_state, line: *mut a_float, size: usize, shaped: *mut atraj_state,
) -> c_int {
    let mut state = None;
    // SAFETY: the pointers are NULL or valid by the contract of this module.
    let code = answer(|| unsafe {
        let (stream, now, line) = (of_mut(ctx)?, *of(now)?, list_mut(line, size)?);
        done(stream.tick(now, line).map(|shaped| state = Some(shaped)))
    });
    // SAFETY: `shaped` is NULL or writable by the contract of this module.
    unsafe { write_state(shaped, state) };
    code
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
    kinds.into_iter().find_map(|(name, named)| (name as c_int == kind).then_some(named)).ok_or(Error::Limits)
}
