# The target doc: the manual in build/doc. CGAL's own documentation build sets the same variables
# to values of its own, so that doc/Shape_interrogation serves both.

find_package(Doxygen 1.9.4 REQUIRED)
set(CGAL_DOC_VERSION standalone)
set(CGAL_CREATED_VERSION_NUM ${PROJECT_VERSION})
set(CGAL_PACKAGE_DOC_DIR ${PROJECT_SOURCE_DIR}/doc/Shape_interrogation)
set(doc_images ${CGAL_PACKAGE_DOC_DIR}/fig)
if(NOT EXISTS ${doc_images})
  unset(doc_images)
endif()
set(CGAL_DOC_PACKAGE_DEFAULTS ${PROJECT_BINARY_DIR}/doc_input/defaults.dxy)
configure_file(${PROJECT_SOURCE_DIR}/doc/standalone/defaults.dxy.in ${CGAL_DOC_PACKAGE_DEFAULTS}
  @ONLY)
configure_file(${CGAL_PACKAGE_DOC_DIR}/Doxyfile.in ${PROJECT_BINARY_DIR}/doc_input/Doxyfile)
add_custom_target(doc
  COMMAND Doxygen::doxygen ${PROJECT_BINARY_DIR}/doc_input/Doxyfile
  COMMENT "Building the manual in ${PROJECT_BINARY_DIR}/doc"
  VERBATIM)
