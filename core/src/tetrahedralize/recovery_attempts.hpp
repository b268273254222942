// SPDX-License-Identifier: MIT
/// @file
/// Attempts at recovery, and what each does otherwise than those before it. Nearly all models need the first alone;
/// others end in a dead end there, where a Steiner point has no double near it that leaves all cells positive.
#pragma once

#include <optional>

#include "geomesh/core/tetrahedralize.hpp"
#include "recover/start/hard_parts_first.hpp"

namespace geomesh {

enum class SteinerPlaces {
  rounded,  ///< doubles from the moment they are made, which may end in a dead end: conforming mode, and one attempt
            ///< alone
  exact,    ///< exactly on their segments and facets until all is recovered, rounded at the end: recovery always ends
};

enum class InsertionOrder {
  all_at_once,       ///< the start triangulation has all vertices
  hard_parts_first,  ///< what earlier attempts found hard is recovered first, the other vertices are put beside it
};

struct Attempt {
  unsigned number = 0;  ///< from 0; also the seed of what is chosen at random
  SteinerPlaces places = SteinerPlaces::rounded;
  InsertionOrder order = InsertionOrder::all_at_once;

  /// How it differs from those before it, in a few words.
  const char* difference() const;
};

/// The attempt of that number, given what those before it have learned.
Attempt attempt_of(unsigned number, const RecoverOptions& options, const recover::HardPartsFirst& hard_parts);

/// The one after `attempt`; nothing after the last.
std::optional<Attempt> attempt_after(const Attempt& attempt, const RecoverOptions& options,
                                     const recover::HardPartsFirst& hard_parts);

}  // namespace geomesh
