// SPDX-License-Identifier: GPL-3.0-or-later
// Checks second-order elements, declared in `check/mesh/checked_mesh.hpp` and `check/within/within_tolerance.hpp`.
#include <CGAL/Mpzf.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <optional>
#include <set>

#include "check/exact/deviation.hpp"
#include "check/mesh/checked_mesh.hpp"
#include "check/mesh/faults.hpp"
#include "check/within/within_tolerance.hpp"

namespace geomesh::geomodel::checking {
namespace {

using Edge = std::pair<VertexIndex, VertexIndex>;
constexpr std::size_t ends[6][2] = {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}};

Edge edge_of(VertexIndex a, VertexIndex b) { return {std::min(a, b), std::max(a, b)}; }

/// Returns the midpoint node of each edge; reports edges with several midpoint nodes.
std::map<Edge, VertexIndex> midpoints_of_edges(const CheckedMesh& mesh, CheckResult& result) {
  std::map<Edge, VertexIndex> of_edge;
  std::map<VertexIndex, Edge> edge_of_node;
  std::vector<bool> is_corner(mesh.n_points(), false);
  for (const Tetrahedron& t : mesh.file.tetrahedra)
    for (const VertexIndex v : t) is_corner[v] = true;
  FaultCollector wrong("wrong_midpoints");
  for (std::size_t t = 0; t < mesh.file.tetrahedra.size(); ++t)
    for (std::size_t e = 0; e < 6; ++e) {
      const Tetrahedron& v = mesh.file.tetrahedra[t];
      const Edge edge = edge_of(v[ends[e][0]], v[ends[e][1]]);
      const VertexIndex m = mesh.file.midpoints[6 * t + e];
      if (of_edge.try_emplace(edge, m).first->second != m || edge_of_node.try_emplace(m, edge).first->second != edge ||
          is_corner[m])
        wrong.add(mesh.file.cell[t], mesh.point(m));
    }
  wrong.report(result, "nodes in the middle of edges are not the one of their edge, shared by all cells there");
  return of_edge;
}

/// Bezier control points of the map from a reference tetrahedron to a second-order one, multiplied by two so that no
/// division is needed.
template <class Number>
struct Controls {
  std::array<std::array<std::array<Number, 3>, 4>, 4> at;

  explicit Controls(const std::array<Vec3, 10>& nodes) {
    const auto number = [](double x) { return Number(x); };
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t i = 0; i < 4; ++i) at[i][i][k] = number(nodes[i][k]) + number(nodes[i][k]);
      for (std::size_t e = 0; e < 6; ++e) {
        const auto [i, j] = ends[e];
        at[i][j][k] = at[j][i][k] = Number(4) * number(nodes[4 + e][k]) - number(nodes[i][k]) - number(nodes[j][k]);
      }
    }
  }

  /// Returns the Bezier coefficient of the Jacobian determinant that belongs to the corners i, j and l of the
  /// tetrahedron, multiplied by 48.
  Number coefficient(std::size_t i, std::size_t j, std::size_t l) const {
    const std::size_t corner[3] = {i, j, l};
    static constexpr std::size_t orders[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
    Number sum(0);
    for (const auto& order : orders) {
      std::array<std::array<Number, 3>, 3> d;
      for (std::size_t r = 0; r < 3; ++r)
        for (std::size_t k = 0; k < 3; ++k) d[r][k] = at[r + 1][corner[order[r]]][k] - at[0][corner[order[r]]][k];
      sum = sum + d[0][0] * (d[1][1] * d[2][2] - d[1][2] * d[2][1]) +
            d[0][1] * (d[1][2] * d[2][0] - d[1][0] * d[2][2]) + d[0][2] * (d[1][0] * d[2][1] - d[1][1] * d[2][0]);
    }
    return sum;
  }
};

/// Decides in floating point whether all Bezier coefficients of the Jacobian exceed their rounding error. Sums and
/// products of 36 terms each round by less than `units_of_determinants` units.
bool all_positive(const std::array<Vec3, 10>& nodes) {
  constexpr double unit = 1.2e-16, units_of_difference = 32, units_of_determinants = 512;
  const Controls<double> rough(nodes);
  double largest = 0, longest = 0;
  for (const Vec3& p : nodes)
    for (std::size_t k = 0; k < 3; ++k) largest = std::max(largest, std::abs(p[k]));
  for (std::size_t c = 0; c < 4; ++c)
    for (std::size_t r = 1; r < 4; ++r)
      for (std::size_t k = 0; k < 3; ++k) longest = std::max(longest, std::abs(rough.at[r][c][k] - rough.at[0][c][k]));
  const double of_difference = units_of_difference * unit * largest + unit * longest;
  const double error =
      units_of_determinants * (longest + of_difference) * (longest + of_difference) * (of_difference + unit * longest);
  std::optional<Controls<CGAL::Mpzf>> exact;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i; j < 4; ++j)
      for (std::size_t l = j; l < 4; ++l) {
        if (rough.coefficient(i, j, l) > error) continue;
        if (!exact) exact.emplace(nodes);
        if (CGAL::sign(exact->coefficient(i, j, l)) != CGAL::POSITIVE) return false;
      }
  return true;
}

void check_jacobians(const CheckedMesh& mesh, CheckResult& result) {
  FaultCollector bad("jacobian_not_positive");
  for (std::size_t t = 0; t < mesh.file.tetrahedra.size(); ++t) {
    std::array<Vec3, 10> nodes;
    for (std::size_t i = 0; i < 4; ++i) nodes[i] = mesh.point(mesh.file.tetrahedra[t][i]);
    for (std::size_t e = 0; e < 6; ++e) nodes[4 + e] = mesh.point(mesh.file.midpoints[6 * t + e]);
    if (!all_positive(nodes)) bad.add(mesh.file.cell[t], centroid(mesh, mesh.cells[t]));
  }
  bad.report(result, "elements of second order have a Bezier coefficient of their Jacobian that is not positive");
  result.checks_done.emplace_back(
      "elements of second order: one node an edge; all 20 Bezier coefficients of every Jacobian are positive (exact)");
}

}  // namespace

void check_second_order(const CheckedMesh& mesh, CheckResult& result) {
  if (mesh.file.midpoints.empty()) return;
  midpoints_of_edges(mesh, result);
  check_jacobians(mesh, result);
}

void check_midpoints_within(const CheckedFaces& checked, const Allowed& allowed, CheckResult& result) {
  const CheckedMesh& mesh = checked.mesh();
  if (mesh.file.midpoints.empty()) return;
  CheckResult told_already;
  const std::map<Edge, VertexIndex> of_edge = midpoints_of_edges(mesh, told_already);
  std::map<Index, std::optional<TriangleSet>> sets;
  FaultCollector off("midpoints_off");
  double largest = 0;
  std::size_t n_curved = 0;
  std::set<std::pair<VertexIndex, Index>> seen;
  for (Index f = 0; f < checked.candidates().size(); ++f)
    for (const std::int32_t id : checked.set_of(f)) {
      const Index row = checked.surface_of(id);
      if (row == no_index) continue;  // sides of the box have no specification
      auto& set = sets[row];
      if (!set) set.emplace(triangles_of(checked.specification().surfaces[row]));
      const Triangle& t = checked.candidates()[f];
      for (std::size_t i = 0; i < 3; ++i) {
        const auto at = of_edge.find(edge_of(t[i], t[(i + 1) % 3]));
        if (at == of_edge.end() || !seen.insert({at->second, row}).second) continue;
        const Vec3 p = mesh.point(at->second), q = 0.5 * (mesh.point(t[i]) + mesh.point(t[(i + 1) % 3])), d = p - q;
        const double distance = set->distance(p);
        largest = std::max(largest, distance);
        n_curved += std::sqrt(dot(d, d)) > allowed.rounding;
        if (distance > allowed.both()) off.add(at->second, p);
      }
    }
  off.report(result, "nodes in the middle of edges are farther from their surface than allowed");
  char text[160];
  std::snprintf(text, sizeof text,
                "nodes in the middle of edges: %zu are not half-way; the farthest from its surface is %.3g off",
                n_curved, largest);
  result.checks_done.emplace_back(text);
}

}  // namespace geomesh::geomodel::checking
