// SPDX-License-Identifier: MIT
// What the user is told of the estimate, declared in remesh/sizes/sizes.hpp.
#include <string>

#include "geomesh/core/error.hpp"
#include "remesh/sizes/sizes.hpp"

namespace geomesh::remesh {

namespace {

std::string in_words(double count) { return std::to_string(static_cast<long long>(count)); }

void check_estimate(double estimate, std::size_t limit) {
  if (estimate <= static_cast<double>(limit)) return;
  throw Error(ErrorKind::cannot_mesh, "the sizes ask for about " + in_words(estimate) +
                                          " elements, more than the limit of " + std::to_string(limit) +
                                          "; ask for larger sizes, a steeper gradation, or raise the limit");
}

/// The size of the whole model may be met by far fewer elements than the edges of the input ask for. The user is told
/// before the work.
void warn_of_short_edges(const PiecewiseLinearComplex& plc, const DomainMesh& mesh, RefineOptions options,
                         const RunContext& context, RefineResult& result) {
  constexpr double many = 250'000, most = 2;
  const double estimate = result.statistics.estimated_elements;
  if (!(options.size.global > 0) || !options.size.from_input_edges || !sizes_surfaces(options) || estimate < many)
    return;
  options.size.from_input_edges = false;
  const double without = estimate_elements(mesh, build_size_field(plc, mesh, options).all, options);
  if (estimate < most * without) return;
  result.warnings.push_back(
      "short edges of the input ask for most of the " + in_words(estimate) +
      " elements or more to come; the sizes asked for about " + in_words(without) +
      ": for fewer, ask for a least size, take no sizes from the input's edges, ask for sizes inside only, or allow "
      "surfaces a tolerance");
  context.note(LogLevel::warning, result.warnings.back());
}

}  // namespace

void announce_estimate(const PiecewiseLinearComplex& plc, const DomainMesh& mesh, const RefineOptions& options,
                       const RunContext& context, RefineResult& result) {
  result.statistics.estimated_elements = estimate_elements(mesh, result.size_field, options);
  context.note(LogLevel::info, "about " + in_words(result.statistics.estimated_elements) + " elements to come");
  warn_of_short_edges(plc, mesh, options, context, result);
  check_estimate(result.statistics.estimated_elements, options.max_elements);
}

}  // namespace geomesh::remesh
