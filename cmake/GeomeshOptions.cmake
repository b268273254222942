# Language level and flags common to all targets; `geomesh_target_defaults(target)` applies them.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/bin")
if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
endif()

option(GEOMESH_GROUPED "Compile sources in groups, and common headers once: faster from nothing, slower after a change" OFF)

find_program(GEOMESH_CCACHE ccache)
if(GEOMESH_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER "${GEOMESH_CCACHE}")
  # ccache keeps results with precompiled headers only with these leniencies. It must compare the headers themselves (depend mode): two
  # headers that differ in a comment are the same once preprocessed, but GCC knows a header of "#pragma once" by its bytes, so it would read
  # the header a second time after precompiled headers that were made before the comment changed.
  if(CMAKE_HOST_UNIX AND GEOMESH_GROUPED)
    set(CMAKE_CXX_COMPILER_LAUNCHER env CCACHE_DEPEND=1 CCACHE_SLOPPINESS=pch_defines,time_macros "${GEOMESH_CCACHE}")
  endif()
  set(CMAKE_C_COMPILER_LAUNCHER "${GEOMESH_CCACHE}")
endif()
find_program(GEOMESH_MOLD mold)
if(GEOMESH_MOLD AND NOT WIN32 AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_GREATER_EQUAL 12.1)
  add_link_options(-fuse-ld=mold)
endif()

if(MINGW)
  include_directories(BEFORE SYSTEM "${PROJECT_SOURCE_DIR}/cmake/windows")  # windows.h without macros for `near` and `far`
endif()

set(GEOMESH_SANITIZE "" CACHE STRING "Sanitizers: address,undefined or thread")
if(GEOMESH_SANITIZE)
  add_compile_options(-fsanitize=${GEOMESH_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)  # a finding fails the test
  add_link_options(-fsanitize=${GEOMESH_SANITIZE})
  add_compile_definitions(GEOMESH_SANITIZED)  # memory is left to the sanitizer
endif()

# Python itself is no program of a sanitizer: its library is to be loaded first, with the one whose exceptions it watches. Empty where
# nothing is to be loaded.
function(geomesh_libraries_before_python result)
  set(files "")
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND GEOMESH_SANITIZE MATCHES "(address|thread)")
    string(REGEX REPLACE ".*(a|t)(ddress|hread).*" "\\1san" sanitizer "${GEOMESH_SANITIZE}")
    foreach(library ${sanitizer} stdc++)
      execute_process(COMMAND "${CMAKE_CXX_COMPILER}" -print-file-name=lib${library}.so OUTPUT_VARIABLE file OUTPUT_STRIP_TRAILING_WHITESPACE)
      string(APPEND files "${file} ")
    endforeach()
  endif()
  set(${result} "${files}" PARENT_SCOPE)
endfunction()

# Exact arithmetic needs IEEE doubles as written: no contraction into fused multiply-adds, no fast-math.
function(geomesh_target_defaults target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_compile_options(${target} PRIVATE -ffp-contract=off -fno-fast-math -Wall -Wextra -Wpedantic)
  if(CMAKE_CXX_COMPILER_ID MATCHES Clang)
    target_compile_options(${target} PRIVATE -Wno-psabi)  # vectors of four doubles pass between inlined functions alone
  endif()
  if(GEOMESH_EXPENSIVE_CHECKS)
    target_compile_definitions(${target} PUBLIC GEOMESH_EXPENSIVE_CHECKS)
  endif()
endfunction()

# For code that takes no part of a run's time worth mentioning: compiled at -O1 in a third less time, with the same results.
function(geomesh_compile_fast target)
  if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
  endif()
endfunction()

# Headers that nearly all sources of a target include are compiled once. No header of the project that fewer sources include belongs
# into the list: its names would be seen by sources that did not ask for them.
function(geomesh_precompile target)
  if(NOT GEOMESH_GROUPED)
    return()
  endif()
  target_precompile_headers(${target} PRIVATE <algorithm> <array> <atomic> <bit> <charconv> <cmath> <cstdint> <cstdio> <cstring> <deque> <functional> <iterator> <limits>
    <map> <memory> <mutex> <numbers> <numeric> <optional> <queue> <set> <span> <string> <string_view> <thread> <tuple> <unordered_map> <utility> <variant>
    <vector> <tbb/blocked_range.h> <tbb/enumerable_thread_specific.h> <tbb/parallel_for.h> <tbb/task_arena.h> ${ARGN})
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(${target} PRIVATE -fpch-preprocess)  # for ccache
  endif()
endfunction()

# Sources in groups, each compiled as one file where no name of one means something else in another (group_sources.py):
#   geomesh_group_sources(RESULT SOURCES...)     what a target is to compile in place of its sources; those with properties stay alone
find_program(GEOMESH_GROUPING_PYTHON NAMES python3 PATHS /usr/bin NO_DEFAULT_PATH)
find_program(GEOMESH_GROUPING_PYTHON NAMES python3)
function(geomesh_group_sources result)
  set(${result} ${ARGN} PARENT_SCOPE)
  if(NOT GEOMESH_GROUPED OR NOT GEOMESH_GROUPING_PYTHON)
    return()
  endif()
  set(alone "")
  set(grouped "")
  foreach(source ${ARGN})
    get_filename_component(path "${source}" ABSOLUTE)
    get_source_file_property(definitions "${source}" COMPILE_DEFINITIONS)
    get_source_file_property(options "${source}" COMPILE_OPTIONS)
    if(definitions OR options)
      list(APPEND alone "${source}")
    else()
      list(APPEND grouped "${path}")
    endif()
  endforeach()
  # Names may change with any file, and the groups with them.
  set(grouping "${PROJECT_SOURCE_DIR}/cmake/group_sources.py")
  file(GLOB_RECURSE headers CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/core/*.hpp" "${PROJECT_SOURCE_DIR}/geomodel/*.hpp")
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${grouping}" ${grouped} ${headers})
  execute_process(COMMAND "${GEOMESH_GROUPING_PYTHON}" "${grouping}" "${CMAKE_CURRENT_BINARY_DIR}/${result}" 24 ${grouped}
    OUTPUT_VARIABLE groups COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX MATCHALL "[^\n]+" groups "${groups}")
  set(${result} ${groups} ${alone} PARENT_SCOPE)
endfunction()
