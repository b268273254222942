// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/exact/vertical_line.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "check/exact/exact.hpp"

namespace geomesh::geomodel::checking {

BoxTree tree_over_triangles(const TriangulatedSurface& surface) {
  std::vector<Box3> boxes;
  for (const Triangle& t : surface.triangles)
    boxes.push_back(box_of(surface.points[t[0]], surface.points[t[1]], surface.points[t[2]]));
  return BoxTree(std::move(boxes));
}

void for_each_height(const TriangulatedSurface& surface, const BoxTree& tree, const Vec3& p, double room,
                     const std::function<void(Index, double)>& visit) {
  Box3 line = inflated(box_of(p, p, p), room);
  line.min.z = -std::numeric_limits<double>::infinity();
  line.max.z = std::numeric_limits<double>::infinity();
  tree.query(line, [&](Index row) {
    const Triangle& t = surface.triangles[row];
    const Vec3 &a = surface.points[t[0]], &b = surface.points[t[1]], &c = surface.points[t[2]];
    const Sign turn = projected_orientation(a, b, c, 2);
    if (turn == Sign::zero) return;  // vertical: the triangles beside it determine where the line crosses
    for (const auto& [u, v] : {std::pair(&a, &b), std::pair(&b, &c), std::pair(&c, &a)}) {
      if (projected_orientation(*u, *v, p, 2) * turn != Sign::negative) continue;
      const double length = std::hypot(v->x - u->x, v->y - u->y);
      const double off = std::abs((v->x - u->x) * (p.y - u->y) - (v->y - u->y) * (p.x - u->x)) / length;
      if (!(off <= room)) return;
    }
    const Vec3 n = cross(b - a, c - a);
    const double z = a.z - (n.x * (p.x - a.x) + n.y * (p.y - a.y)) / n.z;
    visit(row, std::clamp(z, std::min({a.z, b.z, c.z}), std::max({a.z, b.z, c.z})));
  });
}

}  // namespace geomesh::geomodel::checking
