// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The data of a horizon with throw, by the blocks of the faults across which it has it.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "geomesh/geomodel/model_rules.hpp"
#include "rules/framework/horizon_blocks.hpp"
#include "rules/throw/fault_crossings.hpp"

namespace geomesh::geomodel {

/// The blocks between the faults of these rows alone, with their continuations beyond their ends inside the model.
std::shared_ptr<const HorizonBlocks> blocks_between(const BuiltSurfaces& built, const ModelRules& rules,
                                                    const std::vector<Index>& faults);

/// Whose the triangles of a horizon are.
struct SortedTriangles {
  std::vector<Index> block;       ///< per triangle, or BuiltRows::of_every_block
  std::vector<bool> overshoots;   ///< per triangle: wholly beyond a fault at which it should have ended
  std::vector<bool> runs_across;  ///< per fault: a triangle crosses it that is of the blocks on both sides
};

/// The faults in the order of the result, the blocks between them, the box in which sheets go round their ends, and
/// what gives the blocks between all faults of the model, as if each went on through it.
struct SortingSetting {
  const std::vector<ThrowFault>& faults;
  const BlockFramework& framework;
  const Box3& box;
  std::function<const BlockFramework&()> framework_of_all;
};

/// Faults and their continuations cut the horizon's sheets into parts: what of a sheet hangs together in one block. Of
/// parts that hang together across faults the largest counts, as does the largest part in each block of the sheet that
/// has most of the block. All others overshoot the fault at which they should have ended. Where a part does not count,
/// blocks between all faults of the model are asked instead: a sheet that a fault out of the list parts from another
/// one has its own block. A triangle is of the blocks in which its parts count.
///
/// `sheet`: per triangle its sheet, or BuiltRows::of_every_block; empty: triangles that hang together by edges are one.
SortedTriangles sort_into_blocks(const TriangulatedSurface& horizon, const std::vector<Index>& sheet,
                                 const SortingSetting& setting);

}  // namespace geomesh::geomodel
