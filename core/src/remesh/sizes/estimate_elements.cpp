// SPDX-License-Identifier: MIT
// Estimates the number of elements before meshing. Declared in geomesh/core/refine.hpp and remesh/sizes/sizes.hpp.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include "common/geometry.hpp"
#include "geomesh/core/error.hpp"
#include "remesh/sizes/size_integrals.hpp"
#include "remesh/sizes/sizes.hpp"

namespace geomesh::remesh {

namespace {

/// Extrapolates from the integrals for sizes scaled by one, two and four times some factor. The number of elements for
/// constant sizes is proportional to the inverse third power of the scale; for sizes that grow away from surfaces the
/// power is two, from curves one. A polynomial through the three integrals times the third power is therefore evaluated
/// at the scale 1, limited to powers between one and three.
double at_scale_one(const std::array<double, 3>& integrals, double scale) {
  const auto at = [&](unsigned k) { return integrals[k] * std::pow(std::ldexp(scale, static_cast<int>(k)), 3); };
  const double x = 1 / scale;  // the scale 1 at which the polynomial is evaluated, as a multiple of the smallest scale
  const double found = at(0) * (x - 2) * (x - 4) / 3 - at(1) * (x - 1) * (x - 4) / 2 + at(2) * (x - 1) * (x - 2) / 6;
  return std::clamp(found, integrals[0] * scale, integrals[0] * scale * scale * scale);
}

/// Returns the estimated number of elements, or any number above `enough`. If the field has too many small sizes to be
/// sampled, it is extrapolated from larger ones.
double elements_by_sizes(const DomainMesh& mesh, const SizeField& size, double enough) {
  // Sizes that are too small to be sampled are enlarged 8, 64, 4096 ... times, because their unit may be wrong.
  constexpr double larger = 8;
  constexpr std::size_t many_samples = 3'000'000, few_samples = 300'000;  // size evaluations that take 1.5 s and 0.15 s
  if (const auto found = integrate_sizes(mesh, size, many_samples, enough)) return elements_of(*found);
  for (double scale = larger; std::isfinite(scale); scale *= scale) {
    const auto first = integrate_sizes(mesh, size.times(scale), few_samples);
    if (!first) continue;
    std::array<SizeIntegrals, 3> at{*first};
    for (unsigned k = 1; k < 3; ++k) {
      const auto next = integrate_sizes(mesh, size.times(std::ldexp(scale, static_cast<int>(k))), many_samples);
      GEOMESH_CHECK(next.has_value());
      at[k] = *next;
    }
    const auto extrapolated = [&](double SizeIntegrals::*one) {
      return at_scale_one({at[0].*one, at[1].*one, at[2].*one}, scale);
    };
    return elements_of({extrapolated(&SizeIntegrals::volume), extrapolated(&SizeIntegrals::surface),
                        extrapolated(&SizeIntegrals::fold)});
  }
  throw InternalError("a size field requests small sizes at every scale");
}

}  // namespace

double estimate_elements(const DomainMesh& mesh, const SizeField& size, const RefineOptions& options, double enough) {
  // Points of the input that are kept have cells around them in addition to those that the sizes require.
  constexpr double per_given_cell = 1.05;
  const double count = elements_by_sizes(mesh, size, enough);
  return options.honour == Honour::exact ? count + per_given_cell * static_cast<double>(mesh.n_cells()) : count;
}

namespace {

std::string with_three_digits(double x) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.3g", x);
  return text.data();
}

/// Formats a number as "1,234,567", or as "2.1e+13" if it is very large.
std::string in_words(double count) {
  constexpr double countable = 1e12;
  if (!(count < countable)) return with_three_digits(count);
  std::string digits = std::to_string(static_cast<long long>(count));
  for (std::size_t at = digits.size(); at > 3;) digits.insert(at -= 3, ",");
  return digits;
}

void check_estimate(double estimate, std::size_t limit) {
  if (estimate <= static_cast<double>(limit)) return;
  const double larger = std::cbrt(estimate / static_cast<double>(limit));
  throw Error(ErrorKind::cannot_mesh, "the sizes require about " + in_words(estimate) +
                                          " elements, more than the limit of " + in_words(static_cast<double>(limit)) +
                                          " (max_elements): sizes about " + with_three_digits(larger) +
                                          " times as large would do, or raise the limit");
}

/// Returns the median length of the input's edges.
double middle_edge(const PiecewiseLinearComplex& plc) {
  std::vector<double> lengths;
  for (Index l = 0; l + 1 < plc.loop_offsets.size(); ++l) {
    const auto loop = plc.loop(l);
    for (std::size_t k = 0; k < loop.size(); ++k)
      lengths.push_back(length(plc.points[loop[(k + 1) % loop.size()]] - plc.points[loop[k]]));
  }
  if (lengths.empty()) return 0;
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  return *middle;
}

/// Warns before meshing if far fewer elements would meet the size requested for the whole model, or, without such a
/// size, the length of most input edges.
void warn_of_short_edges(const PiecewiseLinearComplex& plc, const DomainMesh& mesh, RefineOptions options,
                         const RunContext& context, RefineResult& result) {
  constexpr double many = 250'000, most = 2, short_edge = 0.1;  // short_edge: as a share of the median length of edges
  const double estimate = result.statistics.estimated_elements;
  if (!options.size.from_input_edges || !sizes_surfaces(options) || estimate < many) return;
  const bool has_size = options.size.global > 0;
  const double least = short_edge * middle_edge(plc);
  if (has_size)
    options.size.from_input_edges = false;
  else
    options.size.min_size = std::max(options.size.min_size, least);
  const double without = estimate_elements(mesh, build_size_field(plc, mesh, options).all, options);
  if (estimate < most * without) return;
  result.warnings.push_back(
      "short edges of the input require most of the " + in_words(estimate) + " elements or more to come; " +
      (has_size ? "the requested sizes need" : "a least size of " + with_three_digits(least) + " needs") + " about " +
      in_words(without) +
      ": for fewer, set a least size, take no sizes from the input's edges, set sizes "
      "inside only, or allow surfaces a tolerance");
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
