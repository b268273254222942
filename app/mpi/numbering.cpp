// SPDX-License-Identifier: GPL-3.0-or-later
#include "numbering.hpp"

#include <algorithm>
#include <numeric>

#include "archive.hpp"
#include "geomesh/core/error.hpp"

namespace geomesh::app {

namespace {

struct GhostPoint {
  Vec3 place;
  std::int64_t number = 0;
  std::vector<std::int32_t> ranks;
};
template <class A>
void pass(A& archive, GhostPoint& p) {
  archive(p.place, p.number, p.ranks);
}

struct GhostCell {
  std::int64_t number = 0;
  std::int32_t region = 0;
  std::array<std::int64_t, 4> points{};
};

/// Points and tetrahedra at the border between two ranks, of which one rank sends copies (ghosts) to the other.
struct GhostMessage {
  std::vector<GhostCell> cells;
  std::vector<GhostPoint> points;
};
template <class A>
void pass(A& archive, GhostMessage& m) {
  archive(m.cells, m.points);
}

struct GlobalNumbers {
  std::vector<std::int64_t> of_point, of_cell;
  std::uint64_t n_points = 0, n_cells = 0;  ///< of all ranks
  std::vector<std::uint64_t> n_of_region;
  Sharers sharers;
  std::vector<std::int32_t> alone;  ///< this rank

  const std::vector<std::int32_t>& ranks_at(const Vec3& p) const {
    const auto found = sharers.find(p);
    return found == sharers.end() ? alone : found->second;
  }
};

void number_points(GlobalNumbers& numbers, const ModelPoints& model, const RankMesh& mesh, const Ranks& ranks) {
  const std::int32_t own = ranks.rank();
  numbers.of_point.assign(mesh.points.size(), -1);
  std::vector<VertexIndex> owned;
  for (VertexIndex v = 0; v < mesh.points.size(); ++v) {
    const std::uint32_t k = model.number_at(mesh.points[v]);
    if (k != ModelPoints::none)
      numbers.of_point[v] = k;
    else if (numbers.ranks_at(mesh.points[v]).front() == own)
      owned.push_back(v);
  }
  const std::vector<std::uint64_t> n = ranks.gather_all(std::uint64_t{owned.size()});
  auto next = static_cast<std::int64_t>(model.size());
  for (std::int32_t r = 0; r < own; ++r) next += static_cast<std::int64_t>(n[static_cast<std::size_t>(r)]);
  numbers.n_points = std::accumulate(n.begin(), n.end(), std::uint64_t{model.size()});
  struct Numbered {
    Vec3 place;
    std::int64_t number;
  };
  std::vector<std::vector<Numbered>> told(static_cast<std::size_t>(ranks.size()));
  for (const VertexIndex v : owned) {
    numbers.of_point[v] = next++;
    for (const std::int32_t r : numbers.ranks_at(mesh.points[v]))
      if (r != own) told[static_cast<std::size_t>(r)].push_back({mesh.points[v], numbers.of_point[v]});
  }
  ByPlace<std::int64_t> heard;
  for (const auto& list : ranks.exchange(told))
    for (const Numbered& p : list) heard[p.place] = p.number;
  for (VertexIndex v = 0; v < mesh.points.size(); ++v)
    if (numbers.of_point[v] < 0) numbers.of_point[v] = heard.at(mesh.points[v]);
}

void number_cells(GlobalNumbers& numbers, const RankModel& model, const RankMesh& mesh, const Ranks& ranks) {
  const std::size_t n_regions = model.sparse.mesh.regions.size();
  const auto region = [&](Index c) {
    return static_cast<std::size_t>(model.region_of_component[mesh.component[c]] - 1);
  };
  std::vector<std::uint64_t> n(n_regions, 0);
  for (Index c = 0; c < mesh.tetrahedra.size(); ++c) ++n[region(c)];
  const std::vector<std::vector<std::uint64_t>> all =
      ranks.exchange(std::vector<std::vector<std::uint64_t>>(static_cast<std::size_t>(ranks.size()), n));
  std::vector<std::int64_t> next(n_regions);
  std::int64_t first = 0;
  for (std::size_t k = 0; k < n_regions; ++k) {
    numbers.n_of_region.push_back(0);
    for (std::size_t r = 0; r < all.size(); ++r) {
      if (static_cast<int>(r) == ranks.rank()) next[k] = first;
      first += static_cast<std::int64_t>(all[r][k]);
      numbers.n_of_region.back() += all[r][k];
    }
  }
  numbers.n_cells = static_cast<std::uint64_t>(first);
  for (Index c = 0; c < mesh.tetrahedra.size(); ++c) numbers.of_cell.push_back(next[region(c)]++);
}

GlobalNumbers find_numbers(const RankModel& model, const RankMesh& mesh, const MeshFaces& faces, const Ranks& ranks) {
  GlobalNumbers numbers;
  numbers.alone = {ranks.rank()};
  numbers.sharers = find_sharers(mesh, faces.open_corners(), ranks);
  number_points(numbers, model.points, mesh, ranks);
  number_cells(numbers, model, mesh, ranks);
  return numbers;
}

/// Returns a mesh with the data that the file of every rank contains: the model's points, faces, curves and names.
geomodel::ModelMesh mesh_of_model(const RankModel& model, const GlobalNumbers& numbers) {
  geomodel::ModelMesh out;
  const geomodel::ModelMesh& in = model.sparse.mesh;
  out.name = in.name;
  out.origin = in.origin;
  out.unit = in.unit;
  out.surface_sets = in.surface_sets;
  out.regions = in.regions;
  for (std::size_t k = 0; k < out.regions.size(); ++k) out.regions[k].n_tetrahedra = numbers.n_of_region[k];
  out.attributes = in.attributes;
  out.groups = in.groups;
  out.surfaces = in.surfaces;
  out.curves = in.curves;
  std::vector<VertexIndex> row(in.points.size(), no_vertex);
  for (const VertexIndex v : model.points.rows()) {
    row[v] = static_cast<VertexIndex>(out.points.size());
    out.points.push_back(in.points[v]);
    out.point_kind.push_back(in.point_kind[v]);
    out.input_vertex.push_back(in.input_vertex[v]);
  }
  out.faces = in.faces;
  for (auto& face : out.faces)
    for (VertexIndex& v : face.vertices) v = row[v];
  out.curve_edges = in.curve_edges;
  for (auto& edge : out.curve_edges) edge.a = row[edge.a], edge.b = row[edge.b];
  out.marked_points = in.marked_points;
  for (auto& point : out.marked_points) point.v = row[point.v];
  return out;
}

/// Returns for each other rank the tetrahedra of this rank that touch its part, in the order of their numbers.
std::vector<Bytes> ghosts_for_others(const RankModel& model, const RankMesh& mesh, const GlobalNumbers& numbers,
                                     const std::vector<Index>& order, const Ranks& ranks) {
  std::vector<GhostMessage> out(static_cast<std::size_t>(ranks.size()));
  std::vector<ByPlace<bool>> is_told(out.size());
  std::vector<std::int32_t> others;
  for (const Index c : order) {
    others.clear();
    for (const VertexIndex v : mesh.tetrahedra[c])
      for (const std::int32_t r : numbers.ranks_at(mesh.points[v]))
        if (r != ranks.rank()) others.push_back(r);
    std::sort(others.begin(), others.end());
    others.erase(std::unique(others.begin(), others.end()), others.end());
    for (const std::int32_t r : others) {
      GhostMessage& message = out[static_cast<std::size_t>(r)];
      GhostCell& cell = message.cells.emplace_back();
      cell.number = numbers.of_cell[c];
      cell.region = model.region_of_component[mesh.component[c]];
      for (unsigned i = 0; i < 4; ++i) {
        const VertexIndex v = mesh.tetrahedra[c][i];
        cell.points[i] = numbers.of_point[v];
        if (is_told[static_cast<std::size_t>(r)].try_emplace(mesh.points[v], true).second)
          message.points.push_back({mesh.points[v], numbers.of_point[v], numbers.ranks_at(mesh.points[v])});
      }
    }
  }
  std::vector<Bytes> bytes;
  for (GhostMessage& message : out) {
    Packer packer;
    packer(message);
    bytes.push_back(packer.take());
  }
  return bytes;
}

/// Builds the part of a rank: appends points and tetrahedra to those of the model, in the order of their numbers.
class PartBuilder {
 public:
  PartBuilder(const RankModel& model, const RankMesh& mesh, GlobalNumbers numbers, const Ranks& ranks)
      : model_(model), mesh_(mesh), numbers_(std::move(numbers)), ranks_(ranks) {
    result_.mesh = mesh_of_model(model, numbers_);
    for (std::uint32_t k = 0; k < model.points.size(); ++k) result_.part.node_number.push_back(k);
    ranks_at_.resize(model.points.size());
  }

  NumberedPart run() {
    std::vector<Index> order(mesh_.tetrahedra.size());
    std::iota(order.begin(), order.end(), Index{0});
    std::sort(order.begin(), order.end(), [&](Index a, Index b) { return numbers_.of_cell[a] < numbers_.of_cell[b]; });
    add_own(order);
    take_ghosts(ranks_.exchange(ghosts_for_others(model_, mesh_, numbers_, order, ranks_)));
    geomodel::GivenPart& part = result_.part;
    part.number = ranks_.rank();
    part.n_parts = ranks_.size();
    part.n_nodes = numbers_.n_points;
    part.n_cells = numbers_.n_cells;
    for (const std::vector<std::int32_t>& at : ranks_at_) {
      part.parts_at.insert(part.parts_at.end(), at.begin(), at.end());
      part.first_at_node.push_back(part.parts_at.size());
    }
    return std::move(result_);
  }

 private:
  bool is_model(std::int64_t number) const { return static_cast<std::size_t>(number) < model_.points.size(); }

  /// Returns the row of a received point in this rank's mesh. A point that is not of the model gets a new row at first.
  VertexIndex row_of(const GhostPoint& p) {
    constexpr std::uint8_t inside = 4;
    geomodel::ModelMesh& out = result_.mesh;
    auto v = static_cast<VertexIndex>(p.number);
    if (!is_model(p.number)) {
      const auto [found, is_new] = row_of_.try_emplace(p.number, static_cast<VertexIndex>(out.points.size()));
      v = found->second;
      if (is_new) {
        out.points.push_back(p.place);
        out.point_kind.push_back(inside);
        out.input_vertex.push_back(-1);
        result_.part.node_number.push_back(p.number);
        ranks_at_.emplace_back();
      }
    }
    ranks_at_[v] = p.ranks;
    return v;
  }
  void add_cell(const Tetrahedron& t, const GhostCell& cell, std::int32_t rank) {
    result_.mesh.tetrahedra.push_back(t);
    result_.mesh.tet_region.push_back(cell.region);
    result_.part.cell_number.push_back(cell.number);
    result_.part.part_of_cell.push_back(rank);
  }

  void add_own(const std::vector<Index>& order) {
    std::vector<VertexIndex> by_number(mesh_.points.size()), row(mesh_.points.size());
    std::iota(by_number.begin(), by_number.end(), VertexIndex{0});
    std::sort(by_number.begin(), by_number.end(),
              [&](VertexIndex a, VertexIndex b) { return numbers_.of_point[a] < numbers_.of_point[b]; });
    for (const VertexIndex v : by_number)
      row[v] = row_of({mesh_.points[v], numbers_.of_point[v], numbers_.ranks_at(mesh_.points[v])});
    for (const Index c : order) {
      Tetrahedron t = mesh_.tetrahedra[c];
      for (VertexIndex& v : t) v = row[v];
      add_cell(t, {numbers_.of_cell[c], model_.region_of_component[mesh_.component[c]], {}}, ranks_.rank());
    }
    result_.n_own = order.size();
  }

  void take_ghosts(const std::vector<Bytes>& came) {
    struct Ghost {
      GhostCell cell;
      std::int32_t rank;
    };
    std::vector<Ghost> ghosts;
    std::vector<GhostPoint> points;
    for (std::size_t r = 0; r < came.size(); ++r) {
      if (static_cast<int>(r) == ranks_.rank()) continue;
      GhostMessage message;
      Unpacker unpacker(came[r]);
      unpacker(message);
      for (const GhostCell& cell : message.cells) ghosts.push_back({cell, static_cast<std::int32_t>(r)});
      std::move(message.points.begin(), message.points.end(), std::back_inserter(points));
    }
    std::sort(ghosts.begin(), ghosts.end(),
              [](const Ghost& a, const Ghost& b) { return a.cell.number < b.cell.number; });
    std::stable_sort(points.begin(), points.end(),
                     [](const GhostPoint& a, const GhostPoint& b) { return a.number < b.number; });
    for (const GhostPoint& p : points) row_of(p);
    for (const Ghost& g : ghosts) {
      Tetrahedron t;
      for (unsigned i = 0; i < 4; ++i) {
        const std::int64_t k = g.cell.points[i];
        t[i] = is_model(k) ? static_cast<VertexIndex>(k) : row_of_.at(k);
      }
      add_cell(t, g.cell, g.rank);
    }
  }

  const RankModel& model_;
  const RankMesh& mesh_;
  const GlobalNumbers numbers_;
  const Ranks& ranks_;
  std::unordered_map<std::int64_t, VertexIndex> row_of_;
  std::vector<std::vector<std::int32_t>> ranks_at_;  // by row
  NumberedPart result_;
};

}  // namespace

NumberedPart number_part(const RankModel& model, const RankMesh& mesh, const MeshFaces& faces, const Ranks& ranks) {
  return PartBuilder(model, mesh, find_numbers(model, mesh, faces, ranks), ranks).run();
}

}  // namespace geomesh::app
