/* What the flags of a C compiler say about the processor. CMakeLists.txt and meson.build read three macros. An unknown processor
   leaves them undefined.

   ATRAJ_TARGETS    Rust's names of the archives that a program with these flags can link, the best one first
   ATRAJ_CPU        CPU of the best archive, if packaging/chips.txt names one
   ATRAJ_NOT_CPUS   CPUs whose archives hold floating-point instructions that these flags exclude */

#if defined(__ARM_ARCH_PROFILE) && __ARM_ARCH_PROFILE == 'M'

#if __ARM_ARCH_ISA_THUMB == 1
#define ATRAJ_TARGETS "thumbv6m-none-eabi"
#elif defined(__ARM_PCS_VFP) && __ARM_ARCH == 7
#define ATRAJ_TARGETS "thumbv7em-none-eabihf"
#elif defined(__ARM_PCS_VFP)
#define ATRAJ_TARGETS "thumbv8m.main-none-eabihf"
#elif defined(__ARM_FEATURE_DSP)
#define ATRAJ_TARGETS "thumbv7em-none-eabi thumbv7m-none-eabi thumbv6m-none-eabi"
#else
#define ATRAJ_TARGETS "thumbv7m-none-eabi thumbv6m-none-eabi"
#endif

/* Bit 3 of __ARM_FP: the unit computes in binary64. Without __ARM_FP there is no unit. */
#if !defined(__ARM_FP)
#define ATRAJ_NOT_CPUS "cortex-m4 cortex-m33 cortex-m35p cortex-m7 cortex-m52 cortex-m55 cortex-m85"
#elif !(__ARM_FP & 8)
#define ATRAJ_NOT_CPUS "cortex-m7 cortex-m52 cortex-m55 cortex-m85"
#endif

#if defined(__ARM_PCS_VFP) && __ARM_ARCH == 7 && (__ARM_FP & 8)
#define ATRAJ_CPU "cortex-m7"
#elif defined(__ARM_FP) && !defined(__ARM_PCS_VFP) && defined(__ARM_FEATURE_DSP)
#define ATRAJ_CPU "cortex-m4"
#endif

#elif defined(__riscv) && !defined(__linux__)

#if __riscv_xlen == 64 && defined(__riscv_float_abi_double) && defined(__riscv_atomic) && defined(__riscv_compressed)
#define ATRAJ_TARGETS "riscv64gc-unknown-none-elf"
#elif __riscv_xlen == 32 && defined(__riscv_float_abi_soft) && !defined(__riscv_abi_rve) && \
    defined(__riscv_mul) && defined(__riscv_compressed)
#if defined(__riscv_atomic)
#define ATRAJ_TARGETS "riscv32imac-unknown-none-elf riscv32imc-unknown-none-elf"
#else
#define ATRAJ_TARGETS "riscv32imc-unknown-none-elf"
#endif
#endif

#elif defined(__aarch64__) && defined(__linux__)
#define ATRAJ_TARGETS "aarch64-unknown-linux-gnu aarch64-unknown-linux-musl"
#elif defined(__aarch64__) && defined(__ELF__)
#define ATRAJ_TARGETS "aarch64-unknown-none"
#elif defined(__ARM_PCS_VFP) && __ARM_ARCH >= 7 && defined(__linux__)
#define ATRAJ_TARGETS "armv7-unknown-linux-gnueabihf armv7-unknown-linux-musleabihf"
#elif defined(__x86_64__) && defined(__linux__) && defined(__LP64__)
#define ATRAJ_TARGETS "x86_64-unknown-linux-gnu x86_64-unknown-linux-musl"
#elif defined(__x86_64__) && defined(__MINGW32__)
#define ATRAJ_TARGETS "x86_64-pc-windows-gnu"
#elif defined(__i386__) && defined(__linux__)
#define ATRAJ_TARGETS "i686-unknown-linux-gnu i686-unknown-linux-musl"
#endif
