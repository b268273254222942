// SPDX-License-Identifier: GPL-3.0-or-later
#include "strips.hpp"

#include <algorithm>
#include <map>
#include <numeric>

#include "archive.hpp"
#include "shared_points.hpp"

namespace geomesh::app {

namespace {

constexpr unsigned layers = 3, n_rounds = 2;
constexpr std::int32_t nobody = -1;

/// Decides which of the ranks that share a point takes the tetrahedra around it. In the first round the points that the
/// same two ranks share are divided, so that each rank takes half of them; in the second round the highest rank takes
/// all. Both ranks know all points that only they share, so both decide alike.
class Takers {
 public:
  Takers(const Sharers& sharers, unsigned round) : round_(round) {
    std::map<std::vector<std::int32_t>, std::vector<Vec3>> of_pair;
    for (const auto& [place, ranks] : sharers)
      if (ranks.size() == 2) of_pair[ranks].push_back(place);
    for (auto& [pair, places] : of_pair) cuts_[pair] = cut(places);
  }
  std::int32_t at(const Vec3& place, const std::vector<std::int32_t>& ranks) const {
    if (round_ > 0) return ranks.back();
    const auto found = cuts_.find(ranks);
    if (found != cuts_.end()) return place[found->second.axis] < found->second.at ? ranks.front() : ranks.back();
    const auto sum = static_cast<std::size_t>(std::accumulate(ranks.begin(), ranks.end(), 0));
    return ranks[sum % ranks.size()];
  }

 private:
  struct Cut {
    std::size_t axis;
    double at;
  };
  /// Divides the points that two ranks share at the median, along the axis of their largest extent.
  static Cut cut(const std::vector<Vec3>& places) {
    Box3 box;
    for (const Vec3& p : places) box.add(p);
    const Vec3 extent = box.max - box.min;
    Cut cut{extent.x >= extent.y && extent.x >= extent.z ? 0u : extent.y >= extent.z ? 1u : 2u, 0};
    std::vector<double> along;
    for (const Vec3& p : places) along.push_back(p[cut.axis]);
    const auto middle = along.begin() + static_cast<std::ptrdiff_t>(along.size() / 2);
    std::nth_element(along.begin(), middle, along.end());
    cut.at = *middle;
    return cut;
  }

  unsigned round_;
  std::map<std::vector<std::int32_t>, Cut> cuts_;  // for each pair of ranks, the plane that divides their common border
};

/// For each point of a rank's mesh, whether it has lain on a border between ranks in every round so far.
using Pending = std::vector<bool>;

/// Tetrahedra, with their points, that are sent to another rank, which will improve them.
struct Parcel {
  std::vector<Vec3> points;
  std::vector<std::uint8_t> is_pending, may_be_outside;
  std::vector<Tetrahedron> tetrahedra;
  std::vector<Index> component;
};
template <class A>
void pass(A& archive, Parcel& p) {
  archive(p.points, p.is_pending, p.may_be_outside, p.tetrahedra, p.component);
}

class ParcelFiller {
 public:
  ParcelFiller(const RankMesh& mesh, const Pending& pending)
      : mesh_(mesh), pending_(pending), row_(mesh.points.size(), no_vertex) {}

  Parcel of(const std::vector<Index>& cells) {
    Parcel parcel;
    for (const Index c : cells) {
      Tetrahedron t = mesh_.tetrahedra[c];
      for (VertexIndex& v : t) {
        if (row_[v] == no_vertex) {
          row_[v] = static_cast<VertexIndex>(parcel.points.size());
          used_.push_back(v);
          parcel.points.push_back(mesh_.points[v]);
          parcel.is_pending.push_back(pending_[v]);
          parcel.may_be_outside.push_back(1);
        }
        v = row_[v];
      }
      parcel.tetrahedra.push_back(t);
      parcel.component.push_back(mesh_.component[c]);
    }
    for (const VertexIndex v : used_) row_[v] = no_vertex;
    used_.clear();
    return parcel;
  }

 private:
  const RankMesh& mesh_;
  const Pending& pending_;
  std::vector<VertexIndex> row_, used_;
};

/// Adds tetrahedra received from other ranks to a mesh, and merges points at the same position.
class Joiner {
 public:
  Joiner(RankMesh& mesh, Pending& pending) : mesh_(mesh), pending_(pending) {}
  /// Records the position of point v of the mesh, so that a received point at this position is merged with it.
  void know(VertexIndex v) { at_.try_emplace(mesh_.points[v], v); }
  void add(const Parcel& parcel) {
    std::vector<VertexIndex> row;
    for (std::size_t k = 0; k < parcel.points.size(); ++k) {
      const auto [found, is_new] = at_.try_emplace(parcel.points[k], static_cast<VertexIndex>(mesh_.points.size()));
      if (is_new) {
        mesh_.points.push_back(parcel.points[k]);
        mesh_.may_be_outside.push_back(0);
        pending_.push_back(false);
      }
      if (parcel.is_pending[k]) pending_[found->second] = true;
      if (parcel.may_be_outside[k]) mesh_.may_be_outside[found->second] = 1;
      row.push_back(found->second);
    }
    for (Tetrahedron t : parcel.tetrahedra) {
      for (VertexIndex& v : t) v = row[v];
      mesh_.tetrahedra.push_back(t);
    }
    mesh_.component.insert(mesh_.component.end(), parcel.component.begin(), parcel.component.end());
  }

 private:
  RankMesh& mesh_;
  Pending& pending_;
  ByPlace<VertexIndex> at_;
};

/// Removes the tetrahedra that a rank will improve. Those that this rank improves are added again afterwards.
void drop_taken(RankMesh& mesh, const std::vector<std::int32_t>& takers) {
  std::size_t n = 0;
  for (std::size_t c = 0; c < takers.size(); ++c) {
    if (takers[c] != nobody) continue;
    mesh.tetrahedra[n] = mesh.tetrahedra[c];
    mesh.component[n++] = mesh.component[c];
  }
  mesh.tetrahedra.resize(n);
  mesh.component.resize(n);
}

void drop_unused_points(RankMesh& mesh, Pending& pending) {
  std::vector<VertexIndex> row(mesh.points.size(), no_vertex);
  for (const Tetrahedron& t : mesh.tetrahedra)
    for (const VertexIndex v : t) row[v] = 0;
  VertexIndex n = 0;
  for (VertexIndex v = 0; v < row.size(); ++v) {
    if (row[v] == no_vertex) continue;
    mesh.points[n] = mesh.points[v];
    mesh.may_be_outside[n] = mesh.may_be_outside[v];
    pending[n] = pending[v];
    row[v] = n++;
  }
  mesh.points.resize(n);
  mesh.may_be_outside.resize(n);
  pending.resize(n);
  for (Tetrahedron& t : mesh.tetrahedra)
    for (VertexIndex& v : t) v = row[v];
}

class StripImprover {
 public:
  StripImprover(RankMesh& mesh, const RankModel& model, const Ranks& ranks)
      : mesh_(mesh), model_(model), ranks_(ranks), pending_(mesh.points.size(), false) {}

  StripsResult run(const RefineOptions& options, const RunContext& context) {
    StripsResult result;
    for (unsigned round = 0; round < n_rounds; ++round) {
      const std::vector<VertexIndex> between = points_between_ranks(round == 0);
      const Sharers sharers = find_sharers(mesh_, between, ranks_);
      std::vector<std::int32_t> taker_at(mesh_.points.size(), nobody);
      const Takers takers(sharers, round);
      for (const VertexIndex v : between) taker_at[v] = takers.at(mesh_.points[v], sharers.at(mesh_.points[v]));
      result.n_tetrahedra += exchange_and_improve(takers_of_cells(std::move(taker_at)), options, context);
    }
    const std::vector<VertexIndex> left = points_between_ranks(false);
    const Sharers sharers = find_sharers(mesh_, left, ranks_);
    std::uint64_t n_own = 0;
    for (const VertexIndex v : left) n_own += sharers.at(mesh_.points[v]).front() == ranks_.rank();
    for (const std::uint64_t n : ranks_.gather_all(n_own)) result.n_never_free += n;
    return result;
  }

 private:
  bool is_model(const Triangle& t) const {
    Corners numbers;
    for (unsigned i = 0; i < 3; ++i) {
      numbers[i] = model_.points.number_at(mesh_.points[t[i]]);
      if (numbers[i] == ModelPoints::none) return false;
    }
    return model_.simplices.face_of(sorted_corners({numbers[0], numbers[1], numbers[2]})) != no_index;
  }

  /// Returns the corners of faces on borders between ranks, without faces on surfaces. The first round omits points of
  /// the model; later rounds return only points that were on a border between ranks in every round before.
  std::vector<VertexIndex> points_between_ranks(bool is_first) {
    const MeshFaces faces(mesh_, MeshFaces::Which::at_border);
    std::vector<bool> is_between(mesh_.points.size(), false);
    for (const OpenFace& f : faces.open)
      if (!is_model(f.vertices))
        for (const VertexIndex v : f.vertices) is_between[v] = true;
    std::vector<VertexIndex> found;
    for (VertexIndex v = 0; v < is_between.size(); ++v) {
      if (is_first) pending_[v] = is_between[v] && model_.points.number_at(mesh_.points[v]) == ModelPoints::none;
      pending_[v] = pending_[v] && is_between[v];
      if (is_first ? is_between[v] : pending_[v]) found.push_back(v);
    }
    return found;
  }

  /// Returns the rank that will improve each tetrahedron; `nobody` for tetrahedra that are more than `layers` layers
  /// away from a border between ranks. If several ranks are possible, the lowest improves the tetrahedron.
  std::vector<std::int32_t> takers_of_cells(std::vector<std::int32_t> taker_at) const {
    std::vector<std::int32_t> of_cell(mesh_.tetrahedra.size(), nobody);
    for (unsigned layer = 0; layer < layers; ++layer) {
      std::vector<Index> reached;
      for (Index c = 0; c < of_cell.size(); ++c) {
        if (of_cell[c] != nobody) continue;
        for (const VertexIndex v : mesh_.tetrahedra[c])
          if (taker_at[v] != nobody && (of_cell[c] == nobody || taker_at[v] < of_cell[c])) of_cell[c] = taker_at[v];
        if (of_cell[c] != nobody) reached.push_back(c);
      }
      std::vector<std::int32_t> next = taker_at;
      for (const Index c : reached)
        for (const VertexIndex v : mesh_.tetrahedra[c])
          if (taker_at[v] == nobody && (next[v] == nobody || of_cell[c] < next[v])) next[v] = of_cell[c];
      taker_at = std::move(next);
    }
    return of_cell;
  }

  /// Sends tetrahedra to the ranks that improve them. This rank improves those that it receives, and adds them to its
  /// mesh. Returns the number of received tetrahedra.
  std::size_t exchange_and_improve(const std::vector<std::int32_t>& takers, const RefineOptions& options,
                                   const RunContext& context) {
    const auto n_ranks = static_cast<std::size_t>(ranks_.size());
    std::vector<std::vector<Index>> to(n_ranks);
    for (Index c = 0; c < takers.size(); ++c)
      if (takers[c] != nobody) to[static_cast<std::size_t>(takers[c])].push_back(c);
    ParcelFiller filler(mesh_, pending_);
    std::vector<Bytes> bytes;
    std::vector<bool> is_known(mesh_.points.size(), false);
    for (const std::vector<Index>& cells : to) {
      Parcel parcel = filler.of(cells);
      Packer packer;
      packer(parcel);
      bytes.push_back(packer.take());
      for (const Index c : cells)
        for (const VertexIndex v : mesh_.tetrahedra[c]) is_known[v] = true;
    }
    Joiner joiner(mesh_, pending_);
    for (VertexIndex v = 0; v < is_known.size(); ++v) {
      if (is_known[v]) mesh_.may_be_outside[v] = 1;
      if (mesh_.may_be_outside[v]) joiner.know(v);
    }
    drop_taken(mesh_, takers);
    RankMesh strip;
    Pending strip_pending;
    Joiner strip_joiner(strip, strip_pending);
    for (const Bytes& came : ranks_.exchange(bytes)) {
      Parcel parcel;
      Unpacker unpacker(came);
      unpacker(parcel);
      strip_joiner.add(parcel);
    }
    const std::size_t n = strip.tetrahedra.size();
    if (n > 0) joiner.add(improved(std::move(strip), strip_pending, options, context));
    drop_unused_points(mesh_, pending_);
    return n;
  }

  /// Improves the tetrahedra of a strip beside a border between ranks. Points that do not move, as on the border of the
  /// strip, keep their mark as `pending`.
  Parcel improved(RankMesh strip, const Pending& pending, RefineOptions options, const RunContext& context) const {
    ByPlace<bool> was_pending;
    for (VertexIndex v = 0; v < pending.size(); ++v)
      if (pending[v]) was_pending[strip.points[v]] = true;
    TetrahedraPart part = with_model(std::move(strip), model_);
    options.refine = false;
    refine_part(part, model_.sparse.size, options, context);
    Parcel parcel;
    for (const Vec3& p : part.points) parcel.is_pending.push_back(was_pending.contains(p));
    parcel.points = std::move(part.points);
    parcel.may_be_outside = std::move(part.is_kept);
    parcel.tetrahedra = std::move(part.tetrahedra);
    parcel.component = std::move(part.component);
    return parcel;
  }

  RankMesh& mesh_;
  const RankModel& model_;
  const Ranks& ranks_;
  Pending pending_;
};

}  // namespace

StripsResult improve_strips(RankMesh& mesh, const RankModel& model, const RefineOptions& options, const Ranks& ranks,
                            const RunContext& context) {
  if (ranks.size() == 1) return {};
  return StripImprover(mesh, model, ranks).run(options, context);
}

}  // namespace geomesh::app
