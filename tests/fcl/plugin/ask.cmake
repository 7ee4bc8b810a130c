# Hosts open plugins that bring tricover. Whether FCL's own functions reach tricover depends on which comes first;
# tricover_fcl's functions answer in every case.
set(ANSWERS "11 0 1, 11 0 1, 00 0.5 0, 00 0.5 0, 1\n")
set(SPHERES "spheres: 1 1\n")
set(REFUSED "says before fcl\nsays LD_PRELOAD\nsays tricover_fcl::collide\n${ANSWERS}")
set(REGISTERED "registered\n${ANSWERS}${ANSWERS}")

function(ask host expected)
  foreach(scope local global)
    execute_process(COMMAND ${CMAKE_COMMAND} -E env ${ARGN} ${host} ${scope} ${PLUGIN} ${OTHER} OUTPUT_VARIABLE said
      ERROR_VARIABLE warned RESULT_VARIABLE code)
    if(NOT code EQUAL 0 OR NOT said STREQUAL expected)
      message(FATAL_ERROR "${host} ${scope} ${ARGN}: ${code}\n${said}${warned}instead of\n${expected}")
    endif()
  endforeach()
endfunction()

ask(${HOST} "${SPHERES}${REFUSED}${REFUSED}${SPHERES}")  # libfcl comes first
ask(${HOST_WITHOUT_FCL} "${REGISTERED}${REGISTERED}")    # tricover comes first in each plugin
ask(${HOST} "${SPHERES}${REGISTERED}${REGISTERED}${SPHERES}" "LD_PRELOAD=${PRELOADED}")
