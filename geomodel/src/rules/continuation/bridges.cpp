// SPDX-License-Identifier: GPL-3.0-or-later
#include "rules/continuation/bridges.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "common/union_find.hpp"
#include "geomesh/core/predicates.hpp"
#include "naming/sums.hpp"
#include "rules/planar/borders.hpp"
#include "rules/planar/planar_fill.hpp"
#include "rules/throw/sheet_sides.hpp"

namespace geomesh::geomodel {
namespace {

using Corners = std::array<Index, 3>;

double circumradius(const Vec2& a, const Vec2& b, const Vec2& c) {
  const double u = std::hypot(b.x - a.x, b.y - a.y), v = std::hypot(c.x - b.x, c.y - b.y),
               w = std::hypot(a.x - c.x, a.y - c.y);
  const double area2 = std::abs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
  return area2 > 0 ? u * v * w / (2 * area2) : std::numeric_limits<double>::infinity();
}

/// Returns the side of an obtuse triangle beyond which its circumcentre lies, identified by the corner at which the
/// side begins; nothing for other triangles.
std::optional<std::size_t> side_before_centre(const std::array<Vec2, 3>& t) {
  const auto length = [&](std::size_t i) { return std::hypot(t[(i + 1) % 3].x - t[i].x, t[(i + 1) % 3].y - t[i].y); };
  for (std::size_t i = 0; i < 3; ++i)
    if (std::hypot(length((i + 1) % 3), length((i + 2) % 3)) < length(i)) return i;
  return std::nullopt;
}

/// Returns the point at which the segment from p to q meets the triangle, including its border.
std::optional<Vec3> piercing(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Sign from = orient3d(a, b, c, p), to = orient3d(a, b, c, q);
  if (from == to || from == Sign::zero || to == Sign::zero) return std::nullopt;
  const Sign s0 = orient3d(p, q, a, b), s1 = orient3d(p, q, b, c), s2 = orient3d(p, q, c, a);
  const bool any_left = s0 == Sign::positive || s1 == Sign::positive || s2 == Sign::positive;
  const bool any_right = s0 == Sign::negative || s1 == Sign::negative || s2 == Sign::negative;
  if (any_left == any_right) return std::nullopt;
  const Vec3 n = cross(b - a, c - a);
  const double d = dot(p - a, n), e = dot(q - a, n);
  return p + (d / (d - e)) * (q - p);
}

/// The border of (a part of) a surface projected along a direction, and the triangles in the gaps between borders.
class Gaps {
 public:
  Gaps(const TriangulatedSurface& surface, const std::vector<BorderEdge>& edges, const Frame& frame)
      : surface_(surface), frame_(frame) {
    std::map<VertexIndex, Index> index;
    const auto row = [&](VertexIndex v) {
      const auto [at, is_new] = index.emplace(v, static_cast<Index>(rows_.size()));
      if (is_new) {
        rows_.push_back(v);
        points_.push_back(surface.points[v]);
      }
      return at->second;
    };
    for (const BorderEdge& e : edges) {
      const Index a = row(e.a), b = row(e.b);
      constraints_.emplace_back(a, b);
      is_border_.insert({std::min(a, b), std::max(a, b)});
    }
  }

  /// Triangulates the gaps between the surface's borders. Returns false if the border crosses itself in the projection.
  bool find(const GapSetting& setting) {
    const auto& [within, box, holes_alone] = std::tie(setting.within, setting.box, setting.holes_alone);
    std::vector<Vec2> places;
    for (const Vec3& p : points_) places.push_back(in_frame(p));
    const auto all = triangulate_plane(places, constraints_);
    if (!all) return false;
    gaps_.clear();
    for (const PlanarTriangle& t : *all) {
      const auto& v = t.vertices;
      const std::array<Vec2, 3> corners{places[v[0]], places[v[1]], places[v[2]]};
      if (t.depth % 2 != 0 || (holes_alone && t.depth == 0)) continue;
      if (circumradius(corners[0], corners[1], corners[2]) > within) {
        // A triangle with a large circumscribed disc spans a wide gap and is left out, unless the disc's centre lies
        // beyond a border edge, inside the surface.
        const auto side = side_before_centre(corners);
        if (!side || !is_border_.contains(std::minmax(v[*side], v[(*side + 1) % 3]))) continue;
      }
      Box3 own;
      for (const Index i : v) own.add(points_[i]);
      const bool is_in_box = own.max.x > box.min.x && own.min.x < box.max.x && own.max.y > box.min.y &&
                             own.min.y < box.max.y && own.max.z > box.min.z && own.min.z < box.max.z;
      if (is_in_box) gaps_.push_back(v);
    }
    return true;
  }

  /// Adds points where fault tips pierce the triangles in the gaps. Returns false if there are none.
  bool add_tips(const std::vector<FaultTip>& tips) {
    std::vector<Box3> boxes;
    for (const Corners& t : gaps_) {
      Box3& box = boxes.emplace_back();
      for (const Index i : t) box.add(points_[i]);
    }
    if (boxes.empty()) return false;
    const arrangement::BoxTree tree(boxes);
    std::vector<Vec3> found;
    for (const FaultTip& tip : tips) {
      Box3 way;
      for (const Vec3& p : tip.ends) way.add(p);
      tree.boxes_meeting(way, [&](Index k) {
        const Corners& t = gaps_[k];
        const auto p = piercing(tip.ends[0], tip.ends[1], points_[t[0]], points_[t[1]], points_[t[2]]);
        if (p && !is_on_border(t, *p)) found.push_back(*p);
      });
    }
    std::sort(found.begin(), found.end(), [](const Vec3& a, const Vec3& b) { return compare_lexicographic(a, b) < 0; });
    const auto same_place = [&](const Vec3& a, const Vec3& b) {
      const Vec2 p = in_frame(a), q = in_frame(b);
      return p.x == q.x && p.y == q.y;
    };
    found.erase(std::unique(found.begin(), found.end(), same_place), found.end());
    points_.insert(points_.end(), found.begin(), found.end());
    return !found.empty();
  }

  void append(TriangulatedSurface& to, const Walls& walls, const std::function<bool(const Vec3&)>& counts) const {
    std::vector<VertexIndex> row(points_.size(), no_vertex);
    std::copy(rows_.begin(), rows_.end(), row.begin());
    for (const Corners& t : gaps_) {
      const Vec3 centre = (1.0 / 3) * (points_[t[0]] + points_[t[1]] + points_[t[2]]);
      if (!counts(centre) || crosses_wall(t, walls)) continue;
      Triangle own;
      for (std::size_t i = 0; i < 3; ++i) {
        if (row[t[i]] == no_vertex) {
          row[t[i]] = static_cast<VertexIndex>(to.points.size());
          to.points.push_back(points_[t[i]]);
        }
        own[i] = row[t[i]];
      }
      if (!faces_up_) std::swap(own[1], own[2]);
      to.triangles.push_back(own);
    }
  }

  void set_faces_up(bool up) { faces_up_ = up; }

 private:
  /// Returns whether the point p lies on a corner of a gap triangle, or on a side that is part of the projected border.
  bool is_on_border(const Corners& t, const Vec3& p) const {
    for (std::size_t i = 0; i < 3; ++i) {
      const Index a = t[i], b = t[(i + 1) % 3];
      const Vec2 from = in_frame(points_[a]), to = in_frame(points_[b]), place = in_frame(p);
      if (orient2d(from, to, place) != Sign::zero) continue;
      if ((place.x == from.x && place.y == from.y) || (place.x == to.x && place.y == to.y)) return true;
      if (is_border_.contains({std::min(a, b), std::max(a, b)})) return true;
    }
    return false;
  }

  /// Returns whether a wall (bounding surface) divides the triangle. A wall that passes through a side that is part of
  /// the border does not count: the original surface continues across that wall there, and so does the triangle.
  bool crosses_wall(const Corners& t, const Walls& walls) const {
    std::set<Index> parting, run_across;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 &a = points_[t[i]], &b = points_[t[(i + 1) % 3]];
      // Edges are tested a little shortened, because their ends may be the tip of a bounding surface.
      const Vec3 from = a + 1e-6 * (b - a), to = b + 1e-6 * (a - b);
      const bool is_border = is_border_.contains(std::minmax(t[i], t[(i + 1) % 3]));
      for (const Index s : walls.surfaces_on(from, to)) (is_border ? run_across : parting).insert(s);
    }
    return !std::includes(run_across.begin(), run_across.end(), parting.begin(), parting.end());
  }

  Vec2 in_frame(const Vec3& p) const {
    const Vec3 q = frame_.to_frame(p);
    return {q.x, q.y};
  }

  const TriangulatedSurface& surface_;
  Frame frame_;
  std::vector<VertexIndex> rows_;
  std::vector<Vec3> points_;  ///< points of the surface's border, followed by fault tips
  std::vector<std::pair<Index, Index>> constraints_;
  std::set<std::pair<Index, Index>> is_border_;
  std::vector<Corners> gaps_;
  bool faces_up_ = true;
};

/// Fills gaps between a surface's border edges in one projection. Returns false, without change, if edges cross there.
bool bridge(TriangulatedSurface& surface, const std::vector<BorderEdge>& edges, const Frame& frame,
            const GapSetting& setting) {
  Gaps gaps(surface, edges, frame);
  gaps.set_faces_up(faces_up(surface, frame));
  if (!gaps.find(setting)) return false;
  if (gaps.add_tips(setting.tips) && !gaps.find(setting)) return false;
  gaps.append(surface, setting.walls, setting.counts);
  return true;
}

/// The surfaces that a vertical line through a point meets above and below it.
struct SurfacesAt {
  std::vector<Index> above, below;  // ascending

  SurfacesAt(const Vec3& p, const Walls& walls, const Box3& all)
      : above(walls.surfaces_on(p, {p.x, p.y, all.max.z})), below(walls.surfaces_on(p, {p.x, p.y, all.min.z})) {}
  const std::vector<Index>& on(bool is_above) const { return is_above ? above : below; }
};

/// Returns the surfaces that lie above (or below) some of the places, and on the other side of none of them.
std::set<Index> on_one_side(const std::vector<SurfacesAt>& places, bool is_above) {
  std::set<Index> found, elsewhere;
  for (const SurfacesAt& at : places) {
    found.insert(at.on(is_above).begin(), at.on(is_above).end());
    elsewhere.insert(at.on(!is_above).begin(), at.on(!is_above).end());
  }
  for (const Index s : elsewhere) found.erase(s);
  return found;
}

Vec3 centroid(const TriangulatedSurface& s, const Triangle& t) {
  return (1.0 / 3) * (s.points[t[0]] + s.points[t[1]] + s.points[t[2]]);
}

std::set<Index> met_by(const TriangulatedSurface& s, const Triangle& t, const Walls& walls) {
  std::set<Index> met;
  for (std::size_t i = 0; i < 3; ++i)
    for (const Index k : walls.surfaces_on(s.points[t[i]], s.points[t[(i + 1) % 3]])) met.insert(k);
  return met;
}

/// A hole: the vertices of its border, and the triangles that fill it.
struct FilledHole {
  std::set<VertexIndex> border;
  std::vector<Triangle> triangles;
};

/// Returns for each triangle that fills the hole whether another horizon pierces the hole and the triangle lies beyond
/// it, so that it must be removed again.
std::vector<bool> beyond_piercing(const TriangulatedSurface& s, const FilledHole& hole, Index row, const Walls& walls,
                                  const Box3& all) {
  std::vector<SurfacesAt> border, inside;
  for (const VertexIndex v : hole.border) border.emplace_back(s.points[v], walls, all);
  for (const Triangle& t : hole.triangles) inside.emplace_back(centroid(s, t), walls, all);
  std::vector<bool> is_beyond(inside.size(), false);
  for (const bool is_above : {false, true}) {
    const std::set<Index> beside = on_one_side(border, is_above);
    std::set<Index> piercing;
    for (const SurfacesAt& at : inside)
      for (const Index k : at.on(!is_above))
        if (k != row && beside.contains(k)) piercing.insert(k);
    const auto pierces = [&](Index k) { return piercing.contains(k); };
    for (std::size_t t = 0; t < inside.size(); ++t)
      is_beyond[t] = is_beyond[t] || std::ranges::any_of(inside[t].on(!is_above), pierces) ||
                     std::ranges::any_of(met_by(s, hole.triangles[t], walls), pierces);
  }
  return is_beyond;
}

}  // namespace

void open_where_pierced(TriangulatedSurface& horizon, Index row, Index first, const Walls& walls, const Box3& model) {
  Box3 all = model;
  for (const Vec3& p : horizon.points) all.add(p);
  const std::vector<Triangle> filled(horizon.triangles.begin() + first, horizon.triangles.end());
  horizon.triangles.resize(first);
  const std::vector<BorderEdge> edges = border_edges(horizon);
  UnionFind loops(horizon.points.size());
  for (const BorderEdge& e : edges) loops.unite(e.a, e.b);
  std::map<Index, FilledHole> holes;  // filled holes of the horizon, by the border loop around each
  for (const Triangle& t : filled) holes[loops.find(t[0])].triangles.push_back(t);
  for (const BorderEdge& e : edges)
    if (const auto hole = holes.find(loops.find(e.a)); hole != holes.end()) hole->second.border.insert(e.a);
  for (const auto& [_, hole] : holes) {
    const std::vector<bool> is_beyond = beyond_piercing(horizon, hole, row, walls, all);
    for (std::size_t t = 0; t < is_beyond.size(); ++t)
      if (!is_beyond[t]) horizon.triangles.push_back(hole.triangles[t]);
  }
}

std::vector<Frame> frames_along(const TriangulatedSurface& surface, const std::vector<FaultTip>& tips) {
  Box3 box;
  for (const Vec3& p : surface.points) box.add(p);
  std::map<Index, Vec3> normals;
  for (const FaultTip& tip : tips) {
    if (std::max(tip.ends[0].z, tip.ends[1].z) < box.min.z || std::min(tip.ends[0].z, tip.ends[1].z) > box.max.z)
      continue;
    const auto [at, is_new] = normals.emplace(tip.fault, tip.normal);
    if (!is_new) at->second = at->second + (dot(at->second, tip.normal) < 0 ? -1.0 : 1.0) * tip.normal;
  }
  std::vector<Frame> frames{frame_of(surface)};
  for (const auto& [_, n] : normals) {
    const Vec3 up_dip{-n.x * n.z, -n.y * n.z, n.x * n.x + n.y * n.y};
    if (up_dip.z > 0) frames.push_back(frame_of_normal(box.min, up_dip));
  }
  return frames;
}

void bridge_gaps(TriangulatedSurface& surface, const GapSetting& setting) {
  const std::vector<BorderEdge> edges = border_edges(surface);
  if (edges.empty()) return;
  for (const Frame& frame : setting.frames)
    if (bridge(surface, edges, frame, setting)) return;
  const std::vector<Index> sheet =
      sheets_of(surface.triangles.size(), neighbours_in(surface), [](Index, Index) { return true; });
  std::map<Index, std::vector<BorderEdge>> edges_of;
  for (const BorderEdge& e : edges) edges_of[sheet[e.triangle]].push_back(e);
  for (const auto& [_, own] : edges_of) bridge(surface, own, setting.frames.front(), setting);
}

}  // namespace geomesh::geomodel
