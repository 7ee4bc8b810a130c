# Runs ALONE and WITH_TRICOVER and compares what they print to the last bit. FCL's warnings on cerr are of no interest.
foreach(program ALONE WITH_TRICOVER)
  execute_process(COMMAND ${${program}} OUTPUT_FILE ${program}.txt ERROR_QUIET COMMAND_ERROR_IS_FATAL ANY)
endforeach()
execute_process(COMMAND ${CMAKE_COMMAND} -E compare_files ALONE.txt WITH_TRICOVER.txt COMMAND_ERROR_IS_FATAL ANY)
file(STRINGS ALONE.txt lines)
list(LENGTH lines count)
list(GET lines -1 summary)
message(STATUS "${count} equal lines; ${summary}")
