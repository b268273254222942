// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The checks of inputs for implausible data, one function for each kind of doubt.
#pragma once

#include "plausibility/plausibility.hpp"

namespace geomesh::geomodel {

inline constexpr double foot = 0.3048;  // metres

/// The inputs of a project that are examined for implausible data.
struct Inspected {
  const Project& project;
  const ProjectInputs& inputs;
  const std::optional<Box3>& volume;
};

/// Finds surfaces and wells that lie entirely beside, above or below the model, or beside all other surfaces if the box
/// is a margin around the data. Suggests the exchange of coordinates, unit or direction that would move them inside.
void doubt_places(const Inspected& model, std::vector<Finding>& findings);

/// Finds a box many times as long as all horizons together, or, if the box is placed around the data, a horizon many
/// times as long as all others together, unless one of them says how it is extended.
void doubt_box_extent(const Inspected& model, std::vector<Finding>& findings);

/// Finds horizons that are lower and flatter than all others by the same factor, as if their heights had another unit.
void doubt_heights(const Inspected& model, std::vector<Finding>& findings);

/// Finds horizons that are vertical, faults that cover the map, bodies that are open inside the model or enclose
/// nothing, duplicate surfaces, and single vertices of horizons far above or below all neighbours.
void doubt_shapes(const Inspected& model, std::vector<Finding>& findings);

/// Finds horizons outside the stratigraphic column that fit into its order. Also finds a horizon that contradicts the
/// order but would fit if its heights were in feet (or in metres, for a project in feet).
void doubt_column(const Inspected& model, std::vector<Finding>& findings);

/// Formats a list of names, shortened as in "top, base and 3 more".
std::string few_of(const std::vector<std::string>& names);

}  // namespace geomesh::geomodel
