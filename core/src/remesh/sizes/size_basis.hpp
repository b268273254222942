// SPDX-License-Identifier: MIT
/// @file
/// Edges and bends of the surfaces, from which sizes follow. They are the same however large the sizes are.
#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "geomesh/core/refine.hpp"
#include "remesh/domain/domain_mesh.hpp"
#include "remesh/sizes/flat_extent.hpp"

namespace geomesh::remesh {

/// The constrained edges at a vertex on a surface or curve.
struct EdgesAtVertex {
  double inverse = 0, sum = 0, count = 0;  // of their lengths
  double shortest = std::numeric_limits<double>::infinity(), longest = 0;
  void add(double length, double times) {
    inverse += times / length, sum += times * length, count += times;
    shortest = std::min(shortest, length), longest = std::max(longest, length);
  }
  /// In an even triangulation the mean. Near a few short edges among long ones a few times the short ones, which is
  /// what elements of good shape need there.
  double harmonic() const { return count / inverse; }
  double mean() const { return sum / count; }
};

/// Two faces of a patch that turn at the edge between them. Where the surface turns by an angle over the distance
/// between the faces' centroids, the radius is that distance over the angle.
struct Bend {
  std::array<VertexIndex, 2> edge;
  std::array<Vec3, 2> centroids;
  double radius;
  Index patch;
};

struct SizeBasis {
  std::vector<Index> patch;             ///< by facet: named_patches
  std::vector<EdgesAtVertex> edges;     ///< by vertex
  std::vector<Bend> bends;              ///< none where neither a tolerance nor a curvature asks for them
  std::vector<FlatExtent::Face> faces;  ///< of all surfaces, where bends are listed
};

/// `options` count with all but their sizes, their tolerance and what gaps ask for. O(n log n).
SizeBasis size_basis(const PiecewiseLinearComplex& plc, const DomainMesh& mesh, const RefineOptions& options);

}  // namespace geomesh::remesh
