// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// One analytic, tilted, asymmetric plane written in every format that is read.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "geomesh/core/geometry.hpp"

namespace geomesh::geomodel {

/// z = -1000 + x / 4 - y / 2 about a corner with UTM-like coordinates, over 3 x 2 cells of 50 x 80 m; normals point up.
struct Plane {
  static constexpr double x0 = 432000.25, y0 = 6012345.5;
  std::vector<Vec3> points;
  std::vector<Triangle> triangles;
  Plane() {
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 4; ++i) points.push_back({x0 + 50 * i, y0 + 80 * j, height(50 * i, 80 * j)});
    for (VertexIndex j = 0; j < 2; ++j) {
      for (VertexIndex i = 0; i < 3; ++i) {
        const VertexIndex a = 4 * j + i, b = a + 1, c = a + 5, d = a + 4;
        triangles.push_back({a, b, c});
        triangles.push_back({a, c, d});
      }
    }
  }
  static double height(double dx, double dy) { return -1000 + dx / 4 - dy / 2; }
};

/// The bytes of a number, little-endian unless `big`, on machines that are little-endian.
template <class T>
void append(std::string& bytes, T value, bool big = false) {
  std::array<char, sizeof(T)> raw;
  std::memcpy(raw.data(), &value, sizeof(T));
  if (big) std::reverse(raw.begin(), raw.end());
  bytes.append(raw.data(), raw.size());
}

struct PlaneFile {
  std::string name, bytes;
  double tolerance = 0;      ///< of the format, in metres
  bool sees_its_end = true;  ///< a cut file can be told from a whole one
};
/// Files of triangles.
std::vector<PlaneFile> triangle_plane_files();
/// Grids and regular points, DXF and OMF.
std::vector<PlaneFile> grid_plane_files();
/// All of them, without GeoTIFF where its module was not built.
std::vector<PlaneFile> plane_files();
/// The bytes of one of them.
std::string plane_file(const std::string& name);

}  // namespace geomesh::geomodel
