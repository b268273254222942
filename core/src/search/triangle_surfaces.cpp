// SPDX-License-Identifier: MIT
#include "search/triangle_surfaces.hpp"

#include <utility>

#include "common/geometry.hpp"

namespace geomesh::search {

TriangleSurfaces::TriangleSurfaces(std::vector<Piece> pieces, std::size_t n_groups, std::vector<Vec3> normals)
    : trees_(std::move(pieces), n_groups), normals_(std::move(normals)) {
  const bool are_lines = trees_.items().empty() || trees_.items()[0].corners[1] == trees_.items()[0].corners[2];
  if (!are_lines) open_edges_ = find_open_edges(trees_.items());
}

bool TriangleSurfaces::within(const Corners& triangle, Index group, double limit, Index& over) const {
  auto& [prover, nearby, rows] = scratch_.local();
  nearby.clear();
  rows.clear();
  prover.set_limit(limit);
  trees_.for_each_row_in(box_about(triangle, limit), group, [&, &nearby = nearby, &rows = rows](Index row) {
    nearby.push_back({&trees_.prepared(row), open_edges_[row]});
    rows.push_back(row);
  });
  const bool is_within = prover.is_within(triangle, nearby);
  over = prover.sheet_row() == no_index ? no_index : trees_.items()[rows[prover.sheet_row()]].id;
  return is_within;
}

void TriangleSurfaces::within(std::span<DistanceQuestion> questions) const {
  CoverProver prover(trees_, 0, open_edges_);
  for (DistanceQuestion& q : questions) {
    prover.set_limit(q.limit);
    q.answer = prover.judge(q.item, q.group);
  }
}

bool TriangleSurfaces::is_even(const Box3& box, Index group, double least_cosine) const {
  Vec3 sum;
  Index n = 0;
  const auto visit = [&](const auto& what) {
    trees_.for_each_in(box, group, [&](const Piece& piece) { what(normals_[piece.id]); });
  };
  visit([&](const Vec3& normal) { sum = sum + normal, ++n; });
  const double least = least_cosine * length(sum);
  bool is_even = n > 0;
  visit([&](const Vec3& normal) { is_even &= dot(normal, sum) >= least; });
  return is_even;
}

}  // namespace geomesh::search
