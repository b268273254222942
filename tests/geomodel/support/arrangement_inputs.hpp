// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Inputs for the tests of the arrangement: made surfaces, random soups, and small loaders for outside data.
#pragma once

#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "geomesh/geomodel/arrangement.hpp"
#include "scratch.hpp"

namespace geomesh::geomodel::testing {

/// n x n cells over [x0, x1] x [y0, y1] at height(x, y).
inline TriangulatedSurface grid_surface(const std::string& name, SurfaceKind kind, unsigned n, double x0, double x1,
                                        double y0, double y1, const std::function<double(double, double)>& height) {
  TriangulatedSurface s;
  s.name = name;
  s.kind = kind;
  for (unsigned j = 0; j <= n; ++j)
    for (unsigned i = 0; i <= n; ++i) {
      const double x = x0 + (x1 - x0) * i / n, y = y0 + (y1 - y0) * j / n;
      s.points.push_back({x, y, height(x, y)});
    }
  for (unsigned j = 0; j < n; ++j)
    for (unsigned i = 0; i < n; ++i) {
      const VertexIndex q = j * (n + 1) + i;
      s.triangles.push_back({q, q + 1, q + n + 2});
      s.triangles.push_back({q, q + n + 2, q + n + 1});
    }
  return s;
}

/// Closed: an ellipsoid of 8 * 4^levels triangles, normals outward.
inline TriangulatedSurface ellipsoid(const std::string& name, const Vec3& centre, const Vec3& radii, int levels) {
  TriangulatedSurface s;
  s.name = name;
  s.kind = SurfaceKind::body;
  s.points = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  s.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<VertexIndex, VertexIndex>, VertexIndex> middle;
    const auto split = [&](VertexIndex a, VertexIndex b) {
      const auto [at, is_new] =
          middle.try_emplace({std::min(a, b), std::max(a, b)}, static_cast<VertexIndex>(s.points.size()));
      if (is_new) {
        const Vec3 m = s.points[a] + s.points[b];
        s.points.push_back((1 / std::sqrt(dot(m, m))) * m);
      }
      return at->second;
    };
    std::vector<Triangle> finer;
    for (const auto& [a, b, c] : s.triangles) {
      const VertexIndex ab = split(a, b), bc = split(b, c), ca = split(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    s.triangles = std::move(finer);
  }
  for (Vec3& p : s.points) p = {centre.x + radii.x * p.x, centre.y + radii.y * p.y, centre.z + radii.z * p.z};
  return s;
}

inline TriangulatedSurface triangles(const std::string& name, const std::vector<std::array<Vec3, 3>>& list,
                                     SurfaceKind kind = SurfaceKind::surface) {
  TriangulatedSurface s;
  s.name = name;
  s.kind = kind;
  for (const auto& t : list) {
    const auto first = static_cast<VertexIndex>(s.points.size());
    s.points.insert(s.points.end(), t.begin(), t.end());
    s.triangles.push_back({first, first + 1, first + 2});
  }
  return s;
}

struct RandomSoup {
  std::vector<TriangulatedSurface> surfaces;
  std::vector<Polyline> polylines;
  std::vector<NamedPoint> points;
  ArrangementOptions options;
};
/// Triangles, a well and points on an integer grid of few values a side, so that nearly everything is degenerate.
inline RandomSoup random_soup(unsigned seed) {
  std::mt19937 random(seed);
  const unsigned side = 2 + seed % 9, n = 3 + random() % 20;
  const auto coordinate = [&] { return static_cast<double>(random() % (side + 1)); };
  const auto point = [&] { return Vec3{coordinate(), coordinate(), coordinate()}; };
  RandomSoup soup;
  for (const char* name : {"first", "second"}) {
    std::vector<std::array<Vec3, 3>> list;
    for (unsigned t = 0; t < n; ++t) list.push_back({point(), point(), point()});
    soup.surfaces.push_back(triangles(name, list));
  }
  soup.polylines.push_back({"well", "", {point(), point(), point(), point()}});
  for (int k = 0; k < 3; ++k) soup.points.push_back({"monitor", point()});
  if (seed % 3 == 0) soup.options.box = Box3{{0, 0, 0}, {double(side), double(side), double(side)}};
  if (seed % 3 == 1) soup.options.box = Box3{{0.5, 1, 0}, {side - 0.5, side + 1.0, 1}};
  return soup;
}

/// Turned about z and then y, so that next to nothing is exactly degenerate any more; without a box.
inline RandomSoup turned(RandomSoup soup, double angle) {
  const auto turn = [angle](Vec3& p) {
    const double c = std::cos(angle), s = std::sin(angle), d = std::cos(0.7 * angle + 0.1),
                 t = std::sin(0.7 * angle + 0.1);
    const Vec3 q{c * p.x - s * p.y, s * p.x + c * p.y, p.z};
    p = {d * q.x - t * q.z, q.y, t * q.x + d * q.z};
  };
  for (TriangulatedSurface& s : soup.surfaces)
    for (Vec3& p : s.points) turn(p);
  for (Polyline& line : soup.polylines)
    for (Vec3& p : line.points) turn(p);
  for (NamedPoint& p : soup.points) turn(p.point);
  soup.options.box.reset();
  return soup;
}

inline double volume_inside(const PolygonSoup& soup, const std::function<bool(const PolygonSoup::Origin&)>& counts) {
  double six_volumes = 0;
  for (Index f = 0; f < soup.facets.size(); ++f)
    for (Index k = soup.origin_offsets[f]; k < soup.origin_offsets[f + 1]; ++k) {
      if (!counts(soup.origins[k])) continue;
      const auto& [a, b, c] = soup.facets[f];
      const double v =
          dot(soup.points[a] - soup.points[0], cross(soup.points[b] - soup.points[0], soup.points[c] - soup.points[0]));
      six_volumes += soup.origins[k].reversed ? -v : v;
    }
  return six_volumes / 6;
}

inline TriangulatedSurface load_ts(const std::filesystem::path& file) {
  TriangulatedSurface s;
  s.name = file.stem().string();
  s.kind = SurfaceKind::fault;
  std::ifstream in(file);
  std::map<int, VertexIndex> row;
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string key;
    words >> key;
    if (key == "VRTX" || key == "PVRTX") {
      int id;
      Vec3 p;
      words >> id >> p.x >> p.y >> p.z;
      row[id] = static_cast<VertexIndex>(s.points.size());
      s.points.push_back(p);
    } else if (key == "TRGL") {
      int a, b, c;
      words >> a >> b >> c;
      s.triangles.push_back({row.at(a), row.at(b), row.at(c)});
    }
  }
  return s;
}

/// Several TSurf objects in one file.
inline std::vector<TriangulatedSurface> load_all_ts(const std::filesystem::path& file) {
  std::vector<TriangulatedSurface> all;
  std::ifstream in(file);
  std::ofstream part;
  const auto scratch = geomesh::geomodel::testing::scratch_folder() / ("geomesh_part_" + file.filename().string());
  std::string text;
  const auto flush = [&] {
    if (text.empty()) return;
    std::ofstream(scratch) << text;
    all.push_back(load_ts(scratch));
    all.back().name = "horizon_" + std::to_string(all.size());
    all.back().kind = SurfaceKind::horizon;
    text.clear();
  };
  for (std::string line; std::getline(in, line);) {
    text += line + "\n";
    if (line.rfind("END", 0) == 0 && line.find("HEADER") == std::string::npos && line.size() <= 4) flush();
  }
  std::filesystem::remove(scratch);
  return all;
}

inline TriangulatedSurface load_obj(const std::filesystem::path& file) {
  TriangulatedSurface s;
  s.name = file.stem().string();
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string key;
    words >> key;
    if (key == "v") {
      Vec3 p;
      words >> p.x >> p.y >> p.z;
      s.points.push_back(p);
    } else if (key == "f") {
      Triangle t{};
      for (VertexIndex& v : t) {
        std::string corner;
        words >> corner;
        v = static_cast<VertexIndex>(std::stoul(corner)) - 1;
      }
      s.triangles.push_back(t);
    }
  }
  return s;
}

/// Binary or ASCII.
inline TriangulatedSurface load_stl(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  std::vector<std::array<Vec3, 3>> list;
  std::uint32_t n = 0;
  if (bytes.size() > 84) std::memcpy(&n, bytes.data() + 80, 4);
  if (bytes.size() == 84 + 50 * std::size_t{n}) {
    for (std::size_t t = 0; t < n; ++t) {
      std::array<float, 9> c;
      std::memcpy(c.data(), bytes.data() + 84 + 50 * t + 12, 36);
      list.push_back({Vec3{c[0], c[1], c[2]}, Vec3{c[3], c[4], c[5]}, Vec3{c[6], c[7], c[8]}});
    }
  } else {
    std::istringstream text(bytes);
    std::vector<Vec3> corners;
    for (std::string word; text >> word;) {
      if (word != "vertex") continue;
      Vec3 p;
      text >> p.x >> p.y >> p.z;
      corners.push_back(p);
    }
    for (std::size_t k = 0; k + 2 < corners.size(); k += 3)
      list.push_back({corners[k], corners[k + 1], corners[k + 2]});
  }
  return triangles(file.stem().string(), list);
}

/// Bounding box of all points, wider by a tenth of its size on each side.
inline Box3 wide_box(const std::vector<TriangulatedSurface>& surfaces) {
  Box3 box;
  for (const auto& s : surfaces)
    for (const Vec3& p : s.points) box.add(p);
  const Vec3 margin = 0.1 * (box.max - box.min);
  return {box.min - margin, box.max + margin};
}

inline double ulps_of_largest(const PolygonSoup& soup, double distance) {
  double largest = 0;
  for (const Vec3& p : soup.points)
    for (std::size_t i = 0; i < 3; ++i) largest = std::max(largest, std::fabs(p[i]));
  return distance / std::ldexp(1.0, std::ilogb(largest) - 52);
}

inline double area_of(const PolygonSoup& soup, Index surface) {
  double sum = 0;
  for (Index f = 0; f < soup.facets.size(); ++f)
    for (Index k = soup.origin_offsets[f]; k < soup.origin_offsets[f + 1]; ++k)
      if (soup.origins[k].surface == surface) {
        const auto& [a, b, c] = soup.facets[f];
        const Vec3 n = cross(soup.points[b] - soup.points[a], soup.points[c] - soup.points[a]);
        sum += 0.5 * std::sqrt(dot(n, n));
      }
  return sum;
}

inline double area_of(const TriangulatedSurface& s) {
  double sum = 0;
  for (const auto& [a, b, c] : s.triangles) {
    const Vec3 n = cross(s.points[b] - s.points[a], s.points[c] - s.points[a]);
    sum += 0.5 * std::sqrt(dot(n, n));
  }
  return sum;
}

}  // namespace geomesh::geomodel::testing
