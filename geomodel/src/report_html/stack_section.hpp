// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The settled stack on the page: thickness maps with pinch-out lines, and what was changed.
#pragma once

#include <string>

#include "geomesh/geomodel/stack.hpp"

namespace geomesh::geomodel::page {

/// `unit`: of lengths.
std::string stack_section(const SettledStack& stack, const std::string& unit);

}  // namespace geomesh::geomodel::page
