// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Writes the report's section on horizons that were put in order: thickness maps with pinch-outs, and changes.
#pragma once

#include <string>

#include "geomesh/geomodel/stack.hpp"

namespace geomesh::geomodel::page {

/// `unit`: of lengths.
std::string stack_section(const SettledStack& stack, const std::string& unit);

}  // namespace geomesh::geomodel::page
