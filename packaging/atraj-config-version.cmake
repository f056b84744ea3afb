# A later version is compatible if its first number is the same, because the soname has only the first number.

set(PACKAGE_VERSION "@VERSION@")
string(REGEX MATCH "^[0-9]+" _atraj_major "${PACKAGE_VERSION}")

if(PACKAGE_FIND_VERSION_MAJOR STREQUAL _atraj_major AND PACKAGE_FIND_VERSION VERSION_LESS_EQUAL PACKAGE_VERSION)
    set(PACKAGE_VERSION_COMPATIBLE TRUE)
endif()
if(PACKAGE_FIND_VERSION VERSION_EQUAL PACKAGE_VERSION)
    set(PACKAGE_VERSION_EXACT TRUE)
endif()

unset(_atraj_major)
