// SPDX-License-Identifier: GPL-3.0-or-later
// Coordinate systems, units, directions of z: from an input to the frame of the model.
#include <catch2/catch.hpp>
#include <cmath>

#include "coordinates/georeference.hpp"
#include "geomesh/core/error.hpp"
#include "installed.hpp"

using namespace geomesh;
using namespace geomesh::geomodel;

namespace {

FileContents with_points(std::vector<Vec3> points) {
  FileContents contents;
  contents.point_sets.push_back({"p", "p.csv", std::move(points)});
  return contents;
}

Project project_in(const std::string& horizontal) {
  Project project;
  project.file = "test.yaml";
  project.crs.horizontal = horizontal;
  return project;
}

struct Placed {
  std::vector<Vec3> points;
  std::vector<std::string> notes, warnings;
  std::string system;
};
Placed place(const Project& project, FileContents contents, const SourceSpec& spec) {
  const std::vector<SourceInput> inputs{{"top", &spec, &contents}};
  const ModelFrame frame(project, inputs);
  Placed placed;
  frame.place(inputs[0], placed.notes, placed.warnings);
  placed.points = contents.point_sets.at(0).points;
  placed.system = frame.system().name();
  return placed;
}

std::string complaint(const Project& project, FileContents contents, const SourceSpec& spec, ErrorKind kind) {
  try {
    place(project, std::move(contents), spec);
  } catch (const Error& e) {
    CHECK(e.kind() == kind);
    return e.what();
  }
  return "no complaint";
}

}  // namespace

TEST_CASE("systems are known by the names that people write", "[coordinates]") {
  using Kind = HorizontalCrs::Kind;
  CHECK(parse_crs("local").kind == Kind::local);
  CHECK(parse_crs("Geographic").kind == Kind::geographic);
  CHECK(parse_crs("EPSG:4326").kind == Kind::geographic);
  for (const char* text : {"utm 32N", "UTM zone 32N", "utm32n", "epsg:32632", "epsg:25832"}) {
    INFO(text);
    CHECK(parse_crs(text).kind == Kind::utm);
    CHECK(parse_crs(text).zone == 32);
    CHECK(parse_crs(text).north);
  }
  CHECK_FALSE(parse_crs("epsg:32755").north);
  CHECK(parse_crs("utm").zone == 0);
  CHECK(parse_crs("epsg:3031").kind == Kind::polar);
  CHECK(parse_crs("epsg:31467").kind == Kind::other);
  CHECK(complaint_about_crs("epsg:31467").empty());
  for (const auto& [text, zone] :
       {std::pair("epsg:32601", 1), {"epsg:32660", 60}, {"epsg:32701", 1}, {"epsg:32760", 60}}) {
    INFO(text);
    CHECK(parse_crs(text).kind == Kind::utm);
    CHECK(parse_crs(text).zone == zone);
  }
  for (const char* text : {"epsg:32600", "epsg:32700"}) {  // grids of all zones: there is no zone 0
    INFO(text);
    CHECK((!complaint_about_crs(text).empty() || parse_crs(text).kind != Kind::utm));
  }
  for (const char* text : {"utm 61N", "utm 32", "utm 32S5", "mars", "epsg:", "epsg:x"}) {
    INFO(text);
    CHECK_FALSE(complaint_about_crs(text).empty());
  }
}

TEST_CASE("projections agree with published coordinates and come back", "[coordinates]") {
  // IOGP Guidance Note 7-2 (2019), 3.2.2 and 3.3.1: worked examples of UPS north and Australian Antarctic-like polar
  // stereographic; the central meridian of a UTM zone at the equator is (500000, 0) by definition.
  const Vec2 ups = from_geographic(parse_crs("epsg:5041"), {44, 73});
  CHECK(ups.x == Approx(3320416.75).margin(0.01));
  CHECK(ups.y == Approx(632668.43).margin(0.01));
  const Vec2 centre = from_geographic(parse_crs("utm 31N"), {3, 0});
  CHECK(centre.x == Approx(500000).margin(1e-6));
  CHECK(centre.y == Approx(0).margin(1e-6));
  // On the central meridian the northing is 0.9996 of the meridian's arc, 5540847.041561 m at 50 degrees on WGS84.
  CHECK(from_geographic(parse_crs("utm 31N"), {3, 50}).y == Approx(0.9996 * 5540847.041561).margin(1e-3));
  for (const char* name : {"utm 31N", "utm 30N", "utm 31S", "epsg:32661", "epsg:3413", "epsg:3995"}) {
    INFO(name);
    const HorizontalCrs crs = parse_crs(name);
    const Vec2 back = to_geographic(crs, from_geographic(crs, {4.25, 62.5}));
    CHECK(back.x == Approx(4.25).margin(1e-12));
    CHECK(back.y == Approx(62.5).margin(1e-12));
  }
  CHECK(from_geographic(parse_crs("utm 31S"), {3, 1}).y - from_geographic(parse_crs("utm 31N"), {3, 1}).y ==
        Approx(1e7).margin(1e-6));
  CHECK(utm_at({5.3, 60.4}).zone == 32);  // Bergen: the exception of zone 32V
  CHECK_FALSE(utm_at({146, -38}).north);
}

TEST_CASE("a centimetre survives at northings of six million", "[coordinates]") {
  const Vec3 p{432000.27, 6012345.59, -1234.56};
  Project project = project_in("utm 32N");
  CHECK(place(project, with_points({p}), {}).points[0] == p);  // not a bit is lost
  project.output.origin = {432000, 6012000, 0};
  CHECK(place(project, with_points({p}), {}).points[0] == p - project.output.origin);

  // Out to longitude and latitude as a text of ten decimals, and back.
  const HorizontalCrs utm = parse_crs("utm 32N");
  Vec2 q = to_geographic(utm, {p.x, p.y});
  q = {std::round(q.x * 1e10) / 1e10, std::round(q.y * 1e10) / 1e10};
  SourceSpec spec;
  spec.crs = "geographic";
  project.output.origin = {};
  const Vec3 back = place(project, with_points({{q.x, q.y, p.z}}), spec).points[0];
  CHECK(std::abs(back.x - p.x) < 1e-4);
  CHECK(std::abs(back.y - p.y) < 1e-4);
  CHECK(back.z == p.z);
}

TEST_CASE("units, depth, datum and origin are applied in that order", "[coordinates]") {
  Project project = project_in("local");
  project.crs.unit = "ft";
  project.output.origin = {100, 0, -50};
  SourceSpec spec;
  spec.unit = "m";
  spec.z_unit = "km";
  spec.depth = true;
  spec.z_datum = 25;
  const Placed placed = place(project, with_points({{304.8, 609.6, 0.3048}}), spec);
  CHECK(placed.points[0].x == Approx(1000 - 100).epsilon(1e-15));
  CHECK(placed.points[0].y == Approx(2000).epsilon(1e-15));
  CHECK(placed.points[0].z == Approx(-1000 + 25 + 50).epsilon(1e-15));
  CHECK(placed.notes.size() == 4);
}

TEST_CASE("what a file says of itself wins over the project, what its entry says wins over both", "[coordinates]") {
  Project project = project_in("local");
  project.crs.depth = true;
  FileContents contents = with_points({{1, 2, 30.48}});  // the reader has converted: 100 ft of elevation
  contents.frame.unit = "ft";
  contents.frame.z_named = true;
  CHECK(place(project, contents, {}).points[0] == Vec3{1, 2, 30.48});
  SourceSpec spec;
  spec.unit = "m";
  spec.depth = true;
  const Placed placed = place(project, contents, spec);
  CHECK(placed.points[0].z == Approx(-100).epsilon(1e-15));
  CHECK(placed.warnings.size() == 2);
  contents.frame = {};
  CHECK(place(project, contents, {}).points[0].z == -30.48);  // nothing said: the project's depth
}

TEST_CASE("coordinates that cannot be what they are said to be are refused", "[coordinates]") {
  const FileContents degrees = with_points({{8.1, 52.3, -100}, {8.2, 52.4, -200}}),
                     metres = with_points({{432000, 6012345, -100}});
  SourceSpec geographic, utm;
  geographic.crs = "geographic";
  utm.crs = "utm 32N";
  CHECK(complaint(project_in("utm 32N"), degrees, {}, ErrorKind::invalid_input).find("add 'crs: geographic'") !=
        std::string::npos);
  CHECK(complaint(project_in("utm 32N"), metres, geographic, ErrorKind::invalid_input).find("which they cannot be") !=
        std::string::npos);
  CHECK(complaint(project_in("local"), degrees, geographic, ErrorKind::usage).find("no place on the globe") !=
        std::string::npos);
  CHECK(complaint(project_in("epsg:99999"), metres, utm, ErrorKind::usage)
            .find(testing::has_module("proj") ? "epsg:99999 is no system that PROJ knows"
                                              : "apt install geomesh-proj") != std::string::npos);
  CHECK(complaint(project_in("utm"), metres, {}, ErrorKind::usage).find("name the zone") != std::string::npos);
  CHECK(place(project_in("epsg:31467"), metres, {}).points[0] ==
        Vec3{432000, 6012345, -100});  // a name alone converts nothing
}

TEST_CASE("PROJ converts national grids, and the shift of the datum is told", "[coordinates]") {
  if (!testing::has_module("proj")) {
    WARN("skipped: built without the module geomesh-proj");
    return;
  }
  // Ordnance Survey, "A guide to coordinate systems in Great Britain": Caister Water Tower in the National Grid
  // (epsg:27700) and on ETRS89. Without the grid of shifts PROJ is within some metres; the datums are 100 m apart.
  SourceSpec national;
  national.crs = "epsg:27700";
  const Vec2 wanted =
      from_geographic(parse_crs("utm 31N"), {1 + 42.0 / 60 + 57.8663 / 3600, 52 + 39.0 / 60 + 28.8282 / 3600});
  const FileContents tower = with_points({{651409.792, 313177.448, -100}});
  const Vec3 found = place(project_in("utm 31N"), tower, national).points[0];
  CHECK(found.x == Approx(wanted.x).margin(8));
  CHECK(found.y == Approx(wanted.y).margin(8));
  CHECK(found.z == -100);

  // NAD83 in zone 12N (epsg:26912), and its neighbour zone: taken there and back.
  SourceSpec nad, neighbour;
  nad.crs = "epsg:26912";
  neighbour.crs = "epsg:26911";
  const FileContents there = with_points({{450000, 4400000, 5}});
  const Vec3 in_neighbour = place(project_in("epsg:26911"), there, nad).points[0];
  CHECK(in_neighbour.x > 900000);
  const Vec3 back = place(project_in("epsg:26912"), with_points({in_neighbour}), neighbour).points[0];
  CHECK(back.x == Approx(450000).margin(1e-3));
  CHECK(back.y == Approx(4400000).margin(1e-3));
}

TEST_CASE("zones are found, and other zones converted", "[coordinates]") {
  SourceSpec geographic, utm33;
  geographic.crs = "geographic";
  utm33.crs = "utm 33N";
  const Placed found = place(project_in("utm"), with_points({{8.5, 52.25, -10}}), geographic);
  CHECK(found.system == "utm 32N");
  const Vec2 expected = from_geographic(parse_crs("utm 32N"), {8.5, 52.25});
  CHECK(found.points[0] == Vec3{expected.x, expected.y, -10});
  const Vec2 in33 = from_geographic(parse_crs("utm 33N"), {8.5, 52.25});
  const Vec3 converted = place(project_in("utm 32N"), with_points({{in33.x, in33.y, 0}}), utm33).points[0];
  CHECK(std::abs(converted.x - expected.x) < 1e-6);
  CHECK(std::abs(converted.y - expected.y) < 1e-6);
}

TEST_CASE("a box in longitude and latitude becomes an upright rectangle inside it", "[coordinates]") {
  Project project = project_in("geographic");
  project.crs.depth = true;
  project.box.emplace().box = Box3{{8, 52, 0}, {8.2, 52.1, 3000}};
  const ModelFrame frame(project, {});
  std::string note;
  const Box3 box = frame.volume(*project.box, note).box;
  CHECK(frame.system().name() == "utm 32N");
  CHECK(box.min.z == -3000);
  CHECK(box.max.z == 0);
  CHECK(note.find("largest upright rectangle") != std::string::npos);
  const HorizontalCrs utm = parse_crs("utm 32N");
  for (const double x : {box.min.x, box.max.x})
    for (const double y : {box.min.y, box.max.y}) {
      const Vec2 q = to_geographic(utm, {x, y});
      CHECK((q.x >= 8 - 1e-9 && q.x <= 8.2 + 1e-9 && q.y >= 52 - 1e-6 && q.y <= 52.1 + 1e-6));
    }
  CHECK(box.max.x - box.min.x > 0.95 * 13700);  // 0.2 degrees of longitude there are 13.7 km
}
