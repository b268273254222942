// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/target_elements.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

#include "geomesh/geomodel/sizes_in_range.hpp"
#include "geomesh/geomodel/words.hpp"
#include "pipeline/refine_model.hpp"
#include "report/announcement.hpp"

namespace geomesh::geomodel {

namespace {

constexpr double near_enough = 0.1;
constexpr double infinity = std::numeric_limits<double>::infinity();

/// Elements go with the cube of the size; where surfaces take their share, with less.
double next_factor(double factor, double count, double target) { return factor * std::cbrt(count / target); }

Box3 bounds_of(const PreparedModel& model) {
  Box3 box;
  for (const Vec3& p : model.plc.plc.points) box.add(p);
  return box;
}

/// Beyond it the tolerance that follows the sizes would be refused.
double greatest_factor(const PreparedModel& model, const RefineOptions& options) {
  constexpr double most_of_diagonal = 0.05;
  if (options.honour != Honour::tolerance || !(options.tolerance_share > 0)) return infinity;
  const Box3 box = bounds_of(model);
  const Vec3 extent = box.max - box.min;
  return std::max(most_of_diagonal * std::sqrt(dot(extent, extent)) / options.tolerance, 1.0);
}

/// Sizes several times those of a volume with nothing in it change no more than the tolerance that follows them.
double factor_of_empty_volume(const PreparedModel& model, const RefineOptions& options, double target) {
  constexpr double most = 7;
  return options.size.global > 0 ? most * derived_size(bounds_of(model), target) / options.size.global : infinity;
}

/// By the estimate alone; at most `most`, however many elements surfaces ask for that cross and touch all over.
double first_factor(const PreparedModel& model, const ConstrainedTetrahedralization& mesh, const RefineOptions& options,
                    double target, double most) {
  constexpr unsigned most_rounds = 6;
  constexpr double enough = 0.02;
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
  settings.size.base.gradation = options.size.gradation;
  settings.size.base.gap_layers = options.size.gap_layers;
  settings.tolerance.rescale_left(options.tolerance);
  auto input = nlohmann::ordered_json::parse(model.input_json, nullptr, false);
  if (input.is_discarded()) return;
  if (options.size.global > 0) input["mesh"]["size"] = options.size.global;
  model.input_json = input.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace

ElementEstimate estimate_model(const PreparedModel& model, const ConstrainedTetrahedralization& mesh,
                               const RefineOptions& options) {
  const std::size_t n_thin = model.stack.settled ? model.stack.sizes.size() : 0;  // come first, ask_of_thin_units
  return estimate_by_cause(model.plc.plc, mesh, options, n_thin);
}

/// Whether the size of the whole model is ours to choose: sizes that the user asks for are never scaled.
static bool may_derive(const RefinementSettings& settings) {
  const NamedSizes& size = settings.size;
  return settings.derive_size && !(settings.target_elements > 0) && !(size.frequency > 0) && size.units.empty() &&
         size.surfaces.empty() && size.curves.empty() && size.near.empty() && size.layers.empty();
}

/// The options scaled to about settings.derived_elements, unless they are near to it as they are.
static CountedOptions scaled_to_target(const PreparedModel& model, const ConstrainedTetrahedralization& mesh,
                                       RefineOptions options) {
  constexpr double near = 1.4;
  const ElementEstimate found = estimate_model(model, mesh, options);
  const double target = model.refinement.derived_elements, off = found.total() / target;
  if (off <= near && off >= 1 / near) return {std::move(options), found};
  // Surfaces that nearly coincide all over ask for as many at every size: the tolerance would be given away in vain.
  const double most = std::min(greatest_factor(model, options), factor_of_empty_volume(model, options, target));
  options = scaled_sizes(options, first_factor(model, mesh, options, target, most));
  const ElementEstimate scaled = estimate_model(model, mesh, options);
  return {std::move(options), scaled};
}

CountedOptions with_derived_size(PreparedModel& model, const ConstrainedTetrahedralization& mesh,
                                 RefineOptions options) {
  constexpr double most_over_target = 2;  // 200,000 elements, beyond which the first mesh of a model is a burden
  const RefinementSettings& settings = model.refinement;
  if (!may_derive(settings)) {
    const ElementEstimate found = estimate_model(model, mesh, options);
    return {std::move(options), found};
  }
  CountedOptions chosen = scaled_to_target(model, mesh, options);
  const double count = chosen.estimate.total(), most = most_over_target * settings.derived_elements;
  if (count > most && settings.gaps_by_default) {
    options.size.gap_layers = 0;
    CountedOptions without_gaps = scaled_to_target(model, mesh, std::move(options));
    // Elsewhere the count remains high without gaps, and elements would be flat in vain.
    if (without_gaps.estimate.total() < count / 2) {
      chosen = std::move(without_gaps);
      chosen.count_with_gaps = count;
    }
  }
  settle(model, chosen.options);
  return chosen;
}

void announce_count(PreparedModel& model, const CountedOptions& counted, const RunContext& context) {
  const RefineOptions& options = counted.options;
  const bool may_move = options.honour == Honour::tolerance;
  const double tolerance =
      may_move ? options.tolerance + model.refinement.tolerance.requested() - model.refinement.tolerance.left() : 0;
  std::string text = announcement(counted.estimate, options.size.global, tolerance, model.unit,
                                  options.size.from_input_edges && options.size_surfaces);
  if (counted.count_with_gaps > 0)
    text += "; elements in gaps between surfaces may be flat, because about " + rounded_count(counted.count_with_gaps) +
            " would come if each gap had layers of its own (mesh: {size: {gap_layers: 0.4}} asks for them)";
  const double total = counted.estimate.total(), limit = static_cast<double>(options.max_elements);
  if (total > limit)
    throw Error(ErrorKind::cannot_mesh, text + ". That is more than the limit of " + count_words(limit) +
                                            " (mesh: {max_elements}); sizes about " +
                                            short_words(std::cbrt(total / limit)) + " times as large would do");
  note(model.notes, context, text);
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

namespace {

/// What is scaled: sizes, and how soon they grow with the distance from where they are small.
struct Scale {
  double size = 1, gradation = 1;
};

struct Try {
  Scale scale;
  double count = 0;  ///< of elements
};

/// The search for the scales by which so many elements come out.
class CountSearch {
 public:
  CountSearch(double target, double most_size, double gradation)
      : target_(target), most_size_(most_size), most_gradation_(std::max(most_gradation / gradation, 1.0)) {}

  bool is_near(const Try& t) const { return std::abs(t.count / target_ - 1) <= near_enough; }
  bool is_nearer(const Try& t, const Try& than) const {
    return std::abs(std::log(t.count / target_)) < std::abs(std::log(than.count / target_));
  }

  /// Where larger sizes bring hardly fewer elements, those about surfaces that ask for short edges count: sizes grow
  /// away from them sooner. Between tries with too many and too few elements, as if these went with a power of the
  /// scale.
  Scale after(const std::vector<Try>& tries) const {
    const Try& now = tries.back();
    const auto [many, few] = nearest_on_both_sides(tries);
    if (many && few) {
      const double share = std::log(many->count / target_) / std::log(many->count / few->count);
      const auto between = [&](double from, double to) { return from * std::pow(to / from, share); };
      return {between(many->scale.size, few->scale.size), between(many->scale.gradation, few->scale.gradation)};
    }
    const bool may_grow_sooner = now.count > target_ && now.scale.gradation < most_gradation_;
    if (may_grow_sooner && (now.scale.size >= most_size_ || is_in_vain(tries)))
      return {tries.size() > 1 ? std::min(tries[tries.size() - 2].scale.size, now.scale.size) : now.scale.size,
              std::min(2 * now.scale.gradation, most_gradation_)};
    return {std::min(next_factor(now.scale.size, now.count, target_), most_size_), now.scale.gradation};
  }

 private:
  static constexpr double most_gradation = 1;

  std::pair<const Try*, const Try*> nearest_on_both_sides(const std::vector<Try>& tries) const {
    const Try *many = nullptr, *few = nullptr;
    for (const Try& t : tries) {
      const Try*& side = t.count > target_ ? many : few;
      if (!side || is_nearer(t, *side)) side = &t;
    }
    return {many, few};
  }

  static bool is_in_vain(const std::vector<Try>& tries) {
    constexpr double much_larger = 1.2, hardly_fewer = 0.8;
    if (tries.size() < 2) return false;
    const Try &before = tries[tries.size() - 2], &now = tries.back();
    return now.scale.gradation == before.scale.gradation && now.scale.size > much_larger * before.scale.size &&
           now.count > hardly_fewer * before.count;
  }

  double target_, most_size_, most_gradation_;
};

}  // namespace

RefineResult refine_to_count(PreparedModel& model, const ConstrainedTetrahedralization& mesh,
                             const RefineOptions& options, const RunContext& context) {
  constexpr unsigned most_runs = 6;
  const double target = model.refinement.target_elements;
  const double most = std::min(greatest_factor(model, options), factor_of_empty_volume(model, options, target));
  const CountSearch search(target, most, options.size.gradation);
  const auto scaled = [&](const Scale& scale) {
    RefineOptions out = scaled_sizes(options, scale.size);
    out.size.gradation *= scale.gradation;
    return out;
  };
  const std::vector<std::string> warnings = model.warnings;
  std::vector<Try> tries;
  struct {
    Try found;
    RefineResult result;
    std::vector<std::string> warnings;
  } best;
  Scale scale{first_factor(model, mesh, options, target, most), 1};
  while (tries.size() < most_runs) {
    model.warnings = warnings;
    RefineResult result = refine_model(model, mesh, scaled(scale), context);
    tries.push_back({scale, static_cast<double>(result.mesh.tetrahedra.size())});
    if (tries.size() == 1 || search.is_nearer(tries.back(), best.found))
      best = {tries.back(), std::move(result), model.warnings};
    if (search.is_near(best.found)) break;
    const Scale next = search.after(tries);
    if (next.size == scale.size && next.gradation == scale.gradation) break;
    scale = next;
  }
  model.warnings = std::move(best.warnings);
  if (!search.is_near(best.found))
    warn(model.warnings, context,
         "target_elements: " + short_words(best.found.count) + " elements came out and not " + short_words(target) +
             ", whatever the size: the surfaces alone ask for others");
  settle(model, scaled(best.found.scale));
  note(model.notes, context,
       "target_elements: sizes are " + short_words(best.found.scale.size) + " times those asked for" +
           (best.found.scale.gradation > 1
                ? ", and grow " + short_words(best.found.scale.gradation) + " times as fast away from small ones"
                : ""));
  return std::move(best.result);
}

}  // namespace geomesh::geomodel
