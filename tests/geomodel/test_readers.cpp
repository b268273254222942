// SPDX-License-Identifier: GPL-3.0-or-later
// One analytic, tilted, asymmetric plane written in every format with one expected answer, and the same files broken in every way.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>

#include "geomesh/core/error.hpp"
#include "geomesh/geomodel/info.hpp"
#include "geomesh/geomodel/readers.hpp"

using namespace geomesh;
using namespace geomesh::geomodel;

namespace {

/// A file of the test, gone at the end.
struct TestFile {
  std::filesystem::path path;
  TestFile(const std::string& name, const std::string& bytes) : path(std::filesystem::temp_directory_path() / ("geomesh_readers_" + name)) {
    std::ofstream(path, std::ios::binary) << bytes;
  }
  ~TestFile() { std::filesystem::remove(path); }
};

/// z = -1000 + x / 4 - y / 2 about a corner with UTM-like coordinates, over 3 x 2 cells of 50 x 80 m; normals point up.
struct Plane {
  static constexpr double x0 = 432000.25, y0 = 6012345.5;
  std::vector<Vec3> points;
  std::vector<Triangle> triangles;
  Plane() {
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 4; ++i) points.push_back({x0 + 50 * i, y0 + 80 * j, height(50 * i, 80 * j)});
    for (VertexIndex j = 0; j < 2; ++j) {
      for (VertexIndex i = 0; i < 3; ++i) {
        const VertexIndex a = 4 * j + i, b = a + 1, c = a + 5, d = a + 4;
        triangles.push_back({a, b, c});
        triangles.push_back({a, c, d});
      }
    }
  }
  static double height(double dx, double dy) { return -1000 + dx / 4 - dy / 2; }
};

std::string number(double v) {
  std::ostringstream out;
  out.precision(17);
  out << v;
  return out.str();
}
std::string text(const Vec3& p) { return number(p.x) + " " + number(p.y) + " " + number(p.z); }
template <class T>
void append(std::string& bytes, T value, bool big = false) {
  std::array<char, sizeof(T)> raw;
  std::memcpy(raw.data(), &value, sizeof(T));
  if (big) std::reverse(raw.begin(), raw.end());
  bytes.append(raw.data(), raw.size());
}

/// GOCAD with everything that trips readers: gaps in the ids, an atom, properties, a block between, CRLF.
std::string gocad(double scale, bool depth, const std::string& unit) {
  const Plane plane;
  std::string s = "GOCAD TSurf 1\r\nHEADER { name: \"tilted plane\" }\r\nGOCAD_ORIGINAL_COORDINATE_SYSTEM\r\nNAME \" x y\" \r\n";
  s += "AXIS_UNIT " + unit + " " + unit + " " + unit + "\r\nZPOSITIVE " + std::string(depth ? "Depth" : "Elevation");
  s += "\r\nEND_ORIGINAL_COORDINATE_SYSTEM\r\nPROPERTIES p\r\nNO_DATA_VALUES -99999\r\nPROPERTY_CLASS_HEADER p q {\r\nis_z: on\r\n}\r\nTFACE\r\n";
  for (std::size_t i = 0; i < plane.points.size(); ++i) {
    Vec3 p = scale * plane.points[i];
    if (depth) p.z = -p.z;
    s += "PVRTX " + std::to_string(10 + 3 * i) + " " + text(p) + " -99999 CNXYZ\r\n";
  }
  s += "PATOM 1000 10 5\r\nATOM 1001 1000\r\nTFACE\r\n";
  for (const Triangle& t : plane.triangles) {
    std::array<std::string, 3> id;
    for (std::size_t k = 0; k < 3; ++k) id[k] = t[k] == 0 ? "1001" : std::to_string(10 + 3 * t[k]);
    if (depth) std::swap(id[1], id[2]);  // right-handed with z down
    s += "TRGL " + id[0] + " " + id[1] + " " + id[2] + " \r\n";
  }
  return s + "BSTONE 10\r\nBORDER 4 10 13\r\nEND";
}

std::string off() {
  const Plane plane;
  std::string s = "OFF # comment\n12 12 0\n\n";
  for (const Vec3& p : plane.points) s += text(p) + "\n";
  for (const Triangle& t : plane.triangles) s += "3 " + std::to_string(t[0]) + " " + std::to_string(t[1]) + " " + std::to_string(t[2]) + " 255 0 0\n";
  return s.substr(0, s.size() - 9) + "\n";  // the last one without colour
}

std::string obj(bool quads) {
  const Plane plane;
  std::string s = "# c\nmtllib a.mtl\no plane\n";
  for (const Vec3& p : plane.points) s += "v " + text(p) + "\n";
  if (quads) {
    for (int j = 0; j < 2; ++j)
      for (int i = 0; i < 3; ++i) {
        const int a = 4 * j + i;
        s += "f " + std::to_string(a + 1) + "/1 " + std::to_string(a - 12 + 1) + "//3 \\\n " + std::to_string(a + 6) + "/2/2 " + std::to_string(a + 5) + "\n";
      }
  } else {
    for (const Triangle& t : plane.triangles) s += "f " + std::to_string(t[0] + 1) + " " + std::to_string(t[1] + 1) + " " + std::to_string(t[2] + 1) + "\n";
  }
  return s;
}

std::string stl_ascii() {
  const Plane plane;
  std::string s = "solid plane\n";
  for (const Triangle& t : plane.triangles) {
    s += " facet normal 0 0 1\n  outer loop\n";
    for (const VertexIndex v : t) s += "   vertex " + text(plane.points[v]) + "\n";
    s += "  endloop\n endfacet\n";
  }
  return s + "endsolid plane\n";
}

std::string stl_binary() {
  const Plane plane;
  std::string s = "solid but binary";
  s.resize(80, ' ');
  append(s, static_cast<std::uint32_t>(plane.triangles.size()));
  for (const Triangle& t : plane.triangles) {
    for (int k = 0; k < 3; ++k) append(s, 0.0f);
    for (const VertexIndex v : t)
      for (std::size_t k = 0; k < 3; ++k) append(s, static_cast<float>(plane.points[v][k]));
    append(s, std::uint16_t{0});
  }
  return s;
}

std::string ply(const std::string& format) {
  const Plane plane;
  const bool ascii = format == "ascii", big = format == "binary_big_endian";
  std::string s = "ply\nformat " + format + " 1.0\ncomment c\nelement vertex 12\nproperty uchar red\nproperty double x\nproperty double y\n";
  s += "property double z\nelement face 12\nproperty list uchar int vertex_indices\nend_header\n";
  for (const Vec3& p : plane.points) {
    if (ascii) {
      s += "7 " + text(p) + "\n";
      continue;
    }
    append(s, std::uint8_t{7});
    for (std::size_t k = 0; k < 3; ++k) append(s, p[k], big);
  }
  for (const Triangle& t : plane.triangles) {
    if (ascii) {
      s += "3 " + std::to_string(t[0]) + " " + std::to_string(t[1]) + " " + std::to_string(t[2]) + "\n";
      continue;
    }
    append(s, std::uint8_t{3});
    for (const VertexIndex v : t) append(s, static_cast<std::int32_t>(v), big);
  }
  return s;
}

std::string vtk_arrays(const char* points_type) {
  const Plane plane;
  std::string s = std::string("<Points><DataArray type=\"") + points_type + "\" NumberOfComponents=\"3\" format=\"ascii\">";
  for (const Vec3& p : plane.points) s += text(p) + "\n";
  return s + "</DataArray></Points>";
}
std::string vtk_cells(bool types) {
  const Plane plane;
  std::string c, o, k;
  for (std::size_t i = 0; i < plane.triangles.size(); ++i) {
    for (const VertexIndex v : plane.triangles[i]) c += std::to_string(v) + " ";
    o += std::to_string(3 * (i + 1)) + " ";
    k += "5 ";
  }
  std::string s = "<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">" + c + "</DataArray>";
  s += "<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">" + o + "</DataArray>";
  if (types) s += "<DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">" + k + "</DataArray>";
  return s;
}
std::string vtp() {
  return "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"0.1\" byte_order=\"LittleEndian\"><PolyData><Piece NumberOfPoints=\"12\" "
         "NumberOfPolys=\"12\">" + vtk_arrays("Float64") + "<Polys>" + vtk_cells(false) + "</Polys></Piece></PolyData></VTKFile>\n";
}
std::string vtu() {
  return "<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\"><UnstructuredGrid><Piece NumberOfPoints=\"12\" "
         "NumberOfCells=\"12\">" + vtk_arrays("Float64") + "<Cells>" + vtk_cells(true) + "</Cells></Piece></UnstructuredGrid></VTKFile>\n";
}

struct PlaneFile {
  std::string name, bytes;
  double tolerance;  ///< of the format, in metres
};
std::vector<PlaneFile> plane_files() {
  return {{"elevation.ts", gocad(1, false, "m"), 0},
          {"depth.ts", gocad(1, true, "\"m\""), 0},
          {"feet.ts", gocad(1 / 0.3048, true, "ft"), 2e-9},
          {"a.off", off(), 0},
          {"a.obj", obj(false), 0},
          {"quads.obj", obj(true), 0},
          {"a.stl", stl_ascii(), 0},
          {"binary.stl", stl_binary(), 0.5},
          {"a.ply", ply("ascii"), 0},
          {"little.ply", ply("binary_little_endian"), 0},
          {"big.ply", ply("binary_big_endian"), 0},
          {"a.vtp", vtp(), 0},
          {"a.vtu", vtu(), 0}};
}

void check_plane(const FileContents& contents, double tolerance) {
  REQUIRE(contents.surfaces.size() == 1);
  const TriangulatedSurface& s = contents.surfaces[0];
  CHECK(s.points.size() == 12);
  CHECK(s.triangles.size() == 12);
  Box3 bounds;
  for (const Vec3& p : s.points) {
    bounds.add(p);
    CHECK(std::abs(p.z - Plane::height(p.x - Plane::x0, p.y - Plane::y0)) <= 2 * tolerance);
  }
  const Box3 expected{{Plane::x0, Plane::y0, -1080}, {Plane::x0 + 150, Plane::y0 + 160, -962.5}};
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(std::abs(bounds.min[i] - expected.min[i]) <= tolerance);
    CHECK(std::abs(bounds.max[i] - expected.max[i]) <= tolerance);
  }
  for (const Triangle& t : s.triangles) {
    const Vec3 n = cross(s.points[t[1]] - s.points[t[0]], s.points[t[2]] - s.points[t[0]]);
    CHECK(std::abs(n.z - 4000) <= 200 * tolerance + 1e-6);  // up: 50 x 80
  }
}

/// The kind of error that reading ends with, and its words; what is no Error escapes.
std::optional<std::pair<ErrorKind, std::string>> error_of(const std::string& name, const std::string& bytes) {
  const TestFile file(name, bytes);
  try {
    is_plc_file(file.path) ? static_cast<void>(read_plc_file(file.path)) : static_cast<void>(read_surface_file(file.path));
  } catch (const Error& e) {
    return std::pair(e.kind(), std::string(e.what()));
  }
  return std::nullopt;
}

}  // namespace

TEST_CASE("every format gives the same tilted plane", "[readers]") {
  for (const PlaneFile& f : plane_files()) {
    INFO(f.name);
    const TestFile file(f.name, f.bytes);
    check_plane(read_surface_file(file.path), f.tolerance);
    const FileInfo info = describe_file(file.path);
    REQUIRE(info.surfaces.size() == 1);
    CHECK(info.surfaces[0].n_components == 1);
    CHECK(info.surfaces[0].n_borders == 1);
    CHECK(info.surfaces[0].n_misoriented_edges == 0);
    CHECK(info.surfaces[0].area == Approx(150 * 160 * std::sqrt(1 + 1 / 16.0 + 1 / 4.0)).epsilon(f.tolerance > 0.1 ? 0.02 : 1e-9));
    CHECK(to_json(info).find("\"triangles\": 12") != std::string::npos);
  }
}

TEST_CASE("the content decides which reader reads a file", "[readers]") {
  const TestFile file("misnamed.stl", off());
  CHECK(read_surface_file(file.path).format == "OFF");
  const TestFile bare("no_extension", gocad(1, false, "m"));
  CHECK(read_surface_file(bare.path).surfaces.at(0).name == "tilted plane");
}

TEST_CASE("a file cut anywhere is refused or says what it lost", "[readers]") {
  for (const PlaneFile& f : plane_files()) {
    // A cut within the last line's number or after it cannot be seen in formats that have neither counts nor an end (OBJ).
    if (f.name.find("obj") != std::string::npos) continue;
    const std::size_t last = f.bytes.find_last_not_of(" \r\n\t");
    for (std::size_t cut = 0; cut + 3 < last; cut += std::max<std::size_t>(1, last / 40)) {
      INFO(f.name << " cut at " << cut << " of " << f.bytes.size());
      const auto error = error_of(f.name, f.bytes.substr(0, cut));
      REQUIRE(error);
      CHECK(error->first == ErrorKind::invalid_input);
      CHECK(error->second.find(f.name) != std::string::npos);
    }
  }
}

TEST_CASE("no damage to a file ends otherwise than in an answer or an error", "[readers]") {
  std::uint32_t state = 12345;
  const auto random = [&](std::size_t n) {
    state = state * 1664525u + 1013904223u;
    return static_cast<std::size_t>((static_cast<std::uint64_t>(state) * n) >> 32);
  };
  for (const PlaneFile& f : plane_files()) {
    for (int round = 0; round < 60; ++round) {
      std::string bytes = f.bytes;
      for (int k = 0; k < 3; ++k) bytes[random(bytes.size())] = "09-e.x \n\xff"[random(9)];
      INFO(f.name << " round " << round);
      const auto error = error_of(f.name, bytes);
      if (error) CHECK((error->first == ErrorKind::invalid_input || error->first == ErrorKind::usage));
    }
  }
}

TEST_CASE("broken surface files are refused with the place and what was expected", "[readers]") {
  struct Case {
    std::string name, bytes, words;
  };
  const std::string head = "GOCAD TSurf 1\nHEADER {\nname: a\n}\nTFACE\nVRTX 1 0 0 0\nVRTX 2 1 0 0\n";
  const std::string binary("\x7f" "ELF\0\1\2\3", 8);
  const std::vector<Case> cases{
      {"a.ts", "", "the file is empty"},
      {"a.ts", binary, "a binary file, not GOCAD, though its extension says so"},
      {"a.ts", "hello\n", "does not begin as GOCAD"},
      {"a.ts", head + "VRTX 3 0 nan 0\nTRGL 1 2 3\nEND\n", "a.ts:8: coordinate y of point 3 is not finite: 'nan'"},
      {"a.ts", head + "VRTX 3 0 1 inf\nTRGL 1 2 3\nEND\n", "a.ts:8: coordinate z of point 3 is not finite"},
      {"a.ts", head + "VRTX 3 0 1\nTRGL 1 2 3\nEND\n", "a.ts:8: the line ends where coordinate z of point 3 was expected"},
      {"a.ts", head + "TRGL 1 2 3\nEND\n", "a.ts:8: vertex 3 is used but not defined above"},
      {"a.ts", head + "VRTX 2 0 1 0\nTRGL 1 2 2\nEND\n", "a.ts:8: vertex 2 is defined twice"},
      {"a.ts", head + "END\n", "nothing to read"},
      {"a.ts", head + "VRTX 99999999999 0 1 0\nTRGL 1 2 3\nEND\n", "vertex 3 is used"},
      {"a.ts", "GOCAD TSurf 1\nGOCAD_ORIGINAL_COORDINATE_SYSTEM\nAXIS_UNIT m m ms\nEND_ORIGINAL_COORDINATE_SYSTEM\nEND\n", "a surface in time"},
      {"a.ts", "GOCAD TSurf 1\nGOCAD_ORIGINAL_COORDINATE_SYSTEM\nZPOSITIVE Up\nEND_ORIGINAL_COORDINATE_SYSTEM\nEND\n", "Elevation or Depth was expected"},
      {"a.ts", "GOCAD Voxet 1\nEND\n", "nothing to read: it holds Voxet"},
      {"a.off", "OFF\n999999999999 5 0\n0 0 0\n", "more than a file of"},
      {"a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", "a.off:6: a face names vertex row 3"},
      {"a.off", "OFF\n0 0 0\n", "the surface is empty"},
      {"a.off", "OFF\n4 1 0\n0 0 0\n1 1 0\n1 0 0\n0 1 0\n4 0 1 2 3\n", "flat or crosses itself"},
      {"a.obj", "v 0 0 0\nf 1 2 0\n", "a.obj:2: expected the index of a vertex"},
      {"a.obj", "v 0 0 0\nv 1 0 0\n", "the surface is empty"},
      {"a.stl", "solid a\nendsolid a\n", "the surface is empty"},
      {"a.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nendloop\nendfacet\nendsolid\n", "a facet with 1 vertices"},
      {"a.ply", "ply\nformat ascii 1.0\nelement vertex 4000000000\nproperty float x\nproperty float y\nproperty float z\nend_header\n0 0 0\n", "only 6 bytes follow"},
      {"a.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n0\n", "no property y"},
      {"a.node", "2 3 0 0\n1 0 0 0\n", "point 2 of 2"},
      {"a.node", "900000000000 3 0 0\n1 0 0 0\n", "cannot hold"},
      {"a.poly", "3 3 0 0\n1 0 0 0\n2 1 0 0\n3 0 1 0\n1 0\n1\n3 1 2 4\n", "a.poly:7: vertex 4 does not exist"},
      {"a.xyzzy", "what is this\n", "its format is not known"},
  };
  for (const Case& c : cases) {
    INFO(c.bytes);
    const auto error = error_of(c.name, c.bytes);
    REQUIRE(error);
    INFO(error->second);
    CHECK(error->first == ErrorKind::invalid_input);
    CHECK(error->second.find(c.words) != std::string::npos);
  }
}

TEST_CASE("a missing file and a folder are errors of usage", "[readers]") {
  for (const std::filesystem::path& path : {std::filesystem::path("/no/such/file.ts"), std::filesystem::temp_directory_path()}) {
    try {
      read_surface_file(path);
      FAIL("an error was expected");
    } catch (const Error& e) {
      CHECK(e.kind() == ErrorKind::usage);
    }
  }
}
