# Read by find_package(Shape_interrogation): defines Shape_interrogation::Shape_interrogation.

include(${CMAKE_CURRENT_LIST_DIR}/Shape_interrogation_dependencies.cmake)
if(NOT DEFINED Shape_interrogation_FOUND OR Shape_interrogation_FOUND)
  include(${CMAKE_CURRENT_LIST_DIR}/Shape_interrogationTargets.cmake)
endif()
