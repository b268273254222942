// SPDX-License-Identifier: GPL-3.0-or-later
#include "fractures/crossings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "geomesh/core/error.hpp"
#include "geomesh/geomodel/sizes_in_range.hpp"
#include "naming/sums.hpp"

namespace geomesh::geomodel {
namespace {

constexpr std::size_t most_samples = 200;
/// Average number of tetrahedra in a cell between crossing planes. Such a cell is convex and has eight corners on
/// average; a convex cell with n corners needs at least n - 3 tetrahedra.
constexpr double elements_of_cell = 5;

struct Plane {
  Vec3 normal, centre;
  double radius = 0;  ///< radius of a sphere around the centre that contains the fracture

  explicit Plane(const TriangulatedSurface& s) {
    const std::vector<Vec3>& p = s.points;
    for (const Triangle& t : s.triangles) normal = normal + cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]);
    for (const Vec3& corner : p) centre = centre + (1 / static_cast<double>(p.size())) * corner;
    for (const Vec3& corner : p) radius = std::max(radius, norm(corner - centre));
  }
  double height(const Vec3& p) const { return dot(normal, p - centre); }
};

struct Segment {
  Vec3 a, b;
};

struct Line {
  Segment segment;
  std::size_t first = 0, second = 0;  ///< rows of the two fractures that cross in the line
};

/// Part of the line in which two fractures cross, as an interval of the line's parameter.
struct Interval {
  double low = std::numeric_limits<double>::infinity(), high = -std::numeric_limits<double>::infinity();
  void add(double at) {
    low = std::min(low, at);
    high = std::max(high, at);
  }
};

/// Returns the interval of positions, along a direction, at which a plane cuts a surface. For a polygon that is not
/// convex, it reaches from the first cut to the last.
Interval cut(const TriangulatedSurface& s, const Plane& plane, const Vec3& direction) {
  Interval found;
  for (const Triangle& t : s.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 &p = s.points[t[i]], &q = s.points[t[(i + 1) % 3]];
      const double hp = plane.height(p), hq = plane.height(q);
      if ((hp < 0) == (hq < 0)) continue;
      found.add(dot(direction, p + (hp / (hp - hq)) * (q - p)));
    }
  return found;
}

std::optional<Segment> clipped(const Segment& s, const Box3& box) {
  double from = 0, to = 1;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double a = s.a[axis], d = s.b[axis] - a;
    if (d == 0 && (a < box.min[axis] || a > box.max[axis])) return std::nullopt;
    if (d == 0) continue;
    const auto [enter, leave] = std::minmax({(box.min[axis] - a) / d, (box.max[axis] - a) / d});
    from = std::max(from, enter);
    to = std::min(to, leave);
  }
  if (!(from < to)) return std::nullopt;
  return Segment{s.a + from * (s.b - s.a), s.a + to * (s.b - s.a)};
}

bool is_in(const TriangulatedSurface& s, const Plane& plane, const Vec3& place) {
  return std::ranges::any_of(s.triangles, [&](const Triangle& t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 &p = s.points[t[i]], &q = s.points[t[(i + 1) % 3]];
      if (dot(cross(q - p, place - p), plane.normal) < 0) return false;
    }
    return true;
  });
}

class Network {
 public:
  Network(const std::vector<const TriangulatedSurface*>& fractures, const Box3& bounds)
      : fractures_(fractures), bounds_(bounds) {
    for (const TriangulatedSurface* s : fractures) planes_.emplace_back(*s);
  }

  NetworkCrossings estimate() const {
    const std::size_t n = fractures_.size(), n_sampled = std::min(n, most_samples);
    std::vector<Line> lines;
    for (std::size_t k = 0; k < n_sampled; ++k) {
      const std::size_t i = k * n / n_sampled;
      for (std::size_t j = 0; j < n; ++j)
        if (const auto line = j == i ? std::nullopt : crossing(i, j)) lines.push_back({*line, i, j});
    }
    if (lines.empty()) return {};
    const std::size_t n_lines = std::min(lines.size(), most_samples);
    std::size_t n_pierced = 0;
    for (std::size_t k = 0; k < n_lines; ++k) n_pierced += count_pierced(lines[k * lines.size() / n_lines]);
    const auto ratio = [](std::size_t a, std::size_t b) { return static_cast<double>(a) / static_cast<double>(b); };
    NetworkCrossings found;
    found.lines = static_cast<double>(lines.size()) * ratio(n, n_sampled) / 2;
    found.points = found.lines * ratio(n_pierced, n_lines) / 3;
    return found;
  }

 private:
  std::optional<Segment> crossing(std::size_t i, std::size_t j) const {
    const Plane &p = planes_[i], &q = planes_[j];
    if (norm(p.centre - q.centre) > p.radius + q.radius) return std::nullopt;
    const Vec3 along = cross(p.normal, q.normal);
    if (!(norm(along) > 0)) return std::nullopt;
    const Vec3 direction = (1 / norm(along)) * along;
    const Interval in_first = cut(*fractures_[i], q, direction), in_second = cut(*fractures_[j], p, direction);
    const double low = std::max(in_first.low, in_second.low), high = std::min(in_first.high, in_second.high);
    if (!(low < high)) return std::nullopt;
    // `foot` is the point in the planes of both fractures that is nearest to the first one's centre.
    const Vec3 across = cross(direction, p.normal);
    const Vec3 foot = p.centre - (q.height(p.centre) / dot(q.normal, across)) * across;
    const auto at = [&](double place) { return foot + (place - dot(direction, foot)) * direction; };
    return clipped({at(low), at(high)}, bounds_);
  }

  /// Counts the fractures that a line crosses, except the two in which the line lies.
  std::size_t count_pierced(const Line& line) const {
    const auto& [from, to] = line.segment;
    std::size_t n = 0;
    for (std::size_t i = 0; i < planes_.size(); ++i) {
      const Plane& p = planes_[i];
      if (i == line.first || i == line.second || norm(0.5 * (from + to) - p.centre) > p.radius + norm(to - from) / 2)
        continue;
      const double a = p.height(from), b = p.height(to);
      if ((a < 0) != (b < 0) && is_in(*fractures_[i], p, from + (a / (a - b)) * (to - from))) ++n;
    }
    return n;
  }

  const std::vector<const TriangulatedSurface*>& fractures_;
  Box3 bounds_;
  std::vector<Plane> planes_;
};

}  // namespace

NetworkCrossings estimate_crossings(const std::vector<const TriangulatedSurface*>& fractures, const Box3& bounds) {
  return Network(fractures, bounds).estimate();
}

void require_countable(const NetworkCrossings& crossings, std::size_t n_fractures, const RefinementSettings& settings) {
  const double count = elements_of_cell * crossings.points;
  if (!(count > static_cast<double>(settings.max_elements))) return;
  throw Error(ErrorKind::cannot_mesh, "fractures: " + std::to_string(n_fractures) +
                                          " of them cross each other in about " + rounded_count(crossings.lines) +
                                          " lines and " + rounded_count(crossings.points) + " points, which comes to " +
                                          rounded_count(count) + " elements or more, beyond the limit of " +
                                          count_words(static_cast<double>(settings.max_elements)) +
                                          " (mesh: {max_elements}): fewer or smaller fractures can be meshed");
}

}  // namespace geomesh::geomodel
