// SPDX-License-Identifier: GPL-3.0-or-later
// The plane as triangles.
#include <cstdint>
#include <sstream>

#include "installed.hpp"
#include "plane_files.hpp"

namespace geomesh::geomodel {
namespace {

std::string number(double v) {
  std::ostringstream out;
  out.precision(17);
  out << v;
  return out.str();
}
std::string text(const Vec3& p) { return number(p.x) + " " + number(p.y) + " " + number(p.z); }

/// GOCAD with everything that trips readers: gaps in the ids, an atom, properties, a block between, CRLF.
std::string gocad(double scale, bool depth, const std::string& unit) {
  const Plane plane;
  std::string s =
      "GOCAD TSurf 1\r\nHEADER { name: \"tilted plane\" }\r\nGOCAD_ORIGINAL_COORDINATE_SYSTEM\r\nNAME \" x y\" \r\n";
  s += "AXIS_UNIT " + unit + " " + unit + " " + unit + "\r\nZPOSITIVE " + std::string(depth ? "Depth" : "Elevation");
  s += "\r\nEND_ORIGINAL_COORDINATE_SYSTEM\r\nPROPERTIES p\r\nNO_DATA_VALUES -99999\r\nPROPERTY_CLASS_HEADER p q "
       "{\r\nis_z: on\r\n}\r\nTFACE\r\n";
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
  for (const Triangle& t : plane.triangles)
    s += "3 " + std::to_string(t[0]) + " " + std::to_string(t[1]) + " " + std::to_string(t[2]) + " 255 0 0\n";
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
        s += "f " + std::to_string(a + 1) + "/1 " + std::to_string(a - 12 + 1) + "//3 \\\n " + std::to_string(a + 6) +
             "/2/2 " + std::to_string(a + 5) + "\n";
      }
  } else {
    for (const Triangle& t : plane.triangles)
      s += "f " + std::to_string(t[0] + 1) + " " + std::to_string(t[1] + 1) + " " + std::to_string(t[2] + 1) + "\n";
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
  std::string s = "ply\nformat " + format +
                  " 1.0\ncomment c\nelement vertex 12\nproperty uchar red\nproperty double x\nproperty double y\n";
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
  std::string s =
      std::string("<Points><DataArray type=\"") + points_type + "\" NumberOfComponents=\"3\" format=\"ascii\">";
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
  return "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"0.1\" "
         "byte_order=\"LittleEndian\"><PolyData><Piece NumberOfPoints=\"12\" "
         "NumberOfPolys=\"12\">" +
         vtk_arrays("Float64") + "<Polys>" + vtk_cells(false) + "</Polys></Piece></PolyData></VTKFile>\n";
}
std::string vtu() {
  return "<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\"><UnstructuredGrid><Piece "
         "NumberOfPoints=\"12\" "
         "NumberOfCells=\"12\">" +
         vtk_arrays("Float64") + "<Cells>" + vtk_cells(true) + "</Cells></Piece></UnstructuredGrid></VTKFile>\n";
}

}  // namespace

std::vector<PlaneFile> triangle_plane_files() {
  return {{"elevation.ts", gocad(1, false, "m"), 0},
          {"depth.ts", gocad(1, true, "\"m\""), 0},
          {"feet.ts", gocad(1 / 0.3048, true, "ft"), 2e-9},
          {"a.off", off(), 0},
          {"a.obj", obj(false), 0, false},
          {"quads.obj", obj(true), 0, false},
          {"a.stl", stl_ascii(), 0},
          {"binary.stl", stl_binary(), 0.5},
          {"a.ply", ply("ascii"), 0},
          {"little.ply", ply("binary_little_endian"), 0},
          {"big.ply", ply("binary_big_endian"), 0},
          {"a.vtp", vtp(), 0},
          {"a.vtu", vtu(), 0}};
}

std::vector<PlaneFile> plane_files() {
  std::vector<PlaneFile> files = triangle_plane_files();
  for (PlaneFile& f : grid_plane_files())
    if (!f.name.ends_with(".tif") || testing::has_module("gdal")) files.push_back(std::move(f));
  return files;
}

std::string plane_file(const std::string& name) {
  for (PlaneFile& f : plane_files())
    if (f.name == name) return std::move(f.bytes);
  return {};
}

}  // namespace geomesh::geomodel
