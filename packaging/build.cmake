# Runs `make dist` for the compiler's processor and sets `folder` to what it fills. CMakeLists.txt includes this file.

set(target "${ATRAJ_TARGET}")
set(cpu "${ATRAJ_CPU}")
if(CMAKE_CROSSCOMPILING AND NOT target)
    if(NOT atraj_targets)
        message(FATAL_ERROR "atraj does not know the processor of these compiler flags: set ATRAJ_TARGET or ATRAJ_PREBUILT.")
    endif()
    list(GET atraj_targets 0 target)
    if(NOT cpu)
        set(cpu "${atraj_cpu}")
    endif()
endif()

# CMake runs again when a source changes.
file(GLOB_RECURSE sources CONFIGURE_DEPENDS src/*.rs include/*.h packaging/*)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${sources} Makefile Cargo.toml Cargo.lock build.rs)

# A make that runs CMake again leaves its own flags in the environment.
find_program(ATRAJ_MAKE NAMES gmake make)
execute_process(RESULT_VARIABLE result OUTPUT_VARIABLE folder OUTPUT_STRIP_TRAILING_WHITESPACE
    COMMAND "${CMAKE_COMMAND}" -E env --unset=MAKEFLAGS --unset=MAKELEVEL "${ATRAJ_MAKE}" -s -C "${CMAKE_CURRENT_SOURCE_DIR}"
        dist where HWCAPS= "TARGET=${target}" "CPU=${cpu}" "REAL=${ATRAJ_REAL}" "POLY=${ATRAJ_POLY}")
if(NOT result EQUAL 0)
    message(FATAL_ERROR "atraj: `make dist` failed. Do what its message above says, or set ATRAJ_PREBUILT to a release's folder.")
endif()
