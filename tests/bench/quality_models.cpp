// SPDX-License-Identifier: GPL-3.0-or-later
#include "quality_models.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <map>
#include <random>
#include <sstream>

#include "remesh/domain/merge_pieces.hpp"
#include "test_places.hpp"

namespace geomesh::bench {

namespace {

Vec3 unit(const Vec3& p) { return (1 / std::sqrt(dot(p, p))) * p; }

struct Surface {
  std::vector<Vec3> points;
  std::vector<Triangle> triangles;
};

/// Icosahedron, each face cut in four, twice: 162 vertices, 320 triangles on the unit sphere.
Surface icosphere() {
  const double g = (1 + std::sqrt(5.0)) / 2;
  Surface s;
  for (const Vec3& p :
       {Vec3{-1, g, 0}, Vec3{1, g, 0}, Vec3{-1, -g, 0}, Vec3{1, -g, 0}, Vec3{0, -1, g}, Vec3{0, 1, g}, Vec3{0, -1, -g},
        Vec3{0, 1, -g}, Vec3{g, 0, -1}, Vec3{g, 0, 1}, Vec3{-g, 0, -1}, Vec3{-g, 0, 1}})
    s.points.push_back(unit(p));
  s.triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                 {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                 {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  for (int level = 0; level < 2; ++level) {
    std::map<std::pair<VertexIndex, VertexIndex>, VertexIndex> middles;
    const auto middle = [&](VertexIndex a, VertexIndex b) {
      const auto [it, is_new] = middles.try_emplace(std::minmax(a, b), static_cast<VertexIndex>(s.points.size()));
      if (is_new) s.points.push_back(unit(s.points[a] + s.points[b]));
      return it->second;
    };
    std::vector<Triangle> finer;
    for (const auto& [a, b, c] : s.triangles) {
      const VertexIndex ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      for (const Triangle& t : {Triangle{a, ab, ca}, Triangle{b, bc, ab}, Triangle{c, ca, bc}, Triangle{ab, bc, ca}})
        finer.push_back(t);
    }
    s.triangles = std::move(finer);
  }
  return s;
}

/// Radius as a sum of six smooth bumps in random directions.
void roughen(Surface& s, double roughness, std::mt19937& random) {
  std::uniform_real_distribution<double> u(-1, 1);
  std::array<Vec3, 6> directions;
  std::array<double, 6> heights;
  for (Vec3& d : directions) d = unit({u(random), u(random), u(random) + 1e-3});
  for (double& h : heights) h = roughness * u(random);
  for (Vec3& p : s.points) {
    double r = 1;
    for (std::size_t k = 0; k < 6; ++k) r += heights[k] * std::exp(4 * (dot(p, directions[k]) - 1));
    p = r * p;
  }
}

void add_gridded_box(QualityModel& model, const Vec3& low, const Vec3& high, int n) {
  std::map<std::array<int, 3>, VertexIndex> ids;
  const auto at = [&](const std::array<int, 3>& i) {
    const auto [it, is_new] = ids.try_emplace(i, static_cast<VertexIndex>(model.plc.points.size()));
    const Vec3 d = high - low;
    if (is_new) model.plc.points.push_back(low + Vec3{d.x * i[0] / n, d.y * i[1] / n, d.z * i[2] / n});
    return it->second;
  };
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (int side = 0; side < 2; ++side)
      for (int u = 0; u < n; ++u)
        for (int v = 0; v < n; ++v) {
          const auto corner = [&](int du, int dv) {
            std::array<int, 3> i{};
            i[axis] = side * n;
            i[(axis + 1) % 3] = u + du;
            i[(axis + 2) % 3] = v + dv;
            return at(i);
          };
          VertexIndex a = corner(0, 0), b = corner(1, 0), c = corner(1, 1), d = corner(0, 1);
          if (side == 0) std::swap(b, d);
          const Index provenance = static_cast<Index>(8 + 2 * axis + static_cast<std::size_t>(side));
          if ((u + v) % 2) std::swap(a, b), std::swap(b, c), std::swap(c, d);  // alternate diagonals
          model.plc.add_triangle({a, b, c}, provenance);
          model.plc.add_triangle({a, c, d}, provenance);
        }
}

}  // namespace

PiecewiseLinearComplex QualityModel::merged() const { return remesh::merge_pieces(plc, facet_parent).plc; }

double QualityModel::diagonal() const {
  Box3 box;
  for (const Vec3& p : plc.points) box.add(p);
  const Vec3 d = box.max - box.min;
  return std::sqrt(dot(d, d));
}

QualityModel grains(double roughness, unsigned seed) {
  QualityModel model;
  model.name = roughness > 0 ? "irregular grains" : "round grains";
  std::mt19937 random(seed);
  const double radius = 3.435, pitch = 8;
  for (unsigned k = 0; k < 8; ++k) {
    Surface s = icosphere();
    if (roughness > 0) roughen(s, roughness, random);
    const VertexIndex base = static_cast<VertexIndex>(model.plc.points.size());
    const Vec3 centre{pitch * (k & 1), pitch * ((k >> 1) & 1), pitch * ((k >> 2) & 1)};
    for (const Vec3& p : s.points) model.plc.points.push_back(centre + radius * p);
    for (const auto& [a, b, c] : s.triangles) model.plc.add_triangle({base + a, base + b, base + c}, k);
  }
  const double margin = radius * 1.3;
  add_gridded_box(model, {-margin, -margin, -margin}, {pitch + margin, pitch + margin, pitch + margin}, 16);
  return model;
}

QualityModel solid(const std::string& file) {
  QualityModel model;
  model.name = file;
  std::ifstream in(std::string(GEOMESH_SHARED_DATA "/solids/") + file);
  std::map<std::array<double, 3>, VertexIndex> rows;  // vertices with equal coordinates are one
  std::vector<VertexIndex> row;
  std::string line;
  while (std::getline(in, line)) {
    std::istringstream words(line);
    std::string kind;
    words >> kind;
    if (kind == "v") {
      Vec3 p;
      words >> p.x >> p.y >> p.z;
      const auto [it, is_new] = rows.try_emplace({p.x, p.y, p.z}, static_cast<VertexIndex>(model.plc.points.size()));
      if (is_new) model.plc.points.push_back(p);
      row.push_back(it->second);
    } else if (kind == "f") {
      Triangle t{};
      std::string word;
      for (VertexIndex& v : t) words >> word, v = row[std::stoul(word) - 1];
      model.plc.add_triangle(t, 0);
    }
  }
  return model;
}

}  // namespace geomesh::bench
