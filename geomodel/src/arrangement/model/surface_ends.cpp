// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrangement/model/surface_ends.hpp"

#include <algorithm>
#include <tuple>

namespace geomesh::geomodel::arrangement {

std::vector<SurfaceEnd> surface_ends(const Complex& complex) {
  std::vector<SurfaceEnd> all;
  for (Index f = 0; f < complex.facets.size(); ++f) {
    const Triangle& t = complex.facets[f];
    Index last = no_index;  // origins of one surface follow each other
    for (const Origin& o : complex.origins.of(f)) {
      if (o.surface == last) continue;
      last = o.surface;
      for (std::size_t k = 0; k < 3; ++k) {
        const auto [a, b] = std::minmax(t[k], t[(k + 1) % 3]);
        all.push_back({a, b, o.surface, f});
      }
    }
  }
  const auto place = [](const SurfaceEnd& e) { return std::tie(e.a, e.b, e.surface); };
  std::sort(all.begin(), all.end(), [&](const SurfaceEnd& x, const SurfaceEnd& y) { return place(x) < place(y); });
  std::vector<SurfaceEnd> ends;
  for (std::size_t i = 0, j; i < all.size(); i = j) {
    for (j = i + 1; j < all.size() && place(all[j]) == place(all[i]);) ++j;
    if (j == i + 1) ends.push_back(all[i]);
  }
  return ends;
}

}  // namespace geomesh::geomodel::arrangement
