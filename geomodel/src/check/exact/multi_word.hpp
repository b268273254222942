// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The numbers of the checker's exact arithmetic: floating-point numbers of as many words as they need, exact under +,
/// - and *. CGAL::Mpzf needs GMP with words of 64 bits; CGAL::MP_Float, several times slower, needs nothing.
#pragma once

#include <CGAL/config.h>

#ifdef CGAL_USE_GMP
#include <CGAL/Mpzf.h>
#endif
#ifndef CGAL_HAS_MPZF
#include <CGAL/MP_Float.h>
#endif

namespace geomesh::geomodel::checking {

#ifdef CGAL_HAS_MPZF
using MultiWord = CGAL::Mpzf;
#else
using MultiWord = CGAL::MP_Float;
#endif

}  // namespace geomesh::geomodel::checking
