// SPDX-License-Identifier: MIT
/// @file
/// The elements of a DomainMesh: faces, tags, kinds of vertices, curve classes and new cells.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geomesh/core/geometry.hpp"
#include "geomesh/core/simplex_mesh.hpp"

namespace geomesh::remesh {

/// Returns face i of the tetrahedron, counter-clockwise as seen from vertex i.
constexpr Triangle face_of(const Tetrahedron& t, unsigned i) {
  const auto& f = face_vertices[i];
  return {t[f[0]], t[f[1]], t[f[2]]};
}

/// The facet that a face of the mesh is part of, and the side of the facet on which its cell lies.
class FaceTag {
 public:
  constexpr FaceTag() = default;
  constexpr FaceTag(Index facet, bool above) : code_(2 * facet + (above ? 1u : 0u)) {}
  constexpr bool constrained() const { return code_ != none; }
  constexpr Index facet() const { return code_ >> 1; }
  /// Returns whether the cell is on the side to which the facet's normal points.
  constexpr bool above() const { return (code_ & 1u) != 0; }
  constexpr FaceTag opposite() const { return constrained() ? FaceTag(facet(), !above()) : *this; }
  friend constexpr bool operator==(FaceTag, FaceTag) = default;

 private:
  static constexpr std::uint32_t none = 0xFFFFFFFFu;
  std::uint32_t code_ = none;
};

/// Tag of a boundary face that is part of no facet. Such a face is never moved.
inline constexpr Index hull_facet = 0x7FFFFFFEu;
inline constexpr Index hull_patch = 0x7FFFFFFEu;

/// How freely a vertex may be moved or removed.
enum class VertexKind : std::uint8_t {
  /// Never removed: ends and junctions of curves, isolated points, and all input vertices if surfaces are kept exactly.
  corner,
  curve,    ///< along its curve
  surface,  ///< within its patch
  inside,   ///< freely
  dead,     ///< removed
};

/// A class of edges on curves. Edges belong to one class if the same segments and the same patches meet at them.
struct CurveClass {
  std::vector<Index> segments;  ///< indices in plc.segments of the segments that contain these edges, ascending
  std::vector<Index> patches;   ///< patches of the faces at the edge, ascending; one entry for each face
  friend bool operator==(const CurveClass&, const CurveClass&) = default;
};

struct NewCell {
  Tetrahedron vertices;
  Index component = 0;
  /// Tags of constrained faces inside the region that is replaced; faces on its border keep their tags.
  std::array<FaceTag, 4> tags{};
  double shape = unknown_shape;  ///< quality measure, computed from the vertices in this order; unknown_shape: not yet
  static constexpr double unknown_shape = -1;
};

/// A face on the border of a cavity. The tetrahedron of `vertices` and the apex of the star will be a positive cell.
struct StarFace {
  Triangle vertices;
};

}  // namespace geomesh::remesh
