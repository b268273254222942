// SPDX-License-Identifier: GPL-3.0-or-later
// A box that is far larger than what its horizons tell of it, declared in plausibility/doubts.hpp.
#include "geomesh/geomodel/words.hpp"
#include "plausibility/doubts.hpp"

namespace geomesh::geomodel {
namespace {

/// A box may be this many times as long as the data of its horizons. One that leaves room for stresses to die out, or
/// for waves to leave, is some ten times as long.
constexpr double most_times = 50;

}  // namespace

void doubt_box_extent(const Inspected& model, std::vector<Finding>& findings) {
  if (!model.volume || model.project.box->shape == VolumeSpec::Shape::margin) return;
  Box3 all;
  std::vector<std::string> names;
  for (std::size_t s = 0; s < model.inputs.surfaces.size(); ++s) {
    const TriangulatedSurface& surface = model.inputs.surfaces[s];
    if (surface.kind != SurfaceKind::horizon || surface.points.empty()) continue;
    const SurfaceRules rule = model.project.rules.of(s);
    if (rule.extend != Extend::none || !rule.continues) return;  // the user has said how it goes on, or that it ends
    for (const Vec3& p : surface.points) all.add(p);
    names.push_back(surface.name);
  }
  if (names.empty()) return;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double of_box = model.volume->max[axis] - model.volume->min[axis], of_data = all.max[axis] - all.min[axis];
    if (!(of_box > most_times * of_data)) continue;
    const std::string unit = " " + model.project.crs.unit;
    findings.push_back({Finding::Sureness::certain, "extent of the box", names,
                        few_of(names) + (names.size() > 1 ? " reach" : " reaches") + " over " + short_words(of_data) +
                            unit + " of the box's " + short_words(of_box) + unit + " in " + "xy"[axis] +
                            ", so that nearly all of the model would be made up",
                        "are the limits of the box in the unit of the data, with no digit too many? If such a box is "
                        "meant, say in the horizons' entries how they go on (extend: flat, tangent or none)"});
    return;
  }
}

}  // namespace geomesh::geomodel
