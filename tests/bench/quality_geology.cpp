// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>

#include "geomesh/core/refine.hpp"
#include "geomesh/geomodel/project.hpp"
#include "pipeline/stages/refine_model.hpp"
#include "quality_models.hpp"
#include "test_places.hpp"

namespace geomesh::bench {
namespace {

QualityModel prepared(const std::string& name, geomodel::Arranged arranged) {
  QualityModel q;
  q.name = name;
  q.facet_parent = geomodel::facet_parents(arranged);
  q.plc = std::move(arranged.plc.plc);
  q.sizes_from_edges = false;
  return q;
}

}  // namespace

QualityModel sample(const std::string& name) {
  const auto file = std::filesystem::path(GEOMESH_SOURCE_DIR) / "samples" / name / "project.yaml";
  const RunContext context;
  geomodel::Journal journal(context);
  const geomodel::Inputs inputs = geomodel::read_project_model(geomodel::read_project(file), journal);
  const geomodel::Built built = geomodel::build_model(inputs, journal);
  return prepared(name, geomodel::intersect(inputs, built, journal));
}

QualityModel model_a4() {
  geomodel::MeshRequest request;
  request.inputs = {std::string(GEOMESH_SHARED_DATA) + "/modelA4/modelA4.ml"};
  if (!std::filesystem::exists(request.inputs[0])) return {"modelA4", {}, false};
  const RunContext context;
  geomodel::Journal journal(context);
  const geomodel::Inputs inputs = geomodel::read_mesh_model(request, journal);
  return prepared("modelA4", geomodel::intersect(inputs, geomodel::built_as_given(inputs), journal));
}

QualityModel model_a4_remeshed() {
  QualityModel given = model_a4(), remeshed;
  remeshed.name = "modelA4, remeshed surfaces";
  if (given.plc.points.empty()) return remeshed;
  const double length = given.diagonal();
  RefineOptions options;
  options.facet_parent = given.facet_parent;
  options.honour = Honour::tolerance;
  options.tolerance = length / 1000;
  options.size.global = length / 50;
  const RefineResult result = refine_and_improve(given.plc, tetrahedralize(given.plc), options);
  std::vector<VertexIndex> row(result.mesh.points.size(), no_vertex);  // in the new complex
  for (const auto& face : result.mesh.faces) {
    Triangle t = face.vertices;
    for (VertexIndex& v : t) {
      if (row[v] == no_vertex) {
        row[v] = static_cast<VertexIndex>(remeshed.plc.points.size());
        remeshed.plc.points.push_back(result.mesh.points[v]);
      }
      v = row[v];
    }
    remeshed.plc.add_triangle(t, given.plc.facet_provenance[face.facet]);
  }
  return remeshed;
}

}  // namespace geomesh::bench
