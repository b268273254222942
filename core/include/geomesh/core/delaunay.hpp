// SPDX-License-Identifier: MIT
/// @file
/// Unconstrained Delaunay tetrahedralization of a point set (Cavalcanti and Mello 1999, section 2).
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
  /// Points nearer than this to an inserted vertex wait until the end (section 2.2). 0: none wait; negative: chosen
  /// from the data (2^-44 of the extent where points are that near). The cavity algorithm looks at all vertices that
  /// the new point would be joined to, the nearest among them. The flip algorithm looks at those of the cell that holds
  /// it.
  double cluster_distance = -1;
};

struct DelaunayStatistics {
  std::size_t points_deferred = 0;
  std::size_t stuck_faces = 0;  ///< flip algorithm: faces left non-flippable (zero in insertion, asserted)
  std::size_t exact_calls = 0;  ///< predicate calls that the floating-point filters did not decide
  std::size_t walk_steps = 0;
};

/// The whole convex hull, ghost cells included.
struct DelaunayTetrahedralization {
  TetMesh mesh;  ///< vertex ids are rows of the points given
  std::vector<VertexIndex>
      representative;  ///< per point: itself, or the first point with equal coordinates (which alone is in the mesh)
  DelaunayStatistics statistics;
};

/// Throws Error{invalid_input} on coordinates that are not finite or out of the exact range. Throws Error{cannot_mesh}
/// where all points lie in one plane or on one line; the message says which. The result is unique (perturbation by
/// coordinates), whatever the order of the points, the algorithm, the cluster distance and the threads. Near-linear on
/// inputs whose triangulation is.
DelaunayTetrahedralization delaunay_tetrahedralization(std::span<const Vec3> points,
                                                       const DelaunayOptions& options = {},
                                                       const RunContext& context = {});

/// Makes a tetrahedralization of the points' convex hull (ghosts included, valid but not Delaunay) Delaunay by flips.
/// From such starts flips can get stuck (Joe 1989), which insertion never does; where they do, the mesh is built anew
/// by insertion. Returns the number of faces that were stuck. Every point that no cell uses is left out.
std::size_t make_delaunay(TetMesh& mesh, std::span<const Vec3> points);

}  // namespace geomesh
