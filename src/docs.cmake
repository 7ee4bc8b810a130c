# The API reference, from the public headers: cmake --build <directory> --target docs leaves docs/html/index.html there.
find_package(Doxygen 1.9 QUIET)
if(NOT DOXYGEN_FOUND)
  message(STATUS "Doxygen not found: no target docs")
  return()
endif()

set(DOXYGEN_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/docs)
set(DOXYGEN_JAVADOC_AUTOBRIEF YES)
set(DOXYGEN_EXCLUDE_SYMBOLS tricover::detail tricover_fcl::detail)
set(DOXYGEN_HAVE_DOT NO)
set(DOXYGEN_MACRO_EXPANSION YES)
set(DOXYGEN_EXPAND_ONLY_PREDEF YES)
set(DOXYGEN_PREDEFINED "TRICOVER_EXPORT=")
set(DOXYGEN_QUIET YES)
# Whatever is public and undocumented is a warning, and warnings are errors. Doxygen leaves out, without one, what is in
# an undocumented namespace: that is what tests/docs/check.py is for.
set(DOXYGEN_WARN_AS_ERROR FAIL_ON_WARNINGS)
set(DOXYGEN_EXAMPLE_PATH ${PROJECT_SOURCE_DIR}/tests/docs)
set(DOXYGEN_IMAGE_PATH ${PROJECT_SOURCE_DIR}/tests/docs)
set(DOXYGEN_STRIP_FROM_PATH ${PROJECT_SOURCE_DIR}/include ${PROJECT_SOURCE_DIR}/fcl_adapter/include)
set(DOXYGEN_STRIP_FROM_INC_PATH ${DOXYGEN_STRIP_FROM_PATH})
set(DOXYGEN_SHOW_USED_FILES NO)
set(DOXYGEN_USE_MDFILE_AS_MAINPAGE ${PROJECT_SOURCE_DIR}/src/mainpage.md)
doxygen_add_docs(docs include fcl_adapter/include src/mainpage.md)

if(TRICOVER_BUILD_TESTS)
  add_test(NAME docs COMMAND ${CMAKE_COMMAND} --build ${PROJECT_BINARY_DIR} --target docs)
  set_tests_properties(docs PROPERTIES FIXTURES_SETUP docs)
  find_package(Python3 REQUIRED COMPONENTS Interpreter)
  add_test(NAME docs_list_every_function
    COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/tests/docs/check.py ${PROJECT_BINARY_DIR}/docs/html)
  set_tests_properties(docs_list_every_function PROPERTIES FIXTURES_REQUIRED docs)
endif()
