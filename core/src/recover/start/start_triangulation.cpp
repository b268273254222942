// SPDX-License-Identifier: MIT
#include "recover/start/start_triangulation.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "mesh/sorted_cells.hpp"
#include "recover/model/crossing.hpp"
#include "recover/model/presence.hpp"
#include "recover/model/recover.hpp"
#include "recover/model/recovery_budget.hpp"
#include "recover/start/level_frame.hpp"
#include "recover/start/scale_forecast.hpp"

namespace geomesh::recover {

namespace {

constexpr std::size_t n_box_corners = 8;

/// Returns the model's vertices and the eight corners of a box that encloses them at a distance. Recovery therefore
/// never touches the hull of the mesh, and the box hardly disturbs the model's Delaunay cells.
std::vector<Vec3> vertices_with_box(const PiecewiseLinearComplex& plc, const DeclaredModel& model) {
  std::vector<Vec3> points;
  Box3 box;
  for (VertexIndex v : model.input_vertex) {
    points.push_back(plc.points[v]);
    box.add(plc.points[v]);
  }
  const double extent = std::max({box.max.x - box.min.x, box.max.y - box.min.y, box.max.z - box.min.z});
  const double margin = std::ldexp(1.0, std::ilogb(extent > 0 ? extent : 1.0) + 4);
  for (unsigned corner = 0; corner < n_box_corners; ++corner)
    points.push_back({corner & 1 ? box.max.x + margin : box.min.x - margin,
                      corner & 2 ? box.max.y + margin : box.min.y - margin,
                      corner & 4 ? box.max.z + margin : box.min.z - margin});
  return points;
}

/// Counts the cells that have input vertices only. Ghosts and free slots have other vertices.
std::size_t count_model_cells(const TetMesh& cells, std::size_t n_input) {
  std::size_t n = 0;
  for (CellIndex c = 0; c < cells.n_slots(); ++c) {
    const auto& v = cells.vertices(c);
    n += std::max({v[0], v[1], v[2], v[3]}) < n_input;
  }
  return n;
}

/// A triangulation of all vertices, and for each subsegment a cell of it that has the subsegment as an edge.
struct Candidate {
  TetMesh cells;
  std::vector<CellIndex> subsegments;  ///< for each subsegment a cell that has it; no_cell if it is no edge of the mesh
  DelaunayStatistics statistics;

  std::size_t n_missing() const {
    return static_cast<std::size_t>(std::count(subsegments.begin(), subsegments.end(), no_cell));
  }
};

class StartSearch {
 public:
  StartSearch(const std::vector<Vec3>& points, const Constraints& constraints, const DelaunayOptions& options,
              const RunContext& context)
      : points_(points), constraints_(constraints), options_(options), context_(context) {}

  Candidate triangulate(const std::array<int, 3>& exponents) const {
    std::vector<Vec3> scaled = points_;
    for (Vec3& p : scaled)
      for (std::size_t i = 0; i < 3; ++i) p[i] = std::ldexp(p[i], exponents[i]);
    DelaunayTetrahedralization delaunay = delaunay_tetrahedralization(scaled, options_, context_);
    TetMesh cells = with_sorted_cells(delaunay.mesh, static_cast<VertexIndex>(points_.size()));
    std::vector<CellIndex> subsegments = cells_of_subsegments(cells, constraints_);
    return {std::move(cells), std::move(subsegments), delaunay.statistics};
  }

  /// Improves `best` by hill climbing: an axis is scaled by two as long as this saves a twentieth of the missing
  /// subsegments. Frames that the forecast excludes are not triangulated. Returns the exponents of the scales.
  std::array<int, 3> climb(Candidate& best) const {
    std::array<int, 3> exponents{0, 0, 0};
    ScaleForecast forecast = forecast_from(best);
    for (const std::size_t axis : axes_by_extent()) {
      for (int step = 0; step < recovery_budget.stretch_steps && best.n_missing() > 0; ++step) {
        std::array<int, 3> trial = exponents;
        ++trial[axis];
        if (whole * forecast.n_missing(trial) > rest * forecast.n_missing(exponents)) break;
        Candidate candidate = triangulate(trial);
        if (whole * candidate.n_missing() > rest * best.n_missing()) break;
        exponents = trial;
        best = std::move(candidate);
        forecast = forecast_from(best);
      }
    }
    return exponents;
  }

  /// Scales each axis by powers of two as long as the missing segments then cross fewer mesh items, and stores in
  /// `best` the last triangulation with only a few more missing segments. Does nothing unless flips would take much
  /// longer than all these triangulations.
  void reduce_crossings(Candidate& best, std::array<int, 3> exponents) const {
    constexpr std::size_t share = recovery_budget.crossings_loss;
    double least = n_crossings(best);
    const std::size_t n_missing = best.n_missing();
    const double n_cells = static_cast<double>(count_model_cells(best.cells, points_.size() - n_box_corners));
    if (least < recovery_budget.crossings_per_cell * n_cells) return;
    for (const std::size_t axis : axes_by_extent()) {
      while (exponents[axis] < recovery_budget.stretch_steps) {
        ++exponents[axis];
        Candidate candidate = triangulate(exponents);
        const double n = n_crossings(candidate);
        if (n >= least) {
          --exponents[axis];
          break;
        }
        least = n;
        if (share * candidate.n_missing() <= (share + 1) * n_missing) best = std::move(candidate);
      }
    }
  }

 private:
  static constexpr std::size_t whole = recovery_budget.stretch_gain, rest = whole - 1;

  /// Returns the number of simplices that the missing subsegments cross, estimated from a sample.
  double n_crossings(Candidate& candidate) const {
    std::vector<Index> missing;
    for (Index s = 0; s < candidate.subsegments.size(); ++s)
      if (candidate.subsegments[s] == no_cell) missing.push_back(s);
    const std::size_t n = std::min(recovery_budget.forecast_sample, missing.size());
    if (n == 0) return 0;
    std::vector<Vec3> points = points_;
    ConstrainedMesh mesh(std::move(candidate.cells), std::move(points), points_.size() - n_box_corners);
    LineCrossings line;
    std::size_t sum = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const Subsegment& s = constraints_.subsegments[missing[i * missing.size() / n]];
      walk_line(mesh, s.a, s.b, line);
      sum += line.crossings.size();
    }
    mesh.release(candidate.cells, points);
    return static_cast<double>(sum) * static_cast<double>(missing.size()) / static_cast<double>(n);
  }
  ScaleForecast forecast_from(Candidate& candidate) const {
    std::vector<Vec3> points = points_;
    ConstrainedMesh mesh(std::move(candidate.cells), std::move(points), points_.size() - n_box_corners);
    ScaleForecast out(mesh, constraints_, candidate.subsegments);
    mesh.release(candidate.cells, points);
    return out;
  }
  /// Returns the two axes along which the model's segments extend least, the least first.
  std::array<std::size_t, 2> axes_by_extent() const {
    Vec3 sum;
    for (const Subsegment& s : constraints_.subsegments)
      for (std::size_t i = 0; i < 3; ++i) sum[i] += std::fabs(points_[s.a][i] - points_[s.b][i]);
    std::array<std::size_t, 3> axes{0, 1, 2};
    std::sort(axes.begin(), axes.end(),
              [&](std::size_t a, std::size_t b) { return sum[a] != sum[b] ? sum[a] < sum[b] : a > b; });
    return {axes[0], axes[1]};
  }

  const std::vector<Vec3>& points_;
  const Constraints& constraints_;
  const DelaunayOptions& options_;
  const RunContext& context_;
};

bool is_many(std::size_t n_missing, const Constraints& constraints) {
  return n_missing > recovery_budget.few_missing &&
         recovery_budget.stretch_from * n_missing > constraints.subsegments.size();
}

/// Searches for scales of the axes with which the Delaunay triangulation contains more of the model's segments: after a
/// shear that makes facets horizontal, if one exists, and unless that helps, also without it.
void stretch(Candidate& best, std::size_t inner_edges, const std::vector<Vec3>& points, const Constraints& constraints,
             const DelaunayOptions& options, const RunContext& context) {
  if (!is_many(best.n_missing() + inner_edges, constraints)) return;
  std::optional<Candidate> candidate;
  if (const std::optional<std::vector<Vec3>> level = with_level_facets(points, constraints)) {
    const StartSearch search(*level, constraints, options, context);
    candidate = search.triangulate({0, 0, 0});
    search.reduce_crossings(*candidate, search.climb(*candidate));
  }
  const bool is_better_level = candidate && candidate->n_missing() < best.n_missing();
  if (!is_better_level && is_many(best.n_missing(), constraints)) {
    const StartSearch search(points, constraints, options, context);
    search.reduce_crossings(best, search.climb(best));
  }
  if (candidate && candidate->n_missing() < best.n_missing()) best = std::move(*candidate);
}

void remember(const Candidate& candidate, Constraints& constraints) {
  for (Index s = 0; s < constraints.subsegments.size(); ++s)
    constraints.subsegments[s].seen_in = candidate.subsegments[s];
}

/// Counts the facets that a start triangulation lacks. Moves `candidate` and `points` into a mesh meanwhile, and back.
MissingSubfacets count_missing_facets(Candidate& candidate, std::vector<Vec3>& points,
                                      const PiecewiseLinearComplex& plc, const ModelNames& names, DeclaredModel& model,
                                      const RunContext& context) {
  remember(candidate, model.constraints);
  ConstrainedMesh mesh(std::move(candidate.cells), std::move(points), model.input_vertex.size());
  RecoveryStatistics unused;
  CrossingsOf crossings(plc);
  Recovery recovery{mesh, model.constraints, unused, context, model.input_vertex, plc, names, crossings};
  const MissingSubfacets out = count_missing_subfacets(recovery);
  mesh.release(candidate.cells, points);
  return out;
}

}  // namespace

StartTriangulation triangulate_start(const PiecewiseLinearComplex& plc, const ModelNames& names, DeclaredModel& model,
                                     const DelaunayOptions& options, const RunContext& context, StartFrame frame) {
  StartTriangulation out;
  out.points = vertices_with_box(plc, model);
  model.constraints.vertices.resize(out.points.size());
  Candidate best = StartSearch(out.points, model.constraints, options, context).triangulate({0, 0, 0});
  out.statistics = best.statistics;
  out.tetrahedra = count_model_cells(best.cells, model.input_vertex.size());
  out.missing_edges = best.n_missing();
  const MissingSubfacets facets = count_missing_facets(best, out.points, plc, names, model, context);
  out.missing_facets = facets.n;
  if (frame == StartFrame::may_be_stretched)
    stretch(best, facets.inner_edges, out.points, model.constraints, options, context);
  remember(best, model.constraints);
  out.mesh = std::move(best.cells);
  return out;
}

}  // namespace geomesh::recover
