// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// `target_elements`: all sizes are scaled so that about so many elements come out.
#pragma once

#include "pipeline/finish.hpp"

namespace geomesh::geomodel {

/// All asked sizes times `factor`, and below 1 the tolerance that follows them.
RefineOptions scaled_sizes(RefineOptions options, double factor);

/// Refines with sizes scaled by the estimate, and again by what came out. Ends when the number of elements is within a
/// tenth of settings.target_elements, or after four times; warns where it is not then, as where the input alone takes
/// more.
RefineResult refine_to_count(PreparedModel& model, const ConstrainedTetrahedralization& mesh,
                             const RefineOptions& options, const RunContext& context);

}  // namespace geomesh::geomodel
