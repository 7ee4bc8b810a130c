# Configures tricover as users may, and looks at the commands that would compile it.
include(${CMAKE_CURRENT_LIST_DIR}/tools.cmake)
file(REMOVE_RECURSE ${WORK})

# commands_of(<source directory> <options>...): sets FILES, and COMMAND_<file> for each.
function(commands_of source)
  set(build ${WORK}/build_of_${source})
  run(${CMAKE_COMMAND} -S ${source} -B ${build} -G ${GENERATOR} -DCMAKE_CXX_COMPILER=${COMPILER}
    -DCMAKE_EXPORT_COMPILE_COMMANDS=ON ${ARGN})
  file(READ ${build}/compile_commands.json commands)
  string(JSON count LENGTH "${commands}")
  math(EXPR last "${count} - 1")
  set(files)
  foreach(i RANGE ${last})
    string(JSON file GET "${commands}" ${i} file)
    string(JSON command GET "${commands}" ${i} command)
    list(APPEND files ${file})
    set(COMMAND_${file} "${command}" PARENT_SCOPE)
  endforeach()
  set(FILES ${files} PARENT_SCOPE)
endfunction()

# A project without a build type: tricover alone is optimised, and yaml-cpp isn't asked for.
file(WRITE ${WORK}/project/CMakeLists.txt "cmake_minimum_required(VERSION 3.22)\nproject(user LANGUAGES CXX)\n"
  "add_subdirectory(${REPOSITORY} tricover)\nadd_executable(app ${REPOSITORY}/tests/consumer/app/core_only.cpp)\n"
  "target_link_libraries(app PRIVATE tricover::tricover)\n")
commands_of(${WORK}/project)
foreach(file ${FILES})
  set(options "${COMMAND_${file}}")
  if(file MATCHES "core_only.cpp$")
    if(options MATCHES " -O|NDEBUG")
      message(FATAL_ERROR "the project's own file is compiled by ${options}")
    endif()
  elseif(NOT options MATCHES " -O[13] ")
    message(FATAL_ERROR "${file} is compiled by ${options}")
  endif()
endforeach()
if(FILES MATCHES "src/io/" OR NOT FILES MATCHES "src/version.cpp" OR NOT FILES MATCHES "fcl_adapter/src")
  message(FATAL_ERROR "instead of tricover and tricover::fcl: ${FILES}")
endif()
commands_of(${WORK}/project "-DCMAKE_CXX_FLAGS=-Og")
if(COMMAND_${REPOSITORY}/src/version.cpp MATCHES "-O[123]")
  message(FATAL_ERROR "the user's optimisation is overruled by ${COMMAND_${REPOSITORY}/src/version.cpp}")
endif()

# Without FCL there are examples all the same.
commands_of(${REPOSITORY} -DTRICOVER_BUILD_FCL=OFF -DTRICOVER_BUILD_EXAMPLES=ON)
foreach(example scene warehouse nesting)
  if(NOT FILES MATCHES "tests/examples/${example}.cpp")
    message(FATAL_ERROR "the example ${example} isn't among ${FILES}")
  endif()
endforeach()
