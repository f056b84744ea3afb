# How to compile for the bare-metal TARGET: included by the top Makefile for `make dist TARGET=…` and by this directory's.

PROFILE := firmware
RUSTC_FLAGS := -C force-unwind-tables=no
CARGO_TARGET := --target $(TARGET)
# Both real types in one directory: Debian's way compiles `core` into it, which takes longest.
CARGO_DIR := target/build-$(TARGET)

# The target from rustup if it is there, else Debian's Rust (1.96) with the source of `core`. That can also leave out the
# frame pointer, which Rust's Thumb targets set up in every function: 6 bytes and 3 instructions.
ifeq ($(wildcard $(shell rustc --print target-libdir --target $(TARGET) 2> /dev/null)/*),)
CARGO = $(if $(wildcard /usr/lib/rustlib/src/rust/library/core),RUSTC=/usr/bin/rustc RUSTC_BOOTSTRAP=1 /usr/bin/cargo,\
    $(error No `core` for $(TARGET): `rustup target add $(TARGET)`, or `make firmware-setup` on Debian))
RUSTC_FLAGS += --cfg atraj_unstable_core
CARGO_TARGET := --target $(CARGO_DIR)/$(TARGET).json -Z json-target-spec -Z build-std=core
endif

$(CARGO_DIR)/$(TARGET).json:
	mkdir -p $(CARGO_DIR)
	RUSTC_BOOTSTRAP=1 /usr/bin/rustc -Z unstable-options --print target-spec-json --target $(TARGET) | \
	    sed 's/"frame-pointer": "always"/"frame-pointer": "may-omit"/' > $@

ifneq ($(filter thumb%,$(TARGET)),)
CROSS := arm-none-eabi-
# Nothing unwinds through this archive, and an entry costs 8 bytes a function.
DROP_UNWIND_TABLES = $(CROSS)objcopy -R '.ARM.exidx*' -R '.rel.ARM.exidx*' $(BUILD)/atraj.o
else ifneq ($(filter riscv%,$(TARGET)),)
CROSS := riscv64-unknown-elf-
endif
