// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver_mesh/curved_edges.hpp"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <tuple>

#include "solver_mesh/second_order.hpp"

namespace geomesh::geomodel {

namespace {

using Kernel = CGAL::Simple_cartesian<double>;

double length(const Vec3& v) { return std::sqrt(dot(v, v)); }

/// Nearest points of a triangulated surface.
class NearestPoints {
 public:
  explicit NearestPoints(const TriangulatedSurface& surface) {
    const auto point = [&](VertexIndex v) {
      const Vec3& p = surface.points[v];
      return Kernel::Point_3(p.x, p.y, p.z);
    };
    for (const Triangle& t : surface.triangles) {
      const Kernel::Triangle_3 triangle(point(t[0]), point(t[1]), point(t[2]));
      if (!triangle.is_degenerate()) triangles_.push_back(triangle);
    }
    tree_.insert(triangles_.begin(), triangles_.end());
    tree_.build();
    if (!triangles_.empty()) tree_.accelerate_distance_queries();
  }
  bool empty() const { return triangles_.empty(); }
  Vec3 to(const Vec3& p) const {
    const Kernel::Point_3 q = tree_.closest_point(Kernel::Point_3(p.x, p.y, p.z));
    return {q.x(), q.y(), q.z()};
  }

 private:
  using Primitive = CGAL::AABB_triangle_primitive<Kernel, std::vector<Kernel::Triangle_3>::const_iterator>;
  std::vector<Kernel::Triangle_3> triangles_;
  CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>> tree_;
};

/// What lies at an edge of faces.
struct EdgeOnSurfaces {
  VertexIndex a, b;
  std::vector<std::int32_t> surfaces;              ///< but sides of the model, ascending
  std::array<bool, 3> fixed{false, false, false};  ///< coordinates of a side along the axes
  bool may_move = true;
  Vec3 straight{0, 0, 0}, target{0, 0, 0};
  int halvings = 0;  ///< of the way to the target; stays: the edge is straight
  static constexpr int stays = 4;

  Vec3 middle() const {
    return halvings >= stays ? straight : straight + (1.0 / (1 << halvings)) * (target - straight);
  }
};

constexpr std::size_t tetrahedron_edges[6][2] = {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}};
/// Alternating projections onto surfaces that meet in an edge.
constexpr int n_projections = 6;

class EdgeCurver {
 public:
  EdgeCurver(const ModelMesh& mesh, const std::vector<TriangulatedSurface>& surfaces, double tolerance)
      : mesh_(mesh), tolerance_(tolerance) {
    for (const NamedSurface& named : mesh.surfaces) {
      kind_of_[named.id] = named.kind;
      if (named.kind == SurfaceKind::box) continue;
      for (const TriangulatedSurface& surface : surfaces)
        if (surface.name == named.name) {
          auto nearest = std::make_unique<NearestPoints>(surface);
          if (!nearest->empty()) nearest_[named.id] = std::move(nearest);
        }
    }
  }

  std::vector<CurvedEdge> curve() {
    find_edges();
    for (EdgeOnSurfaces& edge : edges_) aim(edge);
    straighten_far_faces();
    straighten_unproven();
    std::vector<CurvedEdge> result;
    for (const EdgeOnSurfaces& edge : edges_)
      if (const Vec3 middle = edge.middle(); !(middle == edge.straight)) result.push_back({edge.a, edge.b, middle});
    return result;
  }

 private:
  void find_edges() {
    struct Use {
      VertexIndex a, b;
      std::size_t face;
    };
    std::vector<Use> uses;
    for (std::size_t f = 0; f < mesh_.faces.size(); ++f)
      for (std::size_t i = 0; i < 3; ++i) {
        const VertexIndex p = mesh_.faces[f].vertices[i], q = mesh_.faces[f].vertices[(i + 1) % 3];
        uses.push_back({std::min(p, q), std::max(p, q), f});
      }
    std::sort(uses.begin(), uses.end(),
              [](const Use& p, const Use& q) { return std::tie(p.a, p.b, p.face) < std::tie(q.a, q.b, q.face); });
    for (std::size_t k = 0, end = 0; k < uses.size(); k = end) {
      EdgeOnSurfaces edge{uses[k].a, uses[k].b, {}};
      std::map<std::int32_t, int> n_faces;
      for (end = k; end < uses.size() && uses[end].a == edge.a && uses[end].b == edge.b; ++end)
        for (const std::int32_t id : set_of(uses[end].face)) ++n_faces[id];
      for (const auto& [id, n] : n_faces) {
        if (kind_of_.at(id) == SurfaceKind::box) {
          fix_side(id, edge);
        } else if (nearest_.contains(id)) {
          edge.surfaces.push_back(id);
        } else {
          edge.may_move = false;
        }
      }
      const bool is_end = end - k == 1 && edge.surfaces.size() == 1;
      if (edge.may_move && !is_end && !edge.surfaces.empty()) edges_.push_back(std::move(edge));
    }
  }
  const std::vector<std::int32_t>& set_of(std::size_t face) const {
    return mesh_.surface_sets[static_cast<std::size_t>(mesh_.faces[face].surface_set)];
  }
  void fix_side(std::int32_t id, EdgeOnSurfaces& edge) const {
    bool is_along_axes = false;
    const auto named =
        std::find_if(mesh_.surfaces.begin(), mesh_.surfaces.end(), [&](const NamedSurface& s) { return s.id == id; });
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const char* const end : {"min", "max"})
        if (named->name == std::string(1, "xyz"[axis]) + end) {
          edge.fixed[axis] = true;
          is_along_axes = mesh_.points[edge.a][axis] == mesh_.points[edge.b][axis];
        }
    edge.may_move = edge.may_move && is_along_axes;
  }

  void aim(EdgeOnSurfaces& edge) const {
    const Vec3 &a = mesh_.points[edge.a], &b = mesh_.points[edge.b];
    for (std::size_t k = 0; k < 3; ++k) edge.straight[k] = a[k] / 2 + b[k] / 2;
    Vec3 p = edge.straight;
    const bool is_one = edge.surfaces.size() == 1 && edge.fixed == std::array<bool, 3>{};
    for (int round = 0; round < (is_one ? 1 : n_projections); ++round)
      for (const std::int32_t id : edge.surfaces) p = within_sides(nearest_.at(id)->to(p), edge);
    edge.target = p;
    for (const std::int32_t id : edge.surfaces)
      if (!(distance(id, p) <= distance(id, edge.straight))) edge.halvings = EdgeOnSurfaces::stays;
    if (!(length(p - edge.straight) <= tolerance_)) edge.halvings = EdgeOnSurfaces::stays;
  }
  static Vec3 within_sides(Vec3 p, const EdgeOnSurfaces& edge) {
    for (std::size_t k = 0; k < 3; ++k)
      if (edge.fixed[k]) p[k] = edge.straight[k];
    return p;
  }
  double distance(std::int32_t id, const Vec3& p) const { return length(nearest_.at(id)->to(p) - p); }

  EdgeOnSurfaces* find(VertexIndex p, VertexIndex q) {
    const std::pair key{std::min(p, q), std::max(p, q)};
    const auto at = std::lower_bound(edges_.begin(), edges_.end(), key,
                                     [](const EdgeOnSurfaces& e, const auto& k) { return std::pair(e.a, e.b) < k; });
    return at != edges_.end() && std::pair(at->a, at->b) == key ? &*at : nullptr;
  }
  Vec3 middle(VertexIndex p, VertexIndex q) {
    if (const EdgeOnSurfaces* const edge = find(p, q)) return edge->middle();
    const Vec3 &a = mesh_.points[p], &b = mesh_.points[q];
    return {a.x / 2 + b.x / 2, a.y / 2 + b.y / 2, a.z / 2 + b.z / 2};
  }

  /// Places on a face: quarters of its edges, its middle, and the middles towards its corners.
  void straighten_far_faces() {
    static constexpr double q = 0.25, h = 0.5, t = 1.0 / 3;
    static constexpr double places[10][3] = {{3 * q, q, 0}, {q, 3 * q, 0}, {0, 3 * q, q}, {0, q, 3 * q}, {q, 0, 3 * q},
                                             {3 * q, 0, q}, {t, t, t},     {h, q, q},     {q, h, q},     {q, q, h}};
    for (bool changed = true; changed;) {
      changed = false;
      for (std::size_t f = 0; f < mesh_.faces.size(); ++f) {
        const Triangle& v = mesh_.faces[f].vertices;
        std::array<EdgeOnSurfaces*, 3> edges{find(v[0], v[1]), find(v[1], v[2]), find(v[2], v[0])};
        if (std::none_of(edges.begin(), edges.end(),
                         [](const EdgeOnSurfaces* e) { return e && e->halvings < EdgeOnSurfaces::stays; }))
          continue;
        const std::array<Vec3, 6> nodes{mesh_.points[v[0]], mesh_.points[v[1]], mesh_.points[v[2]],
                                        middle(v[0], v[1]), middle(v[1], v[2]), middle(v[2], v[0])};
        if (std::all_of(std::begin(places), std::end(places),
                        [&](const double(&place)[3]) { return is_near(f, at(nodes, place)); }))
          continue;
        for (EdgeOnSurfaces* const e : edges)
          if (e) e->halvings = EdgeOnSurfaces::stays;
        changed = true;
      }
    }
  }
  static Vec3 at(const std::array<Vec3, 6>& n, const double (&l)[3]) {
    Vec3 p{0, 0, 0};
    for (std::size_t i = 0; i < 3; ++i) p = p + (l[i] * (2 * l[i] - 1)) * n[i] + (4 * l[i] * l[(i + 1) % 3]) * n[3 + i];
    return p;
  }
  bool is_near(std::size_t face, const Vec3& p) const {
    return std::all_of(set_of(face).begin(), set_of(face).end(), [&](std::int32_t id) {
      const auto nearest = nearest_.find(id);
      return nearest == nearest_.end() || length(nearest->second->to(p) - p) <= tolerance_;
    });
  }

  void straighten_unproven() {
    for (bool changed = true; changed;) {
      changed = false;
      for (const Tetrahedron& t : mesh_.tetrahedra) {
        std::array<EdgeOnSurfaces*, 6> edges{};
        bool is_curved = false;
        for (std::size_t e = 0; e < 6; ++e) {
          edges[e] = find(t[tetrahedron_edges[e][0]], t[tetrahedron_edges[e][1]]);
          is_curved = is_curved || (edges[e] && edges[e]->halvings < EdgeOnSurfaces::stays);
        }
        if (!is_curved) continue;
        std::array<Vec3, 10> nodes;
        for (std::size_t i = 0; i < 4; ++i) nodes[i] = mesh_.points[t[i]];
        for (std::size_t e = 0; e < 6; ++e)
          nodes[4 + e] = middle(t[tetrahedron_edges[e][0]], t[tetrahedron_edges[e][1]]);
        if (jacobian_is_positive(nodes)) continue;
        for (EdgeOnSurfaces* const e : edges)
          if (e && e->halvings < EdgeOnSurfaces::stays) ++e->halvings;
        changed = true;
      }
    }
  }

  const ModelMesh& mesh_;
  double tolerance_;
  std::map<std::int32_t, SurfaceKind> kind_of_;
  std::map<std::int32_t, std::unique_ptr<NearestPoints>> nearest_;
  std::vector<EdgeOnSurfaces> edges_;  // by ends, ascending
};

}  // namespace

std::vector<CurvedEdge> curved_edges(const ModelMesh& mesh, const std::vector<TriangulatedSurface>& surfaces,
                                     double tolerance) {
  return EdgeCurver(mesh, surfaces, tolerance).curve();
}

}  // namespace geomesh::geomodel
