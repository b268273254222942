// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Merges surfaces before anything is intersected, and records all merging so far.
#pragma once

#include <set>
#include <vector>

#include "arrangement/join/join_surfaces.hpp"
#include "arrangement/model/contacts.hpp"
#include "arrangement/model/ingest.hpp"
#include "arrangement/snap/join_rule.hpp"

namespace geomesh::geomodel::arrangement {

/// Movements and counts of merging that the result of the arrangement reports, and the facets that vanished.
struct MergingBook {
  ArrangementResult::Merging& merging;
  std::vector<VanishedFacet> vanished{};
  void take(const SnapOutcome& outcome);
};

/// The input of one arrangement, which it merges within a distance. Holds references, which must stay valid.
class InputJoiner {
 public:
  InputJoiner(Ingested& ingested, const SurfaceList& surfaces, const ArrangementOptions& options,
              const Joining& joining, const RunContext& context)
      : ingested_(ingested), surfaces_(surfaces), options_(options), joining_(joining), context_(context) {}

  /// Merges within the tolerance, if there is one: patches of faults, bodies with the faults that cut them, free edges
  /// beside other surfaces, duplicates. Without a tolerance, merges free edges within rounding of other surfaces. Then
  /// moves everything near sides of the volume onto them, up to rounding. Throws Error{usage} if the tolerance is not
  /// greater than rounding. Cost: that of snap_near(), a few times.
  void join(MergingBook& book, std::vector<std::string>& warnings, std::size_t memory_bound);

  /// Returns the rule for what later steps may merge within the tolerance; `contacts` are those of the current input.
  JoinRule rule(const Contacts& contacts) const;

 private:
  /// Pairs of surfaces to merge although they do not meet. Surfaces that meet are merged where one of them ends.
  struct PairsToJoin {
    std::set<SurfacePair> wherever_near;  ///< duplicates
    std::set<SurfacePair> where_they_end;
  };
  PairsToJoin find_pairs(std::vector<std::string>& warnings) const;
  Index first_fixed() const;
  JoinRule join_rule(const Contacts& contacts) const;
  void merge_bodies_with_faults(MergingBook& book);
  void apply_tolerance(MergingBook& book, std::vector<std::string>& warnings, std::size_t memory_bound);
  void join_ends_and_sides(MergingBook& book);
  void take(MergingBook& book, const SnapOutcome& outcome, const std::vector<VertexIndex>& now);

  Ingested& ingested_;
  const SurfaceList& surfaces_;
  const ArrangementOptions& options_;
  const Joining& joining_;
  const RunContext& context_;
  PairsToJoin pairs_;
  bool rule_restricts_ = false;
};

}  // namespace geomesh::geomodel::arrangement
