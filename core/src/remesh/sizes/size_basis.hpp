// SPDX-License-Identifier: MIT
/// @file
/// Input edges of a mesh and bends of its surfaces, from which target sizes are derived. They do not depend on the
/// sizes that the options request.
#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "geomesh/core/refine.hpp"
#include "remesh/domain/domain_mesh.hpp"
#include "remesh/sizes/flat_extent.hpp"

namespace geomesh::remesh {

/// Lengths of the constrained edges at a vertex on a surface or curve.
struct EdgesAtVertex {
  double inverse = 0, sum = 0, count = 0;  // of their lengths
  double shortest = std::numeric_limits<double>::infinity(), longest = 0;
  void add(double length, double times) {
    inverse += times / length, sum += times * length, count += times;
    shortest = std::min(shortest, length), longest = std::max(longest, length);
  }
  /// Returns the harmonic mean of the lengths. In a uniform triangulation it equals the mean. If there are a few short
  /// edges among long ones, it is a few times the short length, as elements of good shape require there.
  double harmonic() const { return count / inverse; }
  double mean() const { return sum / count; }
};

/// Two faces of a patch that form an angle at their common edge. The radius of curvature is the distance between the
/// centroids of the faces, divided by that angle.
struct Bend {
  std::array<VertexIndex, 2> edge;
  std::array<Vec3, 2> centroids;
  double radius;
  Index patch;
};

struct SizeBasis {
  std::vector<Index> patch;             ///< by facet: named_patches
  std::vector<EdgesAtVertex> edges;     ///< by vertex
  std::vector<Bend> bends;              ///< edges at which surfaces bend; empty if sizes need no curvature
  std::vector<FlatExtent::Face> faces;  ///< faces of all surfaces; empty if sizes need no curvature
};

/// Collects the input edges and the bends of a mesh. The sizes, the tolerance and the options on gaps in `options` have
/// no influence. O(n log n).
SizeBasis size_basis(const PiecewiseLinearComplex& plc, const DomainMesh& mesh, const RefineOptions& options);

}  // namespace geomesh::remesh
