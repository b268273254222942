// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Horizons with throw in the arranged soup: blocks and their continuations end at the faults between them.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "geomesh/geomodel/model_rules.hpp"
#include "rules/planar/pieces.hpp"

namespace geomesh::geomodel {

/// What parting works on and what it tells; all outlive the call.
struct Parting {
  WorkingSoup& soup;
  const std::vector<TriangulatedSurface>& surfaces;
  const BuiltRows& built;
  const ModelRules& rules;
  std::vector<double>& removed;  ///< area, per surface
  std::vector<std::string>& notes;
  std::vector<std::string>& warnings;
  /// Whether two places lie in one fault block.
  std::function<bool(const Vec3&, const Vec3&)> in_one_block;
};

/// Of each block's sheets and their continuation, what its faults part off goes. It stays where most of what was given
/// of it lies on the block's own side of each fault. Triangles of every block stay where one block keeps them. Nothing
/// happens to a horizon without blocks. Blocks that are fields are kept in their domains alone; Error{invalid_input}
/// where a field has nothing there.
void part_blocks(const Parting& parting, Index horizon);

/// Continuations of faults that only served to part blocks go, once all horizons are parted. Where blocks do not meet
/// across them, a warning tells the length and the place.
void remove_continuations(const Parting& parting);

}  // namespace geomesh::geomodel
