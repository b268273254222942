// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <cstdio>
#include <map>

#include "check/exact.hpp"
#include "check/faults.hpp"
#include "check/judged_mesh.hpp"

namespace geomesh::geomodel::checking {
namespace {

struct RegionSum {
  std::size_t n_cells = 0;
  std::size_t first_cell = 0;
  ExactVolume volume;
};

std::map<std::int32_t, RegionSum> sum_regions(const JudgedMesh& mesh) {
  std::map<std::int32_t, RegionSum> sums;
  for (std::size_t i = 0; i < mesh.cells.size(); ++i) {
    RegionSum& sum = sums[mesh.file.region[i]];
    if (sum.n_cells++ == 0) sum.first_cell = i;
    const Tetrahedron& c = mesh.cells[i];
    sum.volume.add(mesh.point(c[0]), mesh.point(c[1]), mesh.point(c[2]), mesh.point(c[3]));
  }
  return sums;
}

}  // namespace

void check_regions(const JudgedMesh& mesh, bool contract, CheckResult& result) {
  if (mesh.file.region.empty()) {
    if (contract)
      result.faults.push_back(
          {"no_region_array", "1 array is missing: the mesh has a face set beside it but no cell array \"region\"", 1, {}, {}});
    result.checks_done.emplace_back("no region array: regions were not judged");
    return;
  }
  FaultCollector not_positive("region_ids_not_positive"), unnamed("unnamed_regions"), empty("empty_regions");
  const bool must_be_named = contract || !mesh.file.region_names.empty();
  const auto sums = sum_regions(mesh);
  for (const auto& [id, sum] : sums) {
    const auto name = mesh.file.region_names.find(id);
    const bool named = name != mesh.file.region_names.end() && !name->second.empty();
    const Vec3 place = centroid(mesh, mesh.cells[sum.first_cell]);
    if (contract && id < 1) not_positive.add(mesh.file.cell[sum.first_cell], place);
    if (must_be_named && !named) unnamed.add(mesh.file.cell[sum.first_cell], place);
    result.regions.push_back({id, named ? name->second : "", sum.n_cells, sum.volume.value()});
  }
  for (const auto& [id, name] : mesh.file.region_names)
    if (!sums.contains(id)) empty.add(static_cast<std::size_t>(id), {});
  not_positive.report(result, "region ids are less than 1");
  unnamed.report(result, "region ids have no name");
  empty.report(result, "named regions have no tetrahedron");
  result.checks_done.push_back("regions from \"" + mesh.file.region_array + "\": " + std::to_string(sums.size()) +
                               (must_be_named ? ", each with a name" : ", without names") + "; volumes summed exactly");
}

void check_box(const JudgedMesh& mesh, const Box3& box, CheckResult& result) {
  const Vec3 size = box.max - box.min;
  const double wanted = size.x * size.y * size.z, error = std::abs(result.volume - wanted) / wanted;
  constexpr double relative_tolerance = 1e-12;
  char text[160];
  if (!(error <= relative_tolerance)) {
    std::snprintf(text, sizeof text, "1 volume is wrong: the tetrahedra fill %.15g, the box %.15g (relative error %.2g)",
                  result.volume, wanted, error);
    result.faults.push_back({"box_volume", text, 1, {}, 0.5 * (box.min + box.max)});
  }
  FaultCollector outside("points_outside_box");
  for (VertexIndex v = 0; v < mesh.n_points(); ++v) {
    const Vec3& p = mesh.point(v);
    if (p.x < box.min.x || p.y < box.min.y || p.z < box.min.z || p.x > box.max.x || p.y > box.max.y || p.z > box.max.z)
      outside.add(v, p);
  }
  outside.report(result, "points lie outside the box");
  std::snprintf(text, sizeof text, "the volume is the box's (relative error %.2g, at most 1e-12), every point is in the box",
                error);
  result.checks_done.emplace_back(text);
}

}  // namespace geomesh::geomodel::checking
