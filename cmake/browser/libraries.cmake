# SPDX-License-Identifier: MIT
# The libraries of the build for browsers. find_package() is answered here, so that the tree's CMakeLists are those of every build.
#
#   header-only (CGAL, Boost, Eigen, nlohmann-json, CLI11)      the headers of the system's packages
#   compiled (yaml-cpp, pugixml, zlib, lz4, liblzma, GeographicLib)  the sources of the system's packages, in
#                                                               GEOMESH_LIBRARY_SOURCES, where scripts/browser puts them
#   oneTBB                                                      include/tbb: the same interface on one thread
#   GMP                                                         left out: CGAL falls back on numbers of its own and of Boost
#   METIS, MPI, VTK, and the libraries of modules               left out, as in any build without them
set(GEOMESH_LIBRARY_SOURCES "" CACHE PATH "Folder with the unpacked sources of the compiled libraries")
set(here "${CMAKE_CURRENT_LIST_DIR}")

# The folder /usr/include itself would bring the headers of another C library.
set(headers "${CMAKE_BINARY_DIR}/headers")
file(MAKE_DIRECTORY "${headers}")
foreach(name CGAL boost nlohmann CLI)
  if(NOT EXISTS "/usr/include/${name}")
    message(FATAL_ERROR "/usr/include/${name} is missing: install the packages of scripts/packages.txt")
  endif()
  file(CREATE_LINK "/usr/include/${name}" "${headers}/${name}" SYMBOLIC)
endforeach()

# What the library of emscripten lacks, with the headers that most sources include: the compiler takes the file *.pch beside the header.
set(precompiled "${CMAKE_BINARY_DIR}/precompiled/standard_library.hpp")
if(NOT EXISTS "${precompiled}.pch" OR "${here}/include/standard_library.hpp" IS_NEWER_THAN "${precompiled}.pch")
  configure_file("${here}/include/standard_library.hpp" "${precompiled}" COPYONLY)
  execute_process(COMMAND em++ -O2 -DNDEBUG -std=c++20 -fwasm-exceptions -msimd128 -ffp-contract=off -fno-fast-math -isystem "${headers}" -x c++-header
                          "${precompiled}" -o "${precompiled}.pch" COMMAND_ERROR_IS_FATAL ANY)
endif()

function(header_library target folder)
  add_library(${target} INTERFACE IMPORTED GLOBAL)
  target_include_directories(${target} SYSTEM INTERFACE "${folder}")
endfunction()

# compiled_library(TARGET NAME INCLUDES SOURCES...): file names of includes and sources begin in the library's folder.
function(compiled_library target name includes)
  file(GLOB folder "${GEOMESH_LIBRARY_SOURCES}/${name}-[0-9]*")
  list(FILTER folder EXCLUDE REGEX "\\.(dsc|xz|gz|bz2|asc)$")
  list(LENGTH folder n)
  if(NOT n EQUAL 1)
    message(FATAL_ERROR "the sources of ${name} are not in \"${GEOMESH_LIBRARY_SOURCES}\": scripts/browser fetches them")
  endif()
  set(sources "")
  foreach(pattern ${ARGN})
    file(GLOB found "${folder}/${pattern}")
    if(NOT found)
      message(FATAL_ERROR "${name} has no ${pattern}")
    endif()
    list(APPEND sources ${found})
  endforeach()
  string(REPLACE "::" "_" plain "library_${target}")
  add_library(${plain} STATIC ${sources})
  target_compile_options(${plain} PRIVATE -w)
  foreach(include ${includes})
    target_include_directories(${plain} SYSTEM PUBLIC "${folder}/${include}")
  endforeach()
  add_library(${target} ALIAS ${plain})
endfunction()

function(define_libraries)
  header_library(CGAL::CGAL "${headers}")
  # WebAssembly only rounds to nearest: intervals are widened instead, by CGAL's own means.
  target_compile_definitions(CGAL::CGAL INTERFACE CGAL_ALWAYS_ROUND_TO_NEAREST CGAL_DISABLE_GMP CGAL_NDEBUG)
  header_library(nlohmann_json::nlohmann_json "${headers}")
  header_library(CLI11::CLI11 "${headers}")
  header_library(Eigen3::Eigen /usr/include/eigen3)
  header_library(TBB::tbb "${here}/include")

  compiled_library(yaml-cpp yaml-cpp include "src/*.cpp")
  compiled_library(pugixml::pugixml pugixml src src/pugixml.cpp)
  compiled_library(LZ4::lz4 lz4 lib lib/lz4.c)
  set(zlib adler32 compress crc32 deflate inffast inflate inftrees trees uncompr zutil)
  list(TRANSFORM zlib APPEND .c)
  compiled_library(ZLIB::ZLIB zlib . ${zlib})

  file(WRITE "${CMAKE_BINARY_DIR}/geographiclib/GeographicLib/Config.h"
       "#define GEOGRAPHICLIB_VERSION_STRING \"2\"\n#define GEOGRAPHICLIB_DATA \"\"\n#define GEOGRAPHICLIB_HAVE_LONG_DOUBLE 1\n"
       "#define GEOGRAPHICLIB_WORDS_BIGENDIAN 0\n#define GEOGRAPHICLIB_PRECISION 2\n#define GEOGRAPHICLIB_SHARED_LIB 0\n")
  set(projections Math Utility UTMUPS MGRS TransverseMercator PolarStereographic)
  list(TRANSFORM projections REPLACE "(.+)" "src/\\1.cpp")
  compiled_library(GeographicLib::GeographicLib geographiclib include ${projections})
  target_include_directories(library_GeographicLib_GeographicLib SYSTEM PUBLIC "${CMAKE_BINARY_DIR}/geographiclib")

  # The decoders alone: files compressed so are read, never written.
  set(lzma common/block_buffer_decoder common/block_decoder common/block_header_decoder common/block_util common/common common/filter_common
      common/filter_decoder common/filter_flags_decoder common/index_hash common/stream_buffer_decoder common/stream_decoder
      common/stream_flags_common common/stream_flags_decoder common/vli_decoder common/vli_size check/check check/crc32_fast check/crc32_table
      check/crc64_fast check/crc64_table check/sha256 lz/lz_decoder lzma/lzma_decoder lzma/lzma2_decoder simple/simple_coder
      simple/simple_decoder simple/x86 delta/delta_common delta/delta_decoder)
  list(TRANSFORM lzma REPLACE "(.+)" "src/liblzma/\\1.c")
  compiled_library(LibLZMA::LibLZMA xz-utils src/liblzma/api ${lzma})
  set(folders common check lz lzma simple delta rangecoder)
  get_target_property(api library_LibLZMA_LibLZMA INCLUDE_DIRECTORIES)
  list(TRANSFORM folders REPLACE "(.+)" "${api}/../\\1" OUTPUT_VARIABLE folders)
  target_include_directories(library_LibLZMA_LibLZMA PRIVATE ${folders} "${api}/../../common")
  target_compile_definitions(library_LibLZMA_LibLZMA PRIVATE HAVE_DECODERS HAVE_DECODER_LZMA2 HAVE_DECODER_X86 HAVE_DECODER_DELTA HAVE_CHECK_CRC32 HAVE_CHECK_CRC64
    HAVE_CHECK_SHA256 HAVE_STDBOOL_H HAVE_STDINT_H HAVE_INTTYPES_H HAVE_LIMITS_H HAVE_STRING_H ASSUME_RAM=128 SIZEOF_SIZE_T=4 TUKLIB_SYMBOL_PREFIX=lzma_)
endfunction()

macro(geomesh_provide_package method name)
  if("${name}" MATCHES "^(CGAL|nlohmann_json|CLI11|Eigen3|TBB|yaml-cpp|pugixml|ZLIB|GeographicLib|LibLZMA)$")
    if(NOT TARGET CGAL::CGAL)
      define_libraries()
    endif()
    set(${name}_FOUND TRUE)
  endif()
endmacro()
# Whatever is left out is not looked for: what this system has of it cannot be linked.
foreach(name GDAL MPI PROJ PkgConfig VTK)
  set(CMAKE_DISABLE_FIND_PACKAGE_${name} ON)
endforeach()
cmake_language(SET_DEPENDENCY_PROVIDER geomesh_provide_package SUPPORTED_METHODS FIND_PACKAGE)
set(GEOMESH_LZ4_LIBRARY LZ4::lz4 CACHE STRING "")
set(GEOMESH_LZ4_INCLUDE "${here}/include" CACHE PATH "")
