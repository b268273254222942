// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What the parts of the judge share: the faces of all cells, sorted, and the list of faults.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "corpus_judge.hpp"

namespace geomesh::test {

/// The faces of a positive cell by local vertices, each seen counter-clockwise from the vertex it lacks (so that the
/// cell is above it).
inline constexpr std::array<std::array<unsigned, 3>, 4> faces_from_inside = {
    {{1, 3, 2}, {0, 2, 3}, {0, 3, 1}, {0, 1, 2}}};

/// A triangle as a set and its orientation: `even` where the given order is an even permutation of the sorted one.
struct OrientedKey {
  Triangle sorted;
  bool even;
};
OrientedKey oriented_key(Triangle t);

class Judgement {
 public:
  Judgement(const PiecewiseLinearComplex& plc, const TetrahedralizeOptions& options,
            const ConstrainedTetrahedralization& result);

  const PiecewiseLinearComplex& plc;
  const TetrahedralizeOptions& options;
  const ConstrainedTetrahedralization& mesh;
  double ulp = 0;  ///< of the largest coordinate of the model

  void fault(const std::string& check, const std::string& text);
  std::vector<std::string> faults;

  struct CellFace {
    OrientedKey key;
    Index cell;
  };
  std::vector<CellFace> cell_faces;  ///< sorted by key; a face of two cells stands twice in a row
  /// The cell above `t` (from which it is seen counter-clockwise), or no_index.
  Index cell_above(const Triangle& t) const;

  /// Facet of each face of a facet, sorted by triangle; filled by the constructor.
  struct FacetFace {
    Triangle sorted;
    Index facet;
  };
  std::vector<FacetFace> facet_faces;
  Index facet_of(const Triangle& sorted) const;

  bool is_added(VertexIndex v) const { return mesh.input_vertex[v] == no_vertex; }
  const Vec3& point(VertexIndex v) const { return mesh.points[v]; }

 private:
  std::string last_check_;
  unsigned n_of_check_ = 0;
};

void judge_points(Judgement& j);
void judge_cells(Judgement& j);
void judge_components(Judgement& j);
void judge_delaunay(Judgement& j);
void judge_facets(Judgement& j);
void judge_segments(Judgement& j);
void judge_volumes(Judgement& j);

/// Exact geometry in doubles (CGAL's number type inside; rounded once on return).
int exact_orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);
bool exactly_inside_sphere(const std::array<Vec3, 4>& cell, const Vec3& p);
double distance_from_line(const Vec3& p, const Vec3& a, const Vec3& b);
double distance_from_plane(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c);
/// Where p projects on a-b: 0 at a, 1 at b.
double parameter_on_line(const Vec3& p, const Vec3& a, const Vec3& b);
/// Three corners of the loop that are not collinear, most apart from a line in doubles.
std::array<VertexIndex, 3> plane_corners(const PiecewiseLinearComplex& plc, Index facet);
/// Triangles of one provenance that are joined by edges and lie exactly in one plane, where they are two or more.
/// Nothing else lies at those edges.
std::vector<std::vector<Index>> coplanar_groups(const PiecewiseLinearComplex& plc);
bool is_exactly_planar(const PiecewiseLinearComplex& plc, Index facet);

}  // namespace geomesh::test
