// SPDX-License-Identifier: MIT
// Removal of an edge by the best triangulation of its ring, declared in remesh/operations/improve.hpp.
#include <algorithm>

#include "common/geometry.hpp"
#include "remesh/operations/polygon_triangulation.hpp"

namespace geomesh::remesh {

namespace {

/// The condition for the removal of an edge. By default, it must raise the worst shape.
struct RemovalRule {
  /// The shapes of all new cells must be above the worst before the removal of the edge, or above this value if less.
  double worst_before = 1;
  const MeanGoal* goal = nullptr;  ///< if not null, the removal must raise the mean shape, not the worst
  /// Whether to flip an edge of a surface to make the surface more nearly Delaunay; shapes may fall to `floor`.
  bool for_surface = false;
  double floor = 0;
};

class EdgeRemoval {
 public:
  EdgeRemoval(Toolbox& tools, VertexIndex a, VertexIndex b, const RemovalRule& rule)
      : tools_(tools),
        mesh_(tools.mesh),
        a_(a),
        b_(b),
        before_(rule.worst_before),
        floor_(rule.floor),
        goal_(rule.goal),
        for_surface_(rule.for_surface) {}

  bool attempt(CellIndex c) {
    if (mesh_.curve_of(a_, b_) != no_index) return false;
    auto& cells = tools_.work.cells;
    closed_ = turn_about_edge(mesh_.cells(), c, a_, b_, cells, tools_.work.ring);
    if (!tools_.may_touch(cells)) return false;
    if (cells.size() == 1) return shell_off(cells[0]);
    if (cells.size() > max_ring) return false;
    for (const CellIndex k : cells) before_ = std::min(before_, mesh_.shape_of(k));
    if (goal_ && before_ > goal_->mean) return false;
    const bool may_be_on_surface = mesh_.kind(a_) != VertexKind::inside && mesh_.kind(b_) != VertexKind::inside;
    if (may_be_on_surface) faces_ = constrained_faces_of_ring(mesh_, cells, tools_.work.ring, closed_);
    if (goal_ && faces_.n > 0) return false;
    tools_.work.added.clear();
    if (faces_.n == 0 ? for_surface_ || !remove_inside() : !remove_on_surface()) return false;
    const bool is_positive = std::all_of(tools_.work.added.begin(), tools_.work.added.end(),
                                         [&](const NewCell& n) { return mesh_.is_positive(n.vertices); });
    if (!is_positive || (!for_surface_ && !tools_.bad_cells_may_spread && adds_bad_cells())) return false;
    if (!tools_.exchange(cells)) return false;
    ++tools_.statistics.edge_removals;
    return true;
  }

 private:
  double sum_before() const {
    double sum = 0;
    for (const CellIndex k : tools_.work.cells) sum += mesh_.measure().worth(mesh_.shape_of(k)) - goal_->mean;
    return sum;
  }

  double least_shape() const { return for_surface_ ? std::min(floor_, 0.9 * before_) : before_ * (1 + 1e-6) + 1e-12; }

  /// Returns whether the removal of the edge would increase the number of bad cells.
  bool adds_bad_cells() const {
    const double bad = mesh_.measure().bad();
    if (before_ >= bad) return false;
    const auto n_before = std::count_if(tools_.work.cells.begin(), tools_.work.cells.end(),
                                        [&](CellIndex c) { return mesh_.shape_of(c) < bad; });
    const auto n_after = std::count_if(tools_.work.added.begin(), tools_.work.added.end(),
                                       [&](const NewCell& n) { return mesh_.shape(n.vertices) < bad; });
    return n_after > n_before;
  }

  bool remove_inside() {
    if (!closed_ || tools_.work.ring.size() < 3) return false;
    return solve_side(tools_.work.ring, mesh_.component(tools_.work.cells[0]));
  }

  bool solve_side(const std::vector<VertexIndex>& polygon, Index component) {
    PolygonTriangulation t(mesh_, a_, b_, polygon, faces_.n == 0);
    const double needed = goal_ ? sum_before() + MeanGoal::least_gain : least_shape();
    if (!((goal_ ? t.solve(*goal_, before_, needed) : t.solve(needed)) > needed)) return false;
    t.append_cells(component, tools_.work.added);
    return true;
  }

  bool remove_on_surface() {
    const Index patch = mesh_.patch_of(faces_.tag[0]);
    if (faces_.n != 2 || patch == hull_patch || patch != mesh_.patch_of(faces_.tag[1])) return false;
    const auto& ring = tools_.work.ring;
    const auto& cells = tools_.work.cells;
    const std::size_t s = faces_.at[0], t = faces_.at[1];
    const VertexIndex x = ring[s], y = ring[t];
    if (!closed_ && (s != 0 || t + 1 != ring.size())) return false;
    if (for_surface_ && !surface_asks_for_flip(mesh_, a_, b_, x, y)) return false;
    if (joined_on_surface(x, y)) return false;
    const std::vector<VertexIndex> side(ring.begin() + static_cast<std::ptrdiff_t>(s),
                                        ring.begin() + static_cast<std::ptrdiff_t>(t) + 1);
    if (!solve_side(side, mesh_.component(cells[s]))) return false;
    const std::size_t n_first = tools_.work.added.size();
    if (closed_) {
      std::vector<VertexIndex> other(ring.begin() + static_cast<std::ptrdiff_t>(t), ring.end());
      other.insert(other.end(), ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(s) + 1);
      if (side.size() < 3 && other.size() < 3) return false;
      if (!solve_side(other, mesh_.component(cells[t]))) return false;
    }
    if (!guard_allows(patch, x, y)) return false;
    const FaceTag tag = faces_.tag[0];
    for (std::size_t k = 0; k < tools_.work.added.size(); ++k)
      tag_surface(tools_.work.added[k], x, y, FaceTag(tag.facet(), k < n_first ? tag.above() : !tag.above()));
    return true;
  }

  /// Removes a flat cell whose two faces at the edge a-b are on the boundary. Its other two faces become the surface,
  /// and no new cell takes its place.
  bool shell_off(CellIndex c) {
    if (goal_ || for_surface_ || tools_.guard.exact() || !(mesh_.shape_of(c) < mesh_.measure().bad())) return false;
    const TetMesh& topology = mesh_.cells();
    const VertexIndex x = tools_.work.ring[0], y = tools_.work.ring[1];
    const FaceTag tag = mesh_.tag(c, topology.index_of(c, x)),
                  other =
                      mesh_.tag(c, topology.index_of(c, y));  // tags of the flat cell's faces (a, b, y) and (a, b, x)
    const unsigned opposite_a = topology.index_of(c, a_), opposite_b = topology.index_of(c, b_);
    if (!tag.constrained() || !other.constrained() || mesh_.tag(c, opposite_a).constrained() ||
        mesh_.tag(c, opposite_b).constrained())
      return false;
    const Index patch = mesh_.patch_of(tag);
    if (patch == hull_patch || patch != mesh_.patch_of(other) || tag.above() != other.above()) return false;
    if (joined_on_surface(x, y) || !guard_allows(patch, x, y)) return false;
    auto& cells = tools_.work.cells;
    tools_.work.added.clear();
    for (const unsigned i : {opposite_b, opposite_a}) {
      const FaceRef beyond = topology.neighbor(c, i);
      if (beyond.cell() == cells.back()) return false;
      NewCell same{mesh_.vertices(beyond.cell()), mesh_.component(beyond.cell()), {}, mesh_.shape_of(beyond.cell())};
      for (unsigned k = 0; k < 4; ++k) same.tags[k] = k == beyond.face() ? tag : mesh_.tag(beyond.cell(), k);
      cells.push_back(beyond.cell());
      tools_.work.added.push_back(same);
    }
    if (!tools_.exchange(cells)) return false;
    ++tools_.statistics.edge_removals;
    return true;
  }

  /// Returns whether x-y, which a flip on the surface would create, is already an edge of a surface or of a curve (a
  /// well). If so, new faces would coincide with others, or two surfaces would share an edge that is on no curve. If
  /// the removed edge is not on the boundary, x-y is in the mesh only if a cell at the removed edge contains both x and
  /// y. Faces of other surfaces at x-y may belong to further cells, so all cells at x are examined, or those at y.
  bool joined_on_surface(VertexIndex x, VertexIndex y) {
    if (mesh_.curve_of(x, y) != no_index) return true;
    const auto has_both = [&](CellIndex c) { return mesh_.cells().has_vertex(c, x) && mesh_.cells().has_vertex(c, y); };
    if (closed_ && std::none_of(tools_.work.cells.begin(), tools_.work.cells.end(), has_both)) return false;
    if (mesh_.is_pinched(x)) std::swap(x, y);
    if (mesh_.is_pinched(x)) return true;
    std::vector<CellIndex> about_x;
    mesh_.star(x, tools_.work.marks, about_x);
    return std::any_of(about_x.begin(), about_x.end(), [&](CellIndex c) {
      const unsigned ix = mesh_.cells().index_of(c, x), iy = mesh_.cells().index_of(c, y);
      if (iy > 3) return false;
      for (unsigned i = 0; i < 4; ++i)
        if (i != ix && i != iy && mesh_.tag(c, i).constrained()) return true;
      return false;
    });
  }

  /// Tags the faces (x, y, a) and (x, y, b) of a new cell, which are on the surface after the flip.
  void tag_surface(NewCell& n, VertexIndex x, VertexIndex y, FaceTag tag) const {
    const auto at = n.vertices.begin(), end = at + 3;
    if (std::find(at, end, x) == end || std::find(at, end, y) == end) return;
    n.tags[std::find_if(at, end, [&](VertexIndex v) { return v != x && v != y; }) - at] = tag;
  }

  bool guard_allows(Index patch, VertexIndex x, VertexIndex y) const {
    const Vec3 &a = mesh_.point(a_), &b = mesh_.point(b_), &p = mesh_.point(x), &q = mesh_.point(y);
    return tools_.guard.admits({{{{a, b, p}, patch}, {{b, a, q}, patch}}, {}},
                               {{{{p, a, q}, patch}, {{q, b, p}, patch}}, {}});
  }

  Toolbox& tools_;
  DomainMesh& mesh_;
  VertexIndex a_, b_;
  bool closed_ = true;
  EdgeFaces faces_;
  double before_, floor_;
  const MeanGoal* goal_;
  bool for_surface_;
};

}  // namespace

bool surface_asks_for_flip(const DomainMesh& mesh, VertexIndex a, VertexIndex b, VertexIndex x, VertexIndex y) {
  const auto cosine = [&](VertexIndex v) {
    const Vec3 d = mesh.point(a) - mesh.point(v), e = mesh.point(b) - mesh.point(v);
    return dot(d, e) / (length(d) * length(e));
  };
  return cosine(x) + cosine(y) < -1e-3;
}

bool remove_edge(Toolbox& tools, CellIndex c, VertexIndex a, VertexIndex b) {
  return EdgeRemoval(tools, a, b, {}).attempt(c);
}
bool remove_edge_for_mean(Toolbox& tools, CellIndex c, VertexIndex a, VertexIndex b, const MeanGoal& goal) {
  return EdgeRemoval(tools, a, b, {.goal = &goal}).attempt(c);
}
bool remove_edge_above(Toolbox& tools, CellIndex c, VertexIndex a, VertexIndex b, double floor) {
  return EdgeRemoval(tools, a, b, {.worst_before = floor}).attempt(c);
}
bool flip_surface_edge(Toolbox& tools, CellIndex c, VertexIndex a, VertexIndex b, double floor) {
  return EdgeRemoval(tools, a, b, {.for_surface = true, .floor = floor}).attempt(c);
}

}  // namespace geomesh::remesh
