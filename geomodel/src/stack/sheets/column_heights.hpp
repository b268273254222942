// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The order of a stack's horizons at one place of the map.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace geomesh::geomodel {

/// Bit k: horizons k and k + 1 of the stack share one surface there.
using MergedPairs = std::uint64_t;
inline constexpr std::size_t most_horizons = 64;

/// Which horizon of a pair stays where the two cross or share one surface; the other gives way.
enum class Keeper { younger, older };

/// Brings the heights of a stack, youngest first, into order: each is at least `gap` above the next older one that is
/// there, or equal to it where the pair is merged. NaN: the horizon is not there. Where keepers contradict each other
/// the younger one wins. `keepers` has one entry a pair.
void settle_column(std::span<double> heights, MergedPairs merged, const std::vector<Keeper>& keepers, double gap);

}  // namespace geomesh::geomodel
