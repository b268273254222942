// SPDX-License-Identifier: MIT
#include "remesh/driver/hold_surfaces.hpp"

#include <algorithm>
#include <cstdio>
#include <string>
#include <utility>

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

}  // namespace geomesh::remesh
