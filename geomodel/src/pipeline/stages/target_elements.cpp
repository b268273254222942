// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/stages/target_elements.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "geomesh/geomodel/sizes_in_range.hpp"
#include "geomesh/geomodel/words.hpp"
#include "pipeline/stages/refine_model.hpp"
#include "report/announcement.hpp"

namespace geomesh::geomodel {

namespace {

constexpr double near_enough = 1.1;  // factor
/// Factor by which the number of elements may exceed the number from which sizes were derived. Above 200,000 elements
/// the first mesh of a model takes too long.
constexpr double most_over_target = 2;
constexpr double infinity = std::numeric_limits<double>::infinity();

/// Returns the factor on the target sizes for the next trial. The number of elements is proportional to the inverse
/// cube of the size, or to a lower power if most elements are near surfaces with short edges.
double next_factor(double factor, double count, double target) { return factor * std::cbrt(count / target); }

Box3 bounds_of(const Arranged& model) {
  Box3 box;
  for (const Vec3& p : model.plc.plc.points) box.add(p);
  return box;
}

/// Returns the largest factor on the target sizes. The tolerance follows the sizes, and would be refused if this factor
/// were larger.
double greatest_factor(const Arranged& model, const RefineOptions& options) {
  constexpr double most_of_diagonal = 0.05;
  if (options.honour != Honour::tolerance || !(options.tolerance_share > 0)) return infinity;
  const Box3 box = bounds_of(model);
  const Vec3 extent = box.max - box.min;
  return std::max(most_of_diagonal * std::sqrt(dot(extent, extent)) / options.tolerance, 1.0);
}

/// Returns the largest useful factor on the target sizes. Sizes several times as long as those that fill an empty box
/// with the requested number of elements leave the mesh unchanged; only the tolerance, which follows the sizes, would
/// grow.
double factor_of_empty_volume(const Arranged& model, const RefineOptions& options, double target) {
  constexpr double most = 7;
  return options.size.global > 0 ? most * derived_size(bounds_of(model), target) / options.size.global : infinity;
}

/// Factors on the target sizes, and on how fast sizes grow with the distance from small ones.
struct Scale {
  double size = 1, gradation = 1;
};

struct Try {
  Scale scale;
  double count = 0;  ///< of elements
};

/// Searches for the factors on sizes and gradation with which the requested number of elements results.
class CountSearch {
 public:
  /// `target` is the requested number of elements; `most` has the largest tried factors on sizes and gradation.
  CountSearch(double target, const Scale& most) : target_(target), most_(most) {}

  bool is_near(const Try& t, double factor) const { return t.count <= factor * target_ && t.count * factor >= target_; }
  bool is_nearer(const Try& t, const Try& than) const {
    return std::abs(std::log(t.count / target_)) < std::abs(std::log(than.count / target_));
  }

  /// Returns the factors for the next trial. If a larger size gives hardly fewer elements, most of them are near
  /// surfaces that require short edges; sizes are then allowed to grow as fast as possible away from these. Between
  /// trials with too many and too few elements, factors are interpolated as in a power law.
  Scale after(const std::vector<Try>& tries) const {
    const Try& now = tries.back();
    const auto [many, few] = nearest_on_both_sides(tries);
    if (many && few) {
      const double share = std::log(many->count / target_) / std::log(many->count / few->count);
      const auto between = [&](double from, double to) { return from * std::pow(to / from, share); };
      return {between(many->scale.size, few->scale.size), between(many->scale.gradation, few->scale.gradation)};
    }
    const bool may_grow_sooner = now.count > target_ && now.scale.gradation < most_.gradation;
    const double power = power_of_size(tries);
    if (may_grow_sooner && (now.scale.size >= most_.size || power < 1))
      return {tries.size() > 1 ? std::min(tries[tries.size() - 2].scale.size, now.scale.size) : now.scale.size,
              most_.gradation};
    const double larger = now.scale.size * std::pow(now.count / target_, 1 / power);
    return {std::min(larger, most_.size), now.scale.gradation};
  }

 private:
  std::pair<const Try*, const Try*> nearest_on_both_sides(const std::vector<Try>& tries) const {
    const Try *many = nullptr, *few = nullptr;
    for (const Try& t : tries) {
      const Try*& side = t.count > target_ ? many : few;
      if (!side || is_nearer(t, *side)) side = &t;
    }
    return {many, few};
  }

  /// Returns the exponent with which the number of elements decreases with the size, from the last two trials. It is
  /// three in a free volume, and lower if surfaces determine the number.
  static double power_of_size(const std::vector<Try>& tries) {
    constexpr double least = 0.5, of_volume = 3;
    if (tries.size() < 2) return of_volume;
    const Try &before = tries[tries.size() - 2], &now = tries.back();
    if (now.scale.gradation != before.scale.gradation || !(now.count > 0)) return of_volume;
    const double power = std::log(before.count / now.count) / std::log(now.scale.size / before.scale.size);
    return std::clamp(power, least, of_volume);
  }

  double target_;
  Scale most_;
};

/// With this gradation sizes double from one element to the next, which is the limit for solvers.
constexpr double steepest_gradation = 1;

Scale greatest_scale(const Arranged& model, const RefineOptions& options, double target) {
  return {std::min(greatest_factor(model, options), factor_of_empty_volume(model, options, target)),
          std::max(steepest_gradation / options.size.gradation, 1.0)};
}

RefineOptions scaled(const RefineOptions& options, const Scale& scale) {
  RefineOptions out = scaled_sizes(options, scale.size);
  out.size.gradation *= scale.gradation;
  return out;
}

constexpr unsigned most_tries = 6;

/// Returns the factors on target sizes and gradation whose estimated number of elements is nearest to the requested
/// one. The factor 1 is accepted if its estimate is within a factor of `near` of the request, else the first of at most
/// six trials that is near enough, or the nearest of them.
Try scale_by_estimate(const ElementEstimator& estimator, const RefineOptions& options, const CountSearch& search,
                      double near) {
  std::vector<Try> tries;
  Try best;
  Scale scale;
  while (tries.size() < most_tries) {
    tries.push_back({scale, estimator.total(scaled(options, scale))});
    const Try& now = tries.back();
    if (tries.size() == 1 || search.is_nearer(now, best)) best = now;
    if (!(now.count > 0) || search.is_near(best, tries.size() == 1 ? near : near_enough)) break;
    const Scale next = search.after(tries);
    if (next.size == scale.size && next.gradation == scale.gradation) break;
    scale = next;
  }
  return best;
}

/// Returns the factor on the target sizes, at most `most`, with which the estimated number of elements meets the
/// requested one. The limit matters for surfaces that cross and touch everywhere, where no size meets it. The gradation
/// is unchanged, because only meshing shows whether it must be steeper.
double size_by_estimate(const ElementEstimator& estimator, const RefineOptions& options, double target, double most) {
  double size = 1;
  for (unsigned n = 0; n < most_tries; ++n) {
    const double count = estimator.total(scaled_sizes(options, size));
    if (!(count > 0) || (count <= near_enough * target && count * near_enough >= target)) break;
    const double before = std::exchange(size, std::min(next_factor(size, count, target), most));
    if (size == before) break;
  }
  return size;
}

ElementEstimate by_cause(const ElementEstimator& estimator, const SettledStack& stack, const RefineOptions& options,
                         std::optional<double> known_total = std::nullopt) {
  const std::size_t n_thin = stack.settled ? stack.sizes.size() : 0;  // see ask_of_thin_units
  return estimator.by_cause(options, n_thin, known_total);
}

/// Returns whether the global size may be chosen freely: sizes that the user requests are never scaled.
bool may_derive(const RefinementSettings& settings) {
  const NamedSizes& size = settings.size;
  return settings.derive_size && !(settings.target_elements > 0) && !(size.frequency > 0) && size.units.empty() &&
         size.surfaces.empty() && size.curves.empty() && size.near.empty() && size.layers.empty();
}

/// Returns whether gaps between surfaces require too many elements even if all sizes are as large as allowed.
bool gaps_ask_for_too_many(const RefinementSettings& settings, const ElementEstimator& estimator,
                           const RefineOptions& options, const Scale& greatest) {
  const double most = most_over_target * settings.derived_elements;
  return options.size.gap_layers > 0 && settings.gaps_by_default && estimator.is_above(most, options) &&
         estimator.is_above(most, scaled_sizes(options, greatest.size));
}

}  // namespace

RefinementSettings settings_used(RefinementSettings settings, const RefineOptions& options) {
  settings.size.base.global = options.size.global;
  settings.size.base.gradation = options.size.gradation;
  settings.size.base.gap_layers = options.size.gap_layers;
  settings.tolerance.rescale_left(options.tolerance);
  return settings;
}

CountedOptions with_derived_size(const ModelRecords& model, const ConstrainedTetrahedralization& mesh,
                                 RefineOptions options) {
  constexpr double near = 1.4;  // accepted ratio of estimated to requested elements; the mesh may differ as much again
  const RefinementSettings& settings = model.arranged.refinement;
  const SettledStack& stack = model.built.stack;
  const ElementEstimator estimator(model.arranged.plc.plc, mesh, options);
  if (!may_derive(settings)) return {options, by_cause(estimator, stack, options), settings};
  const double target = settings.derived_elements;
  // Surfaces that nearly coincide everywhere need the same number of elements at every size and tolerance.
  Scale most = greatest_scale(model.arranged, options, target);
  if (!settings.gradation_by_default) most.gradation = 1;
  const bool drops_gaps = gaps_ask_for_too_many(settings, estimator, options, most);
  if (drops_gaps) options.size.gap_layers = 0;
  const auto [scale, count] = scale_by_estimate(estimator, options, CountSearch(target, most), near);
  options = scaled(options, scale);
  return {options, by_cause(estimator, stack, options, count), settings_used(settings, options), drops_gaps,
          scale.gradation};
}

void announce_count(const CountedOptions& counted, const std::string& unit, Journal& journal) {
  const RefineOptions& options = counted.options;
  const RefinementSettings& used = counted.used;
  const bool may_move = options.honour == Honour::tolerance;
  const double tolerance = may_move ? options.tolerance + used.tolerance.requested() - used.tolerance.left() : 0;
  std::string text = announcement(counted.estimate, options.size.global, tolerance, unit,
                                  options.size.from_input_edges && options.size_surfaces);
  if (counted.gaps_dropped)
    text += "; elements in gaps between surfaces may be flat, because more than " +
            rounded_count(most_over_target * used.derived_elements) +
            " would come, whatever the size, if each gap had layers of its own and sizes grew no faster (mesh: {size: "
            "{gap_layers: 0.4}} requests them)";
  if (counted.gradation_scale > 1)
    text += "; sizes grow by " + short_words(options.size.gradation) +
            " a unit of distance away from where they are small (mesh: {size: {gradation: " +
            short_words(options.size.gradation / counted.gradation_scale) + "}} requests more elements there)";
  const double total = counted.estimate.total(), limit = static_cast<double>(options.max_elements);
  if (total > limit)
    throw Error(ErrorKind::cannot_mesh, text + ". That is more than the limit of " + count_words(limit) +
                                            " (mesh: {max_elements}); sizes about " +
                                            short_words(std::cbrt(total / limit)) + " times as large would do");
  journal.note(text);
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

RefinedToCount refine_to_count(const ModelRecords& model, const ConstrainedTetrahedralization& mesh,
                               const RefineOptions& options, Journal& journal) {
  const double target = model.arranged.refinement.target_elements;
  const Scale greatest = greatest_scale(model.arranged, options, target);
  const CountSearch search(target, greatest);
  std::vector<Try> tries;
  Try best;
  RefineResult result;
  Scale scale;
  {
    const StageScope stage(journal.context(), "estimate");
    scale.size =
        size_by_estimate(ElementEstimator(model.arranged.plc.plc, mesh, options), options, target, greatest.size);
  }
  while (tries.size() < most_tries) {
    RefineResult now = refine_model(model, mesh, scaled(options, scale), journal.context());
    tries.push_back({scale, static_cast<double>(now.mesh.tetrahedra.size())});
    if (tries.size() == 1 || search.is_nearer(tries.back(), best)) {
      best = tries.back();
      result = std::move(now);
    }
    if (search.is_near(best, near_enough)) break;
    const Scale next = search.after(tries);
    if (next.size == scale.size && next.gradation == scale.gradation) break;
    scale = next;
  }
  journal.keep_warnings(result.warnings);
  if (!search.is_near(best, near_enough))
    journal.warn("target_elements: " + short_words(best.count) + " elements came out and not " + short_words(target) +
                 ", whatever the size: the surfaces alone require others");
  journal.note("target_elements: sizes are " + short_words(best.scale.size) + " times those requested" +
               (best.scale.gradation > 1
                    ? ", and grow " + short_words(best.scale.gradation) + " times as fast away from small ones"
                    : ""));
  return {std::move(result), settings_used(model.arranged.refinement, scaled(options, best.scale))};
}

}  // namespace geomesh::geomodel
