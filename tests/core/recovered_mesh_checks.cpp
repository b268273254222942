// SPDX-License-Identifier: MIT
#include "recovered_mesh_checks.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "geomesh/core/error.hpp"
#include "geomesh/core/predicates.hpp"
#include "geomesh/core/simplex_mesh.hpp"
#include "plc/facet_triangulation.hpp"

namespace geomesh::test {

namespace {

Triangle rotated(Triangle t) {
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  return t;
}
Triangle reversed(const Triangle& t) { return rotated({t[0], t[2], t[1]}); }

double length(const Vec3& v) { return std::sqrt(dot(v, v)); }

class Checker {
 public:
  Checker(const PiecewiseLinearComplex& plc, const ConstrainedTetrahedralization& mesh) : plc_(plc), mesh_(mesh) {
    for (const Vec3& p : mesh.points)
      for (double x : {p.x, p.y, p.z}) magnitude_ = std::max(magnitude_, std::fabs(x));
  }

  std::vector<std::string> run() {
    check_points();
    check_cells();
    check_faces();
    check_components();
    check_cover();
    check_volume();
    return faults_;
  }

 private:
  void fault(const std::string& text) {
    if (faults_.size() < 20) faults_.push_back(text);
  }

  void check_points() {
    std::vector<std::uint8_t> used(mesh_.points.size(), 0);
    for (const auto& t : mesh_.tetrahedra)
      for (VertexIndex v : t) used.at(v) = 1;
    if (std::count(used.begin(), used.end(), 0) > 0) fault("unused points");
    std::vector<Vec3> sorted = mesh_.points;
    std::sort(sorted.begin(), sorted.end(), [](const Vec3& a, const Vec3& b) { return compare_lexicographic(a, b) < 0; });
    if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) fault("equal points");
    VertexIndex last = 0;
    bool added = false;
    for (std::size_t v = 0; v < mesh_.points.size(); ++v) {
      const VertexIndex row = mesh_.input_vertex[v];
      if (row == no_vertex) {
        added = true;
        if (mesh_.origin[v] == VertexOrigin::input) fault("an added point claims to be input");
        continue;
      }
      if (added || (v > 0 && row <= last)) fault("input points are not first or not in input order");
      last = row;
      if (!(plc_.points[row] == mesh_.points[v])) fault("an input point has moved");
    }
  }

  void check_cells() {
    for (Index c = 0; c < mesh_.tetrahedra.size(); ++c) {
      const auto& t = mesh_.tetrahedra[c];
      if (orient3d(mesh_.points[t[0]], mesh_.points[t[1]], mesh_.points[t[2]], mesh_.points[t[3]]) != Sign::positive)
        fault("cell " + std::to_string(c) + " is not positive");
      for (const auto& l : face_vertices)
        if (!above_.emplace(rotated({t[l[0]], t[l[1]], t[l[2]]}), c).second) fault("a face is seen twice from one side");
    }
  }
  Index cell_above(const Triangle& t) const {
    const auto it = above_.find(rotated(t));
    return it == above_.end() ? no_index : it->second;
  }

  void check_faces() {
    for (const auto& f : mesh_.faces) {
      if (cell_above(f.vertices) != f.tetrahedron_above || cell_above(reversed(f.vertices)) != f.tetrahedron_below)
        fault("a facet face names the wrong cells");
      if (f.tetrahedron_above == no_index && f.tetrahedron_below == no_index) fault("a facet face borders no cell");
      if (!facet_face_.emplace(rotated(f.vertices), f.facet).second || facet_face_.count(reversed(f.vertices))) fault("a facet face is listed twice");
    }
  }
  void check_components() {
    for (const auto& [face, cell] : above_) {
      const Index other = cell_above(reversed(face));
      const bool constrained = facet_face_.count(face) || facet_face_.count(reversed(face));
      if (!constrained && other == no_index) fault("a face of the boundary is part of no facet");
      if (!constrained && other != no_index && mesh_.component[cell] != mesh_.component[other]) fault("components meet without a facet");
    }
    for (Index c : mesh_.component)
      if (c >= mesh_.n_components) fault("component out of range");
  }

  /// Each facet that borders a kept cell is covered by its faces: the right area, and no vertex off its triangle planes.
  void check_cover() {
    std::vector<double> area(plc_.n_facets(), 0);
    std::vector<Vec3> vector_area(plc_.n_facets());
    for (const auto& f : mesh_.faces) {
      const Vec3 n = cross(mesh_.points[f.vertices[1]] - mesh_.points[f.vertices[0]], mesh_.points[f.vertices[2]] - mesh_.points[f.vertices[0]]);
      area[f.facet] += length(n) / 2;
      vector_area[f.facet] = vector_area[f.facet] + 0.5 * n;
      if (plc_.n_loops(f.facet) == 1 && plc_.outer_loop(f.facet).size() == 3) check_distance(f);
    }
    for (Index f = 0; f < plc_.n_facets(); ++f) {
      if (area[f] == 0) continue;  // borders no kept cell
      Vec3 expected;
      for (Index l = plc_.facet_loops[f]; l < plc_.facet_loops[f + 1]; ++l) {
        const auto loop = plc_.loop(l);
        Vec3 n;
        for (std::size_t i = 1; i + 1 < loop.size(); ++i)
          n = n + 0.5 * cross(plc_.points[loop[i]] - plc_.points[loop[0]], plc_.points[loop[i + 1]] - plc_.points[loop[0]]);
        const bool is_hole = l > plc_.facet_loops[f];
        expected = is_hole && dot(n, expected) > 0 ? expected - n : expected + n;
      }
      const double tolerance = 1e-12 * magnitude_ * magnitude_ + 1e-10 * length(expected);
      if (length(vector_area[f] - expected) > tolerance) fault("facet " + std::to_string(f) + " is not covered once in its orientation");
    }
  }
  void check_distance(const ConstrainedTetrahedralization::Face& f) {
    const auto t = plc_.outer_loop(f.facet);
    const Vec3 n = cross(plc_.points[t[1]] - plc_.points[t[0]], plc_.points[t[2]] - plc_.points[t[0]]);
    for (VertexIndex v : f.vertices) {
      if (v < plc_.points.size() && mesh_.origin[v] == VertexOrigin::input) continue;
      const double h = std::fabs(dot(n, mesh_.points[v] - plc_.points[t[0]])) / length(n);
      if (h > 64 * magnitude_ * 2.3e-16) fault("an added point lies off facet " + std::to_string(f.facet));
    }
  }

  void check_volume() {
    long double boundary = 0, scale = 0;
    const Vec3 o = mesh_.points.empty() ? Vec3{} : mesh_.points[0];
    for (const auto& f : mesh_.faces) {
      if ((f.tetrahedron_above == no_index) == (f.tetrahedron_below == no_index)) continue;
      const Vec3 a = mesh_.points[f.vertices[0]] - o, b = mesh_.points[f.vertices[1]] - o, c = mesh_.points[f.vertices[2]] - o;
      const long double v = static_cast<long double>(dot(cross(a, b), c)) / 6;
      boundary += f.tetrahedron_above == no_index ? v : -v;
      scale += std::fabs(v);
    }
    if (std::fabs(boundary - volume_of(mesh_)) > 1e-12L * (scale + 1e-3L * magnitude_ * magnitude_ * magnitude_)) fault("the volume is not that of the boundary");
  }

  const PiecewiseLinearComplex& plc_;
  const ConstrainedTetrahedralization& mesh_;
  double magnitude_ = 0;
  std::map<Triangle, Index> above_;
  std::map<Triangle, Index> facet_face_;
  std::vector<std::string> faults_;
};

}  // namespace

std::vector<std::string> faults_of(const PiecewiseLinearComplex& plc, const ConstrainedTetrahedralization& mesh) {
  return Checker(plc, mesh).run();
}

long double volume_of(const ConstrainedTetrahedralization& mesh) {
  long double sum = 0;
  for (const auto& t : mesh.tetrahedra) {
    const Vec3 a = mesh.points[t[0]];
    sum += static_cast<long double>(dot(cross(mesh.points[t[1]] - a, mesh.points[t[2]] - a), mesh.points[t[3]] - a)) / 6;
  }
  return sum;
}

std::string mesh_and_check(const PiecewiseLinearComplex& plc, const TetrahedralizeOptions& options, ConstrainedTetrahedralization* result) {
  try {
    ConstrainedTetrahedralization mesh = tetrahedralize(plc, options);
    std::string out;
    for (const std::string& f : faults_of(plc, mesh)) out += f + "; ";
    if (result) *result = std::move(mesh);
    return out;
  } catch (const std::exception& e) {
    return e.what();
  }
}

}  // namespace geomesh::test
