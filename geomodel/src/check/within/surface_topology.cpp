// SPDX-License-Identifier: GPL-3.0-or-later
// Checks pieces, borders and holes of surfaces that were moved within a tolerance, declared in
// check/within/within_tolerance.hpp.
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <tuple>

#include "check/exact/exact.hpp"
#include "check/mesh/faults.hpp"
#include "check/within/input_border.hpp"
#include "check/within/passage.hpp"
#include "check/within/within_tolerance.hpp"

namespace geomesh::geomodel::checking {
namespace {

using Edge = std::array<VertexIndex, 2>;
Edge edge_of(const Triangle& t, std::size_t i) {
  return {std::min(t[i], t[(i + 1) % 3]), std::max(t[i], t[(i + 1) % 3])};
}

/// Relative positions of samples on a segment of a border or of an intersection curve.
constexpr std::array<double, 5> between{0.125, 0.3125, 0.5, 0.6875, 0.875};

std::map<Edge, std::vector<Index>> edges_of(const std::vector<Triangle>& triangles) {
  std::map<Edge, std::vector<Index>> edges;
  for (Index t = 0; t < triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) edges[edge_of(triangles[t], i)].push_back(t);
  return edges;
}

struct Topology {
  std::size_t pieces = 0, borders = 0;
  long euler = 0;
  bool manifold = true;  ///< whether no edge of the surface has more than two triangles
  friend bool operator==(const Topology&, const Topology&) = default;
};

class Roots {
 public:
  explicit Roots(std::size_t n) : root_(n) { std::iota(root_.begin(), root_.end(), Index{0}); }
  Index find(Index i) {
    while (root_[i] != i) i = root_[i] = root_[root_[i]];
    return i;
  }
  void join(Index a, Index b) { root_[std::max(find(a), find(b))] = std::min(find(a), find(b)); }

 private:
  std::vector<Index> root_;
};

Topology topology_of(const std::vector<Triangle>& triangles) {
  Topology t;
  std::map<VertexIndex, Index> rows;
  for (const Triangle& f : triangles)
    for (const VertexIndex v : f) rows.try_emplace(v, static_cast<Index>(rows.size()));
  Roots all(rows.size()), border(rows.size());
  std::set<Index> on_border;
  const auto edges = edges_of(triangles);
  for (const auto& [e, at] : edges) {
    const Index a = rows[e[0]], b = rows[e[1]];
    all.join(a, b);
    t.manifold = t.manifold && at.size() <= 2;
    if (at.size() != 1) continue;
    border.join(a, b);
    on_border.insert({a, b});
  }
  std::set<Index> pieces, borders;
  for (Index v = 0; v < rows.size(); ++v) pieces.insert(all.find(v));
  for (const Index v : on_border) borders.insert(border.find(v));
  t.pieces = pieces.size();
  t.borders = borders.size();
  t.euler = static_cast<long>(rows.size()) - static_cast<long>(edges.size()) + static_cast<long>(triangles.size());
  return t;
}

std::string words(const Topology& t) {
  return std::to_string(t.pieces) + " pieces, " + std::to_string(t.borders) + " borders, Euler characteristic " +
         std::to_string(t.euler);
}

class TopologyChecker {
 public:
  TopologyChecker(const CheckedFaces& checked, const Allowed& allowed)
      : checked_(checked),
        specification_(checked.specification()),
        allowed_(allowed),
        pairs_(pair_surfaces(checked, allowed.rounding)),
        edges_(edges_of(checked.candidates())) {
    for (const TriangulatedSurface& s : specification_.surfaces) borders_.emplace_back(s, allowed_);
  }

  void check_presence(CheckResult& result);
  void check_whole_surfaces(CheckResult& result);
  void check_borders(CheckResult& result);
  void check_curves(CheckResult& result);

 private:
  /// Returns whether rules may trim the surface; clipping by a volume that is not a box counts as trimming.
  bool may_be_trimmed(Index row) const {
    return specification_.may_be_trimmed(row) || (specification_.volume && !specification_.volume->box);
  }
  bool is_in_box(const Vec3& p, double room) const;
  bool may_be_cut(Index row) const;
  bool is_whole(Index row) const;
  std::vector<Triangle> faces_of(Index row) const;
  std::vector<Corners> free_edges(Index row, bool but_excused) const;
  std::vector<Corners> continuation_of(Index row) const;
  bool is_excused(const Edge& e, Index row) const;
  bool was_cut_at(Index row, const Vec3& p) const;
  bool is_cracked(Index row) const;
  bool may_be_joined(Index row, Index edge, const Vec3& p) const;
  Corners as_corners(const Edge& e) const {
    const Vec3 &a = checked_.mesh().point(e[0]), &b = checked_.mesh().point(e[1]);
    return {a, b, b};
  }
  struct Places {
    /// Numbers of sampled points of intersection curves, and of those too far from where the surfaces meet in the mesh.
    std::size_t looked_at = 0, farther = 0;
  };
  /// A point at which triangle s of surface i and triangle t of surface j pass through each other, and the direction of
  /// the intersection curve there.
  struct Passage {
    Index i, j, s, t;
    Vec3 place, along;
  };
  TriangleSet meeting_of(Index i, Index j) const;
  bool is_lost(const Passage& passage, const TriangleSet& meeting) const;
  void check_crossings(Index i, Index j, FaultCollector& off, Places& places);

  const CheckedFaces& checked_;
  const Specification& specification_;
  Allowed allowed_;
  std::vector<SurfacePair> pairs_;
  std::map<Edge, std::vector<Index>> edges_;  ///< of all candidates
  std::vector<InputBorder> borders_;
  std::vector<FollowedSurface> followed_;
};

bool TopologyChecker::is_in_box(const Vec3& p, double room) const {
  if (!specification_.box()) return true;
  const Box3 inner = inflated(*specification_.box(), -room);
  return p.x >= inner.min.x && p.y >= inner.min.y && p.z >= inner.min.z && p.x <= inner.max.x && p.y <= inner.max.y &&
         p.z <= inner.max.z;
}

bool TopologyChecker::may_be_cut(Index row) const {
  if (!checked_.is_cut_kind(row)) return false;
  const auto box_of_surface = [](const TriangulatedSurface& s) {
    Box3 box;
    for (const Vec3& p : s.points) box.add(p);
    return box;
  };
  const Box3 own = box_of_surface(specification_.surfaces[row]);
  return std::any_of(checked_.bodies().begin(), checked_.bodies().end(), [&](const Body& body) {
    return body.surface->cuts_all && overlap(own, box_of_surface(*body.surface));
  });
}

bool TopologyChecker::is_whole(Index row) const {
  const auto& points = specification_.surfaces[row].points;
  return !may_be_trimmed(row) && !may_be_cut(row) &&
         std::all_of(points.begin(), points.end(), [&](const Vec3& p) { return is_in_box(p, 0); });
}

std::vector<Triangle> TopologyChecker::faces_of(Index row) const {
  std::vector<Triangle> faces;
  for (const Index f : pairs_[row].faces) faces.push_back(checked_.candidates()[f]);
  return faces;
}

void TopologyChecker::check_presence(CheckResult& result) {
  FaultCollector missing("missing_surfaces");
  std::string names;
  for (Index row = 0; row < specification_.surfaces.size(); ++row) {
    const TriangulatedSurface& s = specification_.surfaces[row];
    if (!pairs_[row].faces.empty() || !is_whole(row) || s.triangles.empty()) continue;
    missing.add(row, s.points[s.triangles[0][0]]);
    names += (names.empty() ? "" : ", ") + s.name;
  }
  missing.report(result, "surfaces that lie in the box have no face in the mesh: " + names);
}

/// Returns whether the mesher may have merged the point p of a border edge with another part of the border, or with
/// another patch of the fault.
bool TopologyChecker::may_be_joined(Index row, Index edge, const Vec3& p) const {
  const bool is_fault = specification_.surfaces[row].kind == SurfaceKind::fault;
  return borders_[row].faces_border(edge, p) || (is_fault && borders_[row].faces_other_piece(edge, p));
}

/// Returns whether the mesher may have merged parts of the surface's border with each other.
bool TopologyChecker::is_cracked(Index row) const {
  const InputBorder& border = borders_[row];
  for (Index e = 0; e < border.edges().size(); ++e) {
    const Corners& edge = border.edges()[e];
    if (border.is_crack(e) || std::any_of(between.begin(), between.end(), [&](double t) {
          return may_be_joined(row, e, edge[0] + t * (edge[1] - edge[0]));
        }))
      return true;
  }
  return false;
}

/// Checks that surfaces which nothing clips have the topology of their input. Surfaces are left out if parts of their
/// border are so close that they may have been merged, which changes the topology.
void TopologyChecker::check_whole_surfaces(CheckResult& result) {
  FaultCollector changed("surfaces_changed");
  std::string how;
  std::size_t n_checked = 0;
  for (Index row = 0; row < specification_.surfaces.size(); ++row) {
    if (!is_whole(row) || pairs_[row].faces.empty() || is_cracked(row)) continue;
    const Topology input = topology_of(welded(specification_.surfaces[row])), now = topology_of(faces_of(row));
    // A surface that meets itself is divided there in the mesh, so its topology differs.
    if (!input.manifold || !now.manifold) continue;
    ++n_checked;
    if (input == now) continue;
    changed.add(row, specification_.surfaces[row].points[specification_.surfaces[row].triangles[0][0]]);
    how += (how.empty() ? "" : "; ") + specification_.surfaces[row].name + ": " + words(now) + ", in the input " +
           words(input);
  }
  changed.report(result, "surfaces are not made of the pieces, borders and handles of their input (" + how + ")");
  result.checks_done.push_back(
      std::to_string(n_checked) + " of " + std::to_string(specification_.surfaces.size()) +
      " surfaces are clipped by nothing, have no cracks and do not meet themselves: their pieces, borders and Euler "
      "characteristic were held against the input's");
}

/// Returns whether a surface may end at the mesh edge e: at the box, a cutting body or, if rules trim it, any surface.
bool TopologyChecker::is_excused(const Edge& e, Index row) const {
  for (const Index f : edges_.at(e))
    for (const std::int32_t id : checked_.set_of(f)) {
      const Index other = checked_.surface_of(id);
      if (other == row) continue;
      if (checked_.is_box_side(id) ||
          (other != no_index &&
           (may_be_trimmed(row) || (specification_.surfaces[other].cuts_all && checked_.is_cut_kind(row)))))
        return true;
    }
  return false;
}

/// Returns whether a body that cuts the surface passes through p. Rules may have removed the body's own wall there.
bool TopologyChecker::was_cut_at(Index row, const Vec3& p) const {
  return checked_.is_cut_kind(row) &&
         std::any_of(checked_.bodies().begin(), checked_.bodies().end(), [&](const Body& body) {
           const auto of_body = static_cast<Index>(body.surface - specification_.surfaces.data());
           return body.surface->cuts_all && may_be_trimmed(of_body) && is_near(body, p, allowed_.both());
         });
}

std::vector<Corners> TopologyChecker::free_edges(Index row, bool but_excused) const {
  std::vector<Corners> free;
  for (const auto& [e, at] : edges_of(faces_of(row)))
    if (at.size() == 1 && !(but_excused && is_excused(e, row))) free.push_back(as_corners(e));
  return free;
}

/// Returns the triangles by which rules continued a surface; any of them may be missing at the mesh surface's border.
std::vector<Corners> TopologyChecker::continuation_of(Index row) const {
  std::vector<Corners> made;
  if (row >= specification_.trims.size() || !specification_.trims[row].continuation) return made;
  const TriangulatedSurface& s = specification_.surfaces[row];
  for (std::size_t t = specification_.trims[row].n_given_triangles; t < s.triangles.size(); ++t)
    made.push_back({s.points[s.triangles[t][0]], s.points[s.triangles[t][1]], s.points[s.triangles[t][2]]});
  return made;
}

void TopologyChecker::check_borders(CheckResult& result) {
  FaultCollector off("borders_off");
  for (Index row = 0; row < specification_.surfaces.size(); ++row) {
    const InputBorder& border = borders_[row];
    const TriangleSet input(border.edges()), mesh(free_edges(row, false));
    const TriangleSet partings(row < specification_.trims.size() ? specification_.trims[row].partings
                                                                 : std::vector<Corners>{});
    const TriangleSet continuation(continuation_of(row));
    const auto is_at = [&](const TriangleSet& set, const Vec3& p) { return !set.near(p, allowed_.both()).empty(); };
    for (const Corners& e : free_edges(row, true))
      for (const double t : between) {
        const Vec3 p = e[0] + t * (e[1] - e[0]);
        if (is_at(input, p) || is_at(partings, p) || is_at(continuation, p) || was_cut_at(row, p)) continue;
        off.add(row, p);
        break;
      }
    for (Index i = 0; i < border.edges().size(); ++i)
      for (const double t : between) {
        const Corners& e = border.edges()[i];
        const Vec3 p = e[0] + t * (e[1] - e[0]);
        if (border.is_crack(i) || may_be_trimmed(row) || !is_in_box(p, allowed_.both()) || is_at(mesh, p) ||
            may_be_joined(row, i, p) || checked_.is_removed(row, p, {}))
          continue;
        off.add(row, p);
        break;
      }
  }
  off.report(
      result,
      "edges where a surface ends, in the mesh or in the input, have no such edge of the other within the tolerance");
  if (off.count() == 0)
    result.checks_done.emplace_back(
        "surfaces end where their input ends (borders, fault tips), or where the box, a body or a rule ends them: "
        "sampled, both ways");
}

/// Returns the mesh edges at which the surfaces i and j meet, and the mesh faces that belong to both.
TriangleSet TopologyChecker::meeting_of(Index i, Index j) const {
  std::vector<Corners> shared;
  for (const auto& [e, at] : edges_) {
    const auto carries = [&, &at = at](Index row) {
      return std::any_of(at.begin(), at.end(), [&](Index f) { return checked_.carries(f, row); });
    };
    if (carries(i) && carries(j)) shared.push_back(as_corners(e));
  }
  for (const Index f : pairs_[i].faces)
    if (checked_.carries(f, j)) shared.push_back(checking::corners_of(checked_, f));
  return TriangleSet(std::move(shared));
}

/// Returns whether an intersection of two input surfaces is missing in the mesh: the surfaces pass through each other
/// at the given point, each deeper than the allowed distance, but do not meet nearby in the mesh. Both may have been
/// moved: where they are closer than the allowed distance, their curve may be anywhere in between.
bool TopologyChecker::is_lost(const Passage& passage, const TriangleSet& meeting) const {
  const Vec3 &place = passage.place, &along = passage.along;
  bool is_met = false;
  const auto passes = [&](Index surface, Index triangle, Index other) {
    const AlongLine line{[&](const Vec3& p) { return !is_in_box(p, 0) || checked_.is_removed(surface, p, {}, other); },
                         [&](const Vec3& p) { is_met = is_met || !meeting.near(p, allowed_.both()).empty(); }};
    return passes_through(followed_[surface], triangle, {place, along}, followed_[other], allowed_.both(), line);
  };
  return passes(passage.i, passage.s, passage.j) && passes(passage.j, passage.t, passage.i) && !is_met;
}

/// Checks that surfaces i and j meet in the mesh near every point where their input triangles pass through each other.
/// This is not required if they pass through by less than the allowed distance, or if they only touch: horizons that
/// end on both sides of a fault touch at a point, up to rounding.
void TopologyChecker::check_crossings(Index i, Index j, FaultCollector& off, Places& places) {
  const FollowedSurface &a = followed_[i], &b = followed_[j];
  const TriangleSet meeting = meeting_of(i, j);
  const auto is_due = [&](const Vec3& p) {
    return is_in_box(p, allowed_.both()) && !checked_.is_removed(i, p, {}, j) && !checked_.is_removed(j, p, {}, i);
  };
  for (Index k = 0; k < a.triangles().size(); ++k) {
    const Corners& s = a.triangles()[k];
    b.tree().query(box_of(s[0], s[1], s[2]), [&](Index row) {
      const auto crossing = crossing_of(s, b.triangles()[row]);
      if (!crossing) return;
      const auto& [from, to] = *crossing;
      // The two triangles meet in a single point, up to rounding.
      if (dot(to - from, to - from) <= allowed_.rounding * allowed_.rounding) return;
      for (const double at : between) {
        const Vec3 p = from + at * (to - from);
        ++places.looked_at;
        if (!meeting.near(p, allowed_.both()).empty() || !is_due(p)) continue;
        ++places.farther;
        if (!is_lost({i, j, k, row, p, to - from}, meeting)) continue;
        off.add(row, p);
        return;
      }
    });
  }
}

void TopologyChecker::check_curves(CheckResult& result) {
  FaultCollector off("curves_off");
  Places places;
  for (const TriangulatedSurface& surface : specification_.surfaces) followed_.emplace_back(surface);
  for (Index i = 0; i < specification_.surfaces.size(); ++i)
    for (Index j = i + 1; j < specification_.surfaces.size(); ++j)
      if (!may_be_trimmed(i) && !may_be_trimmed(j)) check_crossings(i, j, off, places);
  off.report(result,
             "places where input surfaces pass through each other deeper than the tolerance, and do not meet in the "
             "mesh within it");
  if (off.count() == 0)
    result.checks_done.push_back(
        "surfaces that no rule trims meet where their inputs cross: " + std::to_string(places.looked_at) +
        " places sampled; at " + std::to_string(places.farther) +
        " they are too near to each other for one place of the curve, or pass no deeper than the tolerance");
}

}  // namespace

void check_surface_topology(const CheckedFaces& checked, const Allowed& allowed, CheckResult& result) {
  TopologyChecker checker(checked, allowed);
  checker.check_presence(result);
  checker.check_whole_surfaces(result);
  checker.check_borders(result);
  checker.check_curves(result);
}

}  // namespace geomesh::geomodel::checking
