# Installs tricover, moves that elsewhere, builds app against it, and checks what its programs print.
include(${CMAKE_CURRENT_LIST_DIR}/tools.cmake)
file(REMOVE_RECURSE ${WORK})
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/first)
file(RENAME ${WORK}/first ${WORK}/prefix)

foreach(file share/doc/tricover/LICENSE share/tricover/package.xml include/tricover/occupancy_grid_io.h)
  if(NOT EXISTS ${WORK}/prefix/${file})
    message(FATAL_ERROR "${file} isn't installed")
  endif()
endforeach()

# The same as a Debian package.
find_program(DPKG_DEB dpkg-deb)
if(DPKG_DEB)
  run(${CMAKE_CPACK_COMMAND} -G DEB -B ${WORK}/deb --config ${BUILD}/CPackConfig.cmake)
  file(GLOB package ${WORK}/deb/libtricover-dev_*.deb)
  execute_process(COMMAND ${DPKG_DEB} --fsys-tarfile ${package} COMMAND ${CMAKE_COMMAND} -E tar t /dev/stdin
    OUTPUT_VARIABLE packed COMMAND_ERROR_IS_FATAL ANY)
  file(GLOB_RECURSE files RELATIVE ${WORK}/prefix ${WORK}/prefix/*)
  foreach(file ${files})
    if(NOT packed MATCHES "usr/${file}\n")
      message(FATAL_ERROR "${file} is installed, but not in ${package}")
    endif()
  endforeach()
endif()

set(APP -S ${REPOSITORY}/tests/consumer/app ${TOOLS} -DCMAKE_PREFIX_PATH=${WORK}/prefix)
run(${CMAKE_COMMAND} ${APP} -B ${WORK}/app -DEXAMPLES=${REPOSITORY}/fcl_adapter/examples)
run(${CMAKE_COMMAND} --build ${WORK}/app --parallel 2)

expect(app/core_only "^meet\n$")
expect(app/read_map "^tricover: none.yaml: can't be read: .*\n$")
expect(app/readme_example "${README_PRINTS}")
set(ANSWERS "collide: 1 0\ndistance: 0 0.5\ncontinuousCollide: 1 0\n")
expect(app/fcl_listed_first "^registered\n${ANSWERS}tricover_fcl\n${ANSWERS}$")
if(SHARED)  # whose calls are redirected
  expect(app/libfcl_first "^registered\n${ANSWERS}tricover_fcl\n${ANSWERS}$")
endif()

# A program without shapes for float is linked without FCL's tables for float.
if(NOT SHARED)
  execute_process(COMMAND nm -C ${WORK}/app/readme_example OUTPUT_VARIABLE symbols COMMAND_ERROR_IS_FATAL ANY)
  if(NOT symbols MATCHES "CollisionFunctionMatrix<[^\n]*double" OR symbols MATCHES "CollisionFunctionMatrix<[^\n]*float")
    message(FATAL_ERROR "readme_example holds FCL's tables for float, or none")
  endif()
endif()

# What can't be had is refused with a reason.
function(refuse reason)
  execute_process(COMMAND ${CMAKE_COMMAND} ${APP} -B ${WORK}/refused ${ARGN} RESULT_VARIABLE code ERROR_VARIABLE errors)
  string(REGEX REPLACE "[ \n]+" " " errors "${errors}")
  if(code EQUAL 0 OR NOT errors MATCHES "${reason}")
    message(FATAL_ERROR "instead of ${reason}:\n${errors}")
  endif()
endfunction()
refuse("tricover has no component gjk" -DCOMPONENT=gjk)
refuse("builds an FCL of its own \\(target fcl\\)" -DCOMPONENT=fcl -DOWN_FCL=ON)

# With pkg-config.
file(GLOB_RECURSE pc_file ${WORK}/prefix/tricover-fcl.pc)
cmake_path(GET pc_file PARENT_PATH pc_files)
cmake_path(GET pc_files PARENT_PATH libraries)
set(ENV{PKG_CONFIG_PATH} ${pc_files})
set(ENV{LD_LIBRARY_PATH} ${libraries})
set(core_only tricover)
set(read_map tricover-io)
set(registered tricover-fcl)
foreach(program core_only read_map registered)
  set(package ${${program}})
  execute_process(COMMAND ${PKG_CONFIG} --cflags --libs ${package} OUTPUT_VARIABLE flags COMMAND_ERROR_IS_FATAL ANY)
  separate_arguments(flags UNIX_COMMAND "${flags}")
  run(${COMPILER} ${REPOSITORY}/tests/consumer/app/${program}.cpp -o ${WORK}/pkg_${program} ${flags} -std=c++17)
endforeach()
expect(pkg_core_only "^meet\n$")
expect(pkg_read_map "^tricover: none.yaml: ")
expect(pkg_registered "^registered\n$")

# The kernel is no part of a shared library's interface; FCL's functions that tricover replaces are.
if(SHARED)
  foreach(library tricover tricover_io tricover_fcl)
    execute_process(COMMAND nm -DC --defined-only ${libraries}/lib${library}.so OUTPUT_VARIABLE ${library}
      COMMAND_ERROR_IS_FATAL ANY)
    # A symbol's name begins after its type's letter; the standard library's templates may be of the kernel's types.
    if(${library} MATCHES " [A-Za-z] (tricover::detail::[^\n]*)"
        OR ${library} MATCHES " [A-Za-z] (tricover_fcl::collideMixed[^\n]*)")
      message(FATAL_ERROR "lib${library}.so exports ${CMAKE_MATCH_1}")
    endif()
  endforeach()
  foreach(symbol "fcl::collide<double" "fcl::distance<double" "fcl::getCollisionFunctionLookTable<.*float")
    if(NOT tricover_fcl MATCHES "${symbol}")
      message(FATAL_ERROR "libtricover_fcl.so doesn't export ${symbol}")
    endif()
  endforeach()
endif()
