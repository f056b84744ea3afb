# Writes target/release-VERSION: an archive for each target and ABI, the sources with what they depend on, a bill of materials
# (CycloneDX), packages for Debian, Arduino, PlatformIO, CMSIS and vcpkg, the site, wheels, checksums, and with KEY=… their signature.
# The top Makefile starts it: make release.
#
# Two clones of one commit give the same bytes. No file tells where or by whom it was built, and every time is the commit's.

HOSTS := x86_64-unknown-linux-gnu x86_64-unknown-linux-musl aarch64-unknown-linux-gnu aarch64-unknown-linux-musl \
    armv7-unknown-linux-gnueabihf x86_64-pc-windows-gnu
include packaging/chips.mk
TARGETS ?= $(HOSTS) $(CHIPS)
ABIS ?= double float double-compact float-compact
# What is no archive of the library. A goal of the top Makefile makes each.
PARTS ?= debian site python managers

OUT := target/release-$(VERSION)
WORK := target/release-work
ARCHIVES := $(foreach t,$(TARGETS),$(ABIS:%=$(OUT)/atraj-$(VERSION)-$t-%.tar.gz))
SOURCE := atraj-$(VERSION)-source
BILL := $(OUT)/atraj-$(VERSION).cdx.json

export SOURCE_DATE_EPOCH := $(or $(SOURCE_DATE_EPOCH),$(shell git log -1 --format=%ct))
$(if $(KEY),$(if $(wildcard $(KEY)),,$(error KEY=$(KEY) does not exist: it is the file of an SSH key)))
$(if $(SOURCE_DATE_EPOCH),,$(error make release takes the sources and their date from git: start it in a clone))

.DELETE_ON_ERROR:
.PHONY: all
all: $(OUT)/SHA256SUMS$(if $(KEY),.sig)

# Python's tools choose the names of wheels, so the files are counted when all are there.
$(OUT)/SHA256SUMS: $(ARCHIVES) $(OUT)/$(SOURCE).tar.gz $(BILL) $(PARTS)
	cd $(OUT) && LC_ALL=C && sha256sum -- * > $(abspath $(WORK))/SHA256SUMS
	mv $(WORK)/SHA256SUMS $@

$(OUT)/SHA256SUMS.sig: $(OUT)/SHA256SUMS
	ssh-keygen -q -Y sign -n file -f '$(KEY)' $<

# $(call pack,folder): packs this folder of WORK. Every system can unpack gzip; zstd would have to be installed on many.
pack = $(call pack_as,$@,$1)
pack_as = tar --sort=name --owner=0 --group=0 --numeric-owner --mtime=@$(SOURCE_DATE_EPOCH) --mode=a+rX,u+w,go-w \
    --use-compress-program='gzip -9n' -C $(WORK) -cf $1 $2

# The archive of this machine, HOST, is the `make dist` that all tests run on.
dist = target/dist$(filter-out -$(HOST),-$1)$(patsubst -double%,%,-$2)

# $(call archive,target,abi)
define archive
$(OUT)/atraj-$(VERSION)-$1-$2.tar.gz:
	MAKEFLAGS= $$(MAKE) -s dist $(or $(call choices,$1),TARGET=$(filter-out $(HOST),$1)) REAL=$(2:%-compact=%) \
	    POLY=$(if $(filter %-compact,$2),compact)
	packaging/archive.sh $(call dist,$1,$2) $(WORK)/atraj-$(VERSION)-$1-$2 $1 $2
	$$(call pack,atraj-$(VERSION)-$1-$2)
endef
$(foreach t,$(TARGETS),$(foreach a,$(ABIS),$(eval $(call archive,$t,$a))))

# Goals that run `make dist` replace the folder that others copy, so they run one after the other.
.PHONY: $(PARTS)
$(PARTS): $(ARCHIVES)
site: $(filter debian,$(PARTS))
debian:
	MAKEFLAGS= $(MAKE) -s deb
	cp target/deb/*.deb $(OUT)

managers:
	packaging/managers.sh $(abspath $(OUT)) $(abspath $(WORK))

SITE := atraj-$(VERSION)-site
site:
	MAKEFLAGS= $(MAKE) -s doc
	rm -rf $(WORK)/$(SITE)
	cp -R target/site $(WORK)/$(SITE)
	$(call pack_as,$(OUT)/$(SITE).tar.gz,$(SITE))
	cp target/playground/index.html $(OUT)/atraj-$(VERSION)-playground.html

python:
	MAKEFLAGS= $(MAKE) -s python
	find target/python -maxdepth 2 -name 'atraj-*.whl' -o -maxdepth 2 -name 'atraj-*.tar.gz' | xargs cp -t $(OUT)

$(OUT)/$(SOURCE).tar.gz:
	rm -rf $(WORK)/$(SOURCE)
	mkdir -p $(WORK)/$(SOURCE)/.cargo
	git ls-files -z | tar --null --files-from=- -cf $(WORK)/$(SOURCE).tar
	tar -C $(WORK)/$(SOURCE) -xf $(WORK)/$(SOURCE).tar
	# The workspace of an archive is the library: what tests need is not vendored, nor the original under its other licence.
	sed -i 's|^members = .*|members = ["tests/support"]|' $(WORK)/$(SOURCE)/Cargo.toml
	cd $(WORK)/$(SOURCE) && cargo vendor --offline vendor > .cargo/config.toml 2> ../vendor.log || { cat ../vendor.log >&2; exit 1; }
	$(call pack,$(SOURCE))

# The tool describes the sources where they lie, as the address of the package too, and writes its file next to them.
BILL_TOOL ?= target/cargo-cyclonedx-0.5.9/bin/cargo-cyclonedx
$(BILL): $(OUT)/$(SOURCE).tar.gz $(BILL_TOOL)
	cd $(WORK)/$(SOURCE) && $(abspath $(BILL_TOOL)) cyclonedx --quiet --format json --spec-version 1.5 --target all --no-build-deps \
	    --override-filename bill
	sed -e 's|path+file://$(CURDIR)/$(WORK)/$(SOURCE)|path+file:///$(SOURCE)|' -e 's|?download_url=file://\.||' $(WORK)/$(SOURCE)/bill.json > $@

# Compiled without optimisation, because compiling takes longer than running.
target/cargo-cyclonedx-%/bin/cargo-cyclonedx:
	cargo install --quiet --locked --debug --version '=$*' --root target/cargo-cyclonedx-$* cargo-cyclonedx
