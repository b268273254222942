// SPDX-License-Identifier: MIT
/// Converts a mesh of the canonical form to a mesh of the model as the caller gave it.
#include <algorithm>
#include <memory>
#include <numeric>
#include <utility>

#include "tetrahedralize/canonical_form.hpp"

namespace geomesh {

namespace {

class Translator {
 public:
  Translator(ConstrainedTetrahedralization& mesh, const ModelNames& names, const PiecewiseLinearComplex& plc)
      : mesh_(mesh), names_(names), plc_(plc) {}

  void run() {
    number_points();
    for (Tetrahedron& t : mesh_.tetrahedra) {
      for (VertexIndex& v : t) v = row_[v];
      if (names_.frame.mirrors()) std::swap(t[2], t[3]);
    }
    translate_faces();
    number_components();
    translate_edges();
    list_isolated_points();
    mesh_.recovery.facets_not_recovered =
        facets_in_callers_terms(std::move(mesh_.recovery.facets_not_recovered), names_);
  }

 private:
  /// Numbers the vertices of the input in the order of the input, followed by the added points.
  void number_points() {
    const auto n = static_cast<VertexIndex>(mesh_.points.size());
    row_of_input_.assign(plc_.points.size(), no_vertex);
    for (VertexIndex v = 0; v < n; ++v)
      if (mesh_.input_vertex[v] != no_vertex) row_of_input_[names_.vertex[mesh_.input_vertex[v]]] = v;
    std::vector<VertexIndex> order;
    order.reserve(n);
    for (VertexIndex& row : row_of_input_) {
      if (row == no_vertex) continue;
      order.push_back(row);
      row = static_cast<VertexIndex>(order.size() - 1);
    }
    for (VertexIndex v = 0; v < n; ++v)
      if (mesh_.input_vertex[v] == no_vertex) order.push_back(v);
    row_.resize(n);
    std::vector<Vec3> points(n);
    std::vector<VertexIndex> input_vertex(n);
    std::vector<VertexOrigin> origin(n);
    for (VertexIndex row = 0; row < n; ++row) {
      const VertexIndex v = order[row], named = mesh_.input_vertex[v];
      row_[v] = row;
      input_vertex[row] = named == no_vertex ? no_vertex : names_.vertex[named];
      points[row] = named == no_vertex ? names_.frame.leave(mesh_.points[v]) : plc_.points[input_vertex[row]];
      origin[row] = mesh_.origin[v];
    }
    mesh_.points = std::move(points);
    mesh_.input_vertex = std::move(input_vertex);
    mesh_.origin = std::move(origin);
  }

  void translate_faces() {
    std::vector<Index> next(plc_.n_facets() + 1, 0);
    for (auto& face : mesh_.faces) {
      for (VertexIndex& v : face.vertices) v = row_[v];
      if (names_.facet_is_reversed[face.facet]) std::swap(face.vertices[1], face.vertices[2]);
      if (names_.swaps_sides(face.facet)) std::swap(face.tetrahedron_below, face.tetrahedron_above);
      face.facet = names_.facet[face.facet];
      ++next[face.facet + 1];
    }
    std::partial_sum(next.begin(), next.end(), next.begin());
    std::vector<ConstrainedTetrahedralization::Face> faces(mesh_.faces.size());
    for (const auto& face : mesh_.faces) faces[next[face.facet]++] = face;
    mesh_.faces = std::move(faces);
  }

  /// Numbers components in the order of the first facet that touches them. The component on the lower side of a facet
  /// comes before the one on its upper side.
  void number_components() {
    std::vector<Index> number(mesh_.n_components, no_index);
    Index next = 0;
    for (const auto& face : mesh_.faces)
      for (const Index t : {face.tetrahedron_below, face.tetrahedron_above})
        if (t != no_index && number[mesh_.component[t]] == no_index) number[mesh_.component[t]] = next++;
    for (Index& c : mesh_.component) c = number[c];
    std::vector<Index> seeds(mesh_.component_seed.size());
    for (Index c = 0; c < seeds.size(); ++c) seeds[number[c]] = mesh_.component_seed[c];
    mesh_.component_seed = std::move(seeds);
  }

  void translate_edges() {
    for (auto& edge : mesh_.edges) {
      if (names_.segment_is_reversed[edge.segment]) std::swap(edge.a, edge.b);
      edge = {row_[edge.a], row_[edge.b], names_.segment[edge.segment]};
    }
    std::stable_sort(mesh_.edges.begin(), mesh_.edges.end(),
                     [](const auto& a, const auto& b) { return a.segment < b.segment; });
  }

  void list_isolated_points() {
    mesh_.isolated_points.clear();
    for (const VertexIndex v : plc_.isolated_points)
      if (row_of_input_[v] != no_vertex) mesh_.isolated_points.push_back(row_of_input_[v]);
  }

  ConstrainedTetrahedralization& mesh_;
  const ModelNames& names_;
  const PiecewiseLinearComplex& plc_;
  std::vector<VertexIndex> row_;           ///< row in the returned mesh of each point of the mesh of the canonical form
  std::vector<VertexIndex> row_of_input_;  ///< row in the mesh of each point of the complex
};

std::shared_ptr<const MeshExcerpt> excerpt_in_callers_terms(const std::shared_ptr<const MeshExcerpt>& excerpt,
                                                            const ModelNames& names) {
  if (!excerpt) return excerpt;
  auto out = std::make_shared<MeshExcerpt>(*excerpt);
  for (Vec3& p : out->points) p = names.frame.leave(p);
  if (names.frame.mirrors())
    for (Tetrahedron& t : out->tetrahedra) std::swap(t[2], t[3]);
  for (std::size_t i = 0; i < out->triangles.size(); ++i) {
    if (names.facet_is_reversed[out->facet[i]]) std::swap(out->triangles[i][1], out->triangles[i][2]);
    out->facet[i] = names.facet[out->facet[i]];
  }
  return out;
}

}  // namespace

ConstrainedTetrahedralization in_callers_terms(ConstrainedTetrahedralization mesh, const ModelNames& names,
                                               const PiecewiseLinearComplex& plc) {
  Translator(mesh, names, plc).run();
  return mesh;
}

std::vector<Index> facets_in_callers_terms(std::vector<Index> facets, const ModelNames& names) {
  for (Index& f : facets) f = names.facet[f];
  std::sort(facets.begin(), facets.end());
  return facets;
}

Error in_callers_terms(const Error& error, const ModelNames& names) {
  ErrorContext context = error.context();
  for (Index& f : context.facets) f = names.facet[f];
  for (Index& s : context.segments) s = names.segment[s];
  for (VertexIndex& v : context.vertices) v = names.vertex[v];
  for (Vec3& p : context.places) p = names.frame.leave(p);
  context.excerpt = excerpt_in_callers_terms(context.excerpt, names);
  return Error(error.kind(), error.what(), std::move(context));
}

}  // namespace geomesh
