// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/announcement.hpp"

#include <algorithm>
#include <array>

#include "geomesh/geomodel/announcement.hpp"
#include "geomesh/geomodel/sizes_in_range.hpp"
#include "geomesh/geomodel/words.hpp"

namespace geomesh::geomodel {

namespace {

struct Part {
  double count;
  std::string cause, remedy;
};

std::array<Part, 4> parts_of(const ElementEstimate& e, const RefineOptions& o, const std::string& unit) {
  const std::string within = o.honour == Honour::tolerance && o.tolerance > 0
                                 ? " within " + short_words(o.tolerance) + " " + unit
                                 : std::string();
  return {{{e.by_sizes, "for sizes asked of units, surfaces and places", "larger sizes there"},
           {e.by_thin_units, "in thin units", "rules: {min_thickness: L}, which closes units that are thinner"},
           {e.by_bends, "to follow bends of the surfaces" + within, "mesh: {tolerance: L} with a larger L"},
           {e.by_gaps, "in gaps between surfaces", "mesh: {size: {gap_layers: none}}, with flatter elements there"}}};
}

constexpr double worth_telling = 0.05;  // of the whole

}  // namespace

std::string announcement(const ElementEstimate& estimate, const RefineOptions& options, const std::string& unit) {
  const double total = estimate.total();
  std::string text = std::string(announcement_start) + "about " + rounded_count(total);
  std::string parts;
  if (options.size.global > 0)
    parts = rounded_count(estimate.by_volume) + " fill the model with edges of " + short_words(options.size.global) +
            " " + unit;
  const Part* largest = nullptr;
  const std::array<Part, 4> further = parts_of(estimate, options, unit);
  for (const Part& part : further) {
    if (part.count < worth_telling * total) continue;
    parts += (parts.empty() ? "" : ", ") + rounded_count(part.count) + " more " + part.cause;
    if (!largest || part.count > largest->count) largest = &part;
  }
  if (!parts.empty()) text += ", of which " + parts;
  if (largest) text += "; for fewer: " + largest->remedy;
  return text;
}

}  // namespace geomesh::geomodel
