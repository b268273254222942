# SPDX-License-Identifier: GPL-3.0-or-later
# What is installed besides programs and libraries, and the packages that CPack makes of it:
#   geomesh          the program, manual, documents, samples     (component program)
#   libgeomesh-dev   headers, static libraries, CMake package    (component development)
#   python3-geomesh  the Python package                          (component python)
#   geomesh-gdal     the module that reads GeoTIFF by GDAL       (component gdal)
# cpack -G DEB in the build folder writes the four. Files of those that a user installs begin with "geomesh", so that
# apt install ./geomesh*.deb takes them all.
include(GNUInstallDirs)
set(documents "${CMAKE_INSTALL_DATAROOTDIR}/doc/geomesh")
install(FILES LICENSE README.md CHANGELOG.md CITATION.cff DESTINATION "${documents}" COMPONENT program)
install(FILES core/LICENSE DESTINATION "${documents}" RENAME LICENSE.core COMPONENT program)
install(DIRECTORY docs/ DESTINATION "${documents}" COMPONENT program PATTERN "*.json" EXCLUDE)
install(FILES docs/project.schema.json docs/report.schema.json DESTINATION "${CMAKE_INSTALL_DATAROOTDIR}/geomesh" COMPONENT program)
install(DIRECTORY samples DESTINATION "${CMAKE_INSTALL_DATAROOTDIR}/geomesh" COMPONENT program USE_SOURCE_PERMISSIONS
        PATTERN out EXCLUDE PATTERN __pycache__ EXCLUDE)

# The manual page and the shells' completions come out of the program's own help.
if(NOT Python_EXECUTABLE AND NOT SKBUILD AND EXISTS /usr/bin/python3)
  set(Python_EXECUTABLE /usr/bin/python3)  # the system's, as of the package
endif()
find_package(Python 3.9 QUIET COMPONENTS Interpreter)
if(TARGET geomesh AND Python_FOUND)
  set(shell_files "${PROJECT_BINARY_DIR}/shell")
  string(TIMESTAMP today "%Y-%m-%d" UTC)
  add_custom_command(OUTPUT "${shell_files}/geomesh.1"
    COMMAND "${Python_EXECUTABLE}" "${PROJECT_SOURCE_DIR}/packaging/make_shell_files.py" "$<TARGET_FILE:geomesh>" "${PROJECT_VERSION}" "${today}"
            "${shell_files}"
    DEPENDS geomesh "$<TARGET_NAME_IF_EXISTS:geomesh-picture>" packaging/make_shell_files.py VERBATIM)
  add_custom_target(shell-files ALL DEPENDS "${shell_files}/geomesh.1")
  install(FILES "${shell_files}/geomesh.1" DESTINATION "${CMAKE_INSTALL_MANDIR}/man1" COMPONENT program)
  install(FILES "${shell_files}/geomesh.bash" DESTINATION "${CMAKE_INSTALL_DATAROOTDIR}/bash-completion/completions" RENAME geomesh
          COMPONENT program)
  install(FILES "${shell_files}/_geomesh" DESTINATION "${CMAKE_INSTALL_DATAROOTDIR}/zsh/vendor-completions" COMPONENT program)
  install(FILES "${shell_files}/geomesh.fish" DESTINATION "${CMAKE_INSTALL_DATAROOTDIR}/fish/vendor_completions.d" COMPONENT program)
endif()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_VENDOR "geomesh")
set(CPACK_PACKAGE_CONTACT "the geomesh maintainers <maintainers@geomesh.invalid>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_RESOURCE_FILE_LICENSE "${PROJECT_SOURCE_DIR}/LICENSE")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_COMPONENTS_ALL program development python)
if(TARGET geomesh-gdal)
  list(APPEND CPACK_COMPONENTS_ALL gdal)
endif()
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_GDAL_PACKAGE_NAME geomesh-gdal)
set(CPACK_COMPONENT_GDAL_DESCRIPTION "The module of geomesh that reads GeoTIFF, by GDAL")
set(CPACK_DEBIAN_GDAL_PACKAGE_ENHANCES "geomesh, python3-geomesh")
execute_process(COMMAND dpkg --print-architecture OUTPUT_VARIABLE debian_architecture OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME geomesh)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "geomesh-gdal, xvfb, xauth")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libgeomesh-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libtbb-dev")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_RECOMMENDS
    "libcgal-dev, libvtk9-dev, libeigen3-dev, libproj-dev, zlib1g-dev, libyaml-cpp-dev, nlohmann-json3-dev, libgeographiclib-dev, libmetis-dev, pkg-config")
math(EXPR next_minor "${Python_VERSION_MINOR} + 1")
set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-geomesh)
set(CPACK_DEBIAN_PYTHON_FILE_NAME "geomesh-python3_${PROJECT_VERSION}_${debian_architecture}.deb")
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "python3 (>= ${Python_VERSION_MAJOR}.${Python_VERSION_MINOR}), python3 (<< ${Python_VERSION_MAJOR}.${next_minor}), python3-numpy")
set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS "geomesh, geomesh-gdal, python3-meshio, python3-yaml, python3-h5py")
include(CPack)
