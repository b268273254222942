// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Which of two horizons truncates the other, and the order of all horizons at one place of the map.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "geomesh/geomodel/model_rules.hpp"

namespace geomesh::geomodel {

/// Bit k is set if horizons k and k + 1 of the stack coincide at a place.
using MergedPairs = std::uint64_t;
inline constexpr std::size_t most_horizons = std::numeric_limits<MergedPairs>::digits;

/// Which horizon of a pair keeps its place where the two cross or coincide; the other one moves.
enum class Keeper { younger, older };

/// For each pair of horizons of a stack, neighbours or not, which of them keeps its place.
class Keepers {
 public:
  Keepers() = default;
  Keepers(std::size_t n_horizons, Keeper of_all) : n_(n_horizons), of_pairs_(n_horizons * n_horizons, of_all) {}
  /// Returns the keeper of the neighbours `pair` and `pair` + 1.
  Keeper operator[](std::size_t pair) const { return of(pair, pair + 1); }
  Keeper of(std::size_t younger, std::size_t older) const { return of_pairs_[younger * n_ + older]; }
  void set(std::size_t younger, std::size_t older, Keeper keeper) { of_pairs_[younger * n_ + older] = keeper; }
  bool operator==(const Keepers&) const = default;

 private:
  std::size_t n_ = 0;
  std::vector<Keeper> of_pairs_{};
};

/// Returns which of two horizons keeps its place where they cross. `rows` are rows of surfaces, youngest first. In
/// descending priority: the topography and the base of the model, a horizon at which the other's field ends, a younger
/// one that erodes, an older one that is onlapped. Otherwise `on_crossing` and `thin_layers` decide; by default the
/// younger one is kept.
Keepers keepers_of(const ModelRules& rules, const std::vector<Index>& rows,
                   const std::vector<TriangulatedSurface>& surfaces);

/// Puts the heights of a stack, youngest first, into order: each is at least `gap` above the next older horizon that is
/// present, or equal to it if the pair is merged. NaN: the horizon is absent. Horizons are processed in order of
/// deposition, oldest first: each one rises onto older ones that keep their place, then those that do not are lowered
/// below it. O(n^2) at most.
void settle_column(std::span<double> heights, MergedPairs merged, const Keepers& keepers, double gap);

}  // namespace geomesh::geomodel
