// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/region_volumes.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <string>

#include "geomesh/core/error.hpp"
#include "geomesh/geomodel/words.hpp"
#include "naming/sums.hpp"
#include "report/words.hpp"

namespace geomesh::geomodel {

namespace {

bool is_side_alone(const ModelMesh& mesh, const ModelMesh::Face& face) {
  const auto& set = mesh.surface_sets[static_cast<std::size_t>(face.surface_set)];
  return std::all_of(set.begin(), set.end(), [&](std::int32_t id) {
    const auto at =
        std::find_if(mesh.surfaces.begin(), mesh.surfaces.end(), [&](const NamedSurface& s) { return s.id == id; });
    return at != mesh.surfaces.end() && at->kind == SurfaceKind::box;
  });
}

/// Returns for each region id the area of the faces that can have moved. Entry 0 is the outside.
std::vector<double> movable_areas(const ModelMesh& mesh) {
  std::vector<CompensatedSum> sums(mesh.regions.size() + 1);
  std::vector<signed char> is_side(mesh.surface_sets.size(), -1);
  for (const ModelMesh::Face& f : mesh.faces) {
    signed char& side = is_side[static_cast<std::size_t>(f.surface_set)];
    if (side < 0) side = is_side_alone(mesh, f);
    if (side || f.region_minus == f.region_plus) continue;
    const double area =
        triangle_area(mesh.points[f.vertices[0]], mesh.points[f.vertices[1]], mesh.points[f.vertices[2]]);
    sums[static_cast<std::size_t>(f.region_minus)].add(area);
    sums[static_cast<std::size_t>(f.region_plus)].add(area);
  }
  std::vector<double> areas;
  for (const CompensatedSum& sum : sums) areas.push_back(sum.value());
  return areas;
}

}  // namespace

std::vector<double> component_volumes(const ConstrainedTetrahedralization& mesh) {
  std::vector<CompensatedSum> sums(mesh.n_components);
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t) {
    const Tetrahedron& v = mesh.tetrahedra[t];
    sums[mesh.component[t]].add(
        signed_volume(mesh.points[v[0]], mesh.points[v[1]], mesh.points[v[2]], mesh.points[v[3]]));
  }
  std::vector<double> volumes;
  for (const CompensatedSum& sum : sums) volumes.push_back(sum.value());
  return volumes;
}

void set_volumes_of_input(ModelMesh& mesh, const ConstrainedTetrahedralization& core,
                          const std::vector<double>& volumes) {
  if (volumes.empty()) return;
  std::vector<std::int32_t> region_of(volumes.size(), 0);
  for (std::size_t t = 0; t < core.component.size(); ++t) region_of[core.component[t]] = mesh.tet_region[t];
  for (std::size_t c = 0; c < volumes.size(); ++c)
    if (region_of[c] > 0) mesh.regions[static_cast<std::size_t>(region_of[c] - 1)].volume_of_input += volumes[c];
}

void require_volumes_within(const ModelMesh& mesh, double tolerance) {
  const std::vector<double> areas = movable_areas(mesh);
  std::string off;
  for (const Region& r : mesh.regions) {
    const double allowed = areas[static_cast<std::size_t>(r.id)] * tolerance + 1e-12 * r.volume;
    if (r.volume_of_input == 0 || std::abs(r.volume - r.volume_of_input) <= allowed) continue;
    char text[200];
    std::snprintf(text, sizeof text, "%s%.80s holds %.9g, in the input %.9g, where %.3g more or less are allowed",
                  off.empty() ? "" : "; ", r.name.c_str(), r.volume, r.volume_of_input, allowed);
    off += text;
  }
  if (off.empty()) return;
  throw Error(ErrorKind::cannot_mesh,
              "volumes of regions differ from the input's by more than area of boundary times tolerance, so nothing "
              "was written: " +
                  off + ". Choose a smaller tolerance or smaller sizes there, or keep the surfaces exactly");
}

std::vector<std::string> volume_changes(const ModelMesh& mesh, double tolerance) {
  constexpr double worth_telling = 0.01;  // change of a unit's volume that matters for estimates of reserves
  struct Volumes {
    CompensatedSum now, given;
  };
  std::map<std::string, Volumes> units;
  for (const Region& r : mesh.regions) {
    if (r.volume_of_input == 0) continue;
    Volumes& unit = units[r.unit.empty() ? r.name : r.unit];
    unit.now.add(r.volume);
    unit.given.add(r.volume_of_input);
  }
  std::vector<std::string> texts;
  for (const auto& [name, volumes] : units) {
    const double now = volumes.now.value(), given = volumes.given.value(), change = now / given - 1;
    if (!(std::abs(change) > worth_telling)) continue;
    texts.push_back(name + " has " + short_words(100 * std::abs(change)) + (change < 0 ? " % less" : " % more") +
                    " volume than its surfaces enclosed before they were remeshed (" + volume_words(now, mesh.unit) +
                    ", before " + volume_words(given, mesh.unit) + "): they may move by " + short_words(tolerance) +
                    " " + mesh.unit +
                    ". A smaller tolerance (mesh: {surfaces_within: L}) or smaller sizes keep more of it");
  }
  return texts;
}

void require_volume_filled(const ModelMesh& mesh, double volume, bool ends_inside) {
  constexpr double rounding = 1e-9;
  CompensatedSum sum;
  for (const Region& r : mesh.regions) sum.add(r.volume);
  const double more = sum.value() / volume - 1;
  if (more <= rounding && (ends_inside || more >= -rounding)) return;
  char text[260];
  std::snprintf(text, sizeof text,
                "the regions hold %.12g, the model volume %.12g, so nothing was written: a side of it has a crack or a "
                "fold. Choose another `tolerance`, or none, or move the box by a little",
                sum.value(), volume);
  throw Error(ErrorKind::cannot_mesh, text);
}

}  // namespace geomesh::geomodel
