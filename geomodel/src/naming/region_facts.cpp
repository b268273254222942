// SPDX-License-Identifier: GPL-3.0-or-later
#include "naming/region_facts.hpp"

#include <algorithm>
#include <cstdio>

#include "geomesh/core/predicates.hpp"
#include "naming/sums.hpp"

namespace geomesh::geomodel {

namespace {

struct Sums {
  CompensatedSum volume;
  std::array<CompensatedSum, 3> moment;
  double largest = -1;
};

/// Marks components that are not enclosed: they meet the outside across a face that belongs only to the convex hull.
void find_open_hull(const ConstrainedTetrahedralization& mesh, const PolygonSoup& soup, const ModelPlc& plc,
                    Index hull_surface, std::vector<ComponentFacts>& facts) {
  for (const auto& face : mesh.faces) {
    const Index below = component_of(mesh, face.tetrahedron_below), above = component_of(mesh, face.tetrahedron_above);
    if (below != no_index && above != no_index) continue;
    const auto origins = origins_of(soup, plc, face.facet);
    const bool hull_alone = std::all_of(origins.begin(), origins.end(),
                                        [&](const PolygonSoup::Origin& o) { return o.surface == hull_surface; });
    if (hull_alone) facts[below != no_index ? below : above].enclosed = false;
  }
}

void find_first_triangles(const ConstrainedTetrahedralization& mesh, const PolygonSoup& soup, const ModelPlc& plc,
                          std::vector<ComponentFacts>& facts) {
  for (const auto& face : mesh.faces) {
    for (const PolygonSoup::Origin& o : origins_of(soup, plc, face.facet)) {
      for (const bool above : {false, true}) {
        const Index c = component_of(mesh, above ? face.tetrahedron_above : face.tetrahedron_below);
        if (c == no_index) continue;
        const std::array<Index, 3> key{o.surface, o.triangle, above != o.reversed ? 1u : 0u};
        facts[c].first_triangle = std::min(facts[c].first_triangle, key);
      }
    }
  }
}

}  // namespace

std::vector<ComponentFacts> component_facts(const ConstrainedTetrahedralization& mesh, const PolygonSoup& soup,
                                            const ModelPlc& plc, Index hull_surface) {
  std::vector<ComponentFacts> facts(mesh.n_components);
  std::vector<Sums> sums(mesh.n_components);
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t) {
    const Tetrahedron& v = mesh.tetrahedra[t];
    const Vec3 &a = mesh.points[v[0]], &b = mesh.points[v[1]], &c = mesh.points[v[2]], &d = mesh.points[v[3]];
    ComponentFacts& fact = facts[mesh.component[t]];
    Sums& sum = sums[mesh.component[t]];
    const double volume = signed_volume(a, b, c, d);
    const Vec3 middle = 0.25 * ((a + b) + (c + d));
    sum.volume.add(volume);
    for (std::size_t i = 0; i < 3; ++i) sum.moment[i].add(volume * middle[i]);
    if (volume > sum.largest) {
      sum.largest = volume;
      fact.inside_point = middle;
    }
    for (VertexIndex p : v) {
      const Vec3& point = mesh.points[p];
      const bool first = fact.n_tetrahedra == 0 && p == v[0];
      if (first || compare_lexicographic(point, fact.min_point) < 0) fact.min_point = point;
      if (first || compare_lexicographic(point, fact.max_point) > 0) fact.max_point = point;
    }
    ++fact.n_tetrahedra;
  }
  for (std::size_t c = 0; c < facts.size(); ++c) {
    facts[c].volume = sums[c].volume.value();
    for (std::size_t i = 0; i < 3; ++i)
      facts[c].centroid[i] =
          facts[c].volume > 0 ? sums[c].moment[i].value() / facts[c].volume : facts[c].inside_point[i];
  }
  find_first_triangles(mesh, soup, plc, facts);
  if (hull_surface != no_index) find_open_hull(mesh, soup, plc, hull_surface, facts);
  return facts;
}

std::string to_text(const Vec3& place) {
  char text[128];
  std::snprintf(text, sizeof text, "(%.8g, %.8g, %.8g)", place.x, place.y, place.z);
  return text;
}

std::string to_text(double measure) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", measure);
  return text;
}

}  // namespace geomesh::geomodel
