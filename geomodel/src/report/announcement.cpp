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

std::array<Part, 4> parts_of(const ElementEstimate& e, double tolerance, const std::string& unit, bool by_input_edges) {
  const std::string within = tolerance > 0 ? " within " + short_words(tolerance) + " " + unit : std::string();
  const Part sizes = by_input_edges
                         ? Part{e.by_sizes, "for short edges of the input and sizes requested of its parts",
                                "mesh: {size: {input_edges: false}}, or larger sizes there"}
                         : Part{e.by_sizes, "for sizes requested of units, surfaces and places", "larger sizes there"};
  return {{sizes,
           {e.by_thin_units, "in thin units", "rules: {min_thickness: L}, which closes units that are thinner"},
           {e.by_bends, "to follow bends of the surfaces" + within, "mesh: {surfaces_within: L} with a larger L"},
           {e.by_gaps, "in gaps between surfaces", "mesh: {size: {gap_layers: none}}, with flatter elements there"}}};
}

constexpr double worth_telling = 0.05;  // of the whole

}  // namespace

std::string announcement(const ElementEstimate& estimate, double size, double tolerance, const std::string& unit,
                         bool by_input_edges) {
  const double total = estimate.total();
  std::string text = std::string(announcement_start) + "about " + rounded_count(total);
  std::string parts;
  if (size > 0)
    parts = rounded_count(estimate.by_volume) + " fill the model with edges of " + short_words(size) + " " + unit;
  const Part* largest = nullptr;
  const std::array<Part, 4> further = parts_of(estimate, tolerance, unit, by_input_edges);
  for (const Part& part : further) {
    if (part.count < worth_telling * total) continue;
    parts += (parts.empty() ? "" : ", ") + rounded_count(part.count) + " more " + part.cause;
    if (!largest || part.count > largest->count) largest = &part;
  }
  if (!largest)
    return parts.empty()
               ? text
               : text + " with edges of " + short_words(size) + " " + unit + " (mesh: {size: L} changes that)";
  return text + ", of which " + parts + "; for fewer: " + largest->remedy;
}

}  // namespace geomesh::geomodel
