// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver_mesh/pieces.hpp"

#include <algorithm>
#include <map>
#include <tuple>

namespace geomesh::geomodel {

namespace {

std::vector<FacePiece> face_pieces(const ModelMesh& mesh, std::int32_t& next_id) {
  std::map<std::tuple<std::int32_t, std::int32_t, std::int32_t>, std::vector<std::size_t>> pieces;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const ModelMesh::Face& face = mesh.faces[f];
    pieces[{face.surface_set, face.region_minus, face.region_plus}].push_back(f);
  }
  std::map<std::int32_t, std::string> region_names{{0, "outside"}}, surface_names;
  for (const Region& r : mesh.regions) region_names[r.id] = r.name;
  for (const NamedSurface& s : mesh.surfaces) surface_names[s.id] = s.name;
  std::map<std::int32_t, std::size_t> n_pieces;  // by surface
  for (const auto& [key, faces] : pieces)
    for (std::int32_t id : mesh.surface_sets[static_cast<std::size_t>(std::get<0>(key))]) ++n_pieces[id];
  std::vector<FacePiece> result;
  for (auto& [key, faces] : pieces) {
    const auto& set = mesh.surface_sets[static_cast<std::size_t>(std::get<0>(key))];
    FacePiece piece{0, std::get<0>(key), std::get<1>(key), std::get<2>(key), "", std::move(faces)};
    const bool whole = set.size() == 1 && n_pieces[set.front()] == 1;
    for (std::int32_t id : set) piece.full_name += (piece.full_name.empty() ? "" : "+") + surface_names[id];
    if (!whole) {
      piece.full_name += "/" + region_names[piece.region_minus];
      if (piece.region_plus != 0) piece.full_name += "/" + region_names[piece.region_plus];
    }
    piece.id = whole ? set.front() : next_id++;
    result.push_back(std::move(piece));
  }
  return result;
}

std::vector<CurvePiece> curve_pieces(const ModelMesh& mesh, std::int32_t& next_id) {
  std::map<std::pair<VertexIndex, VertexIndex>, std::pair<std::size_t, std::vector<std::int32_t>>> edges;
  for (std::size_t e = 0; e < mesh.curve_edges.size(); ++e) {
    const auto& edge = mesh.curve_edges[e];
    auto& entry =
        edges.try_emplace({std::min(edge.a, edge.b), std::max(edge.a, edge.b)}, e, std::vector<std::int32_t>{})
            .first->second;
    entry.second.push_back(edge.curve);
  }
  std::map<std::vector<std::int32_t>, std::vector<std::size_t>> pieces;
  for (auto& [ends, entry] : edges) {
    std::sort(entry.second.begin(), entry.second.end());
    pieces[entry.second].push_back(entry.first);
  }
  std::map<std::int32_t, std::string> names;
  for (const NamedCurve& c : mesh.curves) names[c.id] = c.name;
  std::map<std::int32_t, std::size_t> n_pieces;
  for (const auto& [curves, rows] : pieces)
    for (std::int32_t id : curves) ++n_pieces[id];
  std::vector<CurvePiece> result;
  for (auto& [curves, rows] : pieces) {
    CurvePiece piece{0, curves, "", std::move(rows)};
    for (std::int32_t id : curves) piece.full_name += (piece.full_name.empty() ? "" : "+") + names[id];
    const bool only = curves.size() == 1;
    if (only && n_pieces[curves.front()] > 1) piece.full_name += "/alone";
    piece.id = only ? curves.front() : next_id++;
    std::sort(piece.edges.begin(), piece.edges.end());
    result.push_back(std::move(piece));
  }
  return result;
}

}  // namespace

std::int32_t largest_id(const ModelMesh& mesh) {
  std::int32_t id = 0;
  for (const auto& r : mesh.regions) id = std::max(id, r.id);
  for (const auto& s : mesh.surfaces) id = std::max(id, s.id);
  for (const auto& c : mesh.curves) id = std::max(id, c.id);
  for (const auto& p : mesh.marked_points) id = std::max(id, p.id);
  for (const auto& l : mesh.cohesive_layers) id = std::max(id, l.id);
  for (const auto& n : mesh.node_sets) id = std::max(id, n.id);
  return id;
}

SolverPieces make_pieces(const ModelMesh& mesh) {
  std::int32_t next_id = largest_id(mesh) + 1;
  SolverPieces groups;
  groups.faces = face_pieces(mesh, next_id);
  groups.curves = curve_pieces(mesh, next_id);
  return groups;
}

}  // namespace geomesh::geomodel
