// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Models for recovery that the arrangement makes valid: random soups, and the outside faults in a box.
#pragma once

#include "arrangement_inputs.hpp"
#include "geomesh/core/plc.hpp"

namespace geomesh::geomodel::testing {

/// Facets, wells and points of an arranged soup as they are.
inline PiecewiseLinearComplex complex_of(const PolygonSoup& soup) {
  PiecewiseLinearComplex plc;
  plc.points = soup.points;
  for (const Triangle& t : soup.facets) plc.add_triangle(t);
  for (const PolygonSoup::Segment& s : soup.segments) plc.segments.push_back({s.a, s.b});
  for (const PolygonSoup::IsolatedPoint& p : soup.isolated_points) plc.isolated_points.push_back(p.v);
  return plc;
}

/// Seed even: nearly everything degenerate, on an integer grid. Odd: triangles of all sizes in general position. Always
/// in a box.
inline PiecewiseLinearComplex random_model(unsigned seed) {
  RandomSoup soup = random_soup(seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> coordinate(0, 1);
  if (seed % 2 == 1) {
    for (TriangulatedSurface& s : soup.surfaces)
      for (std::size_t t = 0; t < s.triangles.size(); ++t) {
        const Vec3 centre{coordinate(random), coordinate(random), coordinate(random)};
        const double size = 0.05 + coordinate(random);
        for (VertexIndex v : s.triangles[t])
          s.points[v] =
              centre + size * Vec3{coordinate(random) - 0.5, coordinate(random) - 0.5, coordinate(random) - 0.5};
      }
    soup.polylines.clear();
    soup.points.clear();
    soup.options.box = Box3{{0.1, 0.1, 0.1}, {0.9, 0.9, 0.9}};
  } else if (!soup.options.box) {
    soup.options.box = Box3{{-1, -1, -1}, {12, 12, 12}};
  }
  return complex_of(arrange(soup.surfaces, soup.polylines, soup.points, soup.options).soup);
}

/// A plate turned by an odd angle, so that no double lies in the planes of its walls, with `n` ellipsoids across one
/// wall: the wall is cut into long thin facets side by side, an ulp off one plane, with vertices of the ellipsoids
/// close before and behind them.
inline PiecewiseLinearComplex crossed_wall(unsigned seed, unsigned n) {
  std::mt19937 random(seed);
  const auto unit = [&] { return static_cast<double>(random()) / 4294967296.0; };
  TriangulatedSurface plate;
  plate.name = "plate";
  plate.kind = SurfaceKind::body;
  for (int i = 0; i < 8; ++i) plate.points.push_back({i & 1 ? 20.0 : 0.0, i & 2 ? 4.0 : 0.0, i & 4 ? 20.0 : 0.0});
  plate.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                     {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  std::vector<TriangulatedSurface> surfaces{plate};
  for (unsigned k = 0; k < n; ++k) {
    const double x = 1 + 18 * unit(), y = 0.3 * (unit() - 0.5), z = 1 + 18 * unit(), rx = 0.1 + unit(),
                 ry = 0.1 + unit(), rz = 0.1 + unit();
    surfaces.push_back(ellipsoid("body_" + std::to_string(k), {x, y, z}, {rx, ry, rz}, 2));
  }
  const double angle = 0.3 + unit(), c = std::cos(angle), s = std::sin(angle);
  for (TriangulatedSurface& surface : surfaces)
    for (Vec3& p : surface.points) p = {200 + c * p.x - s * p.y, 100 + s * p.x + c * p.y, p.z};
  return complex_of(arrange(surfaces, {}, {}, {}).soup);
}

/// All surfaces of a folder, intersected with each other and with the sides of a box a tenth larger than they are.
inline PiecewiseLinearComplex faults_in_box(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::vector<TriangulatedSurface> surfaces;
  Box3 box;
  for (const auto& file : files) {
    surfaces.push_back(load_ts(file));
    for (const Vec3& p : surfaces.back().points) box.add(p);
  }
  const Vec3 margin = 0.1 * (box.max - box.min);
  ArrangementOptions options;
  options.box = Box3{box.min - margin, box.max + margin};
  return complex_of(arrange(surfaces, {}, {}, options).soup);
}

}  // namespace geomesh::geomodel::testing
