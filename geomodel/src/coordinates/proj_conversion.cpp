// SPDX-License-Identifier: GPL-3.0-or-later
#include "coordinates/proj_conversion.hpp"

#include <cmath>
#include <cstdio>

#include "coordinates/proj_module.hpp"
#include "geomesh/core/error.hpp"
#include "modules/module.hpp"

namespace geomesh::geomodel {

namespace {

const ProjModule& proj() {
  static const ProjModule& module = module_table_of<ProjModule>(
      {"geomesh-proj.so", "geomesh_proj_module",
       "Systems of the EPSG register beyond UTM on WGS84, and other datums, are converted with PROJ by", "geomesh-proj",
       "libproj-dev"});
  return module;
}

}  // namespace

bool is_geographic(const HorizontalCrs& crs) {
  if (crs.kind == HorizontalCrs::Kind::geographic) return true;
  if (crs.kind != HorizontalCrs::Kind::other || crs.epsg == 0) return false;
  try {
    return proj().is_geographic(crs);
    // If the PROJ module is missing, the system counts as not geographic. This is safe, because inputs that need a
    // conversion are refused elsewhere, and a name alone converts nothing.
  } catch (const Error&) {
    return false;
  }
}

struct ProjConversion::Operation {
  std::unique_ptr<ProjOperation> by_proj;
};

ProjConversion::ProjConversion(const HorizontalCrs& from, const HorizontalCrs& to)
    : operation_(std::make_unique<Operation>()), names_("from " + from.name() + " to " + to.name()) {
  operation_->by_proj = proj().make(from, to);
  from_metres_ = operation_->by_proj->from_metres;
  to_metres_ = operation_->by_proj->to_metres;
  datum_shift_ = operation_->by_proj->datum_shift;
}

ProjConversion::~ProjConversion() = default;
ProjConversion::ProjConversion(ProjConversion&&) noexcept = default;

Vec2 ProjConversion::convert(const Vec2& p) const {
  const Vec2 q = operation_->by_proj->transform({p.x / from_metres_, p.y / from_metres_});
  if (std::isfinite(q.x) && std::isfinite(q.y)) return {q.x * to_metres_, q.y * to_metres_};
  char place[80];
  std::snprintf(place, sizeof place, "(%.10g, %.10g)", p.x, p.y);
  throw Error(ErrorKind::invalid_input,
              std::string(place) + " cannot be converted " + names_ + ": " + operation_->by_proj->reason());
}

}  // namespace geomesh::geomodel
