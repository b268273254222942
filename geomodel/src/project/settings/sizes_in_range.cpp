// SPDX-License-Identifier: GPL-3.0-or-later
#include "geomesh/geomodel/sizes_in_range.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "geomesh/core/error.hpp"
#include "geomesh/geomodel/words.hpp"

namespace geomesh::geomodel {

namespace {

/// Least target size as a share of the model's longest edge. A cube with edges a millionth as long has 1e19 elements,
/// which no machine can hold; a size in another unit than the model is too small by a thousand or more.
constexpr double least_share = 1e-6;
/// Largest tolerance as a share of the model's diagonal, as the engine requires (core/src/remesh/driver).
constexpr double greatest_tolerance = 0.1;

std::string length_words(double length) {
  constexpr double with_separators = 1000;
  return length >= with_separators ? count_words(length) : short_words(length);
}

class Range {
 public:
  explicit Range(const Box3& bounds) {
    const Vec3 extent = bounds.max - bounds.min;
    longest_ = std::max({extent.x, extent.y, extent.z});
    shortest_ = std::min({extent.x, extent.y, extent.z});
    diagonal_ = std::hypot(extent.x, extent.y, extent.z);
    suggestion_ = derived_size(bounds);
  }

  bool is_known() const { return longest_ > 0 && std::isfinite(longest_); }

  void require_thick() const {
    if (shortest_ > 0 && shortest_ < least_thickness * longest_)
      refuse(
          "the model is " + length_words(shortest_) + " thick and " + length_words(longest_) +
          " long: no mesh has elements for both. Are all limits of the box in the same unit, with no digit too many?");
  }

  /// Refuses a target size outside the plausible range; a size of 0 means that none is given.
  void require_size(const std::string& key, double size) const {
    if (!(size > 0) || (size <= longest_ && size >= least_share * longest_)) return;
    const bool is_long = size > longest_;
    refuse(key + ": edges of " + length_words(size) + " are " +
           (is_long ? "longer than the model, whose longest edge is "
                    : "shorter than a millionth of the model's longest edge of ") +
           length_words(longest_) + suggested(is_long));
  }

  /// Refuses a size limit that is too short; a limit longer than the model has no effect and is accepted.
  void require_not_short(const std::string& key, double size) const { require_size(key, std::min(size, longest_)); }

  /// Refuses a gradation outside the useful range. With the steepest one, sizes grow from the least to the greatest
  /// within one edge; with the least, the smallest size applies in the whole model.
  static void require_gradation(double gradation) {
    if (gradation <= 1 / least_share && gradation >= least_share) return;
    refuse("mesh.size.gradation: sizes that grow by " + short_words(gradation) + " for each unit of distance are " +
           (gradation > 1 ? "not graded at all" : "the same everywhere") + "; 0.1 to 0.5 is usual");
  }

  void require_tolerance(double tolerance) const {
    const std::string key = "mesh.surfaces_within: a tolerance of " + length_words(tolerance);
    const std::string start = "; a thousandth of the diagonal, " + short_words(0.001 * diagonal_) +
                              ", is a good start. Is it in the model's units?";
    if (tolerance > greatest_tolerance * diagonal_)
      refuse(key + " is more than a tenth of the model's diagonal of " + length_words(diagonal_) +
             ": little would be left of its surfaces" + start);
    if (tolerance > 0 && tolerance < least_told_apart * diagonal_)
      refuse(key + " is less than a billionth of the model's diagonal of " + length_words(diagonal_) +
             ": 'honour: exact' keeps every triangle of the surfaces" + start);
  }

 private:
  [[noreturn]] static void refuse(const std::string& text) { throw Error(ErrorKind::usage, text); }

  std::string suggested(bool is_long) const {
    if (!(suggestion_ > 0)) return "; is it in the model's units?";
    return "; " + length_words(suggestion_) +
           " would come to about 100,000 elements. Is it in the model's units, with " +
           (is_long ? "no digit too many?" : "no digit missing?");
  }

  double longest_ = 0, shortest_ = 0, diagonal_ = 0, suggestion_ = 0;
};

}  // namespace

void require_countable(const RefinementSettings& settings, double volume, const std::string& unit) {
  const double size = settings.size.base.global;
  if (!settings.refine || settings.target_elements > 0 || !(size > 0)) return;
  const double count = elements_of_volume(volume, size), limit = static_cast<double>(settings.max_elements);
  if (!(count > limit)) return;
  throw Error(ErrorKind::cannot_mesh, "edges of " + short_words(size) + " " + unit + " fill the model with about " +
                                          count_words(count) + " elements, more than the limit of " +
                                          count_words(limit) + " (mesh: {max_elements}): edges of " +
                                          short_words(size * std::cbrt(count / limit)) + " " + unit +
                                          " are the least for that. Is the size in the model's units?");
}

void require_sizes_in_range(const RefinementSettings& settings, const Box3& bounds) {
  const Range range(bounds);
  if (!settings.refine || !range.is_known()) return;
  range.require_thick();
  const NamedSizes& size = settings.size;
  const std::string waves = size.frequency > 0 ? ".frequency" : "";
  range.require_size("mesh.size" + waves, size.base.global);
  range.require_size("mesh.size.min", size.base.min_size);
  range.require_not_short("mesh.size.max", size.base.max_size);
  range.require_gradation(size.base.gradation);
  const auto require_all = [&](const char* key, const std::map<std::string, AskedSize>& named) {
    for (const auto& [name, asked] : named)
      range.require_size(std::string("mesh.size.") + key + "." + name, asked.size);
  };
  require_all("units", size.units);
  require_all("surfaces", size.surfaces);
  require_all("curves", size.curves);
  for (const PlaceSize& near : size.near) range.require_size("mesh.size.near", near.asked.size);
  for (const NamedSizes::DepthSize& row : size.by_depth) range.require_size("mesh.size.by_depth", row.size);
  if (settings.honour == Honour::tolerance && !settings.tolerance.follows_sizes())
    range.require_tolerance(settings.tolerance.left());
}

}  // namespace geomesh::geomodel
