// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/target_elements.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

#include "geomesh/geomodel/words.hpp"
#include "pipeline/refine_model.hpp"

namespace geomesh::geomodel {

namespace {

constexpr double near_enough = 0.1;
constexpr double infinity = std::numeric_limits<double>::infinity();

/// Elements go with the cube of the size; where surfaces take their share, with less.
double next_factor(double factor, double count, double target) { return factor * std::cbrt(count / target); }

/// Beyond it the tolerance that follows the sizes would be refused.
double greatest_factor(const PreparedModel& model, const RefineOptions& options) {
  constexpr double most_of_diagonal = 0.05;
  if (options.honour != Honour::tolerance || !(options.tolerance_share > 0)) return infinity;
  Box3 box;
  for (const Vec3& p : model.plc.plc.points) box.add(p);
  const Vec3 extent = box.max - box.min;
  return std::max(most_of_diagonal * std::sqrt(dot(extent, extent)) / options.tolerance, 1.0);
}

/// By the estimate alone; at most `most`, however many elements surfaces ask for that cross and touch all over.
double first_factor(const PreparedModel& model, const ConstrainedTetrahedralization& mesh, RefineOptions options,
                    double target, double most) {
  constexpr unsigned most_rounds = 6;
  constexpr double enough = 0.02;
  options.max_elements = std::max(options.max_elements, static_cast<std::size_t>(10 * target));
  double factor = 1;
  for (unsigned round = 0; round < most_rounds; ++round) {
    const double count = estimate_elements(model.plc.plc, mesh, scaled_sizes(options, factor));
    if (!(count > 0) || std::abs(count / target - 1) < enough) break;
    const double before = std::exchange(factor, std::min(next_factor(factor, count, target), most));
    if (factor == before) break;
  }
  return factor;
}

/// What the run promises is what it used, with the sizes and the tolerance of these options.
void settle(PreparedModel& model, const RefineOptions& options) {
  RefinementSettings& settings = model.refinement;
  settings.size.base.global = options.size.global;
  settings.tolerance = options.tolerance;
  auto input = nlohmann::ordered_json::parse(model.input_json, nullptr, false);
  if (input.is_discarded()) return;
  if (options.size.global > 0) input["mesh"]["size"] = options.size.global;
  if (options.honour == Honour::tolerance) input["mesh"]["tolerance"] = settings.tolerance + settings.tolerance_used;
  model.input_json = input.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace

RefineOptions with_derived_size(PreparedModel& model, const ConstrainedTetrahedralization& mesh, RefineOptions options,
                                const RunContext& context) {
  constexpr double many_more = 1.4, most_growth = 3;  // bends and gaps that ask for more shall be kept
  const RefinementSettings& settings = model.refinement;
  if (!settings.derive_size || settings.target_elements > 0) return options;
  RefineOptions counted = options;
  counted.max_elements = static_cast<std::size_t>(100 * settings.derived_elements);
  if (estimate_elements(model.plc.plc, mesh, counted) <= many_more * settings.derived_elements) return options;
  const double most = std::min(most_growth, greatest_factor(model, options));
  const double factor = first_factor(model, mesh, counted, settings.derived_elements, most);
  options = scaled_sizes(std::move(options), factor);
  settle(model, options);
  note(model.notes, context,
       "the model's surfaces ask for more elements than its volume: edges of about " +
           short_words(options.size.global) + " " + model.unit + " come to about " +
           short_words(settings.derived_elements) + " elements");
  return options;
}

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
  if (options.tolerance_share > 0) options.tolerance *= factor;
  return options;
}

RefineResult refine_to_count(PreparedModel& model, const ConstrainedTetrahedralization& mesh,
                             const RefineOptions& options, const RunContext& context) {
  constexpr unsigned most_runs = 4;
  const double target = model.refinement.target_elements;
  const double most = greatest_factor(model, options);
  double factor = first_factor(model, mesh, options, target, most);
  const std::vector<std::string> warnings = model.warnings;
  for (unsigned run = 1;; ++run) {
    model.warnings = warnings;
    const RefineOptions scaled = scaled_sizes(options, factor);
    RefineResult result = refine_model(model, mesh, scaled, context);
    const auto count = static_cast<double>(result.mesh.tetrahedra.size());
    const bool is_near = std::abs(count / target - 1) <= near_enough;
    if (!is_near && run < most_runs) {
      factor = std::min(next_factor(factor, count, target), most);
      continue;
    }
    if (!is_near)
      warn(model.warnings, context,
           "target_elements: " + short_words(count) + " elements came out and not " + short_words(target) +
               ", whatever the size: the surfaces alone ask for others");
    settle(model, scaled);
    note(model.notes, context, "target_elements: sizes are " + short_words(factor) + " times those asked for");
    return result;
  }
}

}  // namespace geomesh::geomodel
