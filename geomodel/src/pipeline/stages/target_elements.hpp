// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Sizes derived from a number of elements: all are scaled so that about that many result, and with them the tolerance
/// if it is a share of them.
#pragma once

#include "geomesh/core/element_estimate.hpp"
#include "pipeline/journal.hpp"
#include "pipeline/records.hpp"

namespace geomesh::geomodel {

/// Returns the options with all target sizes multiplied by `factor`, and the tolerance too if it follows them.
RefineOptions scaled_sizes(RefineOptions options, double factor);

/// Returns the settings with the sizes and the tolerance of these options, so that the reported ones are those that
/// were used.
RefinementSettings settings_used(RefinementSettings settings, const RefineOptions& options);

/// Options with the number of elements that they require.
struct CountedOptions {
  RefineOptions options;
  ElementEstimate estimate;
  RefinementSettings used;
  bool gaps_dropped = false;   ///< whether gaps require no sizes, because they would require too many elements
  double gradation_scale = 1;  ///< factor by which sizes grow faster than usual away from small ones
};

/// If the size was derived from the model's volume alone, and surfaces or a ground that cuts the volume lead to many
/// more or fewer elements, sizes are chosen so that the estimate is about settings.derived_elements. If larger sizes
/// give hardly fewer elements, sizes also grow faster away from small ones, unless the project sets the gradation. Gaps
/// between surfaces are ignored if the estimate is above twice that number with them and below it without them, unless
/// the project sets sizes for gaps. Otherwise, and if the project requests any size, the options are returned
/// unchanged.
CountedOptions with_derived_size(const ModelRecords& model, const ConstrainedTetrahedralization& mesh,
                                 RefineOptions options);

/// Notes before meshing how many elements to expect, and what requires them. `unit` is the unit of length. Throws
/// Error{cannot_mesh} with the same text if the number exceeds the limit.
void announce_count(const CountedOptions& counted, const std::string& unit, Journal& journal);

struct RefinedToCount {
  RefineResult result;
  RefinementSettings used;
};
/// Refines with sizes scaled by the estimate, and again by the resulting number of elements. If larger sizes give
/// hardly fewer elements, sizes grow faster away from small ones. Ends when the number is within a tenth of
/// settings.target_elements, or after six trials; the nearest is then used, with a warning that the input alone
/// requires more.
RefinedToCount refine_to_count(const ModelRecords& model, const ConstrainedTetrahedralization& mesh,
                               const RefineOptions& options, Journal& journal);

}  // namespace geomesh::geomodel
