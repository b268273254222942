// SPDX-License-Identifier: MIT
/// @file
/// What a DomainMesh is made of.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geomesh/core/geometry.hpp"
#include "geomesh/core/simplex_mesh.hpp"

namespace geomesh::remesh {

/// Face i of the tetrahedron, counter-clockwise seen from vertex i.
constexpr Triangle face_of(const Tetrahedron& t, unsigned i) {
  const auto& f = face_vertices[i];
  return {t[f[0]], t[f[1]], t[f[2]]};
}

/// Which facet a mesh face is part of, and on which of the facet's sides the cell lies that the face is seen from.
class FaceTag {
 public:
  constexpr FaceTag() = default;
  constexpr FaceTag(Index facet, bool above) : code_(2 * facet + (above ? 1u : 0u)) {}
  constexpr bool constrained() const { return code_ != none; }
  constexpr Index facet() const { return code_ >> 1; }
  constexpr bool above() const {
    return (code_ & 1u) != 0;
  }  ///< the cell is on the side that the facet's normal points to
  constexpr FaceTag opposite() const { return constrained() ? FaceTag(facet(), !above()) : *this; }
  friend constexpr bool operator==(FaceTag, FaceTag) = default;

 private:
  static constexpr std::uint32_t none = 0xFFFFFFFFu;
  std::uint32_t code_ = none;
};

/// Stands for the facet of a boundary face that is part of none. Never moved.
inline constexpr Index hull_facet = 0x7FFFFFFEu;
inline constexpr Index hull_patch = 0x7FFFFFFEu;

/// How free a vertex is to move or go.
enum class VertexKind : std::uint8_t {
  corner,   ///< never removed: ends and junctions of curves, isolated points, in `exact` every input vertex
  curve,    ///< along its curve
  surface,  ///< within its patch
  inside,   ///< freely
  dead,     ///< removed
};

/// A curve edge's class: edges are of one curve where the same segments and the same patches meet in them.
struct CurveClass {
  std::vector<Index> segments;  ///< rows in plc.segments, ascending
  std::vector<Index> patches;   ///< ascending, a patch twice where it passes through
  friend bool operator==(const CurveClass&, const CurveClass&) = default;
};

struct NewCell {
  Tetrahedron vertices;
  Index component = 0;
  std::array<FaceTag, 4>
      tags{};                    ///< of faces inside the region that are constrained; those on its border are inherited
  double shape = unknown_shape;  ///< where it has been computed already, of the vertices in this order
  static constexpr double unknown_shape = -1;
};

/// A face at the border of cells that go: (vertices, apex) is to be a positive cell.
struct StarFace {
  Triangle vertices;
  FaceRef inner;  ///< as seen from the removed cell
  FaceRef outer;  ///< as seen from the kept cell; invalid if there is none
};

}  // namespace geomesh::remesh
