// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/pieces/throw_cover.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "check/exact/vertical_line.hpp"
#include "check/mesh/faults.hpp"
#include "check/specification/taken_by_rules.hpp"

namespace geomesh::geomodel::checking {
namespace {

// Largest allowed area of the lost parts of a horizon, as a share of its area in the volume.
constexpr double most_lost = 0.03;
constexpr double places_across = 64;    // number of sampled points along the longest extent of a horizon
constexpr int most_places_a_side = 16;  // of a triangle

/// A triangulated surface with a search structure for vertical lines through it.
struct Verticals {
  TriangulatedSurface surface;
  BoxTree tree;
  explicit Verticals(TriangulatedSurface s) : surface(std::move(s)), tree(tree_over_triangles(surface)) {}
  bool any(const Vec3& p, double room, double low, double high) const {
    bool found = false;
    for_each_height(surface, tree, p, room, [&](Index, double z) { found = found || (z >= low && z <= high); });
    return found;
  }
};

class ThrowCover {
 public:
  ThrowCover(const CheckedFaces& checked, Index row, double reach, const TakenByRules& rules)
      : checked_(checked),
        row_(row),
        reach_(reach),
        rules_(rules),
        faces_(mesh_faces()),
        faults_(faults()),
        given_(given_alone()) {
    for (const Triangle& t : given().triangles)
      for (const VertexIndex v : t) bounds_.add(given().points[v]);
  }

  void check(FaultCollector& lost) {
    const double step = std::max(bounds_.max.x - bounds_.min.x, bounds_.max.y - bounds_.min.y) / places_across;
    const std::size_t n_given = given_.surface.triangles.size();
    double all = 0, away = 0;
    std::vector<std::pair<Index, Vec3>> places;
    for (Index t = 0; t < n_given; ++t)
      for_each_place(t, step, [&](const Vec3& p, const Vec3& normal, double area) {
        if (rules_.is_outside(p)) return;
        all += area;
        if (!is_lost(t, p, normal)) return;
        away += area;
        if (places.empty() || places.back().first != t) places.emplace_back(t, p);
      });
    if (!(away > most_lost * all)) return;
    for (const auto& [triangle, place] : places) lost.add(triangle, place);
  }

 private:
  const TriangulatedSurface& given() const { return checked_.specification().surfaces[row_]; }

  TriangulatedSurface mesh_faces() const {
    TriangulatedSurface s;
    for (Index f = 0; f < checked_.candidates().size(); ++f) {
      if (!checked_.carries(f, row_)) continue;
      const auto first = static_cast<VertexIndex>(s.points.size());
      for (int i = 0; i < 3; ++i) s.points.push_back(checked_.corner(checked_.candidates()[f], i));
      s.triangles.push_back({first, first + 1, first + 2});
    }
    return s;
  }
  TriangulatedSurface given_alone() const {
    TriangulatedSurface s = given();
    s.triangles.resize(std::min(s.triangles.size(), checked_.specification().trims[row_].n_given_triangles));
    return s;
  }
  /// Returns all faults of the input and the triangles that extend them to separate the blocks of this horizon.
  TriangulatedSurface faults() const {
    TriangulatedSurface all;
    const auto add = [&](const std::array<Vec3, 3>& corners) {
      const auto first = static_cast<VertexIndex>(all.points.size());
      all.points.insert(all.points.end(), corners.begin(), corners.end());
      all.triangles.push_back({first, first + 1, first + 2});
    };
    for (const TriangulatedSurface& s : checked_.specification().surfaces) {
      if (s.kind != SurfaceKind::fault) continue;
      for (const Triangle& t : s.triangles) add({s.points[t[0]], s.points[t[1]], s.points[t[2]]});
    }
    for (const auto& corners : checked_.specification().trims[row_].partings) add(corners);
    return all;
  }

  template <class F>
  void for_each_place(Index triangle, double step, F&& visit) const {
    const Triangle& t = given().triangles[triangle];
    const Vec3 &a = given().points[t[0]], &b = given().points[t[1]], &c = given().points[t[2]];
    const Vec3 u = b - a, v = c - a;
    const double longest = std::sqrt(std::max({dot(u, u), dot(v, v), dot(c - b, c - b)}));
    const int n = std::clamp(static_cast<int>(std::ceil(longest / step)), 1, most_places_a_side);
    const double area = 0.5 * std::sqrt(dot(cross(u, v), cross(u, v))) / (n * n);
    for (int i = 0; i < n; ++i)
      for (int j = 0; i + j < n; ++j) {
        visit(a + ((i + 1.0 / 3) / n) * u + ((j + 1.0 / 3) / n) * v, cross(u, v), area);
        if (i + j + 1 < n) visit(a + ((i + 2.0 / 3) / n) * u + ((j + 2.0 / 3) / n) * v, cross(u, v), area);
      }
  }

  bool is_lost(Index triangle, const Vec3& p, const Vec3& normal) const {
    constexpr double anywhere = std::numeric_limits<double>::infinity();
    if (faces_.any(p, reach_, -anywhere, anywhere) || faults_.any(p, reach_, bounds_.min.z, bounds_.max.z))
      return false;
    const double length = std::sqrt(dot(normal, normal));
    return length > 0 && !is_taken(p) && !rules_.may_be_away_but_for_throw(row_, triangle, p) &&
           !checked_.is_removed(row_, p, (reach_ / length) * normal);
  }
  /// Returns whether rules may have removed the horizon above or below p, as where data at p overshoot a fault.
  bool is_taken(const Vec3& p) const {
    bool taken = false;
    for_each_height(given_.surface, given_.tree, p, 0, [&](Index triangle, double z) {
      taken = taken || (z != p.z && rules_.may_be_away_but_for_throw(row_, triangle, {p.x, p.y, z}));
    });
    return taken;
  }

  const CheckedFaces& checked_;
  Index row_;
  double reach_;
  const TakenByRules& rules_;
  Verticals faces_, faults_, given_;
  Box3 bounds_;
};

}  // namespace

void check_throw_cover(const CheckedFaces& checked, double reach, CheckResult& result) {
  const Specification& specification = checked.specification();
  const TakenByRules rules(specification, reach);
  std::string names;
  FaultCollector lost("horizon_lost_beyond_faults");
  std::size_t n_checked = 0;
  for (Index row = 0; row < specification.trims.size(); ++row) {
    if (!specification.trims[row].given_beyond_faults || specification.surfaces[row].kind != SurfaceKind::horizon)
      continue;
    const std::size_t before = lost.count();
    ThrowCover(checked, row, reach, rules).check(lost);
    ++n_checked;
    if (lost.count() > before) names += (names.empty() ? "" : ", ") + specification.surfaces[row].name;
  }
  lost.report(result, "given triangles of horizons with throw (" + names +
                          ") are nowhere in the mesh over or under their place, and no fault passes there");
  if (n_checked > 0)
    result.checks_done.emplace_back(
        "horizons with throw are over or under each given place, but for the heave of faults (sampled, to 3% of area)");
}

}  // namespace geomesh::geomodel::checking
