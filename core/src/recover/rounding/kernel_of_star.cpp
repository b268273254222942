// SPDX-License-Identifier: MIT
#include "recover/rounding/kernel_of_star.hpp"

#include <algorithm>
#include <cmath>

namespace geomesh::recover {

using exact::LongExpansion;
using exact::TwoDouble;

namespace {

using ExactVector = std::array<LongExpansion, 3>;

TwoDouble wide(const LongExpansion& e) {
  const double hi = e.estimate();
  return {hi, (e - LongExpansion(hi)).estimate()};
}

ExactVector offset(const ConstrainedMesh& mesh, VertexIndex from, VertexIndex to) {
  ExactVector out;
  for (std::size_t i = 0; i < 3; ++i) out[i] = mesh.coordinate(to, i) - mesh.coordinate(from, i);
  return out;
}

/// Returns six times the volume of the tetrahedron of a face and a point, as a linear function of the point.
WidePlane plane_of(const ConstrainedMesh& mesh, const Triangle& face, const Vec3& origin) {
  const ExactVector u = offset(mesh, face[0], face[1]), v = offset(mesh, face[0], face[2]);
  WidePlane out;
  LongExpansion at;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    const LongExpansion n = u[j] * v[k] - u[k] * v[j];
    out.normal[i] = wide(n);
    at = at + n * (LongExpansion(origin[i]) - mesh.coordinate(face[0], i));
  }
  out.at = wide(at);
  return out;
}

}  // namespace

std::optional<WidePolyhedron> kernel_of_star(const ConstrainedMesh& mesh, const std::vector<CellIndex>& star,
                                             VertexIndex x) {
  WidePolyhedron out;
  Vec3 largest;
  for (const CellIndex c : star)
    for (const VertexIndex v : mesh.cells().vertices(c))
      for (std::size_t i = 0; i < 3; ++i) largest[i] = std::max(largest[i], std::fabs(mesh.point(v)[i]));
  for (std::size_t i = 0; i < 3; ++i) {
    if (!(largest[i] > 0)) return std::nullopt;
    out.spacing[i] = std::ldexp(1.0, std::ilogb(largest[i]) - 52);
    out.origin[i] = std::round(mesh.point(x)[i] / out.spacing[i]) * out.spacing[i];
    out.inside[i] = wide(mesh.coordinate(x, i) - LongExpansion(out.origin[i]));
  }
  for (const CellIndex c : star) {
    const Tetrahedron& v = mesh.cells().vertices(c);
    const auto& f = face_vertices[mesh.cells().index_of(c, x)];
    out.planes.push_back(plane_of(mesh, {v[f[0]], v[f[1]], v[f[2]]}, out.origin));
  }
  return out;
}

}  // namespace geomesh::recover
