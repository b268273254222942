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

find_program(GEOMESH_CCACHE ccache)
if(GEOMESH_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER "${GEOMESH_CCACHE}")
  set(CMAKE_C_COMPILER_LAUNCHER "${GEOMESH_CCACHE}")
endif()
find_program(GEOMESH_MOLD mold)
if(GEOMESH_MOLD AND NOT WIN32 AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_GREATER_EQUAL 12.1)
  add_link_options(-fuse-ld=mold)
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
