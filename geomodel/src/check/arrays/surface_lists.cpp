// SPDX-License-Identifier: GPL-3.0-or-later
// Checks the lists of surfaces and of sets of coincident surfaces, declared in check/arrays/check_arrays.hpp.
#include <algorithm>
#include <cmath>
#include <optional>

#include "check/arrays/check_arrays.hpp"
#include "check/exact/deviation.hpp"
#include "check/mesh/faults.hpp"
#include "check/within/within_tolerance.hpp"

namespace geomesh::geomodel::checking {
namespace {

struct Listed {
  std::string name, kind;
};

/// Returns the surfaces that the files must list: the project's surfaces in its order, then the sides of the volume.
std::vector<Listed> due_surfaces(const Specification& specification) {
  std::vector<Listed> due;
  for (const TriangulatedSurface& s : specification.surfaces) due.push_back({s.name, to_string(s.kind)});
  if (specification.box())
    for (const char* name : box_side_names) due.push_back({name, "box"});
  if (specification.volume && !specification.volume->box)
    for (const TriangulatedSurface& side : specification.volume->sides) due.push_back({side.name, "box"});
  return due;
}

void check_list(const CheckedFaces& checked, CheckResult& result) {
  FaultCollector wrong("wrong_surface_list");
  const FacesFile& faces = *checked.faces();
  const auto& regions = checked.mesh().file.region_names;
  std::int32_t id = regions.empty() ? 0 : regions.rbegin()->first;
  const std::vector<Listed> due = due_surfaces(checked.specification());
  for (const Listed& surface : due) {
    ++id;
    const auto name = faces.surface_names.find(id), kind = faces.surface_kinds.find(id);
    const bool right = name != faces.surface_names.end() && name->second == surface.name &&
                       kind != faces.surface_kinds.end() && kind->second == surface.kind;
    if (!right) wrong.add(static_cast<std::size_t>(id), {});
  }
  if (faces.surface_names.size() > due.size()) wrong.add(due.size(), {});
  wrong.report(result,
               "surfaces are not listed in the project's order and after it the box sides, with ids that follow the "
               "regions', under their names and kinds");
}

void check_set_names(const FacesFile& faces, CheckResult& result) {
  FaultCollector wrong("wrong_surface_sets");
  for (std::size_t row = 0; row < faces.surface_sets.size(); ++row) {
    std::string name;
    for (const std::int32_t id : faces.surface_sets[row]) {
      const auto at = faces.surface_names.find(id);
      name += (name.empty() ? "" : "+") + (at == faces.surface_names.end() ? "" : at->second);
    }
    const auto& ids = faces.surface_sets[row];
    const bool ordered = std::adjacent_find(ids.begin(), ids.end(), std::greater_equal<>()) == ids.end();
    const bool unnamed = faces.surface_set_names.empty();
    if (!ordered || (!unnamed && (row >= faces.surface_set_names.size() || faces.surface_set_names[row] != name)))
      wrong.add(row, {});
  }
  wrong.report(result, "sets of surfaces are not in the order of ids or do not bear their members' names");
}

/// Checks that a mesh face in which several surfaces coincide lies on each of them. The first surface is checked
/// elsewhere, by the source triangle of the face.
void check_members(const CheckedFaces& checked, double rounding, CheckResult& result) {
  FaultCollector off("faces_off_their_surface");
  std::map<Index, std::optional<TriangleSet>> sets;
  for (Index f = 0; f < checked.candidates().size(); ++f) {
    const auto& ids = checked.set_of(f);
    for (std::size_t k = 1; k < ids.size(); ++k) {
      const Index row = checked.surface_of(ids[k]);
      if (row == no_index) continue;  // sides of the box have no specification
      auto& set = sets[row];
      if (!set) set.emplace(triangles_of(checked.specification().surfaces[row]));
      const Corners c = corners_of(checked, f);
      const Vec3 middle = (1.0 / 3) * (c[0] + c[1] + c[2]);
      for (const Vec3& p : {c[0], c[1], c[2], middle})
        if (set->near(p, rounding).empty()) {
          off.add(f, middle);
          break;
        }
    }
  }
  off.report(result, "faces bear surfaces in their set that do not lie there");
}

}  // namespace

void check_surface_lists(const CheckedFaces& checked, double rounding, CheckResult& result) {
  check_list(checked, result);
  check_set_names(*checked.faces(), result);
  if (checked.specification().within == 0) check_members(checked, rounding, result);
  result.checks_done.emplace_back("surfaces and their sets are listed as the project orders them");
}

}  // namespace geomesh::geomodel::checking
