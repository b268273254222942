// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Sizes that follow from a number of elements: all are scaled so that about so many come out, and with them the
/// tolerance that is a share of them.
#pragma once

#include "pipeline/finish.hpp"

namespace geomesh::geomodel {

/// All asked sizes times `factor`, and the tolerance where it follows them.
RefineOptions scaled_sizes(RefineOptions options, double factor);

/// Where the size was derived from the model's volume alone and surfaces come to many more elements than that. The
/// sizes returned are those by which the estimate is about settings.derived_elements. Settings and the report's input
/// hold them.
RefineOptions with_derived_size(PreparedModel& model, const ConstrainedTetrahedralization& mesh, RefineOptions options,
                                const RunContext& context);

/// Refines with sizes scaled by the estimate, and again by what came out. Where larger sizes bring hardly fewer
/// elements, sizes grow sooner away from small ones. Ends when the number of elements is within a tenth of
/// settings.target_elements, or after six times. Then the nearest counts, with a warning: the input alone takes more.
RefineResult refine_to_count(PreparedModel& model, const ConstrainedTetrahedralization& mesh,
                             const RefineOptions& options, const RunContext& context);

}  // namespace geomesh::geomodel
