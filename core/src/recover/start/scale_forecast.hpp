// SPDX-License-Identifier: MIT
/// @file
/// Forecasts how many subsegments the Delaunay triangulation of a stretched frame would miss, at a small part of its
/// cost. An edge is in a Delaunay triangulation if some sphere through its ends has no vertex inside; for the centre of
/// that sphere each vertex is a linear constraint (the lifting of Edelsbrunner and Seidel 1986, restricted to the plane
/// between the ends). For a sample of subsegments, the vertices that the current triangulation has around them are
/// tested. Floating point suffices, since this decides only what is tried, never what is accepted.
#pragma once

#include <array>
#include <vector>

#include "recover/model/constrained_mesh.hpp"
#include "recover/model/constraints.hpp"

namespace geomesh::recover {

class ScaleForecast {
 public:
  /// Uses a sample of some hundred subsegments with their neighbourhoods. `seen_in` contains for each subsegment a cell
  /// that has it, no_cell if it is missing.
  ScaleForecast(ConstrainedMesh& mesh, const Constraints& constraints, const std::vector<CellIndex>& seen_in);

  /// Returns the number of subsegments that are missing if axis i is scaled by 2^exponents[i], estimated from the
  /// neighbourhoods in the sample.
  double n_missing(const std::array<int, 3>& exponents) const;

 private:
  struct Sample {
    Vec3 a, b;
    std::vector<Vec3> about;  ///< vertices that are tested against spheres through the subsegment's ends a and b
    double weight;            ///< number of the model's subsegments for which this sampled one stands
  };

  static bool is_delaunay(const Sample& sample, const Vec3& scale);

  std::vector<Sample> samples_;
};

}  // namespace geomesh::recover
