# Installs the program, the libraries with their headers and a package file, so that another project says
#   find_package(isopatch) and target_link_libraries(... isopatch::iga),
# or find_package(isopatch COMPONENTS solve) for the libraries that solve and what these need alone.

include(CMakePackageConfigHelpers)

set(config_folder "${CMAKE_INSTALL_LIBDIR}/cmake/isopatch")
get_property(libraries GLOBAL PROPERTY ISOPATCH_LIBRARIES)

install(TARGETS isopatch RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}")
install(TARGETS isopatch_drawing isopatch_brep_module LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}/isopatch")
install(TARGETS isopatch_cad_reader RUNTIME DESTINATION "${CMAKE_INSTALL_LIBDIR}/isopatch")
set(solving)
foreach(name base splines geometry mesh hex models io solvers iga)
  list(APPEND solving isopatch_${name})
endforeach()
list(REMOVE_ITEM libraries ${solving})
install(TARGETS isopatch_settings ${solving} EXPORT isopatch_solve ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}")
install(EXPORT isopatch_solve NAMESPACE isopatch:: FILE isopatchSolveTargets.cmake DESTINATION "${config_folder}")
install(TARGETS ${libraries} EXPORT isopatch ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}")
install(EXPORT isopatch NAMESPACE isopatch:: FILE isopatchTargets.cmake DESTINATION "${config_folder}")

# Headers keep their folders, so that they are included as in the tree: "geometry/multi_patch.hpp".
install(DIRECTORY geometry segmentation solvers iga app DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/isopatch"
  FILES_MATCHING PATTERN "*.hpp" PATTERN tests EXCLUDE PATTERN internal EXCLUDE PATTERN program EXCLUDE PATTERN cad_reader EXCLUDE)
install(FILES LICENSE NOTICE.md DESTINATION "${CMAKE_INSTALL_DOCDIR}")

configure_package_config_file(cmake/isopatchConfig.cmake.in "${PROJECT_BINARY_DIR}/isopatchConfig.cmake"
  INSTALL_DESTINATION "${config_folder}")
write_basic_package_version_file("${PROJECT_BINARY_DIR}/isopatchConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/isopatchConfig.cmake" "${PROJECT_BINARY_DIR}/isopatchConfigVersion.cmake"
  cmake/IsopatchSolveDependencies.cmake cmake/IsopatchDependencies.cmake DESTINATION "${config_folder}")
