// SPDX-License-Identifier: MIT
#include "geomesh/core/refine.hpp"

#include <algorithm>
#include <cmath>
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

/// A whole run. What is not as promised ends it early: it has to be done again, with surfaces held more closely.
struct Attempt {
  RefineResult result;
  std::vector<remesh::Breach> breaches;
  std::vector<remesh::TightZone> crossings;
  bool holds() const { return breaches.empty() && crossings.empty(); }
};

Attempt attempt_holding(const remesh::Hold& hold, const PiecewiseLinearComplex& plc, ConstrainedTetrahedralization input, const RefineOptions& options,
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
  const remesh::SurfaceGuard guard(given ? *given : mesh, mesh, plc, options.honour, options.tolerance, hold);
  given.reset();
  Toolbox tools(mesh, guard, result.size_field, result.statistics);
  tools.bad_cells_may_spread = !sizes_surfaces(options);
  if (options.refine) refine_to_size(tools, options, context);
  refining.reset();
  if (!guard.exact()) attempt.crossings = remesh::crossings_outside(mesh);
  if (!attempt.holds()) return attempt;
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
  if (!guard.exact()) attempt.crossings = remesh::crossings_outside(mesh);
  if (!attempt.holds()) return attempt;
  result.statistics.worst_shape_after = worst_shape(mesh);
  result.statistics.edges_within_size = share_of_edges_within_size(tools);
  remesh::renew_facets(mesh, guard, plc);
  result.kept_patch = remesh::patches_of_facets(plc, options);
  const std::string fault = mesh.validate();
  if (!fault.empty()) throw InternalError("refinement: " + fault);
  result.mesh = remesh::export_domain(mesh, plc, input);
  return attempt;
}

bool overlap(const Box3& a, const Box3& b) {
  for (std::size_t i = 0; i < 3; ++i)
    if (a.min[i] > b.max[i] || b.min[i] > a.max[i]) return false;
  return true;
}

/// More closely than in the attempt: everywhere where the tolerance was not proven or it was not enough to hold places twice, and where
/// surfaces came to cross.
void tighten(remesh::Hold& hold, const Attempt& attempt, double tolerance, unsigned round) {
  constexpr double closer = 0.65, closer_in_zones = 0.25, about_zones = 4;
  if (!attempt.breaches.empty() || round > 1) hold.margin *= closer;
  const double reach = about_zones * tolerance;
  const std::size_t n_before = hold.zones.size();
  for (remesh::TightZone zone : attempt.crossings) {
    zone.tolerance = tolerance;
    for (std::size_t k = 0; k < n_before; ++k)
      if (overlap(hold.zones[k].box, zone.box)) zone.tolerance = std::min(zone.tolerance, hold.zones[k].tolerance);
    zone.tolerance *= closer_in_zones;
    zone.box = {zone.box.min - Vec3{reach, reach, reach}, zone.box.max + Vec3{reach, reach, reach}};
    hold.zones.push_back(zone);
  }
}

std::string place_words(const Vec3& p) {
  char text[120];
  std::snprintf(text, sizeof text, "(%.9g, %.9g, %.9g)", p.x, p.y, p.z);
  return text;
}

[[noreturn]] void refuse_tolerance(const Attempt& attempt) {
  constexpr const char* what_to_do = ". Ask for another tolerance, for smaller sizes there, or keep the surfaces exactly";
  ErrorContext context;
  if (!attempt.crossings.empty()) {
    const Box3& box = attempt.crossings.front().box;
    const Vec3 place = 0.5 * (box.min + box.max);
    context.places.push_back(place);
    throw Error(ErrorKind::cannot_mesh,
                "surfaces that are nearer to each other than the tolerance, with the outside between, could not be remeshed without crossing, at " +
                    place_words(place) + what_to_do,
                std::move(context));
  }
  const auto& breaches = attempt.breaches;
  const auto worst = std::max_element(breaches.begin(), breaches.end(), [](const auto& a, const auto& b) { return a.distance < b.distance; });
  context.places.push_back(worst->place);
  for (const auto& b : breaches) {
    context.places.push_back(b.place);
    if (b.facet != no_index) context.facets.push_back(b.facet);
  }
  throw Error(ErrorKind::cannot_mesh,
              "surfaces could not be remeshed so that they are proven to be within the tolerance of the input, both ways: " +
                  std::to_string(breaches.size()) + " triangles or pieces of curves are not, the worst at " + place_words(worst->place) + what_to_do,
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
  if (options.honour == Honour::exact) return attempt_holding({}, plc, std::move(input), options, context).result;
  constexpr unsigned most_attempts = 6;
  remesh::Hold hold;
  for (unsigned round = 0;; ++round) {
    Attempt attempt = attempt_holding(hold, plc, input, options, context);
    if (attempt.holds()) return std::move(attempt.result);
    if (round + 1 == most_attempts) refuse_tolerance(attempt);
    tighten(hold, attempt, options.tolerance, round);
    context.note(LogLevel::info, "surfaces are not as promised in " + std::to_string(attempt.breaches.size() + attempt.crossings.size()) +
                                     " places: held more closely and refined again");
  }
}

}  // namespace geomesh
