// SPDX-License-Identifier: MIT
// Lengthens an edge by moving one of its ends. Declared in remesh/operations/operations.hpp.
#include <algorithm>

#include "common/geometry.hpp"
#include "remesh/operations/operations.hpp"
#include "remesh/operations/refine_ratios.hpp"

namespace geomesh::remesh {

namespace {

class Stretch {
 public:
  Stretch(Toolbox& tools, VertexIndex u, VertexIndex v)
      : tools_(tools), mesh_(tools.mesh), u_(u), v_(v), old_(mesh_.point(u)) {}

  bool attempt(double length, double floor) {
    if (mesh_.kind(u_) == VertexKind::corner || mesh_.kind(u_) == VertexKind::dead) return false;
    if (tools_.guard.exact() && mesh_.kind(u_) != VertexKind::inside) return false;
    const Vec3 along = old_ - mesh_.point(v_);
    const double now = std::sqrt(dot(along, along));
    if (!(now > 0)) return false;
    gather_star(mesh_, u_, tools_.work.marks, star_);
    const Vec3 p = project(mesh_.point(v_) + (length / now) * along);
    if (p == old_ || distance(p, mesh_.point(v_)) < least_share * length || !leaves_room(p)) return false;
    const double needed = std::min(0.999 * removed_shape(mesh_, star_), floor);
    if (!(star_shape(mesh_, star_, p, needed) > needed) || !star_is_positive(mesh_, star_, p)) return false;
    if (tools_.spoils(star_, p) || !guard_allows(p)) return false;
    commit(p);
    return true;
  }

 private:
  /// The edge must have at least this share of the requested length after its moved end is projected to the surface.
  static constexpr double least_share = 0.99;

  Vec3 project(const Vec3& p) const {
    switch (mesh_.kind(u_)) {
      case VertexKind::surface:
        return tools_.guard.project_to_patch(mesh_.support(u_), p);
      case VertexKind::curve:
        return tools_.guard.project_to_curve(mesh_.support(u_), p);
      default:
        return p;
    }
  }

  /// Returns whether u may move to p: no other edge at u becomes too short, or shorter if it is too short already.
  bool leaves_room(const Vec3& p) {
    for (const LinkFace& f : star_.link)
      for (const VertexIndex x : f.vertices) {
        if (x == v_) continue;
        const Vec3& q = mesh_.point(x);
        if (tools_.lengths.is_shorter(u_, p, x, refine_ratios.promised_edge) &&
            squared_distance(p, q) < squared_distance(old_, q))
          return false;
      }
    return true;
  }

  bool guard_allows(const Vec3& p) const {
    if (star_.spokes.empty() && star_.curves.empty()) return true;
    return tools_.guard.admits(surface_of(mesh_, star_, old_), surface_of(mesh_, star_, p));
  }

  void commit(const Vec3& p) {
    mesh_.move_vertex(u_, p);
    for (const CellIndex c : star_.cells) mesh_.set_shape(c, mesh_.shape(mesh_.vertices(c)));
    tools_.lengths.forget(u_);
    ++tools_.statistics.smoothing_moves;
  }

  Toolbox& tools_;
  DomainMesh& mesh_;
  VertexIndex u_, v_;
  Vec3 old_;
  StarCavity star_;
};

}  // namespace

bool try_stretch(Toolbox& tools, VertexIndex u, VertexIndex v, double length, double floor) {
  return Stretch(tools, u, v).attempt(length, floor);
}

}  // namespace geomesh::remesh
