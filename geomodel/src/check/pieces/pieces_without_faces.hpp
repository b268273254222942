// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Finds the parts of a surface that are missing in the mesh and that crossing horizons may have cut off. Uncovered
/// triangles are collected one by one; each connected piece of them is decided as a whole.
#pragma once

#include <functional>
#include <vector>

#include "check/exact/plane_triangle.hpp"
#include "check/mesh/checked_faces.hpp"
#include "check/pieces/taken_pieces.hpp"
#include "check/specification/taken_by_rules.hpp"

namespace geomesh::geomodel::checking {

class PiecesWithoutFaces {
 public:
  /// `may_end_at` returns whether the surface may end at a mesh edge for another reason than a horizon that cuts it:
  /// along its own border, a box side or a body.
  PiecesWithoutFaces(const CheckedFaces& checked, Index surface, const TakenByRules& rules, double tolerance,
                     const std::function<bool(VertexIndex, VertexIndex)>& may_end_at);

  /// Adds an input triangle of the surface that `faces`, the mesh faces in its plane, do not cover.
  void add(const PlaneTriangle& triangle, Index row, const std::vector<Index>& faces);
  std::size_t size() const { return uncovered_.size(); }
  /// Returns the triangles that mesh faces must cover but do not: those in no piece that a horizon may have cut off.
  std::vector<UncoveredTriangle> not_taken() const;

 private:
  bool runs_on(const PlaneTriangle& triangle, const Vec3& a, const Vec3& b) const;

  const CheckedFaces& checked_;
  Index surface_;
  const TakenByRules& rules_;
  double tolerance_;
  /// Mesh edges at which the faces of the surface end, stored as triangles with the second end repeated.
  std::vector<Triangle> open_edges_;
  /// For each open edge: whether it runs along a surface that cuts this one, or along this surface's own border.
  std::vector<bool> at_cutter_;
  BoxTree tree_;  ///< over open_edges_
  std::vector<UncoveredTriangle> uncovered_;
};

}  // namespace geomesh::geomodel::checking
