// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// A region's name as it stands in a file, taken apart.
#pragma once

#include <set>
#include <string>

#include "check/claim/claim.hpp"

namespace geomesh::geomodel::checking {

/// `Chalk__B3__2`: base, block, number.
struct NameParts {
  std::string base;
  std::size_t block = 0, number = 0;  ///< 0: none
};

/// Taken apart so that `base` is one of the names known, where that can be.
NameParts parts_of(const std::string& name, const std::set<std::string>& known);

/// Units of the column, neighbouring units joined by `+`, bodies, seeds.
std::set<std::string> names_of_claim(const Claim& claim);

}  // namespace geomesh::geomodel::checking
