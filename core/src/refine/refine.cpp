// SPDX-License-Identifier: MIT
#include "geomesh/core/refine.hpp"

#include <algorithm>
#include <cstdio>
#include <optional>
#include <string>
#include <utility>

#include "improve/improve.hpp"
#include "quality/shape.hpp"
#include "refine/domain_io.hpp"
#include "refine/refinement.hpp"
#include "refine/sample_surfaces.hpp"

namespace geomesh {

namespace {

using remesh::DomainMesh;
using remesh::Toolbox;

void check_options(const PiecewiseLinearComplex& plc, const RefineOptions& o) {
  const auto refuse = [](const std::string& what) { throw Error(ErrorKind::usage, what); };
  if (!(o.size.gradation > 0)) refuse("the gradation of sizes must be positive");
  if (o.size.global < 0 || o.size.min_size < 0 || o.size.max_size < 0) refuse("a size cannot be negative");
  if (o.honour == Honour::tolerance && !(o.tolerance > 0)) refuse("honouring surfaces to a tolerance needs a distance above 0");
  if (!o.facet_patch.empty() && o.facet_patch.size() != plc.n_facets()) refuse("one patch must be given for each facet");
  if (!o.segment_curve.empty() && o.segment_curve.size() != plc.segments.size()) refuse("one curve must be given for each segment");
  if (!o.facet_parent.empty() && o.facet_parent.size() != plc.n_facets()) refuse("one parent must be given for each facet");
}

double size_tolerance(const RefineOptions& o) { return o.honour == Honour::tolerance ? o.tolerance : 0; }

void check_estimate(double estimate, std::size_t limit) {
  if (estimate <= static_cast<double>(limit)) return;
  throw Error(ErrorKind::cannot_mesh, "the sizes ask for about " + std::to_string(static_cast<long long>(estimate)) +
                                          " elements, more than the limit of " + std::to_string(limit) +
                                          "; ask for larger sizes, a steeper gradation, or raise the limit");
}

double worst_shape(const DomainMesh& mesh) {
  double worst = 1;
  for (CellIndex c = 0; c < mesh.n_slots(); ++c)
    if (mesh.is_live(c)) worst = std::min(worst, mesh.shape_of(c));
  return worst;
}

template <class Visit>
void for_each_cell_edge(const DomainMesh& mesh, const Visit& visit) {
  for (CellIndex c = 0; c < mesh.n_slots(); ++c)
    if (mesh.is_live(c))
      for (const auto& e : edge_vertices) {
        const VertexIndex a = mesh.vertices(c)[e[0]], b = mesh.vertices(c)[e[1]];
        visit(std::min(a, b), std::max(a, b));
      }
}

/// Calls visit(a, b) for each edge once, a < b: a counting sort by a, then short sorts.
template <class Visit>
void for_each_edge(const DomainMesh& mesh, const Visit& visit) {
  std::vector<std::size_t> first(mesh.n_vertices() + 1, 0);
  for_each_cell_edge(mesh, [&](VertexIndex a, VertexIndex) { ++first[a + 1]; });
  for (std::size_t v = 0; v < mesh.n_vertices(); ++v) first[v + 1] += first[v];
  std::vector<VertexIndex> upper(first.back());
  std::vector<std::size_t> next(first.begin(), first.end() - 1);
  for_each_cell_edge(mesh, [&](VertexIndex a, VertexIndex b) { upper[next[a]++] = b; });
  for (VertexIndex a = 0; a < mesh.n_vertices(); ++a) {
    const std::span<VertexIndex> ends = std::span(upper).subspan(first[a], first[a + 1] - first[a]);
    std::sort(ends.begin(), ends.end());
    for (std::size_t k = 0; k < ends.size(); ++k)
      if (k == 0 || ends[k] != ends[k - 1]) visit(a, ends[k]);
  }
}

double share_of_edges_within_size(Toolbox& tools) {
  std::size_t n = 0, within = 0;
  for_each_edge(tools.mesh, [&](VertexIndex a, VertexIndex b) {
    const double ratio = remesh::distance(tools.mesh.point(a), tools.mesh.point(b)) / tools.size_of_edge(a, b);
    ++n;
    within += ratio >= 0.5 && ratio <= 2;
  });
  return n == 0 ? 1 : static_cast<double>(within) / static_cast<double>(n);
}

bool sizes_surfaces(const RefineOptions& o) { return o.size_surfaces || o.honour == Honour::tolerance; }

void refine_to_size(Toolbox& tools, const RefineOptions& options, const RunContext& context) {
  if (!sizes_surfaces(options)) {
    remesh::flip_towards_delaunay(tools, context);
    remesh::refine_inside(tools, options.max_elements, context);
    remesh::collapse_short_edges(tools, true, context);
    return;
  }
  if (options.honour == Honour::tolerance) remesh::regularize_surfaces(tools, context);
  remesh::collapse_short_edges(tools, false, context);
  remesh::split_long_edges(tools, true, options.max_elements, context);
  remesh::flip_towards_delaunay(tools, context);
  remesh::refine_surfaces(tools, options.max_elements, context);
  const std::size_t n_split = remesh::split_long_edges(tools, false, options.max_elements, context);
  remesh::flip_towards_delaunay(tools, context);
  remesh::refine_inside(tools, options.max_elements, context);
  remesh::flip_towards_delaunay(tools, context);
  if (n_split > 0) {
    // Bisected faces are of poor shape, and their neighbourhood is loose enough to mend them only once it is filled.
    remesh::regularize_surfaces(tools, context);
    remesh::collapse_short_edges(tools, false, context);
    remesh::regularize_surfaces(tools, context);
    remesh::flip_towards_delaunay(tools, context);
    remesh::refine_inside(tools, options.max_elements, context);
  }
  remesh::collapse_short_edges(tools, true, context);
}

std::string in_words(double count) { return std::to_string(static_cast<long long>(count)); }

/// Where the size of the whole model would be met by far fewer elements than the edges of the input ask for, the user is told before the work.
void warn_of_short_edges(const PiecewiseLinearComplex& plc, const DomainMesh& mesh, RefineOptions options, const RunContext& context,
                         RefineResult& result) {
  constexpr double many = 250'000, most = 2;
  const double estimate = result.statistics.estimated_elements;
  if (!(options.size.global > 0) || !options.size.from_input_edges || !sizes_surfaces(options) || estimate < many) return;
  options.size.from_input_edges = false;
  const double without = remesh::estimate_elements(mesh, remesh::build_size_field(plc, mesh, options, size_tolerance(options)).all);
  if (estimate < most * without) return;
  result.warnings.push_back("short edges of the input ask for most of the " + in_words(estimate) + " elements or more to come; the sizes asked for about " +
                            in_words(without) + ": for fewer, ask for a least size, take no sizes from the input's edges, ask for sizes inside only, or allow "
                            "surfaces a tolerance");
  context.note(LogLevel::warning, result.warnings.back());
}

void announce_estimate(const PiecewiseLinearComplex& plc, const DomainMesh& mesh, const RefineOptions& options, const RunContext& context,
                       RefineResult& result) {
  result.statistics.estimated_elements = remesh::estimate_elements(mesh, result.size_field);
  context.note(LogLevel::info, "about " + in_words(result.statistics.estimated_elements) + " elements to come");
  warn_of_short_edges(plc, mesh, options, context, result);
  check_estimate(result.statistics.estimated_elements, options.max_elements);
}

/// Where surfaces may move, a few points are as well added one by one: there is no need to mesh anew.
double least_share_of_points(const RefineOptions& o) { return o.honour == Honour::tolerance ? 0.01 : 0; }

/// Meshes anew with points on edges and facets at the asked distances: a constrained Delaunay start, where adding them one by one would
/// start from the slivers between them. False where that cannot be; the mesh is then as it was.
bool add_surface_points(const PiecewiseLinearComplex& plc, const RefineOptions& options, ConstrainedTetrahedralization& mesh,
                        const RunContext& context, RefineResult& result) {
  const remesh::MergedFacets merged = remesh::merge_pieces(plc, options.facet_parent);
  const SizeField none({}, {});
  remesh::SampledComplex sampled = remesh::sample_surfaces(merged, mesh, sizes_surfaces(options) ? result.size_field : none, context);
  const std::size_t n_on_facets = sampled.plc.facet_points.size() - merged.plc.facet_points.size();
  const std::size_t n_on_edges = sampled.plc.points.size() - plc.points.size() - n_on_facets;
  const bool is_merged = merged.plc.n_facets() < plc.n_facets();
  if (!is_merged && static_cast<double>(n_on_facets + n_on_edges) <= least_share_of_points(options) * static_cast<double>(plc.points.size())) return false;
  auto fresh = remesh::mesh_sampled(merged, mesh, std::move(sampled), context);
  if (!fresh) return false;
  mesh = std::move(*fresh);
  result.statistics.points_on_curves += n_on_edges;
  result.statistics.points_on_surfaces += n_on_facets;
  return true;
}

/// Where surfaces are not proven to be within the tolerance both ways, points are put there. Returns what is left in the end.
remesh::Deviations hold_to_tolerance(Toolbox& tools, const RunContext& context) {
  constexpr unsigned most_rounds = 8;
  remesh::Deviations found = tools.guard.deviations(tools.mesh, context.threads);
  for (unsigned round = 0; round < most_rounds && !found.breaches.empty(); ++round) {
    context.check_cancelled();
    if (remesh::mend_surfaces(tools, found.breaches) == 0) break;
    found = tools.guard.deviations(tools.mesh, context.threads);
  }
  return found;
}

/// A whole run with samples held to `margin` of the tolerance.
struct Attempt {
  RefineResult result;
  std::vector<remesh::Breach> breaches;
};

Attempt attempt_within(double margin, const PiecewiseLinearComplex& plc, ConstrainedTetrahedralization input, const RefineOptions& options,
                       const RunContext& context) {
  Attempt attempt;
  RefineResult& result = attempt.result;
  DomainMesh mesh = remesh::import_domain(plc, input, options);
  remesh::SizeFields sizes = remesh::build_size_field(plc, mesh, options, size_tolerance(options));
  result.size_field = std::move(sizes.all);
  result.asked = std::move(sizes.without_gaps);
  result.statistics.sizes_on_surfaces = sizes_surfaces(options);
  if (options.refine) announce_estimate(plc, mesh, options, context, result);
  std::optional<StageScope> refining;
  if (options.refine) refining.emplace(context, "refine");
  std::optional<DomainMesh> given;
  if (options.refine && add_surface_points(plc, options, input, context, result))
    given = std::exchange(mesh, remesh::import_domain(plc, input, options));
  const remesh::SurfaceGuard guard(given ? *given : mesh, mesh, plc, options.honour, options.tolerance, margin);
  given.reset();
  Toolbox tools(mesh, guard, result.size_field, result.statistics);
  tools.bad_cells_may_spread = !sizes_surfaces(options);
  if (options.refine) refine_to_size(tools, options, context);
  refining.reset();
  result.statistics.worst_shape_before = worst_shape(mesh);
  remesh::Deviations found;
  {
    const StageScope stage(context, "improve");
    remesh::improve_mesh(tools, options, context);
    found = hold_to_tolerance(tools, context);
  }
  result.statistics.deviation_result_to_input = found.result_to_input;
  result.statistics.deviation_input_to_result = found.input_to_result;
  attempt.breaches = std::move(found.breaches);
  result.statistics.worst_shape_after = worst_shape(mesh);
  result.statistics.edges_within_size = share_of_edges_within_size(tools);
  remesh::renew_facets(mesh, guard, plc);
  result.kept_patch = remesh::patches_of_facets(plc, options);
  const std::string fault = mesh.validate();
  if (!fault.empty()) throw InternalError("refinement: " + fault);
  result.mesh = remesh::export_domain(mesh, plc, input);
  return attempt;
}

[[noreturn]] void refuse_tolerance(const std::vector<remesh::Breach>& breaches) {
  const auto worst = std::max_element(breaches.begin(), breaches.end(), [](const auto& a, const auto& b) { return a.distance < b.distance; });
  char place[120];
  std::snprintf(place, sizeof place, "(%.9g, %.9g, %.9g)", worst->place.x, worst->place.y, worst->place.z);
  ErrorContext context;
  context.places.push_back(worst->place);
  for (const auto& b : breaches) {
    context.places.push_back(b.place);
    if (b.facet != no_index) context.facets.push_back(b.facet);
  }
  throw Error(ErrorKind::cannot_mesh,
              "surfaces could not be remeshed so that they are proven to be within the tolerance of the input, both ways: " +
                  std::to_string(breaches.size()) + " triangles or pieces of curves are not, the worst at " + place +
                  ". Ask for a larger tolerance, for smaller sizes there, or keep the surfaces exactly",
              std::move(context));
}

}  // namespace

double estimate_elements(const PiecewiseLinearComplex& plc, const ConstrainedTetrahedralization& mesh,
                         const RefineOptions& options) {
  check_options(plc, options);
  const DomainMesh domain = remesh::import_domain(plc, mesh, options);
  return remesh::estimate_elements(
      domain, remesh::build_size_field(plc, domain, options, size_tolerance(options)).all);
}

RefineResult refine_and_improve(const PiecewiseLinearComplex& plc, ConstrainedTetrahedralization input,
                                const RefineOptions& options, const RunContext& context) {
  check_options(plc, options);
  if (options.honour == Honour::exact) return attempt_within(1, plc, std::move(input), options, context).result;
  Attempt attempt;
  for (const double margin : {remesh::SurfaceGuard::sampling_margin, 0.45, 0.25}) {
    attempt = attempt_within(margin, plc, input, options, context);
    if (attempt.breaches.empty()) return std::move(attempt.result);
    context.note(LogLevel::info, "surfaces are not proven to be within the tolerance in " + std::to_string(attempt.breaches.size()) +
                                     " places: held more closely and done again");
  }
  refuse_tolerance(attempt.breaches);
}

}  // namespace geomesh
