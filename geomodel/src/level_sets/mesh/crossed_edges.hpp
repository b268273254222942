// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The edges of a background mesh that isosurfaces cross, with the points where they do.
#pragma once

#include <cstddef>
#include <vector>

#include "level_sets/mesh/background_mesh.hpp"
#include "level_sets/mesh/edge_roots.hpp"

namespace geomesh::geomodel {

/// The vertices of a background mesh after some of them were moved onto isosurfaces, with their values. Values are
/// those of the field minus `shift`, a function that is linear in each cell.
struct MovedVertices {
  MovedVertices(const BackgroundMesh& mesh, std::vector<double> shift);

  std::vector<Vec3> points;
  std::vector<double> values, shift;
  std::vector<char> is_moved;
};

class CrossedEdges {
 public:
  struct Edge {
    VertexIndex below, above;  ///< ends of the edge; the field is less at `below` than at `above`
  };
  /// Finds all edges that an isosurface crosses, and the crossings (roots). Roots of `known` are reused for edges whose
  /// ends were not moved; `known` may be null. If `field` is null, the field is linear between the vertices.
  CrossedEdges(const BackgroundMesh& mesh, const MovedVertices& vertices, const ScalarField* field,
               const std::vector<double>& values, const CrossedEdges* known);

  const std::vector<Edge>& edges() const { return edges_; }
  /// Returns the row of the edge between two vertices. Precondition: an isosurface crosses the edge.
  std::size_t row(VertexIndex a, VertexIndex b) const;
  /// Returns whether an isosurface crosses an edge: its value is above the value at the lower end, and not above that
  /// at the upper end.
  static bool crosses(const Edge& edge, double value, const MovedVertices& vertices) {
    return vertices.values[edge.below] < value && value <= vertices.values[edge.above];
  }
  const Vec3& root(std::size_t value, std::size_t edge) const { return roots_[value][edge]; }

 private:
  void collect(const BackgroundMesh& mesh, const MovedVertices& vertices, const std::vector<double>& values);
  void solve(std::size_t row_of_value, const MovedVertices& vertices, const ScalarField* field,
             const std::vector<double>& values, const CrossedEdges* known);
  bool is_known(const Edge& edge, const MovedVertices& vertices) const;
  /// Returns the part of a mesh edge in which an isosurface crosses it. This part begins where the isosurface of the
  /// next lower value crosses the edge.
  Bracket bracket(std::size_t row_of_value, std::size_t edge, const MovedVertices& vertices,
                  const std::vector<double>& values) const;

  std::vector<Edge> edges_;               ///< by their ends
  std::vector<std::vector<Vec3>> roots_;  ///< point where each isosurface crosses each mesh edge; undefined if nowhere
};

}  // namespace geomesh::geomodel
