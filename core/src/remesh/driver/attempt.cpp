// SPDX-License-Identifier: MIT
// One run of refinement with surfaces kept within the tolerance, declared in remesh/driver/hold_surfaces.hpp.
#include <algorithm>
#include <cstdio>
#include <optional>
#include <utility>

#include "geomesh/core/error.hpp"
#include "remesh/domain/domain_io.hpp"
#include "remesh/driver/hold_surfaces.hpp"
#include "remesh/driver/judge_cells.hpp"
#include "remesh/operations/surface_repair.hpp"
#include "remesh/passes/improve_passes.hpp"
#include "remesh/passes/passes.hpp"
#include "remesh/rescue/bad_cells.hpp"
#include "remesh/sizes/sizes.hpp"
#include "remesh/start/mesh_anew.hpp"
#include "remesh/start/sample_surfaces.hpp"
#include "remesh/start/sampled_crossings.hpp"

namespace geomesh::remesh {

namespace {

double worst_shape(const DomainMesh& mesh) {
  double worst = 1;
  for (const CellIndex c : mesh.live_cells()) worst = std::min(worst, mesh.shape_of(c));
  return worst;
}

/// Builds the size field, estimates the number of elements and reports it to `context`.
void find_sizes(const PiecewiseLinearComplex& plc, const DomainMesh& mesh, const RefineOptions& options,
                const LocalTolerance& tolerance, const RunContext& context, RefineResult& result) {
  SizeFields sizes = build_size_field(plc, mesh, options, tolerance);
  result.size_field = std::move(sizes.all);
  result.asked = std::move(sizes.without_gaps);
  result.statistics.sizes_on_surfaces = sizes_surfaces(options);
  result.statistics.quality_measure = options.quality_measure;
  if (options.refine) announce_estimate(plc, mesh, options, context, result);
  if (options.sparse_growth > 0) result.size_field = result.size_field.times(options.sparse_surfaces);
}

/// Returns a context that reports progress as the number of elements in relation to the estimated number. `context`
/// must outlive the returned one.
RunContext counting_towards(double estimate, const RunContext& context) {
  RunContext counted = context;
  if (context.progress)
    counted.progress = [&context, estimate](std::size_t done, std::size_t total) {
      context.progress(done, total > 0 ? total : std::max(done, static_cast<std::size_t>(estimate)));
    };
  return counted;
}

/// Least number of new points on surfaces, as a share of the input's points, for which the mesh is built anew from all
/// points. If surfaces may move, fewer points can just as well be inserted one by one.
double least_share_of_points(const RefineOptions& o) { return o.honour == Honour::tolerance ? 0.01 : 0; }

/// Builds the mesh anew with points on edges and facets at the target distances. Such a constrained Delaunay mesh is a
/// better start than one into which the points are inserted one by one, among slivers. Points are rounded, so pieces of
/// an edge may pierce a facet that nearly touches it. In that case facets and edges there get no points, merged facets
/// there are separated, and the mesh is built again. Returns false if that is impossible; the mesh is then unchanged.
bool add_surface_points(const PiecewiseLinearComplex& plc, MergedFacets& merged, const RefineOptions& options,
                        ConstrainedTetrahedralization& mesh, const RunContext& context, RefineResult& result) {
  constexpr unsigned most_rounds = 16;
  const SizeField none({}, {});
  std::vector<Index> parent = options.facet_parent;
  WholeParts whole;
  for (unsigned round = 0; round < most_rounds; ++round) {
    SampledComplex sampled =
        sample_surfaces(merged, mesh, sizes_surfaces(options) ? result.size_field : none,
                        options.honour == Honour::exact ? Slivers::stay : Slivers::may_go, context, whole);
    const std::size_t n_on_facets = sampled.plc.facet_points.size() - merged.plc.facet_points.size();
    const std::size_t n_on_edges = sampled.plc.points.size() - plc.points.size() - n_on_facets;
    const bool is_merged = merged.plc.n_facets() < plc.n_facets();
    if (!is_merged && static_cast<double>(n_on_facets + n_on_edges) <=
                          least_share_of_points(options) * static_cast<double>(plc.points.size()))
      return false;
    ErrorContext trouble;
    if (auto fresh = mesh_sampled(merged, mesh, sampled, context, &trouble)) {
      mesh = std::move(*fresh);
      result.statistics.points_on_curves += n_on_edges;
      result.statistics.points_on_surfaces += n_on_facets;
      return true;
    }
    const std::vector<Index> meeting = facets_that_meet(sampled.plc, context.threads);
    trouble.facets.insert(trouble.facets.end(), meeting.begin(), meeting.end());
    const bool comes_apart = take_apart(merged, trouble.facets, parent);
    if (!keep_whole(merged, sampled, trouble, whole) && !comes_apart) return false;
    // Merges facets again, because flips of slivers may have changed them.
    merged = merge_pieces(plc, parent);
  }
  return false;
}

/// Edges longer than `far_too_long` times their target size remain if insertion got stuck. Improvement removes a few of
/// them; if more than the share `worth_meshing_anew` of all cells has such an edge, the points are meshed anew.
constexpr double far_too_long = 3, worth_meshing_anew = 1e-3;

bool has_edge_far_too_long(Toolbox& tools, const Tetrahedron& t) {
  return std::any_of(edge_vertices.begin(), edge_vertices.end(),
                     [&](const auto& e) { return tools.lengths.is_longer(t[e[0]], t[e[1]], far_too_long); });
}

bool is_stuck(Toolbox& tools) {
  std::size_t n = 0;
  for (const CellIndex c : tools.mesh.live_cells()) n += has_edge_far_too_long(tools, tools.mesh.vertices(c));
  return static_cast<double>(n) > worth_meshing_anew * static_cast<double>(tools.mesh.n_cells());
}

bool has_borders_of_no_facet(const DomainMesh& mesh) {
  for (const CellIndex c : mesh.live_cells())
    for (unsigned i = 0; i < 4; ++i)
      if (mesh.tag(c, i).facet() == hull_facet) return true;
  return false;
}

/// Frees the elements of the caller's mesh after import. Export needs only its points and their provenance.
void release_elements(ConstrainedTetrahedralization& mesh) {
  mesh.tetrahedra = {};
  mesh.component = {};
  mesh.faces = {};
  mesh.edges = {};
}

/// Meshes the points anew if edges that are far too long remain, and continues refinement from there. Such edges remain
/// if the cells are far from Delaunay and flips cannot help, because existing points are too close to insert others.
/// Memory that meshing needs is freed before; if meshing fails, the mesh is restored from its input.
void refine_from_anew(Toolbox& tools, const PiecewiseLinearComplex& plc, const RefineOptions& options,
                      const std::vector<Index>& patches, ConstrainedTetrahedralization& input,
                      const RunContext& context) {
  constexpr unsigned most_rounds = 2;
  for (unsigned round = 0; round < most_rounds && is_stuck(tools) && !has_borders_of_no_facet(tools.mesh); ++round) {
    input = export_domain(tools.mesh, input, context.threads);
    tools.mesh = {};
    tools.lengths.forget_all();
    const bool is_fresh = mesh_anew(input, context);
    tools.mesh = import_domain(plc, input, options, patches);
    release_elements(input);
    if (!is_fresh) return;
    flip_towards_delaunay(tools, context);
    refine_inside(tools, options.max_elements, context);
    collapse_short_edges(tools, ShortEdges::inside, context);
  }
}

void improve_holding(Toolbox& tools, const RefineOptions& options, const RunContext& context,
                     const FreeCellJudge& judge, Attempt& attempt) {
  const StageScope stage(context, "improve");
  improve_mesh(tools, options, context, &judge);
  if (options.balance_surfaces) balance_surfaces(tools, context);
  const auto count_bad = [&] { return count_below(tools.mesh, tools.mesh.measure().bad()); };
  const std::size_t n_bad = count_bad();
  Deviations found = hold_to_tolerance(tools, context);
  // A vertex inserted where a surface was too far from the input may be close to others, and make bad cells.
  if (count_bad() > n_bad) {
    mend_bad_cells(tools, options, context);
    found = hold_to_tolerance(tools, context);
  }
  attempt.result.statistics.deviation_result_to_input = found.result_to_input;
  attempt.result.statistics.deviation_input_to_result = found.input_to_result;
  attempt.breaches = std::move(found.breaches);
  if (!tools.guard.exact()) attempt.crossings = crossings_outside(tools.mesh, context.threads);
}

void finish(Toolbox& tools, const PiecewiseLinearComplex& plc, const ConstrainedTetrahedralization& input,
            unsigned threads, RefineResult& result) {
  result.statistics.worst_shape_after = worst_shape(tools.mesh);
  renew_facets(tools.mesh, tools.guard, plc);
  const std::string fault = tools.mesh.validate(threads);
  if (!fault.empty()) throw InternalError("refinement: " + fault);
  result.mesh = export_domain(tools.mesh, input, threads);
}

/// Refinement that has made `far_more` times the estimated number of elements is reported before improvement, which
/// then takes longer in proportion.
constexpr double far_more = 2, worth_telling = 50000;  // elements

void tell_growth(const DomainMesh& mesh, const RunContext& context, RefineResult& result) {
  const double estimate = result.statistics.estimated_elements, now = static_cast<double>(mesh.n_cells());
  if (!(estimate > 0) || now < worth_telling || now < far_more * estimate) return;
  char text[140];
  std::snprintf(text, sizeof text,
                "refinement made %.0f elements, where %.0f were estimated; improvement takes as much longer", now,
                estimate);
  result.warnings.emplace_back(text);
  context.note(LogLevel::warning, text);
}

}  // namespace

Attempt attempt_holding(const Hold& hold, const PiecewiseLinearComplex& plc, ConstrainedTetrahedralization input,
                        const RefineOptions& options, const RunContext& context) {
  Attempt attempt;
  RefineResult& result = attempt.result;
  MergedFacets merged = merge_pieces(plc, options.facet_parent);
  result.kept_patch = patches_of_facets(plc, options, merged);
  DomainMesh mesh = import_domain(plc, input, options, result.kept_patch);
  const LocalTolerance tolerance = allowed_tolerance(plc, mesh, options);
  find_sizes(plc, mesh, options, tolerance, hold.run == 0 ? context : RunContext{}, result);
  std::optional<StageScope> refining;
  if (options.refine) refining.emplace(context, "refine");
  std::optional<DomainMesh> given;  // the mesh of the input, kept for its surfaces
  if (options.refine && add_surface_points(plc, merged, options, input, context, result))
    given = std::exchange(mesh, import_domain(plc, input, options, result.kept_patch));
  const SurfaceGuard guard(given ? *given : mesh, mesh, plc, options.honour, tolerance, hold);
  given.reset();
  release_elements(input);
  Toolbox tools(mesh, guard, result.size_field, result.statistics);
  tools.bad_cells_may_spread = !sizes_surfaces(options);
  const RunContext counted = counting_towards(result.statistics.estimated_elements, context);
  if (options.refine) refine_to_size(tools, options, counted);
  if (options.refine && guard.exact() && sizes_surfaces(options) && !(options.sparse_growth > 0))
    refine_from_anew(tools, plc, options, result.kept_patch, input, context);
  refining.reset();
  if (options.refine && !(options.sparse_growth > 0)) tell_growth(mesh, hold.run == 0 ? context : RunContext{}, result);
  if (!guard.exact()) attempt.crossings = crossings_outside(mesh, context.threads);
  if (!attempt.holds()) return attempt;
  result.statistics.worst_shape_before = worst_shape(mesh);
  improve_holding(tools, options, context, free_cell_judge(plc, input, options, result), attempt);
  if (attempt.holds()) finish(tools, plc, input, context.threads, result);
  return attempt;
}

}  // namespace geomesh::remesh
