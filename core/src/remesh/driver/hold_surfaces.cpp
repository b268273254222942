// SPDX-License-Identifier: MIT
#include "remesh/driver/hold_surfaces.hpp"

#include <algorithm>
#include <cstdio>
#include <string>
#include <utility>

#include "geomesh/core/error.hpp"
#include "remesh/operations/surface_repair.hpp"

namespace geomesh::remesh {

Deviations hold_to_tolerance(Toolbox& tools, const RunContext& context) {
  constexpr unsigned most_rounds = 8;
  Deviations found = tools.guard.deviations(tools.mesh, context.threads);
  for (unsigned round = 0; round < most_rounds && !found.breaches.empty(); ++round) {
    context.check_cancelled();
    if (mend_surfaces(tools, found.breaches) == 0) break;
    found = tools.guard.deviations(tools.mesh, context.threads);
  }
  return found;
}

namespace {

bool overlap(const Box3& a, const Box3& b) {
  for (std::size_t i = 0; i < 3; ++i)
    if (a.min[i] > b.max[i] || b.min[i] > a.max[i]) return false;
  return true;
}

Vec3 centre(const Box3& box) { return 0.5 * (box.min + box.max); }

std::string place_words(const Vec3& p) {
  char text[120];
  std::snprintf(text, sizeof text, "(%.9g, %.9g, %.9g)", p.x, p.y, p.z);
  return text;
}

}  // namespace

void tighten(Hold& hold, const Attempt& attempt, double tolerance) {
  constexpr double closer = 0.65, closer_in_zones = 0.25, about_zones = 4;
  if (!attempt.breaches.empty() || hold.run > 1) hold.margin *= closer;
  const double reach = about_zones * tolerance;
  const std::size_t n_before = hold.zones.size();
  for (TightZone zone : attempt.crossings) {
    zone.tolerance = tolerance;
    for (std::size_t k = 0; k < n_before; ++k)
      if (overlap(hold.zones[k].box, zone.box)) zone.tolerance = std::min(zone.tolerance, hold.zones[k].tolerance);
    zone.tolerance *= closer_in_zones;
    zone.box = {zone.box.min - Vec3{reach, reach, reach}, zone.box.max + Vec3{reach, reach, reach}};
    hold.zones.push_back(zone);
  }
  ++hold.run;
}

void tell_what_is_off(const Attempt& attempt, const RunContext& context) {
  constexpr std::size_t most = 20;
  context.note(LogLevel::info, "surfaces are not as promised in " +
                                   std::to_string(attempt.breaches.size() + attempt.crossings.size()) +
                                   " places: held more closely and refined again");
  for (std::size_t i = 0; i < std::min(most, attempt.breaches.size()); ++i)
    context.note(LogLevel::debug, "not proven to be within the tolerance at " + place_words(attempt.breaches[i].place));
  for (std::size_t i = 0; i < std::min(most, attempt.crossings.size()); ++i)
    context.note(LogLevel::debug,
                 "surfaces cross through the outside at " + place_words(centre(attempt.crossings[i].box)));
}

void refuse_tolerance(const Attempt& attempt) {
  constexpr const char* what_to_do =
      ". Ask for another tolerance, for smaller sizes there, or keep the surfaces exactly";
  ErrorContext context;
  if (!attempt.crossings.empty()) {
    const Vec3 place = centre(attempt.crossings.front().box);
    context.places.push_back(place);
    throw Error(ErrorKind::cannot_mesh,
                "surfaces that are nearer to each other than the tolerance, with the outside between, could not be "
                "remeshed without crossing, at " +
                    place_words(place) + what_to_do,
                std::move(context));
  }
  const auto& breaches = attempt.breaches;
  const auto worst = std::max_element(breaches.begin(), breaches.end(),
                                      [](const auto& a, const auto& b) { return a.distance < b.distance; });
  context.places.push_back(worst->place);
  for (const auto& b : breaches) {
    context.places.push_back(b.place);
    if (b.facet != no_index) context.facets.push_back(b.facet);
  }
  throw Error(
      ErrorKind::cannot_mesh,
      "surfaces could not be remeshed so that they are proven to be within the tolerance of the input, both ways: " +
          std::to_string(breaches.size()) + " triangles or pieces of curves are not, the worst at " +
          place_words(worst->place) + what_to_do,
      std::move(context));
}

}  // namespace geomesh::remesh
