# What an installed tricover leaves for those who build against it: the headers, find_package(tricover [COMPONENTS fcl])
# pkg-config's tricover.pc, the licence, and what ROS's tools read. `cpack` in the build directory makes a .deb of it.
include(CMakePackageConfigHelpers)
set(TRICOVER_PACKAGE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/tricover)

install(TARGETS tricover EXPORT tricover-core)
install(DIRECTORY include/tricover DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT tricover-core NAMESPACE tricover:: DESTINATION ${TRICOVER_PACKAGE_DIR})
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/tricoverConfig.cmake.in
  ${PROJECT_BINARY_DIR}/tricoverConfig.cmake INSTALL_DESTINATION ${TRICOVER_PACKAGE_DIR})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/tricoverConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/tricoverConfig.cmake ${PROJECT_BINARY_DIR}/tricoverConfigVersion.cmake
  DESTINATION ${TRICOVER_PACKAGE_DIR})

# A .pc file finds its prefix from where it is itself, so that the installed tree can be moved.
if(IS_ABSOLUTE ${CMAKE_INSTALL_LIBDIR})
  set(TRICOVER_PC_PREFIX ${CMAKE_INSTALL_PREFIX})
else()
  file(RELATIVE_PATH TRICOVER_PC_PREFIX /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
  string(REGEX REPLACE "/$" "" TRICOVER_PC_PREFIX "\${pcfiledir}/${TRICOVER_PC_PREFIX}")
endif()
foreach(kind INCLUDE LIB)
  set(TRICOVER_PC_${kind}DIR ${CMAKE_INSTALL_${kind}DIR})
  if(NOT IS_ABSOLUTE ${CMAKE_INSTALL_${kind}DIR})
    string(PREPEND TRICOVER_PC_${kind}DIR "\${prefix}/")
  endif()
endforeach()

# tricover_install_pc(<template>): <template> is a .pc file with variables, and ends in .in.
function(tricover_install_pc template)
  cmake_path(GET template STEM LAST_ONLY name)
  configure_file(${template} ${PROJECT_BINARY_DIR}/${name} @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/${name} DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endfunction()
tricover_install_pc(${CMAKE_CURRENT_LIST_DIR}/tricover.pc.in)

install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
set(TRICOVER_PACKAGE_XML_FCL "")
set(TRICOVER_DEBIAN_DEPENDS "libeigen3-dev")
if(TRICOVER_BUILD_FCL)
  set(TRICOVER_PACKAGE_XML_FCL "  <depend>libfcl-dev</depend>")
  string(APPEND TRICOVER_DEBIAN_DEPENDS ", libfcl-dev, libccd-dev")
endif()
# colcon builds the sources as a plain CMake package; here is what it looks for once that is installed.
configure_file(${CMAKE_CURRENT_LIST_DIR}/package.xml.in ${PROJECT_BINARY_DIR}/package.xml @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/package.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/tricover)

if(PROJECT_IS_TOP_LEVEL)
  set(CPACK_GENERATOR DEB)
  set(CPACK_PACKAGE_NAME libtricover-dev)
  set(CPACK_PACKAGE_CONTACT "the tricover authors <maintainers@tricover.invalid>")
  set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
  set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
  set(CPACK_DEBIAN_PACKAGE_SECTION libdevel)
  set(CPACK_DEBIAN_PACKAGE_DEPENDS "${TRICOVER_DEBIAN_DEPENDS}")
  set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ${BUILD_SHARED_LIBS})
  include(CPack)
endif()
