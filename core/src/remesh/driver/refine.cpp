// SPDX-License-Identifier: MIT
#include "geomesh/core/refine.hpp"

#include <cmath>
#include <cstdio>
#include <string>

#include "geomesh/core/error.hpp"
#include "remesh/domain/domain_io.hpp"
#include "remesh/driver/hold_surfaces.hpp"
#include "remesh/sizes/sizes.hpp"

namespace geomesh {

namespace {

/// Of the model's diagonal: beyond it nothing but the box would be left of most surfaces, and nearly every place of one
/// is near to every other.
constexpr double greatest_tolerance = 0.1;

double diagonal_of(const std::vector<Vec3>& points) {
  Box3 box;
  for (const Vec3& p : points) box.add(p);
  const Vec3 extent = box.max - box.min;
  return std::sqrt(dot(extent, extent));
}

std::string rounded(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", x);
  return text;
}

void check_tolerance(const PiecewiseLinearComplex& plc, double tolerance) {
  const double diagonal = diagonal_of(plc.points);
  if (tolerance > greatest_tolerance * diagonal)
    throw Error(ErrorKind::usage, "a tolerance of " + rounded(tolerance) +
                                      " is more than a tenth of the model's diagonal of " + rounded(diagonal) +
                                      ": little would be left of its surfaces. Ask for a smaller one, in the model's "
                                      "units: a thousandth of the diagonal, " +
                                      rounded(0.001 * diagonal) + ", is a good start");
}

void check_options(const PiecewiseLinearComplex& plc, const RefineOptions& o) {
  const auto refuse = [](const std::string& what) { throw Error(ErrorKind::usage, what); };
  if (!(o.size.gradation > 0)) refuse("the gradation of sizes must be positive");
  if (o.size.global < 0 || o.size.min_size < 0 || o.size.max_size < 0) refuse("a size cannot be negative");
  if (o.honour == Honour::tolerance && !(o.tolerance > 0))
    refuse("honouring surfaces to a tolerance needs a distance above 0");
  if (o.honour == Honour::tolerance) check_tolerance(plc, o.tolerance);
  if (!o.facet_patch.empty() && o.facet_patch.size() != plc.n_facets())
    refuse("one patch must be given for each facet");
  if (!o.segment_curve.empty() && o.segment_curve.size() != plc.segments.size())
    refuse("one curve must be given for each segment");
  if (!o.facet_parent.empty() && o.facet_parent.size() != plc.n_facets())
    refuse("one parent must be given for each facet");
}

}  // namespace

double estimate_elements(const PiecewiseLinearComplex& plc, const ConstrainedTetrahedralization& mesh,
                         const RefineOptions& options) {
  check_options(plc, options);
  const remesh::DomainMesh domain = remesh::import_domain(plc, mesh, options);
  const SizeField sizes = remesh::build_size_field(plc, domain, options, remesh::size_tolerance(options)).all;
  return remesh::estimate_elements(domain, sizes, options);
}

RefineResult refine_and_improve(const PiecewiseLinearComplex& plc, ConstrainedTetrahedralization input,
                                const RefineOptions& options, const RunContext& context) {
  check_options(plc, options);
  if (options.honour == Honour::exact)
    return remesh::attempt_holding({}, plc, std::move(input), options, context).result;
  constexpr unsigned most_attempts = 6;
  remesh::Hold hold;
  std::size_t off_before = 0;
  for (;;) {
    remesh::Attempt attempt = remesh::attempt_holding(hold, plc, input, options, context);
    attempt.result.statistics.runs = hold.run + 1;
    attempt.result.statistics.off_before = off_before;
    if (attempt.holds()) return std::move(attempt.result);
    if (hold.run + 1 == most_attempts) remesh::refuse_tolerance(attempt);
    remesh::tighten(hold, attempt, options.tolerance);
    off_before += attempt.breaches.size() + attempt.crossings.size();
    remesh::tell_what_is_off(attempt, context);
  }
}

}  // namespace geomesh
