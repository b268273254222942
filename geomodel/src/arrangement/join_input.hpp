// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What is brought together before anything is intersected, and what was done so far by bringing together.
#pragma once

#include <set>
#include <vector>

#include "arrangement/join/join_surfaces.hpp"
#include "arrangement/model/contacts.hpp"
#include "arrangement/model/ingest.hpp"
#include "arrangement/snap/join_rule.hpp"

namespace geomesh::geomodel::arrangement {

/// The merging of a result, and facets that vanished.
struct MergingBook {
  ArrangementResult::Merging& merging;
  std::vector<VanishedFacet> vanished{};
  void take(const SnapOutcome& outcome);
};

/// One arrangement's input. References must outlive it.
class InputJoiner {
 public:
  InputJoiner(Ingested& ingested, const SurfaceList& surfaces, const ArrangementOptions& options,
              const Joining& joining, const RunContext& context)
      : ingested_(ingested), surfaces_(surfaces), options_(options), joining_(joining), context_(context) {}

  /// Within the tolerance, where there is one: patches of faults, ends, what was given twice. Else ends within rounding
  /// of other surfaces. Then what lies on sides but for rounding. Throws Error{usage} where the tolerance is no greater
  /// than rounding. Cost: that of snap_near, a few times.
  void join(MergingBook& book, std::vector<std::string>& warnings, std::size_t memory_bound);

  /// What the tolerance joins from now on. `contacts`: of the input as it is now.
  JoinRule rule(const Contacts& contacts) const;

 private:
  /// What joins besides surfaces that meet where one of them ends.
  struct PairsToJoin {
    std::set<SurfacePair> wherever_near;  ///< given twice
    std::set<SurfacePair> where_they_end;
  };
  PairsToJoin find_pairs(std::vector<std::string>& warnings) const;
  JoinRule join_rule(const Contacts& contacts) const;
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
