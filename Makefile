# Builds the archive that a C program links, and proves it. Needs make, Rust and a C compiler. docs/install.md has the build choices.
#
# make dist [TARGET=<triple>] [CPU=<name>] [REAL=float]   archive, headers and, on a host, the shared library, in target/dist…
# make install, make uninstall   under DESTDIR and PREFIX (/usr/local), LIBDIR and INCLUDEDIR
# make setup [FOR=<goals>]       installs the Debian packages that the goals need, as root
# make identify FILE=<file>      prints which build of the library is in a program or a library
# make demo, make examples       parity, what the originals fail, pictures; the programs in C, C++ and Rust
# make doc                       guide, references and playground as one site: target/site/index.html
# make playground, make python   the page that plans in a browser; wheel and sdist
# make deb, make release         packages for Debian; every file of a release: docs/releasing.md
#
# make check                     all tests of the library: golden data, the original, headers, symbols, ABI, documents
# make consumers                 builds and installs in many ways, and programs that find the library
# make firmware-check            firmware in QEMU (make -C c_tests/firmware report, bounds: measures)
# make playground-check, make python-check
# make miri, make coverage       Miri on the C functions; the regions that the tests reach
# make mutants, make fuzz, make soak   planted faults; libFuzzer; random cases for hours
# make bench, make instructions  times next to others'; fails if a function takes 3 % more instructions (UPDATE=1 accepts them)

CARGO ?= cargo
CC ?= cc
# make's own default is g++, which not every system has.
ifeq ($(origin CXX),default)
CXX := c++
endif
PREFIX ?= /usr/local
LIBDIR ?= $(PREFIX)/lib
INCLUDEDIR ?= $(PREFIX)/include
# packaging/install.sh reads these names from the environment, because make splits a name with a blank.
export DESTDIR PREFIX LIBDIR INCLUDEDIR

.DEFAULT_GOAL := dist
.DELETE_ON_ERROR:
# A goal prints its results. `make --trace` prints the commands.
.SILENT:

VERSION := $(shell sed -n 's/^version = "\(.*\)"/\1/p' Cargo.toml)

ifneq ($(filter-out double float,$(REAL)),)
$(error REAL=$(REAL) does not exist: it is double or float)
endif
ifneq ($(filter-out compact,$(POLY)),)
$(error POLY=$(POLY) does not exist: it is compact or left out)
endif
ifneq ($(shell printf %s '$(SYMBOL_PREFIX)' | sed '/^[A-Za-z_][A-Za-z0-9_]*$$/d'),)
$(error SYMBOL_PREFIX=$(SYMBOL_PREFIX) does not exist: no C name begins like this)
endif
# Some systems export a CPU of their own to every program.
ifeq ($(origin CPU),environment)
override CPU :=
endif
ifneq ($(and $(CPU),$(CARGO_ENCODED_RUSTFLAGS)),)
$(error CARGO_ENCODED_RUSTFLAGS hides CPU=$(CPU) from Rust: unset CARGO_ENCODED_RUSTFLAGS, or leave CPU out and write HWCAPS=)
endif
# Linux has the clock of `std`. Bare metal and Windows have not.
LINUX := $(if $(TARGET),$(findstring -linux-,$(TARGET)),host)
WINDOWS := $(filter %-windows-gnu,$(TARGET))
# Who links musl links the archive.
SONAMED := $(if $(TARGET),$(filter %-linux-gnu %-linux-gnueabihf,$(TARGET)),host)
FEATURES := capi $(LINUX:%=std) $(filter float,$(REAL)) $(POLY:%=poly-%)
# The highest levels are the default.
LEVELS := $(filter-out -poly3-level3 -poly5-level3 -poly7-level4,$(foreach n,3 5 7,$(A_TRAJPOLY$n:%=-poly$n-level%)))
# Only builds of the same ABI have the same name.
ABI := $(subst $() ,,$(patsubst %,-%,$(filter float,$(REAL)) $(POLY))$(LEVELS)$(SYMBOL_PREFIX:%=-prefix-%))
NAME := atraj$(ABI)
MAJOR := $(firstword $(subst ., ,$(VERSION)))
SONAME := lib$(NAME).so.$(MAJOR)
DLL := lib$(NAME)-$(MAJOR).dll
PROCESSOR := $(TARGET:%=-%)$(CPU:%=-%)
VARIANT := $(PROCESSOR)$(ABI)
DIST := target/dist$(VARIANT)
ifneq ($(and $(filter demo examples deb python-check release,$(MAKECMDGOALS)),$(VARIANT)),)
$(error make $(MAKECMDGOALS) is for the default build: leave TARGET, CPU, REAL, POLY, SYMBOL_PREFIX and the levels out)
endif

# Aligned functions are equally fast wherever a linker puts them.
HOST_RUSTC_FLAGS := -C llvm-args=-align-all-functions=6
ifdef TARGET
include packaging/cross.mk
else
HOST = $(shell rustc -vV | sed -n 's/^host: //p')
CARGO_DIR := target/build$(VARIANT)
# With --target, cargo compiles build.rs without RUSTFLAGS, so build.rs runs here whatever CPU is.
CARGO_TARGET = --target $(HOST)
PROFILE := release
RUSTC_FLAGS := $(HOST_RUSTC_FLAGS)
endif
MACHINE = $(or $(TARGET),$(HOST))
HWCAPS ?= $(if $(TARGET)$(CPU),,$(if $(filter x86_64-%-linux-gnu,$(HOST)),x86-64-v3 x86-64-v4))

.PHONY: help setup dist install uninstall identify demo examples doc playground python deb release \
    check consumers firmware-check playground-check python-check miri coverage mutants fuzz soak bench instructions
# Steps of these.
.PHONY: rust dist-locked where site-tool check-programs check-motions

help:
	@sed '/^$$/,$$d; s/^# \{0,1\}//' Makefile

setup:
	packaging/debian.sh install $(FOR)

# What would end in a message of cargo that does not say what to do.
OLDEST_RUST := $(shell sed -n 's/^rust-version = "1\.\(.*\)"/\1/p' Cargo.toml)
dist deb check doc soak mutants miri coverage bench instructions fuzz python consumers firmware-check release: | rust
rust:
	@rustc --version 2> /dev/null | awk '{ split($$2, part, "."); found = part[1] > 1 || part[2] >= $(OLDEST_RUST) } END { exit !found }' || { \
	    echo 'Rust >= 1.$(OLDEST_RUST) is needed (https://rustup.rs, or on Debian 12 sudo make setup FOR="dist rust"), or take a release:' \
	    'docs/install.md' >&2; exit 1; }
ifdef TARGET
	@rustc --print target-list | grep -qxF -e '$(TARGET)' || { \
	    echo 'TARGET=$(TARGET) does not exist: `rustc --print target-list` lists the names, packaging/chips.txt has those of chips.' >&2; \
	    exit 1; }
endif
ifdef CPU
	@rustc --print target-cpus --target $(MACHINE) | awk '{ print $$1 }' | grep -qxF -e '$(CPU)' || { \
	    echo 'CPU=$(CPU) does not exist: `rustc --print target-cpus --target $(MACHINE)` lists the names.' >&2; exit 1; }
endif

# Cargo writes the library of every real type and of every set of flags to one file name, so one build at a time may run.
# `make -s` does not print the last line.
ARCHIVE := $(DIST)/lib/lib$(NAME).a
dist:
	@mkdir -p $(CARGO_DIR)
	@flock $(CARGO_DIR)/lock $(MAKE) --no-print-directory dist-locked
	@$(if $(findstring s,$(filter-out -%,$(firstword $(MAKEFLAGS)))),,echo "$(DIST): $(notdir $(ARCHIVE)) ($(or $(REAL),double), \
	    $(MACHINE)$(CPU:%= %), $$(($$(wc -c < $(ARCHIVE)) / 1000)) KB); link it by its path: $(CC) program.o $(ARCHIVE) -lm")

NEW := $(CARGO_DIR)/dist
OBJECT := $(CARGO_DIR)/atraj.o
NAMES := $(CARGO_DIR)/names
FILL = sed 's/@VERSION@/$(VERSION)/g; s/@NAME@/$(NAME)/g; s/@MACHINE@/$(MACHINE)$(CPU:%= %)/g'

# $(call level,NAME): the shared library for a level of x86-64, where glibc's loader looks for it. Each level has directories of its own,
# also where the command line names those of this build.
define level
$(MAKE) -s --no-print-directory dist CPU=$1 HWCAPS= DIST=target/dist-$1$(ABI) CARGO_DIR=target/build-$1$(ABI)
mkdir -p $(NEW)/lib/glibc-hwcaps/$1
cp -P target/dist-$1$(ABI)/lib/lib$(NAME).so.* $(NEW)/lib/glibc-hwcaps/$1/

endef

# The archive holds one object. So a user's linker finds the documented symbols in it and no others. The recipe builds aside
# and renames last, so a failed build leaves the old directory.
dist-locked: $(TARGET_JSON)
	$(if $(filter-out x86-64-v2 x86-64-v3 x86-64-v4,$(HWCAPS)),$(error HWCAPS=$(HWCAPS) does not exist: it is some of x86-64-v2 x86-64-v3 x86-64-v4))
	rm -rf $(NEW) $(CARGO_DIR)/old
	mkdir -p $(NEW)/lib/pkgconfig $(NEW)/lib/cmake/$(NAME) $(NEW)/include $(NEW)/share/doc/$(NAME)
	$(if $(CPU),RUSTFLAGS="$$RUSTFLAGS -C target-cpu=$(CPU)") CARGO_TARGET_DIR=$(CARGO_DIR) $(CARGO) rustc --quiet \
	    --profile $(PROFILE) $(CARGO_TARGET) --lib --crate-type staticlib --no-default-features --features "$(FEATURES)" \
	    --message-format=json-render-diagnostics -- $(RUSTC_FLAGS) --cfg atraj_archive > $(CARGO_DIR)/messages.json
	AR=$(CROSS)ar NM=$(CROSS)nm packaging/object.sh $(CARGO_DIR)/messages.json $(OBJECT)
ifdef TARGET
	$(DROP_UNWIND_TABLES)
endif
	cp -R include/. $(NEW)/include
ifdef SYMBOL_PREFIX
	$(CROSS)nm --defined-only --extern-only --format=posix $(OBJECT) | awk '{ print $$1, "$(SYMBOL_PREFIX)" $$1 }' > $(NAMES)
	$(CROSS)objcopy --redefine-syms=$(NAMES) $(OBJECT)
	sed 's|\(.*\) \(.*\)|s/\\<\1\\>/\2/g|' $(NAMES) > $(NAMES).sed
	find $(NEW)/include -type f -exec sed -i -f $(NAMES).sed {} +
endif
	$(CROSS)ar crsD $(NEW)/lib/lib$(NAME).a $(OBJECT)
ifdef SONAMED
	$(CC) -shared -Wl,-soname,$(SONAME) -Wl,--as-needed -o $(NEW)/lib/lib$(NAME).so.$(VERSION) $(OBJECT) -lm
	ln -s lib$(NAME).so.$(VERSION) $(NEW)/lib/$(SONAME)
	ln -s $(SONAME) $(NEW)/lib/lib$(NAME).so
	$(foreach name,$(HWCAPS),$(call level,$(name)))
endif
ifdef WINDOWS
	mkdir -p $(NEW)/bin
	$(CC) -shared -Wl,--out-implib,$(NEW)/lib/lib$(NAME).dll.a -Wl,--no-insert-timestamp -Wl,--strip-all -static-libgcc \
	    -o $(NEW)/bin/$(DLL) $(OBJECT)
endif
	cp "$$(sed -n 's|.*"out_dir":"\([^"]*/build/atraj-[0-9a-f]*/out\)".*|\1|p' $(CARGO_DIR)/messages.json)/atraj_config.h" \
	    $(NEW)/include/a/
	$(FILL) packaging/atraj.pc > $(NEW)/lib/pkgconfig/$(NAME).pc
	$(FILL) packaging/atraj-config.cmake > $(NEW)/lib/cmake/$(NAME)/$(NAME)-config.cmake
	$(FILL) packaging/atraj-config-version.cmake > $(NEW)/lib/cmake/$(NAME)/$(NAME)-config-version.cmake
	cp LICENSE-* $(NEW)/share/doc/$(NAME)/
	if test -e $(DIST); then mv $(DIST) $(CARGO_DIR)/old; fi
	mv $(NEW) $(DIST)
	rm -rf $(CARGO_DIR)/old

# For the build tools that take the files from there.
where:
	@echo '$(CURDIR)/$(DIST)'

# Builds only a missing archive, so `sudo make install` after `make dist` needs no Rust.
$(ARCHIVE):
	$(MAKE) dist

install uninstall: $(ARCHIVE)
	packaging/install.sh $@ $(DIST) $(NAME)

deb:
	packaging/debian.sh tools deb
	mkdir -p target
	rm -rf target/deb
	DEB_RULES_REQUIRES_ROOT=no env -u MAKEFLAGS debian/rules binary > target/deb.log 2>&1 || { cat target/deb.log >&2; exit 1; }
	debian/rules clean >> target/deb.log

# Reads the note that src/capi/identity.rs leaves in the archive, and every linker in the program.
identify:
	@test -r "$(FILE)" || { echo 'make identify needs FILE=…: a program, firmware, an archive or a shared library' >&2; exit 1; }
	@command -v readelf > /dev/null || { echo 'make identify needs readelf: install binutils' >&2; exit 1; }
	@readelf -p .atraj.note "$(FILE)" 2> /dev/null | sed -n 's/.*\] *\(atraj [0-9].*\)/\1/p' | grep . || \
	    { echo "$(FILE) holds no atraj: it was not linked with libatraj.a, or its notes were removed." >&2; exit 1; }

# ROWS=<regular expression> runs some of the rows.
consumers:
	tests/builds.sh
	tests/consumers.sh

# KEY=<SSH key> signs the checksums; `make -j2 release` is faster. tests/release.sh tries every file.
release:
	rm -rf target/release-$(VERSION) target/release-work
	mkdir -p target/release-$(VERSION) target/release-work
	$(MAKE) -f packaging/release.mk VERSION=$(VERSION) HOST=$(HOST)

# mdBook clears the folder of the site.
SITE := target/site
MDBOOK := target/mdbook-0.4.52/bin/mdbook
$(MDBOOK):
	$(CARGO) install --quiet --locked --debug --no-default-features --features search --version =0.4.52 --root $(@:%/bin/mdbook=%) mdbook

site-tool: $(MDBOOK)
doc: dist playground $(MDBOOK)
	docs/site/book.sh target/book
	$(MDBOOK) build --dest-dir $(CURDIR)/$(SITE) target/book
	$(CARGO) doc --quiet --no-deps --features capi --target-dir target/reference
	$(MAKE) -s -C python reference OUT=$(CURDIR)/$(SITE)/python
	doxygen
	sed -i -e 's/<html xmlns/<html lang="en" xmlns/' -e 's/id="MSearchField"/& aria-label="Search"/' target/reference/c/html/*.html target/reference/c/html/menu.js
	echo 'addEventListener("load", () => document.querySelectorAll("tbody, .fragment").forEach((table) => (table.tabIndex = 0)));' >> target/reference/c/html/menu.js
	cp -R target/reference/doc $(SITE)/rust
	cp -R target/reference/c/html $(SITE)/c
	node docs/site/search.mjs $(SITE) target/reference/c/tags.xml
	cp target/playground/index.html $(SITE)/playground.html

DEMO := target/demo
DEMO_FLAGS := -std=c99 -O2 -I$(DIST)/include

# Does the steps of a liba user: compiles a servo program against the headers, links the archive, replays the golden data. Counts the
# moves that the original fails and the plans of atraj.h do not. Draws every setpoint of the examples.
demo: dist
	rm -rf $(DEMO)
	mkdir -p $(DEMO)
	$(CC) $(DEMO_FLAGS) -o $(DEMO)/servo examples/demo/servo.c $(DIST)/lib/libatraj.a -lm
	$(CARGO) run --quiet --locked -p demo --bin parity $(DEMO)/servo
	$(CC) $(DEMO_FLAGS) -o $(DEMO)/originals examples/demo/originals.c $(DIST)/lib/libatraj.a -lm
	$(DEMO)/originals
	for name in $(EXAMPLES); do \
	    $(CC) $(DEMO_FLAGS) -DEVERY=1 -o $(DEMO)/$$name examples/$$name.c $(DIST)/lib/libatraj.a -lm && \
	    $(DEMO)/$$name > $(DEMO)/$$name.txt || exit 1; done
	$(CC) $(DEMO_FLAGS) -o $(DEMO)/sensitivity examples/demo/sensitivity.c $(DIST)/lib/libatraj.a -lm
	$(DEMO)/sensitivity > $(DEMO)/sensitivity.txt
	$(CARGO) run --quiet --locked -p demo --bin plot $(DEMO)

EXAMPLES := $(sort $(basename $(notdir $(wildcard examples/[0-9]*_*.c))))
EXAMPLES_OUT := target/examples
EXAMPLE_FLAGS := -Wall -Wextra -Wpedantic -Werror -O2 -I$(DIST)/include -I$(DIST)/include/claraty

# $(call example,NAME): the three languages must print the same lines. Each program prints into a file, because make would
# not see the program fail in a pipe.
define example
$(CC) -std=c99 $(EXAMPLE_FLAGS) -o $(EXAMPLES_OUT)/$1-c examples/$1.c $(DIST)/lib/libatraj.a -lm
$(EXAMPLES_OUT)/$1-c > $(EXAMPLES_OUT)/$1-c.txt
$(CXX) -std=c++98 $(EXAMPLE_FLAGS) -o $(EXAMPLES_OUT)/$1-cpp examples/$1.cpp $(DIST)/lib/libatraj.a -lm
$(EXAMPLES_OUT)/$1-cpp > $(EXAMPLES_OUT)/$1-cpp.txt
$(CARGO) run --quiet --example $1 > $(EXAMPLES_OUT)/$1-rs.txt
for language in c cpp rs; do diff -u examples/expected/$1.txt $(EXAMPLES_OUT)/$1-$$language.txt || exit 1; done
@echo 'example $1: C, C++ and Rust print the expected lines'

endef

examples: dist
	@command -v $(CXX) > /dev/null || packaging/debian.sh tools examples
	rm -rf $(EXAMPLES_OUT)
	mkdir -p $(EXAMPLES_OUT)
	$(foreach name,$(EXAMPLES),$(call example,$(name)))

ORACLE := --locked --profile oracle -p oracle
# The tests of the oracle that are not part of its program `whole`.
APART := $(filter-out $(shell sed -n 's/^ *mod \(.*\);/\1/p' tests/oracle/whole.rs),$(basename $(notdir $(wildcard tests/oracle/tests/*.rs))))
# The tests of one list call compilers and `make dist` and often wait. So those of the other list run beside them.
check:
	$(MAKE) --no-print-directory -j2 check-programs check-motions

# Their own calls of make are not parts of this one.
check-programs check-motions: export MAKEFLAGS =

# `--tests` leaves out the examples, which `make examples` compiles and runs.
PROGRAMS_LOG := target/check-programs.log
check-programs:
	mkdir -p target
	{ $(CARGO) test --locked --tests -p atraj -p house && $(CARGO) test --locked --doc && \
	    $(CARGO) test $(ORACLE) $(addprefix --test ,$(APART)) -- --nocapture; } \
	    > $(PROGRAMS_LOG) 2>&1; answer=$$?; cat $(PROGRAMS_LOG); exit $$answer

# The default build runs every test of the oracle, each other build the tests of its C functions.
check-motions:
	$(CARGO) test $(ORACLE) --lib --test whole -- --nocapture
	$(CARGO) run --quiet --locked --profile oracle -p measure --bin every_float 1009
	$(CARGO) test --locked --profile oracle -p handover -p pointers -- --nocapture
	for features in float poly-compact float,poly-compact; do \
	    $(CARGO) test $(ORACLE) --features $$features --test does_the_c_abi_agree -- --nocapture || exit 1; done

SOAK ?= calls plans moves axes paths programs

# Each kind goes on where its last row ends, and adds a row, also when it is stopped. SOAK=<kinds> runs some of them, SOAK_SEED=n starts at seed n,
# SOAK_SEEDS=n ends after n seeds. A seed stands for a million calls, a million plans, a quarter of a million moves, ten thousand sets of axes,
# a thousand paths and a thousand programs of calls to a group per real type.
soak:
	$(CARGO) fetch --quiet --locked
	SOAK="$(CARGO) run --quiet --locked --profile oracle -p measure --bin soak --" SOAK_SEED=$(SOAK_SEED) SOAK_SEEDS=$(SOAK_SEEDS) tests/soak.sh $(SOAK)

# About so many of all mutants, drawn by the seed.
MUTANTS ?= 300
MUTANT_SEED ?= 1
TOOLS := $(CURDIR)/target/tools

$(TOOLS)/bin/cargo-mutants:
	$(CARGO) install --quiet --locked --version 26.0.0 --root $(TOOLS) --target-dir $(TOOLS)/build cargo-mutants

mutants: $(TOOLS)/bin/cargo-mutants
	PATH="$(TOOLS)/bin:$$PATH" tests/mutants.sh $(MUTANTS) $(MUTANT_SEED)

# Miri knows the square root of every processor but the host's.
miri:
	$(CARGO) +nightly miri test --target riscv64gc-unknown-linux-gnu --locked -p pointers -- --show-output

coverage:
	tests/coverage.sh

# The benchmark is compiled with the archive's settings, or it would measure other code.
BENCH := $(CARGO) run --quiet --locked --profile bench -p measure --bin bench
bench instructions: export RUSTFLAGS := $(RUSTC_FLAGS)

bench:
	$(CARGO) fetch --quiet --locked
	BENCH="$(BENCH)" tests/bench.sh

# UPDATE=1 accepts the counts of today.
instructions:
	$(CARGO) fetch --quiet --locked
	$(BENCH) -- instructions > target/instructions.txt
	$(if $(UPDATE),cp target/instructions.txt tests/instructions.txt,awk -F ': ' -f tests/instructions.awk tests/instructions.txt target/instructions.txt)

# FUZZ_SECONDS for each family, or exactly FUZZ_RUNS inputs if set; FUZZ_SEED=n starts at seed n, not 1.
FUZZ_SECONDS ?= 60
fuzz:
	fuzz/run.sh $(if $(FUZZ_RUNS),-runs=$(FUZZ_RUNS),-max_total_time=$(FUZZ_SECONDS))

python:
	$(MAKE) -s -C python package

# The archive's shared library, because the tests time its C function.
python-check: dist
	$(MAKE) -s -C python check

playground:
	$(MAKE) -s -C playground page

playground-check:
	$(MAKE) -s -C playground check

firmware-check:
	$(MAKE) -C c_tests/firmware check
