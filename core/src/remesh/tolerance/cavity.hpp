// SPDX-License-Identifier: MIT
/// @file
/// A cavity: a region of the mesh that is to be refilled by the star of one vertex. Split, collapse, insertion and
/// smoothing have this in common.
///
///   split     the cells about an edge, refilled from a point of the edge;
///   collapse  the cells about a vertex, refilled from one of its neighbours;
///   insert    cells of one component, refilled from a new point;
///   smooth    the cells about a vertex, refilled from the same vertex elsewhere (no change of connectivity).
///
/// If every new cell is positive, the star tiles the region exactly: the signed indicator functions of the new cells
/// add up to that of the region, because both have the same border. Positivity, decided exactly, is therefore the whole
/// geometric test.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "common/epoch_marks.hpp"
#include "quality/measure/link_shapes.hpp"
#include "remesh/domain/domain_mesh.hpp"

namespace geomesh::remesh {

/// A face (v0, v1, v2) of the link; (v0, v1, v2, apex) will be a positive cell.
struct LinkFace {
  Triangle vertices;
  Index component;
};

/// A constrained face (apex, a, b) in the orientation of its facet.
struct Spoke {
  VertexIndex a, b;
  Index facet;
};

/// An edge of a curve from the apex of a cavity's star to another vertex `a` of the star.
struct CurveSpoke {
  VertexIndex a;
  Index curve;
};

struct StarCavity {
  std::vector<CellIndex> cells;
  std::vector<LinkFace> link;
  std::vector<Spoke> spokes;
  std::vector<CurveSpoke> curves;
  std::vector<VertexIndex> neighbours_asked;  ///< scratch of gather_star
  void clear() {
    cells.clear();
    link.clear();
    spokes.clear();
    curves.clear();
    neighbours_asked.clear();
  }
};

/// Arrays and marks that local operations of one thread reuse, to avoid allocations.
struct Workspace {
  EpochMarks marks;
  std::vector<CellIndex> cells, created;
  std::vector<CellIndex> collapsed;  ///< cells around the vertex that is to be removed
  std::vector<StarFace> star;
  std::vector<VertexIndex> ring;
  std::vector<NewCell> added;
  StarCavity cavity;
  LinkShapes link;  ///< link of the vertex that is being optimised
  EpochMarks vertex_marks;
};

/// Gathers the star of v as a cavity, including its surfaces and curves.
void gather_star(const DomainMesh& mesh, VertexIndex v, EpochMarks& marks, StarCavity& cavity);

/// Removes everything that contains v from the cavity, except cells: faces of its link, constrained faces and curve
/// edges. These disappear if the apex is contracted into v.
void drop_vertex(StarCavity& cavity, VertexIndex v);

/// Gathers the cells around the edge (a, b) of cell c, which can be refilled from a point on the edge.
void gather_edge(const DomainMesh& mesh, CellIndex c, VertexIndex a, VertexIndex b, StarCavity& cavity);

/// Makes a cavity of the given cells, which belong to one component with no constrained face between them, to be
/// refilled from a new inner point.
void gather_cells(const DomainMesh& mesh, EpochMarks& marks, std::span<const CellIndex> cells, StarCavity& cavity);

/// Returns whether the star that fills the cavity from p consists of positive cells, decided exactly.
bool star_is_positive(const DomainMesh& mesh, const StarCavity& cavity, const Vec3& p);
/// Returns the worst shape in the star that fills the cavity from p. Ends early once a shape is below `enough`, and
/// returns a value of at most `enough` then.
double star_shape(const DomainMesh& mesh, const StarCavity& cavity, const Vec3& p, double enough = -1);
/// Returns the worst stored shape of the cells in the cavity, which are to be removed.
double removed_shape(const DomainMesh& mesh, const StarCavity& cavity);

/// Returns whether the star that fills the cavity from p has more bad cells than the cavity. Next to a cell that cannot
/// be repaired, raising the worst shape by next to nothing would otherwise let its neighbours become as bad.
bool adds_bad_cells(const DomainMesh& mesh, const StarCavity& cavity, const Vec3& p);
/// Returns whether a star with the given shapes, in the order of the link, has more bad cells than the cavity.
bool adds_bad_cells(const DomainMesh& mesh, const StarCavity& cavity, std::span<const double> shapes);

/// Returns whether a vertex, an edge of a curve or a constrained face is inside of a cavity and not on its border. The
/// marks in `work` must be those of the cavity's cells. Faces in `opened` may be inside.
template <class Border>
bool swallows_constraint(const DomainMesh& mesh, Workspace& work, std::span<const CellIndex> cells,
                         const Border& border, std::span<const FaceRef> opened = {}) {
  work.vertex_marks.begin();
  for (const auto& f : border)
    for (const VertexIndex v : f.vertices) work.vertex_marks.mark(v);
  const auto is_on_border = [&](VertexIndex a, VertexIndex b) {
    return std::any_of(border.begin(), border.end(), [&](const auto& f) {
      return std::ranges::count(f.vertices, a) > 0 && std::ranges::count(f.vertices, b) > 0;
    });
  };
  for (const CellIndex c : cells) {
    const Tetrahedron& t = mesh.vertices(c);
    for (unsigned i = 0; i < 4; ++i) {
      if (!work.vertex_marks.marked(t[i])) return true;
      const FaceRef f(c, i), other = mesh.cells().mirror(f);
      if (mesh.tag(f).constrained() && other.valid() && work.marks.marked(other.cell()) &&
          std::ranges::count(opened, f) == 0)
        return true;
    }
    for (const auto& e : edge_vertices)
      if (mesh.curve_of(t[e[0]], t[e[1]]) != no_index && !is_on_border(t[e[0]], t[e[1]])) return true;
  }
  return false;
}

/// Replaces the cavity by the star of `apex`. The caller must have checked that the star is positive and that curves
/// remain registered. `shapes` are those of the new cells in the order of the link, if known.
void fill_with_star(DomainMesh& mesh, const StarCavity& cavity, VertexIndex apex, Workspace& work,
                    std::span<const double> shapes = {});

/// The constrained faces at an edge (a, b): indices k in its ring of vertices for which (a, b, ring[k]) is one.
struct EdgeFaces {
  std::array<std::size_t, 2> at{};  ///< the first two
  /// For each of the first two constrained faces at the edge, its tag in the cell after the face in the ring of cells
  /// (in the last cell, if no cell follows).
  std::array<FaceTag, 2> tag{};
  std::size_t n = 0;
};
EdgeFaces constrained_faces_of_ring(const DomainMesh& mesh, const std::vector<CellIndex>& cells,
                                    const std::vector<VertexIndex>& ring, bool closed);

}  // namespace geomesh::remesh
