# tricover::io, the only code that sees yaml-cpp, libpng and nlohmann-json.
find_package(yaml-cpp QUIET)
find_package(PNG QUIET)
find_package(nlohmann_json 3.10 QUIET)
foreach(needed yaml-cpp:libyaml-cpp-dev PNG:libpng-dev nlohmann_json:nlohmann-json3-dev)
  string(REPLACE ":" ";" needed ${needed})
  list(GET needed 0 library)
  list(GET needed 1 debian)
  if(NOT ${library}_FOUND)
    message(FATAL_ERROR "tricover::io needs ${library} (Debian and Ubuntu: ${debian}), which wasn't found. Set "
      "CMAKE_PREFIX_PATH to where it is, or leave out TRICOVER_BUILD_IO, _TESTS and _PYTHON.")
  endif()
endforeach()
set(TRICOVER_YAML_CPP yaml-cpp)
if(TARGET yaml-cpp::yaml-cpp)  # since 0.8
  set(TRICOVER_YAML_CPP yaml-cpp::yaml-cpp)
endif()

add_library(tricover_io
  src/io/geojson.cpp
  src/io/map_fields.cpp
  src/io/map_files.cpp
  src/io/occupancy_grid_io.cpp
  src/io/parts.cpp
  src/io/pgm.cpp
  src/io/png.cpp
  src/io/rasterize.cpp
  src/io/input.cpp
  src/io/wkt.cpp)
add_library(tricover::io ALIAS tricover_io)
target_include_directories(tricover_io PRIVATE src)
target_link_libraries(tricover_io PUBLIC tricover PRIVATE ${TRICOVER_YAML_CPP} PNG::PNG
  $<BUILD_INTERFACE:nlohmann_json::nlohmann_json> $<BUILD_INTERFACE:tricover_warnings>)
set_target_properties(tricover_io PROPERTIES
  EXPORT_NAME io POSITION_INDEPENDENT_CODE ON CXX_VISIBILITY_PRESET ${TRICOVER_VISIBILITY}
  VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})

if(TRICOVER_INSTALL)
  install(TARGETS tricover_io EXPORT tricover-io)
  install(EXPORT tricover-io NAMESPACE tricover:: DESTINATION ${TRICOVER_PACKAGE_DIR})
  tricover_install_pc(${CMAKE_CURRENT_LIST_DIR}/tricover-io.pc.in)
endif()
