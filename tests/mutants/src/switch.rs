//! In the copy of the library: which mutant is on. The variable `MUTANT` of the environment holds its number.
#![allow(unsafe_code, missing_docs)]

use core::ffi::{c_char, c_int};
use core::sync::atomic::{AtomicU32, Ordering};

static ON: AtomicU32 = AtomicU32::new(u32::MAX);

unsafe extern "C" {
    fn getenv(name: *const c_char) -> *const c_char;
    fn atoi(text: *const c_char) -> c_int;
}

#[inline(always)]
pub fn is(number: u32) -> bool {
    let on = ON.load(Ordering::Relaxed);
    on == number || on == u32::MAX && read() == number
}

#[cold]
#[inline(never)]
fn read() -> u32 {
    // SAFETY: the name ends in a 0, and `atoi` reads what `getenv` found.
    let on = unsafe {
        let text = getenv(c"MUTANT".as_ptr());
        if text.is_null() { 0 } else { atoi(text) as u32 }
    };
    ON.store(on, Ordering::Relaxed);
    on
}
