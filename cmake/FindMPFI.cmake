# Finds MPFI, intervals of multiprecision numbers. Sets MPFI_FOUND and MPFI_VERSION, and defines
# the target MPFI::MPFI, which brings MPFR and GMP with it.
# MPFI_INCLUDE_DIR and MPFI_LIBRARY may be given, or a prefix in CMAKE_PREFIX_PATH.

find_path(MPFI_INCLUDE_DIR mpfi.h DOC "The directory that contains mpfi.h")
find_library(MPFI_LIBRARY mpfi DOC "The library MPFI")
find_library(MPFI_MPFR_LIBRARY mpfr DOC "The library MPFR, which MPFI needs")
find_library(MPFI_GMP_LIBRARY gmp DOC "The library GMP, which MPFI needs")
mark_as_advanced(MPFI_INCLUDE_DIR MPFI_LIBRARY MPFI_MPFR_LIBRARY MPFI_GMP_LIBRARY)

if(MPFI_INCLUDE_DIR AND EXISTS ${MPFI_INCLUDE_DIR}/mpfi.h)
  file(STRINGS ${MPFI_INCLUDE_DIR}/mpfi.h MPFI_VERSION REGEX "define MPFI_VERSION_STRING")
  string(REGEX REPLACE ".*\"([0-9.]+).*" "\\1" MPFI_VERSION "${MPFI_VERSION}")
endif()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(MPFI
  REQUIRED_VARS MPFI_LIBRARY MPFI_INCLUDE_DIR MPFI_VERSION MPFI_MPFR_LIBRARY MPFI_GMP_LIBRARY
  VERSION_VAR MPFI_VERSION
  REASON_FAILURE_MESSAGE "(Debian: libmpfi-dev)")

if(MPFI_FOUND AND NOT TARGET MPFI::MPFI)
  add_library(MPFI::MPFI UNKNOWN IMPORTED)
  set_target_properties(MPFI::MPFI PROPERTIES
    IMPORTED_LOCATION ${MPFI_LIBRARY}
    INTERFACE_INCLUDE_DIRECTORIES ${MPFI_INCLUDE_DIR}
    INTERFACE_LINK_LIBRARIES "${MPFI_MPFR_LIBRARY};${MPFI_GMP_LIBRARY}")
endif()
