// SPDX-License-Identifier: GPL-3.0-or-later
#include "rules/dyke.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "geomesh/core/error.hpp"
#include "naming/region_facts.hpp"
#include "naming/sheets.hpp"
#include "naming/sums.hpp"
#include "rules/planar/borders.hpp"

namespace geomesh::geomodel {

namespace {

/// Largest distance by which a vertex moves, as a multiple of half the thickness. A vertex must move farther than half
/// the thickness if its triangles are inclined to its normal; the limit corresponds to an inclination of 60 degrees.
constexpr double longest_miter = 2;

Vec3 area_vector(const std::vector<Vec3>& points, const Triangle& t) {
  return 0.5 * cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]);
}

double angle_between(const Vec3& u, const Vec3& v) { return std::atan2(norm(cross(u, v)), dot(u, v)); }

[[noreturn]] void refuse(const TriangulatedSurface& sheet, Index triangle, const std::string& what) {
  throw Error(ErrorKind::invalid_input, "body " + sheet.name + ": " + what + ", at triangle " +
                                            std::to_string(triangle) + " near " +
                                            to_text(sheet.points[sheet.triangles[triangle][0]]));
}

/// Checks that each edge has one or two triangles, and that no triangle has equal corners.
void require_sheet(const TriangulatedSurface& sheet, const std::vector<VertexIndex>& merged) {
  std::map<std::pair<VertexIndex, VertexIndex>, int> uses;
  for (Index t = 0; t < sheet.triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [a, b] = std::minmax(merged[sheet.triangles[t][i]], merged[sheet.triangles[t][(i + 1) % 3]]);
      if (a == b) refuse(sheet, t, "a triangle of its sheet has two equal corners");
      if (++uses[{a, b}] > 2) refuse(sheet, t, "an edge of its sheet has more than two triangles");
    }
}

/// Flips triangles so that all triangles of each connected part have the same orientation.
void orient_as_one(TriangulatedSurface& sheet) {
  const UpwardSides sides = orient_upward(sheet);
  if (sides.n_unorientable_sheets > 0)
    refuse(sheet, 0, "its sheet has one side alone (it is twisted like a Moebius band)");
  for (Index t = 0; t < sheet.triangles.size(); ++t)
    if (!sides.as_stored[t]) std::swap(sheet.triangles[t][1], sheet.triangles[t][2]);
}

/// Returns for each vertex the vector that moves it to the mean distance `half` from the planes of its triangles;
/// points with equal coordinates share one vector. Throws at a vertex whose triangles are inclined too much for that.
std::vector<Vec3> offsets(const TriangulatedSurface& sheet, const std::vector<VertexIndex>& merged, double half) {
  struct Corner {
    VertexIndex vertex;
    Index triangle;
    Vec3 normal;
    double angle;
  };
  std::vector<Corner> corners;
  std::vector<Vec3> sum(sheet.points.size(), Vec3{0, 0, 0});
  for (Index row = 0; row < sheet.triangles.size(); ++row) {
    const Triangle& t = sheet.triangles[row];
    const Vec3 area = area_vector(sheet.points, t);
    const double length = norm(area);
    if (!(length > 0)) continue;  // a needle of zero area in doubles; other triangles at its corners give the normals
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 &p = sheet.points[t[i]], &q = sheet.points[t[(i + 1) % 3]], &r = sheet.points[t[(i + 2) % 3]];
      corners.push_back({merged[t[i]], row, (1 / length) * area, angle_between(q - p, r - p)});
      sum[corners.back().vertex] = sum[corners.back().vertex] + corners.back().angle * corners.back().normal;
    }
  }
  std::vector<double> cosine(sheet.points.size(), 0), weight(sheet.points.size(), 0);
  for (const Corner& c : corners) {
    const double length = norm(sum[c.vertex]);
    if (length > 0) cosine[c.vertex] += c.angle * dot(c.normal, sum[c.vertex]) / length;
    weight[c.vertex] += c.angle;
  }
  for (const Corner& c : corners)
    if (longest_miter * cosine[c.vertex] < weight[c.vertex])
      refuse(sheet, c.triangle,
             "its sheet bends too sharply for a wall at a constant distance (smooth or resample it)");
  for (std::size_t v = 0; v < sum.size(); ++v)
    if (weight[v] > 0) sum[v] = (half * weight[v] / (cosine[v] * norm(sum[v]))) * sum[v];
  return sum;
}

}  // namespace

void thicken(TriangulatedSurface& sheet, double thickness, const BuildLog& log) {
  if (sheet.triangles.empty()) return;
  const std::vector<VertexIndex> merged = merge_equal_points(sheet.points);
  require_sheet(sheet, merged);
  orient_as_one(sheet);
  const std::vector<BorderEdge> border = border_edges(sheet);
  const std::vector<Vec3> offset = offsets(sheet, merged, thickness / 2);
  const auto n_points = static_cast<VertexIndex>(sheet.points.size());
  const std::size_t n_given = sheet.triangles.size();
  std::vector<Vec3> walls = sheet.points;
  for (VertexIndex v = 0; v < n_points; ++v) {
    walls.push_back(sheet.points[v] - offset[merged[v]]);
    walls[v] = sheet.points[v] + offset[merged[v]];
  }
  CompensatedSum area;
  for (Index t = 0; t < n_given; ++t) {
    const Triangle given = sheet.triangles[t];
    const Vec3 before = area_vector(sheet.points, given);
    const Triangle other{given[0] + n_points, given[1] + n_points, given[2] + n_points};
    area.add(norm(before));
    if (norm(before) > 0 &&
        (dot(before, area_vector(walls, given)) <= 0 || dot(before, area_vector(walls, other)) <= 0))
      refuse(sheet, t,
             "its sheet bends more tightly than half of the thickness " + to_text(thickness) +
                 " (smooth or resample it, or give less)");
    sheet.triangles.push_back({other[0], other[2], other[1]});
  }
  sheet.points = std::move(walls);
  for (const BorderEdge& e : border) {
    sheet.triangles.push_back({e.b, e.a, e.a + n_points});
    sheet.triangles.push_back({e.b, e.a + n_points, e.b + n_points});
  }
  log.notes.push_back("body " + sheet.name + ": made of a sheet of area " + to_text(area.value()) + " with thickness " +
                      to_text(thickness));
}

}  // namespace geomesh::geomodel
