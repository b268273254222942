// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared_points.hpp"

#include <algorithm>

#include "geomesh/core/error.hpp"
#include "geomesh/core/simplex_mesh.hpp"

namespace geomesh::app {

namespace {

std::size_t keeper_of(const Vec3& p, const Ranks& ranks) {
  return PlaceHash{}(p) / 7 % static_cast<std::size_t>(ranks.size());
}

/// A face by its corners' positions, ascending; `even`: whether this is an even permutation of the cell's order.
struct PlacedFace {
  std::array<Vec3, 3> places;
  std::uint32_t even;
  Index component;
  bool same_place(const PlacedFace& o) const { return places == o.places; }
};

PlacedFace placed(const RankMesh& mesh, const OpenFace& face) {
  PlacedFace f{{mesh.points[face.vertices[0]], mesh.points[face.vertices[1]], mesh.points[face.vertices[2]]},
               1,
               mesh.component[face.cell]};
  for (unsigned pass = 0; pass < 2; ++pass)
    for (unsigned i = 0; i < 2; ++i)
      if (is_before(f.places[i + 1], f.places[i])) {
        std::swap(f.places[i], f.places[i + 1]);
        f.even ^= 1u;
      }
  return f;
}

bool is_before(const PlacedFace& a, const PlacedFace& b) {
  for (unsigned i = 0; i < 3; ++i)
    if (!(a.places[i] == b.places[i])) return app::is_before(a.places[i], b.places[i]);
  return false;
}

}  // namespace

Sharers find_sharers(const RankMesh& mesh, const std::vector<VertexIndex>& rows, const Ranks& ranks) {
  const auto n_ranks = static_cast<std::size_t>(ranks.size());
  std::vector<std::vector<Vec3>> asked(n_ranks);
  for (const VertexIndex v : rows) asked[keeper_of(mesh.points[v], ranks)].push_back(mesh.points[v]);
  const std::vector<std::vector<Vec3>> came = ranks.exchange(asked);
  Sharers at;
  for (std::size_t r = 0; r < n_ranks; ++r)
    for (const Vec3& p : came[r]) at[p].push_back(static_cast<std::int32_t>(r));  // the ranks at a place are ascending
  // Answers, in the order of each rank's questions: how many ranks share the point, and which.
  std::vector<std::vector<std::int32_t>> answers(n_ranks);
  for (std::size_t r = 0; r < n_ranks; ++r)
    for (const Vec3& p : came[r]) {
      const std::vector<std::int32_t>& who = at[p];
      answers[r].push_back(static_cast<std::int32_t>(who.size()));
      answers[r].insert(answers[r].end(), who.begin(), who.end());
    }
  const std::vector<std::vector<std::int32_t>> told = ranks.exchange(answers);
  Sharers sharers;
  for (std::size_t r = 0; r < n_ranks; ++r) {
    std::size_t k = 0;
    for (const Vec3& p : asked[r]) {
      const auto n = static_cast<std::size_t>(told[r].at(k));
      const auto first = told[r].begin() + static_cast<std::ptrdiff_t>(k + 1);
      sharers[p].assign(first, first + static_cast<std::ptrdiff_t>(n));
      k += n + 1;
    }
  }
  return sharers;
}

std::vector<Across> match_faces(const RankMesh& mesh, const std::vector<OpenFace>& faces, const Ranks& ranks) {
  const auto n_ranks = static_cast<std::size_t>(ranks.size());
  std::vector<std::vector<PlacedFace>> asked(n_ranks);
  // for each face, the rank that compares the faces of all ranks there, and the face's position in the message to it
  std::vector<std::pair<std::size_t, std::size_t>> sent;
  for (const OpenFace& face : faces) {
    const PlacedFace f = placed(mesh, face);
    const std::size_t keeper = keeper_of(f.places[0], ranks);
    sent.emplace_back(keeper, asked[keeper].size());
    asked[keeper].push_back(f);
  }
  const std::vector<std::vector<PlacedFace>> came = ranks.exchange(asked);
  struct Use {
    const PlacedFace* face;
    std::size_t rank, place;
  };
  std::vector<Use> uses;
  std::vector<std::vector<Across>> answers(n_ranks);
  for (std::size_t r = 0; r < n_ranks; ++r) {
    answers[r].resize(came[r].size());
    for (std::size_t k = 0; k < came[r].size(); ++k) uses.push_back({&came[r][k], r, k});
  }
  std::stable_sort(uses.begin(), uses.end(), [](const Use& a, const Use& b) { return is_before(*a.face, *b.face); });
  for (std::size_t i = 0, j; i < uses.size(); i = j) {
    for (j = i; j < uses.size() && uses[j].face->same_place(*uses[i].face);) ++j;
    if (j - i > 2) throw InternalError("a face of three tetrahedra between ranks");
    if (j - i < 2) continue;
    const Use &a = uses[i], &b = uses[i + 1];
    if (a.face->even == b.face->even) throw InternalError("two tetrahedra on one side of a face between ranks");
    answers[a.rank][a.place] = {static_cast<std::int32_t>(b.rank), b.face->component};
    answers[b.rank][b.place] = {static_cast<std::int32_t>(a.rank), a.face->component};
  }
  const std::vector<std::vector<Across>> told = ranks.exchange(answers);
  std::vector<Across> across;
  for (const auto& [keeper, place] : sent) across.push_back(told[keeper].at(place));
  return across;
}

}  // namespace geomesh::app
