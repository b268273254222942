// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus_builder.hpp"

#include <array>
#include <cmath>

namespace geomesh::test {

VertexIndex PlcBuilder::vertex(const Vec3& p) {
  const auto [it, is_new] = rows_.try_emplace(p, static_cast<VertexIndex>(plc.points.size()));
  if (is_new) plc.points.push_back(p);
  return it->second;
}

std::vector<VertexIndex> PlcBuilder::vertices(std::span<const Vec3> points) {
  std::vector<VertexIndex> rows;
  for (const Vec3& p : points) rows.push_back(vertex(p));
  return rows;
}

Index PlcBuilder::polygon(std::span<const Vec3> loop) {
  const std::vector<VertexIndex> rows = vertices(loop);
  return plc.add_polygon(std::span(&rows, 1));
}

Index PlcBuilder::polygon_with_holes(std::span<const std::vector<Vec3>> loops) {
  std::vector<std::vector<VertexIndex>> rows;
  for (const auto& loop : loops) rows.push_back(vertices(loop));
  return plc.add_polygon(rows);
}

Index PlcBuilder::box(const Vec3& a, const Vec3& b) {
  const auto corner = [&](int i) { return Vec3{i & 1 ? b.x : a.x, i & 2 ? b.y : a.y, i & 4 ? b.z : a.z}; };
  const auto side = [&](int p, int q, int r, int s) { return polygon({corner(p), corner(q), corner(r), corner(s)}); };
  const Index first = side(0, 2, 3, 1);
  side(4, 5, 7, 6);
  side(0, 1, 5, 4);
  side(1, 3, 7, 5);
  side(3, 2, 6, 7);
  side(2, 0, 4, 6);
  return first;
}

void add_shell(PlcBuilder& builder, const Shell& shell) {
  for (const Triangle& t : shell.triangles)
    builder.triangle(shell.points[t[0]], shell.points[t[1]], shell.points[t[2]]);
}

double volume(const Shell& shell) {
  double sum = 0;
  const Vec3 o = shell.points[0];
  for (const Triangle& t : shell.triangles)
    sum += dot(cross(shell.points[t[0]] - o, shell.points[t[1]] - o), shell.points[t[2]] - o) / 6;
  return sum;
}

Shell sphere(const Vec3& centre, double radius, unsigned level) {
  Shell shell;
  std::map<std::array<double, 3>, VertexIndex> rows;
  const auto vertex = [&](Vec3 p) {
    const Vec3 q = centre + (radius / std::sqrt(dot(p, p))) * p;
    const auto [it, is_new] = rows.try_emplace({q.x, q.y, q.z}, static_cast<VertexIndex>(shell.points.size()));
    if (is_new) shell.points.push_back(q);
    return it->second;
  };
  const auto split = [&](auto&& self, const Vec3& a, const Vec3& b, const Vec3& c, unsigned n) -> void {
    if (n == 0) return shell.triangles.push_back({vertex(a), vertex(b), vertex(c)});
    const auto middle = [](const Vec3& p, const Vec3& q) {
      const Vec3 m = p + q;
      return (1 / std::sqrt(dot(m, m))) * m;
    };
    const Vec3 ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    self(self, a, ab, ca, n - 1);
    self(self, ab, b, bc, n - 1);
    self(self, ca, bc, c, n - 1);
    self(self, ab, bc, ca, n - 1);
  };
  for (int octant = 0; octant < 8; ++octant) {
    const Vec3 x{octant & 1 ? -1.0 : 1.0, 0, 0}, y{0, octant & 2 ? -1.0 : 1.0, 0}, z{0, 0, octant & 4 ? -1.0 : 1.0};
    const bool flipped = ((octant & 1) + ((octant >> 1) & 1) + ((octant >> 2) & 1)) % 2 == 1;
    flipped ? split(split, x, z, y, level) : split(split, x, y, z, level);
  }
  return shell;
}

}  // namespace geomesh::test
