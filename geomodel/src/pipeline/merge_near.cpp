// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/merge_near.hpp"

#include <algorithm>
#include <optional>
#include <string>

#include "fractures/plane_polygons.hpp"
#include "geomesh/geomodel/words.hpp"
#include "naming/region_facts.hpp"

namespace geomesh::geomodel {

namespace {

constexpr double most_of_tolerance = 0.5;      ///< what merging may use
constexpr double most_moved_of_tolerance = 2;  ///< of the project's own
constexpr double next_distance = 0.5;          ///< of the distance before
constexpr unsigned most_tries = 3, most_tries_asked = 5;
constexpr unsigned most_rounds =
    4;  ///< of a try: what has no end then has none later, and each takes as long as the first

/// Nothing where no arrangement comes of it, or something moved too far.
std::optional<ArrangementResult> try_merging(const PreparedModel& model, const std::vector<Polyline>& wells,
                                             const ArrangementOptions& options, const RunContext& context) {
  try {
    ArrangementResult found = arrange(model.surfaces, wells, model.points, options, context);
    if (found.merging.displacement.largest <= most_of_tolerance * model.refinement.tolerance.left()) return found;
    context.note(LogLevel::debug, "merging within " + short_words(options.tolerance) + " moves something by " +
                                      short_words(found.merging.displacement.largest) + ", too far");
  } catch (const Error& error) {
    if (error.kind() == ErrorKind::interrupted) throw;
    context.note(LogLevel::debug, "no merging within " + short_words(options.tolerance) + ": " + error.what());
  }
  return std::nullopt;
}

/// What was merged is told as a finding: nothing is wrong with it.
void tell_merging(PreparedModel& model, ArrangementResult& found, double distance, const RunContext& context) {
  for (const Spot& spot : found.spots)
    if (spot.what == "merged") std::erase(found.warnings, describe(spot, model.surfaces));
  const ArrangementResult::Merging& merging = found.merging;
  const std::size_t n = merging.vertices_merged + merging.vertices_inserted;
  constexpr double by_rounding = 1e-6;  // of the distance: what touches already is counted too
  if (n + merging.pockets_closed == 0 || merging.displacement.largest < by_rounding * distance) return;
  const std::string pockets = merging.pockets_closed == 0
                                  ? std::string()
                                  : "; " + std::to_string(merging.pockets_closed) + " thinner pockets were closed";
  note(model.notes, context,
       "surfaces that meet were brought together at " + std::to_string(n) + " places where they were nearer than " +
           short_words(distance) + " " + model.unit + " to each other" + pockets + "; nothing moved by more than " +
           short_words(merging.displacement.largest) + " " + model.unit);
}

/// What merging, and mending at places too thin for any rounding, moved.
ToleranceUse use_of(const ArrangementResult::Merging& merging) {
  ToleranceUse use{"merging", merging.displacement.largest};
  use.moved = use.taken;
  use.place = merging.displacement.where;
  return use;
}

/// Books what was allowed by `merge_within`, or what mending moved without any tolerance.
ArrangementResult booked_apart(PreparedModel& model, ArrangementResult found) {
  ToleranceUse use = use_of(found.merging);
  use.by_own_key = true;
  if (use.taken > 0) model.refinement.tolerance.take(std::move(use));
  return found;
}

/// What stood against merging within a distance.
struct Obstacle {
  std::string text;
  void keep_first(std::string other) {
    if (text.empty()) text = std::move(other);
  }
};

/// Nothing where no doubles keep apart what merging brings together, or something moved too far, as `obstacle` tells.
std::optional<ArrangementResult> try_merging_asked(const PreparedModel& model, const std::vector<Polyline>& wells,
                                                   const ArrangementOptions& options, double most_moved,
                                                   const RunContext& context, Obstacle& obstacle) {
  try {
    ArrangementResult found = arrange(model.surfaces, wells, model.points, options, context);
    const double moved = found.merging.displacement.largest;
    if (moved <= most_moved) return found;
    obstacle.keep_first("moves something by " + short_words(moved) + " " + model.unit + " near " +
                        to_text(found.merging.displacement.where));
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::cannot_mesh) throw;
    context.note(LogLevel::debug, "no merging within " + short_words(options.tolerance) + ": " + error.what());
    obstacle.keep_first("leaves surfaces that no rounding to doubles keeps apart");
  }
  return std::nullopt;
}

/// Merging within the project's own `tolerance`. It is tried again within half of the distance, and so on to a
/// sixteenth, at last within nothing, with a warning. That is so where something would move by more than twice the
/// tolerance, or no doubles keep apart what comes together. Throws what arrange does where that was not the cause.
ArrangementResult arrange_merging_asked(PreparedModel& model, const std::vector<Polyline>& wells,
                                        ArrangementOptions options, const RunContext& context) {
  const double asked = options.tolerance;
  const std::string within = "merging within the tolerance of " + short_words(asked) + " " + model.unit;
  Obstacle obstacle;
  for (unsigned k = 0; k < most_tries_asked; ++k, options.tolerance *= next_distance) {
    auto found = try_merging_asked(model, wells, options, most_moved_of_tolerance * asked, context, obstacle);
    if (!found) continue;
    if (options.tolerance < asked)
      warn(model.warnings, context,
           within + " " + obstacle.text + ": what is nearer than " + short_words(options.tolerance) + " " + model.unit +
               " was merged");
    return std::move(*found);
  }
  options.tolerance = 0;
  ArrangementResult found = arrange(model.surfaces, wells, model.points, options, context);
  warn(model.warnings, context,
       within + " " + obstacle.text + ", and a sixteenth of it does no better: nothing was merged");
  return found;
}

}  // namespace

ArrangementResult arrange_merging_near(PreparedModel& model, const std::vector<Polyline>& wells,
                                       ArrangementOptions options, const RunContext& context) {
  if (options.tolerance > 0) return booked_apart(model, arrange_merging_asked(model, wells, options, context));
  // A network of fractures keeps its areas and junctions unless the project has `merge_within`.
  double distance = is_fracture_network(model.surfaces, model.rules) ? 0 : merging_distance(model.refinement);
  const unsigned rounds = options.max_rounding_rounds;
  for (unsigned k = 0; distance > 0 && k < most_tries; ++k, distance *= next_distance) {
    options.tolerance = distance;
    options.merging = ArrangementOptions::MergingOf::surfaces_that_meet;
    options.max_rounding_rounds = std::min(rounds, most_rounds);
    auto found = try_merging(model, wells, options, context);
    if (!found) continue;
    tell_merging(model, *found, distance, context);
    if (found->merging.displacement.largest > 0) model.refinement.tolerance.take(use_of(found->merging));
    return std::move(*found);
  }
  if (options.merging == ArrangementOptions::MergingOf::surfaces_that_meet) options.tolerance = 0;
  options.max_rounding_rounds = rounds;
  return booked_apart(model, arrange(model.surfaces, wells, model.points, options, context));
}

}  // namespace geomesh::geomodel
