# Targets: atraj::static is the archive; atraj::atraj is the shared library, which bare metal does not have.

if(TARGET atraj::static)
    return()
endif()

get_filename_component(_atraj_prefix "${CMAKE_CURRENT_LIST_DIR}/../../.." REALPATH)

add_library(atraj::static STATIC IMPORTED)
set_target_properties(atraj::static PROPERTIES
    IMPORTED_LOCATION "${_atraj_prefix}/lib/libatraj.a"
    INTERFACE_INCLUDE_DIRECTORIES "${_atraj_prefix}/include"
    INTERFACE_LINK_LIBRARIES m)

if(EXISTS "${_atraj_prefix}/lib/libatraj.so")
    add_library(atraj::atraj SHARED IMPORTED)
    set_target_properties(atraj::atraj PROPERTIES
        IMPORTED_LOCATION "${_atraj_prefix}/lib/libatraj.so"
        INTERFACE_INCLUDE_DIRECTORIES "${_atraj_prefix}/include")
endif()

unset(_atraj_prefix)
