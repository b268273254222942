// SPDX-License-Identifier: MIT
/// @file
/// A forecast of how many subsegments the Delaunay triangulation of a stretched frame would miss, at a small part of
/// its cost. An edge is in a Delaunay triangulation where some sphere through its ends has no vertex inside; for the
/// centre of that sphere each vertex is a linear constraint (the lifting of Edelsbrunner and Seidel 1986, restricted to
/// the plane between the ends). Of a sample of subsegments, those vertices are asked that the triangulation at hand has
/// about them. In floating point: it decides what is tried, never what is taken.
#pragma once

#include <array>
#include <vector>

#include "recover/model/constrained_mesh.hpp"
#include "recover/model/constraints.hpp"

namespace geomesh::recover {

class ScaleForecast {
 public:
  /// A sample of some hundred subsegments with their neighbourhoods. `seen_in`: of each subsegment a cell that has it,
  /// no_cell where it is missing.
  ScaleForecast(ConstrainedMesh& mesh, const Constraints& constraints, const std::vector<CellIndex>& seen_in);

  /// Subsegments that are missing where axis i is scaled by 2^exponents[i], after the neighbourhoods in the sample.
  double n_missing(const std::array<int, 3>& exponents) const;

 private:
  struct Sample {
    Vec3 a, b;
    std::vector<Vec3> about;  ///< vertices that may lie in a sphere through a and b
    double weight;            ///< subsegments for which it stands
  };

  static bool is_delaunay(const Sample& sample, const Vec3& scale);

  std::vector<Sample> samples_;
};

}  // namespace geomesh::recover
