// SPDX-License-Identifier: GPL-3.0-or-later
// Converts coordinates with PROJ: a module that the program loads for systems other than UTM and longitude and
// latitude, and for other datums. Its interface is coordinates/proj_module.hpp.
#include <proj.h>

#include <cmath>
#include <memory>
#include <string>

#include "coordinates/proj_module.hpp"
#include "geomesh/core/error.hpp"

namespace geomesh::geomodel {

namespace {

struct DestroyObject {
  void operator()(PJ* object) const { proj_destroy(object); }
};
using Object = std::unique_ptr<PJ, DestroyObject>;

/// PROJ's state for one thread, which collects messages that PROJ would print.
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

  operator PJ_CONTEXT*() const { return context_; }  // NOLINT: replaces the pointer in every call of PROJ
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

/// Returns the map coordinate system; for a compound system its horizontal part. Null if the register does not contain
/// the code.
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

/// Returns a unit of the system's first axis in metres; 1 for degrees.
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

/// Returns whether two datums are within a metre of WGS84, so that docs/coordinates.md is the only place that mentions
/// the difference.
bool is_one_datum(const std::string& a, const std::string& b) {
  const auto is_global = [](const std::string& d) {
    return d.find("World Geodetic System 1984") == 0 || d.find("European Terrestrial Reference System 1989") == 0;
  };
  return a == b || (is_global(a) && is_global(b));
}

bool is_geographic(const HorizontalCrs& crs) {
  Context context;
  const Object system = horizontal_system(context, crs.epsg);
  return system && is_geographic_type(proj_get_type(system.get()));
}

class Operation : public ProjOperation {
 public:
  Operation(const HorizontalCrs& from, const HorizontalCrs& to) {
    const Object a = reference(context_, from), b = reference(context_, to);
    // Ignoring a datum would cause an error of hundreds of metres.
    const char* const options[] = {"ALLOW_BALLPARK=NO", nullptr};
    Object found(proj_create_crs_to_crs_from_pj(context_, a.get(), b.get(), nullptr, options));
    if (found) transformation_.reset(proj_normalize_for_visualization(context_, found.get()));
    if (!transformation_)
      throw Error(ErrorKind::usage,
                  "PROJ knows no way from " + from.name() + " to " + to.name() + ": " + context_.reason());
    from_metres = metres(context_, a);
    to_metres = metres(context_, b);
    if (const std::string x = datum(context_, a), y = datum(context_, b); !is_one_datum(x, y))
      datum_shift = "; datum shift from " + x + " to " + y + " by PROJ";
  }

  Vec2 transform(const Vec2& p) const override {
    proj_errno_reset(transformation_.get());
    const PJ_COORD q = proj_trans(transformation_.get(), PJ_FWD, proj_coord(p.x, p.y, 0, HUGE_VAL));
    return proj_errno(transformation_.get()) == 0 ? Vec2{q.xy.x, q.xy.y} : Vec2{HUGE_VAL, HUGE_VAL};
  }
  std::string reason() const override { return context_.reason(); }

 private:
  Context context_;
  Object transformation_;
};

std::unique_ptr<ProjOperation> make_operation(const HorizontalCrs& from, const HorizontalCrs& to) {
  return std::make_unique<Operation>(from, to);
}

}  // namespace
}  // namespace geomesh::geomodel

extern "C" __attribute__((visibility("default"))) const geomesh::geomodel::ProjModule* geomesh_proj_module() {
  using namespace geomesh::geomodel;
  static constexpr ProjModule module{GEOMESH_MODULE_VERSION, is_geographic, make_operation};
  return &module;
}
