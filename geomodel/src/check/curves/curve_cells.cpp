// SPDX-License-Identifier: GPL-3.0-or-later
// Checks the line cells of curves against the edges of the mesh, declared in check/curves/check_curves.hpp.
#include <algorithm>
#include <set>

#include "check/curves/check_curves.hpp"
#include "check/mesh/faults.hpp"

namespace geomesh::geomodel::checking {
namespace {

MeshEdge edge_of(VertexIndex a, VertexIndex b) { return {std::min(a, b), std::max(a, b)}; }

std::set<MeshEdge> edges_of_mesh(const CheckedMesh& mesh) {
  std::vector<MeshEdge> all;
  for (const FacePair& face : mesh.faces)
    for (std::size_t i = 0; i < 3; ++i) all.push_back(edge_of(face.key[i], face.key[(i + 1) % 3]));
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return {all.begin(), all.end()};
}

constexpr const char* kinds[] = {"intersection", "border", "fault_tip", "well", "point"};

/// Checks that ids of curves are distinct and follow those of regions and surfaces, that kinds of curves are known, and
/// that each curve has cells.
void check_lists(const CheckedMesh& mesh, const CurvesFile& file, const FacesFile& faces, CheckResult& result) {
  FaultCollector wrong("wrong_curve_lists");
  std::set<std::int32_t> used(file.edge_curve.begin(), file.edge_curve.end()), listed, taken;
  used.insert(file.vertex_curve.begin(), file.vertex_curve.end());
  for (const auto& [id, name] : mesh.file.region_names) taken.insert(id);
  for (const auto& [id, name] : faces.surface_names) taken.insert(id);
  std::set<std::pair<std::string, std::string>> names;
  for (std::size_t row = 0; row < file.curves.size(); ++row) {
    const auto& curve = file.curves[row];
    const bool known = std::find(std::begin(kinds), std::end(kinds), curve.kind) != std::end(kinds);
    const bool is_new = listed.insert(curve.id).second;
    if (!known || !is_new || curve.name.empty() || taken.contains(curve.id) || !used.contains(curve.id) ||
        !names.insert({curve.kind, curve.name}).second)
      wrong.add(row, {});
    if (!taken.empty() && curve.id != *taken.rbegin() + static_cast<std::int32_t>(row) + 1) wrong.add(row, {});
  }
  for (const std::int32_t id : used)
    if (!listed.contains(id)) wrong.add(static_cast<std::size_t>(id), {});
  wrong.report(result,
               "entries of the list of curves are wrong: an id that is not the next after regions and surfaces, a name "
               "twice, an unknown kind, or no cell");
}

}  // namespace

CheckedCurves check_curve_cells(const CheckedMesh& mesh, const CurvesFile& file, const FacesFile& faces,
                                CheckResult& result) {
  CheckedCurves curves{file, {}, {}, {}};
  const std::vector<VertexIndex> rows = match_points(mesh, file.points);
  for (const auto& e : file.edges) curves.edges.push_back(edge_of(rows[e[0]], rows[e[1]]));
  for (const VertexIndex v : file.vertices) curves.vertices.push_back(rows[v]);
  for (std::size_t row = 0; row < file.curves.size(); ++row) curves.row_of_id.emplace(file.curves[row].id, row);
  FaultCollector unknown("curve_edges_not_in_mesh"), repeated("repeated_curve_edges");
  const std::set<MeshEdge> mesh_edges = edges_of_mesh(mesh);
  std::set<std::pair<MeshEdge, std::int32_t>> seen;
  for (std::size_t e = 0; e < curves.edges.size(); ++e) {
    const Vec3& place = file.points[file.edges[e][0]];
    if (!mesh_edges.contains(curves.edges[e])) unknown.add(e, place);
    if (!seen.insert({curves.edges[e], file.edge_curve[e]}).second) repeated.add(e, place);
  }
  for (std::size_t v = 0; v < curves.vertices.size(); ++v)
    if (curves.vertices[v] == no_vertex) unknown.add(v, file.points[file.vertices[v]]);
  unknown.report(result, "lines or points of the curves are no edge or point of the mesh");
  repeated.report(result, "lines of the curves are there twice under one id");
  check_lists(mesh, file, faces, result);
  result.checks_done.push_back("the curves: " + std::to_string(curves.edges.size()) +
                               " lines, each an edge of the mesh, once under each id");
  return curves;
}

}  // namespace geomesh::geomodel::checking
