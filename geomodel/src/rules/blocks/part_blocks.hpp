// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Horizons with throw in the arranged soup: blocks end at the faults between them, and steps join them beyond the ends
/// of these.
#pragma once

#include <string>
#include <vector>

#include "geomesh/geomodel/model_rules.hpp"
#include "rules/planar/pieces.hpp"

namespace geomesh::geomodel {

/// The input and output data of part_blocks, which divides horizons into blocks. All of it must outlive the call.
struct Parting {
  WorkingSoup& soup;
  const std::vector<TriangulatedSurface>& surfaces;
  const BuiltRows& built;
  const ModelRules& rules;
  std::vector<double>& removed;  ///< area, per surface
  std::vector<std::string>& notes;
  std::vector<std::string>& warnings;
};

/// Of each block's triangles those pieces are removed that lie, for most of their area, in another block of
/// BuiltRows::throw_blocks; of the triangles of a field, those in blocks in which it does not hold. Nothing happens to
/// a horizon without blocks. Throws Error{invalid_input} where a field has nothing in its domain.
void part_blocks(const Parting& parting, Index horizon);

/// Continuations of faults that only served to part blocks are removed, once all horizons are parted. Where the blocks
/// of a horizon do not meet at one, what of it lies between them becomes a step of the horizon (add_steps). That is
/// told, with a warning where the throw does not die out, or where no such step closes the horizon.
void remove_continuations(const Parting& parting);

}  // namespace geomesh::geomodel
