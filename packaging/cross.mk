# How to compile for TARGET: bare metal, WebAssembly or another host. The top Makefile includes this file for `make dist TARGET=…`;
# the Makefile of c_tests/firmware includes it too.

CARGO ?= cargo
include $(dir $(lastword $(MAKEFILE_LIST)))chips.mk
CARGO_TARGET := --target $(TARGET)
# Both real types share this directory: Debian's Rust compiles `core` into it, and compiling `core` takes longest.
CARGO_DIR := target/build-$(TARGET)$(CPU:%=-%)

ifneq ($(findstring -linux-,$(TARGET))$(filter %-windows-gnu,$(TARGET)),)
PROFILE := release
RUSTC_FLAGS := $(HOST_RUSTC_FLAGS)
# The names that Debian gives to its cross compilers. Objects for musl and for glibc have the same tools.
CROSS := $(subst armv7,arm,$(subst -unknown-,-,$(patsubst %-musl,%-gnu,$(TARGET:-pc-windows-gnu=-w64-mingw32))))-
else
PROFILE := firmware
RUSTC_FLAGS := -C force-unwind-tables=no
endif

# rustup's target is used if it is installed, else Debian's Rust (1.96) with the source of `core`. Debian's Rust can also
# leave out the frame pointer. Rust's Thumb targets set one up in every function, for 6 bytes and 3 instructions.
ifeq ($(wildcard $(shell rustc --print target-libdir --target $(TARGET) 2> /dev/null)/*),)
CARGO = $(if $(wildcard /usr/lib/rustlib/src/rust/library/core),RUSTC=/usr/bin/rustc RUSTC_BOOTSTRAP=1 /usr/bin/cargo,\
    $(error Rust has no `core` for $(TARGET): `rustup target add $(TARGET)`, or `sudo make setup FOR=firmware` on Debian))
RUSTC_FLAGS += --cfg atraj_unstable_core
TARGET_JSON := $(CARGO_DIR)/$(TARGET).json
CARGO_TARGET := --target $(TARGET_JSON) -Z json-target-spec -Z build-std=core
endif

# Written anew each time, because another Rust may have other facts. Cargo compares the text, not the date.
$(CARGO_DIR)/$(TARGET).json: FORCE
	@mkdir -p $(CARGO_DIR)
	@RUSTC_BOOTSTRAP=1 /usr/bin/rustc -Z unstable-options --print target-spec-json --target $(TARGET) > $@.rustc
	@sed 's/"frame-pointer": "always"/"frame-pointer": "may-omit"/' $@.rustc > $@.new
	@mv $@.new $@
FORCE:

ifneq ($(filter thumb%,$(TARGET)),)
CROSS := arm-none-eabi-
# Nothing unwinds through this archive, and an unwind entry costs 8 bytes per function.
DROP_UNWIND_TABLES = $(CROSS)objcopy -R '.ARM.exidx*' -R '.rel.ARM.exidx*' $(OBJECT)
else ifneq ($(filter riscv%,$(TARGET)),)
CROSS := riscv64-unknown-elf-
else ifneq ($(filter wasm%,$(TARGET)),)
CROSS := llvm-
endif

CC := $(or $(call compiler,$(TARGET)$(CPU:%=-%)),$(if $(filter wasm%,$(TARGET)),clang --target=wasm32,$(CROSS)gcc))
