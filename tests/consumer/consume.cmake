# Installs tricover into WORK/prefix, builds app against it, and checks what its programs print.
function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()

function(expect program pattern)
  execute_process(COMMAND ${WORK}/app/${program} OUTPUT_VARIABLE output COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
  message(STATUS "${output}")
  if(NOT output MATCHES "${pattern}")
    message(FATAL_ERROR "${program} printed\n${output}\ninstead of ${pattern}")
  endif()
endfunction()

set(TOOLS -G ${GENERATOR} -DCMAKE_CXX_COMPILER=${COMPILER})
file(REMOVE_RECURSE ${WORK}/prefix ${WORK}/app)
if(SHARED)
  run(${CMAKE_COMMAND} ${TOOLS} -S ${REPOSITORY} -B ${WORK}/build -DBUILD_SHARED_LIBS=ON -DCMAKE_BUILD_TYPE=Debug
    -DCMAKE_CXX_FLAGS_DEBUG=-O0)
  run(${CMAKE_COMMAND} --build ${WORK}/build --parallel 2)
  run(${CMAKE_COMMAND} --install ${WORK}/build --prefix ${WORK}/prefix)
else()
  run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/prefix)
endif()

run(${CMAKE_COMMAND} ${TOOLS} -S ${REPOSITORY}/tests/consumer/app -B ${WORK}/app -DCMAKE_PREFIX_PATH=${WORK}/prefix
  -DCMAKE_BUILD_TYPE=Debug -DEXAMPLES=${REPOSITORY}/fcl_adapter/examples)
run(${CMAKE_COMMAND} --build ${WORK}/app --parallel 2)

expect(core_only "^meet\n$")
expect(readme_example "^x = 3: free\nx = 4: free\nx = 5: free\nx = 6: collides\nx = 7: collides\n$")
set(ANSWERS "collide: 1 0\ndistance: 0 0.5\ncontinuousCollide: 1 0\n")
expect(fcl_listed_first "^registered\n${ANSWERS}tricover_fcl\n${ANSWERS}$")
if(SHARED)
  expect(libfcl_first "^refused: tricover: fcl::collide doesn't reach tricover.*Link .*\ntricover_fcl\n${ANSWERS}$")
endif()
