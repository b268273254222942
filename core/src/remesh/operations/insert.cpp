// SPDX-License-Identifier: MIT
// Inserts a point by a constrained Delaunay cavity. Declared in remesh/operations/operations.hpp.
#include <algorithm>
#include <cmath>

#include "common/sort_unique.hpp"
#include "mesh/cavity.hpp"
#include "quality/measure/shape.hpp"
#include "remesh/operations/operations.hpp"
#include "remesh/operations/refine_ratios.hpp"

namespace geomesh::remesh {

namespace {

/// Returns the face of the same patch across the edge (x, y) of a constrained face; invalid if the edge is on a curve.
FaceRef surface_neighbor(const DomainMesh& mesh, FaceRef face, VertexIndex x, VertexIndex y) {
  if (mesh.curve_of(x, y) != no_index) return {};
  std::vector<CellIndex> cells;
  std::vector<VertexIndex> ring;
  const bool closed = turn_about_edge(mesh.cells(), face.cell(), x, y, cells, ring);
  const EdgeFaces faces = constrained_faces_of_ring(mesh, cells, ring, closed);
  if (faces.n != 2) return {};
  VertexIndex third = no_vertex;
  for (const VertexIndex v : mesh.face(face))
    if (v != x && v != y) third = v;
  const std::size_t other = ring[faces.at[0]] == third ? faces.at[1] : faces.at[0];
  const bool last = !closed && other == cells.size();
  const CellIndex c = last ? cells.back() : cells[other];
  const VertexIndex opposite = last ? ring[cells.size() - 1] : ring[(other + 1) % ring.size()];
  return FaceRef(c, mesh.cells().index_of(c, opposite));
}

/// Walks within a patch to the face that contains the projection of p. Returns an invalid face if it meets a curve.
FaceRef locate_on_surface(const DomainMesh& mesh, const Vec3& p, FaceRef face) {
  for (unsigned step = 0; step < 300; ++step) {
    const Triangle t = mesh.face(face);
    const Vec3 n = mesh.normal(t);
    unsigned leave = 3;
    double worst = 0;
    for (unsigned k = 0; k < 3; ++k) {
      const Vec3& x = mesh.point(t[k]);
      const double side = dot(cross(mesh.point(t[(k + 1) % 3]) - x, p - x), n);
      if (side < worst) worst = side, leave = k;
    }
    if (leave == 3) return face;
    face = surface_neighbor(mesh, face, t[leave], t[(leave + 1) % 3]);
    if (!face.valid()) return face;
  }
  return {};
}

class SurfaceInsertion {
 public:
  SurfaceInsertion(Toolbox& tools, const Vec3& p) : tools_(tools), mesh_(tools.mesh), p_(p) {}

  std::optional<VertexIndex> attempt(FaceRef start, const InsertionRule& rule) {
    const FaceRef home = locate_on_surface(mesh_, p_, start);
    if (!home.valid() || !grow_on_surface(home, rule.spacing)) return std::nullopt;
    if (!find_cavity(refine_ratios.surface_spacing_off * rule.spacing)) return std::nullopt;
    StarCavity& cavity = tools_.work.cavity;
    if (swallows_constraint(mesh_, tools_.work, cavity.cells, cavity.link, opened_)) return std::nullopt;
    add_spokes(cavity);
    if (!(star_shape(mesh_, cavity, p_, rule.min_shape) > rule.min_shape) || !guard_allows(cavity)) return std::nullopt;
    const VertexIndex v = mesh_.add_vertex(p_, VertexKind::surface, mesh_.patch_of(mesh_.tag(home)));
    fill_with_star(mesh_, cavity, v, tools_.work);
    ++tools_.statistics.points_on_surfaces;
    return v;
  }

 private:
  bool in_circumsphere(CellIndex c) const {
    const Sphere s = circumsphere(mesh_, c);
    return squared_distance(s.centre, p_) < s.radius * s.radius;
  }

  bool in_circumcircle(const Triangle& t) const {
    const Vec3 offset = offset_of_circumcentre(mesh_, t);
    return squared_distance(mesh_.point(t[0]) + offset, p_) < dot(offset, offset);
  }

  bool is_opened(FaceRef f) const { return std::find(opened_.begin(), opened_.end(), f) != opened_.end(); }

  /// Collects the faces of the patch whose circumcircle contains p, starting at the face that contains p; each is
  /// listed from both sides.
  bool grow_on_surface(FaceRef home, const LocalLength& spacing) {
    std::vector<FaceRef> faces{home};
    const auto both = [&](FaceRef f) { return std::array{f, mesh_.cells().mirror(f)}; };
    const auto open = [&](FaceRef f) {
      for (const FaceRef g : both(f))
        if (g.valid()) opened_.push_back(g), bases_.push_back(g.cell());
    };
    open(home);
    for (std::size_t k = 0; k < faces.size() && faces.size() < 60; ++k) {
      const Triangle t = mesh_.face(faces[k]);
      for (unsigned j = 0; j < 3; ++j) {
        if (spacing.exceeds(mesh_.point(t[j]) - p_)) return false;
        const FaceRef n = surface_neighbor(mesh_, faces[k], t[j], t[(j + 1) % 3]);
        if (!n.valid() || is_opened(n) || !in_circumcircle(mesh_.face(n))) continue;
        open(n);
        faces.push_back(n);
      }
    }
    sort_unique(bases_);
    return true;
  }

  /// Finds the cells whose circumsphere contains p and that p sees, if no vertex is nearer than `spacing`. A shape
  /// criterion in doubles selects the cells; visibility is decided exactly. Returns false if there is none.
  bool find_cavity(const LocalLength& spacing) {
    constexpr std::size_t most_cells = 400;
    const auto may_cross = [&](FaceRef f) { return !mesh_.tag(f).constrained(); };
    Cavity cavity(mesh_.cells(), tools_.work.marks, tools_.work.cells, bases_);
    cavity.grow(most_cells, may_cross, [&](CellIndex c) { return in_circumsphere(c); });
    if (!cavity.shrink(
            may_cross, [&](FaceRef f) { return is_opened(f); },
            [&](FaceRef f) { return mesh_.sees(p_, mesh_.face(f)); }) ||
        !keeps_spacing(spacing))
      return false;
    // gather_cells reuses the marks, so the cells of the cavity are copied first.
    tools_.work.created.assign(tools_.work.cells.begin(), tools_.work.cells.end());
    gather_cells(mesh_, tools_.work.marks, tools_.work.created, tools_.work.cavity);
    if (!opened_.empty()) drop_opened_hull_faces();
    return true;
  }

  /// Removes outer faces of the model that the cavity contains from its border, because the new surface replaces them.
  void drop_opened_hull_faces() {
    std::vector<Triangle> gone;
    for (const FaceRef f : opened_)
      if (!mesh_.has_neighbor(f.cell(), f.face())) gone.push_back(mesh_.face(f));
    std::erase_if(tools_.work.cavity.link,
                  [&](const LinkFace& l) { return std::find(gone.begin(), gone.end(), l.vertices) != gone.end(); });
  }

  /// Adds the border edges of the removed surface faces to the cavity, oriented like their facets.
  void add_spokes(StarCavity& cavity) const {
    std::vector<Spoke> edges;
    for (const FaceRef f : opened_) {
      if (!mesh_.is_surface(f)) continue;
      const Triangle t = mesh_.facet_face(f);
      for (unsigned k = 0; k < 3; ++k) edges.push_back({t[k], t[(k + 1) % 3], mesh_.tag(f).facet()});
    }
    for (const Spoke& s : edges)
      if (std::none_of(edges.begin(), edges.end(), [&](const Spoke& o) { return o.a == s.b && o.b == s.a; }))
        cavity.spokes.push_back(s);
  }

  bool guard_allows(const StarCavity& cavity) const {
    SurfacePart before;
    for (const FaceRef f : opened_)
      before.faces.push_back({mesh_.places(mesh_.facet_face(f)), mesh_.patch_of(mesh_.tag(f))});
    return tools_.guard.admits(before, surface_of(mesh_, cavity, p_));
  }

  /// Returns whether p keeps the required distance from all vertices of removed cells, even those inside the cavity.
  bool keeps_spacing(const LocalLength& spacing) const {
    for (const CellIndex c : tools_.work.cells)
      for (const VertexIndex v : mesh_.vertices(c))
        if (spacing.exceeds(mesh_.point(v) - p_)) return false;
    return true;
  }

  Toolbox& tools_;
  DomainMesh& mesh_;
  Vec3 p_;
  std::vector<CellIndex> bases_;  // cells that the cavity must contain
  std::vector<FaceRef> opened_;   // constrained faces inside the cavity, from both sides
};

}  // namespace

std::optional<VertexIndex> insert_on_surface(Toolbox& tools, const Vec3& p, FaceRef start, const InsertionRule& rule) {
  const FaceTag tag = tools.mesh.tag(start);
  if (tag.facet() == hull_facet) return std::nullopt;
  return SurfaceInsertion(tools, tools.guard.project_to_patch(tools.mesh.patch_of(tag), p)).attempt(start, rule);
}

}  // namespace geomesh::remesh
