// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver_mesh/curved_edges.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>

#include "geomesh/core/surface_distance.hpp"
#include "solver_mesh/curved_face.hpp"
#include "solver_mesh/second_order.hpp"

namespace geomesh::geomodel {

namespace {

double length(const Vec3& v) { return std::sqrt(dot(v, v)); }

/// Returns a bound on the rounding error of a distance that is computed from coordinates near a place.
double rounding_at(const Vec3& p) {
  constexpr double share = 1e-12;  // rounding error as a share of the largest coordinate
  return share * std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
}

/// The mean plane of a side of the model, in long doubles, so that a point that is moved onto the plane is off it only
/// by its own rounding.
struct Plane {
  Vec3 normal{0, 0, 0}, place{0, 0, 0};
  long double height = 0;  ///< signed distance of the plane from the point `place`, along the plane's normal

  long double height_of(const Vec3& p) const {
    long double sum = -height;
    for (std::size_t k = 0; k < 3; ++k)
      sum += (static_cast<long double>(p[k]) - place[k]) * static_cast<long double>(normal[k]);
    return sum;
  }
  Vec3 nearest(Vec3 p) const {
    const long double above = height_of(p);
    for (std::size_t k = 0; k < 3; ++k) p[k] = static_cast<double>(p[k] - above * static_cast<long double>(normal[k]));
    return p;
  }
};

/// An edge of mesh faces, with the surfaces on which it lies and the target of its midpoint.
struct EdgeOnSurfaces {
  VertexIndex a, b;
  std::vector<std::int32_t> surfaces;  ///< ids of the surfaces at the edge without sides of the model, ascending
  /// For each axis: whether the midpoint keeps its coordinate, because a side of the model there is normal to the axis.
  std::array<bool, 3> fixed{false, false, false};
  const Plane* slanting = nullptr;  ///< plane of a side of the model that is not along the axes
  bool may_move = true;
  Vec3 straight{0, 0, 0}, target{0, 0, 0};
  /// Number of times that the midpoint's distance from the straight edge's middle was halved; it is 0 with `stays`.
  int halvings = 0;
  static constexpr int stays = 4;

  Vec3 middle() const {
    return halvings >= stays ? straight : straight + (1.0 / (1 << halvings)) * (target - straight);
  }
};

constexpr std::size_t tetrahedron_edges[6][2] = {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}};
/// Number of alternating projections of a midpoint onto the surfaces that meet in its edge.
constexpr int n_projections = 6;

class EdgeCurver {
 public:
  EdgeCurver(const ModelMesh& mesh, const std::vector<TriangulatedSurface>& surfaces, double tolerance)
      : mesh_(mesh), tolerance_(tolerance), proven_(mesh.faces.size(), {-1, -1, -1}) {
    for (const NamedSurface& named : mesh.surfaces) {
      kind_of_[named.id] = named.kind;
      if (named.kind == SurfaceKind::box) continue;
      for (const TriangulatedSurface& surface : surfaces)
        if (surface.name == named.name) {
          SurfaceDistance nearest(surface.points, surface.triangles);
          if (!nearest.empty()) nearest_.insert_or_assign(named.id, std::move(nearest));
        }
    }
  }

  std::vector<CurvedEdge> curve() {
    find_side_planes();
    find_edges();
    for (EdgeOnSurfaces& edge : edges_) aim(edge);
    // Halving the curvature of edges changes their faces, whose distance from the surfaces must then be proven again.
    do straighten_far_faces();
    while (straighten_unproven());
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
  /// Finds the planes of the model's sides. A side that deviates from a plane by more than rounding has none.
  void find_side_planes() {
    std::map<std::int32_t, std::vector<Triangle>> faces_of;
    for (std::size_t f = 0; f < mesh_.faces.size(); ++f)
      for (const std::int32_t id : set_of(f))
        if (kind_of_.at(id) == SurfaceKind::box) faces_of[id].push_back(mesh_.faces[f].vertices);
    for (const auto& [id, faces] : faces_of)
      if (const std::optional<Plane> plane = plane_of(faces)) sides_[id] = *plane;
  }
  std::optional<Plane> plane_of(const std::vector<Triangle>& faces) const {
    Plane plane;
    Box3 box;
    for (const Triangle& t : faces) {
      const Vec3 &a = mesh_.points[t[0]], &b = mesh_.points[t[1]], &c = mesh_.points[t[2]];
      plane.normal = plane.normal + cross(b - a, c - a);
      for (const VertexIndex v : t) box.add(mesh_.points[v]);
    }
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (box.min[axis] == box.max[axis]) {
        plane.normal = {0, 0, 0};
        plane.normal[axis] = 1;
      }
    plane.normal = (1 / length(plane.normal)) * plane.normal;
    plane.place = half_way(box.min, box.max);
    long double sum = 0;
    for (const Triangle& t : faces)
      for (const VertexIndex v : t) sum += plane.height_of(mesh_.points[v]);
    plane.height = sum / static_cast<long double>(3 * faces.size());
    for (const Triangle& t : faces)
      for (const VertexIndex v : t)
        if (!(std::abs(plane.height_of(mesh_.points[v])) <= rounding_at(mesh_.points[v]))) return std::nullopt;
    return plane;
  }
  /// Restricts the midpoint of an edge on a side of the model to the plane of this side. An edge on two oblique sides
  /// at once remains straight.
  void fix_side(std::int32_t id, EdgeOnSurfaces& edge) const {
    const auto plane = sides_.find(id);
    if (plane == sides_.end()) {
      edge.may_move = false;
      return;
    }
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (plane->second.normal[axis] == 1) {
        edge.fixed[axis] = true;
        return;
      }
    edge.may_move = edge.may_move && !edge.slanting;
    edge.slanting = &plane->second;
  }

  void aim(EdgeOnSurfaces& edge) const {
    edge.straight = half_way(mesh_.points[edge.a], mesh_.points[edge.b]);
    Vec3 p = edge.straight;
    const bool is_one = edge.surfaces.size() == 1 && edge.fixed == std::array<bool, 3>{} && !edge.slanting;
    for (int round = 0; round < (is_one ? 1 : n_projections); ++round)
      for (const std::int32_t id : edge.surfaces) p = within_sides(nearest_.at(id).closest(p), edge);
    edge.target = p;
    const double rounding = rounding_at(p);
    for (const std::int32_t id : edge.surfaces)
      if (!(distance(id, p) <= distance(id, edge.straight) + rounding)) edge.halvings = EdgeOnSurfaces::stays;
    if (!(length(p - edge.straight) <= tolerance_)) edge.halvings = EdgeOnSurfaces::stays;
    if (edge.slanting && !(std::abs(edge.slanting->height_of(p)) <= rounding)) edge.halvings = EdgeOnSurfaces::stays;
  }
  static Vec3 within_sides(Vec3 p, const EdgeOnSurfaces& edge) {
    if (edge.slanting) p = edge.slanting->nearest(p);
    for (std::size_t k = 0; k < 3; ++k)
      if (edge.fixed[k]) p[k] = edge.straight[k];
    return p;
  }
  double distance(std::int32_t id, const Vec3& p) const { return length(nearest_.at(id).closest(p) - p); }

  EdgeOnSurfaces* find(VertexIndex p, VertexIndex q) {
    const std::pair key{std::min(p, q), std::max(p, q)};
    const auto at = std::lower_bound(edges_.begin(), edges_.end(), key,
                                     [](const EdgeOnSurfaces& e, const auto& k) { return std::pair(e.a, e.b) < k; });
    return at != edges_.end() && std::pair(at->a, at->b) == key ? &*at : nullptr;
  }
  Vec3 middle(VertexIndex p, VertexIndex q) {
    if (const EdgeOnSurfaces* const edge = find(p, q)) return edge->middle();
    return half_way(mesh_.points[p], mesh_.points[q]);
  }

  /// Straightens the edges of all faces that are not proven to be within the tolerance of their surfaces.
  void straighten_far_faces() {
    for (bool changed = true; changed;) {
      changed = false;
      for (std::size_t f = 0; f < mesh_.faces.size(); ++f) {
        const Triangle& v = mesh_.faces[f].vertices;
        const std::array<EdgeOnSurfaces*, 3> edges{find(v[0], v[1]), find(v[1], v[2]), find(v[2], v[0])};
        std::array<int, 3> halvings{};
        for (std::size_t e = 0; e < 3; ++e) halvings[e] = edges[e] ? edges[e]->halvings : EdgeOnSurfaces::stays;
        const bool is_flat =
            halvings == std::array{EdgeOnSurfaces::stays, EdgeOnSurfaces::stays, EdgeOnSurfaces::stays};
        if (is_flat || proven_[f] == halvings) continue;
        const std::array<Vec3, 6> nodes{mesh_.points[v[0]], mesh_.points[v[1]], mesh_.points[v[2]],
                                        middle(v[0], v[1]), middle(v[1], v[2]), middle(v[2], v[0])};
        if (is_within(f, nodes)) {
          proven_[f] = halvings;
          continue;
        }
        for (EdgeOnSurfaces* const e : edges)
          if (e) e->halvings = EdgeOnSurfaces::stays;
        changed = true;
      }
    }
  }
  bool is_within(std::size_t face, const std::array<Vec3, 6>& nodes) const {
    return std::all_of(set_of(face).begin(), set_of(face).end(), [&](std::int32_t id) {
      const auto surface = nearest_.find(id);
      return surface == nearest_.end() || is_face_within(nodes, surface->second, tolerance_);
    });
  }

  /// Halves the curvature of edges of elements whose Jacobian is not proven positive; returns whether any edge changed.
  bool straighten_unproven() {
    bool any = false;
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
        any = changed = true;
      }
    }
    return any;
  }

  const ModelMesh& mesh_;
  double tolerance_;
  std::map<std::int32_t, SurfaceKind> kind_of_;
  std::map<std::int32_t, SurfaceDistance> nearest_;
  std::map<std::int32_t, Plane> sides_;  // plane of each side of the model that is plane, by its id
  std::vector<EdgeOnSurfaces> edges_;    // by ends, ascending
  // for each face: how often its edges' curvature had been halved when it was last proven near its surfaces
  std::vector<std::array<int, 3>> proven_;
};

}  // namespace

std::vector<CurvedEdge> curved_edges(const ModelMesh& mesh, const std::vector<TriangulatedSurface>& surfaces,
                                     double tolerance) {
  return EdgeCurver(mesh, surfaces, tolerance).curve();
}

}  // namespace geomesh::geomodel
