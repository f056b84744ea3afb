# How to compile for the bare-metal TARGET: included by the top Makefile for `make dist TARGET=…` and by this directory's.

PROFILE := firmware
CARGO_TARGET := --target $(TARGET)
# Both real types in one directory: Debian's way compiles `core` into it, which takes longest.
CARGO_DIR := target/build-$(TARGET)

# The target from rustup if it is there, else Debian's Rust (1.96) with the source of `core`.
ifeq ($(wildcard $(shell rustc --print target-libdir --target $(TARGET) 2> /dev/null)/*),)
ifeq ($(wildcard /usr/lib/rustlib/src/rust/library/core),)
$(error No `core` for $(TARGET): `rustup target add $(TARGET)`, or `make firmware-setup` on Debian)
endif
CARGO := RUSTC=/usr/bin/rustc RUSTC_BOOTSTRAP=1 /usr/bin/cargo
CARGO_TARGET += -Z build-std=core
endif

ifneq ($(filter thumb%,$(TARGET)),)
CROSS := arm-none-eabi-
# Nothing unwinds through this archive, and an entry costs 8 bytes a function.
DROP_UNWIND_TABLES = $(CROSS)objcopy -R '.ARM.exidx*' -R '.rel.ARM.exidx*' $(BUILD)/atraj.o
else ifneq ($(filter riscv%,$(TARGET)),)
CROSS := riscv64-unknown-elf-
endif
