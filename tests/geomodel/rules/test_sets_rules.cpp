// SPDX-License-Identifier: GPL-3.0-or-later
// Rules as written in a project file.
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "geomesh/core/error.hpp"
#include "geomesh/geomodel/project.hpp"
#include "test_places.hpp"

using namespace geomesh;
using namespace geomesh::geomodel;
namespace fs = std::filesystem;

namespace {

Project read_text(const std::string& text) {
  const fs::path folder = fs::path(GEOMESH_BINARY_DIR) / "test-output" / "rules";
  fs::create_directories(folder);
  std::ofstream(folder / "s.off") << "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  std::ofstream(folder / "project.yaml") << text;
  return read_project(folder / "project.yaml");
}

std::string problems_of(const std::string& text) {
  try {
    read_text(text);
  } catch (const Error& e) {
    return e.what();
  }
  return "";
}

}  // namespace

TEST_CASE("rules of surfaces and of the model are read from the project file", "[sets]") {
  const Project p = read_text(R"(
box: {min: [0, 0, 0], max: [1, 1, 1]}
surfaces:
  - {name: relief, kind: horizon, file: s.off}
  - {name: h, kind: horizon, file: s.off, extend: tangent, fill_holes: 200, base: erode}
  - {name: f, kind: fault, file: s.off, extent: to_fault g}
  - {name: g, kind: fault, file: s.off, extent: to_box, fill_holes: all}
column: [sand, h, shale]
rules: {on_crossing: clip_older, trim_overshoot: 5, topography: relief, fault_blocks: true, min_volume: 7, small_regions: merge}
regions:
  - {name: reservoir, at: [0.5, 0.5, 0.5]}
groups: {all: [sand, shale]}
attributes: {sand: {porosity: 0.25}}
)");
  REQUIRE(p.rules.surfaces.size() == 4);
  CHECK(p.rules.surfaces[1].extend == Extend::tangent);
  CHECK(p.rules.surfaces[1].fill_holes == 200);
  CHECK(p.rules.surfaces[1].base == BaseRule::erode);
  CHECK(p.rules.surfaces[2].extend == Extend::flat);
  CHECK(p.rules.surfaces[2].stop_at == "g");
  CHECK(p.rules.surfaces[3].extend == Extend::flat);
  CHECK(std::isinf(p.rules.surfaces[3].fill_holes));
  CHECK(p.rules.on_crossing == OnCrossing::clip_older);
  CHECK(p.rules.trim_overshoot == 5);
  CHECK(p.rules.trims());
  CHECK(p.rules.column == p.column);
  CHECK(p.naming.topography == "relief");
  CHECK((p.naming.fault_blocks && p.naming.merge_small && p.naming.min_volume == 7));
  REQUIRE(p.naming.seeds.size() == 1);
  CHECK(p.naming.seeds[0].name == "reservoir");
  CHECK(p.naming.groups.at("all") == std::vector<std::string>{"sand", "shale"});
  CHECK(p.naming.attributes.at("sand").at("porosity") == 0.25);
}

TEST_CASE("mistakes in rules are told together, each with what was expected", "[sets]") {
  const std::string told = problems_of(R"(
surfaces:
  - {name: h, kind: horizon, file: s.off, extend: tangent, extent: to_box}
  - {name: f, kind: fault, file: s.off, base: onlap, extent: to_fault nowhere}
  - {name: b, kind: body, file: s.off, extend: flat, fill_holes: -3}
rules: {on_crossing: guess, topography: f}
attributes: {sand: {region: 1}}
)");
  for (const char* part :
       {"no box", "only a fault has an extent", "only a horizon is the base", "nowhere", "a body is not extended",
        "zero or more", "on_crossing", "no horizon is named 'f'", "'region' is the name of an array"}) {
    INFO(told);
    CHECK(told.find(part) != std::string::npos);
  }
}
