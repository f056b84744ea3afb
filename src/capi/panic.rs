//! The panic handler that a `no_std` archive must have. Nothing in this crate panics, so the linker drops it; the symbol
//! test of the archive fails if something keeps it.

#[panic_handler]
fn panic(_: &core::panic::PanicInfo) -> ! {
    loop {}
}
