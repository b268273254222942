// SPDX-License-Identifier: GPL-3.0-or-later
#include <nlohmann/json.hpp>

#include "geomesh/geomodel/report.hpp"
#include "geomesh/geomodel/writers.hpp"
#include "pipeline/finish.hpp"
#include "pipeline/read_points.hpp"

namespace geomesh::geomodel {
namespace {

/// Equal points are one vertex; a warning names the first few rows.
void report_equal_points(const std::vector<VertexIndex>& representative, std::vector<std::string>& warnings, const RunContext& context) {
  std::size_t n = 0;
  std::string rows;
  for (VertexIndex v = 0; v < representative.size(); ++v) {
    if (representative[v] == v) continue;
    if (++n <= 5) rows += (rows.empty() ? "" : ", ") + std::to_string(v) + " = " + std::to_string(representative[v]);
  }
  if (n > 0)
    warn(warnings, context, std::to_string(n) + " points equal an earlier one and were merged with it (rows from 0: " + rows +
                                (n > 5 ? ", ..." : "") + ")");
}

/// The finite cells as one region `hull`, points renumbered without gaps.
ModelMesh to_model_mesh(const std::vector<Vec3>& points, const DelaunayTetrahedralization& delaunay) {
  ModelMesh mesh;
  std::vector<VertexIndex> new_index(points.size(), no_vertex);
  for (VertexIndex v = 0; v < points.size(); ++v) {
    if (delaunay.representative[v] != v) continue;
    new_index[v] = static_cast<VertexIndex>(mesh.points.size());
    mesh.points.push_back(points[v]);
    mesh.input_vertex.push_back(static_cast<std::int32_t>(v));
  }
  mesh.point_kind.assign(mesh.points.size(), 0);
  const TetMesh& cells = delaunay.mesh;
  for (CellIndex c = 0; c < cells.n_slots(); ++c) {
    if (!cells.is_live(c) || cells.is_ghost(c)) continue;
    Tetrahedron t{};
    for (unsigned i = 0; i < 4; ++i) t[i] = new_index[cells.vertex(c, i)];
    mesh.tetrahedra.push_back(t);
  }
  mesh.tet_region.assign(mesh.tetrahedra.size(), 1);
  double volume = 0;
  for (const Tetrahedron& t : mesh.tetrahedra) {
    const Vec3& o = mesh.points[t[0]];
    volume += dot(mesh.points[t[3]] - o, cross(mesh.points[t[1]] - o, mesh.points[t[2]] - o)) / 6;
  }
  mesh.regions.push_back({1, "hull", {}, mesh.tetrahedra.size(), volume});
  return mesh;
}

}  // namespace

JobResult run_delaunay(const DelaunayRequest& request, const RunContext& context) {
  require_writable(request.output);
  if (request.report) require_writable(*request.report);
  StageRecorder recorder(context, "");
  JobResult result;
  std::vector<Vec3> points;
  {
    StageScope stage(recorder.context(), "read");
    points = read_points(request.points);
    recorder.context().note(LogLevel::info, std::to_string(points.size()) + " points");
  }
  DelaunayTetrahedralization delaunay;
  {
    StageScope stage(recorder.context(), "delaunay");
    delaunay = delaunay_tetrahedralization(points, request.options, recorder.context());
    recorder.context().note(LogLevel::info, std::to_string(delaunay.statistics.points_deferred) + " points deferred");
  }
  report_equal_points(delaunay.representative, result.warnings, recorder.context());

  ModelMesh mesh;
  {
    StageScope stage(recorder.context(), "verify");
    mesh = to_model_mesh(points, delaunay);
    mesh.name = request.output.stem().string();
    const std::vector<std::string> faults = validate_model_mesh(mesh);
    if (!faults.empty()) throw InternalError("the triangulation is not valid, so nothing was written (a bug of geomesh): " + faults.front());
  }
  {
    StageScope stage(recorder.context(), "write");
    if (!request.output.parent_path().empty()) std::filesystem::create_directories(request.output.parent_path());
    const auto stem = request.output.parent_path() / request.output.stem();
    result.files = write_format(mesh, request.output.extension().string().substr(1), stem);
  }
  Report report;
  report.command = "delaunay";
  report.name = mesh.name;
  report.input_json = nlohmann::ordered_json{{"points", points.size()}}.dump();
  ConstrainedTetrahedralization core;
  core.delaunay_statistics = delaunay.statistics;
  core.recovery.tetrahedra_unconstrained = core.recovery.tetrahedra_final = mesh.tetrahedra.size();
  core.delaunay = true;
  report.core = &core;
  report.mesh = &mesh;
  report.warnings = result.warnings;
  report.stages = recorder.records();
  for (const auto& file : result.files) report.files.push_back(file.filename().string());
  if (request.output.extension() == ".vtu") {
    result.files.push_back((request.output.parent_path() / request.output.stem()).string() + ".report.json");
    write_report(report, result.files.back());
  }
  if (request.report) {
    write_report(report, *request.report);
    result.files.push_back(*request.report);
  }
  result.summary.push_back(std::to_string(mesh.tetrahedra.size()) + " tetrahedra on " + std::to_string(mesh.points.size()) + " points");
  return result;
}

}  // namespace geomesh::geomodel
