// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver_mesh/split_faults.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include "geomesh/core/error.hpp"
#include "geomesh/core/simplex_mesh.hpp"
#include "solver_mesh/corners/free_corners.hpp"
#include "solver_mesh/face_sides.hpp"
#include "solver_mesh/fault_sides.hpp"
#include "solver_mesh/pieces.hpp"

namespace geomesh::geomodel {

namespace {

class FaultSplitter {
 public:
  FaultSplitter(const ModelMesh& mesh, const std::vector<std::string>& surfaces)
      : before_(mesh), mesh_(mesh), next_id_(largest_id(mesh) + 1) {
    for (const std::string& name : surfaces) choose(name);
    std::vector<Triangle> faces;
    for (const auto& face : mesh.faces) faces.push_back(face.vertices);
    sides_ = tetrahedra_at_faces(mesh.tetrahedra, faces);
    mark_faces();
    turned_ = turned_faces(mesh, split_of_);
    original_.resize(mesh.points.size());
    std::iota(original_.begin(), original_.end(), VertexIndex{0});
    double_nodes();
  }

  SplitMesh split(bool cohesive) {
    name_sides();
    split_faces();
    move_curves();
    move_curved_edges();
    if (cohesive) add_prisms();
    return {std::move(mesh_), std::move(original_)};
  }

 private:
  void choose(const std::string& name) {
    for (const NamedSurface& surface : before_.surfaces)
      if (surface.name == name) {
        chosen_.push_back(surface.id);
        return;
      }
    std::string known;
    for (const NamedSurface& surface : before_.surfaces) known += (known.empty() ? "" : ", ") + surface.name;
    throw Error(ErrorKind::usage, "split: no surface is named \"" + name + "\"; there are " + known);
  }
  const std::vector<std::int32_t>& set_of(const ModelMesh::Face& face) const {
    return before_.surface_sets[static_cast<std::size_t>(face.surface_set)];
  }
  /// Returns the id of the first surface to be split on which a face lies; 0 if there is none.
  std::int32_t chosen_on(const ModelMesh::Face& face) const {
    for (const std::int32_t id : set_of(face))
      if (std::find(chosen_.begin(), chosen_.end(), id) != chosen_.end()) return id;
    return 0;
  }
  bool is_split(std::size_t f) const { return split_of_[f] != 0; }

  void mark_faces() {
    blocked_.assign(before_.tetrahedra.size(), 0);
    std::set<std::int32_t> found;
    for (std::size_t f = 0; f < before_.faces.size(); ++f) {
      const auto& [minus, plus] = sides_[f];
      const bool inner = minus.tetrahedron != no_side && plus.tetrahedron != no_side;
      const std::int32_t id = inner ? chosen_on(before_.faces[f]) : 0;
      split_of_.push_back(id);
      if (id == 0) continue;
      for (const std::int32_t member : set_of(before_.faces[f])) found.insert(member);
      blocked_[minus.tetrahedron] |= 1u << minus.opposite;
      blocked_[plus.tetrahedron] |= 1u << plus.opposite;
    }
    for (const NamedSurface& surface : before_.surfaces)
      if (std::find(chosen_.begin(), chosen_.end(), surface.id) != chosen_.end() && !found.contains(surface.id))
        throw Error(ErrorKind::usage, "split: the surface \"" + surface.name + "\" has no face inside the mesh");
  }

  /// Makes one node for each sector at each node on split faces. A sector consists of the tetrahedra at the node that
  /// are connected through faces which are not split.
  void double_nodes() {
    const std::size_t n = before_.points.size();
    std::vector<bool> touched(n, false);
    for (std::size_t f = 0; f < before_.faces.size(); ++f)
      if (is_split(f))
        for (const VertexIndex v : before_.faces[f].vertices) touched[v] = true;
    std::vector<std::vector<std::size_t>> at(n);  // for each node on split faces: its tetrahedra t, as 4 t + corner
    for (std::size_t t = 0; t < before_.tetrahedra.size(); ++t)
      for (std::size_t i = 0; i < 4; ++i)
        if (touched[before_.tetrahedra[t][i]]) at[before_.tetrahedra[t][i]].push_back(4 * t + i);
    across_ = tetrahedra_across(before_.tetrahedra);
    for (VertexIndex v = 0; v < n; ++v) {
      bool is_first = true;
      for (const std::size_t corner : at[v]) {
        if (done_.contains(corner)) continue;
        flood(v, corner, is_first ? v : copy_of(v));
        is_first = false;
      }
    }
  }
  VertexIndex copy_of(VertexIndex v) {
    mesh_.points.push_back(before_.points[v]);
    mesh_.point_kind.push_back(before_.point_kind[v]);
    mesh_.input_vertex.push_back(-1);
    original_.push_back(v);
    for (PointArray& array : mesh_.point_arrays) array.values.push_back(array.values[v]);
    return static_cast<VertexIndex>(mesh_.points.size() - 1);
  }
  void flood(VertexIndex v, std::size_t corner, VertexIndex node) {
    std::vector<std::size_t> front{corner};
    done_.insert(corner);
    while (!front.empty()) {
      const std::size_t c = front.back(), t = c / 4, own = c % 4;
      front.pop_back();
      mesh_.tetrahedra[t][own] = node;
      for (std::size_t i = 0; i < 4; ++i) {
        if (i == own || (blocked_[t] >> i & 1u) != 0 || across_[t][i] == no_neighbour) continue;
        const std::size_t other = across_[t][i];
        const Tetrahedron& vertices = before_.tetrahedra[other];
        const auto at = static_cast<std::size_t>(std::find(vertices.begin(), vertices.end(), v) - vertices.begin());
        if (done_.insert(4 * other + at).second) front.push_back(4 * other + at);
      }
    }
  }

  /// Returns the vertices that a face has in the tetrahedron after nodes were doubled.
  Triangle vertices_at(std::size_t f, std::size_t tetrahedron) const {
    Triangle result = before_.faces[f].vertices;
    for (VertexIndex& v : result)
      for (std::size_t i = 0; i < 4; ++i)
        if (before_.tetrahedra[tetrahedron][i] == v) {
          v = mesh_.tetrahedra[tetrahedron][i];
          break;
        }
    return result;
  }
  void name_sides() {
    for (NamedSurface& surface : mesh_.surfaces)
      if (std::find(chosen_.begin(), chosen_.end(), surface.id) != chosen_.end()) {
        plus_of_[surface.id] = next_id_++;
        surface.name += ".minus";
      }
    for (const NamedSurface& surface : before_.surfaces)
      if (const auto plus = plus_of_.find(surface.id); plus != plus_of_.end())
        mesh_.surfaces.push_back({plus->second, surface.name + ".plus", surface.kind, surface.area});
  }
  std::int32_t set_on_plus_side(std::int32_t set) {
    std::vector<std::int32_t> ids = before_.surface_sets[static_cast<std::size_t>(set)];
    for (std::int32_t& id : ids)
      if (const auto plus = plus_of_.find(id); plus != plus_of_.end()) id = plus->second;
    const auto [entry, is_new] = plus_sets_.try_emplace(set, static_cast<std::int32_t>(mesh_.surface_sets.size()));
    if (is_new) mesh_.surface_sets.push_back(std::move(ids));
    return entry->second;
  }
  void split_faces() {
    for (std::size_t f = 0; f < before_.faces.size(); ++f) {
      const auto& [minus, plus] = sides_[f];
      ModelMesh::Face& face = mesh_.faces[f];
      const std::size_t own = minus.tetrahedron != no_side ? minus.tetrahedron : plus.tetrahedron;
      if (own == no_side) continue;
      face.vertices = vertices_at(f, own);
      if (!is_split(f)) continue;
      ModelMesh::Face other = face;
      other.vertices = vertices_at(f, plus.tetrahedron);
      other.region_minus = face.region_plus;
      Pair pair{split_of_[f], face.vertices, other.vertices};
      std::swap(other.vertices[1], other.vertices[2]);
      if (turned_[f]) {
        std::swap(face, other);
        pair = {split_of_[f], face.vertices, {other.vertices[0], other.vertices[2], other.vertices[1]}};
      }
      pairs_.push_back(pair);
      other.surface_set = set_on_plus_side(face.surface_set);
      other.surface = mesh_.surface_sets[static_cast<std::size_t>(other.surface_set)].front();
      face.region_plus = other.region_plus = 0;
      plus_faces_.push_back(other);
    }
    mesh_.faces.insert(mesh_.faces.end(), plus_faces_.begin(), plus_faces_.end());
  }
  /// Updates the nodes of edges of curves after the split: an edge follows the first tetrahedron that has it.
  void move_curves() {
    std::map<std::pair<VertexIndex, VertexIndex>, std::vector<ModelMesh::CurveEdge*>> edges;
    for (auto& e : mesh_.curve_edges) edges[{std::min(e.a, e.b), std::max(e.a, e.b)}].push_back(&e);
    for (std::size_t t = 0; t < before_.tetrahedra.size() && !edges.empty(); ++t)
      for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j) {
          const VertexIndex a = before_.tetrahedra[t][i], b = before_.tetrahedra[t][j];
          if (a >= b) continue;
          const auto found = edges.find({a, b});
          if (found == edges.end()) continue;
          for (ModelMesh::CurveEdge* e : found->second) {
            const bool forward = e->a == a;
            (forward ? e->a : e->b) = mesh_.tetrahedra[t][i];
            (forward ? e->b : e->a) = mesh_.tetrahedra[t][j];
          }
          edges.erase(found);
        }
  }
  /// Updates the nodes of curved edges after faults are split. Copies of an edge on both sides have the same curvature.
  void move_curved_edges() {
    if (before_.curved_edges.empty()) return;
    std::map<std::pair<VertexIndex, VertexIndex>, const CurvedEdge*> before, now;
    for (const CurvedEdge& e : before_.curved_edges) before[{e.a, e.b}] = &e;
    for (std::size_t t = 0; t < before_.tetrahedra.size(); ++t)
      for (const auto& [i, j] : edge_vertices) {
        const auto found = before.find(std::minmax(before_.tetrahedra[t][i], before_.tetrahedra[t][j]));
        if (found != before.end()) now[std::minmax(mesh_.tetrahedra[t][i], mesh_.tetrahedra[t][j])] = found->second;
      }
    mesh_.curved_edges.clear();
    for (const auto& [ends, edge] : now)
      mesh_.curved_edges.push_back({ends.first, ends.second, edge->middle, edge->values});
  }
  /// Adds cohesive prisms between the two sides of split faces, except where all three nodes of a face are at a tip,
  /// because nothing opens there.
  void add_prisms() {
    std::map<std::int32_t, std::int32_t> layer_of;
    for (const NamedSurface& surface : before_.surfaces)
      if (plus_of_.contains(surface.id)) {
        layer_of[surface.id] = next_id_;
        mesh_.cohesive_layers.push_back({next_id_++, surface.name + ".layer"});
      }
    for (const auto& [surface, minus, plus] : pairs_)
      if (minus != plus)
        mesh_.prisms.push_back({{minus[0], minus[1], minus[2], plus[0], plus[1], plus[2]}, layer_of[surface]});
  }

  struct Pair {
    std::int32_t surface;
    Triangle minus, plus;
  };
  const ModelMesh& before_;
  ModelMesh mesh_;
  std::int32_t next_id_;
  std::vector<std::int32_t> chosen_, split_of_;
  std::vector<std::array<TetrahedronSide, 2>> sides_;
  std::vector<unsigned> blocked_;  // for each tetrahedron: a bit for each of its faces that is split
  std::vector<Neighbours> across_;
  std::set<std::size_t> done_;
  std::vector<bool> turned_;           // by face
  std::vector<VertexIndex> original_;  // by node
  std::map<std::int32_t, std::int32_t> plus_of_, plus_sets_;
  std::vector<ModelMesh::Face> plus_faces_;
  std::vector<Pair> pairs_;
};

}  // namespace

SplitMesh split_with_origins(const ModelMesh& mesh, const std::vector<std::string>& surfaces, bool cohesive) {
  return FaultSplitter(mesh, surfaces).split(cohesive);
}

ModelMesh split_along(const ModelMesh& mesh, const std::vector<std::string>& surfaces, bool cohesive) {
  return split_with_origins(with_free_corners(mesh, surfaces), surfaces, cohesive).mesh;
}

}  // namespace geomesh::geomodel
