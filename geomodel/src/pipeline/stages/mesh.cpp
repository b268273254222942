// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the stages from delaunay to improve, declared in pipeline/stages/stages.hpp.
#include <algorithm>
#include <cstdio>

#include "geomesh/geomodel/model_mesh.hpp"
#include "naming/name_regions.hpp"
#include "pipeline/region_volumes.hpp"
#include "pipeline/stages/name.hpp"
#include "pipeline/stages/refine_model.hpp"
#include "pipeline/stages/target_elements.hpp"
#include "pipeline/surfaces_of_facets.hpp"
#include "solver_mesh/corners/divide_tetrahedra.hpp"
#include "solver_mesh/corners/free_corners.hpp"

namespace geomesh::geomodel {
namespace {

ConstrainedTetrahedralization tetrahedralize_model(const ModelRecords& model, Journal& journal) {
  ConstrainedTetrahedralization core = tetrahedralize(model.arranged.plc.plc, model.inputs.options, journal.context());
  if (core.tetrahedra.empty())
    throw Error(ErrorKind::cannot_mesh,
                "the surfaces enclose nothing: there is no region to mesh. Close the surfaces, add a box (--box "
                "x0,y0,z0,x1,y1,z1), or keep the convex hull (--hull)");
  return core;
}

/// Removes the parts of the mesh above the topography or below the floor, if the model has these.
ConstrainedTetrahedralization cut_at_ends(ConstrainedTetrahedralization core, const ModelRecords& model,
                                          Journal& journal) {
  const std::vector<Index>& lost = core.recovery.facets_not_recovered;
  if (!lost.empty())
    journal.warn(std::to_string(lost.size()) +
                 " facets are in the mesh but not Delaunay: small angles between surfaces would need more points than "
                 "the budget (" +
                 surfaces_of_facets(lost, model.arranged) +
                 "; the report lists them in recovery.facets_not_recovered)");
  std::vector<std::string> warnings;
  const Arranged& arranged = model.arranged;
  core = within_ends(std::move(core), arranged.arrangement.soup, arranged.plc, arranged.surfaces, model.built.naming,
                     warnings);
  journal.warn_all(std::move(warnings));
  return core;
}

class Refiner {
 public:
  Refiner(const ModelRecords& model, const SparseMeshing& sparse, Journal& journal)
      : model_(model), sparse_(sparse), journal_(journal) {}

  /// Announces the number of elements, then refines. `naming` has the naming rules of the mesh.
  RefinedToCount refine(ConstrainedTetrahedralization mesh, const NamingRules& naming) const {
    if (model_.arranged.refinement.target_elements > 0)
      return refine_to_count(model_, mesh, options(mesh, naming), journal_);
    const CountedOptions counted = [&] {
      const StageScope stage(journal_.context(), "estimate");
      CountedOptions found = with_derived_size(model_, mesh, options(mesh, naming));
      announce_count(found, model_.inputs.unit, journal_);
      return found;
    }();
    RefinedToCount refined{refine_model(model_, std::move(mesh), counted.options, journal_.context()), counted.used};
    journal_.keep_warnings(refined.result.warnings);
    return refined;
  }

 private:
  RefineOptions options(const ConstrainedTetrahedralization& mesh, const NamingRules& naming) const {
    RefineOptions asked = refine_options(model_, mesh, naming);
    asked.sparse_growth = sparse_.growth;
    asked.sparse_ratio = sparse_.ratio;
    asked.sparse_surfaces = sparse_.surfaces;
    return asked;
  }

  const ModelRecords& model_;
  const SparseMeshing& sparse_;
  Journal& journal_;
};

/// Returns the mesh, refined if requested. In conforming mode the whole mesh is refined, because the Delaunay property
/// concerns the whole; otherwise only the part inside the model's ends is refined.
Meshed mesh_to_size(const ModelRecords& model, const SparseMeshing& sparse, Journal& journal) {
  const RefinementSettings& settings = model.arranged.refinement;
  const bool conforming = model.inputs.options.recover.mode == MeshMode::conforming;
  const Refiner refiner(model, sparse, journal);
  RefinedToCount refined{{}, settings};
  refined.result.mesh = tetrahedralize_model(model, journal);
  if (settings.refine && conforming) refined = refiner.refine(std::move(refined.result.mesh), model.built.naming);
  refined.result.mesh = cut_at_ends(std::move(refined.result.mesh), model, journal);
  NamingRules naming = model.built.naming;
  naming.topography.clear();
  naming.floor.clear();
  std::vector<double> volumes_of_input;
  if (settings.refine && !conforming) {
    if (settings.honour == Honour::tolerance) volumes_of_input = component_volumes(refined.result.mesh);
    refined = refiner.refine(std::move(refined.result.mesh), naming);
  }
  return {std::move(refined.result), std::move(refined.used), std::move(naming), std::move(volumes_of_input)};
}

/// Returns how far remeshing moved surfaces. This is proven to be within the remaining tolerance, so nothing is
/// subtracted from the tolerance.
ToleranceUse use_of(const RefineStatistics& statistics) {
  ToleranceUse use{"remeshing"};
  use.moved = std::max(statistics.deviation_result_to_input, statistics.deviation_input_to_result);
  return use;
}

void tell_scale(const ZScale& scale, Journal& journal) {
  if (scale.factor() == 1) return;
  char text[32];
  std::snprintf(text, sizeof text, "%g", scale.factor());
  journal.note(std::string("z was scaled by ") + text +
               " while meshing; lengths and areas of clipping and rounding are those of the scaled model");
}

}  // namespace

Arranged in_true_heights(const Arranged& arranged, const ZScale& scale) {
  Arranged out = arranged;
  scale.undo(out.arrangement.soup.points);
  scale.undo(out.plc.plc.points);
  for (TriangulatedSurface& surface : out.surfaces) scale.undo(surface.points);
  return out;
}

Meshed mesh_model(const ModelRecords& model, const SparseMeshing& sparse, Journal& journal) {
  Meshed meshed = mesh_to_size(model, sparse, journal);
  if (meshed.used.tolerance.left() > 0) meshed.used.tolerance.take(use_of(meshed.refined.statistics));
  const ZScale& scale = model.built.z_scale;
  if (scale.factor() != 1) scale.undo(meshed.refined.mesh.points);
  tell_scale(scale, journal);
  return meshed;
}

Meshed free_split_corners(const ModelRecords& model, Meshed meshed, const std::vector<std::string>& split,
                          unsigned threads) {
  if (split.empty()) return meshed;
  std::vector<std::string> told_later;  // warnings of naming, dropped because naming the final mesh repeats them
  const ModelMesh named = named_mesh(model, meshed, told_later, threads);
  divide_tetrahedra(meshed.refined.mesh, tetrahedra_on_surfaces(named, split));
  return meshed;
}

}  // namespace geomesh::geomodel
