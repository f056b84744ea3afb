//! The note in the archive that says which build a program holds: `make identify FILE=program` prints it, `readelf -n` finds it.
//!
//! The note's section has no flag "a", so nothing loads it and it takes no flash. Linkers keep such a section next to any
//! function of the same object, even with `--gc-sections`. Its name does not begin with ".note", because linker scripts for bare
//! metal discard such names: picolibc's does.

/// Version, ABI, target and CPU, from `build.rs`.
const IDENTITY: &str = env!("ATRAJ_IDENTITY");

core::arch::global_asm!(
    ".pushsection .atraj.note, \"\", %note",
    ".balign 4",
    // Sizes of owner and description with their final zeros, and the type, which is the owner's to choose.
    ".4byte 6, {size}, 1",
    ".asciz \"atraj\"",
    ".balign 4",
    concat!(".asciz \"", env!("ATRAJ_IDENTITY"), "\""),
    ".balign 4",
    ".popsection",
    size = const IDENTITY.len() + 1,
);
