// SPDX-License-Identifier: MIT
#include "geomesh/core/refine.hpp"

#include <cmath>
#include <cstdio>
#include <string>

#include "geomesh/core/error.hpp"
#include "remesh/domain/domain_io.hpp"
#include "remesh/driver/hold_surfaces.hpp"
#include "remesh/driver/keep_there.hpp"
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
  if (o.tolerance_share < 0) refuse("the share of the size that surfaces may be off cannot be negative");
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
  const SizeField sizes = remesh::build_size_field(plc, domain, options).all;
  return remesh::estimate_elements(domain, sizes, options);
}

namespace {

/// Runs that hold surfaces more and more closely; from this one on, facets are kept where the run before was off.
constexpr unsigned first_run_that_keeps = 3, most_runs = 6;

class HoldingRuns {
 public:
  HoldingRuns(const PiecewiseLinearComplex& plc, const RefineOptions& options, const RunContext& context)
      : plc_(plc), options_(options), context_(context) {
    options_.facet_patch = remesh::named_patches(plc, options);
  }

  RefineResult run(const ConstrainedTetrahedralization& input) {
    for (; hold_.run < most_runs;) {
      remesh::Attempt attempt = remesh::attempt_holding(hold_, plc_, input, options_, context_);
      if (attempt.holds()) return told(std::move(attempt.result), hold_.run + 1);
      remesh::tell_what_is_off(attempt, context_);
      off_before_ += attempt.breaches.size() + attempt.crossings.size();
      if (hold_.run + 1 >= first_run_that_keeps && !keep_more(attempt)) break;
      remesh::tighten(hold_, attempt, options_.tolerance);
    }
    return keep_all(input);
  }

 private:
  RefineResult told(RefineResult result, std::size_t runs) const {
    result.statistics.runs = runs;
    result.statistics.off_before = off_before_;
    result.kept = kept_;
    return result;
  }

  bool keep_more(const remesh::Attempt& attempt) {
    const std::vector<KeptPlace> more = remesh::keep_there(plc_, attempt, options_);
    kept_.insert(kept_.end(), more.begin(), more.end());
    return !more.empty();
  }

  RefineResult keep_all(const ConstrainedTetrahedralization& input) {
    options_.honour = Honour::exact;
    RefineResult result =
        told(remesh::attempt_holding(remesh::Hold{}, plc_, input, options_, context_).result, hold_.run + 2);
    result.all_kept = true;
    return result;
  }

  const PiecewiseLinearComplex& plc_;
  RefineOptions options_;
  const RunContext& context_;
  remesh::Hold hold_;
  std::size_t off_before_ = 0;
  std::vector<KeptPlace> kept_;
};

}  // namespace

RefineResult refine_and_improve(const PiecewiseLinearComplex& plc, ConstrainedTetrahedralization input,
                                const RefineOptions& options, const RunContext& context) {
  check_options(plc, options);
  if (options.honour == Honour::exact)
    return remesh::attempt_holding({}, plc, std::move(input), options, context).result;
  return HoldingRuns(plc, options, context).run(input);
}

}  // namespace geomesh
