// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Writes piecewise linear complexes by coordinates: equal points are one vertex.
#pragma once

#include <initializer_list>
#include <map>
#include <span>
#include <vector>

#include "geomesh/core/plc.hpp"

namespace geomesh::test {

class PlcBuilder {
 public:
  PiecewiseLinearComplex plc;

  VertexIndex vertex(const Vec3& p);
  std::vector<VertexIndex> vertices(std::span<const Vec3> points);
  Index triangle(const Vec3& a, const Vec3& b, const Vec3& c) {
    return plc.add_triangle({vertex(a), vertex(b), vertex(c)});
  }
  Index polygon(std::initializer_list<Vec3> loop) { return polygon(std::span(loop.begin(), loop.size())); }
  Index polygon(std::span<const Vec3> loop);
  /// Outer loop and holes.
  Index polygon_with_holes(std::span<const std::vector<Vec3>> loops);
  void facet_segment(Index facet, const Vec3& a, const Vec3& b) {
    plc.facet_segments.push_back({facet, vertex(a), vertex(b)});
  }
  void facet_point(Index facet, const Vec3& p) { plc.facet_points.push_back({facet, vertex(p)}); }
  void segment(const Vec3& a, const Vec3& b, Index curve = no_index) {
    plc.segments.push_back({vertex(a), vertex(b), curve});
  }
  void isolated_point(const Vec3& p) { plc.isolated_points.push_back(vertex(p)); }

  /// The six sides of a box as rectangles, normals outwards: zmin, zmax, ymin, xmax, ymax, xmin. Returns the first
  /// facet.
  Index box(const Vec3& min, const Vec3& max);

 private:
  struct Less {
    bool operator()(const Vec3& a, const Vec3& b) const {
      return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
    }
  };
  std::map<Vec3, VertexIndex, Less> rows_;
};

/// A closed triangulated surface, apart from any PLC.
struct Shell {
  std::vector<Vec3> points;
  std::vector<Triangle> triangles;  ///< normals outwards
};

void add_shell(PlcBuilder& builder, const Shell& shell);
/// Volume of a closed shell, in doubles.
double volume(const Shell& shell);
/// Octahedron with each triangle split `level` times into four, vertices on the sphere.
Shell sphere(const Vec3& centre, double radius, unsigned level);

}  // namespace geomesh::test
