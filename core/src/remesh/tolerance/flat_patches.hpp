// SPDX-License-Identifier: MIT
/// @file
/// Patches whose original lies in one plane up to rounding: sides of a box, plane faults, fractures.
///
/// Within such a patch, faces can be exchanged without computing distances, if the new faces have the same border as
/// the removed ones, lie in the plane up to rounding, and are all oriented to the same side. Seen along the normal,
/// they then cover the same area as the removed faces exactly once, so each of their points is as close to the original
/// as a point of the removed faces.
#pragma once

#include <array>
#include <vector>

#include "geomesh/core/geometry.hpp"
#include "remesh/tolerance/verify_surfaces.hpp"

namespace geomesh::remesh {

/// A constrained face, by corners and patch. Faces of one patch that an operation removes or adds are oriented alike.
struct SurfaceFace {
  std::array<Vec3, 3> corners;
  Index patch;
};
struct CurvePiece {
  Vec3 a, b;
  Index curve;
};
/// The faces and curve pieces that an operation removes, or those that it puts in their place.
struct SurfacePart {
  std::vector<SurfaceFace> faces;
  std::vector<CurvePiece> curves;
};

/// Projects a triangle along the coordinate axis closest to the normal. The orientation of the projection is exact.
std::array<Vec2, 3> seen_along(const Vec3& normal, const std::array<Vec3, 3>& corners);
double signed_area(const std::array<Vec2, 3>& t);

class FlatPatches {
 public:
  FlatPatches() = default;
  /// Finds the flat patches. `original` contains the original faces by patch; `rounding` is the distance from a plane
  /// that rounding alone may cause. O(faces).
  FlatPatches(const search::TriangleSurfaces& original, Index n_patches, double rounding);

  /// Returns whether new faces and curve pieces cover the same area and lines as the removed ones. Both must have the
  /// same border, except for their curves, and the same patches. Returns false if a patch is not flat, a corner is off
  /// its plane, a face is turned over or has no area, or the curves are not straight.
  bool cover_the_same(const SurfacePart& before, const SurfacePart& after) const;

  bool is_flat(Index patch) const { return patch < planes_.size() && !(planes_[patch].normal == Vec3{}); }

 private:
  struct Plane {
    Vec3 normal{};  ///< unit normal of the patch's plane; zero if the patch is not flat
    Vec3 point{};
  };
  bool is_in_plane(const SurfaceFace& f) const;
  bool faces_cover_the_same(const std::vector<SurfaceFace>& before, const std::vector<SurfaceFace>& after) const;
  bool are_straight_between_ends(const std::vector<CurvePiece>& before, const std::vector<CurvePiece>& after) const;

  std::vector<Plane> planes_;  // by patch
  double rounding_ = 0;
};

}  // namespace geomesh::remesh
