// SPDX-License-Identifier: GPL-3.0-or-later
// That the program itself refuses regions whose volumes changed by more than a tolerance allows.
#include <catch2/catch.hpp>
#include <string>

#include "geomesh/core/error.hpp"
#include "hand_made.hpp"
#include "pipeline/region_volumes.hpp"

using geomesh::Error;
using geomesh::ErrorKind;
using namespace geomesh::geomodel;

namespace {

/// What is said of the mesh within the tolerance; empty: nothing.
std::string refusal(const ModelMesh& mesh, double tolerance) {
  try {
    require_volumes_within(mesh, tolerance);
  } catch (const Error& error) {
    CHECK(error.kind() == ErrorKind::cannot_mesh);
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("volumes of regions may change by area of their movable boundary times tolerance, and no more", "[sets]") {
  ModelMesh mesh = testing::three_layer_mesh(2);
  const double tolerance = 0.01, horizon = mesh.surfaces[0].area;
  CHECK(refusal(mesh, tolerance).empty());  // nothing is told of the input
  for (Region& r : mesh.regions) r.volume_of_input = r.volume;
  CHECK(refusal(mesh, tolerance).empty());
  Region &top = mesh.regions[0], &middle = mesh.regions[1];
  top.volume_of_input += 0.99 * tolerance * horizon;  // one horizon below it, sides of the box about it
  middle.volume_of_input -= 1.99 * tolerance * horizon;
  CHECK(refusal(mesh, tolerance).empty());
  top.volume_of_input += 0.02 * tolerance * horizon;
  const std::string one = refusal(mesh, tolerance);
  CHECK(one.find("top holds") != std::string::npos);
  CHECK(one.find("middle") == std::string::npos);
  CHECK(one.find("smaller tolerance") != std::string::npos);
  middle.volume_of_input -= 0.02 * tolerance * horizon;
  CHECK(refusal(mesh, tolerance).find("middle layer") != std::string::npos);
}

TEST_CASE("a unit whose volume changes by more than a hundredth is reported, its regions together", "[sets]") {
  ModelMesh mesh = testing::three_layer_mesh(2);
  for (Region& r : mesh.regions) r.volume_of_input = r.volume;
  CHECK(volume_changes(mesh, 0.01).empty());
  Region &top = mesh.regions[0], &middle = mesh.regions[1];
  top.volume_of_input = 1.03 * top.volume;
  middle.volume_of_input = 1.005 * middle.volume;
  const std::vector<std::string> told = volume_changes(mesh, 0.01);
  REQUIRE(told.size() == 1);
  CHECK(told[0].find("top has 2.913 % less volume") == 0);
  // Regions of one unit may change as long as the unit does not.
  mesh.regions[0].unit = mesh.regions[1].unit = "both";
  middle.volume_of_input = middle.volume - 0.03 * top.volume;
  CHECK(volume_changes(mesh, 0.01).empty());
}
