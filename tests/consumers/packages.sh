# Sourced by tests/consumers.sh: programs that bring the library along, by CMake, Meson, Conan or Debian's packages.

subproject=$sources/subproject
clone=$work/clone
unpacked="$work/unpacked release"

# A repository of its own, because a change need not be committed yet.
clone_of_the_sources() {
    copy_of_the_sources "$clone"
    cd "$clone"
    git init --quiet --initial-branch=main
    git add --all
    git -c user.name=nobody -c user.email=nobody@localhost commit --quiet --message='the present files'
}

unpacked_release() { cp -R "$root/target/dist${package#atraj}" "$unpacked-$package"; }

# --- CMake

# by_cmake ARGUMENT…: builds program.c
by_cmake() {
    rm -rf build
    cp "$subproject/CMakeLists.txt" .
    cmake -S . -B build -DATRAJ="$root" -DATRAJ_REAL=$real -DLIBRARY=$package::static "$@"
    cmake --build build
}

cmake_program() {
    cp "$sources/move.c" program.c
    by_cmake "$@"
    prints_the_bits build/program
}

cmake_shared() { cmake_program -DLIBRARY=$package::$package; }

# A make that does not exist, so nothing can be built.
cmake_prebuilt() {
    cmake_program -DATRAJ_PREBUILT="$unpacked-$package" -DATRAJ_MAKE=/nonexistent
    case $real in double) other=float ;; float) other=double ;; esac
    refused "has no atraj" by_cmake -DATRAJ_REAL=$other -DATRAJ_PREBUILT="$unpacked-$package"
}

# The sources change, and the next build must have them.
cmake_fetches_the_sources() {
    cmake_program -DREPOSITORY="$clone" -DFETCHCONTENT_UPDATES_DISCONNECTED=ON
    sed -i 's/^version = .*/version = "0.9.9"/' build/_deps/atraj-src/Cargo.toml
    cmake --build build
    make -s -C "$root" identify FILE="$PWD/build/program" | grep '^atraj 0\.9\.9,'
}

# A release's archive holds one folder.
cmake_fetches_a_release() {
    tar -C "$root/target" -czf release.tar.gz "dist${package#atraj}"
    cmake_program -DRELEASE="$PWD/release.tar.gz" -DATRAJ_MAKE=/nonexistent
}

m0='-mcpu=cortex-m0plus'
m4='-mcpu=cortex-m4 -mfpu=fpv4-sp-d16'
m7='-mcpu=cortex-m7 -mfpu=fpv5-d16 -mfloat-abi=hard'
m4f_archive=$root/target/dist-thumbv7em-none-eabihf-float

# cross FLAGS ARGUMENT…: by_cmake for a Cortex-M
cross() {
    flags=$1
    shift
    by_cmake -DCMAKE_SYSTEM_NAME=Generic -DCMAKE_C_COMPILER=arm-none-eabi-gcc -DCMAKE_TRY_COMPILE_TARGET_TYPE=STATIC_LIBRARY \
        -DCMAKE_C_FLAGS="-mthumb $flags" -DCMAKE_EXE_LINKER_FLAGS=--specs=nosys.specs "$@"
}

# A micro:bit's Cortex-M0 stands for the Cortex-M0+ of a Pico.
cmake_on_a_pico() {
    cp "$example/jog.c" program.c
    chip thumbv6m-none-eabi
    cross "$m0" -DCMAKE_EXE_LINKER_FLAGS="$map"
    emulate build/program
}

# cross_refused ARCHIVE-FOR FLAGS-FOR ARGUMENT…: CMake must stop, not the linker later
cross_refused() {
    sentence="is for $1, but the compiler's flags are for $2: change the one or the other."
    shift 2
    refused "$sentence" cross "$@"
    test ! -e build/CMakeFiles/program.dir
}

cmake_checks_the_processor() {
    cp "$example/jog.c" program.c
    cross "$m4 -mfloat-abi=hard" -DATRAJ_PREBUILT="$m4f_archive" -DATRAJ_MAKE=/nonexistent
    cross_refused thumbv7em-none-eabihf thumbv6m-none-eabi "$m0" -DATRAJ_PREBUILT="$m4f_archive"
    cross_refused thumbv7em-none-eabihf 'thumbv7em-none-eabi cortex-m4' "$m4 -mfloat-abi=softfp" -DATRAJ_PREBUILT="$m4f_archive"
    cross_refused thumbv7em-none-eabihf thumbv6m-none-eabi "$m0" -DATRAJ_TARGET=thumbv7em-none-eabihf
    # The flags of a Cortex-M0+ come from add_compile_options.
    cross_refused thumbv7em-none-eabihf thumbv6m-none-eabi '' -DOPTIONS=$m0 -DATRAJ_PREBUILT="$m4f_archive"
    refused "is for thumbv7em-none-eabihf, but the compiler's flags are for $(uname -m)-" by_cmake -DATRAJ_PREBUILT="$m4f_archive"
}

# A library for a Cortex-M7 in name: its unit computes in binary64, that of a Cortex-M4F does not.
cmake_checks_the_unit() {
    cp "$example/jog.c" program.c
    cp -R "$m4f_archive" m7
    sed -i 's/^machine=.*/& cortex-m7/' m7/lib/pkgconfig/*.pc
    cross "$m7" -DATRAJ_PREBUILT="$PWD/m7"
    cross_refused 'thumbv7em-none-eabihf cortex-m7' thumbv7em-none-eabihf "$m4 -mfloat-abi=hard" -DATRAJ_PREBUILT="$PWD/m7"
}

# Without -mcpu the compiler is for an Arm7.
cmake_without_a_processor() {
    cp "$example/jog.c" program.c
    refused 'does not know the processor of these compiler flags: set ATRAJ_TARGET or ATRAJ_PREBUILT.' cross ''
    refused 'nothing checks that it is thumbv7em-none-eabihf' cross '' -DATRAJ_PREBUILT="$m4f_archive"
}

# The flags of each chip must tell the archive of the chip. On AArch64, gcc's are for Linux.
knows_the_chips() {
    grep '| TARGET=' "$root/packaging/chips.txt" > chips
    test "$(wc -l < chips)" -ge 10
    while IFS='|' read -r _ choice compiler _; do
        case $choice in *aarch64*) compiler='clang --target=aarch64-none-elf' ;; esac
        $compiler -dM -E "$root/packaging/processor.h" > macros
        sed -n 's/.*ATRAJ_TARGETS "\([^ "]*\).*/TARGET=\1/p' macros > told
        sed -n 's/.*ATRAJ_CPU "\(.*\)"/CPU=\1/p' macros >> told
        test "$(echo $(cat told))" = "$(echo $choice)"
    done < chips
}

# Zephyr and ESP-IDF are too large for a test. A stand-in gives what their CMake files give.
zephyr_stand_in() {
    grep "cmake: packaging/zephyr$" "$root/zephyr/module.yml"
    cmake -S "$sources/zephyr" -B build -DROOT="$root" -DCMAKE_SYSTEM_NAME=Generic -DCMAKE_C_COMPILER=arm-none-eabi-gcc \
        -DCMAKE_TRY_COMPILE_TARGET_TYPE=STATIC_LIBRARY
    cmake --build build
}

esp_idf_stand_in() {
    cmake -S "$sources/esp-idf" -B build -DROOT="$root"
    cmake --build build
    prints_the_bits build/app
}

# --- Meson and Conan

# by_meson ARGUMENT…: builds program.c
by_meson() {
    rm -rf build
    mkdir -p subprojects
    ln -sfn "$root" subprojects/atraj
    cp "$subproject"/meson* .
    meson setup build -Ddependency=$package -Datraj:real=$real "$@"
    ninja -C build
}

meson_program() {
    cp "$sources/move.c" program.c
    by_meson "$@"
    prints_the_bits build/program
}

meson_prebuilt() {
    meson_program -Datraj:prebuilt="$unpacked-$package"
    grep -F "release-$package/lib/lib$package.a" build/build.ninja
}

meson_firmware() {
    cp "$example/jog.c" program.c
    by_meson --cross-file "$subproject/cortex-m4f.ini"
    arm-none-eabi-readelf -A build/program | grep 'Tag_ABI_VFP_args: VFP registers'
    refused 'but the compiler is for thumbv7em-none-eabihf: change the one or the other.' \
        by_meson --cross-file "$subproject/cortex-m4f.ini" -Datraj:prebuilt="$unpacked-$package"
}

# conan_create SHARED: the recipe's test prints the bits among Conan's own lines
conan_create() {
    export CONAN_HOME=$work/conan
    test -e "$CONAN_HOME/profiles/default" || conan profile detect
    conan create "$clone/packaging/conan" -o "atraj/*:real=$real" -o "atraj/*:shared=$1" > said 2>&1 || { cat said && exit 1; }
    grep -xFf "$work/$real.expected" said > printed
    diff "$work/$real.expected" printed
}

# --- Debian's packages

debian=$work/debian

debian_packages() {
    for turn in first second; do
        make -C "$root" deb
        cp -R "$root/target/deb" $turn
    done
    diff -r first second
    test "$(ls first/*_"$version"-*.deb | wc -l)" = 4
    lintian --allow-root --fail-on error,warning first/*.deb
    mkdir -p "$debian/var/lib/dpkg/updates" "$debian/var/lib/dpkg/info"
    touch "$debian/var/lib/dpkg/status"
    # No package of Debian's own is in this folder. The path of a user has no sbin, and dpkg wants programs of it.
    PATH=$PATH:/usr/sbin:/sbin dpkg --root="$debian" --force-depends --force-not-root --log=log -i first/*.deb
}

debian_program() {
    libdir=$debian/usr/lib/$(dpkg-architecture -qDEB_HOST_MULTIARCH)
    ${CC:-cc} "$sources/move.c" -o move $(PKG_CONFIG_PATH=$libdir/pkgconfig pkg-config --cflags --libs $package)
    LD_LIBRARY_PATH=$libdir prints_the_bits ./move
    cmake -S "$sources" -B build -DSOURCE=move.c -DPACKAGE=$package -DCMAKE_PREFIX_PATH="$debian/usr"
    cmake --build build
    prints_the_bits build/move
    make -C "$root" identify FILE="$libdir/lib$package.so.$version"
}

# --- the matrix

# each_real TITLE COMMAND…: a row for each real type
each_real() {
    question=$1
    shift
    for real in double float; do
        about $real
        row "$question, $real" "$@"
    done
}

each_real "a release's folder" unpacked_release
if have cmake; then
    each_real "cmake, add_subdirectory, static" cmake_program
    each_real "cmake, add_subdirectory, shared" cmake_shared
    each_real "cmake, add_subdirectory, a release's folder" cmake_prebuilt
    each_real "cmake, FetchContent of a release" cmake_fetches_a_release
    about double
    row "cmake, ESP-IDF's component on a stand-in" esp_idf_stand_in
fi
if have git; then
    about double
    row "a repository of the sources" clone_of_the_sources
    have cmake && row "cmake, FetchContent of a repository, and a change in it" cmake_fetches_the_sources
fi
if have cmake && have arm-none-eabi-gcc; then
    about double
    have qemu-system-arm && row "cmake, add_subdirectory, Cortex-M0+, in the emulator" cmake_on_a_pico
    about float
    row "cmake checks processor and float ABI" cmake_checks_the_processor
    row "cmake checks the floating-point unit" cmake_checks_the_unit
    row "cmake says that it does not know a processor" cmake_without_a_processor
    row "cmake, Zephyr's module on a stand-in" zephyr_stand_in
    have riscv64-unknown-elf-gcc && have clang && row "the compilers tell the archives of the chips" knows_the_chips
fi

if have python3; then
    row "Meson and Conan from PyPI" tools_from_pypi
    PATH=$root/target/venv/bin:$PATH
    each_real "meson, subproject" meson_program
    each_real "meson, subproject, a release's folder" meson_prebuilt
    have arm-none-eabi-gcc && row "meson, subproject, Cortex-M4F, float" meson_firmware
    about double
    row "conan create, static, double" conan_create False
    about float
    row "conan create, shared, float" conan_create True
fi

if have dh && have lintian && have pkg-config && have cmake; then
    row "make deb, lintian, dpkg" debian_packages
    each_real "program on the Debian packages" debian_program
fi
