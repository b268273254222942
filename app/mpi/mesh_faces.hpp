// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Finds the inner faces of a part, which two of its tetrahedra share, and the open faces, which only one has.
#pragma once

#include <vector>

#include "part.hpp"

namespace geomesh::app {

/// A face that only one tetrahedron of this rank has.
struct OpenFace {
  Index cell;
  unsigned opposite;  ///< vertex of the cell opposite the face
  Triangle vertices;  ///< counter-clockwise as seen from the cell
};

struct InnerFace {
  Corners corners;
  std::array<Index, 2> cells;
};

/// Inner and open faces of a part. O(n log n). Throws InternalError if a face has three tetrahedra, or two on one side.
struct MeshFaces {
  enum class Which { all, at_border };
  /// `at_border` restricts the search to faces whose corners may all be on the outside, if the mesh has this
  /// information; all open faces are among them.
  explicit MeshFaces(const RankMesh& mesh, Which which = Which::all);
  std::vector<OpenFace> open;  ///< by cell

  /// Returns the corners of open faces, ascending.
  std::vector<VertexIndex> open_corners() const;
  /// Calls visit(InnerFace) for each inner face, in the order of their corners.
  template <class Visit>
  void for_each_inner(const Visit& visit) const {
    for (const Use& use : uses_)
      if (use.other != no_index) visit(InnerFace{use.corners(), {use.cell(), use.other}});
  }

 private:
  /// One use of a face by a tetrahedron; two uses make an inner face.
  struct Use {
    std::uint64_t low;  ///< two smallest corners of the face
    VertexIndex high;
    Index code;  ///< index of the cell times four, plus that of the face
    Index other = no_index;
    Index cell() const { return code / 4; }
    Corners corners() const {
      return {static_cast<VertexIndex>(low >> 32), static_cast<VertexIndex>(low & 0xFFFFFFFFu), high};
    }
  };
  std::vector<Use> uses_;  // one use of each inner face
};

}  // namespace geomesh::app
