// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "corpus_judge_parts.hpp"

namespace geomesh::test {

namespace {

using DirectedEdge = std::array<VertexIndex, 2>;
using EdgeSet = std::set<DirectedEdge>;

double length(const Vec3& v) { return std::sqrt(dot(v, v)); }

/// Looks for a chain of `edges` from a to b through added points of the segment a-b, in order along it; removes it
/// where found.
class ChainFinder {
 public:
  ChainFinder(const Judgement& j, const Vec3& a, const Vec3& b) : j_(j), a_(a), b_(b) {}

  bool take(EdgeSet& edges, VertexIndex from, VertexIndex to) {
    chain_.clear();
    if (!extend(edges, from, to, 0)) return false;
    for (const DirectedEdge& e : chain_) edges.erase(e);
    return true;
  }

 private:
  bool extend(const EdgeSet& edges, VertexIndex from, VertexIndex to, double parameter) {
    for (auto it = edges.lower_bound({from, 0}); it != edges.end() && (*it)[0] == from; ++it) {
      const VertexIndex next = (*it)[1];
      chain_.push_back(*it);
      if (next == to) return true;
      if (j_.mesh.origin[next] == VertexOrigin::on_segment &&
          distance_from_line(j_.point(next), a_, b_) <= added_point_ulps * j_.ulp) {
        const double t = parameter_on_line(j_.point(next), a_, b_);
        if (t > parameter && t < 1 && extend(edges, next, to, t)) return true;
      }
      chain_.pop_back();
    }
    return false;
  }

  const Judgement& j_;
  const Vec3 a_, b_;
  std::vector<DirectedEdge> chain_;
};

class FacetJudge {
 public:
  explicit FacetJudge(Judgement& j) : j_(j), row_(j.plc.points.size(), no_vertex), faces_(j.plc.n_facets()) {
    for (VertexIndex v = 0; v < j.mesh.points.size(); ++v)
      if (!j.is_added(v) && j.mesh.input_vertex[v] < row_.size()) row_[j.mesh.input_vertex[v]] = v;
    for (Index i = 0; i < j.mesh.faces.size(); ++i) faces_[j.mesh.faces[i].facet].push_back(i);
    for (const auto& s : j.plc.facet_segments) inner_[s.facet].push_back({s.a, s.b});
    for (const auto& p : j.plc.facet_points) points_[p.facet].push_back(p.v);
  }

  void run() {
    judge_cells_of_faces();
    std::vector<bool> is_done(j_.plc.n_facets(), false);
    for (const std::vector<Index>& group : coplanar_groups(j_.plc)) {
      const auto alone = [&](Index f) { return faces_[f].empty() || stands_alone(f); };
      if (std::all_of(group.begin(), group.end(), alone)) continue;
      judge_group(group);
      for (const Index f : group) is_done[f] = true;
    }
    for (Index f = 0; f < j_.plc.n_facets(); ++f)
      if (!is_done[f] && !faces_[f].empty()) judge_facet(f);
  }

 private:
  void fault(Index facet, const std::string& text) {
    j_.fault("facets", "facet " + std::to_string(facet) + " " + text);
  }

  void judge_cells_of_faces() {
    for (std::size_t i = 1; i < j_.facet_faces.size(); ++i)
      if (j_.facet_faces[i - 1].sorted == j_.facet_faces[i].sorted)
        fault(j_.facet_faces[i].facet, "has a face that is listed twice");
    for (const auto& f : j_.mesh.faces) {
      const Triangle reversed{f.vertices[0], f.vertices[2], f.vertices[1]};
      if (j_.cell_above(f.vertices) != f.tetrahedron_above || j_.cell_above(reversed) != f.tetrahedron_below)
        fault(f.facet, "has a face that names the wrong cells");
      if (f.tetrahedron_above == no_index && f.tetrahedron_below == no_index)
        fault(f.facet, "has a face that borders no cell");
      for (VertexIndex v : f.vertices)
        if (j_.is_added(v) && j_.mesh.origin[v] == VertexOrigin::inside)
          fault(f.facet, "has a vertex that claims to be inside a region");
    }
  }

  void judge_facet(Index f) {
    EdgeSet all;
    for (Index i : faces_[f]) {
      const Triangle& t = j_.mesh.faces[i].vertices;
      for (int k = 0; k < 3; ++k)
        if (!all.insert({t[k], t[(k + 1) % 3]}).second) fault(f, "has two faces on the same side of an edge");
    }
    EdgeSet border;
    for (const DirectedEdge& e : all)
      if (!all.count({e[1], e[0]})) border.insert(e);
    const bool whole = judge_border(f, border);
    if (whole) judge_inner_items(f, all);
    judge_added_points(f);
    if (whole) judge_area(f);
  }

  /// Whether the facet's own faces cover it alone.
  bool stands_alone(Index f) {
    EdgeSet border;
    for (const Index i : faces_[f]) add_to_border(border, j_.mesh.faces[i].vertices);
    const auto loop = j_.plc.outer_loop(f);
    for (std::size_t i = 0; i < loop.size(); ++i)
      if (!take(border, loop[i], loop[(i + 1) % loop.size()])) return false;
    return border.empty();
  }

  /// Coplanar triangles that were meshed as one polygon: their faces cover them together, and each face names the
  /// triangle that has its centroid.
  void judge_group(const std::vector<Index>& group) {
    const Vec3 normal = normal_of(group.front());
    EdgeSet border, due;
    double area = 0, area_due = 0;
    for (const Index f : group) {
      const auto loop = j_.plc.outer_loop(f);
      const bool turned = dot(normal_of(f), normal) < 0;
      add_to_border(due, turned ? Triangle{loop[0], loop[2], loop[1]} : Triangle{loop[0], loop[1], loop[2]});
      area_due += length(normal_of(f));
      for (const Index i : faces_[f]) {
        const Triangle& t = j_.mesh.faces[i].vertices;
        add_to_border(border, turned ? Triangle{t[0], t[2], t[1]} : t);
        area += length(cross(j_.point(t[1]) - j_.point(t[0]), j_.point(t[2]) - j_.point(t[0])));
        if (!holds(f, (1.0 / 3) * (j_.point(t[0]) + j_.point(t[1]) + j_.point(t[2]))))
          fault(f, "does not hold the centroid of a face that names it");
      }
      judge_added_points(f);
    }
    for (const DirectedEdge& e : due)
      if (!take(border, e[0], e[1])) return fault(group.front(), "and its coplanar neighbours are not covered");
    if (!border.empty()) fault(group.front(), "and its coplanar neighbours have faces beyond them");
    if (std::fabs(area - area_due) > 1e-9 * area_due) fault(group.front(), "and its coplanar neighbours are folded");
  }
  static void add_to_border(EdgeSet& border, const Triangle& t) {
    for (unsigned k = 0; k < 3; ++k)
      if (!border.erase({t[(k + 1) % 3], t[k]})) border.insert({t[k], t[(k + 1) % 3]});
  }
  /// Of a triangle; its length is twice the area.
  Vec3 normal_of(Index f) const {
    const auto loop = j_.plc.outer_loop(f);
    const auto& p = j_.plc.points;
    return cross(p[loop[1]] - p[loop[0]], p[loop[2]] - p[loop[0]]);
  }
  /// Up to rounding.
  bool holds(Index f, const Vec3& x) const {
    const auto loop = j_.plc.outer_loop(f);
    const Vec3 n = normal_of(f);
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 &a = j_.plc.points[loop[i]], &b = j_.plc.points[loop[(i + 1) % 3]];
      if (dot(cross(b - a, x - a), n) < -1e-9 * length(b - a) * length(n) * (length(x - a) + length(b - a)))
        return false;
    }
    return true;
  }

  /// True where the facet is covered wholly.
  bool judge_border(Index f, EdgeSet& border) {
    bool whole = true;
    for (Index l = j_.plc.facet_loops[f]; l < j_.plc.facet_loops[f + 1]; ++l) {
      const auto loop = j_.plc.loop(l);
      const bool outer = l == j_.plc.facet_loops[f];
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const VertexIndex a = loop[i], b = loop[(i + 1) % loop.size()];
        if (!take(border, a, b) && (outer || !take(border, b, a))) whole = false;
      }
    }
    const auto inner = inner_.find(f);
    if (!whole && inner == inner_.end()) fault(f, "is not covered up to its border");
    if (!whole && inner != inner_.end())
      for (const DirectedEdge& s : inner->second) take(border, s[0], s[1]) || take(border, s[1], s[0]);
    if (!border.empty()) fault(f, "has faces that end inside it or beyond it");
    return whole;
  }
  bool take(EdgeSet& edges, VertexIndex a, VertexIndex b) {
    if (row_[a] == no_vertex || row_[b] == no_vertex) return false;
    return ChainFinder(j_, j_.plc.points[a], j_.plc.points[b]).take(edges, row_[a], row_[b]);
  }

  void judge_inner_items(Index f, const EdgeSet& all) {
    if (const auto it = inner_.find(f); it != inner_.end())
      for (const DirectedEdge& s : it->second) {
        EdgeSet copy = all;
        if (!take(copy, s[0], s[1])) fault(f, "lacks an inner segment");
      }
    if (const auto it = points_.find(f); it != points_.end())
      for (VertexIndex p : it->second) {
        const VertexIndex v = row_[p];
        const auto edge = all.lower_bound({v, 0});
        if (v == no_vertex || edge == all.end() || (*edge)[0] != v) fault(f, "lacks an inner point");
      }
  }

  void judge_added_points(Index f) {
    if (!is_exactly_planar(j_.plc, f)) return;
    const auto c = plane_corners(j_.plc, f);
    std::set<VertexIndex> added;
    for (Index i : faces_[f])
      for (VertexIndex v : j_.mesh.faces[i].vertices)
        if (j_.is_added(v)) added.insert(v);
    for (VertexIndex v : added) {
      const double off =
          distance_from_plane(j_.point(v), j_.plc.points[c[0]], j_.plc.points[c[1]], j_.plc.points[c[2]]);
      if (off > added_point_ulps * j_.ulp)
        fault(f, "has the added point " + std::to_string(v) + " off its plane by " + std::to_string(off / j_.ulp) +
                     " ulps");
    }
  }

  /// With the right border, areas that add up mean that no face is folded over.
  void judge_area(Index f) {
    double area = 0, perimeter = 0;
    Vec3 vector_area;
    for (Index i : faces_[f]) {
      const Triangle& t = j_.mesh.faces[i].vertices;
      const Vec3 u = j_.point(t[1]) - j_.point(t[0]), v = j_.point(t[2]) - j_.point(t[0]), n = 0.5 * cross(u, v);
      area += length(n);
      vector_area = vector_area + n;
      perimeter += length(u) + length(v) + length(v - u);
    }
    const bool planar = is_exactly_planar(j_.plc, f);
    if (planar && area - length(vector_area) > 1e-12 * area + 8 * j_.ulp * perimeter) fault(f, "is folded");
  }

  Judgement& j_;
  std::vector<VertexIndex> row_;
  std::vector<std::vector<Index>> faces_;
  std::map<Index, std::vector<DirectedEdge>> inner_;
  std::map<Index, std::vector<VertexIndex>> points_;
};

}  // namespace

void judge_facets(Judgement& j) { FacetJudge(j).run(); }

void judge_segments(Judgement& j) {
  if (j.plc.segments.empty()) return;
  EdgeSet of_cells;
  for (const Tetrahedron& t : j.mesh.tetrahedra)
    for (VertexIndex a : t)
      for (VertexIndex b : t)
        if (a != b) of_cells.insert({a, b});
  std::vector<VertexIndex> row(j.plc.points.size(), no_vertex);
  for (VertexIndex v = 0; v < j.mesh.points.size(); ++v)
    if (!j.is_added(v)) row[j.mesh.input_vertex[v]] = v;
  std::vector<EdgeSet> edges(j.plc.segments.size());
  for (const auto& e : j.mesh.edges) {
    if (e.segment >= edges.size()) return j.fault("segments", "an edge names a segment that does not exist");
    if (!of_cells.count({e.a, e.b}))
      j.fault("segments", "an edge of segment " + std::to_string(e.segment) + " is in no cell");
    if (edges[e.segment].count({e.a, e.b}))
      j.fault("segments", "an edge of segment " + std::to_string(e.segment) + " is listed twice");
    edges[e.segment].insert({e.a, e.b});
    edges[e.segment].insert({e.b, e.a});
  }
  for (Index s = 0; s < edges.size(); ++s) {
    const VertexIndex a = j.plc.segments[s].a, b = j.plc.segments[s].b;
    const std::size_t n = edges[s].size() / 2;
    const bool both_ends = row[a] != no_vertex && row[b] != no_vertex;
    if (n == 0 && !(both_ends && of_cells.count({row[a], row[b]}))) continue;  // outside what is kept
    if (!both_ends) {
      j.fault("segments", "segment " + std::to_string(s) + " has edges but not both ends");
      continue;
    }
    EdgeSet rest = edges[s];
    if (!ChainFinder(j, j.plc.points[a], j.plc.points[b]).take(rest, row[a], row[b]) || rest.size() != n)
      j.fault("segments", "segment " + std::to_string(s) + " is not a chain of edges");
  }
}

}  // namespace geomesh::test
