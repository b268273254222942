// SPDX-License-Identifier: GPL-3.0-or-later
#include "geomesh/geomodel/fault_polygons.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "arrangement/search/bvh.hpp"
#include "geomesh/core/predicates.hpp"
#include "geomesh/geomodel/readers.hpp"
#include "naming/region_facts.hpp"
#include "naming/sums.hpp"
#include "readers/tables/table.hpp"

namespace geomesh::geomodel {
namespace {

constexpr double separating = 999;  // x and y of a line that separates two polygons in Irap and CPS files
constexpr int n_levels = 9;         // number of heights at which faults inside a fault polygon are searched
constexpr int n_places = 64;  // number of sampled points on the line in which a horizontal plane cuts a fault triangle
// A fault counts as passing through a polygon if its length in the polygon is at least this share of the longest one.
constexpr double share_of_longest = 0.25;
constexpr double most_of_horizon = 0.5;  // if fault polygons contain more than this share of a horizon's area, warn
constexpr double wide_open = 0.25;  // if a fault polygon's ends are farther apart than this share of its length, warn

Vec2 in_map(const Vec3& p) { return {p.x, p.y}; }

/// Reads fault polygons from a text with one point per line.
class PolygonText {
 public:
  explicit PolygonText(const InputFile& file) : file_(file), lines_(file) {}

  /// Reads fault polygons from a text with one point per line; returns an empty list for any other text.
  std::vector<Polyline> read() {
    bool is_first = true;
    while (lines_.next()) {
      const std::string_view text = trim(lines_.line());
      if (text.empty() || text.front() == '>') {
        end_line();
        continue;
      }
      if (text.front() == '#' || text.front() == '!') continue;
      if (is_first) separation_ = sniff_separation(text);
      const std::vector<std::string_view> fields = separation_.split(text);
      const auto x = fields.size() > 1 ? separation_.number(fields[x_]) : std::nullopt;
      if (is_first && !x) {
        if (!read_names(fields)) return {};
        is_first = false;
        continue;
      }
      is_first = false;
      add(fields);
    }
    end_line();
    return std::move(found_);
  }

 private:
  bool read_names(const std::vector<std::string_view>& fields) {
    std::size_t n_found = 0;
    for (std::size_t i = 0; i < fields.size(); ++i) {
      const std::string name = to_lower(fields[i]);
      if (name == "x" || name == "easting" || name == "lon" || name == "longitude") x_ = i, ++n_found;
      if (name == "y" || name == "northing" || name == "lat" || name == "latitude") y_ = i, ++n_found;
      if (name == "id" || name == "polygon" || name == "name" || name == "line") id_ = i;
    }
    has_names_ = true;
    return n_found == 2;
  }

  void add(const std::vector<std::string_view>& fields) {
    if (fields.size() <= std::max(x_, y_)) lines_.fail("x and y of a fault polygon were expected");
    const auto x = separation_.number(fields[x_]), y = separation_.number(fields[y_]);
    if (!x || !y || !std::isfinite(*x) || !std::isfinite(*y))
      lines_.fail("x and y of a fault polygon were expected, as numbers");
    if (*x == separating && *y == separating) return end_line();
    if (!has_names_ && fields.size() > 3) id_ = 3;
    const std::string id = id_ && *id_ < fields.size() ? std::string(fields[*id_]) : "";
    if (id != at_id_) end_line();
    at_id_ = id;
    points_.push_back({*x, *y, 0});
  }

  void end_line() {
    if (!points_.empty())
      found_.push_back({"polygon " + std::to_string(found_.size() + 1), file_.shown(), std::move(points_)});
    points_.clear();
  }

  const InputFile& file_;
  LineReader lines_;
  Separation separation_;
  std::size_t x_ = 0, y_ = 1;
  std::optional<std::size_t> id_;
  bool has_names_ = false;
  std::string at_id_;
  std::vector<Vec3> points_;
  std::vector<Polyline> found_;
};

class MapPolygon {
 public:
  explicit MapPolygon(const Polyline& line) {
    for (const Vec3& p : line.points)
      if (corners_.empty() || corners_.back() != in_map(p)) corners_.push_back(in_map(p));
    for (std::size_t i = 0; i + 1 < corners_.size(); ++i) length_ += distance(corners_[i], corners_[i + 1]);
    gap_ = corners_.empty() ? 0 : distance(corners_.front(), corners_.back());
    if (corners_.size() > 1 && corners_.front() == corners_.back()) corners_.pop_back();
    for (const Vec2& p : corners_) bounds_.add({p.x, p.y, 0});
  }
  bool is_area() const { return corners_.size() > 2; }
  bool is_open() const { return gap_ > wide_open * length_; }
  const Box3& bounds() const { return bounds_; }
  Vec3 place() const { return 0.5 * (bounds_.min + bounds_.max); }

  bool holds(const Vec2& p) const {
    if (p.x < bounds_.min.x || p.x > bounds_.max.x || p.y < bounds_.min.y || p.y > bounds_.max.y) return false;
    bool inside = false;
    for_each_edge([&](const Vec2& a, const Vec2& b) {
      if ((a.y > p.y) == (b.y > p.y)) return;
      const Sign side = orient2d(a, b, p);
      inside = inside != (side == (b.y > a.y ? Sign::positive : Sign::negative));
    });
    return inside;
  }
  template <class F>
  void for_each_edge(F&& visit) const {
    for (std::size_t i = 0; i < corners_.size(); ++i) visit(corners_[i], corners_[(i + 1) % corners_.size()]);
  }

 private:
  static double distance(const Vec2& a, const Vec2& b) { return std::hypot(a.x - b.x, a.y - b.y); }
  std::vector<Vec2> corners_;
  double length_ = 0, gap_ = 0;
  Box3 bounds_;
};

bool cross(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  return orient2d(a, b, c) != orient2d(a, b, d) && orient2d(c, d, a) != orient2d(c, d, b);
}

class MapHorizon {
 public:
  explicit MapHorizon(const TriangulatedSurface& s) : s_(s), tree_(boxes_of(s)) {}

  /// Returns the indices of the horizon's triangles that the polygon meets, ascending.
  std::set<Index> met_by(const MapPolygon& polygon) const {
    std::set<Index> met;
    tree_.boxes_meeting(polygon.bounds(), [&](Index t) {
      for (const VertexIndex v : s_.triangles[t])
        if (polygon.holds(in_map(s_.points[v]))) met.insert(t);
    });
    polygon.for_each_edge([&](const Vec2& a, const Vec2& b) {
      Box3 box;
      box.add({a.x, a.y, 0});
      box.add({b.x, b.y, 0});
      tree_.boxes_meeting(box, [&](Index t) {
        if (crosses(t, a, b)) met.insert(t);
      });
    });
    return met;
  }

  std::pair<double, double> heights(const std::set<Index>& triangles) const {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Index t : triangles)
      for (const VertexIndex v : s_.triangles[t])
        low = std::min(low, s_.points[v].z), high = std::max(high, s_.points[v].z);
    return {low, high};
  }

 private:
  static std::vector<Box3> boxes_of(const TriangulatedSurface& s) {
    std::vector<Box3> boxes(s.triangles.size());
    for (std::size_t t = 0; t < boxes.size(); ++t)
      for (const VertexIndex v : s.triangles[t]) boxes[t].add({s.points[v].x, s.points[v].y, 0});
    return boxes;
  }
  /// Returns whether the segment a b crosses the horizon's triangle t in the map; an end inside t counts as crossing.
  bool crosses(Index t, const Vec2& a, const Vec2& b) const {
    const Triangle& v = s_.triangles[t];
    int n_left = 0, n_right = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec2 p = in_map(s_.points[v[i]]), q = in_map(s_.points[v[(i + 1) % 3]]);
      if (cross(p, q, a, b)) return true;
      (orient2d(p, q, a) == Sign::positive ? n_left : n_right) += 1;
    }
    return n_left == 3 || n_right == 3;
  }
  const TriangulatedSurface& s_;
  arrangement::BoxTree tree_;
};

/// Returns the length of the line at which a fault has the height `level` inside the fault polygon.
double length_within(const MapPolygon& polygon, const TriangulatedSurface& fault, double level) {
  double length = 0;
  for (const Triangle& t : fault.triangles) {
    std::vector<Vec2> ends;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 &p = fault.points[t[i]], &q = fault.points[t[(i + 1) % 3]];
      if ((p.z > level) == (q.z > level)) continue;
      const double share = (level - p.z) / (q.z - p.z);
      ends.push_back({p.x + share * (q.x - p.x), p.y + share * (q.y - p.y)});
    }
    if (ends.size() != 2) continue;
    const Box3& b = polygon.bounds();
    if (std::max(ends[0].x, ends[1].x) < b.min.x || std::min(ends[0].x, ends[1].x) > b.max.x ||
        std::max(ends[0].y, ends[1].y) < b.min.y || std::min(ends[0].y, ends[1].y) > b.max.y)
      continue;
    const double piece = std::hypot(ends[1].x - ends[0].x, ends[1].y - ends[0].y) / n_places;
    for (int k = 0; k < n_places; ++k) {
      const double share = (k + 0.5) / n_places;
      const Vec2 p{ends[0].x + share * (ends[1].x - ends[0].x), ends[0].y + share * (ends[1].y - ends[0].y)};
      if (polygon.holds(p)) length += piece;
    }
  }
  return length;
}

/// Returns the faults that pass through the polygon within a range of heights.
std::set<Index> faults_in(const MapPolygon& polygon, const std::pair<double, double>& heights,
                          const std::vector<TriangulatedSurface>& surfaces) {
  std::vector<double> length(surfaces.size(), 0);
  for (Index s = 0; s < surfaces.size(); ++s)
    for (int k = 0; surfaces[s].kind == SurfaceKind::fault && k < n_levels; ++k)
      length[s] +=
          length_within(polygon, surfaces[s], heights.first + (k + 0.5) / n_levels * (heights.second - heights.first));
  const double longest = length.empty() ? 0 : *std::max_element(length.begin(), length.end());
  std::set<Index> found;
  for (Index s = 0; s < length.size(); ++s)
    if (length[s] > 0 && length[s] >= share_of_longest * longest) found.insert(s);
  return found;
}

/// Fault polygons that one kind of warning concerns: their number, and the position of the first.
struct Told {
  std::size_t n = 0;
  Vec3 place;
  void add(const MapPolygon& polygon) {
    if (n++ == 0) place = polygon.place();
  }
  void tell(const std::string& horizon, const std::string& what, std::vector<std::string>& out) const {
    if (n == 0) return;
    out.push_back("horizon " + horizon + ": fault polygons that " + what + ": " + std::to_string(n) +
                  ", the first near (" + to_text(place.x) + ", " + to_text(place.y) + ")");
  }
};

}  // namespace

FileContents read_fault_polygons(const std::filesystem::path& file) {
  FileContents contents;
  const InputFile input = load_input_file(file);
  if (!looks_binary(input)) contents.polylines = PolygonText(input).read();
  contents.format = "fault polygons";
  if (contents.polylines.empty()) contents = read_surface_file(file);
  const auto is_area = [](const Polyline& line) { return MapPolygon(line).is_area(); };
  if (std::none_of(contents.polylines.begin(), contents.polylines.end(), is_area))
    throw Error(ErrorKind::invalid_input, input.shown() + ": no fault polygon of three points or more");
  return contents;
}

PolygonCut cut_at_polygons(TriangulatedSurface& horizon, const std::vector<Polyline>& polygons,
                           const std::vector<TriangulatedSurface>& surfaces) {
  PolygonCut cut;
  const MapHorizon map(horizon);
  std::set<Index> taken, faults;
  Told beside, without_fault, open;
  std::size_t n_used = 0;
  for (const Polyline& line : polygons) {
    const MapPolygon polygon(line);
    if (!polygon.is_area()) continue;
    if (polygon.is_open()) open.add(polygon);
    const std::set<Index> met = map.met_by(polygon);
    if (met.empty()) {
      beside.add(polygon);
      continue;
    }
    const std::set<Index> found = faults_in(polygon, map.heights(met), surfaces);
    if (found.empty()) {
      without_fault.add(polygon);
      continue;
    }
    ++n_used;
    taken.insert(met.begin(), met.end());
    faults.insert(found.begin(), found.end());
  }
  std::vector<Triangle> kept;
  double area = 0, area_taken = 0;
  std::vector<std::uint8_t> used(horizon.points.size(), 0), used_before = used;
  for (Index t = 0; t < horizon.triangles.size(); ++t) {
    const Triangle& v = horizon.triangles[t];
    const double size = triangle_area(horizon.points[v[0]], horizon.points[v[1]], horizon.points[v[2]]);
    const bool goes = taken.contains(t);
    (goes ? area_taken : area) += size;
    if (!goes) kept.push_back(v);
    for (const VertexIndex p : v) used_before[p] = 1, used[p] = used[p] || !goes;
  }
  area += area_taken;
  for (std::size_t v = 0; v < used.size(); ++v) cut.n_nodes += used_before[v] && !used[v];
  cut.n_triangles = taken.size();
  std::string names;
  for (const Index s : faults) {
    cut.faults.push_back(surfaces[s].name);
    names += (names.empty() ? "" : ", ") + surfaces[s].name;
  }
  if (n_used > 0)
    cut.notes.push_back("horizon " + horizon.name + ": fault polygons of " + names + ": " + std::to_string(n_used) +
                        "; " + std::to_string(cut.n_nodes) + " nodes and " + std::to_string(cut.n_triangles) +
                        " triangles within them are no data (area " + to_text(area_taken) + ")");
  beside.tell(horizon.name, "lie beside it (are their coordinates those of the horizon: crs, unit?)", cut.warnings);
  without_fault.tell(horizon.name, "are passed by no fault at its height; the horizon is kept as it is there",
                     cut.warnings);
  open.tell(horizon.name, "are lines with their ends far apart, which are joined straight", cut.warnings);
  if (area_taken > most_of_horizon * area)
    cut.warnings.push_back("horizon " + horizon.name + ": its fault polygons take " + to_text(100 * area_taken / area) +
                           " % of its area; are their coordinates right?");
  horizon.triangles = std::move(kept);
  return cut;
}

}  // namespace geomesh::geomodel
