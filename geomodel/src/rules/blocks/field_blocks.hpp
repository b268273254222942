// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Horizons of several fields, each of which holds on certain sides of faults.
#pragma once

#include <functional>
#include <vector>

#include "rules/blocks/part_blocks.hpp"

namespace geomesh::geomodel {

/// Makes the triangles of each field of horizon `s` a block that ends at the faults in SurfaceRules::throw_at. Sets the
/// horizon's rows in `built.rows`; part_blocks then cuts the blocks off at the faults. Throws Error{invalid_input}
/// where a field holds above or below a fault that is upright, so that neither of its sides is the upper one.
void part_by_fields(BuiltSurfaces& built, std::size_t s, const ModelRules& rules);

/// One of the fields of a horizon: rows of the surface and of SurfaceRules::field_parts.
struct FieldOfHorizon {
  Index horizon, part;
};

/// Per piece of the surface of a field, whether it lies in the field's domain: in its fault block, else as
/// `is_on_own_side` says of the sides of faults. Throws Error{invalid_input} where no piece does, or where two fields
/// of the horizon hold in one block. Warns where the surface goes round the end of a fault that bounds the domain.
std::vector<bool> pieces_in_domain(const Parting& parting, FieldOfHorizon field, const std::vector<Piece>& pieces,
                                   const std::function<bool(const Piece&)>& is_on_own_side);

}  // namespace geomesh::geomodel
