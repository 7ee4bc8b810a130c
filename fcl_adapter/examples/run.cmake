# Runs an example, PROGRAM, and checks that it succeeds, prints what matches EXPECTED, and draws where it was told to
# (PICTURE), if it draws at all.
file(REMOVE ${PICTURE})
execute_process(COMMAND ${PROGRAM} ${PICTURE} OUTPUT_VARIABLE output COMMAND_ERROR_IS_FATAL ANY)
message(STATUS "${output}")
if(NOT output MATCHES "${EXPECTED}")
  message(FATAL_ERROR "${PROGRAM} printed\n${output}\ninstead of ${EXPECTED}")
endif()
if(EXISTS ${PICTURE})
  file(READ ${PICTURE} picture)
  if(NOT picture MATCHES "^<svg .*</svg>\n$")
    message(FATAL_ERROR "${PICTURE} is not a whole picture")
  endif()
endif()
