// SPDX-License-Identifier: GPL-3.0-or-later
// The driver of the arrangement, declared in geomesh/geomodel/arrangement.hpp.
#include <algorithm>
#include <cmath>

#include "arrangement/clip/clip.hpp"
#include "arrangement/diagnosis/diagnosis.hpp"
#include "arrangement/diagnosis/near_surfaces.hpp"
#include "arrangement/model/memory_bound.hpp"
#include "arrangement/pockets/close_pockets.hpp"
#include "arrangement/pockets/cut_flaps.hpp"
#include "arrangement/pockets/fill_holes.hpp"
#include "arrangement/snap/flatten_slivers.hpp"
#include "arrangement/snap/join_patches.hpp"
#include "arrangement/snap/join_surfaces.hpp"
#include "arrangement/snap/rounding.hpp"
#include "arrangement/snap/snap.hpp"
#include "common/thread_limit.hpp"
#include "geomesh/geomodel/model_error.hpp"
#include "geomesh/geomodel/words.hpp"

namespace geomesh::geomodel {
namespace {

using namespace arrangement;

void check_box(const Box3& box) {
  for (std::size_t i = 0; i < 3; ++i)
    if (!(std::isfinite(box.min[i]) && std::isfinite(box.max[i]) && box.min[i] < box.max[i]))
      throw Error(ErrorKind::invalid_input, "the box is empty: each of its minima must be less than the maximum");
}

double unit_in_the_last_place(const Complex& complex) {
  double largest = 0;
  for (const Vec3& p : complex.points) largest = std::max({largest, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
  return std::ldexp(1.0, std::ilogb(std::max(largest, 1e-300)) - 52);
}

/// What is still improper is a few ulps thin: new points go to old ones nearby, from wider about each time.
double mending_distance(const Complex& complex, unsigned round) {
  return unit_in_the_last_place(complex) * std::ldexp(1.0, std::min(1 + 3 * static_cast<int>(round), 9));
}

/// Of `tolerance`: surfaces that follow each other as near are one surface given twice.
constexpr double twin_share = 0.01;
/// Surfaces that lie in each other are a few ulps apart.
constexpr double joining_ulps = 32;

/// A point may move once a step: the sum of the largest bounds it.
void add(const Displacement& more, Displacement& total) {
  if (more.largest > total.largest) total.where = more.where;
  total.largest += more.largest;
  const auto n = static_cast<double>(total.points_moved + more.points_moved);
  if (n > 0)
    total.mean =
        (total.mean * static_cast<double>(total.points_moved) + more.mean * static_cast<double>(more.points_moved)) / n;
  total.points_moved += more.points_moved;
}

void close_thin_pockets(Complex& complex, const ArrangementOptions& options, const SurfaceList& surfaces,
                        ArrangementResult::Merging& merging) {
  const ClosedPockets closed =
      close_pockets(complex, options.tolerance, static_cast<Index>(surfaces.given.size()), options.parts);
  add(closed.moved, merging.displacement);
  merging.pockets_closed += closed.n_pockets;
  merging.facets_merged += closed.n_facets_removed;
}

/// What needles that vanished left of surfaces. `rounding`: a distance that rounding leaves.
void mend_surfaces(Complex& complex, double tolerance, double rounding, ArrangementResult& result,
                   std::vector<VanishedFacet>& vanished) {
  if (!(tolerance > 0) && result.n_rounding_rounds == 0) return;
  const CutFlaps cut = cut_flaps(complex, std::max(tolerance, rounding));
  add(cut.moved, result.merging.displacement);
  result.merging.facets_collapsed += cut.vanished.size();
  vanished.insert(vanished.end(), cut.vanished.begin(), cut.vanished.end());
  if (tolerance > 0) fill_holes(complex, tolerance);
}

void log_round(const RunContext& context, unsigned round, const Complex& complex, const Contacts& contacts) {
  context.note(LogLevel::debug, "arrangement round " + std::to_string(round) + ": " +
                                    std::to_string(complex.facets.size()) + " facets, " +
                                    std::to_string(contacts.n_pairs) + " pairs, " +
                                    std::to_string(contacts.facets.size()) + " contacts, " +
                                    std::to_string(contacts.overlaps.size()) + " overlaps");
}

/// Where rounding finds no end.
[[noreturn]] void refuse(const SurfaceList& surfaces, const Complex& complex, const Contacts& contacts) {
  ErrorContext context;
  ModelItems items;
  std::string names;
  const auto add = [&](Index f) {
    if (context.places.size() >= 10) return;
    context.facets.push_back(f);
    context.places.push_back(complex.points[complex.facets[f][0]]);
    const auto& origin = complex.origins.of(f)[0];
    const std::string& name = surfaces[origin.surface].name;
    items.add_triangle(name, origin.triangle);
    if (names.find(name) == std::string::npos) names += (names.empty() ? "" : ", ") + name;
  };
  for (const FacetContact& c : contacts.facets) add(c.facet);
  for (const Overlap& o : contacts.overlaps) add(o.a);
  const std::string message = "the surfaces " + names + " lie so near each other near " +
                              (context.places.empty() ? "?" : to_text(context.places[0])) +
                              " that no rounding to doubles keeps them apart; move them apart or merge them there "
                              "(tolerance; for horizons of one column rules.stack: auto with honour: tolerance)";
  throw ModelError(ErrorKind::cannot_mesh, message, std::move(items), std::move(context));
}

/// A point that is not from the input is a triple point where three surfaces meet.
void fill_kinds(PolygonSoup& soup) {
  std::vector<std::array<Index, 3>> at(soup.points.size(), {no_index, no_index, no_index});
  for (Index f = 0; f < soup.facets.size(); ++f)
    for (const VertexIndex v : soup.facets[f]) {
      if (soup.input_point[v] != no_index) continue;
      for (Index k = soup.origin_offsets[f]; k < soup.origin_offsets[f + 1]; ++k)
        for (Index& slot : at[v]) {
          if (slot == no_index) slot = soup.origins[k].surface;
          if (slot == soup.origins[k].surface) break;
        }
    }
  soup.kind.assign(soup.points.size(), SoupVertexKind::input);
  for (std::size_t v = 0; v < soup.points.size(); ++v)
    if (soup.input_point[v] == no_index && at[v][0] != no_index)
      soup.kind[v] = at[v][2] != no_index ? SoupVertexKind::triple_point : SoupVertexKind::intersection;
}

PolygonSoup soup_of(Complex&& complex) {
  drop_unused_points(complex);
  PolygonSoup soup;
  soup.points = std::move(complex.points);
  soup.input_point = std::move(complex.input_point);
  soup.facets = std::move(complex.facets);
  soup.origins = std::move(complex.origins.items);
  soup.origin_offsets = std::move(complex.origins.offsets);
  soup.segments = std::move(complex.segments);
  soup.isolated_points = std::move(complex.isolated_points);
  fill_kinds(soup);
  return soup;
}

/// What joins besides surfaces that meet where one of them ends.
struct PairsToJoin {
  std::set<SurfacePair> wherever_near;  ///< given twice
  std::set<SurfacePair> where_they_end;
};

/// What was given twice is told.
PairsToJoin pairs_to_join(const std::vector<TriangulatedSurface>& surfaces, double tolerance,
                          std::vector<std::string>& warnings) {
  const double nearest = twin_share * tolerance;
  const NearSurfaces near = near_surfaces(surfaces, nearest, tolerance);
  const auto words = [&](Index s) { return std::string(to_string(surfaces[s].kind)) + " " + surfaces[s].name; };
  for (const auto& [a, b] : near.twins)
    warnings.push_back(words(a) + " and " + words(b) + " follow each other nearer than " + short_words(nearest) +
                       ": they are meshed as one where they do (honour: exact keeps them apart)");
  return {{near.twins.begin(), near.twins.end()}, {near.ending.begin(), near.ending.end()}};
}

std::vector<std::uint8_t> all_facets(const Complex& complex) {
  return std::vector<std::uint8_t>(complex.facets.size(), 1);
}

/// Of the box or the volume. Throws where the box is empty.
std::vector<TriangulatedSurface> sides_of(const ArrangementOptions& options) {
  if (!options.box) return options.volume;
  check_box(*options.box);
  return make_box_sides(*options.box);
}

std::optional<Box3> bounds_of(const ArrangementOptions& options) {
  if (options.box || options.volume.empty()) return options.box;
  Box3 bounds;
  for (const TriangulatedSurface& s : options.volume)
    for (const Vec3& p : s.points) bounds.add(p);
  return bounds;
}

std::vector<std::uint8_t> are_faults(const std::vector<TriangulatedSurface>& surfaces) {
  std::vector<std::uint8_t> are;
  for (const TriangulatedSurface& s : surfaces) are.push_back(s.kind == SurfaceKind::fault);
  return are;
}

/// Points keep to the sides of a box by its planes; the sides of another volume are fixed.
JoinRule join_rule_of(const SurfaceList& surfaces, const ArrangementOptions& options, const PairsToJoin& pairs,
                      const Complex& complex, const Contacts& contacts) {
  const Index first_fixed = options.box ? no_index : static_cast<Index>(surfaces.given.size());
  if (options.merging == ArrangementOptions::MergingOf::everything) return JoinRule::all_but(first_fixed);
  JoinRule rule(surfaces_that_meet(complex, contacts), first_fixed);
  rule.join_all_of(pairs.wherever_near);
  rule.join_ends_of(pairs.where_they_end);
  return rule;
}

/// Facets that meet others.
std::vector<std::uint8_t> marks_of(const Contacts& contacts, const Complex& complex) {
  std::vector<std::uint8_t> marks(complex.facets.size(), 0);
  for (const FacetContact& c : contacts.facets) {
    marks[c.facet] = 1;
    if (c.other != no_index) marks[c.other] = 1;
  }
  for (const Overlap& o : contacts.overlaps) marks[o.a] = marks[o.b] = 1;
  return marks;
}

void refuse_tolerance_of_rounding(double tolerance, const Complex& complex) {
  const double least = 1024 * unit_in_the_last_place(complex);
  if (tolerance < least)
    throw Error(ErrorKind::usage,
                "the tolerance must be at least " + short_words(least) + " for coordinates of this size, or 0");
}

constexpr unsigned most_snaps = 6;             // in one round
constexpr unsigned most_passes_over_ends = 8;  // what one splits may be near to more; three do mostly

/// Brings together what lies within the mending distance among the facets that still meet.
SnapOutcome snap_what_meets(Complex& complex, const Contacts& contacts, unsigned round,
                            const std::optional<Box3>& bounds) {
  if (contacts.empty()) return {};
  return snap_near(complex, marks_of(contacts, complex), {mending_distance(complex, round), bounds});
}

/// A soup that grows beyond these while it is mended will not end.
class MendingBounds {
 public:
  MendingBounds(const Complex& complex, const Contacts& contacts, unsigned most_rounds)
      : most_facets_(4 * complex.facets.size() + 1000),
        fewest_contacts_(contacts.facets.size()),
        most_rounds_(most_rounds) {}
  bool grows(const Complex& complex) const { return complex.facets.size() > most_facets_; }
  /// Of what is left after a round.
  bool has_no_end(unsigned round, const Complex& complex, const Contacts& contacts) {
    const std::size_t n = contacts.facets.size(), most = 4 * fewest_contacts_ + 1000;
    fewest_contacts_ = std::min(fewest_contacts_, n);
    return round > most_rounds_ || grows(complex) || n > most;
  }

 private:
  std::size_t most_facets_, fewest_contacts_;
  unsigned most_rounds_;
};

/// One arrangement: what is read in, and what its rounds have done so far.
class Arrangement {
 public:
  Arrangement(const std::vector<TriangulatedSurface>& surfaces, const std::vector<Polyline>& polylines,
              const std::vector<NamedPoint>& points, const ArrangementOptions& options, const RunContext& context)
      : polylines_(polylines),
        points_(points),
        options_(options),
        context_(context),
        surfaces_{surfaces, result_.box_sides} {
    result_.box_sides = sides_of(options);
    bounds_ = bounds_of(options);
    ingested_ = ingest(surfaces_, polylines, points, bounds_);
    first_rounding_ = unit_in_the_last_place(ingested_.complex);
    joining_ = {joining_ulps * first_rounding_, bounds_, surfaces.size(), !options.box};
    result_.memory_bound = options.max_memory > 0 ? options.max_memory : default_memory_bound();
    result_.warnings = std::move(ingested_.warnings);
    result_.area_clipped_by_bodies.assign(surfaces.size(), 0);
    result_.area_clipped_by_box = ingested_.area_outside;
  }

  ArrangementResult run() {
    if (options_.tolerance > 0)
      apply_tolerance_to_input();
    else
      join_ends_of_input();
    Contacts contacts = find_contacts(ingested_.complex, context_, result_.memory_bound);
    if (join_rule_.restricts()) join_rule_ = join_rule_of(surfaces_, options_, pairs_, ingested_.complex, contacts);
    result_.n_pairs = contacts.n_pairs;
    log_round(context_, 0, ingested_.complex, contacts);
    Complex complex = first_round(contacts);
    apply_tolerance(complex);
    MendingBounds bounds(complex, contacts, options_.max_rounding_rounds);
    for (unsigned round = 1;; ++round) {
      contacts = find_contacts(complex, context_, result_.memory_bound);
      if (contacts.empty()) break;
      log_round(context_, round, complex, contacts);
      result_.n_rounding_rounds = round;
      if (const auto joined = join_what_lies_in_each_other(complex, contacts, joining_)) {
        take(*joined);
        contacts = find_contacts(complex, context_, result_.memory_bound);
      }
      for (unsigned k = 0; k < most_snaps && !bounds.grows(complex); ++k) {
        const SnapOutcome outcome = snap_what_meets(complex, contacts, round, bounds_);
        if (!outcome.changed()) break;
        take(outcome);
        contacts = find_contacts(complex, context_, result_.memory_bound);
      }
      if (contacts.empty()) break;
      if (bounds.has_no_end(round, complex, contacts)) refuse(surfaces_, complex, contacts);
      complex = round_again(complex, contacts, round);
      apply_tolerance(complex);
    }
    if (options_.tolerance > 0) take(flatten_slivers(complex, joining_, context_, result_.memory_bound));
    if (options_.tolerance > 0) close_thin_pockets(complex, options_, surfaces_, result_.merging);
    mend_surfaces(complex, options_.tolerance, joining_.distance, result_, vanished_);
    result_.soup = soup_of(std::move(complex));
    diagnose_soup(surfaces_, vanished_, result_);
    return std::move(result_);
  }

 private:
  Complex first_round(const Contacts& contacts) {
    Arranged arranged = arrange_round(ingested_.complex, contacts, context_, result_.memory_bound);
    std::vector<std::uint8_t> crosses_itself(surfaces_.given.size(), 0);
    diagnose_crossings({ingested_.complex, contacts, arranged}, surfaces_, bounds_, result_, crosses_itself);
    if (options_.crossings == ArrangementOptions::Crossings::refuse) refuse_crossings(result_, surfaces_);
    const ClipContext clip{arranged, surfaces_, result_, options_.tolerance};
    if (options_.box) clip_to_box(clip, *options_.box, polylines_);
    if (!options_.box && bounds_) clip_to_volume(clip, ingested_.complex, ingested_, polylines_, points_);
    add(cut_by_bodies(clip, ingested_.complex, ingested_, bounds_, crosses_itself), result_.merging.displacement);
    context_.check_cancelled();
    return take(round_to_doubles(arranged, ingested_.complex,
                                 {.snap = first_rounding_, .box = bounds_, .onto_sides_alone = true}));
  }

  Complex round_again(const Complex& complex, const Contacts& contacts, unsigned round) {
    const Arranged arranged = arrange_round(complex, contacts, context_, result_.memory_bound);
    RoundingOptions rounding{0, bounds_};
    rounding.snap = mending_distance(complex, round);
    return take(round_to_doubles(arranged, complex, rounding));
  }

  void join_ends_of_input() {
    std::vector<VertexIndex> now;
    for (unsigned pass = 0; pass < most_passes_over_ends; ++pass) {
      const auto joined = join_ends(ingested_.complex, joining_, now);
      if (!joined) return;
      take(*joined, now);
    }
  }

  void apply_tolerance_to_input() {
    Complex& complex = ingested_.complex;
    refuse_tolerance_of_rounding(options_.tolerance, complex);
    const bool joins_all = options_.merging == ArrangementOptions::MergingOf::everything;
    std::vector<VertexIndex> now;
    if (!joins_all) take(join_patches(complex, are_faults(surfaces_.given), options_.tolerance, bounds_, now), now);
    SnapOptions snapping{options_.tolerance, bounds_};
    if (options_.box) snapping.move_to_box = joins_all ? MoveToBox::all : MoveToBox::of_free_borders;
    if (!joins_all || !options_.volume.empty()) {
      const Contacts contacts = find_contacts(complex, context_, result_.memory_bound);
      if (!joins_all) pairs_ = pairs_to_join(surfaces_.given, options_.tolerance, result_.warnings);
      snapping.rule = join_rule_ = join_rule_of(surfaces_, options_, pairs_, complex, contacts);
    }
    take(snap_near(complex, all_facets(complex), snapping, &now), now);
  }

  /// `now`: by vertex the one that stands for it.
  void take(const SnapOutcome& outcome, const std::vector<VertexIndex>& now) {
    take(outcome);
    for (auto& vertices : ingested_.vertex_of_point)
      for (VertexIndex& v : vertices) v = now[v];
  }

  void apply_tolerance(Complex& complex) {
    if (options_.tolerance > 0)
      take(snap_near(complex, all_facets(complex), {options_.tolerance, bounds_, MoveToBox::none, join_rule_}));
  }

  void take(const SnapOutcome& outcome) {
    add(outcome.moved, result_.merging.displacement);
    result_.merging.vertices_merged += outcome.n_vertices_merged;
    result_.merging.vertices_inserted += outcome.n_vertices_inserted;
    result_.merging.facets_merged += outcome.n_facets_merged;
    result_.merging.facets_collapsed += outcome.vanished.size();
    vanished_.insert(vanished_.end(), outcome.vanished.begin(), outcome.vanished.end());
  }

  Complex take(Rounded&& rounded) {
    add(rounded.displacement, result_.rounding);
    vanished_.insert(vanished_.end(), rounded.vanished.begin(), rounded.vanished.end());
    return std::move(rounded.complex);
  }

  const std::vector<Polyline>& polylines_;
  const std::vector<NamedPoint>& points_;
  const ArrangementOptions& options_;
  const RunContext& context_;
  ArrangementResult result_;
  SurfaceList surfaces_;
  Ingested ingested_;
  std::optional<Box3> bounds_;  ///< of the box or the volume
  std::vector<VanishedFacet> vanished_;
  PairsToJoin pairs_;
  JoinRule join_rule_;  ///< of `tolerance`
  Joining joining_;
  double first_rounding_ = 0;  ///< finer doubles, next to zero, keep no points off the sides of the box
};

}  // namespace

ArrangementResult arrange(const std::vector<TriangulatedSurface>& surfaces, const std::vector<Polyline>& polylines,
                          const std::vector<NamedPoint>& points, const ArrangementOptions& options,
                          const RunContext& context) {
  const ThreadLimit limit(context.threads);
  return Arrangement(surfaces, polylines, points, options, context).run();
}

}  // namespace geomesh::geomodel
