// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The edges of a background mesh that isosurfaces cross, with the places where they do.
#pragma once

#include <cstddef>
#include <vector>

#include "level_sets/mesh/background_mesh.hpp"
#include "level_sets/mesh/edge_roots.hpp"

namespace geomesh::geomodel {

/// Corners of a background mesh whose vertices may have been moved onto isosurfaces, and values there. These are the
/// field's own less `shift`, a function that is linear in cells.
struct MovedVertices {
  MovedVertices(const BackgroundMesh& mesh, std::vector<double> shift);

  std::vector<Vec3> points;
  std::vector<double> values, shift;
  std::vector<char> is_moved;
};

class CrossedEdges {
 public:
  struct Edge {
    VertexIndex below, above;  ///< the field at `below` is less than at `above`
  };
  /// Roots of `known` are taken over for edges with no end that was moved; null: none are known. `field` null: the
  /// field is linear between the vertices.
  CrossedEdges(const BackgroundMesh& mesh, const MovedVertices& vertices, const ScalarField* field,
               const std::vector<double>& values, const CrossedEdges* known);

  const std::vector<Edge>& edges() const { return edges_; }
  /// Of the edge between the vertices; precondition: a value is crossed there.
  std::size_t row(VertexIndex a, VertexIndex b) const;
  /// True where the value lies above the lower end and at or below the upper one.
  static bool crosses(const Edge& edge, double value, const MovedVertices& vertices) {
    return vertices.values[edge.below] < value && value <= vertices.values[edge.above];
  }
  const Vec3& root(std::size_t value, std::size_t edge) const { return roots_[value][edge]; }

 private:
  void collect(const BackgroundMesh& mesh, const MovedVertices& vertices, const std::vector<double>& values);
  void solve(std::size_t row_of_value, const MovedVertices& vertices, const ScalarField* field,
             const std::vector<double>& values, const CrossedEdges* known);
  bool is_known(const Edge& edge, const MovedVertices& vertices) const;
  /// In which the root of the value lies, above that of the value before.
  Bracket bracket(std::size_t row_of_value, std::size_t edge, const MovedVertices& vertices,
                  const std::vector<double>& values) const;

  std::vector<Edge> edges_;               ///< by their ends
  std::vector<std::vector<Vec3>> roots_;  ///< per value and edge; meaningless where it is not crossed
};

}  // namespace geomesh::geomodel
