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
  unsigned opposite;  ///< position in its cell (0 to 3) of the vertex opposite the face
  Triangle vertices;  ///< corners of the face, counter-clockwise as seen from its cell
};

struct InnerFace {
  Corners corners;
  std::array<Index, 2> cells;
};

/// Inner and open faces of a part. O(n log n). Throws InternalError if a face has three tetrahedra, or two on one side.
struct MeshFaces {
  enum class Which { all, at_border };
  /// With `at_border`, searches only faces whose corners may all lie on the outside of the mesh, if the mesh stores
  /// which points may lie there. These include all open faces, which only one tetrahedron has.
  explicit MeshFaces(const RankMesh& mesh, Which which = Which::all);
  std::vector<OpenFace> open;  ///< by cell

  /// Returns the corners, ascending, of all faces that only one tetrahedron has.
  std::vector<VertexIndex> open_corners() const;
  /// Calls visit(InnerFace) for each face that two tetrahedra share, in the order of the faces' corners.
  template <class Visit>
  void for_each_inner(const Visit& visit) const {
    for (const Use& use : uses_)
      if (use.other != no_index) visit(InnerFace{use.corners(), {use.cell(), use.other}});
  }

 private:
  /// One use of a face by a tetrahedron; two uses make an inner face.
  struct Use {
    std::uint64_t low;  ///< the two smallest vertex numbers of the face, packed into one number
    VertexIndex high;
    Index code;  ///< index of the cell times four, plus that of the face in the cell (0 to 3)
    Index other = no_index;
    Index cell() const { return code / 4; }
    Corners corners() const {
      return {static_cast<VertexIndex>(low >> 32), static_cast<VertexIndex>(low & 0xFFFFFFFFu), high};
    }
  };
  std::vector<Use> uses_;  // the faces that two tetrahedra share, once each
};

}  // namespace geomesh::app
