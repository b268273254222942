// SPDX-License-Identifier: GPL-3.0-or-later
// The project file: what it means, and that one run names every mistake with its place.

#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "geomesh/core/error.hpp"
#include "geomesh/geomodel/project.hpp"
#include "scratch.hpp"

using namespace geomesh;
using namespace geomesh::geomodel;

namespace {

/// A folder with a project file and two empty surface files, gone at the end.
struct ProjectFolder {
  std::filesystem::path folder = testing::scratch_folder() / "geomesh_test_project_folder";
  ProjectFolder() {
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder / "s");
    for (const char* name : {"s/a.ts", "s/b.ts"}) std::ofstream(folder / name) << "GOCAD TSurf 1\n";
  }
  ~ProjectFolder() { std::filesystem::remove_all(folder); }
  std::filesystem::path write(const std::string& text, const char* name = "model.yaml") const {
    std::ofstream(folder / name, std::ios::binary) << text;
    return folder / name;
  }
};

/// The message of the usage error that reading must end with.
std::string complaint(const std::string& text) {
  const ProjectFolder f;
  const auto file = f.write(text);
  try {
    read_project(file);
  } catch (const Error& e) {
    CHECK(e.kind() == ErrorKind::usage);
    std::string message = e.what();
    for (std::size_t at; (at = message.find(file.string() + ":")) != std::string::npos;)
      message.erase(at, file.string().size() + 1);
    return message;
  }
  return "no complaint";
}

const char* const two_surfaces =
    "surfaces:\n"
    "  - {name: top, kind: horizon, file: s/a.ts}\n"
    "  - {name: salt, kind: body, file: s/b.ts}\n";

}  // namespace

TEST_CASE("a project means what its page says", "[project]") {
  const ProjectFolder f;
  const Project p =
      read_project(f.write("name: dome\n"
                           "crs: {horizontal: local, z: depth, unit: ft}\n"
                           "box: {min: [0, -1e3, -5000], max: [1.5, 2, 0]}\n"
                           "surfaces:\n"
                           "  - {name: top, kind: horizon, file: s/a.ts}\n"
                           "  - name: salt\n"
                           "    kind: body\n"
                           "    file: s/b.ts\n"
                           "points: [{name: hypocentre, at: [1, 2, 3]}]\n"
                           "column: [chalk, top, basement]\n"
                           "mesh: {mode: conforming, refine: none, cluster_distance: 0.5, preserve_boundary: true}\n"
                           "output: {directory: ../elsewhere, formats: [vtu, msh], origin: [500000, 6000000, 0]}\n"));
  CHECK(p.name == "dome");
  CHECK(p.crs.depth);
  CHECK(p.crs.unit == "ft");
  REQUIRE(p.box);
  CHECK(p.box->box.min == Vec3{0, -1000, -5000});
  CHECK(p.box->box.max == Vec3{1.5, 2, 0});
  REQUIRE(p.surfaces.size() == 2);
  CHECK(p.surfaces[0].kind == SurfaceKind::horizon);
  CHECK_FALSE(p.surfaces[0].cuts_all);
  CHECK(p.surfaces[1].cuts_all);
  CHECK(p.surfaces[1].line == 6);
  CHECK(p.surfaces[1].file == f.folder / "s/b.ts");
  CHECK(p.surfaces[1].file_as_written == "s/b.ts");
  CHECK(p.points.at(0).point == Vec3{1, 2, 3});
  CHECK(p.column == std::vector<std::string>{"chalk", "top", "basement"});
  CHECK(p.mesh.options.recover.mode == MeshMode::conforming);
  CHECK(p.mesh.options.recover.preserve_boundary);
  CHECK(p.mesh.options.delaunay.cluster_distance == 0.5);
  CHECK(p.output.directory == f.folder.parent_path() / "elsewhere");
  CHECK(p.output.formats == std::vector<std::string>{"vtu", "msh"});
  CHECK(p.output.origin == Vec3{500000, 6000000, 0});
}

TEST_CASE("a project without a name takes its file's, or its folder's", "[project]") {
  const ProjectFolder f;
  CHECK(read_project(f.write(two_surfaces)).name == "model");
  const Project p = read_project(f.write(two_surfaces, "project.yaml"));
  CHECK(p.name == "geomesh_test_project_folder");
  CHECK(p.output.directory == f.folder / "out");
  CHECK(p.output.formats == std::vector<std::string>{"vtu"});
  CHECK_FALSE(p.box);
}

TEST_CASE("sizes are read by name, with and without radius", "[project]") {
  const ProjectFolder f;
  const Project p = read_project(
      f.write(std::string(two_surfaces) +
              "points:\n  - {name: gauge, at: [1, 2, 3]}\n"
              "mesh:\n"
              "  size: {global: 9, units: {u: 4}, surfaces: {salt: {size: 2, radius: 7}}, curves: {wells: 1.5},\n"
              "         near: [{at: gauge, size: 0.5, radius: 3}, {at: [4, 5, 6], size: 0.25}], gradation: 0.2, max: "
              "8, gap_layers: none}\n"
              "  honour: tolerance\n  tolerance: 0.125\n  quality: best\n  quality_measure: mean_ratio\n  "
              "max_elements: 1000\n  time_budget: 2.5\n"
              "  cell_arrays: [size, aspect]\n"));
  const RefinementSettings& r = p.mesh.refinement;
  CHECK(r.refine);
  CHECK(r.size.base.global == 9);
  CHECK(r.size.base.gradation == 0.2);
  CHECK(r.size.base.max_size == 8);
  CHECK(r.size.base.gap_layers == 0);
  CHECK(r.sizes_on_surfaces);
  CHECK(r.size.units.at("u").size == 4);
  CHECK(r.size.surfaces.at("salt").size == 2);
  CHECK(r.size.surfaces.at("salt").radius == 7);
  CHECK(r.size.curves.at("wells").size == 1.5);
  REQUIRE(r.size.near.size() == 2);
  CHECK(r.size.near[0].place == Vec3{1, 2, 3});
  CHECK(r.size.near[0].asked.radius == 3);
  CHECK(r.size.near[1].asked.size == 0.25);
  CHECK(r.honour == Honour::tolerance);
  CHECK(r.tolerance.left() == 0.125);
  CHECK(r.quality == QualityLevel::best);
  CHECK(r.quality_measure == QualityMeasure::mean_ratio);
  CHECK(r.max_elements == 1000);
  CHECK(r.time_budget == 2.5);
  CHECK(r.cell_arrays == std::vector<std::string>{"size", "aspect"});
  const RefinementSettings by_default = read_project(f.write(two_surfaces)).mesh.refinement;
  CHECK(by_default.refine);
  CHECK(by_default.honour == Honour::tolerance);
  CHECK(by_default.derive_size);
  CHECK(by_default.tolerance.left_share() == default_tolerance_share);
  CHECK_FALSE(by_default.size.base.from_input_edges);
  CHECK_FALSE(read_project(f.write(std::string(two_surfaces) + "mesh: {refine: none}\n")).mesh.refinement.refine);
  CHECK(read_project(f.write(std::string(two_surfaces) + "mesh: {tolerance: 2}\n")).mesh.refinement.tolerance.left() ==
        2);
  CHECK_FALSE(read_project(f.write(std::string(two_surfaces) + "mesh: {size: {on_surfaces: false}}\n"))
                  .mesh.refinement.sizes_on_surfaces);
}

TEST_CASE("The two lengths of nearness are read under their names and, with a note, under the former ones",
          "[project]") {
  const ProjectFolder f;
  const std::string start(two_surfaces);
  const Project now = read_project(f.write(start + "merge_within: 0.5\nmesh: {surfaces_within: 2}\n"));
  CHECK(now.merge_within == 0.5);
  CHECK(now.mesh.refinement.tolerance.requested() == 2);
  CHECK(now.notes.empty());
  const Project before = read_project(f.write(start + "tolerance: 0.5\nmesh: {tolerance: 2}\n"));
  CHECK(before.merge_within == 0.5);
  CHECK(before.mesh.refinement.tolerance.requested() == 2);
  REQUIRE(before.notes.size() == 2);
  CHECK(before.notes[1].find("surfaces_within") != std::string::npos);
  CHECK_THROWS_WITH(read_project(f.write(start + "merge_within: 1\ntolerance: 1\n")),
                    Catch::Matchers::Contains("leave out one of them"));
}

TEST_CASE("attributes do not take the names of arrays that the mesh file has", "[project]") {
  const ProjectFolder f;
  const auto message = [&](const std::string& rest) {
    try {
      read_project(f.write(std::string(two_surfaces) + rest));
    } catch (const Error& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  for (const char* name : {"region", "size", "aspect", "min_dihedral"})
    CHECK(message("attributes: {u: {" + std::string(name) + ": 1}}\n").find("is the name of an array") !=
          std::string::npos);
  CHECK(message("attributes: {u: {porosity: 0.2}}\n").empty());
  CHECK(message("mesh: {size: 5, cell_arrays: [size, aspect, size]}\n").find("requested twice") != std::string::npos);
}

TEST_CASE("all mistakes of a project are named in one run, in the order of the file", "[project]") {
  const std::string text = complaint(
      "nmae: x\n"
      "box: {min: [0, 0, 0], max: [1, 0, 010]}\n"
      "surfaces:\n"
      "  - {name: top, kind: horizont, file: s/a.ts}\n"
      "  - {name: salt, kind: body, file: s/missing.ts}\n"
      "column: [a, tpo, b]\n"
      "mesh: {refine: perhaps, size: {surfaces: {slat: 5}}}\n");
  INFO(text);
  CHECK(text.find("1:1: unknown key 'nmae'; was 'name' meant?") == 0);
  CHECK(text.find("2:35: box.max[3]: the number '010' has a leading zero") != std::string::npos);
  CHECK(text.find(
            "4:23: surfaces[1].kind: horizon, fault or body was expected, found 'horizont'; was 'horizon' meant?") !=
        std::string::npos);
  CHECK(text.find("5:36: surfaces[2].file: there is no file") != std::string::npos);
  CHECK(text.find("6:13: column[2]: a horizon was expected here, but no surface is named 'tpo'; was 'top' meant?") !=
        std::string::npos);
  CHECK(text.find("7:16: mesh.refine: none or default was expected, found 'perhaps'") != std::string::npos);
  CHECK(text.find("mesh.size.surfaces.slat: there is no surface of this name; was 'salt' meant?") != std::string::npos);
  CHECK(std::count(text.begin(), text.end(), '\n') == 6);
}

TEST_CASE("each mistake has its own words", "[project]") {
  struct Case {
    std::string text, words;
  };
  const std::string s = two_surfaces;
  const std::vector<Case> cases{
      {"", "the project is empty"},
      {"[1, 2]", "1:1: project: a map with the keys"},
      {"surfaces: [", "not valid YAML"},
      {"name: a\n", "neither 'surfaces' nor 'box' is given"},
      {s + "name: a\nname: b\n", "5:1: name: duplicate"},
      {s + "box: {min: [0, 0], max: [1, 1, 1]}\n",
       "4:12: box.min: three numbers [x, y, z] were expected, found 2 values"},
      {s + "box: {min: [0, 0, .nan], max: [1, 1, 1]}\n", "box.min[3]: a finite number was expected"},
      {s + "box: {min: [0, 0, 1e999], max: [1, 1, 1]}\n", "box.min[3]: a finite number was expected"},
      {s + "box: {min: [0, 0, 'a'], max: [1, 1, 1]}\n", "box.min[3]: a number was expected, found 'a'"},
      {s + "box: {min: [0, 2, 0], max: [1, 1, 1]}\n", "box.max: the box is empty in y: max must be greater than min"},
      {s + "box: {min: [0, 0, 0]}\n", "box: the key 'max' is missing"},
      {s + "column: [top, salt]\n", "an odd number of names; found 2"},
      {s + "column: [top, a, b]\n",
       "4:10: column[1]: the name of a unit was expected here, but 'top' is a surface (line 2)"},
      {s + "column: [a, salt, b]\n", "column[2]: a horizon was expected here, but 'salt' is a body (line 3)"},
      {s + "column: [a, top, a]\n", "column[3]: 'a' stands in the column already"},
      {s + "column: &x [*x]\n", "column[1]: a text was expected, found a list"},
      {"box: &b {min: *b, max: [1, 1, 1]}\n", "box.min: three numbers [x, y, z] were expected, found a map"},
      {"surfaces:\n  - {name: xmin, kind: fault, file: s/a.ts}\n",
       "2:12: surfaces[1].name: 'xmin' is the name of a side of the box"},
      {s + "points: [{name: top, at: [0, 0, 0]}]\n", "4:17: points[1].name: the name 'top' is used already (line 2)"},
      {"surfaces:\n  - {name: t, kind: fault, file: s}\n", "surfaces[1].file: 's' is a folder; a file was expected"},
      {"surfaces:\n  - {name: t, kind: horizon, file: s/a.ts, cuts: all}\n",
       "cuts: only bodies and faults cut; this surface is a horizon"},
      {"surfaces:\n  - {name: t, kind: horizon, file: s/a.ts, cuts: [u1]}\n",
       "cuts: all or none was expected, found a list"},
      {"surfaces:\n  - {name: t, kind: body, file: s/a.ts, cuts: [u1]}\n",
       "cuts: all or none was expected, found a list"},
      {"surfaces:\n  - {name: t, kind: fault, file: s/a.ts, cuts: none}\n",
       "cuts: all or a list of units of the column was expected"},
      {"surfaces:\n  - {name: t, kind: fault, file: s/a.ts, cuts: []}\n", "cuts: the list of units is empty"},
      {s + "mesh: {quality: good}\n", "mesh.quality: fast, default or best was expected"},
      {s + "mesh: {quality_measure: best}\n",
       "mesh.quality_measure: dihedral, radius_ratio or mean_ratio was expected"},
      {s + "mesh: {mode: conforming, size: 5, quality_measure: mean_ratio}\n", "quality_measure and time_budget"},
      {s + "mesh: {size: -5}\n", "mesh.size: a number above zero was expected"},
      {s + "mesh: {refine: none, size: 5}\n", "mesh.refine: none contradicts"},
      {s + "mesh: {honour: {tolerance: 2}}\n",
       "found a map; give 'honour: tolerance' and beside it 'surfaces_within', a length"},
      {s + "mesh: {honour: exact, tolerance: 2}\n", "mesh.tolerance: has no meaning while surfaces are kept exactly"},
      {s + "mesh: {size: {min: 5, max: 2}}\n", "mesh.size: min is greater than max"},
      {s + "mesh: {size: {units: {a: {size: 2, radius: 3}}}}\n", "mesh.size.units: a size inside of a has no radius"},
      {s + "mesh: {size: {near: [{at: nowhere, size: 5}]}}\n",
       "[x, y, z] or the name of an entry of 'points' was expected"},
      {s + "mesh: {mode: conforming, size: 5, quality: best}\n",
       "quality, quality_measure and time_budget have no meaning with it"},
      {s + "mesh: {mode: conforming, size: 5, honour: tolerance, tolerance: 1}\n",
       "mode conforming keeps the input's facets"},
      {s + "mesh: {size: {background: nowhere.csv}}\n", "there is no file 'nowhere.csv'"},
      {s + "mesh: {preserve_boundary: true, quality: fast}\n", "preserve_boundary and refinement exclude each other"},
      {s + "mesh: {size: {on_surfaces: false}, honour: tolerance, tolerance: 1}\n",
       "(on_surfaces: false) contradicts it"},
      {s + "mesh: {size: {on_surfaces: false}, mode: conforming}\n", "(on_surfaces: false) contradicts it"},
      {s + "mesh: {refine: none, cell_arrays: [size]}\n", "the cell array 'size' holds the requested sizes"},
      {s + "mesh: {preserve_boundary: yes}\n", "true or false was expected, found 'yes'"},
      {s + "mesh: {cluster_distance: -2}\n", "auto or a length of zero or more was expected"},
      {s + "rules: {topography: salt}\n", "a horizon was expected, but no horizon is named 'salt'"},
      {s + "rules: {topography: nowhere}\n", "a horizon was expected, but no horizon is named 'nowhere'"},
      {s + "output: {formats: [vtk]}\n", "output.formats[1]: "},
      {s + "---\nname: b\n", "several YAML documents"},
  };
  for (const Case& c : cases) {
    INFO(c.text);
    const std::string text = complaint(c.text);
    INFO(text);
    CHECK(text.find(c.words) != std::string::npos);
  }
}

TEST_CASE("YAML that cannot be read comes with what most often stands behind it, near that line alone", "[project]") {
  const auto contains = [](const std::string& text, const char* words) {
    return text.find(words) != std::string::npos;
  };
  const char *const tab = "there is a tab near it", *const colon = "is there a blank after the colon?",
                    *const columns = "keys of one entry begin in the same column";
  for (const char* text : {"name: a\nsurfaces:\n\t- x\n", "name: a\n\tb: 1\nsurfaces: []\n"}) {
    CAPTURE(text);
    CHECK(contains(complaint(text), tab));
  }
  CHECK(contains(complaint("name: a\nsurfaces:\n  - {name:a, [}\n"), colon));
  CHECK(contains(complaint("name: a\nsurfaces:\n  - {kind:[1, 2}\n"), colon));
  for (const char* text : {"name: a\nsurfaces: []\n  box: 1\n", "box: {min: [0, 0, 0]\n"}) {
    CAPTURE(text, complaint(text));
    CHECK(contains(complaint(text), columns));
  }
  // What stands two lines before has no part in it.
  CHECK(contains(complaint("#\ta tab\n#x:y\nname: a\nsurfaces: []\n  box: 1\n"), columns));
}

TEST_CASE("names are UTF-8: the first and last letters of each length are taken, other bytes are refused",
          "[project]") {
  const ProjectFolder f;
  const auto text = [](const std::string& letter) { return "name: \"a" + letter + "b\"\n" + two_surfaces; };
  for (const char* letter : {"\xc2\xa1", "\xdf\xbf", "\xe0\xa0\x80", "\xed\x9f\xbf", "\xee\x80\x80", "\xef\xbf\xbd",
                             "\xf0\x90\x80\x80", "\xf3\xbf\xbf\xbd", "\xf4\x8f\xbf\xbd"})
    CHECK(read_project(f.write(text(letter))).name == std::string("a") + letter + "b");
  for (const char* letter : {"\x80", "\xc1\xbf", "\xe0\x9f\xbf", "\xed\xa0\x80", "\xed\xbf\xbf", "\xf0\x8f\xbf\xbf",
                             "\xf4\x90\x80\x80", "\xf5\x80\x80\x80", "\xc3", "\xe2\x82", "\xf0\x9f\x98"}) {
    const std::string words = complaint(text(letter));
    INFO(words);
    CHECK(words.find("UTF-8") != std::string::npos);
  }
}

TEST_CASE("a missing project is an error of usage", "[project]") {
  try {
    read_project("/no/such/project.yaml");
    FAIL("an error was expected");
  } catch (const Error& e) {
    CHECK(e.kind() == ErrorKind::usage);
  }
}
