// SPDX-License-Identifier: GPL-3.0-or-later
// Checks arrays of element sizes and shapes, declared in check/arrays/check_arrays.hpp.
#include <algorithm>
#include <cmath>

#include "check/arrays/check_arrays.hpp"
#include "check/arrays/element_shape.hpp"
#include "check/mesh/faults.hpp"

namespace geomesh::geomodel::checking {
namespace {

struct Measure {
  const char* name;
  double ElementShape::*value;
  double (ElementShape::*slack)() const;
};
constexpr std::array<Measure, 5> measures{
    {{"min_dihedral", &ElementShape::min_dihedral, &ElementShape::slack_of_angles},
     {"max_dihedral", &ElementShape::max_dihedral, &ElementShape::slack_of_angles},
     {"radius_ratio", &ElementShape::radius_ratio, &ElementShape::slack_of_ratios},
     {"mean_ratio", &ElementShape::mean_ratio, &ElementShape::slack_of_ratios},
     {"aspect", &ElementShape::aspect, &ElementShape::slack_of_ratios}}};

using Values = std::vector<double>;

/// Returns the file's array with this name, or nullptr if it has none with a value for each cell.
const Values* array_of(const MeshFile& file, const std::string& name) {
  const auto at = file.cell_values.find(name);
  return at != file.cell_values.end() && at->second.size() == file.tetrahedra.size() ? &at->second : nullptr;
}

void check_shapes(const CheckedMesh& mesh, double ulp, FaultCollector& wrong) {
  std::array<const Values*, measures.size()> arrays;
  for (std::size_t m = 0; m < measures.size(); ++m) arrays[m] = array_of(mesh.file, measures[m].name);
  if (std::all_of(arrays.begin(), arrays.end(), [](const Values* a) { return !a; })) return;
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    const ElementShape shape = element_shape(mesh, mesh.cells[c], ulp);
    for (std::size_t m = 0; m < measures.size(); ++m)
      if (arrays[m] && !(std::abs((*arrays[m])[c] - shape.*measures[m].value) <= (shape.*measures[m].slack)()))
        wrong.add(mesh.file.cell[c], centroid(mesh, mesh.cells[c]));
  }
}

/// Checks that element sizes are lengths, and that within one region they grow by at most `most` per unit of distance.
/// With `most` = 0 the growth is not checked.
void check_sizes(const CheckedMesh& mesh, double most, FaultCollector& wrong) {
  const Values* const sizes = array_of(mesh.file, "size");
  if (!sizes) return;
  std::vector<char> is_wrong(mesh.cells.size(), 0);
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) is_wrong[c] = !((*sizes)[c] > 0 && std::isfinite((*sizes)[c]));
  for (const FacePair& face : mesh.faces) {
    if (!(most > 0) || !is_inner(face) || mesh.file.region[face.even] != mesh.file.region[face.odd]) continue;
    const double a = (*sizes)[face.even], b = (*sizes)[face.odd];
    const Vec3 way = centroid(mesh, mesh.cells[face.even]) - centroid(mesh, mesh.cells[face.odd]);
    constexpr double by_rounding = 1e-9;
    if (std::abs(a - b) > most * std::sqrt(dot(way, way)) + by_rounding * (a + b))
      is_wrong[a > b ? face.even : face.odd] = 1;
  }
  for (std::size_t c = 0; c < mesh.cells.size(); ++c)
    if (is_wrong[c]) wrong.add(mesh.file.cell[c], centroid(mesh, mesh.cells[c]));
}

}  // namespace

void check_cell_arrays(const CheckedFaces& checked, double ulp, CheckResult& result) {
  const CheckedMesh& mesh = checked.mesh();
  FaultCollector missing("missing_cell_arrays"), wrong("wrong_cell_arrays");
  for (std::size_t row = 0; row < checked.specification().cell_arrays.size(); ++row)
    if (!array_of(mesh.file, checked.specification().cell_arrays[row])) missing.add(row, {});
  check_shapes(mesh, ulp, wrong);
  check_sizes(mesh, checked.specification().size_growth, wrong);
  missing.report(result, "arrays of mesh.cell_arrays are not there");
  wrong.report(result, "cells have another shape than their array reports, or a size that is none or that jumps");
}

}  // namespace geomesh::geomodel::checking
