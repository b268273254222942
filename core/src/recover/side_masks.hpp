// SPDX-License-Identifier: MIT
/// @file
/// On which side of the plane of three vertices each of up to 64 vertices lies, as bit masks; each triple is decided once, exactly.
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "recover/constrained_mesh.hpp"

namespace geomesh::recover {

/// Number of a vertex among those of one polyhedron, below 64.
using LocalVertex = std::uint8_t;
using LocalTriangle = std::array<LocalVertex, 3>;
using VertexMask = std::uint64_t;

constexpr VertexMask bit(LocalVertex v) { return VertexMask{1} << v; }
constexpr VertexMask mask_of(const LocalTriangle& t) { return bit(t[0]) | bit(t[1]) | bit(t[2]); }

class SideMasks {
 public:
  static constexpr std::size_t max_vertices = 64;

  /// `vertices`: at most max_vertices, in the mesh's numbering.
  SideMasks(const ConstrainedMesh& mesh, const std::vector<VertexIndex>& vertices)
      : mesh_(mesh), vertices_(vertices), row_(triples(vertices.size()), 0) {}

  /// Vertices v for which (t, v) is positive.
  VertexMask above(const LocalTriangle& t) { return sides(t).first; }
  /// Vertices v for which (t, v) is negative.
  VertexMask below(const LocalTriangle& t) { return sides(t).second; }
  /// Sign of (a, b, c, d), as -1, 0, 1.
  int sign(LocalVertex a, LocalVertex b, LocalVertex c, LocalVertex d) {
    const auto [above, below] = sides({a, b, c});
    return above & bit(d) ? 1 : below & bit(d) ? -1 : 0;
  }

 private:
  using Masks = std::pair<VertexMask, VertexMask>;
  static std::size_t triples(std::size_t n) { return n * (n - 1) * (n - 2) / 6; }

  Masks sides(const LocalTriangle& t) {
    LocalTriangle s = t;
    bool odd = false;
    const auto order = [&](unsigned i, unsigned j) {
      if (s[i] <= s[j]) return;
      std::swap(s[i], s[j]);
      odd = !odd;
    };
    order(0, 1);
    order(1, 2);
    order(0, 1);
    const std::size_t i = s[0], j = s[1], k = s[2];
    std::uint32_t& row = row_[k * (k - 1) * (k - 2) / 6 + j * (j - 1) / 2 + i];
    if (row == 0) {
      known_.push_back(decide(s));
      row = static_cast<std::uint32_t>(known_.size());
    }
    const Masks& m = known_[row - 1];
    return odd ? Masks{m.second, m.first} : m;
  }
  Masks decide(const LocalTriangle& t) const {
    Masks out{0, 0};
    for (LocalVertex v = 0; v < vertices_.size(); ++v) {
      if (mask_of(t) & bit(v)) continue;
      const Sign s = mesh_.orient(vertices_[t[0]], vertices_[t[1]], vertices_[t[2]], vertices_[v]);
      if (s == Sign::positive) out.first |= bit(v);
      if (s == Sign::negative) out.second |= bit(v);
    }
    return out;
  }

  const ConstrainedMesh& mesh_;
  const std::vector<VertexIndex>& vertices_;
  std::vector<std::uint32_t> row_;  ///< of each sorted triple in known_, plus 1; 0 where not decided yet
  std::vector<Masks> known_;
};

}  // namespace geomesh::recover
