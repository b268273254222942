// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What settling a stack changed, with areas, moves and thicknesses.
#pragma once

#include "geomesh/geomodel/stack.hpp"
#include "stack/sheets/sheet_approximation.hpp"

namespace geomesh::geomodel {

/// Names and counts of triangles are left to the caller.
SettledStack describe_settled(const MapSheets& sheets, const MapSamples& samples, const std::vector<ThinArea>& areas,
                              const MapBounds& bounds, const SheetOptions& options);

/// A sentence a horizon that was moved and a unit that thins out.
std::vector<std::string> notes_of(const SettledStack& stack);

}  // namespace geomesh::geomodel
