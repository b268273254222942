// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Decides which of two horizons truncates the other, and puts the heights of all horizons at a place in order.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geomesh/geomodel/model_rules.hpp"

namespace geomesh::geomodel {

/// Set of pairs of horizons that coincide at a place: bit k stands for horizons k and k + 1 of the stack.
using MergedPairs = std::uint64_t;
inline constexpr std::size_t most_horizons = 64;

/// The horizon of a pair that keeps its height where the two cross or coincide; the other one moves.
enum class Keeper { younger, older };

/// For each pair of horizons of a stack, whether neighbours or not, which of the two keeps its height.
class Keepers {
 public:
  Keepers() = default;
  Keepers(std::size_t n_horizons, Keeper of_all) : n_(n_horizons), of_pairs_(n_horizons * n_horizons, of_all) {}
  /// Returns which of the neighbouring horizons `pair` and `pair` + 1 keeps its height.
  Keeper operator[](std::size_t pair) const { return of(pair, pair + 1); }
  Keeper of(std::size_t younger, std::size_t older) const { return of_pairs_[younger * n_ + older]; }
  void set(std::size_t younger, std::size_t older, Keeper keeper) { of_pairs_[younger * n_ + older] = keeper; }
  bool operator==(const Keepers&) const = default;

 private:
  std::size_t n_ = 0;
  std::vector<Keeper> of_pairs_{};
};

/// Returns for each pair of horizons which of the two keeps its height where they cross. `rows` are indices of
/// surfaces, youngest first. In descending priority: the topography and the base of the model, a horizon at which the
/// other one's field ends, a younger horizon that erodes, an older one that is onlapped. Otherwise `on_crossing` and
/// `thin_layers` decide; by default the younger one is kept.
Keepers keepers_of(const ModelRules& rules, const std::vector<Index>& rows,
                   const std::vector<TriangulatedSurface>& surfaces);

/// Puts the heights of a stack of horizons, youngest first, into order. Each is then at least `gap` above the next
/// older horizon that is present, or equal to it if the pair is merged. The height NaN means that the horizon is
/// absent. Horizons are processed in order of deposition, oldest first: each one rises onto older horizons that keep
/// their height, then the other older ones are lowered below it. O(n^2) at most.
void settle_column(std::span<double> heights, MergedPairs merged, const Keepers& keepers, double gap);

}  // namespace geomesh::geomodel
