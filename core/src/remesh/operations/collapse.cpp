// SPDX-License-Identifier: MIT
// Contracts an edge. Declared in remesh/operations/operations.hpp.
#include <algorithm>
#include <limits>

#include "common/geometry.hpp"
#include "remesh/operations/operations.hpp"

namespace geomesh::remesh {

namespace {

/// Appends the edges opposite v in the constrained faces at v, each with its ends in ascending order.
void surface_link(const DomainMesh& mesh, VertexIndex v, EpochMarks& marks, std::vector<CellIndex>& cells,
                  std::vector<std::array<VertexIndex, 2>>& sides) {
  mesh.star(v, marks, cells);
  for (const CellIndex c : cells)
    for (unsigned i = 0; i < 4; ++i) {
      if (!mesh.tag(c, i).constrained() || mesh.vertices(c)[i] == v) continue;
      const Triangle f = mesh.face(c, i);
      const unsigned k = f[0] == v ? 0 : f[1] == v ? 1 : 2;
      sides.push_back(sorted(std::array{f[(k + 1) % 3], f[(k + 2) % 3]}));
    }
}

class Collapse {
 public:
  Collapse(Toolbox& tools, VertexIndex u) : tools_(tools), mesh_(tools.mesh), u_(u), cells_(tools.work.collapsed) {
    cells_.clear();
  }

  /// Tries to contract the edge from u to a neighbour v, which moves u to v. Can be called for further neighbours until
  /// it returns true; the cells at u are gathered only once.
  bool attempt(VertexIndex v, CollapseRule rule, double floor) {
    v_ = v;
    if (mesh_.kind(u_) == VertexKind::corner || mesh_.kind(u_) == VertexKind::dead) return false;
    if (!shapes_may_allow(rule, floor)) return false;
    if (star_.cells.empty()) gather_star(mesh_, u_, tools_.work.marks, star_);
    if (!support_allows() || !cells_at_edge_allow()) return false;
    target_ = star_;
    drop_vertex(target_, v_);
    if (target_.link.empty() || !topology_allows() || !shape_allows(rule, floor) || !guard_allows()) return false;
    commit();
    return true;
  }

 private:
  /// Returns whether the contracted edge u-v lies on the curve or patch of u, so that u may move along it.
  bool support_allows() const {
    switch (mesh_.kind(u_)) {
      case VertexKind::inside:
        return true;
      case VertexKind::surface:
        return std::any_of(star_.spokes.begin(), star_.spokes.end(),
                           [&](const Spoke& s) { return s.a == v_ || s.b == v_; });
      case VertexKind::curve:
        return mesh_.curve_of(u_, v_) != no_index;
      default:
        return false;
    }
  }

  /// Returns whether the cells at the contracted edge u-v permit the contraction. Such a cell vanishes, and two of its
  /// faces become one. Not both of these may be constrained, and neither may be on the boundary.
  bool cells_at_edge_allow() const {
    bool joined = false;
    for (const CellIndex c : star_.cells) {
      const unsigned iv = mesh_.cells().index_of(c, v_);
      if (iv > 3) continue;
      joined = true;
      const unsigned iu = mesh_.cells().index_of(c, u_);
      if (!mesh_.has_neighbor(c, iv) || (mesh_.tag(c, iu).constrained() && mesh_.tag(c, iv).constrained()))
        return false;
    }
    return joined;
  }

  /// Returns whether the surface remains a manifold. A surface edge or face that moves from u to v must not exist
  /// already, except for the edges next to the contracted edge.
  bool topology_allows() const {
    if (mesh_.kind(u_) == VertexKind::inside) return true;
    if (mesh_.is_pinched(v_)) return false;  // not all cells at v are found, so the surface cannot be checked
    std::vector<VertexIndex> beside;
    std::vector<std::array<VertexIndex, 2>> link;
    for (const Spoke& s : star_.spokes)
      if (s.a == v_ || s.b == v_) beside.push_back(s.a == v_ ? s.b : s.a);
    surface_link(mesh_, v_, tools_.work.marks, tools_.work.cells, link);
    for (const Spoke& s : target_.spokes) {
      for (const auto& side : link) {
        if (side == sorted(std::array{s.a, s.b})) return false;
        for (const VertexIndex x : {s.a, s.b})
          if ((side[0] == x || side[1] == x) && std::ranges::count(beside, x) == 0) return false;
      }
    }
    return std::none_of(target_.curves.begin(), target_.curves.end(),
                        [&](const CurveSpoke& s) { return mesh_.curve_of(v_, s.a) != no_index; });
  }

  static double needed_shape(double old, CollapseRule rule, double floor) {
    return rule == CollapseRule::improve ? old * (1 + 1e-9) : std::min(old * 0.999, floor);
  }

  /// Checks the shapes of the cells at u only, which suffices to refuse most contractions. Ends at the first cell that
  /// would be inverted, often before all cells are gathered.
  bool shapes_may_allow(CollapseRule rule, double floor) {
    double least = std::numeric_limits<double>::infinity();
    if (cells_.empty()) mesh_.begin_star(u_, tools_.work.marks, cells_);
    for (std::size_t k = 0; k < cells_.size(); ++k) {
      if (k == n_grown_) mesh_.grow_star(u_, n_grown_++, tools_.work.marks, cells_);
      const CellIndex c = cells_[k];
      if (mesh_.cells().has_vertex(c, v_)) continue;
      const Triangle face = mesh_.face(c, mesh_.cells().index_of(c, u_));
      const double shape = mesh_.shape(face, mesh_.point(v_));
      if (!(shape > 0) && !mesh_.sees(mesh_.point(v_), face)) return false;
      least = std::min(least, shape);
    }
    double old = 1;
    for (const CellIndex c : cells_) old = std::min(old, mesh_.shape_of(c));
    return least > needed_shape(old, rule, floor);
  }

  bool shape_allows(CollapseRule rule, double floor) {
    const double needed = needed_shape(removed_shape(mesh_, star_), rule, floor);
    const Vec3& p = mesh_.point(v_);
    if (!(star_shape(mesh_, target_, p, needed) > needed) || !star_is_positive(mesh_, target_, p)) return false;
    if (rule != CollapseRule::coarsen && tools_.spoils(target_, p)) return false;
    const double stretch = rule == CollapseRule::improve ? 1.8 : 1.4;
    for (const LinkFace& f : target_.link)
      for (const VertexIndex x : f.vertices) {
        const Vec3& q = mesh_.point(x);
        if (tools_.lengths.is_longer(v_, x, stretch) && squared_distance(p, q) > squared_distance(mesh_.point(u_), q))
          return false;
      }
    return true;
  }

  bool guard_allows() const {
    if (star_.spokes.empty() && star_.curves.empty()) return true;
    if (tools_.guard.exact())
      return tools_.guard.admits(surface_of(mesh_, star_, mesh_.point(u_)),
                                 surface_of(mesh_, target_, mesh_.point(v_)));
    StarCavity about_v;
    gather_star(mesh_, v_, tools_.work.marks, about_v);
    std::erase_if(about_v.spokes, [&](const Spoke& s) { return s.a == u_ || s.b == u_; });
    return tools_.guard.admits(surface_of(mesh_, star_, mesh_.point(u_)), surface_of(mesh_, target_, mesh_.point(v_)),
                               surface_of(mesh_, about_v, mesh_.point(v_)).faces);
  }

  void commit() {
    for (const CurveSpoke& s : star_.curves) mesh_.erase_curve(u_, s.a);
    for (const CurveSpoke& s : target_.curves) mesh_.set_curve(v_, s.a, s.curve);
    fill_with_star(mesh_, target_, v_, tools_.work);
    mesh_.remove_vertex(u_);
    ++tools_.statistics.collapses;
  }

  Toolbox& tools_;
  DomainMesh& mesh_;
  VertexIndex u_, v_ = no_vertex;
  std::vector<CellIndex>& cells_;  ///< cells around u that have been gathered so far
  std::size_t n_grown_ = 0;        ///< number of entries of `cells_` whose neighbours around u have been gathered too
  StarCavity star_, target_;
};

}  // namespace

bool try_collapse(Toolbox& tools, VertexIndex u, VertexIndex v, CollapseRule rule, double floor) {
  return Collapse(tools, u).attempt(v, rule, floor);
}

bool try_collapse_into_any(Toolbox& tools, VertexIndex u, std::span<const VertexIndex> neighbours, CollapseRule rule,
                           double floor) {
  Collapse collapse(tools, u);
  return std::ranges::any_of(neighbours, [&](VertexIndex v) { return collapse.attempt(v, rule, floor); });
}

}  // namespace geomesh::remesh
