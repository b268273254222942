// SPDX-License-Identifier: GPL-3.0-or-later
// One analytic, tilted, asymmetric plane written in every format with one expected answer, and the same files broken in
// every way.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <optional>

#include "geomesh/core/error.hpp"
#include "geomesh/geomodel/info.hpp"
#include "geomesh/geomodel/readers.hpp"
#include "installed.hpp"
#include "plane_files.hpp"
#include "scratch.hpp"

using namespace geomesh;
using namespace geomesh::geomodel;

namespace {

/// A file of the test, gone at the end.
struct TestFile {
  std::filesystem::path path;
  TestFile(const std::string& name, const std::string& bytes)
      : path(testing::scratch_folder() / ("geomesh_readers_" + name)) {
    std::ofstream(path, std::ios::binary) << bytes;
  }
  ~TestFile() { std::filesystem::remove(path); }
};

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
    is_plc_file(file.path) ? static_cast<void>(read_plc_file(file.path))
                           : static_cast<void>(read_surface_file(file.path));
    static_cast<void>(to_text(describe_file(file.path)));
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
    CHECK(info.surfaces[0].area ==
          Approx(150 * 160 * std::sqrt(1 + 1 / 16.0 + 1 / 4.0)).epsilon(f.tolerance > 0.1 ? 0.02 : 1e-9));
    CHECK(to_json(info).find("\"triangles\": 12") != std::string::npos);
  }
}

TEST_CASE("the content decides which reader reads a file", "[readers]") {
  const TestFile file("misnamed.stl", plane_file("a.off"));
  CHECK(read_surface_file(file.path).format == "OFF");
  const TestFile bare("no_extension", plane_file("elevation.ts"));
  CHECK(read_surface_file(bare.path).surfaces.at(0).name == "tilted plane");
}

TEST_CASE("a file cut anywhere is refused or says what it lost", "[readers]") {
  for (const PlaneFile& f : plane_files()) {
    if (!f.sees_its_end) continue;  // no counts and no end mark (OBJ, tables of points)
    const std::size_t end = f.bytes.find_last_not_of(" \r\n\t");
    // A cut within the number that ends a text cannot be seen either.
    const std::size_t last = f.bytes.find('\0') == std::string::npos ? f.bytes.find_last_of(" \r\n\t", end) : end;
    for (std::size_t cut = 0; cut + 3 < last; cut += std::max<std::size_t>(1, last / 40)) {
      INFO(f.name << " cut at " << cut << " of " << f.bytes.size());
      const auto error = error_of(f.name, f.bytes.substr(0, cut));
      REQUIRE(error);
      CHECK(error->first == ErrorKind::invalid_input);
      CHECK(error->second.find(f.name) != std::string::npos);
    }
  }
}

namespace {

/// Damages files in the ways in which they are damaged: bytes changed, lost, doubled, cut off, numbers blown up. The
/// same for the same seed.
class Damage {
 public:
  explicit Damage(std::uint64_t seed) : state_(seed) {}

  std::string apply(std::string bytes) {
    for (std::size_t n = 1 + random(4); n > 0 && !bytes.empty(); --n) {
      const std::size_t at = random(bytes.size()), length = 1 + random(std::min<std::size_t>(bytes.size() - at, 40));
      switch (random(7)) {
        case 0:
          bytes[at] = "09-e.x \n\xff\0"[random(10)];
          break;
        case 1:
          bytes[at] = static_cast<char>(bytes[at] ^ (1 << random(8)));
          break;
        case 2:
          bytes.erase(at, length);
          break;
        case 3:
          bytes.insert(at, bytes.substr(at, length));
          break;
        case 4:
          bytes.insert(at, "99999999999");
          break;
        case 5:
          bytes.replace(at, std::min<std::size_t>(4, bytes.size() - at), "\xff\xff\xff\x7f");
          break;
        default:
          bytes.resize(at);
          break;
      }
    }
    return bytes;
  }

 private:
  std::size_t random(std::size_t n) {
    state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<std::size_t>((state_ >> 33) % n);
  }
  std::uint64_t state_;
};

void damage_every_format(std::uint64_t first_seed, std::uint64_t n_rounds) {
  for (const PlaneFile& f : plane_files()) {
    for (std::uint64_t seed = first_seed; seed < first_seed + n_rounds; ++seed) {
      INFO(f.name << " with seed " << seed);
      const auto error = error_of(f.name, Damage(seed).apply(f.bytes));
      if (error) CHECK((error->first == ErrorKind::invalid_input || error->first == ErrorKind::usage));
    }
  }
}

}  // namespace

TEST_CASE("no damage to a file ends otherwise than in an answer or an error", "[readers][fuzz]") {
  damage_every_format(1, 100);
}

TEST_CASE("no damage to a file ends otherwise, at length", "[.][nightly][readers][fuzz]") {
  damage_every_format(1000, 5000);
}

namespace {

/// A VTK XML file of four points with the given cells; `types` empty for PolyData.
/// A triangle with the word as its value, and no point data.
std::string with_cell_data(const std::string& word) {
  return "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\"><UnstructuredGrid><Piece NumberOfPoints=\"3\" "
         "NumberOfCells=\"1\"><Points><DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">0 0 0 1 0 "
         "0 0 "
         "1 0</DataArray></Points><Cells><DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">0 1 "
         "2</DataArray><DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">3</DataArray><DataArray "
         "type=\"UInt8\" Name=\"types\" format=\"ascii\">5</DataArray></Cells><CellData><DataArray type=\"Int32\" "
         "Name=\"a\" format=\"ascii\">" +
         word + "</DataArray></CellData></Piece></UnstructuredGrid></VTKFile>";
}

std::string vtk_file(const std::string& kind, const std::string& count, const std::string& element,
                     const std::string& connectivity, const std::string& offsets, const std::string& types) {
  const auto array = [](const std::string& name, const std::string& type, const std::string& values) {
    return "<DataArray type=\"" + type + "\" Name=\"" + name + "\" format=\"ascii\">" + values + "</DataArray>";
  };
  std::string s =
      "<VTKFile type=\"" + kind + "\" version=\"0.1\"><" + kind + "><Piece NumberOfPoints=\"4\" " + count + ">";
  s += "<Points><DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">0 0 0 1 0 0 1 1 0 0 1 "
       "1</DataArray></Points>";
  s += "<" + element + ">" + array("connectivity", "Int64", connectivity) + array("offsets", "Int64", offsets);
  if (!types.empty()) s += array("types", "UInt8", types);
  return s + "</" + element + "></Piece></" + kind + "></VTKFile>\n";
}

}  // namespace

TEST_CASE("broken surface files are refused with the place and what was expected", "[readers]") {
  struct Case {
    std::string name, bytes, words;
  };
  const std::string head = "GOCAD TSurf 1\nHEADER {\nname: a\n}\nTFACE\nVRTX 1 0 0 0\nVRTX 2 1 0 0\n";
  const std::string binary(
      "\x7f"
      "ELF\0\1\2\3",
      8);
  const std::vector<Case> cases{
      {"a.ts", "", "the file is empty"},
      {"a.ts", binary, "a binary file, not GOCAD, though its extension says so"},
      {"a.ts", "hello\n", "does not begin as GOCAD"},
      {"a.ts", head + "VRTX 3 0 nan 0\nTRGL 1 2 3\nEND\n", "a.ts:8: coordinate y of point 3 is not finite: 'nan'"},
      {"a.ts", head + "VRTX 3 0 1 inf\nTRGL 1 2 3\nEND\n", "a.ts:8: coordinate z of point 3 is not finite"},
      {"a.ts", head + "VRTX 3 0 1\nTRGL 1 2 3\nEND\n",
       "a.ts:8: the line ends where coordinate z of point 3 was expected"},
      {"a.ts", head + "TRGL 1 2 3\nEND\n", "a.ts:8: vertex 3 is used but not defined above"},
      {"a.ts", head + "VRTX 2 0 1 0\nTRGL 1 2 2\nEND\n", "a.ts:8: vertex 2 is defined twice"},
      {"a.ts", head + "END\n", "nothing to read"},
      {"a.ts", head + "VRTX 99999999999 0 1 0\nTRGL 1 2 3\nEND\n", "vertex 3 is used"},
      {"a.ts",
       "GOCAD TSurf 1\nGOCAD_ORIGINAL_COORDINATE_SYSTEM\nAXIS_UNIT m m ms\nEND_ORIGINAL_COORDINATE_SYSTEM\nEND\n",
       "a surface in time"},
      {"a.ts", "GOCAD TSurf 1\nGOCAD_ORIGINAL_COORDINATE_SYSTEM\nZPOSITIVE Up\nEND_ORIGINAL_COORDINATE_SYSTEM\nEND\n",
       "Elevation or Depth was expected"},
      {"a.ts", "GOCAD Voxet 1\nEND\n", "nothing to read: it holds Voxet"},
      {"a.off", "OFF\n999999999999 5 0\n0 0 0\n", "more than a file of"},
      {"a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", "a.off:6: a face names vertex row 3"},
      {"a.off", "OFF\n0 0 0\n", "the surface is empty"},
      {"a.off", "OFF\n4 1 0\n0 0 0\n1 1 0\n1 0 0\n0 1 0\n4 0 1 2 3\n", "flat or crosses itself"},
      {"a.obj", "v 0 0 0\nf 1 2 0\n", "a.obj:2: expected the index of a vertex"},
      {"a.obj", "v 0 0 0\nv 1 0 0\n", "the surface is empty"},
      {"a.stl", "solid a\nendsolid a\n", "the surface is empty"},
      {"a.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nendloop\nendfacet\nendsolid\n",
       "a facet with 1 vertices"},
      {"a.ply",
       "ply\nformat ascii 1.0\nelement vertex 4000000000\nproperty float x\nproperty float y\nproperty float "
       "z\nend_header\n0 0 0\n",
       "only 6 bytes follow"},
      {"a.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n0\n", "no property y"},
      {"a.node", "2 3 0 0\n1 0 0 0\n", "point 2 of 2"},
      {"a.node", "900000000000 3 0 0\n1 0 0 0\n", "cannot hold"},
      {"a.poly", "3 3 0 0\n1 0 0 0\n2 1 0 0\n3 0 1 0\n1 0\n1\n3 1 2 4\n", "a.poly:7: vertex 4 does not exist"},
      {"a.asc", "ncols 99999999\nnrows 99999999\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 2 3\n",
       "bytes of values follow"},
      {"a.asc", "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 2 3 4 5\n", "more values follow"},
      {"a.asc", "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 0\n1 2 3 4\n", "positive numbers were expected"},
      {"a.asc", "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\n-9999 -9999 -9999 1\n", "the grid is empty"},
      {"a.asc", "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 2 x 4\n",
       "a.asc:6: expected a height, found 'x'"},
      {"a.grd", "DSAA\n2 2\n5 5\n0 1\n0 1\n1 2 3 4\n", "the limits of x"},
      {"a.grd", "DSAA\n1000000 1000000\n0 1\n0 1\n0 1\n1 2 3 4\n", "is given as 1000000"},
      {"a.zmap", "@a HEADER, GRID, 5\n10, 1e30, , 4, 1\n2, 2, 0, 1, 0, 1\n@\n1. 2.\n3.\n", "the file ends after 3"},
      {"a.zmap", "@a HEADER, GRID, 5\n10, 1e30, , 4, 1\n900000000, 900000000, 0, 1, 0, 1\n@\n1. 2.\n",
       "bytes of values follow"},
      {"a.cps3", "FSASCI 0 1 \"C\" 0 1E30\nFSNROW 2 2\n1 2 3 4\n", "FSLIMI"},
      {"a.irap", "-996 2 1 1\n0 1 0 1\n2 0 0 0\n0 0 0 0 0 0 0\n1 2 3\n", "the file ends where a height was expected"},
      {"a.petrel", "# Unit in depth: ms\nVERSION 1\nBEGIN HEADER\nX\nY\nZ\nEND HEADER\n1 2 3\n", "a surface in time"},
      {"a.csv", "x,y,twt\n1,2,3\n4,5,6\n", "a surface in time"},
      {"a.csv", "id,a,b,c\n1,2,3,4\n", "columns x, y and z"},
      {"a.csv", "x,y,z\n1,2,3\n4,five,6\n", "a.csv:3: expected a number for y in column 2, found 'five'"},
      {"a.csv", "x,y,z\n1,2,3\n4,5\n", "a.csv:3: expected at least 3 columns"},
      {"a.xyz", "1 2 3\n4 inf 6\n", "a.xyz:2: coordinate y is not finite"},
      {"a.ev",
       "# Field: 1 x\n# Field: 2 y\n# Field: 3 z\n# Field: 4 column\n# Field: 5 row\n# Grid_size: 99999 x 99999\n0 0 0 "
       "1 1\n",
       "far more than the file holds"},
      {"a.ev",
       "# Field: 1 x\n# Field: 2 y\n# Field: 3 z\n# Field: 4 column\n# Field: 5 row\n# Grid_size: 2 x 2\n0 0 0 3 1\n",
       "a point has column 3"},
      {"a.dxf", "0\nSECTION\n2\nENTITIES\n0\n3DFACE\n8\n0\n10\n1\n20\n1\n30\n",
       "the file ends where the value of group 30"},
      {"a.dxf", "AutoCAD Binary DXF\r\n", "a binary DXF file is not read"},
      {"a.dxf",
       "0\nSECTION\n2\nBLOCKS\n0\nBLOCK\n2\na\n0\nINSERT\n2\na\n10\n0\n20\n0\n0\nENDBLK\n0\nENDSEC\n0\nSECTION\n2\nENTI"
       "TIES\n"
       "0\nINSERT\n2\na\n10\n0\n20\n0\n0\nENDSEC\n0\nEOF\n",
       "holds itself"},
      {"a.dxf",
       "0\nSECTION\n2\nBLOCKS\n0\nBLOCK\n2\na\n0\nPOINT\n10\n0\n20\n0\n0\nENDBLK\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n"
       "0\nINSERT\n2\na\n10\n0\n20\n0\n70\n99999\n71\n99999\n0\nENDSEC\n0\nEOF\n",
       "would make more than"},
      {"a.omf", "PK\x03\x04", "OMF version 2 is not read"},
      {"a.tif", std::string("II*\0\x08\0\0\0\0\0", 10), "the TIFF file cannot be read"},
      {"a.vtp",
       "<VTKFile type=\"PolyData\" version=\"0.1\"><PolyData><Piece NumberOfPoints=\"1\"><Points><DataArray "
       "type=\"Float64\" "
       "NumberOfComponents=\"999999999993\" format=\"ascii\">0 0 0</DataArray></Points></Piece></PolyData></VTKFile>",
       "where 999999999993 were expected"},
      {"a.vtp", vtk_file("PolyData", "NumberOfPolys=\"2\"", "Polys", "0 1 2 3 0 1", "4 6", ""),
       "cell 1 (counted from 0) has 2 corners"},
      {"a.vtu", vtk_file("UnstructuredGrid", "NumberOfCells=\"1\"", "Cells", "0 1 2", "3", "10"),
       "of type 10 has 3 corners"},
      {"a.vtu", vtk_file("UnstructuredGrid", "NumberOfCells=\"1\"", "Cells", "0 1 2 3 0 1", "6", "22"),
       "is of VTK's type 22, which is not read"},
      {"a.vtu", with_cell_data("q"), "where a number of its type was expected"},
      {"a.xyzzy", "what is this\n", "its format is not known"},
  };
  for (const Case& c : cases) {
    INFO(c.bytes);
    const auto error = error_of(c.name, c.bytes);
    REQUIRE(error);
    INFO(error->second);
    if (std::string_view(c.name).ends_with(".tif") && !testing::has_module("gdal")) {
      CHECK(error->second.find("apt install geomesh-gdal") != std::string::npos);
      continue;
    }
    CHECK(error->first == ErrorKind::invalid_input);
    CHECK(error->second.find(c.words) != std::string::npos);
  }
}

TEST_CASE("a VTK file without point data is read", "[readers]") { CHECK_FALSE(error_of("a.vtu", with_cell_data("1"))); }

TEST_CASE("surfaces and lines are read from legacy VTK files", "[readers]") {
  const std::string head =
      "# vtk DataFile Version 4.2\ntitle\nASCII\nDATASET POLYDATA\nPOINTS 4 double\n"
      "0 0 0 1 0 0 1 1 0 0 1 1\n";
  const TestFile file("a.vtk", head + "LINES 1 3\n2 0 1\nPOLYGONS 1 5\n4 0 1 2 3\nTRIANGLE_STRIPS 1 5\n4 0 1 3 2\n");
  const FileContents contents = read_surface_file(file.path);
  REQUIRE(contents.surfaces.size() == 1);
  CHECK(contents.surfaces[0].triangles.size() == 4);
  CHECK(contents.polylines.size() == 1);
  CHECK(contents.format == "VTK PolyData");
  const auto error = error_of("a.vtk", "# vtk DataFile Version 3.0\nt\nASCII\nDATASET STRUCTURED_POINTS\n");
  REQUIRE(error);
  CHECK(error->second.find("UNSTRUCTURED_GRID and POLYDATA are read") != std::string::npos);
}

TEST_CASE("a missing file and a folder are errors of usage", "[readers]") {
  for (const std::filesystem::path& path :
       {std::filesystem::path("/no/such/file.ts"), std::filesystem::temp_directory_path()}) {
    try {
      read_surface_file(path);
      FAIL("an error was expected");
    } catch (const Error& e) {
      CHECK(e.kind() == ErrorKind::usage);
    }
  }
}
