// SPDX-License-Identifier: MIT
/// @file
/// Faces of good shape within patches, by exchanging edges and moving points, cells allowing.
#pragma once

#include <cstdint>
#include <vector>

#include "geomesh/core/run_context.hpp"
#include "remesh/operations/improve.hpp"

namespace geomesh::remesh {

/// Rounds of surface flips towards Delaunay and of moves to the centroid of the faces. What was in vain is tried again
/// only where something about it has changed, also from one run to the next.
class SurfaceRegularizer {
 public:
  explicit SurfaceRegularizer(Toolbox& tools) : tools_(tools), mesh_(tools.mesh) {}

  /// Moves on all cores, with the same result whatever their number. O(vertices of the mesh), and the stars of those on
  /// surfaces that have changed.
  void run(const RunContext& context);

 private:
  /// An edge from a vertex to a greater one, and the apexes of its faces.
  struct SurfaceEdge {
    VertexIndex to;
    CellIndex cell;
    VertexIndex apex, other_apex;
    unsigned n_faces;
  };
  std::size_t flip_about(VertexIndex v);
  std::size_t move_all(unsigned threads);
  void collect_edges(VertexIndex v);
  void add_edge(VertexIndex to, VertexIndex apex, CellIndex cell);
  bool is_asked(VertexIndex v, const SurfaceEdge& e) const;

  Toolbox& tools_;
  DomainMesh& mesh_;
  std::vector<std::uint64_t> flips_in_vain_, moves_in_vain_;  // by vertex: the mesh's time of the last that were
  std::vector<CellIndex> star_;
  std::vector<SurfaceEdge> edges_;
};

}  // namespace geomesh::remesh
