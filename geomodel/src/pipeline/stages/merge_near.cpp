// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/stages/merge_near.hpp"

#include <algorithm>
#include <optional>
#include <string>

#include "fractures/plane_polygons.hpp"
#include "geomesh/core/error.hpp"
#include "geomesh/geomodel/words.hpp"
#include "naming/region_facts.hpp"

namespace geomesh::geomodel {

namespace {

constexpr double most_of_tolerance = 0.5;      ///< share of the remaining tolerance that merging may use
constexpr double most_moved_of_tolerance = 2;  ///< largest movement of a point by merging, divided by `merge_within`
constexpr double next_distance = 0.5;          ///< factor from one tried merging distance to the next smaller one
constexpr unsigned most_tries = 3, most_tries_asked = 5;
/// Largest number of times that coordinates are rounded to doubles in one attempt to merge surfaces. An attempt that
/// still fails then would not succeed later either, and each rounding takes as long as the first.
constexpr unsigned most_rounds = 4;

/// Returns how far surfaces were moved by merging, and by the repair of places too thin for any rounding to doubles.
ToleranceUse use_of(const ArrangementResult::Merging& merging) {
  ToleranceUse use{"merging", merging.displacement.largest};
  use.moved = use.taken;
  use.place = merging.displacement.where;
  return use;
}

/// The reason why surfaces were not merged within the requested distance.
struct Obstacle {
  std::string text;
  void keep_first(std::string other) {
    if (text.empty()) text = std::move(other);
  }
};

class NearMerging {
 public:
  NearMerging(const Inputs& inputs, const Built& built, ToleranceLedger& tolerance, Journal& journal)
      : unit_(inputs.unit), built_(built), tolerance_(tolerance), journal_(journal) {}

  /// Merges surfaces where they are nearer to each other than `merge_within`.
  ArrangementResult asked(ArrangementOptions options) { return booked_apart(try_shares_asked(std::move(options))); }

  /// Merges surfaces within a share of the tolerance; used if the project does not set `merge_within`.
  ArrangementResult by_default(ArrangementOptions options) {
    // A network of fractures keeps its areas and junctions unless the project sets `merge_within`.
    double distance = is_fracture_network(built_.surfaces, built_.rules) ? 0 : merging_distance(built_.refinement);
    const unsigned rounds = options.max_rounding_rounds;
    for (unsigned k = 0; distance > 0 && k < most_tries; ++k, distance *= next_distance) {
      options.tolerance = distance;
      options.merging = ArrangementOptions::MergingOf::surfaces_that_meet;
      options.max_rounding_rounds = std::min(rounds, most_rounds);
      auto found = try_default(options);
      if (!found) continue;
      tell(*found, distance);
      if (found->merging.displacement.largest > 0) tolerance_.take(use_of(found->merging));
      return std::move(*found);
    }
    if (options.merging == ArrangementOptions::MergingOf::surfaces_that_meet) options.tolerance = 0;
    options.max_rounding_rounds = rounds;
    return booked_apart(arranged(options));
  }

 private:
  ArrangementResult arranged(const ArrangementOptions& options) const {
    ArrangementResult found = arrange(built_.surfaces, built_.wells, built_.points, options, journal_.context());
    GEOMESH_EXPENSIVE_CHECK(validate_soup(found.soup, 1).empty());
    return found;
  }

  /// Merges surfaces within a distance; returns nothing if no arrangement is found, or if a point moved too far.
  std::optional<ArrangementResult> try_default(const ArrangementOptions& options) const {
    const auto tell = [&](const std::string& text) { journal_.context().note(LogLevel::debug, text); };
    try {
      ArrangementResult found = arranged(options);
      if (found.merging.displacement.largest <= most_of_tolerance * tolerance_.left()) return found;
      tell("merging within " + short_words(options.tolerance) + " moves something by " +
           short_words(found.merging.displacement.largest) + ", too far");
    } catch (const Error& error) {
      if (error.kind() == ErrorKind::interrupted) throw;
      tell("no merging within " + short_words(options.tolerance) + ": " + error.what());
    }
    return std::nullopt;
  }

  /// Notes at how many places surfaces were merged: no warning, because merging does not show that the input is wrong.
  void tell(ArrangementResult& found, double distance) const {
    for (const Spot& spot : found.spots)
      if (spot.what == "merged") std::erase(found.warnings, describe(spot, built_.surfaces));
    const ArrangementResult::Merging& merging = found.merging;
    const std::size_t n = merging.vertices_merged + merging.vertices_inserted;
    // Smaller movements, as a share of the merging distance, are not reported: surfaces that only touch are merged,
    // too.
    constexpr double by_rounding = 1e-6;
    if (n + merging.pockets_closed == 0 || merging.displacement.largest < by_rounding * distance) return;
    const std::string pockets = merging.pockets_closed == 0
                                    ? std::string()
                                    : "; " + std::to_string(merging.pockets_closed) + " thinner voids were closed";
    journal_.note("surfaces that meet were merged at " + std::to_string(n) + " places where they were nearer than " +
                  short_words(distance) + " " + unit_ + " to each other" + pockets + "; nothing moved by more than " +
                  short_words(merging.displacement.largest) + " " + unit_);
  }

  /// Records how far `merge_within` moved surfaces, or how far a repair moved them without any tolerance.
  ArrangementResult booked_apart(ArrangementResult found) {
    ToleranceUse use = use_of(found.merging);
    use.by_own_key = true;
    if (use.taken > 0) tolerance_.take(std::move(use));
    return found;
  }

  /// Merges surfaces within the requested distance. Returns nothing if no doubles represent the merged surfaces without
  /// new contacts, or if a point moved too far; `obstacle` then gives the reason.
  std::optional<ArrangementResult> try_asked(const ArrangementOptions& options, double most_moved,
                                             Obstacle& obstacle) const {
    try {
      ArrangementResult found = arranged(options);
      const double moved = found.merging.displacement.largest;
      if (moved <= most_moved) return found;
      obstacle.keep_first("moves something by " + short_words(moved) + " " + unit_ + " near " +
                          to_text(found.merging.displacement.where));
    } catch (const Error& error) {
      if (error.kind() != ErrorKind::cannot_mesh) throw;
      journal_.context().note(LogLevel::debug,
                              "no merging within " + short_words(options.tolerance) + ": " + error.what());
      obstacle.keep_first("leaves surfaces that no rounding to doubles keeps apart");
    }
    return std::nullopt;
  }

  /// Merges surfaces within the requested distance; if this fails, within half of it, and so on down to a sixteenth,
  /// and finally not at all, with a warning. An attempt fails if a point would move by more than twice the
  /// requested distance, or if no doubles represent the merged surfaces without new contacts. Passes other errors on.
  ArrangementResult try_shares_asked(ArrangementOptions options) const {
    const double asked = options.tolerance;
    const std::string within = "merging within the tolerance of " + short_words(asked) + " " + unit_;
    Obstacle obstacle;
    for (unsigned k = 0; k < most_tries_asked; ++k, options.tolerance *= next_distance) {
      auto found = try_asked(options, most_moved_of_tolerance * asked, obstacle);
      if (!found) continue;
      if (options.tolerance < asked)
        journal_.warn(within + " " + obstacle.text + ": what is nearer than " + short_words(options.tolerance) + " " +
                      unit_ + " was merged");
      return std::move(*found);
    }
    options.tolerance = 0;
    ArrangementResult found = arranged(options);
    journal_.warn(within + " " + obstacle.text + ", and a sixteenth of it does no better: nothing was merged");
    return found;
  }

  const std::string& unit_;
  const Built& built_;
  ToleranceLedger& tolerance_;
  Journal& journal_;
};

}  // namespace

ArrangementResult arrange_merging_near(const Inputs& inputs, const Built& built, ArrangementOptions options,
                                       ToleranceLedger& tolerance, Journal& journal) {
  NearMerging merging(inputs, built, tolerance, journal);
  return options.tolerance > 0 ? merging.asked(std::move(options)) : merging.by_default(std::move(options));
}

}  // namespace geomesh::geomodel
