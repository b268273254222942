// SPDX-License-Identifier: MIT
// The driver of refinement that keeps the mesh Delaunay, declared in geomesh/core/refine_conforming.hpp.
#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "common/geometry.hpp"
#include "common/sort_unique.hpp"
#include "geomesh/core/refine_conforming.hpp"
#include "remesh/conforming/conforming_refiner.hpp"
#include "remesh/domain/domain_io.hpp"
#include "remesh/sizes/sizes.hpp"
#include "tetrahedralize/conforming_step.hpp"

namespace geomesh {

namespace {

/// Largest number of points that recovery may add on one facet during refinement. The limit is high because each point
/// divides the facet further and each part may lose faces once.
constexpr std::size_t steiner_per_refined_facet = 2000;

/// For each facet of the caller's model, the components on its two sides.
remesh::FacetComponents facet_components(const PiecewiseLinearComplex& plc, const ConstrainedTetrahedralization& mesh) {
  remesh::FacetComponents components(plc.n_facets(), {no_index, no_index});
  std::vector<std::uint8_t> seen(plc.n_facets(), 0);
  for (const auto& face : mesh.faces) {
    const auto component = [&](Index t) { return t == no_index ? no_index : mesh.component[t]; };
    const std::array<Index, 2> here{component(face.tetrahedron_below), component(face.tetrahedron_above)};
    auto& known = components[face.facet];
    for (std::size_t side = 0; side < 2; ++side)
      if (!seen[face.facet])
        known[side] = here[side];
      else if (known[side] != here[side])
        known[side] = no_index;
    seen[face.facet] = 1;
  }
  return components;
}

/// The components on the two sides of each facet, for the facets as recovery numbers them.
remesh::FacetComponents in_terms_of(const ModelNames& names, const remesh::FacetComponents& callers) {
  remesh::FacetComponents components;
  for (Index f = 0; f < names.facet.size(); ++f) {
    components.push_back(callers[names.facet[f]]);
    if (names.swaps_sides(f)) std::swap(components.back()[0], components.back()[1]);
  }
  return components;
}

/// Handles small input angles that rule out a Delaunay mesh, as tetrahedralize does: the model is meshed and refined in
/// constrained mode, and the facets that are not Delaunay are listed.
RefineResult refine_constrained_instead(const PiecewiseLinearComplex& plc, TetrahedralizeOptions meshing,
                                        const RefineOptions& options, const RunContext& context) {
  context.note(LogLevel::warning,
               "conforming mode: small angles need too many points; the model is refined in constrained mode instead");
  meshing.recover.mode = MeshMode::constrained;
  RunContext quiet = context;
  quiet.stage = {};
  RefineResult result = refine_and_improve(plc, tetrahedralize(plc, meshing, quiet), options, context);
  result.mesh.delaunay = false;
  list_facets_off_delaunay(result.mesh);
  std::vector<Index>& off = result.mesh.recovery.facets_not_recovered;
  if (off.empty())  // even if all facets are Delaunay, cells may not be
    for (Index f = 0; f < plc.n_facets(); ++f) off.push_back(f);
  return result;
}

[[noreturn]] void refuse(const std::string& what, std::size_t limit) {
  throw Error(ErrorKind::cannot_mesh,
              what + " than the limit of " + std::to_string(limit) + "; choose larger sizes, or raise the limit");
}

void require_sizes_alone(const RefineOptions& o) {
  if (o.honour != Honour::exact)
    throw Error(ErrorKind::usage,
                "conforming mode keeps the input's facets: surfaces cannot be remeshed within a tolerance");
  if (!o.refine)
    throw Error(ErrorKind::usage,
                "conforming mode is refined to sizes; elements are not moved or flipped, which would leave Delaunay");
}

}  // namespace

RefineResult refine_conforming(const PiecewiseLinearComplex& plc, const ConstrainedTetrahedralization& mesh,
                               const TetrahedralizeOptions& meshing, const RefineOptions& options,
                               const RunContext& context) {
  require_sizes_alone(options);
  if (mesh.recovery.facets_not_recovered.size() == plc.n_facets())
    return refine_constrained_instead(plc, meshing, options, context);
  RefineResult result;
  {
    const remesh::DomainMesh domain = remesh::import_domain(plc, mesh, options);
    remesh::SizeFields sizes = remesh::build_size_field(plc, domain, options, remesh::LocalTolerance());
    result.statistics.estimated_elements = remesh::estimate_elements(domain, sizes.all, options);
    result.size_field = std::move(sizes.all);
    result.asked = std::move(sizes.without_gaps);
  }
  const auto estimate = std::to_string(static_cast<long long>(result.statistics.estimated_elements));
  context.note(LogLevel::info, "about " + estimate + " elements to come");
  if (result.statistics.estimated_elements > static_cast<double>(options.max_elements))
    refuse("the sizes require about " + estimate + " elements, more", options.max_elements);
  std::optional<StageScope> stage(std::in_place, context, "refine");
  RunContext quiet = context;
  quiet.stage = {};  // only the stage refine is reported, not those of tetrahedralize()
  remesh::ConformingRefiner::Counts counts;
  bool is_too_large = false;
  const auto step = [&](recover::Recovery& recovery, const RecoverOptions& recover, std::vector<Index>& given_up) {
    RecoverOptions refined = recover;
    refined.max_steiner_per_facet = std::max(refined.max_steiner_per_facet, steiner_per_refined_facet);
    remesh::ConformingRefiner refiner(recovery, refined, result.size_field,
                                      in_terms_of(recovery.names, facet_components(plc, mesh)), options.max_elements);
    const bool within_budget = refiner.run();
    is_too_large = within_budget && !refiner.refine();
    counts = refiner.counts();
    given_up = refiner.facets_given_up();
    sort_unique(given_up);
    return within_budget;
  };
  TetrahedralizeOptions conforming = meshing;
  conforming.recover.mode = MeshMode::conforming;
  try {
    result.mesh = tetrahedralize_conforming(plc, conforming, quiet, step);
  } catch (const Error& e) {
    if (e.kind() != ErrorKind::cannot_mesh) throw;
    stage.reset();
    return refine_constrained_instead(plc, meshing, options, context);
  }
  if (is_too_large) refuse("refinement has reached more elements", options.max_elements);
  result.statistics.points_on_curves = counts.on_segments;
  result.statistics.points_on_surfaces = counts.on_facets;
  result.statistics.points_inside = counts.inside;
  result.statistics.passes = counts.rounds;
  if (counts.too_large > 0)
    context.note(
        LogLevel::info,
        std::to_string(counts.too_large) +
            " elements remain larger or more pointed than requested: a point for them would be too near to others");
  return result;
}

}  // namespace geomesh
