// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrangement/join_input.hpp"

#include "arrangement/diagnosis/near_surfaces.hpp"
#include "arrangement/join/join_patches.hpp"
#include "arrangement/model/displacement.hpp"
#include "arrangement/sides/join_to_sides.hpp"
#include "geomesh/core/error.hpp"
#include "geomesh/geomodel/words.hpp"

namespace geomesh::geomodel::arrangement {

namespace {

// Fraction of the tolerance within which two surfaces that run along each other are duplicates.
constexpr double duplicate_share = 0.01;
// Most passes of merging: an edge that one pass splits may be near others; three passes are usually enough.
constexpr unsigned most_passes = 8;
// Smallest tolerance, in ulps, since rounding might undo the merging within a smaller one.
constexpr double least_ulps = 1024;

std::vector<std::uint8_t> are_faults(const std::vector<TriangulatedSurface>& surfaces) {
  std::vector<std::uint8_t> are;
  for (const TriangulatedSurface& s : surfaces) are.push_back(s.kind == SurfaceKind::fault);
  return are;
}

void refuse_tolerance_of_rounding(double tolerance, const Complex& complex) {
  const double least = least_ulps * unit_in_the_last_place(complex);
  if (tolerance < least)
    throw Error(ErrorKind::usage,
                "the tolerance must be at least " + short_words(least) + " for coordinates of this size, or 0");
}

}  // namespace

void MergingBook::take(const SnapOutcome& outcome) {
  add(outcome.moved, merging.displacement);
  merging.vertices_merged += outcome.n_vertices_merged;
  merging.vertices_inserted += outcome.n_vertices_inserted;
  merging.facets_merged += outcome.n_facets_merged;
  merging.facets_collapsed += outcome.vanished.size();
  vanished.insert(vanished.end(), outcome.vanished.begin(), outcome.vanished.end());
}

void InputJoiner::join(MergingBook& book, std::vector<std::string>& warnings, std::size_t memory_bound) {
  if (options_.tolerance > 0) apply_tolerance(book, warnings, memory_bound);
  join_ends_and_sides(book);
}

JoinRule InputJoiner::rule(const Contacts& contacts) const {
  return rule_restricts_ ? join_rule(contacts) : JoinRule();
}

/// Warns of duplicates.
InputJoiner::PairsToJoin InputJoiner::find_pairs(std::vector<std::string>& warnings) const {
  const std::vector<TriangulatedSurface>& surfaces = surfaces_.given;
  const double nearest = duplicate_share * options_.tolerance;
  const NearSurfaces near = near_surfaces(surfaces, nearest, options_.tolerance);
  const auto words = [&](Index s) { return std::string(to_string(surfaces[s].kind)) + " " + surfaces[s].name; };
  for (const auto& [a, b] : near.duplicates)
    warnings.push_back(words(a) + " and " + words(b) + " follow each other nearer than " + short_words(nearest) +
                       ": they are meshed as one where they do (honour: exact keeps them apart)");
  return {{near.duplicates.begin(), near.duplicates.end()}, {near.ending.begin(), near.ending.end()}};
}

/// Surfaces from this index on are not merged: points stay on the sides of a box because its planes hold them, and the
/// sides of any other volume are fixed.
Index InputJoiner::first_fixed() const { return options_.box ? no_index : static_cast<Index>(surfaces_.given.size()); }

JoinRule InputJoiner::join_rule(const Contacts& contacts) const {
  if (options_.merging == ArrangementOptions::MergingOf::everything) return JoinRule::all_but(first_fixed());
  JoinRule rule(surfaces_that_meet(ingested_.complex, contacts), first_fixed());
  rule.join_all_of(pairs_.wherever_near);
  rule.join_ends_of(pairs_.where_they_end);
  return rule;
}

/// Merges bodies with the faults that cut them where the two coincide up to the digits in their files. Neither surface
/// ends there, so the rule for surfaces that meet would leave a gap of this width between them.
void InputJoiner::merge_bodies_with_faults(MergingBook& book) {
  std::set<SurfacePair> pairs;
  const std::vector<TriangulatedSurface>& surfaces = surfaces_.given;
  for (Index a = 0; a < surfaces.size(); ++a)
    for (Index b = 0; b < surfaces.size(); ++b)
      if (surfaces[a].kind == SurfaceKind::body && surfaces[b].kind == SurfaceKind::fault)
        pairs.insert({surface_pair(a, a), surface_pair(a, b)});
  if (pairs.empty()) return;
  SnapOptions snapping{duplicate_share * options_.tolerance, joining_.box};
  snapping.rule = JoinRule::all_of(std::move(pairs), first_fixed());
  snapping.sides_of = sides_of_vertices(ingested_.complex, joining_);
  std::vector<VertexIndex> now;
  const std::vector<std::uint8_t> all(ingested_.complex.facets.size(), 1);
  take(book, snap_near(ingested_.complex, all, snapping, &now), now);
}

void InputJoiner::apply_tolerance(MergingBook& book, std::vector<std::string>& warnings, std::size_t memory_bound) {
  Complex& complex = ingested_.complex;
  refuse_tolerance_of_rounding(options_.tolerance, complex);
  const bool joins_all = options_.merging == ArrangementOptions::MergingOf::everything;
  std::vector<VertexIndex> now;
  if (!joins_all) {
    const SnapOutcome joined =
        join_patches(complex, are_faults(surfaces_.given), options_.tolerance, joining_.box, now);
    take(book, joined, now);
  }
  add(move_to_sides(complex, joining_, options_.tolerance), book.merging.displacement);
  for (unsigned pass = 0; pass < most_passes; ++pass) {
    const auto drawn = draw_to_feature_edges(complex, joining_, options_.tolerance);
    if (!drawn) break;
    book.take(*drawn);
  }
  if (!joins_all) merge_bodies_with_faults(book);
  SnapOptions snapping{options_.tolerance, joining_.box};
  if (options_.box) snapping.move_to_box = joins_all ? MoveToBox::all : MoveToBox::of_free_borders;
  if (!joins_all || !options_.volume.empty()) {
    const Contacts contacts = find_contacts(complex, context_, memory_bound);
    if (!joins_all) pairs_ = find_pairs(warnings);
    snapping.rule = join_rule(contacts);
    rule_restricts_ = true;
  }
  snapping.sides_of = sides_of_vertices(complex, joining_);
  const SnapOutcome joined = snap_near(complex, std::vector<std::uint8_t>(complex.facets.size(), 1), snapping, &now);
  take(book, joined, now);
}

/// Repeats each step of merging surfaces until nothing changes.
void InputJoiner::join_ends_and_sides(MergingBook& book) {
  std::vector<VertexIndex> now;
  const auto repeat = [&](auto join) {
    for (unsigned pass = 0; pass < most_passes; ++pass) {
      const auto joined = join(ingested_.complex, joining_, now);
      if (!joined) return;
      take(book, *joined, now);
    }
  };
  if (!(options_.tolerance > 0)) repeat(join_ends);
  repeat(join_to_sides);
}

/// `now` maps each vertex to the one that replaced it.
void InputJoiner::take(MergingBook& book, const SnapOutcome& outcome, const std::vector<VertexIndex>& now) {
  book.take(outcome);
  for (auto& vertices : ingested_.vertex_of_point)
    for (VertexIndex& v : vertices) v = now[v];
}

}  // namespace geomesh::geomodel::arrangement
