# How our own programs are compiled when the caller does not say otherwise.

if(PROJECT_IS_TOP_LEVEL AND NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Release, Debug, RelWithDebInfo or MinSizeRel" FORCE)
endif()

# The flags of our own targets; users of the library never see them.
add_library(shape_interrogation_warnings INTERFACE)
if(NOT MSVC)
  target_compile_options(shape_interrogation_warnings INTERFACE -Wall -Wextra -Wpedantic)
endif()
