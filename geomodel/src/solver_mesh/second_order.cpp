// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver_mesh/second_order.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "geomesh/core/error.hpp"

namespace geomesh::geomodel {

namespace {

constexpr std::size_t edge_ends[6][2] = {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}};

struct Edge {
  VertexIndex a, b;
  bool operator<(const Edge& o) const { return a != o.a ? a < o.a : b < o.b; }
  bool operator==(const Edge& o) const { return a == o.a && b == o.b; }
};
Edge edge(VertexIndex a, VertexIndex b) { return {std::min(a, b), std::max(a, b)}; }

/// A number with a bound on its rounding error. Every operation adds half an ulp of its result to the bound.
struct Bounded {
  double value, error;
};
constexpr double ulp = std::numeric_limits<double>::epsilon();
Bounded operator+(Bounded a, Bounded b) {
  const double v = a.value + b.value;
  return {v, (a.error + b.error + std::abs(v) * ulp) * (1 + 4 * ulp)};
}
Bounded operator-(Bounded a, Bounded b) { return a + Bounded{-b.value, b.error}; }
Bounded operator*(Bounded a, Bounded b) {
  const double v = a.value * b.value;
  return {v, (std::abs(a.value) * b.error + std::abs(b.value) * a.error + a.error * b.error + std::abs(v) * ulp +
              std::numeric_limits<double>::min()) *
                 (1 + 8 * ulp)};
}

using Vector = std::array<Bounded, 3>;
Bounded determinant(const Vector& a, const Vector& b, const Vector& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}

}  // namespace

double half_way(double a, double b) { return a / 2 + b / 2; }
Vec3 half_way(const Vec3& a, const Vec3& b) { return {half_way(a.x, b.x), half_way(a.y, b.y), half_way(a.z, b.z)}; }

/// The Jacobian's determinant is computed from its Bezier coefficients. Each derivative of the quadratic map is linear
/// and given by four vectors at the corners, so the coefficient for the corners i <= j <= k is the mean over all
/// assignments of i, j and k to the three derivatives.
bool jacobian_is_positive(const std::array<Vec3, 10>& nodes) {
  // Bezier points of the quadratic map: the corners, and 2 m - (a + b) / 2 for the edge ab with midpoint m.
  const auto at = [&](std::size_t i, std::size_t j, std::size_t k) -> Bounded {
    if (i == j) return {nodes[i][k], 0};
    for (std::size_t e = 0; e < 6; ++e)
      if ((edge_ends[e][0] == i && edge_ends[e][1] == j) || (edge_ends[e][0] == j && edge_ends[e][1] == i))
        return Bounded{2, 0} * Bounded{nodes[4 + e][k], 0} -
               Bounded{0.5, 0} * (Bounded{nodes[i][k], 0} + Bounded{nodes[j][k], 0});
    return {0, 0};
  };
  // Derivative of the element's quadratic map along 3 axes, at the 4 corners.
  std::array<std::array<Vector, 4>, 3> derivative;
  for (std::size_t d = 0; d < 3; ++d)
    for (std::size_t c = 0; c < 4; ++c)
      for (std::size_t k = 0; k < 3; ++k) derivative[d][c][k] = at(d + 1, c, k) - at(0, c, k);
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i; j < 4; ++j)
      for (std::size_t l = j; l < 4; ++l) {
        std::array<std::size_t, 3> corner{i, j, l};
        Bounded sum{0, 0};
        std::sort(corner.begin(), corner.end());
        do {
          sum = sum + determinant(derivative[0][corner[0]], derivative[1][corner[1]], derivative[2][corner[2]]);
        } while (std::next_permutation(corner.begin(), corner.end()));
        if (!(sum.value > sum.error)) return false;
      }
  return true;
}

std::size_t n_unproven_jacobians(const ModelMesh& mesh, std::size_t* first) {
  std::size_t n = 0;
  for (std::size_t t = 0; t < mesh.midpoints.of_tetrahedron.size(); ++t) {
    std::array<Vec3, 10> nodes;
    for (std::size_t i = 0; i < 4; ++i) nodes[i] = mesh.points[mesh.tetrahedra[t][i]];
    for (std::size_t e = 0; e < 6; ++e)
      nodes[4 + e] = mesh.midpoints.points[mesh.midpoints.of_tetrahedron[t][e] - mesh.points.size()];
    if (jacobian_is_positive(nodes)) continue;
    if (n++ == 0 && first) *first = t;
  }
  return n;
}

void add_midpoints(ModelMesh& mesh) {
  std::vector<Edge> edges;
  edges.reserve(6 * mesh.tetrahedra.size());
  for (const Tetrahedron& t : mesh.tetrahedra)
    for (const auto& [i, j] : edge_ends) edges.push_back(edge(t[i], t[j]));
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  const std::size_t n = mesh.points.size();
  if (n + edges.size() >= no_vertex)
    throw Error(ErrorKind::cannot_mesh, "elements of second order need more nodes than 32 bits can count");
  const auto node = [&](VertexIndex a, VertexIndex b) {
    const auto found = std::lower_bound(edges.begin(), edges.end(), edge(a, b));
    return static_cast<VertexIndex>(n + static_cast<std::size_t>(found - edges.begin()));
  };
  Midpoints mid;
  for (const Edge& e : edges) {
    const Vec3 &p = mesh.points[e.a], &q = mesh.points[e.b];
    mid.points.push_back(half_way(p, q));
  }
  for (PointArray& array : mesh.point_arrays)
    for (const Edge& e : edges) array.values.push_back(half_way(array.values[e.a], array.values[e.b]));
  for (const CurvedEdge& curved : mesh.curved_edges) {
    const auto found = std::lower_bound(edges.begin(), edges.end(), edge(curved.a, curved.b));
    if (found == edges.end() || !(*found == edge(curved.a, curved.b))) continue;
    const auto row = static_cast<std::size_t>(found - edges.begin());
    mid.points[row] = curved.middle;
    for (std::size_t k = 0; k < std::min(curved.values.size(), mesh.point_arrays.size()); ++k)
      mesh.point_arrays[k].values[n + row] = curved.values[k];
  }
  for (const Tetrahedron& t : mesh.tetrahedra) {
    std::array<VertexIndex, 6> nodes{};
    for (std::size_t e = 0; e < 6; ++e) nodes[e] = node(t[edge_ends[e][0]], t[edge_ends[e][1]]);
    mid.of_tetrahedron.push_back(nodes);
  }
  for (const auto& face : mesh.faces) {
    const Triangle& v = face.vertices;
    mid.of_face.push_back({node(v[0], v[1]), node(v[1], v[2]), node(v[2], v[0])});
  }
  for (const auto& e : mesh.curve_edges) mid.of_curve_edge.push_back(node(e.a, e.b));
  mesh.midpoints = std::move(mid);
  std::size_t worst = 0;
  if (const std::size_t bad = n_unproven_jacobians(mesh, &worst); bad > 0) {
    const Vec3& p = mesh.points[mesh.tetrahedra[worst][0]];
    throw Error(ErrorKind::cannot_mesh,
                std::to_string(bad) +
                    " elements of second order are so flat that their Jacobian is not proven positive in "
                    "doubles, the first at (" +
                    std::to_string(p.x) + ", " + std::to_string(p.y) + ", " + std::to_string(p.z) +
                    "); write order 1, or mesh with a quality",
                {{}, {}, {}, {p}});
  }
}

}  // namespace geomesh::geomodel
