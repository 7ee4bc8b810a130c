# For the scripts here: run(<command>) and expect(<program> <pattern of its output>), which fail the test.
function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()

function(expect program pattern)
  execute_process(COMMAND ${WORK}/${program} OUTPUT_VARIABLE output COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
  message(STATUS "${output}")
  if(NOT output MATCHES "${pattern}")
    message(FATAL_ERROR "${program} printed\n${output}\ninstead of ${pattern}")
  endif()
endfunction()

set(TOOLS -G ${GENERATOR} -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG=-O0)
set(README_PRINTS "^x = 3: free\nx = 4: free\nx = 5: free\nx = 6: collides\nx = 7: collides\n$")
