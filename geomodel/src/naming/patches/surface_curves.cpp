// SPDX-License-Identifier: GPL-3.0-or-later
#include "naming/patches/surface_curves.hpp"

#include <algorithm>
#include <map>
#include <span>
#include <utility>

#include "common/edge_uses.hpp"
#include "common/union_find.hpp"

namespace geomesh::geomodel {

namespace {

std::string joined_names(const std::vector<Index>& rows, const std::vector<TriangulatedSurface>& surfaces) {
  std::vector<std::string> names;
  for (Index row : rows) names.push_back(surfaces[row].name);
  if (names.size() == 1) names.push_back(names.front());
  std::sort(names.begin(), names.end());
  std::string joined = names.front();
  for (std::size_t i = 1; i < names.size(); ++i) joined += "*" + names[i];
  return joined;
}

std::vector<Index> surfaces_at(std::span<const EdgeUse> edge, const ModelMesh& model) {
  std::vector<Index> rows;
  for (const EdgeUse& use : edge)
    for (const std::int32_t id : model.surface_sets[static_cast<std::size_t>(model.faces[use.facet].surface_set)])
      rows.push_back(static_cast<Index>(id - model.surfaces.front().id));
  std::sort(rows.begin(), rows.end());
  rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
  return rows;
}

/// Groups edges into curves by what determines the name: the surfaces at the edge, and whether it has only one face.
class CurveTable {
 public:
  explicit CurveTable(const std::vector<TriangulatedSurface>& surfaces) : surfaces_(surfaces) {}

  void add(std::span<const EdgeUse> edge, std::vector<Index> rows) {
    const std::size_t n_faces = edge.size();
    const auto [at, is_new] = keys_.try_emplace({n_faces == 1, std::move(rows)});
    if (is_new) {
      const SoupCurve curve = curve_of(at->first.second, n_faces, surfaces_);
      at->second = curves_.try_emplace({curve.kind, curve.name}, no_index).first;
    }
    edges_.push_back({edge[0].a, edge[0].b, at->second});
  }

  MeshCurves result() && {
    MeshCurves out;
    for (auto& [key, row] : curves_) {
      row = static_cast<Index>(out.curves.size());
      out.curves.push_back({key.second, key.first});
    }
    for (const auto& [a, b, curve] : edges_) out.edges.push_back({a, b, curve->second});
    return out;
  }

 private:
  using Curves = std::map<std::pair<std::string, std::string>, Index>;
  struct Edge {
    VertexIndex a, b;
    Curves::const_iterator curve;
  };
  const std::vector<TriangulatedSurface>& surfaces_;
  std::map<std::pair<bool, std::vector<Index>>, Curves::const_iterator> keys_;
  Curves curves_;
  std::vector<Edge> edges_;
};

void number_patches(UnionFind& joined, ModelMesh& model) {
  std::int32_t n_patches = 0;
  for (Index f = 0; f < model.faces.size(); ++f) {
    const Index first = joined.find(f);
    model.faces[f].patch = first == f ? ++n_patches : model.faces[first].patch;
  }
}

}  // namespace

SoupCurve curve_of(const std::vector<Index>& rows, std::size_t n_facets,
                   const std::vector<TriangulatedSurface>& surfaces) {
  if (rows.size() > 1 || n_facets > 1) return {joined_names(rows, surfaces), "intersection"};
  const TriangulatedSurface& surface = surfaces[rows.front()];
  if (surface.kind == SurfaceKind::fault) return {surface.name + ".tip", "fault_tip"};
  return {surface.name + ".border", "border"};
}

MeshCurves tell_curves_and_patches(const std::vector<TriangulatedSurface>& surfaces, ModelMesh& model) {
  CurveTable curves(surfaces);
  UnionFind joined(model.faces.size());
  for_each_edge(sorted_edge_uses(model.faces), [&](std::span<const EdgeUse> edge) {
    const Index first = edge.front().facet, last = edge.back().facet;
    if (edge.size() == 2 && model.faces[first].surface_set == model.faces[last].surface_set)
      joined.unite(first, last);
    else
      curves.add(edge, surfaces_at(edge, model));
  });
  number_patches(joined, model);
  return std::move(curves).result();
}

}  // namespace geomesh::geomodel
