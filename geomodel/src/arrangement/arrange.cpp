// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the arrangement, declared in geomesh/geomodel/arrangement.hpp.
#include <algorithm>
#include <cmath>
#include <limits>

#include "arrangement/clip/clip.hpp"
#include "arrangement/diagnosis/diagnosis.hpp"
#include "arrangement/join/flatten_slivers.hpp"
#include "arrangement/join/join_surfaces.hpp"
#include "arrangement/join/lost_parts.hpp"
#include "arrangement/join_input.hpp"
#include "arrangement/model/displacement.hpp"
#include "arrangement/model/memory_bound.hpp"
#include "arrangement/pockets/close_pockets.hpp"
#include "arrangement/pockets/cut_dangling_faces.hpp"
#include "arrangement/pockets/fill_holes.hpp"
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

/// Snapping distance of a round that repairs overlaps left by rounding. These are a few ulps thin, so new points snap
/// to existing ones nearby, over a larger distance in each round. Surfaces that nearly coincide are merged within the
/// distance of the first round.
double mending_distance(double ulp, unsigned round) {
  return ulp * std::ldexp(1.0, std::min(1 + 3 * static_cast<int>(round), 9));
}

void close_thin_pockets(Complex& complex, const ArrangementOptions& options, const SurfaceList& surfaces,
                        ArrangementResult::Merging& merging) {
  const ClosedPockets closed =
      close_pockets(complex, options.tolerance, static_cast<Index>(surfaces.given.size()), options.parts);
  add(closed.moved, merging.displacement);
  merging.pockets_closed += closed.n_pockets;
  merging.facets_merged += closed.n_facets_removed;
}

/// Repairs cracks and dangling faces that vanished needles have left. Rounding moves a point by at most `rounding`.
void mend_surfaces(Complex& complex, double tolerance, double rounding, ArrangementResult& result,
                   std::vector<VanishedFacet>& vanished) {
  if (!(tolerance > 0) && result.n_rounding_rounds == 0) return;
  // Dangling faces up to this multiple of the tolerance are cut: merging may move a corner farther than its neighbours.
  constexpr double dangling_of_tolerance = 2;
  const CutDanglingFaces cut = cut_dangling_faces(complex, std::max(dangling_of_tolerance * tolerance, rounding));
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

/// Throws a ModelError that names surfaces that still cross after all rounds, because rounding makes new crossings.
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

/// A point that is not from the input and lies on three surfaces is a triple point.
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

std::vector<std::uint8_t> all_facets(const Complex& complex) {
  return std::vector<std::uint8_t>(complex.facets.size(), 1);
}

/// Returns the sides of the model's box or volume as surfaces. Throws if the box is empty.
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

/// Returns those planes of the bounding box in which triangles of the volume's sides lie; the others are set to
/// infinity because a rotated box touches its bounding box only at its edges.
std::optional<Box3> planes_of(const std::vector<TriangulatedSurface>& sides, const std::optional<Box3>& bounds) {
  if (!bounds) return std::nullopt;
  constexpr double far = std::numeric_limits<double>::infinity();
  Box3 planes{{-far, -far, -far}, {far, far, far}};
  for (const TriangulatedSurface& s : sides)
    for (const Triangle& t : s.triangles)
      for (std::size_t i = 0; i < 3; ++i) {
        const auto lies_at = [&](double x) {
          return std::ranges::all_of(t, [&](VertexIndex v) { return s.points[v][i] == x; });
        };
        if (lies_at(bounds->min[i])) planes.min[i] = bounds->min[i];
        if (lies_at(bounds->max[i])) planes.max[i] = bounds->max[i];
      }
  return planes;
}

/// Marks the facets that touch, cross or overlap others.
std::vector<std::uint8_t> marks_of(const Contacts& contacts, const Complex& complex) {
  std::vector<std::uint8_t> marks(complex.facets.size(), 0);
  for (const FacetContact& c : contacts.facets) {
    marks[c.facet] = 1;
    if (c.other != no_index) marks[c.other] = 1;
  }
  for (const Overlap& o : contacts.overlaps) marks[o.a] = marks[o.b] = 1;
  return marks;
}

constexpr unsigned most_snaps = 6;  // in one round

/// Merges facets that still cross, touch or overlap others after rounding with all that is within mending_distance().
SnapOutcome snap_what_meets(Complex& complex, const Contacts& contacts, unsigned round,
                            const std::optional<Box3>& bounds) {
  if (contacts.empty()) return {};
  return snap_near(complex, marks_of(contacts, complex),
                   {mending_distance(unit_in_the_last_place(complex), round), bounds});
}

/// Limits on the numbers of rounds and contacts. Beyond them, repairing what rounding breaks is given up as endless.
class MendingBounds {
 public:
  MendingBounds(const Contacts& contacts, unsigned most_rounds)
      : fewest_contacts_(contacts.facets.size()), most_rounds_(most_rounds) {}
  /// Returns whether there are so many rounds or contacts that repairing crossings seems to have no end.
  bool has_no_end(unsigned round, const Contacts& contacts) {
    const std::size_t n = contacts.facets.size(), most = 4 * fewest_contacts_ + 1000;
    fewest_contacts_ = std::min(fewest_contacts_, n);
    return round > most_rounds_ || n > most;
  }

 private:
  std::size_t fewest_contacts_;
  unsigned most_rounds_;
};

/// State of one arrangement: its input, and the results of its rounds so far.
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
    planes_ = planes_of(result_.box_sides, bounds_);
    joining_ = {mending_distance(first_rounding_, 1), planes_, surfaces.size(), !options.box};
    result_.memory_bound = options.max_memory > 0 ? options.max_memory : default_memory_bound();
    result_.warnings = std::move(ingested_.warnings);
    result_.area_clipped_by_bodies.assign(surfaces.size(), 0);
    result_.area_clipped_by_box = ingested_.area_outside;
  }

  ArrangementResult run() {
    InputJoiner joiner(ingested_, surfaces_, options_, joining_, context_);
    joiner.join(book_, result_.warnings, result_.memory_bound);
    book_lost_parts(ingested_.complex);
    Contacts contacts = find_contacts(ingested_.complex, context_, result_.memory_bound);
    join_rule_ = joiner.rule(contacts);
    result_.n_pairs = contacts.n_pairs;
    log_round(context_, 0, ingested_.complex, contacts);
    Complex complex = first_round(contacts);
    apply_tolerance(complex);
    MendingBounds bounds(contacts, options_.max_rounding_rounds);
    for (unsigned round = 1;; ++round) {
      contacts = find_contacts(complex, context_, result_.memory_bound);
      if (contacts.empty()) break;
      log_round(context_, round, complex, contacts);
      result_.n_rounding_rounds = round;
      if (const auto joined = join_what_lies_in_each_other(complex, contacts, joining_)) {
        book_.take(*joined);
        contacts = find_contacts(complex, context_, result_.memory_bound);
      }
      for (unsigned k = 0; k < most_snaps; ++k) {
        const SnapOutcome outcome = snap_what_meets(complex, contacts, round, planes_);
        if (!outcome.changed()) break;
        book_.take(outcome);
        contacts = find_contacts(complex, context_, result_.memory_bound);
      }
      if (contacts.empty()) break;
      if (bounds.has_no_end(round, contacts)) refuse(surfaces_, complex, contacts);
      complex = round_again(complex, contacts, round);
      apply_tolerance(complex);
    }
    if (options_.tolerance > 0) book_.take(flatten_slivers(complex, joining_, context_, result_.memory_bound));
    book_lost_parts(complex);
    if (options_.tolerance > 0) close_thin_pockets(complex, options_, surfaces_, result_.merging);
    mend_surfaces(complex, options_.tolerance, joining_.distance, result_, book_.vanished);
    result_.soup = soup_of(std::move(complex));
    diagnose_soup(surfaces_, book_.vanished, result_);
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
    end_continuations(clip, options_);
    add(cut_by_bodies(clip, ingested_.complex, ingested_, bounds_, crosses_itself), result_.merging.displacement);
    context_.check_cancelled();
    return take(round_to_doubles(arranged, ingested_.complex,
                                 {.snap = first_rounding_, .box = planes_, .onto_sides_alone = true}));
  }

  Complex round_again(const Complex& complex, const Contacts& contacts, unsigned round) {
    const Arranged arranged = arrange_round(complex, contacts, context_, result_.memory_bound);
    return take(
        round_to_doubles(arranged, complex, {mending_distance(unit_in_the_last_place(complex), round), planes_}));
  }

  void apply_tolerance(Complex& complex) {
    if (options_.tolerance > 0)
      book_.take(snap_near(complex, all_facets(complex), {options_.tolerance, planes_, MoveToBox::none, join_rule_}));
  }

  /// Records the movement of facets that have vanished since the last call.
  void book_lost_parts(const Complex& complex) {
    if (!(options_.tolerance > 0)) return;
    add(lost_with(std::span(book_.vanished).subspan(n_booked_), complex, options_.tolerance),
        result_.merging.displacement);
    n_booked_ = book_.vanished.size();
  }

  Complex take(Rounded&& rounded) {
    add(rounded.displacement, result_.rounding);
    book_.vanished.insert(book_.vanished.end(), rounded.vanished.begin(), rounded.vanished.end());
    return std::move(rounded.complex);
  }

  const std::vector<Polyline>& polylines_;
  const std::vector<NamedPoint>& points_;
  const ArrangementOptions& options_;
  const RunContext& context_;
  ArrangementResult result_;
  MergingBook book_{result_.merging};
  SurfaceList surfaces_;
  Ingested ingested_;
  std::optional<Box3> bounds_;
  std::optional<Box3> planes_;  ///< planes of the bounding box that contain triangles of the volume's sides
  JoinRule join_rule_;          ///< of `tolerance`
  Joining joining_;
  std::size_t n_booked_ = 0;  ///< number of vanished facets whose movement was recorded
  /// Unit in the last place of the coordinates of the whole input. That of a clipped model close to zero would be
  /// finer, and constructed points would then not snap onto the sides of the box.
  double first_rounding_ = 0;
};

}  // namespace

ArrangementResult arrange(const std::vector<TriangulatedSurface>& surfaces, const std::vector<Polyline>& polylines,
                          const std::vector<NamedPoint>& points, const ArrangementOptions& options,
                          const RunContext& context) {
  const ThreadLimit limit(context.threads);
  return Arrangement(surfaces, polylines, points, options, context).run();
}

}  // namespace geomesh::geomodel
