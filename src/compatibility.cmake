include(CMakePackageConfigHelpers)

# tricover_version_file(<file> <version>): what find_package asks. Before 1.0 a minor version may break what CHANGELOG says,
# from then on a major one alone.
function(tricover_version_file file version)
  set(same SameMajorVersion)
  if(version VERSION_LESS 1)
    set(same SameMinorVersion)
  endif()
  write_basic_package_version_file(${file} VERSION ${version} COMPATIBILITY ${same})
endfunction()
