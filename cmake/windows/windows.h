// SPDX-License-Identifier: MIT
// Stands before MinGW-w64's header of this name, which oneTBB's headers include: without its macros for words that
// sources use as names.
#ifndef GEOMESH_WINDOWS_H
#define GEOMESH_WINDOWS_H

#ifndef NOMINMAX
#define NOMINMAX
#endif
#ifndef WIN32_LEAN_AND_MEAN
#define WIN32_LEAN_AND_MEAN
#endif
#ifndef NOGDI
#define NOGDI  // functions such as Polyline
#endif
#include_next <windows.h>

#undef near
#undef far
#undef small
#undef interface
// Headers of the system that are included later declare by these, which are defined by the words above.
#undef NEAR
#undef FAR
#define NEAR
#define FAR

#endif
