// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What the mesh lacks of a surface that horizons may cut: gathered triangle by triangle, judged piece by piece.
#pragma once

#include <functional>
#include <vector>

#include "check/claim/taken_by_rules.hpp"
#include "check/exact/plane_triangle.hpp"
#include "check/judged/claimed_faces.hpp"
#include "check/pieces/taken_pieces.hpp"

namespace geomesh::geomodel::checking {

class PiecesWithoutFaces {
 public:
  /// `may_end_at`: whether an edge runs along what may cut the surface beside horizons, or along its own border.
  PiecesWithoutFaces(const ClaimedFaces& claimed, Index surface, const TakenByRules& rules, double tolerance,
                     const std::function<bool(VertexIndex, VertexIndex)>& may_end_at);

  /// A triangle of the surface that `faces`, those on its plane, do not cover.
  void add(const PlaneTriangle& triangle, Index row, const std::vector<Index>& faces);
  std::size_t size() const { return uncovered_.size(); }
  /// Those of the triangles added that are in no piece that may be away.
  std::vector<UncoveredTriangle> not_taken() const;

 private:
  bool runs_on(const PlaneTriangle& triangle, const Vec3& a, const Vec3& b) const;

  const ClaimedFaces& claimed_;
  Index surface_;
  const TakenByRules& rules_;
  double tolerance_;
  std::vector<Triangle> open_edges_;  ///< at which the surface's faces end, with the second end twice
  std::vector<bool> at_cutter_;       ///< by open edge: whether it runs along what cuts the surface, or its border
  BoxTree tree_;                      ///< over open_edges_
  std::vector<UncoveredTriangle> uncovered_;
};

}  // namespace geomesh::geomodel::checking
