// SPDX-License-Identifier: GPL-3.0-or-later
#include "level_sets/fields/function_field.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "geomesh/core/error.hpp"
#include "level_sets/fields/place_words.hpp"

namespace geomesh::geomodel {

FunctionField::FunctionField(std::shared_ptr<FieldFunction> function, const Box3& box, std::string surface)
    : function_(std::move(function)), box_(box), surface_(std::move(surface)) {}

void FunctionField::values(std::span<const Vec3> places, std::span<double> out) const {
  std::vector<Vec3> inside(places.begin(), places.end());
  for (Vec3& p : inside)
    for (std::size_t a = 0; a < 3; ++a) p[a] = std::clamp(p[a], box_.min[a], box_.max[a]);
  (*function_)(inside, out);
  for (std::size_t i = 0; i < out.size(); ++i) {
    if (std::isfinite(out[i])) continue;
    ErrorContext context;
    context.places.push_back(inside[i]);
    throw Error(ErrorKind::invalid_input,
                "surface " + surface_ + ": its function gives a value that is not finite at " + place_words(inside[i]) +
                    "; it must have a finite value everywhere in the box",
                std::move(context));
  }
}

}  // namespace geomesh::geomodel
