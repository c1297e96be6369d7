# What a program needs that uses the library. The package's own build and the installed
# configuration both read this file, so that they ask for the same.

include(CMakeFindDependencyMacro)

# CGAL brings GMP and MPFR, and GMPXX where it is there; we need all three. No version is asked for
# here, as CGAL 6 would then be refused in place of 5.
find_dependency(CGAL CONFIG)
if(CGAL_VERSION VERSION_LESS 5.5 OR NOT GMP_FOUND OR NOT MPFR_FOUND OR NOT GMPXX_FOUND)
  set(Shape_interrogation_NOT_FOUND_MESSAGE
    "Shape_interrogation needs CGAL 5.5 or later with GMP, GMPXX and MPFR; found CGAL \
${CGAL_VERSION} (Debian: libcgal-dev libgmp-dev libmpfr-dev).")
  set(Shape_interrogation_FOUND FALSE)
  if(Shape_interrogation_FIND_REQUIRED)
    message(FATAL_ERROR "${Shape_interrogation_NOT_FOUND_MESSAGE}")
  endif()
  return()
endif()

find_dependency(Boost 1.74)
find_dependency(Eigen3 CONFIG)

# MPFI comes without a configuration of its own, and CGAL's module for it defines no target.
list(PREPEND CMAKE_MODULE_PATH ${CMAKE_CURRENT_LIST_DIR})
find_dependency(MPFI 1.5)
list(POP_FRONT CMAKE_MODULE_PATH)
