# find_package(tricover [COMPONENTS fcl]), with or without the adapter.

configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/tricoverConfig.cmake.in
  ${PROJECT_BINARY_DIR}/tricoverConfig.cmake INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/tricover)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/tricoverConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/tricoverConfig.cmake ${PROJECT_BINARY_DIR}/tricoverConfigVersion.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/tricover)
