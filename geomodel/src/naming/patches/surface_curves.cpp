// SPDX-License-Identifier: GPL-3.0-or-later
#include "naming/patches/surface_curves.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "common/edge_uses.hpp"
#include "common/union_find.hpp"

namespace geomesh::geomodel {

namespace {

constexpr auto well_kind = "well";

std::string joined_names(const std::vector<Index>& rows, const std::vector<TriangulatedSurface>& surfaces) {
  std::vector<std::string> names;
  for (Index row : rows) names.push_back(surfaces[row].name);
  if (names.size() == 1) names.push_back(names.front());
  std::sort(names.begin(), names.end());
  std::string joined = names.front();
  for (std::size_t i = 1; i < names.size(); ++i) joined += "*" + names[i];
  return joined;
}

bool is_before(const SoupCurve& p, const SoupCurve& q) {
  if ((p.kind == well_kind) != (q.kind == well_kind)) return q.kind == well_kind;
  return p.kind != well_kind && std::pair(p.kind, p.name) < std::pair(q.kind, q.name);
}

/// What the faces of a model say of its edges.
class FaceEdges {
 public:
  FaceEdges(const std::vector<TriangulatedSurface>& surfaces, const ModelMesh& model)
      : surfaces_(surfaces), model_(model) {
    std::vector<Triangle> triangles;
    triangles.reserve(model.faces.size());
    for (const ModelMesh::Face& face : model.faces) triangles.push_back(face.vertices);
    uses_ = sorted_edge_uses(triangles);
  }

  const std::vector<EdgeUse>& uses() const { return uses_; }

  bool inside_patch(std::span<const EdgeUse> edge) const {
    return edge.size() == 2 && set_of(edge[0]) == set_of(edge[1]);
  }

  /// The curve that is due at an edge; nothing inside a patch.
  const SoupCurve* due_at(std::span<const EdgeUse> edge) {
    if (inside_patch(edge)) return nullptr;
    rows_.clear();
    for (const EdgeUse& use : edge)
      for (const std::int32_t id : model_.surface_sets[static_cast<std::size_t>(set_of(use))])
        rows_.push_back(static_cast<Index>(id - model_.surfaces.front().id));
    std::sort(rows_.begin(), rows_.end());
    rows_.erase(std::unique(rows_.begin(), rows_.end()), rows_.end());
    const auto [at, is_new] = names_.try_emplace({edge.size() == 1, rows_});
    if (is_new) at->second = curve_of(rows_, edge.size(), surfaces_);
    return &at->second;
  }

 private:
  std::int32_t set_of(const EdgeUse& use) const { return model_.faces[use.facet].surface_set; }

  const std::vector<TriangulatedSurface>& surfaces_;
  const ModelMesh& model_;
  std::vector<EdgeUse> uses_;
  std::vector<Index> rows_;
  std::map<std::pair<bool, std::vector<Index>>, SoupCurve> names_;  ///< by whether one face is there, and surfaces
};

/// Edges that lie on other curves than their faces say.
struct Corrections {
  std::vector<std::size_t> gone;  ///< rows of MeshCurves::edges
  struct Due {
    VertexIndex a, b;
    SoupCurve curve;
  };
  std::vector<Due> due;
  bool empty() const { return gone.empty() && due.empty(); }
};

/// Rows of edges on curves of surfaces, sorted by their ends.
std::vector<EdgeUse> edges_of_surfaces(const MeshCurves& curves) {
  std::vector<EdgeUse> rows;
  for (Index e = 0; e < curves.edges.size(); ++e)
    if (const auto& [a, b, curve] = curves.edges[e]; curves.curves[curve].kind != well_kind)
      rows.push_back({std::min(a, b), std::max(a, b), e});
  std::sort(rows.begin(), rows.end(), [](const EdgeUse& p, const EdgeUse& q) {
    return std::tie(p.a, p.b, p.facet) < std::tie(q.a, q.b, q.facet);
  });
  return rows;
}

Corrections find_corrections(FaceEdges& edges, const MeshCurves& curves) {
  Corrections found;
  const std::vector<EdgeUse> given = edges_of_surfaces(curves);
  auto at = given.begin();
  for_each_edge(edges.uses(), [&](std::span<const EdgeUse> edge) {
    const auto key = std::pair(edge[0].a, edge[0].b);
    while (at != given.end() && std::pair(at->a, at->b) < key) ++at;
    const SoupCurve* due = edges.due_at(edge);
    bool is_there = false;
    for (; at != given.end() && std::pair(at->a, at->b) == key; ++at) {
      const SoupCurve& is = curves.curves[curves.edges[at->facet].curve];
      if (due && !is_there && is.kind == due->kind && is.name == due->name)
        is_there = true;
      else
        found.gone.push_back(at->facet);
    }
    if (due && !is_there) found.due.push_back({key.first, key.second, *due});
  });
  return found;
}

/// Adds the curves of `due` that are not there yet, each at its place in the order.
void add_curves(const std::vector<Corrections::Due>& due, MeshCurves& curves) {
  std::vector<SoupCurve> all = curves.curves;
  for (const Corrections::Due& d : due) {
    const auto place = std::lower_bound(all.begin(), all.end(), d.curve, is_before);
    if (place == all.end() || is_before(d.curve, *place)) all.insert(place, d.curve);
  }
  std::vector<Index> row;
  for (std::size_t c = 0, k = 0; c < curves.curves.size(); ++c, ++k) {
    while (all[k].kind != curves.curves[c].kind || all[k].name != curves.curves[c].name) ++k;
    row.push_back(static_cast<Index>(k));
  }
  for (MeshCurves::Edge& e : curves.edges) e.curve = row[e.curve];
  curves.curves = std::move(all);
}

void correct_curves(const Corrections& corrections, MeshCurves& curves) {
  add_curves(corrections.due, curves);
  std::vector<bool> is_gone(curves.edges.size(), false);
  for (const std::size_t e : corrections.gone) is_gone[e] = true;
  std::vector<MeshCurves::Edge> kept;
  for (std::size_t e = 0; e < curves.edges.size(); ++e)
    if (!is_gone[e]) kept.push_back(curves.edges[e]);
  for (const auto& [a, b, curve] : corrections.due) {
    const auto place = std::lower_bound(curves.curves.begin(), curves.curves.end(), curve, is_before);
    kept.push_back({a, b, static_cast<Index>(place - curves.curves.begin())});
  }
  curves.edges = std::move(kept);
}

/// Patches numbered from 1 in the order of their first face.
void number_patches(const FaceEdges& edges, ModelMesh& model) {
  UnionFind joined(model.faces.size());
  for_each_edge(edges.uses(), [&](std::span<const EdgeUse> edge) {
    if (edges.inside_patch(edge)) joined.unite(edge[0].facet, edge[1].facet);
  });
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

void correct_by_faces(const std::vector<TriangulatedSurface>& surfaces, ModelMesh& model, MeshCurves& curves) {
  FaceEdges edges(surfaces, model);
  const Corrections corrections = find_corrections(edges, curves);
  if (corrections.empty()) return;
  correct_curves(corrections, curves);
  number_patches(edges, model);
}

}  // namespace geomesh::geomodel
