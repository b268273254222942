// SPDX-License-Identifier: GPL-3.0-or-later
// What tables, wells and values for "no height" are taken for.
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "geomesh/core/error.hpp"
#include "geomesh/geomodel/readers.hpp"
#include "geomesh/geomodel/section.hpp"
#include "readers/tables/table.hpp"
#include "readers/tables/well_table.hpp"
#include "readers/text/no_data.hpp"

using namespace geomesh;
using namespace geomesh::geomodel;

namespace {

std::filesystem::path file_of(const std::string& name, const std::string& text) {
  const auto path = std::filesystem::temp_directory_path() / ("geomesh_tables_" + name);
  std::ofstream(path, std::ios::binary) << text;
  return path;
}

std::string refusal(const std::string& name, const std::string& text, const ReadOptions& options = {}) {
  try {
    read_surface_file(file_of(name, text), options);
  } catch (const Error& error) {
    CHECK(error.kind() == ErrorKind::invalid_input);
    return error.what();
  }
  return "";
}

bool holds(const std::string& text, const std::string& words) { return text.find(words) != std::string::npos; }

const std::string scattered = "101 202 -10\n103 207 -11\n108 204 -12\n106 209 -13\n";

}  // namespace

TEST_CASE("heights that stand for no value are told from heights by how they lie", "[readers][no_data]") {
  std::vector<double> heights;
  for (int i = 0; i < 100; ++i) heights.push_back(-1000 - 3.7 * i);
  const auto odd = [&](std::vector<double> more, const ReadOptions& options = {}) {
    std::vector<double> all = heights;
    all.insert(all.end(), more.begin(), more.end());
    return find_odd_heights(all, options);
  };
  using Kind = OddHeight::Kind;
  CHECK(odd({}).empty());
  for (const double v : {1e30, 1.70141e38, -99999.0, -9999.0, -32768.0, 9999900.0}) {
    const auto found = odd({v, v});
    INFO(v);
    REQUIRE(found.size() == 1);
    CHECK(found[0].kind == Kind::no_data);
    CHECK(found[0].value == v);
    CHECK(found[0].count == 2);
    CHECK(found[0].first == 100);
  }
  CHECK(odd({1e30}).at(0).kind == Kind::no_data);    // no length
  CHECK(odd({-99999}).at(0).kind == Kind::no_data);  // once, but far
  CHECK(odd({-1500}).empty());                       // a little lower than the rest
  CHECK(odd({0, 0, 0}).empty());                     // within ten ranges: a step is geology
  CHECK(odd({77777, 77777}).at(0).kind == Kind::repeated);
  CHECK(odd({77777.5}).at(0).kind == Kind::spike);
  const auto both = odd({1e30, -9999, -9999});
  CHECK(both.size() == 2);
  ReadOptions keep;
  keep.keep_all_heights = true;
  CHECK(odd({1e30, -9999, -9999}, keep).empty());
  ReadOptions named;
  named.no_data = -1000;
  CHECK(odd({}, named).at(0).value == -1000);
  CHECK(find_odd_heights(std::vector<double>{5, 5, 5, 5, 5, 7, 7, 7, 7, 7}, {}).empty());  // two levels
}

TEST_CASE("no data is left out of grids, points and triangles alike", "[readers][no_data]") {
  std::string grid = "ncols 4\nnrows 4\nxllcorner 0\nyllcorner 0\ncellsize 1\n", points = "x,y,z\n", ts;
  ts = "GOCAD TSurf 1\nHEADER {\nname: a\n}\nTFACE\n";
  int n = 0;
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i, ++n) {
      const bool none = n == 5 || n == 6;
      const std::string z = none ? "-99999" : std::to_string(-10 - n);
      grid += z + " ";
      points += std::to_string(i * i + j) + "," + std::to_string(j * j) + "," + z + "\n";
      ts += "VRTX " + std::to_string(n + 1) + " " + std::to_string(i) + " " + std::to_string(j) + " " + z + "\n";
    }
  ts += "TRGL 1 2 5\nTRGL 2 6 5\nTRGL 3 4 8\nEND\n";
  const FileContents of_grid = read_surface_file(file_of("a.asc", grid));
  CHECK(of_grid.grids.at(0).n_blank == 2);
  REQUIRE(of_grid.warnings.size() >= 1);
  CHECK(holds(of_grid.warnings[0], "2 nodes of"));
  CHECK(holds(of_grid.warnings[0], "the height -99999"));
  const FileContents of_points = read_surface_file(file_of("a.csv", points));
  CHECK(of_points.point_sets.at(0).points.size() == 14);
  const FileContents of_triangles = read_surface_file(file_of("a.ts", ts));
  CHECK(of_triangles.surfaces.at(0).triangles.size() == 2);
  CHECK(of_triangles.surfaces.at(0).points.size() == 6);
  for (const Vec3& p : of_triangles.surfaces.at(0).points) CHECK(p.z > -100);
}

TEST_CASE("heights far from all others are told in every format, and kept", "[readers][no_data]") {
  // Zero at 4 of 64 nodes of a layer near -1000: in a grid, points, triangles and points of GOCAD.
  std::string grid = "ncols 8\nnrows 8\nxllcorner 0\nyllcorner 0\ncellsize 1\n", lattice, points = "x,y,z\n";
  std::string ts = "GOCAD TSurf 1\nHEADER {\nname: a\n}\nTFACE\n", vs = "GOCAD VSet 1\nHEADER {\nname: a\n}\n", off;
  int n = 0;
  for (int j = 0; j < 8; ++j)
    for (int i = 0; i < 8; ++i) {
      const bool none = j == 5 && i > 2 && i < 7;
      const std::string z = none ? "0" : std::to_string(-1000.5 - n),
                        place = std::to_string(i) + " " + std::to_string(j);
      ++n;
      grid += z + " ";
      lattice += place + " " + z + "\n";
      points += std::to_string(i * i + j) + "," + std::to_string(j * j) + "," + z + "\n";
      ts += "VRTX " + std::to_string(n) + " " + place + " " + z + "\n";
      vs += "VRTX " + std::to_string(n) + " " + place + " " + z + "\n";
      off += place + " " + z + "\n";
    }
  std::string faces;
  for (int j = 0; j < 7; ++j)
    for (int i = 0; i < 7; ++i) {
      const int a = 8 * j + i;
      for (const auto& [p, q, r] : {std::array{a, a + 1, a + 9}, std::array{a, a + 9, a + 8}}) {
        ts += "TRGL " + std::to_string(p + 1) + " " + std::to_string(q + 1) + " " + std::to_string(r + 1) + "\n";
        faces += "3 " + std::to_string(p) + " " + std::to_string(q) + " " + std::to_string(r) + "\n";
      }
    }
  for (const auto& [name, text] : {std::pair{"f.asc", grid}, std::pair{"f.xyz", lattice}, std::pair{"f.csv", points},
                                   std::pair{"f.ts", ts + "END\n"}, std::pair{"f.vs", vs + "END\n"},
                                   std::pair{"f.off", "OFF\n64 98 0\n" + off + faces}}) {
    INFO(name);
    const FileContents read = read_surface_file(file_of(name, text));
    REQUIRE(read.warnings.size() == 1);  // once, not as points and again as nodes
    CHECK(holds(read.warnings[0], "have the height 0, the first near ("));
    CHECK(holds(read.warnings[0], "far outside the range of all others: does it stand for 'no value'? no_data: 0"));
  }
}

TEST_CASE("a fault and a body with a level foot are not doubted", "[readers][no_data]") {
  std::string fault = "GOCAD TSurf 1\nHEADER {\nname: f\n}\nTFACE\n", faces;
  for (int i = 0; i < 10; ++i) {
    fault += "VRTX " + std::to_string(2 * i + 1) + " " + std::to_string(i) + " 0 " + std::to_string(-10 - i % 3 * 0.7) +
             "\n";
    fault += "VRTX " + std::to_string(2 * i + 2) + " " + std::to_string(i) + " 200 -2000\n";
    if (i == 0) continue;
    const int a = 2 * i - 1;
    faces += "TRGL " + std::to_string(a) + " " + std::to_string(a + 1) + " " + std::to_string(a + 3) + "\n";
    faces += "TRGL " + std::to_string(a) + " " + std::to_string(a + 3) + " " + std::to_string(a + 2) + "\n";
  }
  CHECK(read_surface_file(file_of("foot.ts", fault + faces + "END\n")).warnings.empty());
}

TEST_CASE("points of lines without a height are left out", "[readers][no_data]") {
  std::string text = "GOCAD PLine 1\nHEADER {\nname: f\n}\n";
  int n = 0;
  for (int line = 0; line < 3; ++line) {
    text += "ILINE\n";
    for (int i = 0; i < 4; ++i)
      text += "VRTX " + std::to_string(++n) + " " + std::to_string(line) + " 0 " +
              (i == 1 && line < 2 ? "-99999" : std::to_string(-100 * i)) + "\n";
    for (int i = 0; i < 3; ++i) text += "SEG " + std::to_string(n - 3 + i) + " " + std::to_string(n - 2 + i) + "\n";
  }
  const FileContents read = read_surface_file(file_of("sticks.pl", text + "END\n"));
  REQUIRE(read.polylines.size() == 3);
  CHECK(read.polylines[0].points.size() == 3);
  CHECK(read.polylines[2].points.size() == 4);
  REQUIRE(read.warnings.size() == 1);
  CHECK(holds(read.warnings[0], "2 points on lines of"));
  CHECK(holds(read.warnings[0], "have the height -99999"));
}

TEST_CASE("columns of a table are not guessed", "[readers][tables]") {
  CHECK(refusal("a.xyz", scattered) == "");
  CHECK(holds(refusal("a.xyz", "0 1 2 -10 5\n1 3 7 -11 5\n2 8 4 -12 5\n"), "no header names the 5 columns"));
  CHECK(holds(refusal("a.xyz", "1 2 -10 0.25\n3 7 -11 0.5\n8 4 -12 0.75\n"), "no header names the 4 columns"));
  CHECK(refusal("a.xyz", "1 2 -10 top\n3 7 -11 top\n8 4 -12 top\n") == "");
  CHECK(holds(refusal("a.xyz", "1 2 3 4 5 6 7 8 9\n1 2 3 4 5 6 7 8 9\n"), "no header names the 9 columns"));
  CHECK(holds(refusal("a.xyz", "2 2 1\n" + scattered), "counts"));
  CHECK(holds(refusal("a.xyz", "4\n" + scattered), "this first line holds 1 number"));
  CHECK(refusal("a.xyz", "# id x y z\n0 1 2 -10\n1 3 7 -11\n2 8 4 -12\n") == "");
  ReadOptions options;
  options.columns = {{"x", "2"}, {"y", "3"}, {"depth_ft", "4"}};
  const FileContents contents = read_surface_file(file_of("b.xyz", "0 1 2 10 5\n1 3 7 11 5\n2 8 4 12 5\n"), options);
  CHECK(contents.point_sets.at(0).points.at(1).x == 3);
  CHECK(contents.point_sets.at(0).points.at(1).z == Approx(-11 * 0.3048));
  options.columns = {{"x", "2"}, {"y", "3"}, {"z", "Tiefe"}};
  CHECK(holds(refusal("c.csv", "a;b;c;d\n0;1;2;3\n", options), "'columns' takes z from the column 'Tiefe'"));
}

TEST_CASE("numbers are read as spreadsheets of many countries write them", "[readers][tables]") {
  const auto first_of = [](const std::string& line) {
    const FileContents c = read_surface_file(file_of("n.csv", line + "\n" + line + "\n"));
    return c.point_sets.at(0).points.at(0);
  };
  const Vec3 place{432500.5, 5801200.25, -1234.5};
  for (const char* line :
       {"432500.5,5801200.25,-1234.5", "432500,5;5801200,25;-1234,5", "432500,5 5801200,25 -1234,5",
        "432,500.5 5,801,200.25 -1,234.5", "\"432,500.5\",\"5,801,200.25\",\"-1,234.5\"",
        "432.500,5;5.801.200,25;-1.234,5", "432'500.5;5'801'200.25;-1'234.5", "432500.5\t5801200.25\t-1234.5",
        "432500.5, 5801200.25, -1234.5", "432,500.5;5,801,200.25;-1,234.5"}) {
    INFO(line);
    CHECK(first_of(line) == place);
  }
}

TEST_CASE("a deviation survey becomes a path by minimum curvature", "[readers][wells]") {
  // A quarter of a circle of radius R from straight down to level, to the east: its length is R pi / 2.
  const double radius = 1000, length = radius * std::acos(-1.0) / 2;
  const std::vector<Vec3> arc = path_of_survey({{0, 0, 90}, {length, 90, 90}});
  CHECK(arc.back().x == Approx(radius));
  CHECK(arc.back().y == Approx(0).margin(1e-9));
  CHECK(arc.back().z == Approx(-radius));
  double along = 0;
  for (std::size_t i = 1; i < arc.size(); ++i) {
    const Vec3 step = arc[i] - arc[i - 1];
    along += std::sqrt(dot(step, step));
    const Vec3 from_centre = arc[i] - Vec3{radius, 0, 0};  // every point lies on the circle
    CHECK(std::sqrt(dot(from_centre, from_centre)) == Approx(radius));
  }
  CHECK(along == Approx(length).epsilon(2e-5));
  // North at 30 degrees: straight; and straight down before the first station.
  const std::vector<Vec3> straight = path_of_survey({{100, 30, 0}, {1100, 30, 0}});
  CHECK(straight.size() == 3);
  CHECK(straight[1] == Vec3{0, 0, -100});
  CHECK(straight[2].y == Approx(500));
  CHECK(straight[2].z == Approx(-100 - 1000 * std::sqrt(3) / 2));
}

TEST_CASE("wells are read from tables", "[readers][wells]") {
  WellReading reading;
  const FileContents places =
      read_well_file(file_of("w.csv", "well;x;y;z\nA;1;2;0\nA;1;3;-50\nB;5;5;0\nB;5;5;-9\n"), reading);
  REQUIRE(places.polylines.size() == 2);
  CHECK(places.polylines[0].name == "A");
  CHECK(places.polylines[0].points.at(1) == Vec3{1, 3, -50});
  const std::string survey = "MD [ft]  Incl  Azim\n0 0 0\n1000 0 0\n";
  CHECK_THROWS_WITH(read_well_file(file_of("s.txt", survey), reading), Catch::Contains("head: [x, y, z]"));
  reading.head = Vec3{100, 200, 30};
  const FileContents path = read_well_file(file_of("s.txt", survey), reading);
  CHECK(path.polylines.at(0).points.back().x == 100);
  CHECK(path.polylines.at(0).points.back().z == Approx(30 - 304.8));
  reading.head_is_depth = true;
  reading.head = Vec3{100, 200, -30};
  CHECK(read_well_file(file_of("s.txt", survey), reading).polylines.at(0).points.back().z == Approx(-30 + 304.8));
  CHECK_THROWS_WITH(read_well_file(file_of("d.txt", "0 0 0\n500 10 45\n900 20 50\n"), WellReading{}),
                    Catch::Contains("could be measured depth, inclination and azimuth"));
  CHECK_THROWS_WITH(read_well_file(file_of("e.txt", "MD Incl Azim\n0 0 0\n500 200 0\n"), reading),
                    Catch::Contains("e.txt:3: an inclination"));
}

TEST_CASE("lines of a section become a body, a horizon lies below another by a thickness", "[gridding]") {
  const ExtrudeSpec spec{1, 10, 30};
  const FileContents lines = read_section(file_of("sec.txt", "0 0\n4 0\n4 -2\n0 -2\n>\n5 0\n6 0\n6 -1\n"), spec);
  REQUIRE(lines.polylines.size() == 2);
  for (const auto& order : {lines.polylines, std::vector<Polyline>(lines.polylines.rbegin(), lines.polylines.rend())}) {
    const TriangulatedSurface body = extrude_lines(order, spec, true, "body");
    double volume = 0;
    for (const Triangle& t : body.triangles)
      volume += dot(body.points[t[0]], cross(body.points[t[1]], body.points[t[2]])) / 6;
    CHECK(volume == Approx(20 * (8 + 0.5)));  // outward
  }
  const FileContents named =
      read_section(file_of("named.txt", "> A\n0 0\n4 0\n4 -2\n> -L\"B\"\n5 0\n6 0\n6 -1\n"), spec);
  REQUIRE(named.polylines.size() == 2);
  CHECK(named.polylines[0].name == "A");
  CHECK(named.polylines[1].name == "B");
  const ExtrudeSpec along_x{0, 10, 30};
  const FileContents other = read_section(file_of("sec.csv", "y,depth\n0,0\n4,0\n4,2\n0,2\n"), along_x);
  const TriangulatedSurface body = extrude_lines(other.polylines, along_x, true, "body");
  double volume = 0;
  for (const Triangle& t : body.triangles)
    volume += dot(body.points[t[0]], cross(body.points[t[1]], body.points[t[2]])) / 6;
  CHECK(volume == Approx(160));
  TriangulatedSurface top, thickness;
  top.points = {{0, 0, 5}, {4, 0, 6}, {0, 4, 7}, {4, 4, 8}};
  top.triangles = {{0, 1, 2}, {1, 3, 2}};
  thickness.points = {{-1, -1, 1}, {9, -1, 1}, {-1, 9, 1}};
  thickness.triangles = {{0, 1, 2}};
  const BelowSurface below = surface_below(top, thickness);
  CHECK(below.n_without == 0);
  CHECK(below.surface.points.at(3) == Vec3{4, 4, 7});
  thickness.points = {{-1, -1, 1}, {5, -1, -1}, {-1, 5, 1}};
  CHECK(surface_below(top, thickness).n_without == 1);
  CHECK(surface_below(top, thickness).surface.triangles.size() == 1);
  CHECK(surface_below(top, thickness).n_negative == 1);
}
