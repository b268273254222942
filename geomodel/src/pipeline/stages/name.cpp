// SPDX-License-Identifier: GPL-3.0-or-later
// Names the regions, surfaces and curves of a mesh, declared in pipeline/stages/name.hpp.
#include "pipeline/stages/name.hpp"

#include "pipeline/region_volumes.hpp"
#include "pipeline/stages/stages.hpp"
#include "rules/order/deposition.hpp"

namespace geomesh::geomodel {
namespace {

/// Returns the sum of the largest movements of surfaces: by merging, by rounding, and within the tolerance.
double moved_at_most(const ModelRecords& model, const Meshed& meshed) {
  return meshed.used.tolerance.bound() + model.arranged.arrangement.rounding.largest;
}

}  // namespace

ModelMesh named_mesh(const ModelRecords& model, const Meshed& meshed, std::vector<std::string>& warnings,
                     unsigned threads) {
  const Arranged& arranged = model.arranged;
  const NamingRules naming = with_heights(meshed.naming, arranged.surfaces, model.built.rows, model.built.rules);
  return name_model(
      {meshed.refined.mesh, arranged.arrangement.soup, arranged.plc, arranged.surfaces, moved_at_most(model, meshed)},
      model.inputs.points, naming, warnings, threads);
}

void require_valid(const ModelMesh& mesh, const ZScale& scale, unsigned threads) {
  const std::vector<std::string> faults = validate_model_mesh(mesh, threads);
  if (!faults.empty() && !scale.is_exact())
    throw Error(
        ErrorKind::cannot_mesh,
        "crs.z_scale is no power of two, so that undoing it rounds, and here a tetrahedron does not bear that: " +
            faults.front() + "; take a power of two (2, 4, 8, 16 ...), which is undone exactly");
  if (faults.empty()) return;
  std::string all =
      "the finished mesh does not hold what it must, so nothing was written (a bug of geomesh; please report it):";
  for (const std::string& fault : faults) all += "\n  " + fault;
  throw InternalError(all);
}

ModelMesh name_and_verify(const ModelRecords& model, const Meshed& meshed, std::vector<CellArray> arrays,
                          Journal& journal) {
  const unsigned threads = journal.context().threads;
  std::vector<std::string> warnings;
  ModelMesh mesh = named_mesh(model, meshed, warnings, threads);
  journal.warn_all(std::move(warnings));
  mesh.name = model.inputs.name;
  mesh.origin = model.inputs.origin;
  mesh.cell_arrays = std::move(arrays);
  mesh.unit = model.inputs.unit;
  require_valid(mesh, model.built.z_scale, threads);
  const ModelRules& rules = model.built.rules;
  if (model.built.volume.volume > 0)
    require_volume_filled(mesh, model.built.volume.volume, !rules.topography.empty() || !rules.floor.empty());
  journal.context().note(LogLevel::info,
                         std::to_string(mesh.tetrahedra.size()) + " tetrahedra exactly positive and conforming");
  set_volumes_of_input(mesh, meshed.refined.mesh, meshed.volumes_of_input);
  if (!meshed.volumes_of_input.empty()) require_volumes_within(mesh, meshed.used.tolerance.left());
  return mesh;
}

}  // namespace geomesh::geomodel
