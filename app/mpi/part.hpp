// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Prepares the part of one rank: from the sparse mesh to a part that can be refined on its own.
#pragma once

#include <cstdint>
#include <vector>

#include "corners.hpp"
#include "geomesh/core/refine_part.hpp"
#include "sparse_model.hpp"

namespace geomesh::app {

/// Points on surfaces and curves, and named points. They have the same positions in the sparse and the fine mesh.
class ModelPoints {
 public:
  static constexpr std::uint32_t none = UINT32_MAX;

  explicit ModelPoints(const geomodel::ModelMesh& mesh);
  std::size_t size() const { return rows_.size(); }
  /// Returns the rows of the model's points in the sparse mesh, ascending.
  const std::vector<VertexIndex>& rows() const { return rows_; }
  /// Returns the number of the model's point with exactly these coordinates, or `none`.
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
  std::vector<std::array<std::uint32_t, 2>> edges;  ///< edges of curves, sorted and distinct

  ModelSimplices(const geomodel::ModelMesh& mesh, const ModelPoints& points);
  /// Returns the row of the face with these corners, or no_index if there is none.
  Index face_of(const Corners& corners) const;
};

/// The model as a mesh with few tetrahedra, with tables that find its points and faces by their coordinates or corners.
struct RankModel {
  explicit RankModel(SparseModel given);
  /// The model as a mesh with few tetrahedra. The edges of its surfaces have been halved SparseModel::halvings times.
  SparseModel sparse;
  ModelPoints points;
  ModelSimplices simplices;
  std::vector<std::int32_t> region_of_component;
};

/// The tetrahedra of one rank's part of the fine mesh; points have no global numbers yet.
struct RankMesh {
  std::vector<Vec3> points;
  std::vector<Tetrahedron> tetrahedra;
  std::vector<Index> component;
  /// For each point: 0 if all tetrahedra around it are on this rank; empty: unknown.
  std::vector<std::uint8_t> may_be_outside;
  std::vector<std::uint8_t> is_settled;  ///< TetrahedraPart
};

/// Returns the tetrahedra of the sparse mesh that belong to a rank. Edges on the border to other ranks that are longer
/// than the target size are halved, the longest first; ties are decided by position. The halved edges, and so the
/// points, follow from each triangle alone, so that both ranks make the same triangles without communication. O(n log
/// n) in the triangles. Throws Error{cannot_mesh} if a tetrahedron at the border becomes too flat.
RankMesh part_of_rank(const RankModel& model, const std::vector<std::int32_t>& rank_of, std::int32_t rank);

/// Adds to a part of the mesh the points, edges and faces of the model that lie in it.
TetrahedraPart with_model(RankMesh mesh, const RankModel& model);
RankMesh without_model(TetrahedraPart part);

}  // namespace geomesh::app
