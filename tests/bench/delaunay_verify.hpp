// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Whether the tetrahedra of a benchmark are right: cavity against flips against CGAL, and the exact validators.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "geomesh/core/geometry.hpp"

namespace geomesh::bench {

struct Verification {
  std::size_t tetrahedra = 0;  ///< by the cavity algorithm
  std::size_t faults = 0;      ///< of the validators: neighbours, orientations, local Delaunay with perturbation
  bool flips_agree = false;    ///< the flip algorithm ends in the same set of tetrahedra, with no face stuck
  bool threads_agree = false;  ///< two threads give the same cells in the same slots
  bool cgal_agrees = false;    ///< CGAL has the same set; its perturbation orders points as ours does
};

Verification verify(std::span<const Vec3> points);

}  // namespace geomesh::bench
