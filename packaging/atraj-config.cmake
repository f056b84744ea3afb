# Targets: @NAME@::static is the archive; @NAME@::@NAME@ is the shared library or DLL, which bare metal and musl do not have.

if(TARGET @NAME@::static)
    return()
endif()

# Somebody who asks for a component would else get this real type instead of the wanted one.
if(@NAME@_FIND_COMPONENTS)
    set(@NAME@_FOUND FALSE)
    set(@NAME@_NOT_FOUND_MESSAGE
        "@NAME@ has no components. Each real type is a package of its own: find_package(atraj), find_package(atraj-float).")
    return()
endif()

get_filename_component(_atraj_lib "${CMAKE_CURRENT_LIST_DIR}/../.." REALPATH)
get_filename_component(_atraj_include "${_atraj_lib}/../include" REALPATH)

# One program can hold one ABI only, because all have the same symbols. CMake refuses to link two values of atraj_ABI.
function(_atraj_add name kind file)
    add_library(${name} ${kind} IMPORTED)
    set_target_properties(${name} PROPERTIES
        IMPORTED_LOCATION "${file}"
        INTERFACE_INCLUDE_DIRECTORIES "${_atraj_include}"
        INTERFACE_atraj_ABI @NAME@
        COMPATIBLE_INTERFACE_STRING atraj_ABI)
endfunction()

_atraj_add(@NAME@::static STATIC "${_atraj_lib}/lib@NAME@.a")
set_target_properties(@NAME@::static PROPERTIES INTERFACE_LINK_LIBRARIES m)

if(EXISTS "${_atraj_lib}/lib@NAME@.so")
    _atraj_add(@NAME@::@NAME@ SHARED "${_atraj_lib}/lib@NAME@.so")
endif()

file(GLOB _atraj_dll "${_atraj_lib}/../bin/lib@NAME@-[0-9]*.dll")
if(_atraj_dll)
    _atraj_add(@NAME@::@NAME@ SHARED "${_atraj_dll}")
    set_target_properties(@NAME@::@NAME@ PROPERTIES IMPORTED_IMPLIB "${_atraj_lib}/lib@NAME@.dll.a")
endif()

unset(_atraj_dll)
unset(_atraj_lib)
unset(_atraj_include)
