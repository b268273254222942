// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Horizons made of several scalar fields, each of which is valid on certain sides of faults.
#pragma once

#include <functional>
#include <vector>

#include "rules/blocks/part_blocks.hpp"

namespace geomesh::geomodel {

/// Makes the triangles of each field of horizon `s` a block that ends at the faults in SurfaceRules::throw_at. Sets the
/// horizon's entries in `built.rows`; part_blocks() then cuts the blocks off at the faults. Throws Error{invalid_input}
/// if a field is valid only above or below a vertical fault, which has no upper side.
void part_by_fields(BuiltSurfaces& built, std::size_t s, const ModelRules& rules);

/// Identifies one of the fields of a horizon by the index of the surface and the index in SurfaceRules::field_parts.
struct FieldOfHorizon {
  Index horizon, part;
};

/// For each piece of the level set of a field, returns whether it lies in the field's domain: in the fault block named
/// by the rules, else on the sides of faults that `is_on_own_side` accepts. Throws Error{invalid_input} if no piece
/// does, or if two fields of the horizon are valid in one block. Warns if the surface continues around the end of a
/// fault that bounds the domain.
std::vector<bool> pieces_in_domain(const Parting& parting, FieldOfHorizon field, const std::vector<Piece>& pieces,
                                   const std::function<bool(const Piece&)>& is_on_own_side);

}  // namespace geomesh::geomodel
