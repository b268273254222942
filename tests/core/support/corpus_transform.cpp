// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus_transform.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <numeric>
#include <random>
#include <set>

#include "corpus_judge_parts.hpp"

namespace geomesh::test {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<VertexIndex, Kernel>;
using FaceInfo = CGAL::Triangulation_face_base_with_info_2<int, Kernel>;
using FaceBase = CGAL::Constrained_triangulation_face_base_2<Kernel, FaceInfo>;
using Draft =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>>;

/// Even-odd number of loops around each face; loops are constraints marked by `is_loop`.
void mark_inside(Draft& draft, const std::set<std::array<VertexIndex, 2>>& loop_edges) {
  for (auto f = draft.all_faces_begin(); f != draft.all_faces_end(); ++f) f->info() = -1;
  std::deque<Draft::Face_handle> queue{draft.infinite_face()};
  draft.infinite_face()->info() = 0;
  while (!queue.empty()) {
    const Draft::Face_handle f = queue.front();
    queue.pop_front();
    for (int i = 0; i < 3; ++i) {
      const Draft::Face_handle n = f->neighbor(i);
      if (n->info() >= 0) continue;
      const auto u = f->vertex(Draft::ccw(i)), v = f->vertex(Draft::cw(i));
      const bool crosses = !draft.is_infinite(u) && !draft.is_infinite(v) &&
                           loop_edges.count({std::min(u->info(), v->info()), std::max(u->info(), v->info())}) > 0;
      n->info() = crosses ? 1 - f->info() : f->info();
      queue.push_back(n);
    }
  }
}

/// The facet in the plane of two axes, in which its orientation is kept.
std::vector<Triangle> triangles_of_facet(const PiecewiseLinearComplex& plc, Index facet) {
  const auto corner = plane_corners(plc, facet);
  const Vec3 n = cross(plc.points[corner[1]] - plc.points[corner[0]], plc.points[corner[2]] - plc.points[corner[0]]);
  std::size_t axis = std::fabs(n.x) > std::fabs(n.y) ? 0 : 1;
  if (std::fabs(n.z) > std::fabs(n[axis])) axis = 2;
  Vec3 area;
  const auto outer = plc.outer_loop(facet);
  for (std::size_t i = 1; i + 1 < outer.size(); ++i)
    area = area + cross(plc.points[outer[i]] - plc.points[outer[0]], plc.points[outer[i + 1]] - plc.points[outer[0]]);
  const bool flip = area[axis] < 0;
  const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;

  Draft draft;
  std::map<VertexIndex, Draft::Vertex_handle> handles;
  const auto insert = [&](VertexIndex row) {
    const auto [it, is_new] = handles.try_emplace(row);
    if (is_new) {
      it->second = draft.insert(Kernel::Point_2(plc.points[row][u], plc.points[row][v]));
      it->second->info() = row;
    }
    return it->second;
  };
  std::set<std::array<VertexIndex, 2>> loop_edges;
  for (Index l = plc.facet_loops[facet]; l < plc.facet_loops[facet + 1]; ++l) {
    const auto loop = plc.loop(l);
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const VertexIndex a = loop[i], b = loop[(i + 1) % loop.size()];
      draft.insert_constraint(insert(a), insert(b));
      loop_edges.insert({std::min(a, b), std::max(a, b)});
    }
  }
  for (const auto& s : plc.facet_segments)
    if (s.facet == facet) draft.insert_constraint(insert(s.a), insert(s.b));
  for (const auto& p : plc.facet_points)
    if (p.facet == facet) insert(p.v);
  mark_inside(draft, loop_edges);
  std::vector<Triangle> triangles;
  for (auto f = draft.finite_faces_begin(); f != draft.finite_faces_end(); ++f) {
    if (f->info() != 1) continue;
    Triangle t{f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()};
    if (flip) std::swap(t[1], t[2]);
    triangles.push_back(t);
  }
  return triangles;
}

/// Everything of `plc` but its facets and what belongs to them.
PiecewiseLinearComplex without_facets(const PiecewiseLinearComplex& plc) {
  PiecewiseLinearComplex out;
  out.points = plc.points;
  out.provenance_sets = plc.provenance_sets;
  out.segments = plc.segments;
  out.isolated_points = plc.isolated_points;
  out.region_seeds = plc.region_seeds;
  out.hole_seeds = plc.hole_seeds;
  return out;
}

}  // namespace

PiecewiseLinearComplex mapped(PiecewiseLinearComplex plc, const PointMap& map, int orientation) {
  for (Vec3& p : plc.points) p = map(p);
  for (auto* seeds : {&plc.region_seeds, &plc.hole_seeds})
    for (auto& s : *seeds) s.point = map(s.point);
  if (orientation < 0)
    for (Index l = 0; l + 1 < plc.loop_offsets.size(); ++l)
      std::reverse(plc.loop_vertices.begin() + plc.loop_offsets[l],
                   plc.loop_vertices.begin() + plc.loop_offsets[l + 1]);
  return plc;
}

PiecewiseLinearComplex as_triangles(const PiecewiseLinearComplex& plc) {
  PiecewiseLinearComplex out = without_facets(plc);
  for (Index f = 0; f < plc.n_facets(); ++f)
    for (const Triangle& t : triangles_of_facet(plc, f)) out.add_triangle(t, plc.facet_provenance[f]);
  return out;
}

PiecewiseLinearComplex shuffled(const PiecewiseLinearComplex& plc, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto permutation = [&](std::size_t n) {
    std::vector<Index> p(n);
    std::iota(p.begin(), p.end(), Index{0});
    for (std::size_t i = n; i > 1; --i) std::swap(p[i - 1], p[random() % i]);
    return p;
  };
  PiecewiseLinearComplex out = without_facets(plc);
  const std::vector<Index> row = permutation(plc.points.size()), order = permutation(plc.n_facets());
  for (VertexIndex v = 0; v < plc.points.size(); ++v) out.points[row[v]] = plc.points[v];
  std::vector<Index> new_facet(plc.n_facets());
  for (Index i = 0; i < order.size(); ++i) {
    const Index f = order[i];
    std::vector<std::vector<VertexIndex>> loops;
    for (Index l = plc.facet_loops[f]; l < plc.facet_loops[f + 1]; ++l) {
      std::vector<VertexIndex> loop;
      for (VertexIndex v : plc.loop(l)) loop.push_back(row[v]);
      std::rotate(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(random() % loop.size()), loop.end());
      loops.push_back(loop);
    }
    new_facet[f] = out.add_polygon(loops, plc.facet_provenance[f]);
  }
  for (const auto& s : plc.facet_segments) out.facet_segments.push_back({new_facet[s.facet], row[s.b], row[s.a]});
  for (const auto& p : plc.facet_points) out.facet_points.push_back({new_facet[p.facet], row[p.v]});
  for (auto& s : out.segments) s = {row[s.a], row[s.b], s.curve};
  for (VertexIndex& v : out.isolated_points) v = row[v];
  return out;
}

PointMap axes_permuted() {
  return [](const Vec3& p) { return Vec3{p.y, p.z, p.x}; };
}
PointMap mirrored() {
  return [](const Vec3& p) { return Vec3{-p.x, p.y, p.z}; };
}
PointMap scaled(int power) {
  return [s = std::ldexp(1.0, power)](const Vec3& p) { return s * p; };
}
PointMap moved(const Vec3& by) {
  return [by](const Vec3& p) { return p + by; };
}
PointMap flattened(double by) {
  return [by](const Vec3& p) { return Vec3{p.x, p.y, by * p.z}; };
}
PointMap turned() {
  const double a = 0.6180339887, b = 1.1414213562, c = 0.2718281828;
  return [=](Vec3 p) {
    p = {std::cos(a) * p.x - std::sin(a) * p.y, std::sin(a) * p.x + std::cos(a) * p.y, p.z};
    p = {p.x, std::cos(b) * p.y - std::sin(b) * p.z, std::sin(b) * p.y + std::cos(b) * p.z};
    return Vec3{std::cos(c) * p.x + std::sin(c) * p.z, p.y, std::cos(c) * p.z - std::sin(c) * p.x};
  };
}
PointMap moved_to_utm() { return moved({512345.67, 5987654.32, -1234.5}); }

}  // namespace geomesh::test
