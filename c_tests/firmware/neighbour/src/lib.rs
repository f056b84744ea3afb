//! Stands for any other Rust library in a firmware. It brings its own panic handler and compiler-builtins, which must not clash with ours.
#![no_std]

/// How many of `count` values lie below their mean.
///
/// # Safety
/// `values` points to `count` numbers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn neighbour_below_mean(values: *const f64, count: u32) -> u32 {
    // SAFETY: the caller's promise.
    let values = unsafe { core::slice::from_raw_parts(values, count as usize) };
    let mean = values.iter().sum::<f64>() / f64::from(count);
    values.iter().map(|&v| u32::from(v < mean)).sum()
}

#[panic_handler]
fn panic(_: &core::panic::PanicInfo) -> ! {
    loop {}
}
