// SPDX-License-Identifier: GPL-3.0-or-later
#include "geomesh/geomodel/model_volume.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geomesh/core/error.hpp"
#include "naming/region_facts.hpp"
#include "rules/planar/planar_fill.hpp"

namespace geomesh::geomodel {
namespace {

[[noreturn]] void refuse(const std::string& message) { throw Error(ErrorKind::usage, "box: " + message); }

/// The axes of a rotated box in the map.
struct Turn {
  Vec2 x{1, 0}, y{0, 1};
  explicit Turn(double azimuth) {
    if (azimuth == 0) return;
    const double angle = azimuth * std::numbers::pi / 180;
    x = {std::cos(angle), -std::sin(angle)};
    y = {std::sin(angle), std::cos(angle)};
  }
  Vec2 own(double px, double py) const { return {px * x.x + py * x.y, px * y.x + py * y.y}; }
  Vec2 map(double u, double v) const { return {u * x.x + v * y.x, u * x.y + v * y.y}; }
};

/// Returns the bounds in the map of all points of the surfaces, in the rotated frame, and the range of their heights.
Box3 data_bounds(const std::vector<TriangulatedSurface>& surfaces, const Turn& turn) {
  Box3 bounds;
  for (const TriangulatedSurface& s : surfaces)
    for (const Triangle& t : s.triangles)
      for (VertexIndex v : t) {
        const Vec2 own = turn.own(s.points[v].x, s.points[v].y);
        bounds.add({own.x, own.y, s.points[v].z});
      }
  return bounds;
}

/// Returns a height above or below all of the named surface, with a margin of a twentieth of the height of all data.
double clear_of(const std::vector<TriangulatedSurface>& surfaces, const std::string& name, bool above) {
  const Box3 all = data_bounds(surfaces, Turn(0));
  for (const TriangulatedSurface& s : surfaces) {
    if (s.name != name || s.triangles.empty()) continue;
    const Box3 own = data_bounds({s}, Turn(0));
    const double room = std::max(0.05 * (all.max.z - all.min.z), 1.0);
    return above ? own.max.z + room : own.min.z - room;
  }
  refuse("there is no surface " + name + " to end at");
}

struct Heights {
  double bottom, top;
};

Heights heights_of(const VolumeSpec& spec, const std::vector<TriangulatedSurface>& surfaces, const Vec3& origin,
                   const Box3& data) {
  Heights h{data.min.z - spec.margin.z, data.max.z + spec.margin.z};
  if (spec.bottom) h.bottom = *spec.bottom - origin.z;
  if (spec.top) h.top = *spec.top - origin.z;
  if (!spec.bottom_surface.empty()) h.bottom = clear_of(surfaces, spec.bottom_surface, false);
  if (!spec.top_surface.empty()) h.top = clear_of(surfaces, spec.top_surface, true);
  if (!(h.bottom < h.top))
    refuse("its bottom (" + to_text(h.bottom + origin.z) + ") is not below its top (" + to_text(h.top + origin.z) +
           ")");
  return h;
}

TriangulatedSurface side_surface(const std::string& name, std::vector<Vec3> points, std::vector<Triangle> triangles) {
  TriangulatedSurface side;
  side.name = name;
  side.kind = SurfaceKind::box;
  side.points = std::move(points);
  side.triangles = std::move(triangles);
  return side;
}

/// Returns the vertical prism over a counter-clockwise polygon; names[i] is the side from corner i to the next.
ModelVolume prism(const std::vector<Vec2>& corners, const Heights& h, const std::vector<std::string>& names) {
  ModelVolume result;
  std::vector<std::pair<Index, Index>> edges;
  std::vector<Vec3> low, high;
  for (Index i = 0; i < corners.size(); ++i) {
    edges.emplace_back(i, static_cast<Index>((i + 1) % corners.size()));
    low.push_back({corners[i].x, corners[i].y, h.bottom});
    high.push_back({corners[i].x, corners[i].y, h.top});
    result.bounds.add(low.back());
    result.bounds.add(high.back());
  }
  const auto map = triangulate_plane(corners, edges);
  if (!map) refuse("the polygon crosses or touches itself, or has a corner twice");
  std::vector<Triangle> up, down;
  double doubled_area = 0;
  for (const PlanarTriangle& t : *map) {
    if (t.depth != 1) continue;
    const auto& v = t.vertices;
    up.push_back({v[0], v[1], v[2]});
    down.push_back({v[0], v[2], v[1]});
    const Vec2 &a = corners[v[0]], &b = corners[v[1]], &c = corners[v[2]];
    doubled_area += (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  }
  for (const auto& [i, k] : edges)
    result.sides.push_back(side_surface(names[i], {low[i], low[k], high[k], high[i]}, {{0, 1, 2}, {0, 2, 3}}));
  result.sides.push_back(side_surface("zmin", low, down));
  result.sides.push_back(side_surface("zmax", high, up));
  result.volume = 0.5 * doubled_area * (h.top - h.bottom);
  return result;
}

ModelVolume along_axes(const Box3& box) {
  ModelVolume result;
  result.box = result.bounds = box;
  const Vec3 size = box.max - box.min;
  result.volume = size.x * size.y * size.z;
  return result;
}

/// Returns the box between two opposite corners that are given in the rotated frame.
ModelVolume turned_box(const VolumeSpec& spec, Vec2 own_min, Vec2 own_max, const Heights& h) {
  if (spec.azimuth == 0) return along_axes({{own_min.x, own_min.y, h.bottom}, {own_max.x, own_max.y, h.top}});
  const Turn turn(spec.azimuth);
  return prism({turn.map(own_min.x, own_min.y), turn.map(own_max.x, own_min.y), turn.map(own_max.x, own_max.y),
                turn.map(own_min.x, own_max.y)},
               h, {"ymin", "xmax", "ymax", "xmin"});
}

std::vector<Vec2> counter_clockwise(std::vector<Vec2> polygon) {
  double doubled_area = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    doubled_area += (a.x - polygon[0].x) * (b.y - polygon[0].y) - (a.y - polygon[0].y) * (b.x - polygon[0].x);
  }
  if (doubled_area < 0) std::reverse(polygon.begin() + 1, polygon.end());
  return polygon;
}

ModelVolume extruded(const VolumeSpec& spec, const Heights& h, const Vec3& origin) {
  std::vector<Vec2> corners = counter_clockwise(spec.polygon);
  std::vector<std::string> names;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    names.push_back(std::string("side_").append(std::to_string(i + 1)));
    corners[i] = {corners[i].x - origin.x, corners[i].y - origin.y};
  }
  return prism(corners, h, names);
}

}  // namespace

ModelVolume make_volume(const VolumeSpec& spec, const std::vector<TriangulatedSurface>& surfaces, const Vec3& origin) {
  using Shape = VolumeSpec::Shape;
  if (spec.shape == Shape::box) return along_axes({spec.box.min - origin, spec.box.max - origin});
  const Turn turn(spec.azimuth);
  const Box3 data = data_bounds(surfaces, turn);
  if (spec.shape == Shape::margin && data.empty()) refuse("a margin needs surfaces to lie about, and there are none");
  const Heights h = heights_of(spec, surfaces, origin, data);
  if (spec.shape == Shape::polygon) return extruded(spec, h, origin);
  if (spec.shape == Shape::turned) {
    const Vec2 middle = turn.own(spec.center.x - origin.x, spec.center.y - origin.y);
    const Vec2 half{0.5 * spec.size.x, 0.5 * spec.size.y};
    return turned_box(spec, {middle.x - half.x, middle.y - half.y}, {middle.x + half.x, middle.y + half.y}, h);
  }
  ModelVolume result = turned_box(spec, {data.min.x - spec.margin.x, data.min.y - spec.margin.y},
                                  {data.max.x + spec.margin.x, data.max.y + spec.margin.y}, h);
  result.note = "box laid about the data: from " + to_text(result.bounds.min + origin) + " to " +
                to_text(result.bounds.max + origin);
  return result;
}

Box3 bounds_of(const std::vector<TriangulatedSurface>& surfaces) {
  Box3 bounds;
  for (const TriangulatedSurface& s : surfaces)
    for (const Vec3& p : s.points) bounds.add(p);
  return bounds;
}

}  // namespace geomesh::geomodel
