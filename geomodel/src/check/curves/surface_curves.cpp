// SPDX-License-Identifier: GPL-3.0-or-later
// Determines the intersections, borders and tips of surfaces from mesh faces, declared in
// check/curves/check_curves.hpp.
#include <algorithm>
#include <set>

#include "check/curves/check_curves.hpp"
#include "check/mesh/faults.hpp"

namespace geomesh::geomodel::checking {
namespace {

struct Named {
  std::string kind, name;
  friend auto operator<=>(const Named&, const Named&) = default;
};

std::map<MeshEdge, std::vector<Index>> faces_at_edges(const CheckedFaces& checked) {
  std::map<MeshEdge, std::vector<Index>> at;
  for (Index f = 0; f < checked.candidates().size(); ++f) {
    const Triangle& t = checked.candidates()[f];
    for (std::size_t i = 0; i < 3; ++i)
      at[{std::min(t[i], t[(i + 1) % 3]), std::max(t[i], t[(i + 1) % 3])}].push_back(f);
  }
  return at;
}

/// Returns the name and kind of the curve (docs/output-files.md) at an edge with these faces; nothing inside a patch.
std::optional<Named> curve_at(const CheckedFaces& checked, const std::vector<Index>& faces) {
  if (faces.size() == 2 && checked.set_of(faces[0]) == checked.set_of(faces[1])) return std::nullopt;
  std::set<std::int32_t> ids;
  for (const Index f : faces) ids.insert(checked.set_of(f).begin(), checked.set_of(f).end());
  const auto name_of = [&](std::int32_t id) {
    const auto name = checked.faces()->surface_names.find(id);
    return name == checked.faces()->surface_names.end() ? std::string() : name->second;
  };
  if (ids.size() == 1 && faces.size() == 1) {
    const Index row = checked.surface_of(*ids.begin());
    const bool is_fault = row != no_index && checked.specification().surfaces[row].kind == SurfaceKind::fault;
    return is_fault ? Named{"fault_tip", name_of(*ids.begin()) + ".tip"}
                    : Named{"border", name_of(*ids.begin()) + ".border"};
  }
  std::vector<std::string> names;
  for (const std::int32_t id : ids) names.push_back(name_of(id));
  if (names.size() == 1) names.push_back(names[0]);
  std::sort(names.begin(), names.end());
  std::string joined;
  for (const std::string& name : names) joined += (joined.empty() ? "" : "*") + name;
  return Named{"intersection", joined};
}

}  // namespace

void check_surface_curves(const CheckedFaces& checked, const CheckedCurves& curves, CheckResult& result) {
  std::map<MeshEdge, std::set<Named>> given;
  for (std::size_t e = 0; e < curves.edges.size(); ++e) {
    const auto row = curves.row_of_id.find(curves.file.edge_curve[e]);
    if (row == curves.row_of_id.end()) continue;
    const auto& curve = curves.file.curves[row->second];
    if (curve.kind != "well") given[curves.edges[e]].insert({curve.kind, curve.name});
  }
  FaultCollector missing("missing_curve_edges"), wrong("wrong_curve_edges");
  const CheckedMesh& mesh = checked.mesh();
  const auto place = [&](const MeshEdge& e) { return 0.5 * (mesh.point(e[0]) + mesh.point(e[1])); };
  std::size_t n_due = 0;
  for (const auto& [edge, faces] : faces_at_edges(checked)) {
    const auto due = curve_at(checked, faces);
    const auto at = given.find(edge);
    n_due += due ? 1 : 0;
    if (due && (at == given.end() || !at->second.contains(*due))) missing.add(n_due, place(edge));
    if (at == given.end()) continue;
    if (at->second.size() > (due ? 1u : 0u)) wrong.add(n_due, place(edge));
    given.erase(at);
  }
  for (const auto& [edge, names] : given)
    if (edge[1] != no_vertex) wrong.add(0, place(edge));
  missing.report(result, "edges where surfaces meet or end are in no curve of the name that is due there");
  wrong.report(result,
               "edges lie on a curve of surfaces although these neither meet nor end there, or under a second name");
  result.checks_done.push_back("curves of surfaces are the " + std::to_string(n_due) +
                               " edges where faces of the set meet or end, under the names due");
}

}  // namespace geomesh::geomodel::checking
