// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The faces of the mesh that stand for surfaces, and what the rules take away of these: what the checks against the
/// input share.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "check/exact/box_tree.hpp"
#include "check/judged/judged_mesh.hpp"

namespace geomesh::geomodel::checking {

inline constexpr const char* box_side_names[] = {"xmin", "xmax", "ymin", "ymax", "zmin", "zmax"};

BoxTree tree_over(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles);

/// A body: with `cuts_all` it removes horizons and faults inside it; what of it lies inside itself on both sides is
/// removed too.
struct Body {
  const TriangulatedSurface* surface;
  BoxTree tree;
};
/// Whether a triangle of the body is no farther from p than that. O(log n) and the triangles whose boxes are.
bool is_near(const Body& body, const Vec3& p, double reach);

class ClaimedFaces {
 public:
  /// `set_faces`: rows of the face set in mesh vertices; every face of the mesh is a candidate where there is no set.
  ClaimedFaces(const JudgedMesh& mesh, const Claim& claim, const FacesFile* faces,
               const std::vector<Triangle>& set_faces);

  const JudgedMesh& mesh() const { return mesh_; }
  const Claim& claim() const { return claim_; }
  const FacesFile* faces() const { return faces_; }
  const std::vector<Triangle>& candidates() const { return candidates_; }
  const std::vector<Body>& bodies() const { return bodies_; }
  const Vec3& corner(const Triangle& t, int i) const { return mesh_.point(t[i]); }

  /// Whether the face may stand for the surface: always where faces bear no names.
  bool carries(Index face, Index surface) const;
  /// Ids of the surfaces that coincide in the face.
  const std::vector<std::int32_t>& set_of(Index face) const;
  /// Row of the claim's surface with this id; no_index for box sides and unknown ids.
  Index surface_of(std::int32_t id) const;
  bool is_box_side(std::int32_t id) const;
  /// A face of a box side and of no surface of the claim.
  bool is_side_alone(Index face) const;
  bool is_cut_kind(Index surface) const;
  /// Whether the face has the model on one side alone, and a topography or a bottom ends this: along a fault it may
  /// have a scarp there, which no body takes away.
  bool may_be_scarp(Index face) const;
  /// Whether the rules take p, a point of the surface, away: parts of horizons and faults inside a body that cuts, and
  /// parts of a body that crosses itself with its inside on either side. They are judged `off` to both sides along the
  /// normal. Where p is on a body's surface the answer is yes: the open edges speak there. The body in row `but` is
  /// passed over.
  bool is_removed(Index surface, const Vec3& p, const Vec3& off, Index but = no_index) const;
  /// Faces of box sides lie on them exactly: fault `faces_off_box_side`.
  void check_box_sides(CheckResult& result) const;

 protected:
  const JudgedMesh& mesh_;
  const Claim& claim_;
  const FacesFile* faces_;
  std::vector<Triangle> candidates_;
  std::vector<Body> bodies_;

 private:
  std::map<std::int32_t, Index> surface_of_id_;
  std::map<Index, std::int32_t> id_of_surface_;
};

}  // namespace geomesh::geomodel::checking
