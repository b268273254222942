// SPDX-License-Identifier: MIT
#include "refine/mesh_anew.hpp"

#include <algorithm>
#include <map>
#include <numeric>

#include "geomesh/core/error.hpp"

namespace geomesh::remesh {

namespace {

/// Which component of `mesh` each component of `fresh` is, told by a facet and its side; no_index: none. Nothing where facets disagree.
std::optional<std::vector<Index>> match_components(const ConstrainedTetrahedralization& mesh, const std::vector<Index>& row_of_facet,
                                                   const ConstrainedTetrahedralization& fresh) {
  std::map<std::pair<Index, bool>, Index> side;
  std::vector<Index> match(fresh.n_components, no_index);
  const auto for_each_side = [](const ConstrainedTetrahedralization& m, const auto& visit) {
    for (const auto& f : m.faces)
      for (const bool above : {false, true})
        if (const Index t = above ? f.tetrahedron_above : f.tetrahedron_below; t != no_index)
          if (!visit(f.facet, above, m.component[t])) return false;
    return true;
  };
  if (!for_each_side(mesh, [&](Index facet, bool above, Index c) {
        return side.try_emplace({row_of_facet[facet], above}, c).first->second == c;
      }))
    return std::nullopt;
  const bool agrees = for_each_side(fresh, [&](Index row, bool above, Index c) {
    const auto at = side.find({row, above});
    if (at == side.end()) return true;
    if (match[c] == no_index) match[c] = at->second;
    return match[c] == at->second;
  });
  return agrees ? std::optional(match) : std::nullopt;
}

/// A point well inside each component that has no match.
void seed_holes(const ConstrainedTetrahedralization& fresh, const std::vector<Index>& match, PiecewiseLinearComplex& plc) {
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

/// No component of `mesh` is missing, and none is told twice.
bool is_complete(std::vector<Index> match, std::size_t n_components) {
  std::sort(match.begin(), match.end());
  std::vector<Index> all(n_components);
  std::iota(all.begin(), all.end(), Index{0});
  return match == all;
}

/// The faces of a mesh as facets, the edges as segments (both in their order), the points on neither as isolated ones.
PiecewiseLinearComplex complex_of(const ConstrainedTetrahedralization& mesh) {
  PiecewiseLinearComplex plc;
  plc.points = mesh.points;
  std::vector<bool> is_used(mesh.points.size(), false);
  for (const auto& f : mesh.faces) {
    plc.add_triangle(f.vertices);
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

}  // namespace

std::optional<ConstrainedTetrahedralization> tetrahedralize_as(const ConstrainedTetrahedralization& mesh, const std::vector<Index>& row_of_facet,
                                                               PiecewiseLinearComplex plc, const RunContext& context) {
  RunContext quiet;
  quiet.cancel = context.cancel;
  quiet.threads = context.threads;
  quiet.log = [&context](LogLevel level, std::string_view text) {
    if (level == LogLevel::debug) context.note(level, text);
  };
  TetrahedralizeOptions options;
  options.recover.max_attempts = 8;  // the caller has another way
  try {
    ConstrainedTetrahedralization fresh = tetrahedralize(plc, options, quiet);
    auto match = match_components(mesh, row_of_facet, fresh);
    if (match && std::find(match->begin(), match->end(), no_index) != match->end()) {
      seed_holes(fresh, *match, plc);
      fresh = tetrahedralize(plc, options, quiet);
      match = match_components(mesh, row_of_facet, fresh);
    }
    if (!match || !is_complete(*match, mesh.n_components)) return std::nullopt;
    for (Index& c : fresh.component) c = (*match)[c];
    fresh.n_components = mesh.n_components;
    fresh.component_seed = mesh.component_seed;
    fresh.recovery = mesh.recovery;
    fresh.delaunay_statistics = mesh.delaunay_statistics;
    return fresh;
  } catch (const Error& e) {
    if (e.kind() == ErrorKind::interrupted) throw;
    context.note(LogLevel::debug, std::string("not meshed anew: ") + e.what());
    return std::nullopt;
  }
}

std::optional<ConstrainedTetrahedralization> mesh_anew(const ConstrainedTetrahedralization& mesh, const RunContext& context) {
  ConstrainedTetrahedralization by_face = mesh;
  for (Index f = 0; f < by_face.faces.size(); ++f) by_face.faces[f].facet = f;
  std::vector<Index> rows(mesh.faces.size());
  std::iota(rows.begin(), rows.end(), Index{0});
  auto fresh = tetrahedralize_as(by_face, rows, complex_of(mesh), context);
  if (!fresh) return std::nullopt;
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
  return fresh;
}

}  // namespace geomesh::remesh
