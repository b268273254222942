# SPDX-License-Identifier: MIT
# Stands for oneTBB: its calls on one thread, from headers that the toolchain brings (cmake/browser-emscripten.cmake).
if(NOT TARGET TBB::tbb)
  add_library(TBB::tbb INTERFACE IMPORTED)
endif()
