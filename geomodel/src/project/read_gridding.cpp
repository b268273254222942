// SPDX-License-Identifier: GPL-3.0-or-later
// The keys gridding, resample and smooth of an entry of `surfaces`, declared in project/read_reading.hpp.
#include <cmath>

#include "project/read_reading.hpp"

namespace geomesh::geomodel {
namespace {

void read_length(const YamlValue& value, double& length) {
  const auto number = value.number();
  if (!number) return;
  if (*number <= 0) return value.problem("a length greater than zero was expected");
  length = *number;
}

void read_method(const YamlValue& value, SurfaceSpec& spec) {
  const YamlMap map(value, {"method", "spacing", "smoothing", "max_distance", "extent"});
  if (!map.is_map()) return;
  if (const auto v = map.find("method")) {
    if (v->choice({"thin_plate", "triangulate"}) == "triangulate")
      spec.gridding.method = GriddingSpec::Method::triangulate;
  }
  if (const auto v = map.find("spacing")) read_length(*v, spec.gridding.spacing);
  if (const auto v = map.find("smoothing")) read_length(*v, spec.gridding.smoothing);
  if (const auto v = map.find("max_distance")) read_length(*v, spec.gridding.max_distance);
  if (const auto v = map.find("extent")) {
    spec.gridding.to_box = v->choice({"data", "box"}) == "box";
    if (spec.gridding.to_box && !spec.may_be(SurfaceKind::horizon))
      v->problem("only a horizon is gridded over the box; a fault goes on by 'extent: to_box' of the surface");
  }
  if (spec.gridding.method == GriddingSpec::Method::triangulate) {
    for (const char* key : {"spacing", "smoothing", "extent"})
      if (const auto v = map.find(key)) v->problem("has no meaning where points are triangulated as they are");
  }
}

}  // namespace

void read_gridding(const YamlMap& map, SurfaceSpec& spec) {
  if (const auto v = map.find("gridding")) read_method(*v, spec);
  if (const auto v = map.find("resample")) read_length(*v, spec.resample);
  if (const auto v = map.find("smooth")) {
    const auto n = v->number();
    if (!n) return;
    if (*n < 0 || *n > 1000 || *n != std::floor(*n))
      return v->problem("a whole number of passes from 0 to 1000 was expected");
    spec.smooth = static_cast<int>(*n);
  }
}

}  // namespace geomesh::geomodel
