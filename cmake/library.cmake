# The library target and its installation.

set(CMAKE_FIND_PACKAGE_NAME ${PROJECT_NAME}) # find_dependency() goes by these two
set(${PROJECT_NAME}_FIND_REQUIRED TRUE)
include(${CMAKE_CURRENT_LIST_DIR}/Shape_interrogation_dependencies.cmake)
unset(CMAKE_FIND_PACKAGE_NAME)

add_library(Shape_interrogation INTERFACE)
add_library(Shape_interrogation::Shape_interrogation ALIAS Shape_interrogation)
target_compile_features(Shape_interrogation INTERFACE cxx_std_17)
target_include_directories(Shape_interrogation INTERFACE
  $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>
  $<INSTALL_INTERFACE:include>)
target_link_libraries(Shape_interrogation INTERFACE
  CGAL::CGAL Boost::headers Eigen3::Eigen MPFI::MPFI)
# CGAL hides its use of these two libraries behind a macro each.
target_compile_definitions(Shape_interrogation INTERFACE CGAL_EIGEN3_ENABLED CGAL_USE_MPFI=1)

include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(config_dir ${CMAKE_INSTALL_DATADIR}/cmake/Shape_interrogation)
write_basic_package_version_file(
  ${PROJECT_BINARY_DIR}/cmake/Shape_interrogationConfigVersion.cmake
  COMPATIBILITY SameMinorVersion ARCH_INDEPENDENT)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/ DESTINATION include FILES_MATCHING PATTERN "*.h")
install(TARGETS Shape_interrogation EXPORT Shape_interrogationTargets)
install(EXPORT Shape_interrogationTargets
  NAMESPACE Shape_interrogation:: DESTINATION ${config_dir})
install(FILES
  ${PROJECT_BINARY_DIR}/cmake/Shape_interrogationConfigVersion.cmake
  ${CMAKE_CURRENT_LIST_DIR}/Shape_interrogationConfig.cmake
  ${CMAKE_CURRENT_LIST_DIR}/Shape_interrogation_dependencies.cmake
  ${CMAKE_CURRENT_LIST_DIR}/FindMPFI.cmake
  DESTINATION ${config_dir})
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
