//! `atraj.h`: what liba does not have.

mod axes;
mod axis;
mod clock;
mod codes;
mod group;
mod r#move;
mod path;
mod profiles;
mod shaper;
mod steps;

pub use axes::*;
pub use axis::*;
pub use clock::*;
pub use codes::*;
pub use group::*;
pub use r#move::*;
pub use path::*;
pub use profiles::*;
pub use shaper::*;
pub use steps::*;

use super::{Face, Number, a_float};
use crate::findings::{Error, Extremes, Findings};
use crate::sampling::MOST_SAMPLES;
use crate::state::State;
use core::ffi::c_int;

/// What C gets for findings, or for an error; `ATRAJ_ERR_NULL` without an answer.
fn answer(plan: impl FnOnce() -> Option<Result<Findings, Error>>) -> c_int {
    match plan() {
        Some(Ok(findings)) => findings.bits().into(),
        Some(Err(error)) => error as c_int,
        None => ATRAJ_ERR_NULL as c_int,
    }
}

/// What `answer` takes for a function that finds nothing.
fn done(result: Result<(), Error>) -> Option<Result<Findings, Error>> {
    Some(result.map(|()| Findings::default()))
}

/// Writes what is made; `ATRAJ_ERR_NULL` if `ctx` is NULL, or nothing is made because another pointer is.
///
/// # Safety
/// `ctx` is NULL or writable.
unsafe fn put<C: Face>(ctx: *mut C, make: impl FnOnce() -> Option<Result<C::Core, Error>>) -> c_int {
    let put = |made| {
        // SAFETY: not NULL, so writable by the contract of this function.
        unsafe { ctx.cast::<C::Core>().write(made) };
        Findings::default()
    };
    answer(|| if ctx.is_null() { None } else { Some(make()?.map(put)) })
}

/// The `n` values at `list`; `None` for NULL.
///
/// # Safety
/// `list` is NULL, or points to `n` values that nobody changes as long as the result lives.
unsafe fn list<'a, C: Face>(list: *const C, n: usize) -> Option<&'a [C::Core]> {
    // SAFETY: not NULL, so valid by the contract of this function; the layouts are the same.
    (!list.is_null()).then(|| unsafe { core::slice::from_raw_parts(list.cast(), n) })
}

/// The `n` values at `list`; `None` for NULL.
///
/// # Safety
/// `list` is NULL, or has room for `n` values that nobody else uses as long as the result lives.
unsafe fn list_mut<'a, C: Face>(list: *mut C, n: usize) -> Option<&'a mut [C::Core]> {
    // SAFETY: not NULL, so valid by the contract of this function; the layouts are the same.
    (!list.is_null()).then(|| unsafe { core::slice::from_raw_parts_mut(list.cast(), n) })
}

/// Fills the outputs with `n` samples, or with the most that there may be. Returns how many, 0 without a context. A NULL output gets nothing.
///
/// # Safety
/// Each output is NULL, or has room for `n` values that nobody else uses.
unsafe fn sample<T, const N: usize>(
    ctx: Option<&T>, outputs: [*mut a_float; N], n: usize, fill: impl FnOnce(&T, [&mut [Number]; N]) -> usize,
) -> usize {
    let n = n.min(MOST_SAMPLES);
    // SAFETY: by the contract of this function.
    let outputs = outputs.map(|output| unsafe { list_mut(output, n) }.unwrap_or_default());
    ctx.map_or(0, |ctx| {
        fill(ctx, outputs);
        n
    })
}

/// Writes the extremes where an output is not NULL; nothing without extremes.
///
/// # Safety
/// Each output is NULL or has room for three values.
unsafe fn write_extremes(extremes: Option<Extremes<Number>>, lowest: *mut a_float, highest: *mut a_float) {
    if let Some(Extremes { lowest: low, highest: high }) = extremes {
        // SAFETY: by the contract of this function; a state is three numbers.
        unsafe {
            write_state(lowest.cast(), Some(low));
            write_state(highest.cast(), Some(high));
        }
    }
}

/// Writes a state, or NaN without one. A NULL output gets nothing.
///
/// # Safety
/// `now` is NULL or writable.
unsafe fn write_state(now: *mut atraj_state, state: Option<State<Number>>) {
    let nan = a_float::NAN.into();
    let state = state.unwrap_or(State { position: nan, velocity: nan, acceleration: nan });
    if !now.is_null() {
        // SAFETY: by the contract of this function; the layouts are the same.
        unsafe { now.cast::<State<Number>>().write(state) };
    }
}

/// Writes each value to its output, or NaN without values. A NULL output gets nothing.
///
/// # Safety
/// Each output is NULL or writable.
unsafe fn write<const N: usize>(outputs: [*mut a_float; N], values: Option<[Number; N]>) {
    let values = values.map_or([a_float::NAN; N], |values| values.map(Into::into));
    for (output, value) in outputs.into_iter().zip(values) {
        if !output.is_null() {
            // SAFETY: by the contract of this function.
            unsafe { output.write(value) };
        }
    }
}
