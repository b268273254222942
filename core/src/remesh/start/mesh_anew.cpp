// SPDX-License-Identifier: MIT
#include "remesh/start/mesh_anew.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "geomesh/core/error.hpp"

namespace geomesh::remesh {

namespace {

/// For each facet of a complex, the component below and above it; no_index if unknown.
using ComponentsBeside = std::vector<std::array<Index, 2>>;

/// Calls visit(face, above, component) for each side of each face that has a tetrahedron, until a call returns false.
/// Returns whether all calls returned true.
template <class Visit>
bool for_each_side(const ConstrainedTetrahedralization& mesh, const Visit& visit) {
  for (Index f = 0; f < mesh.faces.size(); ++f)
    for (const bool above : {false, true})
      if (const Index t = above ? mesh.faces[f].tetrahedron_above : mesh.faces[f].tetrahedron_below; t != no_index)
        if (!visit(f, above, mesh.component[t])) return false;
  return true;
}

/// Returns the components on both sides of each facet of a complex, or nothing if faces of one facet disagree. `row_of`
/// returns the facet of which a face of the mesh is part.
template <class RowOf>
std::optional<ComponentsBeside> components_beside(const ConstrainedTetrahedralization& mesh, std::size_t n_facets,
                                                  const RowOf& row_of) {
  ComponentsBeside beside(n_facets, {no_index, no_index});
  const bool agrees = for_each_side(mesh, [&](Index f, bool above, Index c) {
    Index& known = beside[row_of(f)][above];
    if (known == no_index) known = c;
    return known == c;
  });
  return agrees ? std::optional(std::move(beside)) : std::nullopt;
}

/// Returns for each component of the new mesh the known component on the same side of the same facet, or no_index if
/// there is none. Returns nothing if facets disagree.
std::optional<std::vector<Index>> match_components(const ComponentsBeside& beside,
                                                   const ConstrainedTetrahedralization& fresh) {
  std::vector<Index> match(fresh.n_components, no_index);
  const bool agrees = for_each_side(fresh, [&](Index f, bool above, Index c) {
    const Index known = beside[fresh.faces[f].facet][above];
    if (known != no_index && match[c] == no_index) match[c] = known;
    return known == no_index || match[c] == known;
  });
  return agrees ? std::optional(std::move(match)) : std::nullopt;
}

/// Adds a hole seed well inside each component of the new mesh that the previous mesh does not have.
void seed_holes(const ConstrainedTetrahedralization& fresh, const std::vector<Index>& match,
                PiecewiseLinearComplex& plc) {
  std::vector<double> largest(fresh.n_components, 0);
  std::vector<Vec3> place(fresh.n_components);
  for (std::size_t t = 0; t < fresh.tetrahedra.size(); ++t) {
    const Tetrahedron& v = fresh.tetrahedra[t];
    const Vec3 &a = fresh.points[v[0]], &b = fresh.points[v[1]], &c = fresh.points[v[2]], &d = fresh.points[v[3]];
    const double volume = dot(cross(b - a, c - a), d - a);
    if (volume <= largest[fresh.component[t]]) continue;
    largest[fresh.component[t]] = volume;
    place[fresh.component[t]] = 0.25 * ((a + b) + (c + d));
  }
  for (Index c = 0; c < fresh.n_components; ++c)
    if (match[c] == no_index) plc.hole_seeds.push_back({place[c], no_index});
}

/// Returns whether `match` contains each component exactly once.
bool is_complete(std::vector<Index> match, std::size_t n_components) {
  std::sort(match.begin(), match.end());
  std::vector<Index> all(n_components);
  std::iota(all.begin(), all.end(), Index{0});
  return match == all;
}

/// Makes a complex of a mesh: faces become facets and edges segments, in their order; other points are isolated ones.
PiecewiseLinearComplex complex_of(const ConstrainedTetrahedralization& mesh) {
  PiecewiseLinearComplex plc;
  plc.points = mesh.points;
  std::vector<bool> is_used(mesh.points.size(), false);
  for (Index row = 0; row < mesh.faces.size(); ++row) {
    const auto& f = mesh.faces[row];
    plc.add_triangle(f.vertices, row);  // Each face is a surface of its own, so coplanar faces are not merged.
    for (const VertexIndex v : f.vertices) is_used[v] = true;
  }
  for (const auto& e : mesh.edges) {
    plc.segments.push_back({e.a, e.b});
    is_used[e.a] = is_used[e.b] = true;
  }
  for (VertexIndex v = 0; v < mesh.points.size(); ++v)
    if (!is_used[v]) plc.isolated_points.push_back(v);
  return plc;
}

/// Meshes a complex and identifies its components by the facets beside them. Returns nothing if it cannot be meshed or
/// its components cannot be identified.
std::optional<ConstrainedTetrahedralization> tetrahedralize_beside(const ComponentsBeside& beside,
                                                                   std::size_t n_components, PiecewiseLinearComplex plc,
                                                                   unsigned most_attempts, const RunContext& context,
                                                                   ErrorContext* trouble) {
  RunContext quiet;
  quiet.cancel = context.cancel;
  quiet.threads = context.threads;
  quiet.log = [&context](LogLevel level, std::string_view text) {
    if (level == LogLevel::debug) context.note(level, text);
  };
  TetrahedralizeOptions options;
  options.recover.max_attempts = most_attempts;
  try {
    ConstrainedTetrahedralization fresh = tetrahedralize(plc, options, quiet);
    auto match = match_components(beside, fresh);
    if (match && std::find(match->begin(), match->end(), no_index) != match->end()) {
      seed_holes(fresh, *match, plc);
      fresh = {};  // frees the mesh before its complex is meshed again with hole seeds
      fresh = tetrahedralize(plc, options, quiet);
      match = match_components(beside, fresh);
    }
    if (!match || !is_complete(*match, n_components)) {
      context.note(LogLevel::debug, "not meshed anew: its components cannot be identified");
      return std::nullopt;
    }
    for (Index& c : fresh.component) c = (*match)[c];
    return fresh;
  } catch (const Error& e) {
    if (e.kind() == ErrorKind::interrupted) throw;
    context.note(LogLevel::debug, std::string("not meshed anew: ") + e.what());
    if (trouble) *trouble = e.context();
    return std::nullopt;
  }
}

/// Copies number and seeds of components, and the statistics of recovery and Delaunay insertion, from `mesh`.
void inherit(const ConstrainedTetrahedralization& mesh, ConstrainedTetrahedralization& fresh) {
  fresh.n_components = mesh.n_components;
  fresh.component_seed = mesh.component_seed;
  fresh.recovery = mesh.recovery;
  fresh.delaunay_statistics = mesh.delaunay_statistics;
}

}  // namespace

std::optional<ConstrainedTetrahedralization> tetrahedralize_as(const ConstrainedTetrahedralization& mesh,
                                                               const std::vector<Index>& row_of_facet,
                                                               PiecewiseLinearComplex plc, const RunContext& context,
                                                               ErrorContext* trouble) {
  const auto beside =
      components_beside(mesh, plc.n_facets(), [&](Index f) { return row_of_facet[mesh.faces[f].facet]; });
  if (!beside) return std::nullopt;
  // after so many failed attempts at recovery, the caller tries again with fewer added points
  constexpr unsigned most_attempts = 2;
  auto fresh = tetrahedralize_beside(*beside, mesh.n_components, std::move(plc), most_attempts, context, trouble);
  if (fresh) inherit(mesh, *fresh);
  return fresh;
}

bool mesh_anew(ConstrainedTetrahedralization& mesh, const RunContext& context) {
  const auto beside = components_beside(mesh, mesh.faces.size(), [](Index f) { return f; });
  // Recovery of facets is attempted only once, because the caller keeps the old mesh if it fails. A further attempt
  // would represent added points exactly, which takes minutes beside a needle that is a rounding error wide.
  constexpr unsigned most_attempts = 1;
  auto fresh = tetrahedralize_beside(*beside, mesh.n_components, complex_of(mesh), most_attempts, context, nullptr);
  if (!fresh) return false;
  inherit(mesh, *fresh);
  for (auto& f : fresh->faces) f.facet = mesh.faces[f.facet].facet;
  for (auto& e : fresh->edges) e.segment = mesh.edges[e.segment].segment;
  std::vector<VertexIndex> row_in_fresh(mesh.points.size(), no_vertex);
  for (VertexIndex v = 0; v < fresh->points.size(); ++v) {
    const VertexIndex row = fresh->input_vertex[v];
    if (row == no_vertex) continue;
    row_in_fresh[row] = v;
    fresh->input_vertex[v] = mesh.input_vertex[row];
    fresh->origin[v] = mesh.origin[row];
  }
  fresh->isolated_points.clear();
  for (const VertexIndex v : mesh.isolated_points) fresh->isolated_points.push_back(row_in_fresh[v]);
  mesh = std::move(*fresh);
  return true;
}

}  // namespace geomesh::remesh
