// SPDX-License-Identifier: MIT
/// @file
/// Delaunay tetrahedralization of a point set without constraints (Cavalcanti and Mello 1999, section 2).
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "geomesh/core/geometry.hpp"
#include "geomesh/core/run_context.hpp"
#include "geomesh/core/simplex_mesh.hpp"

namespace geomesh {

enum class DelaunayAlgorithm { cavity, flip };

struct DelaunayOptions {
  DelaunayAlgorithm algorithm = DelaunayAlgorithm::cavity;
  /// Points closer than this to an inserted vertex are deferred to the end (Cavalcanti and Mello 1999, section 2.2). 0:
  /// none are deferred; negative: derived from the data (2^-44 of the extent if points are that close). The cavity
  /// algorithm examines all vertices to which the new point would be connected, including the nearest one; the flip
  /// algorithm examines those of the cell that contains it.
  double cluster_distance = -1;
};

struct DelaunayStatistics {
  std::size_t points_deferred = 0;
  /// Number of faces that the flip algorithm could not flip. It is zero during insertion, which is asserted.
  std::size_t stuck_faces = 0;
  std::size_t exact_calls = 0;  ///< number of predicate calls that the floating-point filters did not decide
  std::size_t walk_steps = 0;
};

/// The tetrahedralization of the whole convex hull, including ghost cells.
struct DelaunayTetrahedralization {
  TetMesh mesh;  ///< a vertex id is the index of its point in the input
  /// For each point its own index, or that of the first point with equal coordinates (only that one is in the mesh).
  std::vector<VertexIndex> representative;
  DelaunayStatistics statistics;
};

/// Computes the Delaunay tetrahedralization of the points. Throws Error{invalid_input} on coordinates that are not
/// finite or out of the exact range. Throws Error{cannot_mesh} if all points lie in one plane or on one line; the
/// message says which. The result is unique (perturbation by coordinates), whatever the order of the points, the
/// algorithm, the cluster distance and the threads. Nearly linear time for inputs with a triangulation of linear size.
DelaunayTetrahedralization delaunay_tetrahedralization(std::span<const Vec3> points,
                                                       const DelaunayOptions& options = {},
                                                       const RunContext& context = {});

/// Turns a valid tetrahedralization of the convex hull of the points, with ghost cells, into the Delaunay
/// tetrahedralization by flips. Flips can get stuck on a mesh that insertion has not made (Joe 1989); the mesh is then
/// rebuilt by insertion. Returns the number of faces that were stuck. Unused points are left out.
std::size_t make_delaunay(TetMesh& mesh, std::span<const Vec3> points);

}  // namespace geomesh
