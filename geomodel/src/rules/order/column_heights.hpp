// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Which of two horizons cuts the other, and the order of all of them at one place of the map.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geomesh/geomodel/model_rules.hpp"

namespace geomesh::geomodel {

/// Bit k: horizons k and k + 1 of the stack share one surface there.
using MergedPairs = std::uint64_t;
inline constexpr std::size_t most_horizons = 64;

/// Which horizon of a pair stays where the two cross or share one surface; the other gives way.
enum class Keeper { younger, older };

/// Who stays, for each pair of a stack's horizons, neighbours or not.
class Keepers {
 public:
  Keepers() = default;
  Keepers(std::size_t n_horizons, Keeper of_all) : n_(n_horizons), of_pairs_(n_horizons * n_horizons, of_all) {}
  /// Of the neighbours `pair` and `pair` + 1.
  Keeper operator[](std::size_t pair) const { return of(pair, pair + 1); }
  Keeper of(std::size_t younger, std::size_t older) const { return of_pairs_[younger * n_ + older]; }
  void set(std::size_t younger, std::size_t older, Keeper keeper) { of_pairs_[younger * n_ + older] = keeper; }
  bool operator==(const Keepers&) const = default;

 private:
  std::size_t n_ = 0;
  std::vector<Keeper> of_pairs_{};
};

/// Tells which of two horizons stays where they cross. `rows`: of surfaces, youngest first. The topography and the
/// bottom of the model stay, then a horizon at which the other's field ends, then a younger one that erodes, then an
/// older one that is onlapped. Else `on_crossing` and `thin_layers` tell; the younger one stays by default.
Keepers keepers_of(const ModelRules& rules, const std::vector<Index>& rows,
                   const std::vector<TriangulatedSurface>& surfaces);

/// Brings the heights of a stack, youngest first, into order: each is at least `gap` above the next older one that is
/// there, or equal to it where the pair is merged. NaN: the horizon is not there. Horizons come as they were laid down,
/// oldest first: each rises onto older ones that stay, then those that do not stay sink below it. O(n^2) at most.
void settle_column(std::span<double> heights, MergedPairs merged, const Keepers& keepers, double gap);

}  // namespace geomesh::geomodel
