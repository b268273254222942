// SPDX-License-Identifier: MIT
/// @file
/// Patches whose original lies in one plane up to rounding: sides of a box, plane faults, fractures.
///
/// Within such a patch a change needs no search for distances. Let new faces have the same border as the removed ones,
/// let all of them lie in the plane up to rounding and be turned to the same side. Seen along the normal they then
/// cover the same places as the removed ones, once, so each of their points is as near to the original as one that was
/// there.
#pragma once

#include <array>
#include <vector>

#include "geomesh/core/geometry.hpp"
#include "remesh/tolerance/verify_surfaces.hpp"

namespace geomesh::remesh {

/// A constrained face by its corners and its patch. Those of one operation and one patch, before and after, are all
/// oriented alike.
struct SurfaceFace {
  std::array<Vec3, 3> corners;
  Index patch;
};
struct CurvePiece {
  Vec3 a, b;
  Index curve;
};
/// The part that an operation removes, or puts in its place.
struct SurfacePart {
  std::vector<SurfaceFace> faces;
  std::vector<CurvePiece> curves;
};

/// A triangle seen along the coordinate axis that is nearest to a normal: its orientation there is exact.
std::array<Vec2, 3> seen_along(const Vec3& normal, const std::array<Vec3, 3>& corners);
double signed_area(const std::array<Vec2, 3>& t);

class FlatPatches {
 public:
  FlatPatches() = default;
  /// `original`: its faces, by patch. `rounding`: the distance from a plane that rounding alone makes. O(faces).
  FlatPatches(const search::TriangleSurfaces& original, Index n_patches, double rounding);

  /// Whether `after` covers what `before` does. Both have the same border but for their curves, and the same patches.
  /// False: a patch is not flat, a corner is off its plane, a face is turned over or has no area, or the curves are not
  /// straight.
  bool cover_the_same(const SurfacePart& before, const SurfacePart& after) const;

  bool is_flat(Index patch) const { return patch < planes_.size() && !(planes_[patch].normal == Vec3{}); }

 private:
  struct Plane {
    Vec3 normal{};  ///< of length one; zero where the patch is not flat
    Vec3 point{};
  };
  bool is_in_plane(const SurfaceFace& f) const;
  bool faces_cover_the_same(const std::vector<SurfaceFace>& before, const std::vector<SurfaceFace>& after) const;
  bool are_straight_between_ends(const std::vector<CurvePiece>& before, const std::vector<CurvePiece>& after) const;

  std::vector<Plane> planes_;  // by patch
  double rounding_ = 0;
};

}  // namespace geomesh::remesh
