// SPDX-License-Identifier: MIT
/// @file
/// Attempts at recovery, and how each differs from those before it. Nearly all models need only the first attempt. In
/// other models it reaches a dead end: a Steiner point near which no double leaves all cells positive.
#pragma once

#include <optional>

#include "geomesh/core/tetrahedralize.hpp"
#include "recover/start/hard_parts_first.hpp"

namespace geomesh {

enum class SteinerPlaces {
  /// Steiner points have double coordinates from the start. For conforming mode and single attempts; may fail.
  rounded,
  /// Steiner points are exactly on their segments and facets until everything is recovered, and are rounded at the end,
  /// so that recovery always terminates.
  exact,
};

enum class InsertionOrder {
  all_at_once,  ///< all vertices of the model are inserted before anything is recovered
  /// Items that earlier attempts found hard are recovered first, and the other vertices are inserted afterwards.
  hard_parts_first,
};

struct Attempt {
  unsigned number = 0;  ///< number of the attempt, from 0; also the seed of random choices
  SteinerPlaces places = SteinerPlaces::rounded;
  InsertionOrder order = InsertionOrder::all_at_once;

  /// Returns a short text for the log: how this attempt at recovery differs from those before it.
  const char* difference() const;
};

/// Returns the settings of attempt `number`. `hard_parts` contains what earlier attempts have found hard to recover.
Attempt attempt_of(unsigned number, const RecoverOptions& options, const recover::HardPartsFirst& hard_parts);

/// Returns the settings of the next attempt at recovery; nothing if this was the last one allowed.
std::optional<Attempt> attempt_after(const Attempt& attempt, const RecoverOptions& options,
                                     const recover::HardPartsFirst& hard_parts);

}  // namespace geomesh
