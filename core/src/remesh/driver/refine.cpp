// SPDX-License-Identifier: MIT
#include "geomesh/core/refine.hpp"

#include <cstdio>
#include <limits>
#include <memory>
#include <string>
#include <utility>

#include "common/geometry.hpp"
#include "geomesh/core/element_estimate.hpp"
#include "geomesh/core/error.hpp"
#include "remesh/domain/domain_io.hpp"
#include "remesh/driver/hold_surfaces.hpp"
#include "remesh/sizes/sizes.hpp"

namespace geomesh {

namespace {

/// Largest permitted tolerance, as a share of the model's diagonal. A larger tolerance would leave only the bounding
/// box of most surfaces, and nearly every place of a surface would be close to every other.
constexpr double greatest_tolerance = 0.1;

std::string rounded(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", x);
  return text;
}

void check_tolerance(const PiecewiseLinearComplex& plc, double tolerance) {
  Box3 box;
  for (const Vec3& p : plc.points) box.add(p);
  const double diagonal = distance(box.min, box.max);
  if (tolerance > greatest_tolerance * diagonal)
    throw Error(ErrorKind::usage, "a tolerance of " + rounded(tolerance) +
                                      " is more than a tenth of the model's diagonal of " + rounded(diagonal) +
                                      ": little would be left of its surfaces. Choose a smaller one, in the model's "
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
  if (o.sparse_growth < 0 || !(o.sparse_ratio >= 1)) refuse("a sparse inside grows, and is no finer than requested");
  if (o.tolerance_share < 0) refuse("the share of the size that surfaces may be off cannot be negative");
  if (!o.facet_patch.empty() && o.facet_patch.size() != plc.n_facets())
    refuse("one patch must be given for each facet");
  if (!o.segment_curve.empty() && o.segment_curve.size() != plc.segments.size())
    refuse("one curve must be given for each segment");
  if (!o.facet_parent.empty() && o.facet_parent.size() != plc.n_facets())
    refuse("one parent must be given for each facet");
}

}  // namespace

struct ElementEstimator::Basis {
  const PiecewiseLinearComplex& plc;
  remesh::DomainMesh domain;
  remesh::SizeBasis sizes;
};

ElementEstimator::ElementEstimator(const PiecewiseLinearComplex& plc, const ConstrainedTetrahedralization& mesh,
                                   const RefineOptions& options) {
  check_options(plc, options);
  remesh::DomainMesh domain = remesh::import_domain(plc, mesh, options);
  remesh::SizeBasis sizes = remesh::size_basis(plc, domain, options);
  basis_ = std::make_unique<Basis>(Basis{plc, std::move(domain), std::move(sizes)});
}

ElementEstimator::ElementEstimator(ElementEstimator&&) noexcept = default;
ElementEstimator& ElementEstimator::operator=(ElementEstimator&&) noexcept = default;
ElementEstimator::~ElementEstimator() = default;

double ElementEstimator::total(const RefineOptions& options) const {
  return count(options, std::numeric_limits<double>::infinity());
}

bool ElementEstimator::is_above(double limit, const RefineOptions& options) const {
  return count(options, limit) > limit;
}

double ElementEstimator::count(const RefineOptions& options, double enough) const {
  check_options(basis_->plc, options);
  const remesh::DomainMesh& domain = basis_->domain;
  const remesh::LocalTolerance tolerance = remesh::allowed_tolerance(basis_->plc, domain, options);
  return remesh::estimate_elements(domain, remesh::build_size_field(basis_->sizes, domain, options, tolerance).all,
                                   options, enough);
}

ElementEstimate ElementEstimator::by_cause(const RefineOptions& options, std::size_t n_thin,
                                           std::optional<double> known_total) const {
  check_options(basis_->plc, options);
  const remesh::DomainMesh& domain = basis_->domain;
  const auto count = [&](const SizeField& size) { return remesh::estimate_elements(domain, size, options); };
  RefineOptions without_thin = options;
  without_thin.size.sources.erase(without_thin.size.sources.begin(),
                                  without_thin.size.sources.begin() + static_cast<std::ptrdiff_t>(n_thin));
  SizeField::Limits global;
  if (options.size.global > 0) global.global = options.size.global;
  const double by_volume = count(SizeField({}, global));
  const double by_name = count(remesh::sizes_asked_by_name(basis_->sizes, domain, without_thin));
  const double with_thin = n_thin > 0 ? count(remesh::sizes_asked_by_name(basis_->sizes, domain, options)) : by_name;
  const bool has_gaps = options.size.gap_layers > 0 || !options.size.component_layers.empty();
  std::optional<double> with_bends, total = known_total;
  if (has_gaps || !total) {
    const remesh::LocalTolerance tolerance = remesh::allowed_tolerance(basis_->plc, domain, options);
    const auto sizes = remesh::build_size_field(basis_->sizes, domain, options, tolerance);
    if (!total) total = count(sizes.all);
    if (has_gaps) with_bends = count(sizes.without_gaps);
  }
  if (!with_bends) with_bends = total;
  return {by_volume, by_name - by_volume, with_thin - by_name, *with_bends - with_thin, *total - *with_bends};
}

double estimate_elements(const PiecewiseLinearComplex& plc, const ConstrainedTetrahedralization& mesh,
                         const RefineOptions& options) {
  return ElementEstimator(plc, mesh, options).total(options);
}

namespace {

/// Runs repeat with smaller tolerances until surfaces are within the requested tolerance, at most `most_runs` times.
/// From run `first_run_that_keeps` on (counted from 0), facets are kept unchanged where the previous run failed.
constexpr unsigned first_run_that_keeps = 3, most_runs = 6;

RefineResult refine_within(const PiecewiseLinearComplex& plc, const ConstrainedTetrahedralization& input,
                           RefineOptions options, const RunContext& context) {
  options.facet_patch = remesh::named_patches(plc, options);
  remesh::Hold hold;
  std::size_t n_off = 0;
  std::vector<KeptPlace> kept;
  const auto told = [&](remesh::Attempt& attempt, std::size_t runs) {
    attempt.result.statistics.runs = runs;
    attempt.result.statistics.off_before = n_off;
    attempt.result.kept = kept;
    return std::move(attempt.result);
  };
  while (hold.run < most_runs) {
    remesh::Attempt attempt = remesh::attempt_holding(hold, plc, input, options, context);
    if (attempt.holds()) return told(attempt, hold.run + 1);
    remesh::tell_what_is_off(attempt, context);
    n_off += attempt.breaches.size() + attempt.crossings.size();
    if (hold.run + 1 >= first_run_that_keeps) {
      const std::vector<KeptPlace> more = remesh::keep_there(plc, attempt, options);
      if (more.empty()) break;
      kept.insert(kept.end(), more.begin(), more.end());
    }
    remesh::tighten(hold, attempt, options.tolerance);
  }
  options.honour = Honour::exact;
  remesh::Attempt exact = remesh::attempt_holding({}, plc, input, options, context);
  exact.result.all_kept = true;
  return told(exact, hold.run + 2);
}

}  // namespace

RefineResult refine_and_improve(const PiecewiseLinearComplex& plc, ConstrainedTetrahedralization input,
                                const RefineOptions& options, const RunContext& context) {
  check_options(plc, options);
  if (options.honour == Honour::exact)
    return remesh::attempt_holding({}, plc, std::move(input), options, context).result;
  return refine_within(plc, input, options, context);
}

}  // namespace geomesh
