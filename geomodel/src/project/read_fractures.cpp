// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the key `fractures` of a project, declared in project/read_gridding.hpp.
#include "fractures/read_fractures.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

#include "fractures/generate.hpp"
#include "geomesh/core/error.hpp"
#include "geomesh/geomodel/given.hpp"
#include "geomesh/geomodel/words.hpp"
#include "project/read_gridding.hpp"
#include "readers/triangles/polygon.hpp"

namespace geomesh::geomodel {
namespace {

constexpr double default_corners = 16;

double positive(const YamlMap& map, const char* key, double otherwise) {
  const auto v = map.find(key);
  if (!v) return otherwise;
  const double number = v->number().value_or(1);
  if (!(number > 0)) v->problem("a number above zero was expected");
  return number;
}

void read_radius(const YamlValue& value, FractureFamily& family) {
  if (!value.is_map()) {
    family.least_radius = family.greatest_radius = value.number().value_or(1);
    if (!(family.least_radius > 0)) value.problem("a length above zero was expected");
    return;
  }
  const YamlMap map(value, {"min", "max", "exponent"});
  map.require("min", "the least radius");
  map.require("max", "the greatest radius");
  family.least_radius = positive(map, "min", 1);
  family.greatest_radius = positive(map, "max", family.least_radius);
  if (const auto v = map.find("exponent")) family.exponent = v->number().value_or(0);
  if (family.greatest_radius < family.least_radius) value.problem("max is less than min");
}

FractureFamily read_family(const YamlValue& value) {
  FractureFamily family;
  const YamlMap map(value, {"name", "dip_direction", "dip", "kappa", "radius", "p32", "count"});
  if (!map.is_map()) return family;
  if (const auto v = map.require("name", "each family needs a name")) family.name = v->text().value_or("");
  if (const auto v = map.find("dip_direction")) family.dip_direction = v->number().value_or(0);
  if (const auto v = map.find("dip")) family.dip = v->number().value_or(0);
  if (const auto v = map.find("kappa")) {
    family.kappa = v->number().value_or(0);
    if (family.kappa < 0) v->problem("zero or more was expected");
  }
  if (const auto v = map.require("radius", "a length, or {min, max, exponent}")) read_radius(*v, family);
  family.p32 = positive(map, "p32", 0);
  const double count = positive(map, "count", 0);
  family.count = static_cast<std::size_t>(std::min(std::round(count), 1e6));
  if ((map.find("p32") != std::nullopt) == (map.find("count") != std::nullopt))
    value.problem("either p32 (area over volume) or count was expected");
  return family;
}

std::vector<Fracture> read_families(const YamlMap& map, const YamlValue& families, int n_corners,
                                    const std::optional<Box3>& box) {
  std::vector<FractureFamily> found;
  for (const YamlValue& item : families.items()) found.push_back(read_family(item));
  const auto seed = map.require("seed", "a whole number, so that the same network comes out again");
  if (!box) families.problem("families fill the box; give the project a box with min and max");
  if (!seed || !box || !families.problems().empty()) return {};
  const double number = seed->number().value_or(0);
  if (number < 0 || number != std::floor(number)) seed->problem("a whole number was expected");
  return generate_fractures(found, *box, n_corners, static_cast<std::uint64_t>(std::max(0.0, number)));
}

FractureFileOptions file_options(const YamlMap& map, int n_corners) {
  FractureFileOptions options;
  options.n_corners = n_corners;
  if (const auto v = map.find("layout"))
    options.layout = v->choice({"polygons", "ellipses"}) == "ellipses" ? FractureFileOptions::Layout::ellipses
                                                                       : FractureFileOptions::Layout::polygons;
  if (const auto v = map.find("angles")) options.degrees = v->choice({"radians", "degrees"}) == "degrees";
  if (const auto v = map.find("name")) options.name = v->text().value_or(options.name);
  return options;
}

}  // namespace

std::vector<Fracture> read_fractures(const YamlValue& value, const std::filesystem::path& folder,
                                     const std::optional<Box3>& box) {
  const YamlMap map(value, {"file", "layout", "angles", "corners", "name", "families", "seed"});
  if (!map.is_map()) return {};
  const double corners = positive(map, "corners", default_corners);
  if (corners < 3 || corners > 1000 || corners != std::floor(corners))
    map.find("corners")->problem("a whole number from 3 to 1000 was expected");
  const int n_corners = static_cast<int>(std::clamp(corners, 3.0, 1000.0));
  std::vector<Fracture> fractures;
  const auto file = map.find("file"), families = map.find("families");
  if (!file && !families) value.problem("either file or families was expected");
  const FractureFileOptions options = file_options(map, n_corners);
  if (file) {
    const std::filesystem::path path = (folder / file->text().value_or("")).lexically_normal();
    if (std::filesystem::is_regular_file(path))
      fractures = read_fracture_file(path, options);
    else
      file->problem("there is no file '" + file->scalar() + "' (looked for as " + path.string() + ")" +
                    file_was_meant(path));
  }
  if (families) {
    std::vector<Fracture> drawn = read_families(map, *families, n_corners, box);
    std::move(drawn.begin(), drawn.end(), std::back_inserter(fractures));
  }
  return fractures;
}

SurfaceSpec surface_of(const Fracture& fracture) {
  std::vector<VertexIndex> loop(fracture.corners.size());
  std::iota(loop.begin(), loop.end(), VertexIndex{0});
  std::vector<Triangle> triangles = triangulate_polygon(fracture.corners, loop);
  if (triangles.empty())
    throw Error(ErrorKind::invalid_input,
                "fracture " + fracture.name +
                    (fracture.line > 0 ? " (line " + std::to_string(fracture.line) + " of its file)" : "") +
                    " crosses itself; give its corners in order around it");
  SurfaceSpec spec;
  spec.name = fracture.name;
  spec.kind = SurfaceKind::fault;
  spec.file_as_written = "fractures";
  spec.rules.continues = false;  // A fracture ends at its polygon's border and is not continued to other surfaces.
  spec.given =
      std::make_shared<const FileContents>(given_surface(fracture.name, fracture.corners, std::move(triangles)));
  return spec;
}

}  // namespace geomesh::geomodel
