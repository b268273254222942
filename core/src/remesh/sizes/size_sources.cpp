// SPDX-License-Identifier: MIT
#include "remesh/sizes/size_sources.hpp"

#include <limits>

namespace geomesh::remesh {

void cover_triangle(const std::array<Vec3, 3>& corners, const AskedSize& asked, std::vector<SizeSource>& sources) {
  const auto& [a, b, c] = corners;
  const double longest = std::max({distance(a, b), distance(b, c), distance(c, a)});
  const int n = std::clamp(static_cast<int>(std::ceil(longest / (2 * asked.size))), 1, 100);
  for (int i = 0; i <= n; ++i)
    for (int j = 0; i + j <= n; ++j) {
      const double u = static_cast<double>(i) / n, v = static_cast<double>(j) / n;
      sources.push_back({(1 - u - v) * a + u * b + v * c, asked.size, asked.radius + 0.75 * (longest / n)});
    }
}

void cover_curves(const DomainMesh& mesh, const std::vector<AskedSize>& asked, std::vector<SizeSource>& sources) {
  for (const auto& [from, to] : mesh.curve_edges())
    for (const Index s : mesh.curve_class(mesh.curve_of(from, to)).segments) {
      if (s >= asked.size() || !(asked[s].size > 0)) continue;
      const Vec3 a = mesh.point(from), b = mesh.point(to);
      const double l = distance(a, b);
      const int n = std::clamp(static_cast<int>(std::ceil(l / (2 * asked[s].size))), 1, 10000);
      for (int i = 0; i <= n; ++i)
        sources.push_back({a + (static_cast<double>(i) / n) * (b - a), asked[s].size, asked[s].radius + 0.5 * l / n});
    }
}

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Where a ray leaves a cell.
struct Exit {
  FaceRef face;
  double at = infinity;
  Vec3 normal;
};

Exit leave(const DomainMesh& mesh, FaceRef entered, const Vec3& origin, const Vec3& direction) {
  Exit first;
  for (unsigned k = 0; k < 4; ++k) {
    const FaceRef f(entered.cell(), k);
    if (f == entered) continue;
    const Triangle t = mesh.face(f);
    const Vec3 m = mesh.normal(t);
    const double speed = -dot(m, direction);
    if (!(speed > 0)) continue;
    const double at = dot(m, origin - mesh.point(t[0])) / speed;
    if (at < first.at) first = {f, at, m};
  }
  return first;
}

}  // namespace

double gap_width(const DomainMesh& mesh, FaceRef face, const Vec3& origin) {
  constexpr unsigned most_steps = 500;
  constexpr double least_cosine = 0.5;
  const Triangle from = mesh.face(face);
  const Vec3 direction = unit(mesh.normal(from));
  for (unsigned step = 0; step < most_steps; ++step) {
    const Exit out = leave(mesh, face, origin, direction);
    if (!out.face.valid()) return infinity;
    if (mesh.tag(out.face).constrained()) {
      const Triangle to = mesh.face(out.face);
      const bool is_corner = std::ranges::any_of(to, [&](VertexIndex v) { return std::ranges::count(from, v) > 0; });
      const bool is_facing = -dot(out.normal, direction) > least_cosine * length(out.normal);
      return is_facing && !is_corner ? std::max(out.at, 0.0) : infinity;
    }
    face = mesh.cells().mirror(out.face);
  }
  return infinity;
}

}  // namespace geomesh::remesh
