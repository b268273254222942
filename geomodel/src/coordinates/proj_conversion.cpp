// SPDX-License-Identifier: GPL-3.0-or-later
#include "coordinates/proj_conversion.hpp"

#include <proj.h>

#include <cmath>
#include <cstdio>

#include "geomesh/core/error.hpp"

namespace geomesh::geomodel {

namespace {

struct DestroyObject {
  void operator()(PJ* object) const { proj_destroy(object); }
};
using Object = std::unique_ptr<PJ, DestroyObject>;

/// PROJ's state of one thread, which collects what PROJ would print.
class Context {
 public:
  Context() : context_(proj_context_create()) {
    proj_log_func(context_, this, [](void* self, int level, const char* text) {
      if (level == PJ_LOG_ERROR) static_cast<Context*>(self)->message_ = text;
    });
  }
  ~Context() { proj_context_destroy(context_); }
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  operator PJ_CONTEXT*() const { return context_; }  // NOLINT: stands for the pointer in every call of PROJ
  std::string reason() const {
    if (!message_.empty()) return message_;
    const int code = proj_context_errno(context_);
    return code == 0 ? "no reason given" : proj_context_errno_string(context_, code);
  }

 private:
  PJ_CONTEXT* context_;
  std::string message_;
};

int code_of(const HorizontalCrs& crs) {
  if (crs.epsg > 0) return crs.epsg;
  if (crs.kind == HorizontalCrs::Kind::utm) return (crs.north ? 32600 : 32700) + crs.zone;
  return crs.kind == HorizontalCrs::Kind::geographic ? 4326 : 0;
}

bool is_geographic_type(PJ_TYPE type) { return type == PJ_TYPE_GEOGRAPHIC_2D_CRS || type == PJ_TYPE_GEOGRAPHIC_3D_CRS; }

/// The system of places in the map; of a compound one its horizontal part. Null where the register has none of the
/// code.
Object horizontal_system(const Context& context, int code) {
  Object system(proj_create_from_database(context, "EPSG", std::to_string(code).c_str(), PJ_CATEGORY_CRS, 0, nullptr));
  if (system && proj_get_type(system.get()) == PJ_TYPE_COMPOUND_CRS)
    system.reset(proj_crs_get_sub_crs(context, system.get(), 0));
  if (!system) return nullptr;
  const PJ_TYPE type = proj_get_type(system.get());
  return type == PJ_TYPE_PROJECTED_CRS || is_geographic_type(type) ? std::move(system) : nullptr;
}

Object reference(const Context& context, const HorizontalCrs& crs) {
  Object system = horizontal_system(context, code_of(crs));
  if (!system)
    throw Error(ErrorKind::usage,
                crs.name() + " is no system that PROJ knows of places in the map: " + context.reason());
  return system;
}

/// A unit of the system's first axis in metres; 1 for degrees.
double metres(const Context& context, const Object& system) {
  if (is_geographic_type(proj_get_type(system.get()))) return 1;
  const Object axes(proj_crs_get_coordinate_system(context, system.get()));
  double factor = 1;
  proj_cs_get_axis_info(context, axes.get(), 0, nullptr, nullptr, nullptr, &factor, nullptr, nullptr, nullptr);
  return factor;
}

std::string datum(const Context& context, const Object& system) {
  const Object datum(proj_crs_get_datum_forced(context, system.get()));
  const char* const name = datum ? proj_get_name(datum.get()) : nullptr;
  return name ? name : "an unnamed datum";
}

/// The datums that are within a metre of WGS84: not worth a word beyond that of docs/coordinates.md.
bool is_one_datum(const std::string& a, const std::string& b) {
  const auto is_global = [](const std::string& d) {
    return d.find("World Geodetic System 1984") == 0 || d.find("European Terrestrial Reference System 1989") == 0;
  };
  return a == b || (is_global(a) && is_global(b));
}

}  // namespace

struct ProjConversion::Operation {
  Context context;
  Object transformation;
};

bool is_geographic(const HorizontalCrs& crs) {
  if (crs.kind == HorizontalCrs::Kind::geographic) return true;
  if (crs.kind != HorizontalCrs::Kind::other || crs.epsg == 0) return false;
  Context context;
  const Object system = horizontal_system(context, crs.epsg);
  return system && is_geographic_type(proj_get_type(system.get()));
}

ProjConversion::ProjConversion(const HorizontalCrs& from, const HorizontalCrs& to)
    : operation_(std::make_unique<Operation>()), names_("from " + from.name() + " to " + to.name()) {
  const Context& context = operation_->context;
  const Object a = reference(context, from), b = reference(context, to);
  const char* const options[] = {"ALLOW_BALLPARK=NO", nullptr};  // a datum that is passed over is hundreds of metres
  Object found(proj_create_crs_to_crs_from_pj(context, a.get(), b.get(), nullptr, options));
  if (found) operation_->transformation.reset(proj_normalize_for_visualization(context, found.get()));
  if (!operation_->transformation)
    throw Error(ErrorKind::usage, "PROJ knows no way " + names_ + ": " + context.reason());
  from_metres_ = metres(context, a);
  to_metres_ = metres(context, b);
  if (const std::string x = datum(context, a), y = datum(context, b); !is_one_datum(x, y))
    datum_shift_ = "; datum shift from " + x + " to " + y + " by PROJ";
}

ProjConversion::~ProjConversion() = default;
ProjConversion::ProjConversion(ProjConversion&&) noexcept = default;

Vec2 ProjConversion::convert(const Vec2& p) const {
  PJ* const transformation = operation_->transformation.get();
  proj_errno_reset(transformation);
  const PJ_COORD q =
      proj_trans(transformation, PJ_FWD, proj_coord(p.x / from_metres_, p.y / from_metres_, 0, HUGE_VAL));
  if (std::isfinite(q.xy.x) && std::isfinite(q.xy.y) && proj_errno(transformation) == 0)
    return {q.xy.x * to_metres_, q.xy.y * to_metres_};
  char place[80];
  std::snprintf(place, sizeof place, "(%.10g, %.10g)", p.x, p.y);
  throw Error(ErrorKind::invalid_input,
              std::string(place) + " cannot be converted " + names_ + ": " + operation_->context.reason());
}

}  // namespace geomesh::geomodel
