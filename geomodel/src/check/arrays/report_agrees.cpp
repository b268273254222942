// SPDX-License-Identifier: GPL-3.0-or-later
// Checks the JSON report against the mesh, declared in check/arrays/check_arrays.hpp.
#include <cmath>
#include <nlohmann/json.hpp>

#include "check/arrays/check_arrays.hpp"
#include "check/mesh/faults.hpp"
#include "check/within/within_tolerance.hpp"

namespace geomesh::geomodel::checking {
namespace {

/// Allowed differences between sums that the checker computes in floating point and those in the report: relative to
/// the sum itself, and relative to the total over the model. Volumes of parts as thin as rounding are rounding errors.
constexpr double agreement = 1e-9, agreement_of_whole = 1e-14;

bool is_about(double a, double b, double whole = 0) {
  return std::abs(a - b) <= agreement * std::max(std::abs(a), std::abs(b)) + agreement_of_whole * whole;
}

double length_of(const Vec3& d) { return std::sqrt(dot(d, d)); }

/// Returns the entries of one list of the report by their `id`; entries that are not objects with an id are ignored.
std::map<std::int32_t, nlohmann::json> by_id(const nlohmann::json& report, const char* list) {
  std::map<std::int32_t, nlohmann::json> entries;
  if (report.is_object() && report.contains(list) && report[list].is_array())
    for (const auto& entry : report[list])
      if (entry.is_object() && entry.contains("id") && entry["id"].is_number_integer())
        entries[entry["id"].get<std::int32_t>()] = entry;
  return entries;
}

bool text_is(const nlohmann::json& entry, const char* key, const std::string& due) {
  return entry.contains(key) && entry[key].is_string() && entry[key].get<std::string>() == due;
}
bool number_is(const nlohmann::json& entry, const char* key, double due, double whole = 0) {
  return entry.contains(key) && entry[key].is_number() && is_about(entry[key].get<double>(), due, whole);
}

}  // namespace

void check_report(const CheckedFaces& checked, const CheckedCurves* curves, const nlohmann::json& report,
                  double tolerance, CheckResult& result) {
  FaultCollector differs("report_differs");
  auto regions = by_id(report, "regions");
  for (const auto& region : result.regions) {
    const auto at = regions.find(region.id);
    if (at == regions.end() || !text_is(at->second, "name", region.name) ||
        !number_is(at->second, "tetrahedra", static_cast<double>(region.n_tetrahedra)) ||
        !number_is(at->second, "volume", region.volume, result.volume))
      differs.add(static_cast<std::size_t>(region.id), {});
  }
  std::map<std::int32_t, double> areas, lengths;
  for (Index f = 0; f < checked.candidates().size(); ++f) {
    const Corners c = corners_of(checked, f);
    for (const std::int32_t id : checked.set_of(f)) areas[id] += 0.5 * length_of(cross(c[1] - c[0], c[2] - c[0]));
  }
  auto surfaces = by_id(report, "surfaces");
  for (const auto& [id, name] : checked.faces()->surface_names) {
    const auto at = surfaces.find(id);
    if (at == surfaces.end() || !text_is(at->second, "name", name) || !number_is(at->second, "area", areas[id]))
      differs.add(static_cast<std::size_t>(id), {});
  }
  if (curves) {
    for (std::size_t e = 0; e < curves->edges.size(); ++e)
      if (curves->edges[e][1] != no_vertex)
        lengths[curves->file.edge_curve[e]] +=
            length_of(checked.mesh().point(curves->edges[e][0]) - checked.mesh().point(curves->edges[e][1]));
    auto listed = by_id(report, "curves");
    for (const auto& curve : curves->file.curves) {
      const auto at = listed.find(curve.id);
      if (curve.kind == "point") continue;
      if (at == listed.end() || !text_is(at->second, "name", curve.name) || !text_is(at->second, "kind", curve.kind) ||
          !number_is(at->second, "length", lengths[curve.id]))
        differs.add(static_cast<std::size_t>(curve.id), {});
    }
  }
  const nlohmann::json::json_pointer moved("/displacement/rounding/largest");
  if (report.contains(moved) && report.at(moved).is_number() && report.at(moved).get<double>() > tolerance)
    differs.add(0, {});
  differs.report(result,
                 "entries of the report beside the mesh are not what the mesh holds (regions, surfaces, curves), or it "
                 "reports a displacement by rounding beyond what rounding does");
  result.checks_done.emplace_back("the report's regions, surfaces and curves are those of the mesh");
}

}  // namespace geomesh::geomodel::checking
