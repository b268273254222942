// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>

#include "geomesh/geomodel/project.hpp"
#include "pipeline/prepare.hpp"
#include "pipeline/refine_model.hpp"
#include "quality_models.hpp"

namespace geomesh::bench {
namespace {

QualityModel prepared(const std::string& name, geomodel::PreparedModel& model) {
  QualityModel q;
  q.name = name;
  q.facet_parent = geomodel::facet_parents(model);
  q.plc = std::move(model.plc.plc);
  q.sizes_from_edges = false;
  return q;
}

}  // namespace

QualityModel sample(const std::string& name) {
  const auto file = std::filesystem::path(GEOMESH_SAMPLES) / name / "project.yaml";
  geomodel::PreparedModel model;
  geomodel::prepare_project(geomodel::read_project(file), model, {});
  return prepared(name, model);
}

QualityModel model_a4() {
  geomodel::MeshRequest request;
  request.inputs = {std::string(GEOMESH_SHARED_DATA) + "/modelA4/modelA4.ml"};
  if (!std::filesystem::exists(request.inputs[0])) return {"modelA4", {}, false};
  geomodel::PreparedModel model;
  geomodel::prepare_mesh(request, model, {});
  return prepared("modelA4", model);
}

}  // namespace geomesh::bench
