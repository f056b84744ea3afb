//! Every fact about the target that a choice in this library rests on.

/// A unit computes in binary32: a division or a square root is one instruction.
///
/// On Arm the ABI tells, since it passes reals in the unit's registers. RISC-V cores of 32 bits count as cores without a unit.
pub const HAS_BINARY32_UNIT: bool = cfg!(not(any(target_abi = "eabi", all(target_arch = "riscv32"))));

/// A unit computes in binary64.
pub const HAS_BINARY64_UNIT: bool = HAS_BINARY32_UNIT && cfg!(not(unit_lacks_binary64));

/// The largest vector registers of common processors, bytes: a store that crosses a cache line costs more than one that does not.
pub const VECTOR_BYTES: usize = 32;
