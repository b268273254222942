// SPDX-License-Identifier: GPL-3.0-or-later
#include "delaunay_peers.hpp"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <tbb/global_control.h>
#include <tetgen.h>

#include <stdexcept>
#include <vector>

namespace geomesh::bench {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Compact = CGAL::Delaunay_triangulation_3<Kernel>;
using FastLocation = CGAL::Delaunay_triangulation_3<Kernel, CGAL::Fast_location>;
using ParallelData =
    CGAL::Triangulation_data_structure_3<CGAL::Triangulation_vertex_base_3<Kernel>,
                                         CGAL::Delaunay_triangulation_cell_base_3<Kernel>, CGAL::Parallel_tag>;
using Parallel = CGAL::Delaunay_triangulation_3<Kernel, ParallelData>;

std::vector<Kernel::Point_3> converted(std::span<const Vec3> points) {
  std::vector<Kernel::Point_3> r;
  r.reserve(points.size());
  for (const Vec3& p : points) r.emplace_back(p.x, p.y, p.z);
  return r;
}

Answer answer_of(std::size_t tetrahedra) {
  Answer out;
  out.tetrahedra = tetrahedra;
  return out;
}

template <class Triangulation>
Answer run_cgal(std::span<const Vec3> points) {
  const auto input = converted(points);
  Triangulation triangulation(input.begin(), input.end());
  if (triangulation.dimension() < 3) throw std::runtime_error("dimension " + std::to_string(triangulation.dimension()));
  return answer_of(triangulation.number_of_finite_cells());
}

}  // namespace

Answer run_geomesh(std::span<const Vec3> points, const DelaunayOptions& options, unsigned threads) {
  RunContext context;
  context.threads = threads;
  const auto result = delaunay_tetrahedralization(points, options, context);
  std::size_t finite = 0;
  for (CellIndex c = 0; c < result.mesh.n_slots(); ++c) finite += result.mesh.is_live(c) && !result.mesh.is_ghost(c);
  Answer out = answer_of(finite);
  out.exact_calls = result.statistics.exact_calls;
  out.walk_steps = result.statistics.walk_steps;
  out.deferred = result.statistics.points_deferred;
  return out;
}

Answer run_cgal_compact(std::span<const Vec3> points) { return run_cgal<Compact>(points); }

Answer run_cgal_fast_location(std::span<const Vec3> points) { return run_cgal<FastLocation>(points); }

Answer run_cgal_parallel(std::span<const Vec3> points, unsigned threads) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  const auto input = converted(points);
  CGAL::Bbox_3 box = input.front().bbox();
  for (const auto& p : input) box += p.bbox();
  Parallel::Lock_data_structure locks(box, 50);
  Parallel triangulation(input.begin(), input.end(), &locks);
  if (triangulation.dimension() < 3) throw std::runtime_error("dimension " + std::to_string(triangulation.dimension()));
  return answer_of(triangulation.number_of_finite_cells());
}

Answer run_tetgen(std::span<const Vec3> points) {
  tetgenio in, out;
  in.numberofpoints = static_cast<int>(points.size());
  in.pointlist = new REAL[3 * points.size()];
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) in.pointlist[3 * i + k] = points[i][k];
  char switches[] = "Q";
  try {
    tetrahedralize(switches, &in, &out);
  } catch (int code) {
    throw std::runtime_error("TetGen ended with code " + std::to_string(code));
  }
  return answer_of(static_cast<std::size_t>(out.numberoftetrahedra));
}

}  // namespace geomesh::bench
