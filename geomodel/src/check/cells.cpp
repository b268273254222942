// SPDX-License-Identifier: GPL-3.0-or-later
// Checks the tetrahedra and the point arrays of a mesh, declared in `check/mesh/checked_mesh.hpp`.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "check/exact/exact.hpp"
#include "check/mesh/checked_mesh.hpp"
#include "check/mesh/faults.hpp"

namespace geomesh::geomodel::checking {

bool is_finite(const Vec3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

namespace {

void check_equal_points(const CheckedMesh& mesh, CheckResult& result) {
  std::vector<VertexIndex> order(mesh.n_points());
  std::iota(order.begin(), order.end(), VertexIndex{0});
  std::sort(order.begin(), order.end(), [&](VertexIndex a, VertexIndex b) {
    const Vec3 &p = mesh.point(a), &q = mesh.point(b);
    return p == q ? a < b : std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z);
  });
  FaultCollector equal("equal_points");
  for (std::size_t i = 1; i < order.size(); ++i)
    if (mesh.point(order[i]) == mesh.point(order[i - 1])) equal.add(order[i], mesh.point(order[i]));
  equal.report(result, "points have the coordinates of another point");
}

void check_unused_points(const CheckedMesh& mesh, CheckResult& result) {
  std::vector<bool> used(mesh.n_points(), false);
  for (const Tetrahedron& cell : mesh.cells)
    for (const VertexIndex v : cell) used[v] = true;
  for (const VertexIndex v : mesh.file.midpoints) used[v] = true;
  FaultCollector unused("unused_points");
  for (std::size_t v = 0; v < used.size(); ++v)
    if (!used[v]) unused.add(v, mesh.point(static_cast<VertexIndex>(v)));
  unused.report(result, "points belong to no tetrahedron");
}

void check_orientations(CheckedMesh& mesh, CheckResult& result) {
  FaultCollector inverted("inverted_tetrahedra"), flat("flat_tetrahedra");
  ExactVolume total;
  for (std::size_t i = 0; i < mesh.cells.size(); ++i) {
    Tetrahedron& cell = mesh.cells[i];
    const Vec3 &a = mesh.point(cell[0]), &b = mesh.point(cell[1]), &c = mesh.point(cell[2]), &d = mesh.point(cell[3]);
    total.add(a, b, c, d);
    const Sign sign = orientation(a, b, c, d);
    if (sign == Sign::zero) flat.add(mesh.file.cell[i], centroid(mesh, cell));
    if (sign == Sign::negative) {
      inverted.add(mesh.file.cell[i], centroid(mesh, cell));
      std::swap(cell[2], cell[3]);
    }
  }
  result.volume = total.value();
  mesh.sound = inverted.count() == 0 && flat.count() == 0;
  inverted.report(result, "tetrahedra are inverted (negative volume, decided exactly)");
  flat.report(result, "tetrahedra are flat (zero volume, decided exactly)");
}

}  // namespace

Vec3 centroid(const CheckedMesh& mesh, const Tetrahedron& cell) {
  return 0.25 * (mesh.point(cell[0]) + mesh.point(cell[1]) + mesh.point(cell[2]) + mesh.point(cell[3]));
}

Vec3 centroid(const CheckedMesh& mesh, const Triangle& face) {
  return (1.0 / 3) * (mesh.point(face[0]) + mesh.point(face[1]) + mesh.point(face[2]));
}

bool check_cells(CheckedMesh& mesh, CheckResult& result) {
  result.n_points = mesh.n_points();
  result.n_tetrahedra = mesh.cells.size();
  FaultCollector infinite("not_finite");
  for (std::size_t v = 0; v < mesh.n_points(); ++v)
    if (!is_finite(mesh.point(static_cast<VertexIndex>(v)))) infinite.add(v, {});
  const bool checkable = infinite.count() == 0 && !mesh.cells.empty();
  infinite.report(result, "points have a coordinate that is no finite number");
  if (mesh.file.n_other_solids > 0)
    result.faults.push_back({"not_tetrahedra",
                             std::to_string(mesh.file.n_other_solids) + " solid cells are no linear tetrahedra",
                             mesh.file.n_other_solids,
                             {},
                             {}});
  if (mesh.cells.empty()) result.faults.push_back({"no_tetrahedra", "1 file holds no tetrahedron", 1, {}, {}});
  if (mesh.file.n_lower_cells > 0)
    result.checks_done.push_back(std::to_string(mesh.file.n_lower_cells) +
                                 " cells that are no solids were passed over");
  if (!checkable) return false;
  check_orientations(mesh, result);
  check_equal_points(mesh, result);
  check_unused_points(mesh, result);
  result.checks_done.emplace_back(
      "every cell is a tetrahedron of positive volume (exact); points are used and distinct");
  return true;
}

void check_point_arrays(const CheckedMesh& mesh, CheckResult& result) {
  std::string names;
  for (const std::string& name : mesh.file.missing_arrays) names += (names.empty() ? "" : ", ") + name;
  const std::size_t n = mesh.file.missing_arrays.size() + (mesh.file.single_precision ? 1 : 0);
  if (mesh.file.single_precision)
    names += names.empty() ? "coordinates in double precision" : ", coordinates in double precision";
  if (n > 0)
    result.faults.push_back(
        {"missing_point_arrays", std::to_string(n) + " things are missing in the mesh file: " + names, n, {}, {}});
  FaultCollector late("input_points_not_first");
  for (std::size_t v = 1; v < mesh.file.input_vertex.size(); ++v)
    if (mesh.file.input_vertex[v] >= 0 && mesh.file.input_vertex[v - 1] < 0) late.add(v, mesh.file.points[v]);
  late.report(result, "input points come after added ones");
}

}  // namespace geomesh::geomodel::checking
