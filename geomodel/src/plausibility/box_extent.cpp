// SPDX-License-Identifier: GPL-3.0-or-later
// Detects a box that is far larger than its horizons suggest, or one horizon that is far larger than all others;
// declared in plausibility/doubts.hpp.
#include <algorithm>

#include "geomesh/geomodel/words.hpp"
#include "plausibility/doubts.hpp"

namespace geomesh::geomodel {
namespace {

/// Largest plausible ratio of the box's length to that of its horizons, and of one horizon to all others together. A
/// box that leaves room for stresses to decay, or for waves to leave, is about ten times as long as its horizons.
constexpr double most_times = 50;

struct Extent {
  std::string name;
  Box3 box;
  double along(std::size_t axis) const { return box.max[axis] - box.min[axis]; }
};

/// Returns the extents of all horizons; empty if the project states for a horizon how it is extended, or that it ends.
std::vector<Extent> extents_of_horizons(const Inspected& model) {
  std::vector<Extent> found;
  for (std::size_t s = 0; s < model.inputs.surfaces.size(); ++s) {
    const TriangulatedSurface& surface = model.inputs.surfaces[s];
    if (surface.kind != SurfaceKind::horizon || surface.points.empty()) continue;
    const SurfaceRules rule = model.project.rules.of(s);
    if (rule.extend != Extend::none || !rule.continues) return {};
    Box3& box = found.emplace_back(Extent{surface.name, {}}).box;
    for (const Vec3& p : surface.points) box.add(p);
  }
  return found;
}

double length_of(const std::vector<Extent>& extents, std::size_t axis) {
  Box3 all;
  for (const Extent& e : extents) {
    all.add(e.box.min);
    all.add(e.box.max);
  }
  return all.max[axis] - all.min[axis];
}

class BoxDoubts {
 public:
  BoxDoubts(const Inspected& model, std::vector<Finding>& findings)
      : model_(model), horizons_(extents_of_horizons(model)), findings_(findings) {}

  /// Compares the box with the horizons if the project gives the limits of the box.
  void compare_box() {
    for (std::size_t axis = 0; axis < 2 && !horizons_.empty(); ++axis) {
      const double of_box = model_.volume->max[axis] - model_.volume->min[axis], of_data = length_of(horizons_, axis);
      if (!(of_box > most_times * of_data)) continue;
      std::vector<std::string> names;
      for (const Extent& e : horizons_) names.push_back(e.name);
      return tell(names,
                  few_of(names) + (names.size() > 1 ? " reach" : " reaches") + " over " + words(of_data) +
                      " of the box's " + words(of_box) + " in " + "xy"[axis],
                  "are the limits of the box in the unit of the data, with no digit too many?");
    }
  }

  /// Compares the horizontal lengths of the horizons if the box is a margin around the data. Horizons that were already
  /// reported as misplaced, or in another unit, are ignored.
  void compare_horizons() {
    std::erase_if(horizons_, [&](const Extent& e) {
      return std::ranges::any_of(findings_, [&](const Finding& f) { return std::ranges::count(f.inputs, e.name) > 0; });
    });
    if (horizons_.size() < 3) return;  // with only two horizons, the data of either could be wrong, so none is reported
    for (std::size_t axis = 0; axis < 2; ++axis) {
      std::vector<Extent> rest = horizons_;
      const auto longest = std::ranges::max_element(rest, {}, [&](const Extent& e) { return e.along(axis); });
      const Extent one = *longest;
      rest.erase(longest);
      if (!(one.along(axis) > most_times * length_of(rest, axis))) continue;
      return tell({one.name},
                  one.name + " reaches over " + words(one.along(axis)) + " in " + "xy"[axis] + ", the other " +
                      std::to_string(rest.size()) + " horizons together over " + words(length_of(rest, axis)),
                  "is the spacing or unit of " + one.name + " right, with no digit too many?");
    }
  }

 private:
  std::string words(double length) const { return short_words(length) + " " + model_.project.crs.unit; }

  void tell(const std::vector<std::string>& of, const std::string& text, const std::string& question) {
    findings_.push_back(
        {Finding::Sureness::certain, "extent of the box", of,
         text + ", so that nearly all of the model would be made up",
         question + " If this is meant, say in the horizons' entries how they go on (extend: flat, tangent or none)"});
  }

  const Inspected& model_;
  std::vector<Extent> horizons_;
  std::vector<Finding>& findings_;
};

}  // namespace

void doubt_box_extent(const Inspected& model, std::vector<Finding>& findings) {
  if (!model.volume) return;
  BoxDoubts doubts(model, findings);
  if (model.project.box->shape == VolumeSpec::Shape::margin)
    doubts.compare_horizons();
  else
    doubts.compare_box();
}

}  // namespace geomesh::geomodel
