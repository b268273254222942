// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/target_elements.hpp"

#include <algorithm>
#include <cmath>

#include "geomesh/geomodel/words.hpp"
#include "pipeline/refine_model.hpp"

namespace geomesh::geomodel {

namespace {

constexpr double near_enough = 0.1;

/// Elements go with the cube of the size; where surfaces take their share, with less.
double next_factor(double factor, double count, double target) { return factor * std::cbrt(count / target); }

/// By the estimate alone.
double first_factor(const PreparedModel& model, const ConstrainedTetrahedralization& mesh, RefineOptions options,
                    double target) {
  constexpr unsigned most_rounds = 6;
  constexpr double enough = 0.02;
  options.max_elements = std::max(options.max_elements, static_cast<std::size_t>(10 * target));
  double factor = 1;
  for (unsigned round = 0; round < most_rounds; ++round) {
    const double count = estimate_elements(model.plc.plc, mesh, scaled_sizes(options, factor));
    if (!(count > 0) || std::abs(count / target - 1) < enough) break;
    factor = next_factor(factor, count, target);
  }
  return factor;
}

}  // namespace

RefineOptions scaled_sizes(RefineOptions options, double factor) {
  SizeOptions& size = options.size;
  size.global *= factor;
  size.min_size *= factor;
  size.max_size *= factor;
  for (double& s : size.component_size) s *= factor;
  for (AskedSize& s : size.patch_size) s.size *= factor;
  for (AskedSize& s : size.segment_size) s.size *= factor;
  for (SizeSource& s : size.sources) s.size *= factor;
  if (size.background)
    size.background = [background = size.background, factor](const Vec3& p) { return factor * background(p); };
  if (options.tolerance_share > 0) options.tolerance *= std::min(1.0, factor);  // never more than the project says
  return options;
}

RefineResult refine_to_count(PreparedModel& model, const ConstrainedTetrahedralization& mesh,
                             const RefineOptions& options, const RunContext& context) {
  constexpr unsigned most_runs = 4;
  const double target = model.refinement.target_elements;
  double factor = first_factor(model, mesh, options, target);
  const std::vector<std::string> warnings = model.warnings;
  for (unsigned run = 1;; ++run) {
    model.warnings = warnings;
    const RefineOptions scaled = scaled_sizes(options, factor);
    RefineResult result = refine_model(model, mesh, scaled, context);
    const auto count = static_cast<double>(result.mesh.tetrahedra.size());
    const bool is_near = std::abs(count / target - 1) <= near_enough;
    if (!is_near && run < most_runs) {
      factor = next_factor(factor, count, target);
      continue;
    }
    if (!is_near)
      warn(model.warnings, context,
           "target_elements: " + short_words(count) + " elements came out and not " + short_words(target) +
               ", whatever the size: the surfaces alone ask for others");
    note(model.notes, context, "target_elements: sizes are " + short_words(factor) + " times those asked for");
    return result;
  }
}

}  // namespace geomesh::geomodel
