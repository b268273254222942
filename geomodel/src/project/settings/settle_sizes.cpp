// SPDX-License-Identifier: GPL-3.0-or-later
// Completes the mesh settings that depend on the model, declared in geomesh/geomodel/refinement.hpp.
#include <algorithm>
#include <cmath>

#include "geomesh/core/error.hpp"
#include "geomesh/geomodel/refinement.hpp"
#include "geomesh/geomodel/sizes_in_range.hpp"
#include "geomesh/geomodel/words.hpp"

namespace geomesh::geomodel {

namespace {

/// Number of elements per volume in units of the cubed size, as in estimate_elements: a regular tetrahedron with unit
/// edges has the volume 1 / 8.5, and a mesh of uniform size has a third more elements.
constexpr double elements_per_volume = 11.2;

double two_digits(double x) {
  const double unit = std::pow(10, std::floor(std::log10(x)) - 1);
  return unit >= 1 ? std::round(x / unit) * unit : std::round(x / unit) / std::round(1 / unit);
}

double size_at_depth(const std::vector<NamedSizes::DepthSize>& table, double depth) {
  const auto below = std::find_if(table.begin(), table.end(), [&](const auto& row) { return row.depth > depth; });
  if (below == table.begin()) return table.front().size;
  if (below == table.end()) return table.back().size;
  const auto above = below - 1;
  const double share = (depth - above->depth) / (below->depth - above->depth);
  return (1 - share) * above->size + share * below->size;
}

/// Combines target sizes by depth with those of a background file; the smaller one is used.
void add_depths(NamedSizes& sizes, const Vec3& origin) {
  if (sizes.by_depth.empty()) return;
  sizes.base.background = [table = sizes.by_depth, file = sizes.base.background, zero = origin.z](const Vec3& p) {
    const double by_depth = size_at_depth(table, -(p.z + zero)), by_file = file ? file(p) : 0;
    return by_file > 0 ? std::min(by_file, by_depth) : by_depth;
  };
}

/// Returns the largest target size that wavelengths allow in any unit.
double greatest_wavelength_size(const NamedSizes& sizes, const UnitAttributes& attributes) {
  double greatest = 0;
  for (const auto& [unit, values] : attributes) greatest = std::max(greatest, wavelength_size(sizes, values));
  if (!(greatest > 0))
    throw Error(ErrorKind::usage,
                "mesh.size.frequency: no unit has a velocity; give each one in 'attributes', as chalk: {vp: 3000}");
  return greatest;
}

}  // namespace

double elements_of_volume(double volume, double size) { return elements_per_volume * volume / (size * size * size); }

std::string count_words(double count) {
  constexpr double countable = 1e12;
  if (!(count < countable)) return short_words(count);
  std::string digits = std::to_string(std::llround(count));
  for (std::size_t at = digits.size(); at > 3;) digits.insert(at -= 3, ",");
  return digits;
}

std::string rounded_count(double count) { return count_words(count < 1 ? count : two_digits(count)); }

double derived_size(const Box3& bounds, double elements) {
  const Vec3 extent = bounds.max - bounds.min;
  const double volume = extent.x * extent.y * extent.z;
  return volume > 0 ? two_digits(std::cbrt(elements_per_volume * volume / elements)) : 0;
}

double wavelength_size(const NamedSizes& sizes, const std::map<std::string, double>& attributes) {
  const auto value = [&](const char* name) {
    const auto at = attributes.find(name);
    return at == attributes.end() ? 0.0 : at->second;
  };
  const double velocity = value("vs") > 0 ? value("vs") : value("vp");
  return velocity / (sizes.frequency * sizes.points_per_wavelength);
}

void settle_sizes(RefinementSettings& settings, const Box3& bounds, const UnitAttributes& attributes,
                  const Vec3& origin) {
  SizeOptions& size = settings.size.base;
  if (settings.size.frequency > 0) {
    const double by_waves = greatest_wavelength_size(settings.size, attributes);
    size.global = size.global > 0 ? std::min(size.global, by_waves) : by_waves;
  } else if (settings.derive_size) {
    if (settings.target_elements > 0) settings.derived_elements = settings.target_elements;
    size.global = derived_size(bounds, settings.derived_elements);
  }
  add_depths(settings.size, origin);
  if (!settings.tolerance.follows_sizes()) return;
  double greatest = size.global > 0 ? size.global : derived_size(bounds, settings.derived_elements);
  if (size.max_size > 0) greatest = std::min(greatest, size.max_size);
  settings.tolerance.follow_size(greatest);
}

double merging_distance(const RefinementSettings& settings) {
  constexpr double share_of_tolerance = 0.2;
  const NamedSizes& size = settings.size;
  const bool is_within_tolerance =
      settings.refine && settings.honour == Honour::tolerance && settings.tolerance.left() > 0;
  if (!is_within_tolerance || !size.background.empty()) return 0;
  const ToleranceLedger& tolerance = settings.tolerance;
  const double share = tolerance.follows_sizes() ? tolerance.left_share() : default_tolerance_share;
  double least = tolerance.left() / share;
  if (size.base.global > 0) least = std::min(least, size.base.global);
  const auto ask = [&](const AskedSize& asked) { least = asked.size > 0 ? std::min(least, asked.size) : least; };
  for (const auto* named : {&size.units, &size.surfaces, &size.curves})
    for (const auto& [name, asked] : *named) ask(asked);
  for (const PlaceSize& near : size.near) ask(near.asked);
  for (const auto& row : size.by_depth) ask({row.size, 0});
  return share_of_tolerance * share * least;
}

RefinementSettings preview_settings() {
  RefinementSettings preview;
  preview.refine = preview.derive_size = true;
  preview.derived_elements = 1e4;
  preview.honour = Honour::tolerance;
  preview.tolerance = ToleranceLedger::of_sizes(default_tolerance_share);
  preview.quality = QualityLevel::fast;
  preview.size.base.from_input_edges = false;
  preview.size.base.gap_layers = 0;
  return preview;
}

}  // namespace geomesh::geomodel
