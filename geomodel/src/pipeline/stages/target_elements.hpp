// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Sizes that follow from a number of elements: all are scaled so that about so many come out, and with them the
/// tolerance that is a share of them.
#pragma once

#include "geomesh/core/element_estimate.hpp"
#include "pipeline/journal.hpp"
#include "pipeline/records.hpp"

namespace geomesh::geomodel {

/// All asked sizes times `factor`, and the tolerance where it follows them.
RefineOptions scaled_sizes(RefineOptions options, double factor);

/// The settings with the sizes and the tolerance of these options: what the run promises is what it used.
RefinementSettings settings_used(RefinementSettings settings, const RefineOptions& options);

/// Options with the number of elements that they ask for.
struct CountedOptions {
  RefineOptions options;
  ElementEstimate estimate;
  RefinementSettings used;
  bool gaps_dropped = false;   ///< gaps ask for no sizes, because they would ask for too many elements
  double gradation_scale = 1;  ///< how many times as fast as usual sizes grow away from where they are small
};

/// Where the size was derived from the model's volume alone, and surfaces or a ground that cuts the volume come to many
/// more or fewer elements: the sizes are those by which the estimate is about settings.derived_elements. Where larger
/// sizes bring hardly fewer elements, sizes grow sooner away from small ones, unless the project says how soon. Gaps
/// between surfaces ask for no sizes where the estimate is above twice that with them and below without them, unless
/// the project says what they ask for. Otherwise, and where the project asks for any size, the options are returned as
/// they are.
CountedOptions with_derived_size(const ModelRecords& model, const ConstrainedTetrahedralization& mesh,
                                 RefineOptions options);

/// Notes before the work how many elements will come, and what asks for them. `unit` is that of lengths. Throws
/// Error{cannot_mesh} with the same words where that is more than the limit.
void announce_count(const CountedOptions& counted, const std::string& unit, Journal& journal);

struct RefinedToCount {
  RefineResult result;
  RefinementSettings used;
};
/// Refines with sizes scaled by the estimate, and again by what came out. Where larger sizes bring hardly fewer
/// elements, sizes grow sooner away from small ones. Ends when the number of elements is within a tenth of
/// settings.target_elements, or after six times. Then the nearest counts, with a warning: the input alone takes more.
RefinedToCount refine_to_count(const ModelRecords& model, const ConstrainedTetrahedralization& mesh,
                               const RefineOptions& options, Journal& journal);

}  // namespace geomesh::geomodel
