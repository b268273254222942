// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The kinds of doubts, one function each.
#pragma once

#include "plausibility/plausibility.hpp"

namespace geomesh::geomodel {

inline constexpr double foot = 0.3048;  // metres

/// What the functions look at.
struct Inspected {
  const Project& project;
  const ProjectInputs& inputs;
  const std::optional<Box3>& volume;
};

/// Surfaces and wells that lie wholly beside, above or below the model, or (where a margin about the data makes it)
/// beside all other surfaces: with the exchange, unit or direction that would bring them in.
void doubt_places(const Inspected& model, std::vector<Finding>& findings);

/// A box many times as long as all horizons together, or, in one laid about the data, a horizon many times as long as
/// all others together, unless one of them says how it is extended.
void doubt_box_extent(const Inspected& model, std::vector<Finding>& findings);

/// Horizons that are as much lower and more level than all others as if their heights were in another unit.
void doubt_heights(const Inspected& model, std::vector<Finding>& findings);

/// Horizons that stand upright, faults that cover the map, bodies that are open inside the model or enclose nothing,
/// surfaces that are given twice, single vertices of horizons far above or below all neighbours.
void doubt_shapes(const Inspected& model, std::vector<Finding>& findings);

/// Horizons that stand in no column and yet lie in the order of its horizons, and one that lies against that order but
/// would not if its heights were in feet (or in metres, in a project in feet).
void doubt_column(const Inspected& model, std::vector<Finding>& findings);

/// "top, base and 3 more".
std::string few_of(const std::vector<std::string>& names);

}  // namespace geomesh::geomodel
