// SPDX-License-Identifier: GPL-3.0-or-later
// A box that is far larger than what its horizons tell of it, declared in plausibility/doubts.hpp.
#include <algorithm>

#include "geomesh/geomodel/words.hpp"
#include "plausibility/doubts.hpp"

namespace geomesh::geomodel {
namespace {

/// A box may be this many times as long as the data of its horizons. One that leaves room for stresses to die out, or
/// for waves to leave, is some ten times as long.
constexpr double most_times = 50;

struct Extents {
  std::vector<std::string> names;
  std::vector<Box3> boxes;
};

/// Of all horizons. Empty where one of them says how it goes on, or that it ends.
Extents extents_of_horizons(const Inspected& model) {
  Extents found;
  for (std::size_t s = 0; s < model.inputs.surfaces.size(); ++s) {
    const TriangulatedSurface& surface = model.inputs.surfaces[s];
    if (surface.kind != SurfaceKind::horizon || surface.points.empty()) continue;
    const SurfaceRules rule = model.project.rules.of(s);
    if (rule.extend != Extend::none || !rule.continues) return {};
    found.names.push_back(surface.name);
    Box3& box = found.boxes.emplace_back();
    for (const Vec3& p : surface.points) box.add(p);
  }
  return found;
}

/// Without those that are said to lie elsewhere, or to be in another unit.
Extents without_doubted(const Extents& all, const std::vector<Finding>& findings) {
  Extents found;
  for (std::size_t k = 0; k < all.names.size(); ++k)
    if (std::ranges::none_of(findings,
                             [&](const Finding& f) { return std::ranges::count(f.inputs, all.names[k]) > 0; })) {
      found.names.push_back(all.names[k]);
      found.boxes.push_back(all.boxes[k]);
    }
  return found;
}

double length_of(const Extents& extents, std::size_t axis) {
  Box3 all;
  for (const Box3& box : extents.boxes) {
    all.add(box.min);
    all.add(box.max);
  }
  return all.max[axis] - all.min[axis];
}

/// Takes the longest away, and returns its name and length.
std::pair<std::string, double> take_longest(Extents& extents, std::size_t axis) {
  const auto length = [&](const Box3& box) { return box.max[axis] - box.min[axis]; };
  const auto longest = std::ranges::max_element(extents.boxes, {}, length);
  const auto row = longest - extents.boxes.begin();
  std::pair<std::string, double> taken{extents.names[row], length(*longest)};
  extents.names.erase(extents.names.begin() + row);
  extents.boxes.erase(longest);
  return taken;
}

constexpr const char* if_meant =
    "If it is meant, say in the horizons' entries how they go on (extend: flat, tangent or none)";

}  // namespace

void doubt_box_extent(const Inspected& model, std::vector<Finding>& findings) {
  if (!model.volume) return;
  const Extents all = extents_of_horizons(model);
  if (all.names.empty()) return;
  const auto words = [&](double length) { return short_words(length) + " " + model.project.crs.unit; };
  const auto tell = [&](const std::vector<std::string>& of, const std::string& text, const std::string& advice) {
    findings.push_back({Finding::Sureness::certain, "extent of the box", of,
                        text + ", so that nearly all of the model would be made up", advice + " " + if_meant});
  };
  const bool is_laid_about_data = model.project.box->shape == VolumeSpec::Shape::margin;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double of_box = model.volume->max[axis] - model.volume->min[axis], of_data = length_of(all, axis);
    const std::string way = std::string(" in ") + "xy"[axis];
    if (!is_laid_about_data && of_box > most_times * of_data)
      return tell(all.names,
                  few_of(all.names) + (all.names.size() > 1 ? " reach" : " reaches") + " over " + words(of_data) +
                      " of the box's " + words(of_box) + way,
                  "are the limits of the box in the unit of the data, with no digit too many?");
    Extents rest = without_doubted(all, findings);
    if (!is_laid_about_data || rest.names.size() < 3) continue;
    const auto [longest, length] = take_longest(rest, axis);
    if (length > most_times * length_of(rest, axis))
      return tell({longest},
                  longest + " reaches over " + words(length) + way + ", the other " +
                      std::to_string(rest.names.size()) + " horizons together over " + words(length_of(rest, axis)),
                  "is the spacing or unit of " + longest + " right, with no digit too many?");
  }
}

}  // namespace geomesh::geomodel
