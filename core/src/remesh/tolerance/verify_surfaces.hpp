// SPDX-License-Identifier: MIT
/// @file
/// Proves that remeshed surfaces are within the tolerance of the input, by verification of the whole result.
#pragma once

#include <cstddef>
#include <vector>

#include "remesh/domain/domain_mesh.hpp"
#include "remesh/tolerance/local_tolerance.hpp"
#include "search/triangle_surfaces.hpp"

namespace geomesh::remesh {

/// Returns the faces of a mesh, grouped by patch. The item of a face is its facet. Faces that are part of no facet are
/// left out. `normals` are those of the facets.
search::TriangleSurfaces faces_of(const DomainMesh& mesh, std::vector<Vec3> normals = {});
/// Returns the edges of a mesh's curves, grouped by curve class.
search::TriangleSurfaces curves_of(const DomainMesh& mesh);

/// A piece of the input or of the result that is not proven to be within the tolerance of the other model.
struct Breach {
  Vec3 place{};
  double distance = 0;     ///< distance of `place` from the other model; within the tolerance if only the proof failed
  Index group = no_index;  ///< patch of a face, or class of a curve edge
  Index facet = no_index;  ///< facet of the input at a face; none for a curve edge
  bool on_curve = false;
  bool of_input = false;  ///< whether this piece belongs to the input, not to the result
};

struct Deviations {
  /// Largest distances found between the surfaces of result and input. They are lower bounds of the true distances and
  /// nearly attain them. If `breaches` is empty, the true distances are within the tolerance.
  double result_to_input = 0, input_to_result = 0;
  /// Faces and curve edges not proven to be within the tolerance of the other model. If there are none, all are proven.
  std::vector<Breach> breaches;
};

/// Distances found by a verification. The next one of the same input reuses those around which nothing has changed.
struct VerifiedSurfaces {
  /// Distances by face or curve edge: of the result from the input, and of the input from the result.
  struct Covers {
    std::vector<search::Cover> result, input;
  };
  search::TriangleSurfaces result_faces, result_curves;
  Covers faces, curves;
};

/// The input with which a result is compared.
struct ReferenceModel {
  const search::ReferenceSurfaces &faces, &curves;
};

/// Compares the faces and curve edges of the mesh with the same patch or curve of the input, in both directions. A
/// piece of the result must keep the smallest tolerance at its corners; a piece of the input must keep an upper bound
/// of the tolerances anywhere on it. Almost linear if both have similar sizes. Runs in parallel; the result does not
/// depend on the number of threads. Pieces that were proven in the verification `before` are not examined again if
/// nothing has changed around them.
Deviations verify_surfaces(const DomainMesh& mesh, const ReferenceModel& input, const LocalTolerance& tolerance,
                           unsigned threads, VerifiedSurfaces* before = nullptr);

/// A box in which a smaller tolerance applies.
struct TightZone {
  Box3 box;
  double tolerance;
};

/// Returns places at which outer faces of the model meet others beyond common vertices and edges. Nothing is meshed
/// there, so no cell reveals that surfaces nearer to each other than the tolerance have come to intersect. If there are
/// none, the mesh fills space exactly once. Decided exactly. The boxes returned contain the edges and faces that meet,
/// with a tolerance of 0. O(n log n).
std::vector<TightZone> crossings_outside(const DomainMesh& mesh, unsigned threads = 1);

}  // namespace geomesh::remesh
