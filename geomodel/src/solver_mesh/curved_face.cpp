// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver_mesh/curved_face.hpp"

#include <algorithm>
#include <cmath>

#include "geomesh/core/surface_distance.hpp"

namespace geomesh::geomodel {

namespace {

double length(const Vec3& v) { return std::sqrt(dot(v, v)); }

enum class Verdict { within, beyond, open };

/// Approximates a second-order face by flat triangles with `n` pieces on each edge, and tests these against the
/// surface. `off` is the largest distance of the face from the triangles.
Verdict judge(const std::array<Vec3, 6>& nodes, const SurfaceDistance& surface, double limit, int n, double off) {
  const auto place = [&](int i, int j) {
    return place_on_face(nodes,
                         {static_cast<double>(n - i - j) / n, static_cast<double>(i) / n, static_cast<double>(j) / n});
  };
  Verdict verdict = Verdict::within;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; i + j <= n; ++j) {
      const Vec3 p = place(i, j);
      if (length(surface.closest(p) - p) > limit) return Verdict::beyond;
      if (i + j == n || verdict == Verdict::open) continue;
      const Vec3 right = place(i + 1, j), up = place(i, j + 1);
      if (!surface.is_within({p, right, up}, limit - off)) verdict = Verdict::open;
      if (i + j + 2 <= n && !surface.is_within({right, place(i + 1, j + 1), up}, limit - off)) verdict = Verdict::open;
    }
  return verdict;
}

}  // namespace

Vec3 place_on_face(const std::array<Vec3, 6>& nodes, const std::array<double, 3>& at) {
  Vec3 p{0, 0, 0};
  for (std::size_t i = 0; i < 3; ++i)
    p = p + (at[i] * (2 * at[i] - 1)) * nodes[i] + (4 * at[i] * at[(i + 1) % 3]) * nodes[3 + i];
  return p;
}

bool is_face_within(const std::array<Vec3, 6>& nodes, const SurfaceDistance& surface, double limit) {
  constexpr int most_pieces = 16;
  // Limit on the distance between a curved face and its flat triangles, as a share of the tolerance `limit`; finer flat
  // triangles are made until the distance is below it.
  constexpr double most_off = 0.25;
  double bend = 0;
  for (std::size_t i = 0; i < 3; ++i)
    bend = std::max(bend, length(nodes[3 + i] - 0.5 * (nodes[i] + nodes[(i + 1) % 3])));
  for (int n = 1; n <= most_pieces; n *= 2) {
    const double off = 4 * bend / (3.0 * n * n);
    if (off > most_off * limit) continue;
    const Verdict verdict = judge(nodes, surface, limit, n, off);
    if (verdict != Verdict::open) return verdict == Verdict::within;
  }
  return false;
}

}  // namespace geomesh::geomodel
