// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Cuts horizons with throw in the arranged soup, so that blocks and their extensions end at the faults between them.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "geomesh/geomodel/model_rules.hpp"
#include "rules/planar/pieces.hpp"

namespace geomesh::geomodel {

/// Input and output of part_blocks(), which divides horizons into blocks. All referenced data must outlive the call.
struct Parting {
  WorkingSoup& soup;
  const std::vector<TriangulatedSurface>& surfaces;
  const BuiltRows& built;
  const ModelRules& rules;
  std::vector<double>& removed;  ///< area, per surface
  std::vector<std::string>& notes;
  std::vector<std::string>& warnings;
  std::function<bool(const Vec3&, const Vec3&)> in_one_block;
};

/// Removes the parts of a horizon's blocks and of their extensions that faults cut off from the block. A part is kept
/// if most of its original area lies on the block's side of each fault. Triangles that belong to every block are kept
/// if one block keeps them. Horizons without blocks are not changed. Blocks made of scalar fields are kept only in the
/// domains of the fields. Throws Error{invalid_input} if a field has no surface in its domain.
void part_blocks(const Parting& parting, Index horizon);

/// Removes the extensions of faults that were made only to separate blocks, after all horizons were divided. If blocks
/// do not meet where such an extension was, a warning gives the length and position of the gap.
void remove_continuations(const Parting& parting);

}  // namespace geomesh::geomodel
