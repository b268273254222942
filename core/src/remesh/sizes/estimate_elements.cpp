// SPDX-License-Identifier: MIT
// The number of elements before the work, declared in geomesh/core/refine.hpp and remesh/sizes/sizes.hpp.
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

/// From the integrals at a scale of the sizes, at twice and at four times that. Even sizes go with the inverse third
/// power of the scale, sizes that grow away from surfaces with the second, from curves with the first: the polynomial
/// through the integrals times the third power is taken at the scale 1. Never beyond the third and the first power.
double at_scale_one(const std::array<double, 3>& integrals, double scale) {
  const auto at = [&](unsigned k) { return integrals[k] * std::pow(std::ldexp(scale, static_cast<int>(k)), 3); };
  const double x = 1 / scale;  // of the least of the scales 1, 2, 4
  const double found = at(0) * (x - 2) * (x - 4) / 3 - at(1) * (x - 1) * (x - 4) / 2 + at(2) * (x - 1) * (x - 2) / 6;
  return std::clamp(found, integrals[0] * scale, integrals[0] * scale * scale * scale);
}

/// The elements, or a number of them that is more than enough. A field with too many small sizes to sample is
/// extrapolated from larger ones.
double elements_by_sizes(const DomainMesh& mesh, const SizeField& size, double enough) {
  constexpr double larger = 8;  // squared from try to try: sizes in other units are soon left behind
  constexpr std::size_t many_samples = 3'000'000, few_samples = 300'000;  // some seconds, and some tenths
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
  throw InternalError("a size field asks for small sizes at every scale");
}

}  // namespace

double estimate_elements(const DomainMesh& mesh, const SizeField& size, const RefineOptions& options, double enough) {
  // Cells about given points that stay there are there for their own sake.
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

/// "1,234,567", or "2.1e+13" beyond what anybody counts.
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
  throw Error(ErrorKind::cannot_mesh, "the sizes ask for about " + in_words(estimate) +
                                          " elements, more than the limit of " + in_words(static_cast<double>(limit)) +
                                          " (max_elements): sizes about " + with_three_digits(larger) +
                                          " times as large would do, or raise the limit");
}

/// Of the edges of the input, half are longer.
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

/// Far fewer elements may meet what is asked of the whole model, or where nothing is asked, what most edges of the
/// input ask for. The user is told before the work.
void warn_of_short_edges(const PiecewiseLinearComplex& plc, const DomainMesh& mesh, RefineOptions options,
                         const RunContext& context, RefineResult& result) {
  constexpr double many = 250'000, most = 2, short_edge = 0.1;  // of the middle one
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
      "short edges of the input ask for most of the " + in_words(estimate) + " elements or more to come; " +
      (has_size ? "the sizes asked for" : "a least size of " + with_three_digits(least) + " asks for") + " about " +
      in_words(without) +
      ": for fewer, ask for a least size, take no sizes from the input's edges, ask for sizes "
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
