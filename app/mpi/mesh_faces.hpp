// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The faces of a part: those of two of its tetrahedra, and those of one.
#pragma once

#include <vector>

#include "part.hpp"

namespace geomesh::app {

/// Faces of one tetrahedron of this rank alone.
struct OpenFace {
  Index cell;
  unsigned opposite;  ///< vertex of the cell
  Triangle vertices;  ///< counter-clockwise seen from the cell
};

struct InnerFace {
  Corners corners;
  std::array<Index, 2> cells;
};

/// O(n log n). Throws InternalError where a face has three tetrahedra, or two on one side.
struct MeshFaces {
  enum class Which { all, at_border };
  /// `at_border`: those alone whose corners all may be outside, where the mesh tells; all open ones are among them.
  explicit MeshFaces(const RankMesh& mesh, Which which = Which::all);
  std::vector<OpenFace> open;  ///< by cell

  /// Corners of open faces, ascending.
  std::vector<VertexIndex> open_corners() const;
  /// visit(InnerFace) for each, in the order of their corners.
  template <class Visit>
  void for_each_inner(const Visit& visit) const {
    for (const Use& use : uses_)
      if (use.other != no_index) visit(InnerFace{use.corners(), {use.cell(), use.other}});
  }

 private:
  /// Two of it are a face.
  struct Use {
    std::uint64_t low;  ///< the two smallest corners
    VertexIndex high;
    Index code;  ///< four times the cell, and the face
    Index other = no_index;
    Index cell() const { return code / 4; }
    Corners corners() const {
      return {static_cast<VertexIndex>(low >> 32), static_cast<VertexIndex>(low & 0xFFFFFFFFu), high};
    }
  };
  std::vector<Use> uses_;  // of inner faces, one each
};

}  // namespace geomesh::app
