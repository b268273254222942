# SPDX-License-Identifier: MIT
# The compiler of the build for browsers (scripts/browser): emscripten's own toolchain file, and what all sources need besides.
find_program(GEOMESH_EM_CONFIG em-config REQUIRED)
execute_process(COMMAND "${GEOMESH_EM_CONFIG}" EMSCRIPTEN_ROOT OUTPUT_VARIABLE emscripten_root OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
include("${emscripten_root}/cmake/Modules/Platform/Emscripten.cmake")
set(CMAKE_SHARED_LIBRARY_SUFFIX .so)  # modules have no target here, their names stand in messages

# Exceptions and vectors of doubles as every browser of the last years has them: both are an order faster than without. The header,
# with all that it includes, is compiled once (libraries.cmake), which takes two fifths off the time of the build.
set(CMAKE_C_FLAGS_INIT "-fwasm-exceptions -msimd128")
set(CMAKE_CXX_FLAGS_INIT "-fwasm-exceptions -msimd128 -ffp-contract=off -fno-fast-math -include \"${CMAKE_BINARY_DIR}/precompiled/standard_library.hpp\"")
set(CMAKE_C_FLAGS_RELEASE "-O2 -DNDEBUG" CACHE STRING "")
set(CMAKE_CXX_FLAGS_RELEASE "-O2 -DNDEBUG" CACHE STRING "")
set(GEOMESH_CCACHE "" CACHE FILEPATH "ccache does not know the compiled header")
set(CMAKE_PROJECT_TOP_LEVEL_INCLUDES "${CMAKE_CURRENT_LIST_DIR}/libraries.cmake")
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)  # linking would first build emscripten's own libraries, without optimisation
