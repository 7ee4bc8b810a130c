# Builds the project own_fcl, and checks what its program prints.
include(${CMAKE_CURRENT_LIST_DIR}/tools.cmake)
file(REMOVE_RECURSE ${WORK})
file(WRITE ${WORK}/objects.cmake "set(CORE_OBJECTS ${CORE_OBJECTS})\nset(FCL_OBJECTS ${FCL_OBJECTS})\n")
run(${CMAKE_COMMAND} -S ${REPOSITORY}/tests/consumer/own_fcl -B ${WORK} ${TOOLS} -DTRICOVER=${REPOSITORY}
  -DTRICOVER_WERROR=ON)
run(${CMAKE_COMMAND} --build ${WORK} --target readme --parallel 2)
expect(readme "${README_PRINTS}")
