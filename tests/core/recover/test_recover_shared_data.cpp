// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <filesystem>

#include "corpus_run.hpp"
#include "plc_reader.hpp"
#include "test_places.hpp"

using namespace geomesh;

namespace {

/// Reports and returns false where the outside data are not there.
bool have_shared_data() {
  if (std::filesystem::exists(GEOMESH_SHARED_DATA "/classic")) return true;
  WARN("skipped: no outside data in " GEOMESH_SHARED_DATA);
  return false;
}

}  // namespace

TEST_CASE("classic adversarial models are meshed", "[recover][shared]") {
  if (!have_shared_data()) return;
  const MeshMode mode = GENERATE(MeshMode::constrained, MeshMode::conforming);
  TetrahedralizeOptions options;
  options.recover.mode = mode;
  for (const char* name :
       {"schonhardt.off", "schonhardt_5.off", "schonhardt_59.off", "chazelle_slits_2.poly", "chazelle_slits_4.poly",
        "lattice_3.poly", "lattice_8.poly", "pillar_holes_regions.poly", "schonhardt_in_box_hole.poly",
        "schonhardt_in_box_regions.poly", "wedge_0.01deg.poly", "wedge_1deg.poly", "wedge_1e-6.poly"}) {
    INFO(name);
    const test::CorpusRun run =
        test::run_and_judge(test::read_plc(std::string(GEOMESH_SHARED_DATA "/classic/") + name), options);
    CHECK(run.trouble == "");
    if (!run.ok()) continue;
    const ConstrainedTetrahedralization& mesh = *run.mesh;
    if (mode == MeshMode::conforming) CHECK(mesh.delaunay == mesh.recovery.facets_not_recovered.empty());
  }
}

TEST_CASE("solids are meshed without points on their boundary", "[recover][shared]") {
  if (!have_shared_data()) return;
  TetrahedralizeOptions options;
  options.recover.preserve_boundary = true;
  for (const char* name : {"bunny25k.obj", "cow25k.obj", "sphere1.obj", "sphere2.obj", "bamboo_pen.obj",
                           "cube_minus_sphere.obj", "humanoid.off", "soccerball.obj", "7_8ths_cube.stl", "round.stl",
                           "shared.STL", "multibody.stl", "ballA.off", "ballB.off"}) {
    INFO(name);
    const test::CorpusRun run =
        test::run_and_judge(test::read_plc(std::string(GEOMESH_SHARED_DATA "/solids/") + name), options);
    CHECK(run.trouble == "");
    if (!run.ok()) continue;
    const ConstrainedTetrahedralization& mesh = *run.mesh;
    CHECK(mesh.recovery.steiner_on_segments + mesh.recovery.steiner_on_facets == 0);
  }
}

TEST_CASE("solids are meshed with few added points", "[recover][shared]") {
  if (!have_shared_data()) return;
  for (const char* name : {"res.obj", "1002_tray_bottom.STL", "plate_holes.STL", "featuretype.ply"}) {
    INFO(name);
    CHECK(test::run_and_judge(test::read_plc(std::string(GEOMESH_SHARED_DATA "/solids/") + name)).trouble == "");
  }
}

TEST_CASE("solids conform to Delaunay", "[recover][shared]") {
  if (!have_shared_data()) return;
  TetrahedralizeOptions options;
  options.recover.mode = MeshMode::conforming;
  for (const char* name :
       {"bunny25k.obj", "sphere1.obj", "res.obj", "bamboo_pen.obj", "humanoid.off", "round.stl", "ballA.off"}) {
    INFO(name);
    const test::CorpusRun run =
        test::run_and_judge(test::read_plc(std::string(GEOMESH_SHARED_DATA "/solids/") + name), options);
    CHECK(run.trouble == "");
    if (!run.ok()) continue;
    const ConstrainedTetrahedralization& mesh = *run.mesh;
    CHECK(mesh.delaunay);
    CHECK(mesh.recovery.facets_not_recovered.empty());
  }
}

TEST_CASE("real models that cross themselves are refused", "[recover][shared]") {
  if (!have_shared_data()) return;
  for (const char* name : {"two_spheres.obj", "Gravgen.obj"}) {
    INFO(name);
    try {
      tetrahedralize(test::read_plc(std::string(GEOMESH_SHARED_DATA "/solids/") + name));
      FAIL("crossing facets were meshed");
    } catch (const Error& e) {
      CHECK(e.kind() == ErrorKind::invalid_input);
      CHECK(e.context().facets.size() >= 2);
      CHECK(!e.context().places.empty());
    }
  }
}
