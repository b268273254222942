// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/outputs/summary.hpp"

#include <algorithm>
#include <cstdio>
#include <functional>

#include "geomesh/geomodel/model_mesh.hpp"
#include "geomesh/geomodel/words.hpp"
#include "report/words.hpp"

namespace geomesh::geomodel {
namespace {

constexpr const char* no_mesh_for_solvers =
    "not refined: the bare triangulation of the surfaces, no mesh for a solver (mesh: {size: L} makes one)";

constexpr std::size_t most_units_listed = 6;

struct Unit {
  std::string name;
  std::vector<const Region*> regions;
  std::size_t n_tetrahedra = 0;
  double volume = 0;
};

/// Groups the regions of a mesh into units, in the order of the units' first regions.
std::vector<Unit> units_of(const ModelMesh& mesh) {
  std::vector<Unit> units;
  for (const Region& region : mesh.regions) {
    const std::string& name = region.unit.empty() ? region.name : region.unit;
    auto unit = std::find_if(units.begin(), units.end(), [&](const Unit& u) { return u.name == name; });
    if (unit == units.end()) unit = units.insert(unit, {name, {}, 0, 0});
    unit->regions.push_back(&region);
    unit->n_tetrahedra += region.n_tetrahedra;
    unit->volume += region.volume;
  }
  return units;
}

/// Returns all units if there are few of them, else the largest ones in the same order.
std::vector<Unit> units_shown(std::vector<Unit> units) {
  if (units.size() <= most_units_listed) return units;
  std::vector<double> volumes;
  for (const Unit& unit : units) volumes.push_back(unit.volume);
  std::nth_element(volumes.begin(), volumes.begin() + (most_units_listed - 2), volumes.end(), std::greater<>());
  const double least = volumes[most_units_listed - 2];
  std::vector<Unit> shown;
  for (Unit& unit : units)
    if (unit.volume >= least && shown.size() + 1 < most_units_listed) shown.push_back(std::move(unit));
  return shown;
}

std::string row(const std::string& name, std::size_t width, std::size_t n_tetrahedra, const std::string& volume) {
  char numbers[64];
  std::snprintf(numbers, sizeof numbers, "%12s tetrahedra   ", grouped_words(n_tetrahedra).c_str());
  return "  " + name + std::string(width - std::min(width, name.size()), ' ') + numbers + volume;
}

void add_units(const ModelMesh& mesh, std::vector<std::string>& lines) {
  std::vector<Unit> units = units_of(mesh);
  const std::size_t n = units.size();
  units = units_shown(std::move(units));
  std::size_t width = 0;
  for (const Unit& unit : units) width = std::max(width, unit.name.size());
  for (const Unit& unit : units) {
    std::string line = row(unit.name, width, unit.n_tetrahedra, volume_words(unit.volume, mesh.unit));
    if (unit.regions.size() > 1)
      line += "   in " + grouped_words(unit.regions.size()) + " parts: " + unit.regions.front()->name +
              (unit.regions.size() > 2 ? " to " : " and ") + unit.regions.back()->name;
    lines.push_back(std::move(line));
  }
  if (n > units.size())
    lines.push_back("  and " + grouped_words(n - units.size()) + " smaller units (--verbose or the report lists all)");
}

void add_regions(const ModelMesh& mesh, std::vector<std::string>& lines) {
  std::size_t width = 0;
  for (const Region& region : mesh.regions) width = std::max(width, region.name.size());
  for (const Region& region : mesh.regions) {
    char id[16];
    std::snprintf(id, sizeof id, "%5d", region.id);
    lines.push_back(id + row(region.name, width, region.n_tetrahedra, volume_words(region.volume, mesh.unit)));
  }
}

/// Returns the surface that gridding, smoothing or resampling moved farthest from its data; null if none was moved.
const ToleranceUse* farthest_off_data(const ToleranceLedger& ledger) {
  const ToleranceUse* farthest = nullptr;
  for (const ToleranceUse& use : ledger.uses()) {
    const bool is_of_data = use.stage == "gridding" || use.stage == "smoothing" || use.stage == "resampling";
    if (is_of_data && *use.moved > (farthest ? *farthest->moved : 0)) farthest = &use;
  }
  return farthest;
}

/// Describes the lengths of edges, and the mesh settings that the user did not choose.
std::string steering(const RefinementSettings& r, const Distribution& edge_length, const std::string& unit) {
  std::string text = "edges are " + short_words(edge_length.mean) + " " + unit + " long in the mean";
  if (r.size.base.global > 0) text += ", of " + short_words(r.size.base.global) + " " + unit + " requested";
  if (r.derive_size) text += " (derived from the model; mesh: {size: L} sets others)";
  if (r.tolerance.follows_sizes())
    text += "; surfaces are within " + short_words(r.tolerance.requested()) + " " + unit +
            " of the input (mesh: {honour: exact} keeps them)";
  if (const ToleranceUse* const farthest = farthest_off_data(r.tolerance))
    text += "; " + farthest->surface + " is up to " + short_words(*farthest->moved) + " " + unit +
            " off the data that it was made from";
  return text;
}

/// Formats the shapes of the elements: "99.9 % of the tetrahedra above 24.85 degrees, 3 below 8 ...".
std::string shapes(const QualityReport& quality) {
  char text[160];
  std::snprintf(text, sizeof text,
                "smallest dihedral angle above 24.85 degrees in %.4g %% of the tetrahedra, below 8 in %zu (%zu imposed "
                "by the input)",
                100 * quality.measured.whole.share_above_24_85, quality.measured.n_bad, quality.measured.n_bad_forced);
  if (quality.short_edges.n == 0) return text;
  return text + ("; " + grouped_words(quality.short_edges.n)) + " edges below a third of the size requested there (" +
         grouped_words(quality.short_edges.n_forced) + " imposed by the input)";
}

}  // namespace

Summary summarise(const Report& report, const RefinementSettings& refinement) {
  const ModelMesh& mesh = *report.mesh;
  Summary summary;
  summary.lines.push_back(grouped_words(mesh.tetrahedra.size()) + " tetrahedra, " + grouped_words(mesh.points.size()) +
                          " points, " + units_words(mesh) + ":");
  add_units(mesh, summary.lines);
  add_regions(mesh, summary.details);
  summary.details.push_back(grouped_words(mesh.faces.size()) + " faces on surfaces");
  if (!refinement.refine) {
    summary.lines.emplace_back(no_mesh_for_solvers);
    if (!report.model_verdict.empty()) summary.lines.push_back(report.model_verdict);
    return summary;
  }
  summary.lines.push_back(steering(refinement, report.quality->measured.whole.edge_length, mesh.unit));
  const std::vector<std::string> verdict = to_lines(*report.solver);
  summary.lines.push_back(verdict.front());
  if (!report.model_verdict.empty()) summary.lines.push_back(report.model_verdict);
  summary.details.push_back(shapes(*report.quality));
  summary.details.insert(summary.details.end(), verdict.begin() + 1, verdict.end());
  return summary;
}

}  // namespace geomesh::geomodel
