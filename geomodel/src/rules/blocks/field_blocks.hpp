// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Horizons of several fields, each of which holds in some of the fault blocks.
#pragma once

#include "rules/blocks/part_blocks.hpp"
#include "rules/extend/extend.hpp"

namespace geomesh::geomodel {

/// Finds the blocks between the faults in SurfaceRules::throw_at in which each field of horizon `row` holds, for
/// part_blocks to cut its surface off there. Sets the horizon's rows in `built.rows`. Throws Error{invalid_input} where
/// a field holds above or below a fault that is upright, so that neither of its sides is the upper one, and where two
/// fields hold in the block of one place. Warns where a fault that bounds a domain ends inside of it.
void part_by_fields(BuiltSurfaces& built, Index row, const ModelRules& rules, const BuildLog& log);

/// Identifies one of the fields of a horizon by the row of the surface and the row in SurfaceRules::field_parts.
struct FieldOfHorizon {
  Index horizon, part;
};

/// Throws Error{invalid_input}: nothing of the field's surface, of which one place is told, lies in its domain.
[[noreturn]] void refuse_field_outside(const Parting& parting, FieldOfHorizon field, const Vec3& place);

}  // namespace geomesh::geomodel
