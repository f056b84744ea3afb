//! `atraj.h`: what liba does not have.

use super::a_float;
use super::trajbell::a_trajbell;
use crate::Bell;

#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_bell_sample(
    ctx: *const a_trajbell,
    x0: a_float,
    dt: a_float,
    n: usize,
    pos: *mut a_float,
    vel: *mut a_float,
    acc: *mut a_float,
    jer: *mut a_float,
) -> usize {
    // SAFETY: `ctx` is NULL or valid by the contract of this module, and the layouts are the same.
    let Some(bell) = (unsafe { ctx.cast::<Bell<a_float>>().as_ref() }) else {
        return 0;
    };
    // SAFETY:
    let outputs = unsafe { [pos, vel, acc, jer].map(|output| slice(output, n)) };
    bell.sample_into(x0, dt, outputs);
    n
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn atraj_bell_state(
    ctx: *const a_trajbell,
    x: a_float,
    pos: *mut a_float,
    vel: *mut a_float,
    acc: *mut a_float,
    jer: *mut a_float,
) {
    // SAFETY: `ctx` is NULL or valid by the contract of this module, and the layouts are the same.
    let Some(bell) = (unsafe { ctx.cast::<Bell<a_float>>().as_ref() }) else {
        return;
    };
    for (output, value) in [pos, vel, acc, jer].into_iter().zip(bell.state(x)) {
        if let Some(output) = unsafe { output.as_mut() } {
            *output = value;
        }
    }
}

unsafe fn slice<'a>(output: *mut a_float, n: usize) -> &'a mut [a_float] {
    if output.is_null() {
        &mut []
    } else {
        // SAFETY:
        unsafe { core::slice::from_raw_parts_mut(output, n) }
    }
}
