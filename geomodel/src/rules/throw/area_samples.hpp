// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Samples points all over a surface, each with the area that it represents.
#pragma once

#include <cmath>

#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel {

Vec3 centre_of(const TriangulatedSurface& surface, const Triangle& triangle);
double area_of(const TriangulatedSurface& surface, Index triangle);

/// Divides large triangles into equal parts, so that the area on each side of a fault can be measured even for a few
/// large triangles. A surface has at least about 500 parts; a triangle smaller than a part is not divided.
class AreaSamples {
 public:
  /// Precondition: the sampled surface outlives the AreaSamples. O(triangles).
  explicit AreaSamples(const TriangulatedSurface& surface);

  /// Divides a triangle into equal parts, and calls visit(place, area) for each.
  template <class F>
  void for_each(Index triangle, F&& visit) const {
    const Triangle& v = surface_.triangles[triangle];
    const double area = area_of(surface_, triangle);
    const int n = parts_along_side(area);
    if (n == 1) return visit(centre_of(surface_, v), area);
    const Vec3 &a = surface_.points[v[0]], ab = surface_.points[v[1]] - a, ac = surface_.points[v[2]] - a;
    const double part = area / (double(n) * n);
    for (int i = 0; i < n; ++i)
      for (int j = 0; i + j < n; ++j) {
        visit(a + ((i + 1.0 / 3) / n) * ab + ((j + 1.0 / 3) / n) * ac, part);
        if (i + j + 1 < n) visit(a + ((i + 2.0 / 3) / n) * ab + ((j + 2.0 / 3) / n) * ac, part);
      }
  }

 private:
  int parts_along_side(double area) const {
    return area > largest_ ? static_cast<int>(std::ceil(std::sqrt(area / largest_))) : 1;
  }

  const TriangulatedSurface& surface_;
  double largest_ = 0;  ///< largest area of the parts of divided triangles; infinite if the surface has no area
};

}  // namespace geomesh::geomodel
