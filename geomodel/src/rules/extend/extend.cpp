// SPDX-License-Identifier: GPL-3.0-or-later
#include "rules/extend/extend.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "naming/region_facts.hpp"
#include "naming/sums.hpp"
#include "rules/planar/borders.hpp"
#include "rules/planar/nearest_place.hpp"
#include "rules/planar/planar_fill.hpp"

namespace geomesh::geomodel {

namespace {

constexpr int n_grid = 24;             // number of points added along the longer side of the extended area
constexpr double margin = 0.05;        // distance beyond the box to which the surface is extended, in box diagonals
constexpr double slope_radius = 0.05;  // radius for the mean slope near a border point, in surface diagonals

/// The surface's border projected to a frame: distinct points and the edges between them.
struct PlanarBorder {
  std::vector<BorderEdge> edges;
  std::vector<VertexIndex> row;  ///< for each border point in the plane: its index in the surface
  std::vector<Vec3> in_frame;    ///< parallel
  std::vector<std::pair<Index, Index>> constraints;
  std::vector<Vec2> planar() const {
    std::vector<Vec2> points;
    for (const Vec3& p : in_frame) points.push_back({p.x, p.y});
    return points;
  }
};

PlanarBorder planar_border(const TriangulatedSurface& s, const Frame& frame) {
  PlanarBorder border;
  border.edges = border_edges(s);
  std::map<VertexIndex, Index> index;
  const auto planar_row = [&](VertexIndex v) {
    const auto [at, is_new] = index.emplace(v, static_cast<Index>(border.row.size()));
    if (is_new) {
      border.row.push_back(v);
      border.in_frame.push_back(frame.to_frame(s.points[v]));
    }
    return at->second;
  };
  for (const BorderEdge& e : border.edges) {
    const Index a = planar_row(e.a), b = planar_row(e.b);
    border.constraints.emplace_back(a, b);
  }
  return border;
}

void warn_crossing(const TriangulatedSurface& s, const char* rule, const BuildLog& log) {
  log.warnings.push_back("surface " + s.name + ": " + rule + " not applied: its border crosses itself " +
                         (s.kind == SurfaceKind::horizon ? "in the map" : "in the mean plane"));
}

/// The nearest point of the border to a point of the plane: the edge and the parameter on it.
struct Nearest {
  std::size_t edge = 0;
  double t = 0, distance2 = std::numeric_limits<double>::infinity();
};
Nearest nearest_on_border(const PlanarBorder& border, double x, double y) {
  Nearest best;
  for (std::size_t e = 0; e < border.constraints.size(); ++e) {
    const Vec3 &a = border.in_frame[border.constraints[e].first], &b = border.in_frame[border.constraints[e].second];
    const double dx = b.x - a.x, dy = b.y - a.y, l2 = dx * dx + dy * dy;
    const double t = l2 > 0 ? std::clamp(((x - a.x) * dx + (y - a.y) * dy) / l2, 0.0, 1.0) : 0.0;
    const double ex = x - (a.x + t * dx), ey = y - (a.y + t * dy), d2 = ex * ex + ey * ey;
    if (d2 < best.distance2) best = {e, t, d2};
  }
  return best;
}

/// Computes heights beyond the border of a surface by the chosen rule (Extend).
class Continuation {
 public:
  Continuation(const TriangulatedSurface& s, const Frame& frame, const PlanarBorder& border, Extend how)
      : border_(border), how_(how), slopes_(border.constraints.size()) {
    Box3 box;
    for (const Triangle& t : s.triangles) {
      std::array<Vec3, 3> p;
      for (std::size_t i = 0; i < 3; ++i) {
        p[i] = frame.to_frame(s.points[t[i]]);
        vertices_.push_back(p[i]);
        box.add(p[i]);
      }
      Vec3 n = cross(p[1] - p[0], p[2] - p[0]);
      if (n.z < 0) n = -1.0 * n;
      centres_.push_back((1.0 / 3) * (p[0] + p[1] + p[2]));
      normals_.push_back(n);
    }
    radius_ = slope_radius * norm(box.max - box.min);
  }
  double height(double x, double y, const Nearest& at) {
    if (how_ == Extend::nearest) return nearest_vertex_height(x, y);
    const Vec3 &a = border_.in_frame[border_.constraints[at.edge].first],
               &b = border_.in_frame[border_.constraints[at.edge].second];
    const Vec3 foot = a + at.t * (b - a);
    if (how_ == Extend::flat) return foot.z;
    const Vec2 slope = slope_at(at.edge);
    return foot.z + slope.x * (x - foot.x) + slope.y * (y - foot.y);
  }

 private:
  double nearest_vertex_height(double x, double y) {
    if (!nearest_) nearest_.emplace(vertices_);
    return vertices_[nearest_->find(x, y)].z;
  }
  /// Returns the slope of the mean normal of triangles near a border edge's midpoint; zero if too steep to extrapolate.
  Vec2 slope_at(std::size_t edge) {
    if (slopes_[edge]) return *slopes_[edge];
    const Vec3 middle =
        0.5 * (border_.in_frame[border_.constraints[edge].first] + border_.in_frame[border_.constraints[edge].second]);
    Vec3 sum = normals_[border_.edges[edge].triangle];
    for (std::size_t t = 0; t < centres_.size(); ++t)
      if (std::hypot(centres_[t].x - middle.x, centres_[t].y - middle.y) < radius_) sum = sum + normals_[t];
    Vec2 slope{0, 0};
    if (sum.z > 0 && std::hypot(sum.x, sum.y) <= steepest_slope * sum.z) slope = {-sum.x / sum.z, -sum.y / sum.z};
    slopes_[edge] = slope;
    return slope;
  }

  const PlanarBorder& border_;
  Extend how_;
  std::vector<std::optional<Vec2>> slopes_;
  std::vector<Vec3> vertices_, centres_, normals_;
  std::optional<NearestPlace> nearest_;  ///< of the vertices
  double radius_;
};

/// Returns a rectangle in the frame that contains the box and the surface, with a margin.
Box3 extended_area(const TriangulatedSurface& s, const Frame& frame, const Box3& box, Index rim) {
  Box3 area;
  for (int corner = 0; corner < 8; ++corner)
    area.add(frame.to_frame(
        {corner & 1 ? box.max.x : box.min.x, corner & 2 ? box.max.y : box.min.y, corner & 4 ? box.max.z : box.min.z}));
  for (const Triangle& t : s.triangles)
    for (VertexIndex v : t) area.add(frame.to_frame(s.points[v]));
  const double extra = margin * norm(box.max - box.min) * (1 + rim / 8.0);
  return {area.min - Vec3{extra, extra, 0}, area.max + Vec3{extra, extra, 0}};
}

Triangle oriented(Triangle t, bool up) {
  if (!up) std::swap(t[1], t[2]);
  return t;
}

/// Groups triangles inside holes (2, 4, ... borders away from outside); returns each group with its border's length.
std::vector<std::pair<std::vector<std::size_t>, double>> holes_of(const std::vector<PlanarTriangle>& triangles,
                                                                  const PlanarBorder& border) {
  std::map<std::pair<Index, Index>, std::vector<std::size_t>> at_edge;
  const auto key = [](Index a, Index b) { return std::pair(std::min(a, b), std::max(a, b)); };
  std::map<std::pair<Index, Index>, bool> is_border;
  for (const auto& [a, b] : border.constraints) is_border[key(a, b)] = true;
  std::vector<std::size_t> hole_triangles;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (triangles[t].depth < 2 || triangles[t].depth % 2 != 0) continue;
    hole_triangles.push_back(t);
    for (std::size_t i = 0; i < 3; ++i)
      at_edge[key(triangles[t].vertices[i], triangles[t].vertices[(i + 1) % 3])].push_back(t);
  }
  std::vector<bool> seen(triangles.size(), false);
  std::vector<std::pair<std::vector<std::size_t>, double>> holes;
  for (std::size_t seed : hole_triangles) {
    if (seen[seed]) continue;
    std::vector<std::size_t> hole{seed};
    CompensatedSum length;
    seen[seed] = true;
    for (std::size_t k = 0; k < hole.size(); ++k)
      for (std::size_t i = 0; i < 3; ++i) {
        const Index a = triangles[hole[k]].vertices[i], b = triangles[hole[k]].vertices[(i + 1) % 3];
        if (is_border.contains(key(a, b))) {
          length.add(norm(border.in_frame[b] - border.in_frame[a]));
          continue;
        }
        for (std::size_t next : at_edge[key(a, b)])
          if (!seen[next]) {
            seen[next] = true;
            hole.push_back(next);
          }
      }
    holes.emplace_back(std::move(hole), length.value());
  }
  return holes;
}

}  // namespace

void fill_holes(TriangulatedSurface& surface, double longest_border, const BuildLog& log) {
  if (surface.triangles.empty()) return;
  const Frame frame = frame_of(surface);
  const PlanarBorder border = planar_border(surface, frame);
  if (border.edges.empty()) return;
  const auto triangles = triangulate_plane(border.planar(), border.constraints);
  if (!triangles) return warn_crossing(surface, "fill_holes", log);
  const bool up = faces_up(surface, frame);
  const std::size_t first = surface.triangles.size();
  std::size_t n_filled = 0, n_left = 0;
  double longest = 0;
  Vec3 place;
  for (const auto& [hole, length] : holes_of(*triangles, border)) {
    if (length > longest_border) {
      ++n_left;
      continue;
    }
    ++n_filled;
    if (length > longest) {
      longest = length;
      place = surface.points[border.row[(*triangles)[hole.front()].vertices[0]]];
    }
    for (std::size_t t : hole) {
      const auto& v = (*triangles)[t].vertices;
      surface.triangles.push_back(oriented({border.row[v[0]], border.row[v[1]], border.row[v[2]]}, up));
    }
  }
  if (n_filled > 0)
    log.notes.push_back("surface " + surface.name + ": " + std::to_string(n_filled) + " holes filled (area " +
                        to_text(area_from(surface, first)) + ", the largest near " + to_text(place) + ")");
  if (n_left > 0)
    log.notes.push_back("surface " + surface.name + ": " + std::to_string(n_left) + " holes with longer borders than " +
                        to_text(longest_border) + " stay");
}

bool extend_to_box(TriangulatedSurface& surface, Extend how, const Box3& box, const BuildLog& log,
                   const ContinuationPoints& added_points) {
  if (how == Extend::none || surface.triangles.empty()) return true;
  const Frame frame = frame_of(surface);
  const PlanarBorder border = planar_border(surface, frame);
  if (border.edges.empty()) return true;
  const Box3 area = extended_area(surface, frame, box, added_points.rim);
  const double step = std::max(area.max.x - area.min.x, area.max.y - area.min.y) / n_grid;
  const int nx = std::max(1, static_cast<int>(std::lround((area.max.x - area.min.x) / step)));
  const int ny = std::max(1, static_cast<int>(std::lround((area.max.y - area.min.y) / step)));
  std::vector<Vec2> points = border.planar();
  std::vector<Vec3> added;  // in the frame
  Continuation continuation(surface, frame, border, how);
  for (int j = 0; j <= ny; ++j)
    for (int i = 0; i <= nx; ++i) {
      const double x = area.min.x + (area.max.x - area.min.x) * i / nx,
                   y = area.min.y + (area.max.y - area.min.y) * j / ny;
      const Nearest at = nearest_on_border(border, x, y);
      const bool on_rim = i == 0 || j == 0 || i == nx || j == ny;
      if (!on_rim && (!added_points.inside || at.distance2 < 0.25 * step * step)) continue;
      points.push_back({x, y});
      added.push_back({x, y, continuation.height(x, y, at)});
    }
  const auto triangles = triangulate_plane(points, border.constraints);
  if (!triangles) {
    warn_crossing(surface, "extend", log);
    return false;
  }
  const bool up = faces_up(surface, frame);
  const std::size_t first = surface.triangles.size();
  std::map<Index, VertexIndex> row;
  const auto row_of = [&](Index v) {
    if (v < border.row.size()) return border.row[v];
    const auto [at, is_new] = row.emplace(v, static_cast<VertexIndex>(surface.points.size()));
    if (is_new) surface.points.push_back(frame.to_model(added[v - border.row.size()]));
    return at->second;
  };
  for (const PlanarTriangle& t : *triangles)
    if (t.depth == 0)
      surface.triangles.push_back(oriented({row_of(t.vertices[0]), row_of(t.vertices[1]), row_of(t.vertices[2])}, up));
  const char* names[] = {"none", "flat", "tangent", "nearest"};
  log.notes.push_back("surface " + surface.name + ": extended to beyond the box (" + names[static_cast<int>(how)] +
                      "), area added " + to_text(area_from(surface, first)) + " of which the box keeps a part");
  return true;
}

void close_body(TriangulatedSurface& surface, const Box3& box, const BuildLog& log) {
  const BorderLoops borders = border_loops(border_edges(surface));
  if (borders.n_edges_left > 0)
    log.warnings.push_back("body " + surface.name + ": " + std::to_string(borders.n_edges_left) +
                           " border edges form no loop (are its triangles oriented alike?): not closed there");
  for (std::vector<VertexIndex> loop : borders.loops) {
    const std::size_t first = surface.triangles.size();
    Vec3 middle{0, 0, 0}, least = surface.points[loop[0]], greatest = least;
    for (VertexIndex v : loop) {
      const Vec3& p = surface.points[v];
      middle = middle + (1.0 / static_cast<double>(loop.size())) * p;
      for (std::size_t k = 0; k < 3; ++k) {
        least[k] = std::min(least[k], p[k]);
        greatest[k] = std::max(greatest[k], p[k]);
      }
    }
    // Finds the side of the box to which the border loop as a whole is nearest, or beyond which it is farthest.
    std::size_t axis = 2;
    bool at_max = false;
    double gap = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < 3; ++k) {
      if (greatest[k] - box.min[k] < gap) gap = greatest[k] - box.min[k], axis = k, at_max = false;
      if (box.max[k] - least[k] < gap) gap = box.max[k] - least[k], axis = k, at_max = true;
    }
    if (gap >= 0) {
      const double beyond = margin * norm(box.max - box.min);
      std::vector<VertexIndex> outer;
      for (VertexIndex v : loop) {
        Vec3 p = surface.points[v];
        p[axis] = at_max ? box.max[axis] + beyond : box.min[axis] - beyond;
        outer.push_back(static_cast<VertexIndex>(surface.points.size()));
        surface.points.push_back(p);
      }
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const std::size_t k = (i + 1) % loop.size();
        surface.triangles.push_back({loop[k], loop[i], outer[i]});
        surface.triangles.push_back({loop[k], outer[i], outer[k]});
      }
      loop = outer;
    }
    const VertexIndex apex = static_cast<VertexIndex>(surface.points.size());
    Vec3 tip = middle;
    if (gap >= 0) tip[axis] = surface.points[loop[0]][axis];
    surface.points.push_back(tip);
    for (std::size_t i = 0; i < loop.size(); ++i)
      surface.triangles.push_back({loop[(i + 1) % loop.size()], loop[i], apex});
    const char* sides[] = {"xmin", "xmax", "ymin", "ymax", "zmin", "zmax"};
    log.notes.push_back("body " + surface.name + ": open end near " + to_text(middle) + " closed beyond " +
                        sides[2 * axis + (at_max ? 1 : 0)] + ", area added " + to_text(area_from(surface, first)));
  }
}

}  // namespace geomesh::geomodel
