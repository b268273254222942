// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Derives target sizes from a number of elements: all sizes are scaled so that about that many elements result, and
/// with them the tolerance if it is a share of the size.
#pragma once

#include "geomesh/core/element_estimate.hpp"
#include "pipeline/journal.hpp"
#include "pipeline/records.hpp"

namespace geomesh::geomodel {

/// Returns the options with all target sizes multiplied by `factor`, and the tolerance too if it follows the sizes.
RefineOptions scaled_sizes(RefineOptions options, double factor);

/// Returns the mesh settings with the sizes and tolerance of `options`, so that the values used are reported.
RefinementSettings settings_used(RefinementSettings settings, const RefineOptions& options);

/// Refinement options with the number of elements that they require.
struct CountedOptions {
  RefineOptions options;
  ElementEstimate estimate;
  RefinementSettings used;
  bool gaps_dropped = false;   ///< whether gaps between surfaces are ignored, because they require too many elements
  double gradation_scale = 1;  ///< factor on the gradation, the growth of target sizes around small ones
};

/// Corrects a size that was derived from the model's volume alone. If surfaces, or a ground that cuts the volume, lead
/// to many more or fewer elements, sizes are chosen so that the estimated number is about settings.derived_elements. If
/// larger sizes give hardly fewer elements, sizes also grow faster away from small ones, unless the project sets the
/// gradation. Gaps between surfaces are ignored if the estimate is above twice that number with gaps and below it
/// without them, unless the project sets sizes for gaps. The options are unchanged if the project requests any size.
CountedOptions with_derived_size(const ModelRecords& model, const ConstrainedTetrahedralization& mesh,
                                 RefineOptions options);

/// Notes before meshing how many elements to expect, and which settings require them. `unit` is the unit of length.
/// Throws Error{cannot_mesh} with the same text if the number exceeds the limit.
void announce_count(const CountedOptions& counted, const std::string& unit, Journal& journal);

struct RefinedToCount {
  RefineResult result;
  RefinementSettings used;
};
/// Refines the mesh with sizes scaled so that the estimated number of elements meets settings.target_elements, and
/// again with sizes corrected by the resulting number. If larger sizes give hardly fewer elements, sizes grow faster
/// away from small ones. Ends when the number is within a tenth of the target, or after six trials; the nearest result
/// is then used, with a warning that the input alone requires more.
RefinedToCount refine_to_count(const ModelRecords& model, const ConstrainedTetrahedralization& mesh,
                               const RefineOptions& options, Journal& journal);

}  // namespace geomesh::geomodel
