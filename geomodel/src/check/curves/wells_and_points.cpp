// SPDX-License-Identifier: GPL-3.0-or-later
// Checks wells and named points, declared in check/curves/check_curves.hpp.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>

#include "check/curves/check_curves.hpp"
#include "check/mesh/faults.hpp"
#include "check/names/region_places.hpp"
#include "check/specification/taken_by_rules.hpp"

namespace geomesh::geomodel::checking {
namespace {

struct Interval {
  double from, to;
};

/// Returns the position of p along the segment a b (0 to 1) and its distance from it.
std::pair<double, double> along(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 d = b - a;
  const double t = dot(d, d) > 0 ? std::clamp(dot(p - a, d) / dot(d, d), 0.0, 1.0) : 0;
  const Vec3 off = p - (a + t * d);
  return {t, std::sqrt(dot(off, off))};
}

class WellChecker {
 public:
  WellChecker(const CheckedFaces& checked, const CheckedCurves& curves, double room)
      : checked_(checked), curves_(curves), room_(room), volume_(checked.specification(), 2 * room) {}

  void check(const Polyline& well);
  void check_no_others();
  void report(CheckResult& result);

 private:
  std::vector<MeshEdge> edges_of(const std::string& name);
  bool lies_on(const MeshEdge& e, const Polyline& well) const;
  void check_covered(const Polyline& well, const std::vector<MeshEdge>& edges);
  bool is_due(const Vec3& p) const;

  const CheckedFaces& checked_;
  const CheckedCurves& curves_;
  double room_;
  TakenByRules volume_;
  std::set<std::string> known_;
  std::size_t n_edges_ = 0;
  FaultCollector off_{"wells_off"}, missing_{"missing_well_parts"}, wrong_{"wrong_wells"};
};

std::vector<MeshEdge> WellChecker::edges_of(const std::string& name) {
  std::vector<MeshEdge> edges;
  for (std::size_t e = 0; e < curves_.edges.size(); ++e) {
    const auto row = curves_.row_of_id.find(curves_.file.edge_curve[e]);
    if (row == curves_.row_of_id.end()) continue;
    const auto& curve = curves_.file.curves[row->second];
    if (curve.kind == "well" && curve.name == name && curves_.edges[e][1] != no_vertex)
      edges.push_back(curves_.edges[e]);
  }
  return edges;
}

/// Returns whether five points spread over the mesh edge are each near some segment of the well's path.
bool WellChecker::lies_on(const MeshEdge& e, const Polyline& well) const {
  const Vec3 &a = checked_.mesh().point(e[0]), &b = checked_.mesh().point(e[1]);
  for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    const Vec3 p = a + t * (b - a);
    bool near = false;
    for (std::size_t i = 1; i < well.points.size() && !near; ++i)
      near = along(p, well.points[i - 1], well.points[i]).second <= room_;
    if (!near) return false;
  }
  return true;
}

/// Returns whether a point of a well's path must be on mesh edges: whether it is inside the mesh and farther than the
/// allowed distance from its border. Points around p are tested.
bool WellChecker::is_due(const Vec3& p) const {
  if (volume_.is_outside(p)) return false;
  if (checked_.specification().volume && !checked_.specification().ends_inside) return true;
  const double d = 2 * room_;
  for (const Vec3& off : {Vec3{d, 0, 0}, Vec3{-d, 0, 0}, Vec3{0, d, 0}, Vec3{0, -d, 0}, Vec3{0, 0, d}, Vec3{0, 0, -d}})
    if (regions_at(checked_.mesh(), p + off).empty()) return false;
  return true;
}

/// Checks that mesh edges cover each segment of a well's path inside the mesh.
void WellChecker::check_covered(const Polyline& well, const std::vector<MeshEdge>& edges) {
  for (std::size_t i = 1; i < well.points.size(); ++i) {
    const Vec3 &a = well.points[i - 1], &b = well.points[i];
    const double length = std::sqrt(dot(b - a, b - a));
    if (length == 0) continue;
    std::vector<Interval> covered;
    for (const MeshEdge& e : edges) {
      const auto [t, d] = along(checked_.mesh().point(e[0]), a, b);
      const auto [u, f] = along(checked_.mesh().point(e[1]), a, b);
      // If surfaces may move, the mesh edge may cut a corner of the well's path, so that its ends are near different
      // segments of the path.
      if (d <= 2 * room_ || f <= 2 * room_) covered.push_back({std::min(t, u), std::max(t, u)});
    }
    std::sort(covered.begin(), covered.end(), [](const Interval& x, const Interval& y) { return x.from < y.from; });
    covered.push_back({1, 1});
    double reached = 0;
    for (const Interval& next : covered) {
      if ((next.from - reached) * length > 4 * room_) {
        const double middle = 0.5 * (reached + next.from), quarter = 0.5 * (reached + middle);
        for (const double t : {quarter, middle, 0.5 * (middle + next.from)})
          if (is_due(a + t * (b - a))) {
            missing_.add(i - 1, a + t * (b - a));
            break;
          }
      }
      reached = std::max(reached, next.to);
    }
  }
}

void WellChecker::check(const Polyline& well) {
  known_.insert(well.name);
  const std::vector<MeshEdge> edges = edges_of(well.name);
  n_edges_ += edges.size();
  for (std::size_t e = 0; e < edges.size(); ++e)
    if (!lies_on(edges[e], well)) off_.add(e, checked_.mesh().point(edges[e][0]));
  check_covered(well, edges);
}

void WellChecker::check_no_others() {
  for (std::size_t row = 0; row < curves_.file.curves.size(); ++row)
    if (curves_.file.curves[row].kind == "well" && !known_.contains(curves_.file.curves[row].name)) wrong_.add(row, {});
}

void WellChecker::report(CheckResult& result) {
  char text[200];
  std::snprintf(text, sizeof text, "edges of wells lie farther from the well's path than %.3g", room_);
  off_.report(result, text);
  missing_.report(result, "stretches of wells inside the mesh have no edge of the well along them");
  wrong_.report(result, "wells are listed that the project does not have");
  std::snprintf(text, sizeof text, "%zu edges of %zu wells lie on the wells' paths and cover them, within %.3g",
                n_edges_, known_.size(), room_);
  result.checks_done.emplace_back(text);
}

/// Checks that each named point inside the model exists, at exactly its position, or near it if features were merged.
void check_points(const CheckedFaces& checked, const CheckedCurves& curves, double room, CheckResult& result) {
  FaultCollector wrong("wrong_named_points");
  std::set<std::string> asked;
  for (std::size_t i = 0; i < checked.specification().points.size(); ++i) {
    const NamedPoint& point = checked.specification().points[i];
    asked.insert(point.name);
    bool found = false;
    for (std::size_t v = 0; v < curves.vertices.size(); ++v) {
      const auto row = curves.row_of_id.find(curves.file.vertex_curve[v]);
      if (row == curves.row_of_id.end() || curves.vertices[v] == no_vertex) continue;
      const auto& curve = curves.file.curves[row->second];
      const Vec3 d = checked.mesh().point(curves.vertices[v]) - point.point;
      found = found || (curve.kind == "point" && curve.name == point.name && std::sqrt(dot(d, d)) <= room);
    }
    if (!found && !regions_at(checked.mesh(), point.point).empty()) wrong.add(i, point.point);
  }
  for (std::size_t row = 0; row < curves.file.curves.size(); ++row)
    if (curves.file.curves[row].kind == "point" && !asked.contains(curves.file.curves[row].name)) wrong.add(row, {});
  wrong.report(result, "named points are not at their place, or the project does not have them");
}

}  // namespace

void check_wells_and_points(const CheckedFaces& checked, const CheckedCurves& curves, double room,
                            CheckResult& result) {
  WellChecker checker(checked, curves, room);
  for (const Polyline& well : checked.specification().wells) checker.check(well);
  checker.check_no_others();
  checker.report(result);
  check_points(checked, curves, room, result);
}

}  // namespace geomesh::geomodel::checking
