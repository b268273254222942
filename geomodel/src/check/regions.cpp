// SPDX-License-Identifier: GPL-3.0-or-later
// Checks volumes of regions and of the whole mesh, declared in `check/mesh/checked_mesh.hpp`.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

#include "check/exact/exact.hpp"
#include "check/mesh/checked_mesh.hpp"
#include "check/mesh/faults.hpp"
#include "naming/sums.hpp"

namespace geomesh::geomodel::checking {
namespace {

struct RegionSum {
  std::size_t n_cells = 0;
  std::size_t first_cell = 0;
  ExactVolume volume;
};

std::map<std::int32_t, RegionSum> sum_regions(const CheckedMesh& mesh) {
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

void check_regions(const CheckedMesh& mesh, bool contract, CheckResult& result) {
  if (mesh.file.region.empty()) {
    if (contract)
      result.faults.push_back({"no_region_array",
                               "1 array is missing: the mesh has a face set beside it but no cell array \"region\"",
                               1,
                               {},
                               {}});
    result.checks_done.emplace_back("no region array: regions were not checked");
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

namespace {

/// Returns the distance in long doubles, because its rounding error must be smaller than that of the points'
/// coordinates.
double distance_to_segment(Vec2 p, Vec2 a, Vec2 b) {
  using Real = long double;
  const Real dx = Real{b.x} - a.x, dy = Real{b.y} - a.y, px = Real{p.x} - a.x, py = Real{p.y} - a.y;
  const Real l2 = dx * dx + dy * dy, t = l2 > 0 ? std::clamp((px * dx + py * dy) / l2, Real{0}, Real{1}) : Real{0};
  return static_cast<double>(std::hypot(px - t * dx, py - t * dy));
}

/// Returns whether p is, in the map, inside the polygon of the volume's vertical sides, or closer than `room` to a
/// side.
bool is_within(const ModelVolume& volume, const Vec3& p, double room) {
  const std::size_t n = volume.sides.size() - 2;  // the last two sides of a model volume are its bottom and top
  bool inside = false, near = false;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3 &a = volume.sides[i].points[0], &b = volume.sides[i].points[1];
    near = near || distance_to_segment({p.x, p.y}, {a.x, a.y}, {b.x, b.y}) <= room;
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
  }
  return inside || near;
}

}  // namespace

void check_volume(const CheckedMesh& mesh, const Specification& specification, CheckResult& result) {
  const ModelVolume& volume = *specification.volume;
  const Box3& box = volume.bounds;
  // Largest distance in ulps of mesh points from a side of the volume. Sides that are not along the axes are rounded,
  // and surfaces that lie on them up to rounding are joined to them, within 32 ulps. Points in between are rounded
  // again.
  constexpr double ulps_off_a_side = 40;
  double ulp = 0, side_area = 0;  // of such sides
  for (const TriangulatedSurface& side : volume.sides)
    for (const Triangle& t : side.triangles)
      side_area += 0.5 * norm(cross(side.points[t[1]] - side.points[t[0]], side.points[t[2]] - side.points[t[0]]));
  Box3 all = box;
  for (const TriangulatedSurface& s : specification.surfaces)
    for (const Vec3& p : s.points) all.add(p);
  for (const Vec3& p : {all.min, all.max})
    for (std::size_t i = 0; i < 3; ++i) ulp = std::max(ulp, std::nextafter(std::abs(p[i]), INFINITY) - std::abs(p[i]));
  const double room = ulps_off_a_side * ulp;
  const double error = result.volume / volume.volume - 1, tolerance = 1e-12 + room * side_area / volume.volume;
  char text[200];
  if (!(error <= tolerance && (specification.ends_inside || error >= -tolerance))) {
    std::snprintf(text, sizeof text,
                  "1 volume is wrong: the tetrahedra fill %.15g, the box %.15g (relative error %.2g)", result.volume,
                  volume.volume, std::abs(error));
    result.faults.push_back({"box_volume", text, 1, {}, 0.5 * (box.min + box.max)});
  }
  FaultCollector outside("points_outside_box");
  for (VertexIndex v = 0; v < mesh.n_points(); ++v) {
    const Vec3& p = mesh.point(v);
    const bool in_bounds = !(p.x < box.min.x || p.y < box.min.y || p.z < box.min.z || p.x > box.max.x ||
                             p.y > box.max.y || p.z > box.max.z);
    if (volume.box ? !in_bounds : !is_within(volume, p, room)) outside.add(v, p);
  }
  outside.report(result, "points lie outside the box");
  if (specification.ends_inside) {
    std::snprintf(
        text, sizeof text,
        "the model fills %.6g of its box, the rest lies beyond the surface at which it ends; every point is in the box",
        1 + error);
  } else {
    std::snprintf(text, sizeof text,
                  "the volume is the box's (relative error %.2g, at most %.2g), every point is in the box",
                  std::abs(error), tolerance);
  }
  result.checks_done.emplace_back(text);
}

}  // namespace geomesh::geomodel::checking
