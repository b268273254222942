// SPDX-License-Identifier: GPL-3.0-or-later
// What is particular to grids and tables of points: holes, nulls, groups, units, regular lattices.
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "geomesh/geomodel/info.hpp"
#include "geomesh/geomodel/readers.hpp"
#include "installed.hpp"
#include "plane_files.hpp"
#include "scratch.hpp"

using namespace geomesh;
using namespace geomesh::geomodel;

namespace {

FileContents read_text(const std::string& name, const std::string& bytes) {
  const auto path = testing::scratch_folder() / ("geomesh_grids_" + name);
  std::ofstream(path, std::ios::binary) << bytes;
  FileContents contents = read_surface_file(path);
  std::filesystem::remove(path);
  return contents;
}

bool says(const std::vector<std::string>& lines, const std::string& words) {
  for (const std::string& line : lines)
    if (line.find(words) != std::string::npos) return true;
  return false;
}

/// z = 100 + column of a grid of 5 by 5 nodes, the middle node without a value and the last one alone.
std::string grid_with_hole() {
  std::string s = "ncols 5\nnrows 5\nxllcenter 0\nyllcenter 0\ncellsize 10\nNODATA_value -1\n";
  for (int row = 4; row >= 0; --row)
    for (int column = 0; column < 5; ++column)
      s += column == 2 && row == 2 ? "-1 " : std::to_string(100 + column) + " ";
  return s;
}

}  // namespace

TEST_CASE("a node without a value is a hole, whose cells keep one triangle each", "[readers][grids]") {
  const FileContents contents = read_text("hole.asc", grid_with_hole());
  REQUIRE(contents.surfaces.size() == 1);
  CHECK(contents.surfaces[0].points.size() == 24);
  CHECK(contents.surfaces[0].triangles.size() == 12 * 2 + 4);
  REQUIRE(contents.grids.size() == 1);
  CHECK(contents.grids[0].n_columns == 5);
  CHECK(contents.grids[0].n_blank == 1);
  CHECK(contents.grids[0].cell_centred);
  const SurfaceInfo info = measure_surface(contents.surfaces[0]);
  CHECK(info.n_borders == 2);
  CHECK(info.n_holes == 1);
}

TEST_CASE("the spacing of grids is told, whichever way their nodes run", "[readers][grids]") {
  for (const char* name : {"along_u.omf", "along_v.omf"}) {
    const FileContents contents = read_text(name, plane_file(name));
    REQUIRE(contents.grids.size() == 1);
    CHECK(contents.grids[0].origin.x == Approx(Plane::x0).epsilon(1e-15));
    CHECK(contents.grids[0].origin.y == Approx(Plane::y0).epsilon(1e-15));
    CHECK(contents.grids[0].spacing.x == 50);
    CHECK(contents.grids[0].spacing.y == 80);
  }
}

TEST_CASE("nulls of each grid format are holes", "[readers][grids]") {
  const auto n_points = [](const std::string& name, const std::string& bytes) {
    return read_text(name, bytes).surfaces.at(0).points.size();
  };
  CHECK(n_points("a.grd", "DSAA\n3 2\n0 2\n0 1\n0 9\n1 2 3\n4 5 1.70141e38\n") == 5);
  CHECK(n_points("a.zmap",
                 "@a HEADER, GRID, 3\n12, -99999.0, , 0, 1\n2, 3, 0, 2, 0, 1\n@\n1. -99999.0\n2. 3.\n4. 5.\n") == 5);
  CHECK(n_points("b.zmap", "@a HEADER, GRID, 3\n12, , ZNON, 0, 1\n2, 3, 0, 2, 0, 1\n@\n1. ZNON\n2. 3.\n4. 5.\n") == 5);
  CHECK(n_points(
            "a.cps3",
            "FSASCI 0 1 COMPUTED 0 1E+030\nFSLIMI 0 2 0 1 0 9\nFSNROW 2 3\nFSXINC 1 1\n->a\n1 0.1E+31 2 3 4 5\n") == 5);
  CHECK(n_points("a.irap", "-996 2 1 1\n0 2 0 1\n3 0 0 0\n0 0 0 0 0 0 0\n1 2 3 4 5 9999900\n") == 5);
}

TEST_CASE("fault traces of a Surfer grid are told where there are some", "[readers][grids]") {
  const std::string grid = plane_file("surfer7.grd");
  CHECK(read_text("plain7.grd", grid).warnings.empty());
  CHECK(says(read_text("faults7.grd", grid + "FLTI" + std::string(4, '\0')).warnings, "fault traces"));
}

TEST_CASE("a rotated grid turns about its origin, counter-clockwise", "[readers][grids]") {
  const FileContents contents =
      read_text("turn.irap", "-996 2 10 20\n0 10 0 20\n2 30 100 200\n0 0 0 0 0 0 0\n1 2 3 4\n");
  const auto& p = contents.surfaces.at(0).points;
  REQUIRE(p.size() == 4);
  CHECK(p[0] == Vec3{100, 200, 1});
  CHECK(p[1].x == Approx(100 + 10 * std::sqrt(0.75)).epsilon(1e-15));
  CHECK(p[1].y == Approx(205).epsilon(1e-15));
  CHECK(p[2].x == Approx(90).epsilon(1e-15));
  CHECK(p[2].y == Approx(200 + 20 * std::sqrt(0.75)).epsilon(1e-15));
}

TEST_CASE("a table is parted by its column of names; numbers of places alone do not part it", "[readers][grids]") {
  std::string s = "id,X,Y,Z,formation\n";
  for (int i = 0; i < 30; ++i)
    s += std::to_string(i) + "," + std::to_string(i * i) + "," + std::to_string(7 * i % 11) + "," + std::to_string(-i) +
         (i % 3 ? ",sand\n" : ",shale\n");
  const FileContents contents = read_text("groups.csv", s);
  REQUIRE(contents.point_sets.size() == 2);
  CHECK(contents.point_sets[0].name == "shale");
  CHECK(contents.point_sets[0].points.size() == 10);
  CHECK(contents.point_sets[1].name == "sand");
}

TEST_CASE("rows without a value are counted, repeated points and places are told", "[readers][grids]") {
  const FileContents contents = read_text("dirt.csv", "x;y;z\n0;0;1\n1;0;\n1;3;1e30\n5;2;7\n5;2;7\n5;2;8\n9;4;1\n");
  CHECK(contents.point_sets.at(0).points.size() == 5);
  CHECK(says(contents.warnings, "1 rows without a value"));
  CHECK(says(contents.warnings, "one of the points of 'geomesh_grids_dirt' has the height 1e+30, near (1, 3)"));
  CHECK(says(contents.warnings, "1 points of 'geomesh_grids_dirt' repeat another"));
  CHECK(says(contents.warnings, "with a different z"));
}

TEST_CASE("scattered points are no grid, nodes of a grid with gaps are one", "[readers][grids]") {
  CHECK(read_text("scatter.xyz", "0 0 1\n1 0.1 2\n0.2 1 3\n1.1 0.9 4\n0.5 0.4 5\n").surfaces.empty());
  const FileContents gaps = read_text("gaps.xyz", "0 0 1\n1 0 2\n2 0 3\n0 1 4\n1 1 5\n2 2 6\n1 2 7\n");
  REQUIRE(gaps.surfaces.size() == 1);
  CHECK(gaps.grids.at(0).n_blank == 2);
}

TEST_CASE("longitude and latitude are told by the names of columns", "[readers][grids]") {
  const FileContents contents = read_text("lonlat.csv", "lat,lon,elevation\n52,8,-100\n52.5,8.3,-200\n53,8.1,-300\n");
  CHECK(contents.frame.geographic);
  CHECK(contents.point_sets.at(0).points.at(1) == Vec3{8.3, 52.5, -200});
}

TEST_CASE("the CRS of a GeoTIFF and the units of headers are told", "[readers][grids]") {
  if (testing::has_module("gdal"))
    CHECK(read_text("crs.tif", plane_file("area.tif")).frame.crs == "epsg:32632");
  else
    WARN("skipped: built without the module geomesh-gdal");
  const FileContents feet = read_text("feet.petrel",
                                      "# Unit in X and Y direction: m\n# Unit in depth: ft\nVERSION 1\nBEGIN "
                                      "HEADER\nX\nY\nZ\nEND HEADER\n0 0 -100\n9 1 -50\n3 7 -10\n");
  CHECK(feet.frame.z_unit == "ft");
  CHECK(feet.point_sets.at(0).points.at(0).z == Approx(-30.48).epsilon(1e-15));
}

TEST_CASE("DXF: layers are surfaces, lines are kept, blocks that are not there are told", "[readers][grids]") {
  const std::string face =
      "0\n3DFACE\n8\nA\n10\n0\n20\n0\n30\n0\n11\n1\n21\n0\n31\n0\n12\n0\n22\n1\n32\n0\n13\n0\n23\n1\n33\n0\n";
  const std::string line = "0\nLINE\n8\nL\n10\n0\n20\n0\n30\n5\n11\n1\n21\n2\n31\n3\n";
  const std::string flat = "0\nLWPOLYLINE\n8\nL\n90\n2\n70\n0\n38\n7\n10\n1\n20\n2\n10\n3\n20\n4\n";
  const FileContents c = read_text("mixed.dxf", "0\nSECTION\n2\nENTITIES\n" + face + line + flat +
                                                    "0\nINSERT\n8\n0\n2\nB\n10\n0\n20\n0\n0\nENDSEC\n0\nEOF\n");
  REQUIRE(c.surfaces.size() == 1);
  CHECK(c.surfaces[0].name == "A");
  CHECK(c.surfaces[0].triangles.size() == 1);
  REQUIRE(c.polylines.size() == 2);
  CHECK(c.polylines[1].points == std::vector<Vec3>{{1, 2, 7}, {3, 4, 7}});
  CHECK(says(c.warnings, "1 INSERT of the block 'B', which is not in the file, passed over"));
}

TEST_CASE("a GOCAD well is a path with its reference added", "[readers]") {
  const std::string head =
      "GOCAD Well 1\nHEADER {\nname: W 1\n}\nGOCAD_ORIGINAL_COORDINATE_SYSTEM\nAXIS_UNIT \"m\" \"m\" \"ft\"\nZPOSITIVE "
      "Depth\nEND_ORIGINAL_COORDINATE_SYSTEM\n";
  const FileContents c = read_text("w.wl", head +
                                               "WREF 1000 2000 -100\nPATH 0 -100 0 0\nPATH 1000 900 0 0\nPATH 2050 "
                                               "1800 30 -40\nMRKR top_sand 0 1500 0\nEND\n");
  REQUIRE(c.polylines.size() == 1);
  CHECK(c.polylines[0].name == "W 1");
  REQUIRE(c.polylines[0].points.size() == 3);  // the first station repeats WREF
  CHECK(c.polylines[0].points[0] == Vec3{1000, 2000, 0.3048 * 100});
  CHECK(c.polylines[0].points[2].x == 1030);
  CHECK(c.polylines[0].points[2].y == 1960);
  CHECK(c.polylines[0].points[2].z == Approx(-0.3048 * 1800).epsilon(1e-15));
}
