// SPDX-License-Identifier: GPL-3.0-or-later
#include "fault_zones/relabel.hpp"

#include <algorithm>
#include <map>
#include <string>

#include "common/union_find.hpp"
#include "naming/sums.hpp"

namespace geomesh::geomodel {

namespace {

std::pair<VertexIndex, VertexIndex> edge(VertexIndex a, VertexIndex b) { return {std::min(a, b), std::max(a, b)}; }

std::map<std::pair<VertexIndex, VertexIndex>, std::vector<Index>> faces_at(const ModelMesh& mesh,
                                                                           const EdgeSet* edges) {
  std::map<std::pair<VertexIndex, VertexIndex>, std::vector<Index>> at;
  for (Index f = 0; f < mesh.faces.size(); ++f)
    for (std::size_t i = 0; i < 3; ++i) {
      const auto e = edge(mesh.faces[f].vertices[i], mesh.faces[f].vertices[(i + 1) % 3]);
      if (!edges || edges->contains(e)) at[e].push_back(f);
    }
  return at;
}

}  // namespace

void renumber_ids(ModelMesh& mesh) {
  std::map<std::int32_t, std::int32_t> now;  // new id of each surface, curve, point and set, by old id
  auto next = static_cast<std::int32_t>(mesh.regions.size());
  for (NamedSurface& s : mesh.surfaces) s.id = now[s.id] = ++next;
  for (NamedCurve& c : mesh.curves) c.id = now[c.id] = ++next;
  for (auto& p : mesh.marked_points) p.id = now[p.id] = ++next;
  for (NodeSet& n : mesh.node_sets) n.id = now[n.id] = ++next;
  for (auto& set : mesh.surface_sets) {
    for (std::int32_t& id : set) id = now[id];
    std::sort(set.begin(), set.end());
  }
  for (auto& face : mesh.faces) face.surface = mesh.surface_sets[static_cast<std::size_t>(face.surface_set)].front();
  for (auto& e : mesh.curve_edges) e.curve = now[e.curve];
}

void number_patches(ModelMesh& mesh) {
  UnionFind patches(mesh.faces.size());
  for (const auto& [e, faces] : faces_at(mesh, nullptr))
    if (faces.size() == 2 && mesh.faces[faces[0]].surface_set == mesh.faces[faces[1]].surface_set)
      patches.unite(faces[0], faces[1]);
  std::map<Index, std::int32_t> number;
  for (Index f = 0; f < mesh.faces.size(); ++f)
    mesh.faces[f].patch =
        number.try_emplace(patches.find(f), static_cast<std::int32_t>(number.size() + 1)).first->second;
}

void name_intersections(ModelMesh& mesh, const EdgeSet& edges) {
  std::map<std::int32_t, std::string> name_of;
  for (const NamedSurface& s : mesh.surfaces) name_of[s.id] = s.name;
  std::map<std::int32_t, std::string> kind_of;
  std::map<std::string, std::int32_t> curve_of;
  std::int32_t next = 0;
  for (const NamedSurface& s : mesh.surfaces) next = std::max(next, s.id);
  for (const auto& p : mesh.marked_points) next = std::max(next, p.id);
  for (const NodeSet& n : mesh.node_sets) next = std::max(next, n.id);
  for (const NamedCurve& c : mesh.curves) {
    next = std::max(next, c.id);
    kind_of[c.id] = c.kind;
    if (c.kind == "intersection") curve_of.try_emplace(c.name, c.id);
  }
  EdgeSet tips;
  std::erase_if(mesh.curve_edges, [&](const ModelMesh::CurveEdge& e) {
    const bool is_here = edges.contains(edge(e.a, e.b));
    if (is_here && (kind_of[e.curve] == "fault_tip" || kind_of[e.curve] == "border")) tips.insert(edge(e.a, e.b));
    return is_here && kind_of[e.curve] == "intersection";
  });
  for (const auto& [e, faces] : faces_at(mesh, &edges)) {
    if (tips.contains(e)) continue;
    std::multiset<std::string> names;
    std::set<std::int32_t> ids;
    for (const Index f : faces)
      for (const std::int32_t id : mesh.surface_sets[static_cast<std::size_t>(mesh.faces[f].surface_set)])
        if (ids.insert(id).second) names.insert(name_of[id]);
    const bool is_inside = faces.size() == 2 && mesh.faces[faces[0]].surface_set == mesh.faces[faces[1]].surface_set;
    if (is_inside || (names.size() == 1 && faces.size() == 1)) continue;
    if (names.size() == 1) names.insert(*names.begin());  // it meets itself
    std::string joined;
    for (const std::string& name : names) joined += (joined.empty() ? "" : "*") + name;
    const auto [curve, is_new] = curve_of.try_emplace(joined, next + 1);
    if (is_new) mesh.curves.push_back({++next, joined, "intersection"});
    mesh.curve_edges.push_back({e.first, e.second, curve->second});
  }
  std::set<std::int32_t> used;
  for (const auto& e : mesh.curve_edges) used.insert(e.curve);
  std::erase_if(mesh.curves, [&](const NamedCurve& c) { return !used.contains(c.id); });
}

void measure_again(ModelMesh& mesh) {
  std::vector<CompensatedSum> volumes(mesh.regions.size());
  for (Region& region : mesh.regions) region.n_tetrahedra = 0;
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t) {
    const Tetrahedron& v = mesh.tetrahedra[t];
    const auto region = static_cast<std::size_t>(mesh.tet_region[t] - 1);
    volumes[region].add(signed_volume(mesh.points[v[0]], mesh.points[v[1]], mesh.points[v[2]], mesh.points[v[3]]));
    ++mesh.regions[region].n_tetrahedra;
  }
  for (std::size_t r = 0; r < volumes.size(); ++r) mesh.regions[r].volume = volumes[r].value();
  std::map<std::int32_t, CompensatedSum> areas, lengths;
  for (const auto& face : mesh.faces)
    for (const std::int32_t id : mesh.surface_sets[static_cast<std::size_t>(face.surface_set)])
      areas[id].add(
          triangle_area(mesh.points[face.vertices[0]], mesh.points[face.vertices[1]], mesh.points[face.vertices[2]]));
  for (NamedSurface& s : mesh.surfaces) s.area = areas[s.id].value();
  for (const auto& e : mesh.curve_edges) lengths[e.curve].add(norm(mesh.points[e.b] - mesh.points[e.a]));
  for (NamedCurve& c : mesh.curves) c.length = lengths[c.id].value();
}

}  // namespace geomesh::geomodel
