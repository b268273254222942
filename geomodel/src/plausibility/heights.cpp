// SPDX-License-Identifier: GPL-3.0-or-later
// Detects horizons whose heights are in another unit than those of the others, declared in plausibility/doubts.hpp.
#include <algorithm>
#include <cmath>

#include "geomesh/geomodel/words.hpp"
#include "plausibility/doubts.hpp"

namespace geomesh::geomodel {
namespace {

struct Heights {
  std::string name;
  double least = 0, greatest = 0;
  double relief() const { return greatest - least; }
  double size() const { return std::max(std::abs(least), std::abs(greatest)); }
};

std::vector<Heights> heights_of_horizons(const Inspected& model) {
  std::vector<Heights> heights;
  for (const TriangulatedSurface& s : model.inputs.surfaces) {
    if (s.kind != SurfaceKind::horizon || s.points.empty()) continue;
    const auto [low, high] = std::ranges::minmax_element(s.points, {}, &Vec3::z);
    const double zero = model.project.output.origin.z;
    heights.push_back({s.name, low->z + zero, high->z + zero});
  }
  return heights;
}

double middle(std::vector<double> values) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// Returns whether a ratio of heights is nearer to a unit's conversion factor than to 1, on a logarithmic scale.
bool is_nearer_to(double factor, double ratio) {
  return std::abs(std::log(ratio / factor)) < std::abs(std::log(ratio));
}

}  // namespace

void doubt_heights(const Inspected& model, std::vector<Finding>& findings) {
  struct Unit {
    double factor;
    const char *share, *words, *key;
  };
  constexpr Unit units[] = {{1000, "a thousandth", "kilometres where metres were understood", "km"},
                            {0.001, "a thousand times", "metres where kilometres were understood", "m"}};
  const std::vector<Heights> all = heights_of_horizons(model);
  if (all.size() < 3) return;  // with only two horizons, either could be in the wrong unit, so none is reported
  for (const Heights& one : all) {
    std::vector<double> sizes, reliefs;
    double least = 0, greatest = 0;  // over the others
    for (const Heights& other : all) {
      if (&other == &one) continue;
      least = sizes.empty() ? other.least : std::min(least, other.least);
      greatest = sizes.empty() ? other.greatest : std::max(greatest, other.greatest);
      sizes.push_back(other.size());
      reliefs.push_back(other.relief());
    }
    for (const Unit& unit : units) {
      // Both the heights and the relief of a horizon must differ from those of the others by the factor of a unit: a
      // sea floor is shallow and a salt flat is level, but neither differs in both by the same factor.
      const double size = middle(sizes) / one.size(), relief = middle(reliefs) / one.relief();
      const double low = unit.factor * one.least, high = unit.factor * one.greatest;
      const bool is_level = !(one.relief() > 0) || !(relief > 0) || !(size > 0);
      if (is_level || !is_nearer_to(unit.factor, size) || !is_nearer_to(unit.factor, relief)) continue;
      if (high < least || low > greatest) continue;
      findings.push_back({Finding::Sureness::probable,
                          "unit of z",
                          {one.name},
                          "horizon " + one.name + " lies within z " + short_words(one.least) + " to " +
                              short_words(one.greatest) + ", heights and relief " + unit.share +
                              " of those of the other horizons: are its heights in " + unit.words + "?",
                          std::string("if so, give 'z_unit: ") + unit.key + "' in its entry"});
    }
  }
}

}  // namespace geomesh::geomodel
