// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The outside test data (GEOMESH_SHARED_DATA) that are valid piecewise linear complexes as they are, for tests and
/// benchmarks.
#pragma once

#include <string>
#include <vector>

#include "corpus_models.hpp"

namespace geomesh::test {

struct SharedModel {
  std::string name;  ///< folder/file
  std::function<PiecewiseLinearComplex()> make;
};

/// solids, classic, grains (the hundred in a box), modelA4; in this order. Empty where `folder` does not exist.
std::vector<SharedModel> shared_models(const std::string& folder);

/// One object of a GOCAD ASCII file: VRTX, PVRTX, ATOM, TRGL lines alone. Coordinates as written.
struct GocadTriangles {
  std::vector<Vec3> points;
  std::vector<Triangle> triangles;
};
GocadTriangles read_gocad_triangles(const std::string& path);

}  // namespace geomesh::test
