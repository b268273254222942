// SPDX-License-Identifier: GPL-3.0-or-later
// Checks the arrays `kind` and `input_vertex` of mesh points, declared in check/arrays/check_arrays.hpp.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "check/arrays/check_arrays.hpp"
#include "check/exact/deviation.hpp"
#include "check/mesh/faults.hpp"
#include "check/names/region_places.hpp"

namespace geomesh::geomodel::checking {
namespace {

enum Kind : std::int32_t { input = 0, intersection = 1, on_segment = 2, on_facet = 3, inside = 4, midpoint = 5 };

struct AtPoint {
  std::set<std::int32_t> surfaces;
  bool on_curve = false, is_named = false;
  bool may_be_on_curve = false;  ///< whether the point may be on a curve: true if the mesh has no curves file
};

std::vector<AtPoint> things_at_points(const CheckedFaces& checked, const CheckedCurves* curves) {
  std::vector<AtPoint> at(checked.mesh().n_points());
  for (Index f = 0; f < checked.candidates().size(); ++f)
    for (const VertexIndex v : checked.candidates()[f])
      if (v != no_vertex) at[v].surfaces.insert(checked.set_of(f).begin(), checked.set_of(f).end());
  if (!curves) {
    for (AtPoint& a : at) a.may_be_on_curve = true;
    return at;
  }
  for (const MeshEdge& e : curves->edges)
    for (const VertexIndex v : e)
      if (v != no_vertex) at[v].on_curve = true;
  for (const VertexIndex v : curves->vertices)
    if (v != no_vertex) at[v].is_named = true;
  return at;
}

/// Finds input points by their coordinates; of several equal points, the first one counts.
class InputRows {
 public:
  explicit InputRows(const std::vector<Vec3>& points) : points_(points), order_(points.size()) {
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::sort(order_.begin(), order_.end(), [&](std::size_t a, std::size_t b) {
      return points_[a] == points_[b] ? a < b : comes_before(points_[a], points_[b]);
    });
  }
  /// Returns the index of the first input point with the coordinates of p, or -1 if there is none.
  std::int32_t first_at(const Vec3& p) const {
    const auto at = std::lower_bound(order_.begin(), order_.end(), p,
                                     [&](std::size_t row, const Vec3& q) { return comes_before(points_[row], q); });
    return at != order_.end() && points_[*at] == p ? static_cast<std::int32_t>(*at) : -1;
  }

 private:
  const std::vector<Vec3>& points_;
  std::vector<std::size_t> order_;
};

/// Returns whether the kind of a point agrees with the surfaces and curves at the point. With `may_be_bare`, rules or
/// bodies removed parts of surfaces, so that an intersection point may have lost one of its surfaces.
bool fits(std::int32_t kind, const AtPoint& at, std::int32_t input_vertex, bool may_be_bare) {
  if (at.may_be_on_curve) {
    const bool with_curve = fits(kind, {at.surfaces, true, true}, input_vertex, may_be_bare);
    return with_curve || fits(kind, {at.surfaces}, input_vertex, may_be_bare);
  }
  const bool is_free = at.surfaces.empty() && !at.on_curve;
  switch (kind) {
    case input:
      return input_vertex >= 0 || (at.surfaces.empty() && (at.on_curve || at.is_named));
    case intersection:
      return input_vertex < 0 && !is_free && (may_be_bare || at.on_curve || at.surfaces.size() > 1);
    case on_segment:
      return input_vertex < 0 && !is_free;
    case on_facet:
      return input_vertex < 0 && !at.surfaces.empty() && !at.on_curve;
    case inside:
      return input_vertex < 0 && is_free;
    default:
      return false;
  }
}

/// Returns whether two input triangles without a common corner both pass p within rounding. If surfaces were merged at
/// p, or a crack was closed, only the intersection point may be left of their crossing. O(triangles).
bool were_apart_at(const Specification& specification, const Vec3& p, double rounding) {
  std::vector<Corners> near;
  for (const TriangulatedSurface& s : specification.surfaces)
    for (const Triangle& t : s.triangles) {
      const Corners corners{s.points[t[0]], s.points[t[1]], s.points[t[2]]};
      const Vec3 d = nearest_on_triangle(p, corners) - p;
      if (std::sqrt(dot(d, d)) <= rounding) near.push_back(corners);
    }
  const auto share_corner = [](const Corners& s, const Corners& t) {
    return std::any_of(s.begin(), s.end(), [&](const Vec3& q) { return std::find(t.begin(), t.end(), q) != t.end(); });
  };
  return std::any_of(near.begin(), near.end(), [&](const Corners& s) {
    return std::any_of(near.begin(), near.end(), [&](const Corners& t) { return !share_corner(s, t); });
  });
}

}  // namespace

void check_point_values(const CheckedFaces& checked, const CheckedCurves* curves, double rounding,
                        CheckResult& result) {
  const CheckedMesh& mesh = checked.mesh();
  const Specification& specification = checked.specification();
  if (mesh.file.kind.size() != mesh.n_points() || mesh.file.input_vertex.size() != mesh.n_points()) return;
  const std::vector<AtPoint> at = things_at_points(checked, curves);
  const InputRows rows(specification.input_points);
  const bool trimmed =
      std::any_of(specification.trims.begin(), specification.trims.end(), [](const TrimRules& t) { return t.any(); }) ||
      std::any_of(specification.surfaces.begin(), specification.surfaces.end(),
                  [](const auto& s) { return s.cuts_all; });
  const bool exact = specification.within == 0 && specification.merging == 0;
  const std::set<VertexIndex> midpoints(mesh.file.midpoints.begin(), mesh.file.midpoints.end());
  FaultCollector wrong_kind("wrong_kinds"), wrong_row("wrong_input_vertices");
  for (VertexIndex v = 0; v < mesh.n_points(); ++v) {
    const Vec3& p = mesh.point(v);
    if (midpoints.contains(v) != (mesh.file.kind[v] == midpoint)) wrong_kind.add(v, p);
    if (midpoints.contains(v)) continue;
    const std::int32_t row = mesh.file.input_vertex[v], here = rows.first_at(p);
    if (row >= 0) {
      const bool known = static_cast<std::size_t>(row) < specification.input_points.size();
      const Vec3 d = known ? specification.input_points[static_cast<std::size_t>(row)] - p : Vec3{};
      if (!known || std::sqrt(dot(d, d)) > rounding + specification.within + specification.merging ||
          (exact && here >= 0 && row != here))
        wrong_row.add(v, p);
    } else if (row != -1 || (exact && here >= 0 && !at[v].surfaces.empty())) {
      wrong_row.add(v, p);
    }
    if (!fits(mesh.file.kind[v], at[v], row, trimmed || specification.merging > 0) &&
        !(fits(mesh.file.kind[v], at[v], row, true) && were_apart_at(specification, p, rounding)))
      wrong_kind.add(v, p);
  }
  wrong_kind.report(
      result, "points have a kind that does not fit what lies at them (surfaces, curves, an input point, nothing)");
  wrong_row.report(result, "points have an input_vertex that is not the row of the input's point at their place");
  result.checks_done.emplace_back(
      "kind and input_vertex of every point fit the input and the surfaces and curves at it");
}

}  // namespace geomesh::geomodel::checking
