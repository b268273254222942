// SPDX-License-Identifier: MIT
/// @file
/// How a subfacet, whose three edges are present, lies in the mesh: which mesh faces are part of it and which mesh edges pierce it.
///
/// As no mesh edge crosses the subfacet's border, the part of the subfacet in a cell is the whole section of that cell or nothing. So after
/// the first piercing edge, found in the ring of a border edge, the sides of the vertices alone decide: every edge of a pierced cell
/// whose ends lie on different sides pierces the subfacet too.
#pragma once

#include <vector>

#include "recover/constrained_mesh.hpp"

namespace geomesh::recover {

struct PiercingEdge {
  VertexIndex below = no_vertex, above = no_vertex;
  friend auto operator<=>(const PiercingEdge&, const PiercingEdge&) = default;
};

struct FacetTrace {
  enum class Status {
    complete,  ///< the faces cover the subfacet
    pierced,   ///< edges pierce it
    touched,   ///< `culprit` lies in it and is not declared part of it
    unclear,   ///< the signs about an edge contradict each other, which only rounding to a few ulps can do
  };
  Status status = Status::complete;
  std::vector<Triangle> faces;          ///< in the orientation of the subfacet
  std::vector<PiercingEdge> piercing;   ///< in the order found, each once
  VertexIndex culprit = no_vertex;
};

/// Sides of vertices relative to the plane of a triangle; the corners and `members` (declared to lie on it) are on it.
class FacetSides {
 public:
  FacetSides(const ConstrainedMesh& mesh, const Triangle& t, const std::vector<VertexIndex>& members) : mesh_(mesh), t_(t), members_(members) {}
  int operator()(VertexIndex v) const;
  bool is_member(VertexIndex v) const;
  const Triangle& triangle() const { return t_; }

 private:
  const ConstrainedMesh& mesh_;
  Triangle t_;
  const std::vector<VertexIndex>& members_;
};

FacetTrace trace_facet(ConstrainedMesh& mesh, const FacetSides& sides);

}  // namespace geomesh::recover
