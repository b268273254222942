// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Splits the name of a region in a file into its parts.
#pragma once

#include <set>
#include <string>

#include "check/specification/specification.hpp"

namespace geomesh::geomodel::checking {

/// The parts of `Chalk__B3__2`: base, block, number.
struct NameParts {
  std::string base;
  std::size_t block = 0, number = 0;  ///< 0: none
};

/// Splits the name so that `base` is one of the known names, if possible.
NameParts parts_of(const std::string& name, const std::set<std::string>& known);

/// Returns the names of units of the column, of neighbouring units joined by `+`, of bodies and of seeds.
std::set<std::string> names_of_specification(const Specification& specification);

}  // namespace geomesh::geomodel::checking
