// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Sizes that follow from a number of elements: all are scaled so that about so many come out, and with them the
/// tolerance that is a share of them.
#pragma once

#include "geomesh/core/element_estimate.hpp"
#include "pipeline/finish.hpp"

namespace geomesh::geomodel {

/// All asked sizes times `factor`, and the tolerance where it follows them.
RefineOptions scaled_sizes(RefineOptions options, double factor);

/// Options with the number of elements that they ask for.
struct CountedOptions {
  RefineOptions options;
  ElementEstimate estimate;
  bool gaps_dropped = false;   ///< gaps ask for no sizes, because they would ask for too many elements
  double gradation_scale = 1;  ///< how many times as fast as usual sizes grow away from where they are small
};

/// Where the size was derived from the model's volume alone, and surfaces or a ground that cuts the volume come to many
/// more or fewer elements: the sizes are those by which the estimate is about settings.derived_elements, and settings
/// and the report's input hold them. Where larger sizes bring hardly fewer elements, sizes grow sooner away from small
/// ones, unless the project says how soon. Gaps between surfaces ask for no sizes where the estimate is above twice
/// that with them and below without them, unless the project says what they ask for. Otherwise, and where the project
/// asks for any size, the options are returned as they are.
CountedOptions with_derived_size(PreparedModel& model, const ConstrainedTetrahedralization& mesh,
                                 RefineOptions options);

/// Notes before the work how many elements will come, and what asks for them. Throws Error{cannot_mesh} with the same
/// words where that is more than the limit.
void announce_count(PreparedModel& model, const CountedOptions& counted, const RunContext& context);

/// Refines with sizes scaled by the estimate, and again by what came out. Where larger sizes bring hardly fewer
/// elements, sizes grow sooner away from small ones. Ends when the number of elements is within a tenth of
/// settings.target_elements, or after six times. Then the nearest counts, with a warning: the input alone takes more.
RefineResult refine_to_count(PreparedModel& model, const ConstrainedTetrahedralization& mesh,
                             const RefineOptions& options, const RunContext& context);

}  // namespace geomesh::geomodel
