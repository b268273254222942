// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the command `delaunay`, declared in geomesh/geomodel/pipeline.hpp.
#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "geomesh/geomodel/formats.hpp"
#include "geomesh/geomodel/pipeline.hpp"
#include "geomesh/geomodel/report.hpp"
#include "geomesh/geomodel/writers.hpp"
#include "naming/sums.hpp"
#include "pipeline/jobs/read_points.hpp"
#include "pipeline/journal.hpp"
#include "pipeline/stage_recorder.hpp"
#include "pipeline/stages/hull.hpp"

namespace geomesh::geomodel {
namespace {

/// Warns of equal input points, which become one vertex. The warning lists the first few, the report all of them.
void report_equal_points(const std::vector<VertexIndex>& representative, Journal& journal) {
  std::size_t n = 0;
  std::string rows;
  for (VertexIndex v = 0; v < representative.size(); ++v) {
    if (representative[v] == v) continue;
    if (++n <= 5) rows += (rows.empty() ? "" : ", ") + std::to_string(v) + " = " + std::to_string(representative[v]);
  }
  if (n > 0)
    journal.warn(std::to_string(n) + " points equal an earlier one and were merged with it (rows from 0: " + rows +
                 (n > 5 ? ", ..." : "") + ")");
}

/// Returns the pairs (merged point, equal earlier point) as indices of the input points.
nlohmann::ordered_json merged_points(const std::vector<VertexIndex>& representative) {
  auto pairs = nlohmann::ordered_json::array();
  for (VertexIndex v = 0; v < representative.size(); ++v)
    if (representative[v] != v) pairs.push_back({v, representative[v]});
  return pairs;
}

/// Returns the same oriented tetrahedron with its smallest vertex first and its second smallest vertex second.
Tetrahedron canonical(const Tetrahedron& t) {
  constexpr std::array<std::array<std::uint8_t, 4>, 4> to_front{
      {{0, 1, 2, 3}, {1, 0, 3, 2}, {2, 3, 0, 1}, {3, 2, 1, 0}}};
  const auto& order = to_front[static_cast<std::size_t>(std::min_element(t.begin(), t.end()) - t.begin())];
  Tetrahedron r{t[order[0]], t[order[1]], t[order[2]], t[order[3]]};
  std::rotate(r.begin() + 1, std::min_element(r.begin() + 1, r.end()), r.end());
  return r;
}

double volume_of(const ModelMesh& mesh) {
  CompensatedSum volume;
  for (const Tetrahedron& t : mesh.tetrahedra)
    volume.add(signed_volume(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]], mesh.points[t[3]]));
  return volume.value();
}

/// Adds the boundary of the triangulation as the only surface of the mesh, with outward normals.
void add_hull(ModelMesh& mesh, std::vector<Triangle> hull) {
  constexpr std::int32_t region = 1, surface = 2;
  for (Triangle& t : hull) std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  std::sort(hull.begin(), hull.end());
  CompensatedSum area;
  for (const Triangle& t : hull) {
    area.add(triangle_area(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]));
    mesh.faces.push_back({t, surface, 0, 1, region, 0, static_cast<std::int32_t>(mesh.faces.size())});
  }
  mesh.surface_sets = {{surface}};
  mesh.surfaces.push_back({surface, hull_name, SurfaceKind::surface, area.value()});
}

/// Returns the finite cells of a Delaunay tetrahedralization as one region `hull`, with points renumbered without gaps.
/// The order of the cells is canonical, so that files are the same for all algorithms.
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
  std::vector<Triangle> hull;
  for (CellIndex c = 0; c < cells.n_slots(); ++c) {
    if (!cells.is_live(c)) continue;
    const auto& v = cells.vertices(c);
    if (const int ghost = cells.ghost_index(c); ghost >= 0) {
      const auto& f = face_vertices[static_cast<std::size_t>(ghost)];
      hull.push_back({new_index[v[f[0]]], new_index[v[f[1]]], new_index[v[f[2]]]});
    } else {
      mesh.tetrahedra.push_back(canonical({new_index[v[0]], new_index[v[1]], new_index[v[2]], new_index[v[3]]}));
    }
  }
  std::sort(mesh.tetrahedra.begin(), mesh.tetrahedra.end());
  mesh.tet_region.assign(mesh.tetrahedra.size(), 1);
  mesh.regions.push_back({1, hull_name, {}, mesh.tetrahedra.size(), volume_of(mesh)});
  add_hull(mesh, std::move(hull));
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
  Journal journal(recorder.context());
  report_equal_points(delaunay.representative, journal);
  result.warnings = journal.warnings();

  ModelMesh mesh;
  {
    StageScope stage(recorder.context(), "verify");
    mesh = to_model_mesh(points, delaunay);
    mesh.name = request.output.stem().string();
    const std::vector<std::string> faults = validate_model_mesh(mesh);
    if (!faults.empty())
      throw InternalError("the triangulation is not valid, so nothing was written (a bug of geomesh): " +
                          faults.front());
  }
  {
    StageScope stage(recorder.context(), "write");
    if (!request.output.parent_path().empty()) std::filesystem::create_directories(request.output.parent_path());
    const auto stem = request.output.parent_path() / request.output.stem();
    result.files = write_format(mesh, format_name_of(request.output), stem);
  }
  Report report;
  report.command = "delaunay";
  report.name = mesh.name;
  report.input_json =
      nlohmann::ordered_json{{"points", points.size()}, {"equal_points", merged_points(delaunay.representative)}}
          .dump();
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
  result.summary.push_back(std::to_string(mesh.tetrahedra.size()) + " tetrahedra on " +
                           std::to_string(mesh.points.size()) + " points");
  return result;
}

}  // namespace geomesh::geomodel
