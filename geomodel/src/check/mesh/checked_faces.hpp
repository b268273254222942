// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The mesh faces that represent surfaces, and the parts of surfaces that rules remove, for all checks against the
/// input.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "check/exact/box_tree.hpp"
#include "check/mesh/checked_mesh.hpp"

namespace geomesh::geomodel::checking {

inline constexpr const char* box_side_names[] = {"xmin", "xmax", "ymin", "ymax", "zmin", "zmax"};

BoxTree tree_over(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles);

/// A closed surface. If its `cuts_all` is set, the body removes horizons and faults inside it. Parts of the body that
/// have its inside on both sides are removed too.
struct Body {
  const TriangulatedSurface* surface;
  BoxTree tree;
};
/// Returns whether a triangle of the body is no farther than `reach` from p. O(log n) plus the number of triangles
/// whose boxes are that close.
bool is_near(const Body& body, const Vec3& p, double reach);

class CheckedFaces {
 public:
  /// `set_faces` are the triangles of the face set as mesh vertices. Without them, every mesh face may represent a
  /// surface.
  CheckedFaces(const CheckedMesh& mesh, const Specification& specification, const FacesFile* faces,
               const std::vector<Triangle>& set_faces);

  const CheckedMesh& mesh() const { return mesh_; }
  const Specification& specification() const { return specification_; }
  const FacesFile* faces() const { return faces_; }
  const std::vector<Triangle>& candidates() const { return candidates_; }
  const std::vector<Body>& bodies() const { return bodies_; }
  const Vec3& corner(const Triangle& t, int i) const { return mesh_.point(t[i]); }

  /// Returns whether the mesh face may represent the surface; always true if faces have no names.
  bool carries(Index face, Index surface) const;
  /// Returns the ids of the surfaces that coincide in the mesh face.
  const std::vector<std::int32_t>& set_of(Index face) const;
  /// Returns the index of the specified surface with this id; no_index for box sides and unknown ids.
  Index surface_of(std::int32_t id) const;
  bool is_box_side(std::int32_t id) const;
  /// Returns whether the mesh face is on a box side and on no surface of the specification.
  bool is_side_alone(Index face) const;
  bool is_cut_kind(Index surface) const;
  /// Returns whether the mesh face may be a scarp along a fault, where the model ends at a topography or base: it has
  /// the model on only one side, and no body removes it.
  bool may_be_scarp(Index face) const;
  /// Returns whether the rules remove the point p of a surface. They remove parts of horizons and faults inside a body
  /// that cuts, and parts of a body that crosses itself with its inside on both sides. Points at the distance `off` on
  /// both sides along the normal are tested. If p is on a body's surface the result is true, because open edges are
  /// checked along bodies. The body with index `but` is ignored.
  bool is_removed(Index surface, const Vec3& p, const Vec3& off, Index but = no_index) const;
  /// Checks that mesh faces on box sides lie exactly in the plane of the side (`faces_off_box_side`).
  void check_box_sides(CheckResult& result) const;

 protected:
  const CheckedMesh& mesh_;
  const Specification& specification_;
  const FacesFile* faces_;
  std::vector<Triangle> candidates_;
  std::vector<Body> bodies_;

 private:
  std::map<std::int32_t, Index> surface_of_id_;
  std::map<Index, std::int32_t> id_of_surface_;
};

}  // namespace geomesh::geomodel::checking
