// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Splits the name of a region in a file into its parts.
#pragma once

#include <set>
#include <string>

#include "check/specification/specification.hpp"

namespace geomesh::geomodel::checking {

/// The parts of a region's name such as `Chalk__B3__2`: base name, block and number.
struct NameParts {
  std::string base;
  std::size_t block = 0, number = 0;  ///< 0: none
};

/// Splits a region's name so that `base` is one of the known names, if possible.
NameParts parts_of(const std::string& name, const std::set<std::string>& known);

/// Returns all base names that a specification allows: units, neighbouring units joined by `+`, bodies and seeds.
std::set<std::string> names_of_specification(const Specification& specification);

}  // namespace geomesh::geomodel::checking
