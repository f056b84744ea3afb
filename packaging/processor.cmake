# Which archives fit the flags of the C compiler.

# Sets atraj_targets, atraj_cpu and atraj_not_cpus to what packaging/processor.h says under the flags of CMAKE_C_FLAGS and of
# add_compile_options. CMake cannot evaluate generator expressions here, so they are left out.
function(atraj_read_processor)
    separate_arguments(flags NATIVE_COMMAND "${CMAKE_C_COMPILER_ARG1} ${CMAKE_C_FLAGS}")
    if(CMAKE_C_COMPILER_TARGET)
        list(APPEND flags "--target=${CMAKE_C_COMPILER_TARGET}")
    endif()
    get_directory_property(options COMPILE_OPTIONS)
    list(FILTER options EXCLUDE REGEX "\\$<")
    execute_process(OUTPUT_VARIABLE macros ERROR_QUIET
        COMMAND "${CMAKE_C_COMPILER}" ${flags} ${options} -dM -E "${CMAKE_CURRENT_FUNCTION_LIST_DIR}/processor.h")
    foreach(variable targets cpu not_cpus)
        string(TOUPPER ${variable} macro)
        string(REGEX MATCH "ATRAJ_${macro} \"([^\"]*)\"" found "${macros}")
        string(REPLACE " " ";" value "${CMAKE_MATCH_1}")
        set(atraj_${variable} "${value}" PARENT_SCOPE)
    endforeach()
endfunction()

# Stops unless the library NAME of the folder fits the flags.
function(atraj_check_processor folder name)
    file(STRINGS "${folder}/lib/pkgconfig/${name}.pc" machine REGEX "^machine=")
    string(REGEX MATCH "^machine=([^ ]*) ?(.*)$" machine "${machine}")
    set(target "${CMAKE_MATCH_1}")
    set(cpu "${CMAKE_MATCH_2}")
    if(NOT atraj_targets)
        message(WARNING "atraj does not know the processor of these compiler flags: nothing checks that it is ${target}.")
    elseif(NOT target IN_LIST atraj_targets OR (cpu AND cpu IN_LIST atraj_not_cpus))
        list(GET atraj_targets 0 best)
        string(JOIN " " ours ${target} ${cpu})
        string(JOIN " " theirs ${best} ${atraj_cpu})
        message(FATAL_ERROR
            "The library in ${folder} is for ${ours}, but the compiler's flags are for ${theirs}: change the one or the other.")
    endif()
endfunction()
