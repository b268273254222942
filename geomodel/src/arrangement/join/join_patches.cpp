// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrangement/join/join_patches.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "common/union_find.hpp"

namespace geomesh::geomodel::arrangement {

namespace {

/// Sides of the model volume are numbered after the input surfaces.
std::size_t rows_in_use(const Complex& complex) {
  std::size_t n = 0;
  for (const Origin& o : complex.origins.items) n = std::max<std::size_t>(n, o.surface + std::size_t{1});
  return n;
}

/// Patches (edge-connected facets) of surfaces that may be merged, treated as if each were a surface of its own.
class Patches {
 public:
  Patches(const Complex& complex, const std::vector<std::uint8_t>& may_join)
      : n_surfaces_(rows_in_use(complex)), joined_(complex.origins.items.size()) {
    struct OriginAtEdge {
      Index surface;
      VertexIndex a, b;
      Index row;  ///< of the origin
    };
    std::vector<OriginAtEdge> sides;
    for (Index f = 0; f < complex.facets.size(); ++f)
      for (Index row = complex.origins.offsets[f]; row < complex.origins.offsets[f + 1]; ++row) {
        const Index surface = complex.origins.items[row].surface;
        if (surface >= may_join.size() || !may_join[surface]) continue;
        for (std::size_t k = 0; k < 3; ++k) {
          const auto [a, b] = std::minmax(complex.facets[f][k], complex.facets[f][(k + 1) % 3]);
          sides.push_back({surface, a, b, row});
        }
      }
    const auto edge = [](const OriginAtEdge& s) { return std::tie(s.surface, s.a, s.b); };
    std::sort(sides.begin(), sides.end(),
              [&](const OriginAtEdge& s, const OriginAtEdge& t) { return edge(s) < edge(t); });
    for (std::size_t k = 1; k < sides.size(); ++k)
      if (edge(sides[k]) == edge(sides[k - 1])) joined_.unite(sides[k - 1].row, sides[k].row);
    number(sides.empty() ? std::vector<Index>{} : rows_of(sides), complex);
  }

  bool are_several() const { return !pairs_.empty(); }
  const std::set<SurfacePair>& pairs() const { return pairs_; }
  Index of_row(Index row) const { return patch_of_row_[row]; }
  Index surface_of(Index patch) const { return patch < n_surfaces_ ? patch : surface_[patch - n_surfaces_]; }

 private:
  template <class Sides>
  static std::vector<Index> rows_of(const Sides& sides) {
    std::vector<Index> rows;
    for (const auto& s : sides) rows.push_back(s.row);
    std::sort(rows.begin(), rows.end());
    rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
    return rows;
  }

  void number(const std::vector<Index>& rows, const Complex& complex) {
    patch_of_row_.resize(complex.origins.items.size());
    for (Index row = 0; row < patch_of_row_.size(); ++row) patch_of_row_[row] = complex.origins.items[row].surface;
    std::map<Index, Index> number;
    std::map<Index, std::vector<Index>> of_surface;
    for (const Index row : rows) {
      const Index surface = complex.origins.items[row].surface;
      const auto [at, is_new] =
          number.try_emplace(joined_.find(row), static_cast<Index>(n_surfaces_ + surface_.size()));
      if (is_new) {
        surface_.push_back(surface);
        of_surface[surface].push_back(at->second);
      }
      patch_of_row_[row] = at->second;
    }
    for (const auto& [surface, patches] : of_surface)
      for (std::size_t i = 0; i < patches.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) pairs_.insert(surface_pair(patches[i], patches[j]));
  }

  std::size_t n_surfaces_;
  UnionFind joined_;                 ///< rows of origins
  std::vector<Index> patch_of_row_;  ///< patch of each origin (input triangle), or its surface if that has no patches
  std::vector<Index> surface_;       ///< surface of each patch; patches are numbered from n_surfaces_ on
  std::set<SurfacePair> pairs_;      ///< pairs of patches that belong to one surface
};

/// Restores the origins (input triangles) of facets as they were before each patch counted as a surface.
void give_surfaces_back(Complex& complex, const Patches& patches) {
  edit_origins(complex, [&](Index, std::vector<Origin>& of) {
    for (Origin& o : of) o.surface = patches.surface_of(o.surface);
  });
}

}  // namespace

SnapOutcome join_patches(Complex& complex, const std::vector<std::uint8_t>& may_join, double distance,
                         const std::optional<Box3>& box, std::vector<VertexIndex>& vertex_now) {
  vertex_now.resize(complex.points.size());
  std::iota(vertex_now.begin(), vertex_now.end(), VertexIndex{0});
  const Patches patches(complex, may_join);
  if (!patches.are_several()) return {};
  for (Index row = 0; row < complex.origins.items.size(); ++row)
    complex.origins.items[row].surface = patches.of_row(row);
  SnapOptions snapping{distance, box, MoveToBox::none, JoinRule(std::set<SurfacePair>{})};
  snapping.rule.join_all_of(patches.pairs());
  SnapOutcome outcome = snap_near(complex, std::vector<std::uint8_t>(complex.facets.size(), 1), snapping, &vertex_now);
  for (VanishedFacet& v : outcome.vanished)
    for (Index& surface : v.surfaces) surface = patches.surface_of(surface);
  give_surfaces_back(complex, patches);
  return outcome;
}

}  // namespace geomesh::geomodel::arrangement
