// SPDX-License-Identifier: GPL-3.0-or-later
#include "init/template_surfaces.hpp"

#include <charconv>
#include <cmath>
#include <numbers>

namespace geomesh::geomodel {
namespace {

/// Adds two triangles for each cell of a grid of (n+1) x (n+1) nodes, stored row by row, with alternating diagonals.
void add_grid_triangles(TriangulatedSurface& surface, int n) {
  const auto node = [n](int i, int j) { return static_cast<VertexIndex>(j * (n + 1) + i); };
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const VertexIndex a = node(i, j), b = node(i + 1, j), c = node(i + 1, j + 1), d = node(i, j + 1);
      if ((i + j) % 2 == 0) {
        surface.triangles.push_back({a, b, c});
        surface.triangles.push_back({a, c, d});
      } else {
        surface.triangles.push_back({a, b, d});
        surface.triangles.push_back({b, c, d});
      }
    }
}

void append_number(std::string& text, double value) {
  char buffer[32];
  const auto result = std::to_chars(buffer, buffer + sizeof buffer, value);
  text.append(buffer, result.ptr);
}

void append_vertices(std::string& text, const std::vector<Vec3>& points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    text += "VRTX " + std::to_string(i + 1);
    for (std::size_t k = 0; k < 3; ++k) {
      text += ' ';
      append_number(text, points[i][k]);
    }
    text += '\n';
  }
}

}  // namespace

TriangulatedSurface height_surface(const std::string& name, const MapGrid& grid,
                                   const std::function<double(double, double)>& height) {
  const auto [x0, x1, y0, y1, n] = grid;
  TriangulatedSurface surface;
  surface.name = name;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) {
      const double x = x0 + (x1 - x0) * i / n, y = y0 + (y1 - y0) * j / n;
      surface.points.push_back({x, y, height(x, y)});
    }
  add_grid_triangles(surface, n);
  return surface;
}

TriangulatedSurface sheet_surface(const std::string& name, const Vec3& origin, const Vec3& u, const Vec3& v, int n) {
  TriangulatedSurface surface;
  surface.name = name;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) surface.points.push_back(origin + (double(i) / n) * u + (double(j) / n) * v);
  add_grid_triangles(surface, n);
  return surface;
}

TriangulatedSurface revolved_surface(const std::string& name, const Axis& axis,
                                     const std::function<double(double)>& radius) {
  const auto [x, y, bottom, top, rings, sectors] = axis;
  TriangulatedSurface surface;
  surface.name = name;
  surface.points.push_back({x, y, bottom});
  for (int r = 1; r < rings; ++r)
    for (int s = 0; s < sectors; ++s) {
      const double t = double(r) / rings, angle = 2 * std::numbers::pi * (s + 0.5 * (r % 2)) / sectors;
      surface.points.push_back(
          {x + radius(t) * std::cos(angle), y + radius(t) * std::sin(angle), bottom + t * (top - bottom)});
    }
  surface.points.push_back({x, y, top});
  const auto last = static_cast<VertexIndex>(surface.points.size() - 1);
  const auto node = [sectors = axis.sectors](int r, int s) {
    return static_cast<VertexIndex>(1 + (r - 1) * sectors + s % sectors);
  };
  for (int s = 0; s < sectors; ++s) surface.triangles.push_back({0, node(1, s + 1), node(1, s)});
  for (int r = 1; r + 1 < rings; ++r)
    for (int s = 0; s < sectors; ++s) {
      surface.triangles.push_back({node(r, s), node(r, s + 1), node(r + 1, s)});
      surface.triangles.push_back({node(r, s + 1), node(r + 1, s + 1), node(r + 1, s)});
    }
  for (int s = 0; s < sectors; ++s) surface.triangles.push_back({last, node(rings - 1, s), node(rings - 1, s + 1)});
  return surface;
}

std::string to_gocad(const Polyline& line) {
  std::string text = "GOCAD PLine 1\nHEADER {\nname: " + line.name + "\n}\nILINE\n";
  append_vertices(text, line.points);
  for (std::size_t i = 1; i < line.points.size(); ++i)
    text += "SEG " + std::to_string(i) + ' ' + std::to_string(i + 1) + '\n';
  return text + "END\n";
}

std::string to_gocad(const TriangulatedSurface& surface) {
  std::string text = "GOCAD TSurf 1\nHEADER {\nname: " + surface.name + "\n}\nTFACE\n";
  append_vertices(text, surface.points);
  for (const Triangle& t : surface.triangles)
    text += "TRGL " + std::to_string(t[0] + 1) + ' ' + std::to_string(t[1] + 1) + ' ' + std::to_string(t[2] + 1) + '\n';
  return text + "END\n";
}

}  // namespace geomesh::geomodel
