// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// How far an arrangement is from what was given.
#pragma once

#include <optional>

#include "arrangement/model/complex.hpp"

namespace geomesh::geomodel::arrangement {

/// The farthest corner of a facet from the surfaces that it is part of; sides of a volume, of rows beyond those given,
/// do not count. Nothing where some facet is not proven to be nowhere farther than that and a hundredth more, or a
/// millionth of the model. O(n log n).
std::optional<Displacement> distance_from_given(const Complex& complex, const std::vector<TriangulatedSurface>& given);

}  // namespace geomesh::geomodel::arrangement
