// SPDX-License-Identifier: GPL-3.0-or-later
#include "part.hpp"

#include <algorithm>
#include <queue>
#include <set>

#include "geomesh/core/error.hpp"
#include "geomesh/core/predicates.hpp"
#include "geomesh/core/quality.hpp"
#include "geomesh/core/simplex_mesh.hpp"
#include "halve.hpp"
#include "mesh_faces.hpp"

namespace geomesh::app {

namespace {

/// Edges longer than this multiple of the target size at their midpoint are halved. Halves are therefore hardly shorter
/// than the target size divided by this number.
constexpr double longest_share = 1.4;

class BorderHalver {
 public:
  BorderHalver(RankMesh& mesh, const SizeField& size, std::vector<bool> stays)
      : mesh_(mesh), size_(size), stays_(std::move(stays)), cells_at_(mesh.points.size()) {}

  /// Halves long edges. `border` contains the triangles between parts, `kept` the edges, sorted, that are not halved.
  void run(const std::vector<OpenFace>& border, const std::vector<Edge>& kept) {
    kept_ = &kept;
    std::vector<bool> at_border(mesh_.points.size(), false);
    for (const OpenFace& f : border)
      for (const VertexIndex v : f.vertices) at_border[v] = true;
    for (Index c = 0; c < mesh_.tetrahedra.size(); ++c)
      for (const VertexIndex v : mesh_.tetrahedra[c])
        if (at_border[v]) cells_at_[v].push_back(c);
    for (const OpenFace& f : border) add_triangle(f.vertices, mesh_.component[f.cell]);
    while (!queue_.empty()) {
      const LongEdge e = queue_.top();
      queue_.pop();
      halve(e);
    }
    for (const Index c : touched_) {
      const Tetrahedron& t = mesh_.tetrahedra[c];
      const auto& p = mesh_.points;
      if (orient3d(p[t[0]], p[t[1]], p[t[2]], p[t[3]]) != Sign::positive)
        throw Error(ErrorKind::cannot_mesh,
                    "a tetrahedron between two ranks is too flat to be divided; take another number of ranks");
    }
  }
  /// Returns the tetrahedra that were divided because an edge on the border between ranks was halved.
  const std::set<Index>& touched() const { return touched_; }

 private:
  struct LongEdge {
    double squared_length;
    Vec3 low, high;  // coordinates of the edge's two ends, in lexicographic order
    Edge ends;
    bool operator<(const LongEdge& o) const {
      if (squared_length != o.squared_length) return squared_length < o.squared_length;
      if (!(low == o.low)) return is_before(low, o.low);
      return is_before(high, o.high);
    }
  };

  void add_triangle(const Triangle& t, Index component) {
    const auto row = static_cast<Index>(triangles_.size());
    triangles_.push_back({t, component});
    for (unsigned i = 0; i < 3; ++i) {
      const Edge e = sorted_edge(t[i], t[(i + 1) % 3]);
      auto& at = triangles_at_[e];
      at.push_back(row);
      if (at.size() == 1) ask(e, component);
    }
  }
  void ask(const Edge& e, Index component) {
    if (stays_[e[0]] && stays_[e[1]] && std::binary_search(kept_->begin(), kept_->end(), e)) return;
    Vec3 low = mesh_.points[e[0]], high = mesh_.points[e[1]];
    if (is_before(high, low)) std::swap(low, high);
    const double longest = longest_share * size_.at(0.5 * (low + high), component);
    const double l2 = dot(high - low, high - low);
    if (l2 > longest * longest) queue_.push({l2, low, high, e});
  }
  void halve(const LongEdge& e) {
    const auto found = triangles_at_.find(e.ends);
    if (found == triangles_at_.end() || found->second.empty()) return;
    const std::vector<Index> rows = found->second;
    const auto m = static_cast<VertexIndex>(mesh_.points.size());
    mesh_.points.push_back(0.5 * (e.low + e.high));
    stays_.push_back(false);
    cells_at_.emplace_back();
    halve_cells(e.ends, m);
    for (const Index row : rows) {
      const auto [t, component] = triangles_[row];
      for (unsigned i = 0; i < 3; ++i) std::erase(triangles_at_[sorted_edge(t[i], t[(i + 1) % 3])], row);
      for (const VertexIndex gone : e.ends) {
        Triangle half = t;
        std::replace(half.begin(), half.end(), gone, m);
        add_triangle(half, component);
      }
    }
    triangles_at_.erase(e.ends);
  }
  void halve_cells(const Edge& e, VertexIndex m) {
    std::vector<Index> cells;
    for (const Index c : cells_at_[e[0]])
      if (std::ranges::count(mesh_.tetrahedra[c], e[1]) > 0) cells.push_back(c);
    for (const Index c : cells) {
      const auto made = static_cast<Index>(mesh_.tetrahedra.size());
      Tetrahedron other = mesh_.tetrahedra[c];
      std::replace(other.begin(), other.end(), e[0], m);
      std::replace(mesh_.tetrahedra[c].begin(), mesh_.tetrahedra[c].end(), e[1], m);
      mesh_.tetrahedra.push_back(other);
      mesh_.component.push_back(mesh_.component[c]);
      std::erase(cells_at_[e[1]], c);
      for (const VertexIndex v : other)
        if (v == e[1] || v == m || !cells_at_[v].empty()) cells_at_[v].push_back(made);
      cells_at_[m].push_back(c);
      touched_.insert({c, made});
    }
  }

  RankMesh& mesh_;
  const SizeField& size_;
  std::vector<bool> stays_;  // for each point: whether it is a point of the model
  const std::vector<Edge>* kept_ = nullptr;
  std::vector<std::vector<Index>> cells_at_;  // for each point on the border between ranks, the tetrahedra that have it
  struct BorderTriangle {
    Triangle corners;
    Index component;
  };
  std::vector<BorderTriangle> triangles_;
  struct EdgeHash {
    std::size_t operator()(const Edge& e) const {
      return (std::uint64_t{e[0]} << 32 | e[1]) * 0x9E3779B97F4A7C15u >> 7;
    }
  };
  std::unordered_map<Edge, std::vector<Index>, EdgeHash> triangles_at_;
  std::priority_queue<LongEdge> queue_;
  std::set<Index> touched_;
};

}  // namespace

ModelPoints::ModelPoints(const geomodel::ModelMesh& mesh) {
  constexpr std::uint8_t inside = 4;
  std::vector<bool> is_model(mesh.points.size(), false);
  for (VertexIndex v = 0; v < mesh.points.size(); ++v) is_model[v] = mesh.point_kind[v] != inside;
  for (const auto& face : mesh.faces)
    for (const VertexIndex v : face.vertices) is_model[v] = true;
  for (const auto& edge : mesh.curve_edges) is_model[edge.a] = is_model[edge.b] = true;
  for (const auto& point : mesh.marked_points) is_model[point.v] = true;
  for (VertexIndex v = 0; v < mesh.points.size(); ++v) {
    if (!is_model[v]) continue;
    if (!number_.emplace(mesh.points[v], static_cast<std::uint32_t>(rows_.size())).second)
      throw InternalError("two points of the model are in one place");
    rows_.push_back(v);
  }
}

ModelSimplices::ModelSimplices(const geomodel::ModelMesh& mesh, const ModelPoints& points) {
  const auto number = [&](VertexIndex v) { return points.number_at(mesh.points[v]); };
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    const Triangle& t = mesh.faces[f].vertices;
    faces.push_back({sorted_corners({number(t[0]), number(t[1]), number(t[2])}), f});
  }
  std::sort(faces.begin(), faces.end());
  for (const auto& e : mesh.curve_edges) edges.push_back(sorted_edge(number(e.a), number(e.b)));
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
}

Index ModelSimplices::face_of(const Corners& corners) const {
  const auto found = std::lower_bound(faces.begin(), faces.end(), Face{corners, 0});
  return found != faces.end() && found->corners == corners ? found->row : no_index;
}

namespace {

SparseModel with_fine_surfaces(SparseModel model) {
  for (unsigned k = 0; k < model.halvings; ++k) halve_surfaces(model.mesh);
  return model;
}

}  // namespace

RankModel::RankModel(SparseModel given)
    : sparse(with_fine_surfaces(std::move(given))), points(sparse.mesh), simplices(sparse.mesh, points) {
  for (std::size_t t = 0; t < sparse.mesh.tetrahedra.size(); ++t) {
    const Index c = sparse.component[t];
    if (c >= region_of_component.size()) region_of_component.resize(c + 1, 0);
    region_of_component[c] = sparse.mesh.tet_region[t];
  }
}

namespace {

RankMesh tetrahedra_of_rank(const SparseModel& model, const std::vector<std::int32_t>& rank_of, std::int32_t rank) {
  RankMesh mesh;
  std::vector<VertexIndex> row(model.mesh.points.size(), no_vertex);
  for (std::size_t t = 0; t < rank_of.size(); ++t) {
    if (rank_of[t] != rank) continue;
    Tetrahedron own = model.mesh.tetrahedra[t];
    for (VertexIndex& v : own) {
      if (row[v] == no_vertex) {
        row[v] = static_cast<VertexIndex>(mesh.points.size());
        mesh.points.push_back(model.mesh.points[v]);
      }
      v = row[v];
    }
    mesh.tetrahedra.push_back(own);
    mesh.component.push_back(model.component[t]);
  }
  for (unsigned k = 0; k < model.halvings; ++k) halve_tetrahedra(mesh.points, mesh.tetrahedra, mesh.component);
  return mesh;
}

/// Marks tetrahedra that are not refined again. Rank 0 has repaired poor tetrahedra while surfaces could still be
/// moved. These and their neighbours are marked if they are as small as requested, or have only points of the model.
/// Tetrahedra in `divided` have changed since and are not marked.
void settle(RankMesh& mesh, const RankModel& model, const std::set<Index>& divided) {
  constexpr double poor = 30;       // dihedral angle in degrees below which a tetrahedron counts as poor
  constexpr double as_asked = 1.6;  // longest edge, in target sizes, of a tetrahedron that needs no refinement
  std::vector<bool> is_about(mesh.points.size(), false);
  const auto corners = [&](const Tetrahedron& t) {
    return std::array{mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]], mesh.points[t[3]]};
  };
  for (Index c = 0; c < mesh.tetrahedra.size(); ++c) {
    const auto p = corners(mesh.tetrahedra[c]);
    if (dihedral_range(p[0], p[1], p[2], p[3]).least < poor && !divided.contains(c))
      for (const VertexIndex v : mesh.tetrahedra[c]) is_about[v] = true;
  }
  mesh.is_settled.assign(mesh.tetrahedra.size(), 0);
  for (Index c = 0; c < mesh.tetrahedra.size(); ++c) {
    const Tetrahedron& t = mesh.tetrahedra[c];
    if (divided.contains(c) || std::ranges::none_of(t, [&](VertexIndex v) { return is_about[v]; })) continue;
    const auto p = corners(t);
    const Vec3 middle = 0.25 * ((p[0] + p[1]) + (p[2] + p[3]));
    const auto is_of_model = [&](const Vec3& place) { return model.points.number_at(place) != ModelPoints::none; };
    mesh.is_settled[c] = tetrahedron_shape(p[0], p[1], p[2], p[3]).longest_edge <=
                             as_asked * model.sparse.size.at(middle, mesh.component[c]) ||
                         std::ranges::all_of(p, is_of_model);
  }
}

}  // namespace

RankMesh part_of_rank(const RankModel& model, const std::vector<std::int32_t>& rank_of, std::int32_t rank) {
  const ModelPoints& points = model.points;
  const ModelSimplices& simplices = model.simplices;
  RankMesh mesh = tetrahedra_of_rank(model.sparse, rank_of, rank);
  std::vector<std::uint32_t> number;
  std::vector<bool> stays;
  for (const Vec3& p : mesh.points) {
    number.push_back(points.number_at(p));
    stays.push_back(number.back() != ModelPoints::none);
  }
  std::vector<OpenFace> border = MeshFaces(mesh).open;
  std::erase_if(border, [&](const OpenFace& face) {
    const Triangle& t = face.vertices;
    return stays[t[0]] && stays[t[1]] && stays[t[2]] &&
           simplices.face_of(sorted_corners({number[t[0]], number[t[1]], number[t[2]]})) != no_index;
  });
  std::vector<VertexIndex> row_of_number(points.size(), no_vertex);
  for (VertexIndex v = 0; v < number.size(); ++v)
    if (stays[v]) row_of_number[number[v]] = v;
  std::vector<Edge> kept;
  const auto keep = [&](std::uint32_t a, std::uint32_t b) {
    if (row_of_number[a] != no_vertex && row_of_number[b] != no_vertex)
      kept.push_back(sorted_edge(row_of_number[a], row_of_number[b]));
  };
  for (const ModelSimplices::Face& f : simplices.faces)
    for (unsigned i = 0; i < 3; ++i) keep(f.corners[i], f.corners[(i + 1) % 3]);
  for (const auto& e : simplices.edges) keep(e[0], e[1]);
  std::sort(kept.begin(), kept.end());
  kept.erase(std::unique(kept.begin(), kept.end()), kept.end());
  BorderHalver halver(mesh, model.sparse.size, std::move(stays));
  halver.run(border, kept);
  if (model.sparse.halvings == 0) settle(mesh, model, halver.touched());
  return mesh;
}

TetrahedraPart with_model(RankMesh mesh, const RankModel& model) {
  const ModelSimplices& simplices = model.simplices;
  TetrahedraPart part;
  std::vector<std::uint32_t> number;
  for (const Vec3& p : mesh.points) {
    number.push_back(model.points.number_at(p));
    part.is_kept.push_back(number.back() != ModelPoints::none);
  }
  const auto model_face = [&](const Triangle& t) {
    return part.is_kept[t[0]] && part.is_kept[t[1]] && part.is_kept[t[2]] &&
           simplices.face_of(sorted_corners({number[t[0]], number[t[1]], number[t[2]]})) != no_index;
  };
  std::vector<std::pair<Corners, Triangle>> faces;
  std::vector<Edge> edges;
  for (const Tetrahedron& t : mesh.tetrahedra) {
    for (unsigned i = 0; i < 4; ++i)
      if (const Triangle f = face_at(t, i); model_face(f)) faces.emplace_back(sorted_corners(f), f);
    for (const auto& e : edge_vertices) {
      const VertexIndex a = t[e[0]], b = t[e[1]];
      if (!part.is_kept[a] || !part.is_kept[b]) continue;
      const Edge by_number = sorted_edge(number[a], number[b]);
      if (std::binary_search(simplices.edges.begin(), simplices.edges.end(), by_number))
        edges.push_back(sorted_edge(a, b));
    }
  }
  std::stable_sort(faces.begin(), faces.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (std::size_t i = 0; i + 1 < faces.size(); ++i)
    if (faces[i].first == faces[i + 1].first) part.kept_faces.push_back(faces[i].second);
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  part.kept_edges = std::move(edges);
  part.points = std::move(mesh.points);
  part.tetrahedra = std::move(mesh.tetrahedra);
  part.component = std::move(mesh.component);
  part.is_settled = std::move(mesh.is_settled);
  return part;
}

RankMesh without_model(TetrahedraPart part) {
  return {std::move(part.points), std::move(part.tetrahedra), std::move(part.component), std::move(part.is_kept), {}};
}

}  // namespace geomesh::app
