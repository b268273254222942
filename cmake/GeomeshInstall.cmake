# Install and export: find_package(geomesh) gives geomesh::core, and geomesh::geomodel where it was built.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(GEOMESH_CONFIG_DIR "${CMAKE_INSTALL_LIBDIR}/cmake/geomesh")

install(DIRECTORY core/include/ DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}" COMPONENT development)
install(TARGETS geomesh_core EXPORT geomesh_core_targets ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}"
        COMPONENT development)
install(EXPORT geomesh_core_targets NAMESPACE geomesh:: DESTINATION "${GEOMESH_CONFIG_DIR}" COMPONENT development)
if(GEOMESH_BUILD_GEOMODEL)
  install(DIRECTORY geomodel/include/ DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}" COMPONENT development)
  install(TARGETS geomesh_geomodel EXPORT geomesh_geomodel_targets ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}"
        COMPONENT development)
  install(EXPORT geomesh_geomodel_targets NAMESPACE geomesh:: DESTINATION "${GEOMESH_CONFIG_DIR}" COMPONENT development)
endif()

configure_package_config_file(cmake/geomeshConfig.cmake.in "${PROJECT_BINARY_DIR}/geomeshConfig.cmake"
  INSTALL_DESTINATION "${GEOMESH_CONFIG_DIR}")
write_basic_package_version_file("${PROJECT_BINARY_DIR}/geomeshConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/geomeshConfig.cmake" "${PROJECT_BINARY_DIR}/geomeshConfigVersion.cmake"
  DESTINATION "${GEOMESH_CONFIG_DIR}" COMPONENT development)
