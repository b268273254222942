// SPDX-License-Identifier: MIT
#include "recover/start_triangulation.hpp"

#include <algorithm>
#include <cmath>

#include "delaunay/sorted_cells.hpp"
#include "recover/recover.hpp"

namespace geomesh::recover {

namespace {

/// The model's vertices and the eight corners of a box that encloses them at a distance, so that the hull of the mesh is never touched
/// by recovery and the box disturbs the model's Delaunay cells little.
std::vector<Vec3> vertices_with_box(const PiecewiseLinearComplex& plc, const DeclaredModel& model) {
  std::vector<Vec3> points;
  Box3 box;
  for (VertexIndex v : model.input_vertex) {
    points.push_back(plc.points[v]);
    box.add(plc.points[v]);
  }
  const double extent = std::max({box.max.x - box.min.x, box.max.y - box.min.y, box.max.z - box.min.z});
  const double margin = std::ldexp(1.0, std::ilogb(extent > 0 ? extent : 1.0) + 4);
  for (unsigned corner = 0; corner < 8; ++corner)
    points.push_back({corner & 1 ? box.max.x + margin : box.min.x - margin, corner & 2 ? box.max.y + margin : box.min.y - margin,
                      corner & 4 ? box.max.z + margin : box.min.z - margin});
  return points;
}

std::size_t count_model_cells(const TetMesh& cells, std::size_t n_input) {
  std::size_t n = 0;
  for (CellIndex c = 0; c < cells.n_slots(); ++c) {
    if (!cells.is_live(c)) continue;
    const auto& v = cells.vertices(c);
    if (std::all_of(v.begin(), v.end(), [&](VertexIndex u) { return u < n_input; })) ++n;
  }
  return n;
}

/// Subsegments that are no edges of the mesh, found by one pass over the cells.
std::size_t count_missing(const TetMesh& cells, const Constraints& constraints) {
  std::vector<std::uint8_t> present(constraints.subsegments.size(), 0);
  for (CellIndex c = 0; c < cells.n_slots(); ++c) {
    if (!cells.is_live(c)) continue;
    for (const auto& e : edge_vertices) {
      const Index s = constraints.subsegment_of(cells.vertex(c, e[0]), cells.vertex(c, e[1]));
      if (s != no_index) present[s] = 1;
    }
  }
  return static_cast<std::size_t>(std::count(present.begin(), present.end(), 0));
}

class StartSearch {
 public:
  StartSearch(const std::vector<Vec3>& points, const Constraints& constraints, const DelaunayOptions& options, const RunContext& context)
      : points_(points), constraints_(constraints), options_(options), context_(context) {}

  DelaunayTetrahedralization triangulate(const std::array<int, 3>& exponents) const {
    std::vector<Vec3> scaled = points_;
    for (Vec3& p : scaled)
      for (std::size_t i = 0; i < 3; ++i) p[i] = std::ldexp(p[i], exponents[i]);
    return delaunay_tetrahedralization(scaled, options_, context_);
  }

  /// Improves `best` while a step of one axis saves a twentieth of what is missing.
  void climb(DelaunayTetrahedralization& best, std::size_t missing, std::array<int, 3> exponents) const {
    for (const std::size_t axis : axes_by_extent()) {
      for (int step = 0; step < 12; ++step) {
        std::array<int, 3> trial = exponents;
        ++trial[axis];
        DelaunayTetrahedralization candidate = triangulate(trial);
        const std::size_t n = count_missing(candidate.mesh, constraints_);
        if (20 * n > 19 * missing) break;
        missing = n;
        exponents = trial;
        best.mesh = std::move(candidate.mesh);
      }
    }
  }

 private:
  /// The two axes along which segments extend least, the least first.
  std::array<std::size_t, 2> axes_by_extent() const {
    Vec3 sum;
    for (const Subsegment& s : constraints_.subsegments)
      for (std::size_t i = 0; i < 3; ++i) sum[i] += std::fabs(points_[s.a][i] - points_[s.b][i]);
    std::array<std::size_t, 3> axes{0, 1, 2};
    std::sort(axes.begin(), axes.end(), [&](std::size_t a, std::size_t b) { return sum[a] != sum[b] ? sum[a] < sum[b] : a > b; });
    return {axes[0], axes[1]};
  }

  const std::vector<Vec3>& points_;
  const Constraints& constraints_;
  const DelaunayOptions& options_;
  const RunContext& context_;
};

}  // namespace

StartTriangulation triangulate_start(const PiecewiseLinearComplex& plc, const ModelNames& names, DeclaredModel& model,
                                     const DelaunayOptions& options, const RunContext& context, bool may_scale, unsigned attempt) {
  StartTriangulation out;
  out.points = vertices_with_box(plc, model);
  model.constraints.vertices.resize(out.points.size());
  const StartSearch search(out.points, model.constraints, options, context);
  DelaunayTetrahedralization delaunay = search.triangulate({0, 0, 0});
  out.statistics = delaunay.statistics;
  out.tetrahedra = count_model_cells(delaunay.mesh, model.input_vertex.size());
  out.missing_edges = count_missing(delaunay.mesh, model.constraints);
  {
    ConstrainedMesh mesh(delaunay.mesh, out.points, model.input_vertex.size());
    RecoveryStatistics unused;
    CrossingsOf crossings(plc);
    Recovery recovery{mesh, model.constraints, unused, context, model.input_vertex, plc, names, crossings};
    out.missing_facets = count_missing_subfacets(recovery);
  }
  std::array<int, 3> exponents{0, 0, 0};
  std::size_t missing = out.missing_edges;
  if (may_scale && attempt > 0) {
    exponents[attempt % 3] = static_cast<int>(1 + attempt / 3);
    delaunay.mesh = search.triangulate(exponents).mesh;
    missing = count_missing(delaunay.mesh, model.constraints);
  }
  if (may_scale && missing > 20 && 10 * missing > model.constraints.subsegments.size()) search.climb(delaunay, missing, exponents);
  out.mesh = with_sorted_cells(delaunay.mesh, static_cast<VertexIndex>(out.points.size()));
  return out;
}

}  // namespace geomesh::recover
