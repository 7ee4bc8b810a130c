# `cmake --install --prefix` of the Python package alone, then an import of it from there.
file(REMOVE_RECURSE ${WORK})
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK} --component tricover_python
  RESULT_VARIABLE failed OUTPUT_VARIABLE said ERROR_VARIABLE said)
if(failed)
  message(FATAL_ERROR "${said}")
endif()
file(GLOB_RECURSE files RELATIVE ${WORK} ${WORK}/*)
foreach(file ${files})
  if(NOT file MATCHES "^${SITE}/tricover/[a-z_]+(\\.py|\\.pyi|\\..*\\.so)$" AND NOT file MATCHES "/py\\.typed$")
    message(FATAL_ERROR "${file} is none of the package's files in ${SITE}")
  endif()
endforeach()
set(program "import tricover as tc; print(tc.__file__, tc.__version__, tc.Polygon.box(2, 3).area)")
execute_process(COMMAND ${CMAKE_COMMAND} -E env PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=${WORK}/${SITE} ${PYTHON} -c "${program}"
  RESULT_VARIABLE failed OUTPUT_VARIABLE said ERROR_VARIABLE said)
if(failed OR NOT said MATCHES "^${WORK}/${SITE}/tricover/__init__.py [0-9.]+ 6.0\n$")
  message(FATAL_ERROR "the installed package says: ${said}")
endif()
