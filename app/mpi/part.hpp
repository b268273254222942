// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The part of one rank, from the sparse mesh to a part that can be refined on its own.
#pragma once

#include <cstdint>
#include <vector>

#include "corners.hpp"
#include "geomesh/core/refine_part.hpp"
#include "sparse_model.hpp"

namespace geomesh::app {

/// Points on surfaces and curves, and named ones: they have the same place in the sparse mesh and in the fine one.
class ModelPoints {
 public:
  static constexpr std::uint32_t none = UINT32_MAX;

  explicit ModelPoints(const geomodel::ModelMesh& mesh);
  std::size_t size() const { return rows_.size(); }
  /// Rows of the sparse mesh, ascending.
  const std::vector<VertexIndex>& rows() const { return rows_; }
  /// The number of the point at a place; none where there is none.
  std::uint32_t number_at(const Vec3& place) const {
    const auto found = number_.find(place);
    return found == number_.end() ? none : found->second;
  }

 private:
  std::vector<VertexIndex> rows_;
  ByPlace<std::uint32_t> number_;
};

/// Faces and edges of the model, by the numbers of their points.
struct ModelSimplices {
  struct Face {
    Corners corners;
    Index row;  ///< in ModelMesh::faces
    bool operator<(const Face& other) const { return corners < other.corners; }
  };
  std::vector<Face> faces;                          ///< in order
  std::vector<std::array<std::uint32_t, 2>> edges;  ///< of curves, in order, each once

  ModelSimplices(const geomodel::ModelMesh& mesh, const ModelPoints& points);
  /// no_index where there is none.
  Index face_of(const Corners& corners) const;
};

/// The sparse model with what is looked up in it.
struct RankModel {
  explicit RankModel(SparseModel given);
  SparseModel sparse;  ///< its surfaces halved as often as SparseModel::halvings says, its tetrahedra as they were
  ModelPoints points;
  ModelSimplices simplices;
  std::vector<std::int32_t> region_of_component;
};

/// The tetrahedra of a part of the fine mesh; points have no number yet.
struct RankMesh {
  std::vector<Vec3> points;
  std::vector<Tetrahedron> tetrahedra;
  std::vector<Index> component;
  std::vector<std::uint8_t> may_be_outside;  ///< by point: 0 where all tetrahedra about it are here; empty: not known
  std::vector<std::uint8_t> is_settled;      ///< TetrahedraPart
};

/// Tetrahedra of the sparse mesh that a rank has. Edges between it and others that are longer than asked are halved,
/// the longest first; ties by places. Which edges are halved, and so where points are, follows from each triangle
/// alone. So the ranks on both sides make the same triangles without a word. O(n log n) in the triangles.
///
/// Throws Error{cannot_mesh} where a tetrahedron at the border does not bear that.
RankMesh part_of_rank(const RankModel& model, const std::vector<std::int32_t>& rank_of, std::int32_t rank);

/// With what of the model stays in it.
TetrahedraPart with_model(RankMesh mesh, const RankModel& model);
RankMesh without_model(TetrahedraPart part);

}  // namespace geomesh::app
