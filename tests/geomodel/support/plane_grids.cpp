// SPDX-License-Identifier: GPL-3.0-or-later
// The plane as a grid of 4 by 3 nodes, and as points, DXF and OMF. What is written here is written by the formats' own
// rules, with no code of the readers.
#include <algorithm>
#include <cstdint>
#include <cstdio>

#include "plane_files.hpp"

namespace geomesh::geomodel {
namespace {

constexpr int n_columns = 4, n_rows = 3;
constexpr double dx = 50, dy = 80;

double node_height(int i, int j) { return Plane::height(dx * i, dy * j); }
double node_x(int i) { return Plane::x0 + dx * i; }
double node_y(int j) { return Plane::y0 + dy * j; }

std::string text(double v, const char* format = "%.17g") {
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, format, v);
  return buffer;
}
std::string comma(std::string s) {
  std::replace(s.begin(), s.end(), '.', ',');
  return s;
}

std::string esri(bool corner, bool decimal_comma) {
  std::string s = "NCOLS 4\nnrows 3\n";
  s += corner ? "xllcorner " + text(Plane::x0 - dx / 2) + "\nyllcorner " + text(Plane::y0 - dy / 2) + "\n"
              : "xllcenter " + text(Plane::x0) + "\nyllcenter " + text(Plane::y0) + "\n";
  s += "dx 50\ndy 80\nNODATA_value -99999\n";
  for (int j = n_rows - 1; j >= 0; --j)
    for (int i = 0; i < n_columns; ++i) s += text(node_height(i, j)) + (i == 1 ? "\n" : " ");
  return decimal_comma ? comma(s) : s;
}

std::string surfer_text() {
  std::string s = "DSAA\n4 3\n" + text(Plane::x0) + " " + text(node_x(3)) + "\n" + text(Plane::y0) + " " +
                  text(node_y(2)) + "\n-1080 -962.5\n";
  for (int j = 0; j < n_rows; ++j)
    for (int i = 0; i < n_columns; ++i) s += text(node_height(i, j)) + " ";
  return s + "\n";
}

std::string surfer_6() {
  std::string s = "DSBB";
  append(s, std::int16_t{4});
  append(s, std::int16_t{3});
  for (const double v : {Plane::x0, node_x(3), Plane::y0, node_y(2), -1080.0, -962.5}) append(s, v);
  for (int j = 0; j < n_rows; ++j)
    for (int i = 0; i < n_columns; ++i) append(s, static_cast<float>(node_height(i, j)));
  return s;
}

std::string surfer_7() {
  std::string s = "DSRB";
  append(s, std::int32_t{4});
  append(s, std::int32_t{1});
  s += "GRID";
  append(s, std::int32_t{72});
  append(s, std::int32_t{3});
  append(s, std::int32_t{4});
  for (const double v : {Plane::x0, Plane::y0, dx, dy, -1080.0, -962.5, 0.0, 1.70141e38}) append(s, v);
  s += "DATA";
  append(s, std::int32_t{96});
  for (int j = 0; j < n_rows; ++j)
    for (int i = 0; i < n_columns; ++i) append(s, node_height(i, j));
  return s;
}

std::string zmap(const char* format, int width, int decimals, double factor) {
  std::string s = "! a comment\n@plane HEADER, GRID, 2\n" + std::to_string(width) + ", -99999.0000, , " +
                  std::to_string(decimals) + ", 1\n3, 4, " + text(Plane::x0) + ", " + text(node_x(3)) + ", " +
                  text(Plane::y0) + ", " + text(node_y(2)) + "\n0.0, 0.0, 0.0\n@\n";
  for (int i = 0; i < n_columns; ++i) {
    for (int j = n_rows - 1; j >= 0; --j) s += text(factor * node_height(i, j), format) + (j == 1 ? "\n" : "");
    s += "\n";
  }
  return s;
}

std::string cps3() {
  std::string s = "FSASCI 0 1 \"Computed\" 0 1.0E+30\nFSATTR 0 0\nFSLIMI " + text(Plane::x0) + " " + text(node_x(3)) +
                  " " + text(Plane::y0) + " " + text(node_y(2)) + " -1080 -962.5\nFSNROW 3 4\nFSXINC 50 80\n->plane\n";
  for (int i = 0; i < n_columns; ++i)
    for (int j = n_rows - 1; j >= 0; --j) s += text(node_height(i, j)) + (j == 0 ? "\n" : " ");
  return s;
}

/// Turned by a right angle: columns go north, rows west.
std::string irap(bool turned) {
  const int nx = turned ? n_rows : n_columns, ny = turned ? n_columns : n_rows;
  std::string s = "-996 " + std::to_string(ny) + " " + text(turned ? dy : dx) + " " + text(turned ? dx : dy) + "\n";
  s += text(Plane::x0) + " " + text(node_x(3)) + " " + text(Plane::y0) + " " + text(node_y(2)) + "\n" +
       std::to_string(nx) + " " + (turned ? "90" : "0") + " " + text(turned ? node_x(3) : Plane::x0) + " " +
       text(Plane::y0) + "\n0 0 0 0 0 0 0\n";
  for (int row = 0; row < ny; ++row)
    for (int column = 0; column < nx; ++column)
      s += text(turned ? node_height(3 - row, column) : node_height(column, row)) + (column % 3 == 2 ? "\n" : " ");
  return s;
}

std::string irap_binary() {
  std::string s;
  const auto record = [&](const std::string& bytes) {
    append(s, static_cast<std::int32_t>(bytes.size()), true);
    s += bytes;
    append(s, static_cast<std::int32_t>(bytes.size()), true);
  };
  std::string r;
  append(r, std::int32_t{-996}, true);
  append(r, std::int32_t{3}, true);
  for (const double v : {Plane::x0, node_x(3), Plane::y0, node_y(2), dx, dy}) append(r, static_cast<float>(v), true);
  record(r);
  r.clear();
  append(r, std::int32_t{4}, true);
  for (const double v : {0.0, Plane::x0, Plane::y0}) append(r, static_cast<float>(v), true);
  record(r);
  record(std::string(28, '\0'));
  for (int j = 0; j < n_rows; ++j) {
    r.clear();
    for (int i = 0; i < n_columns; ++i) append(r, static_cast<float>(node_height(i, j)), true);
    record(r);
  }
  return s;
}

/// A TIFF of one strip of doubles, from the north.
std::string geotiff(bool pixel_is_point) {
  struct Tag {
    std::uint16_t id, type;
    std::uint32_t count, value;
  };
  constexpr std::uint32_t n_tags = 13, data_at = 8 + 2 + 12 * n_tags + 4;
  std::string data;
  const auto place = [&](auto&& fill) {
    const auto at = static_cast<std::uint32_t>(data_at + data.size());
    fill();
    return at;
  };
  const std::uint32_t scale = place([&] {
    for (const double v : {dx, dy, 0.0}) append(data, v);
  });
  const double half = pixel_is_point ? 0 : 0.5;  // the tie point is the corner of the first cell, or its centre
  const std::uint32_t tie = place([&] {
    for (const double v : {0.0, 0.0, 0.0, Plane::x0 - half * dx, node_y(2) + half * dy, 0.0}) append(data, v);
  });
  const std::uint32_t keys = place([&] {
    for (const int v : {1, 1, 0, 3, 1024, 0, 1, 1, 1025, 0, 1, pixel_is_point ? 2 : 1, 3072, 0, 1, 32632})
      append(data, static_cast<std::uint16_t>(v));
  });
  const std::uint32_t pixels = place([&] {
    for (int j = n_rows - 1; j >= 0; --j)
      for (int i = 0; i < n_columns; ++i) append(data, node_height(i, j));
  });
  std::string s("II*\0", 4);
  append(s, std::uint32_t{8});
  append(s, static_cast<std::uint16_t>(n_tags));
  for (const Tag& t : {Tag{256, 3, 1, 4}, Tag{257, 3, 1, 3}, Tag{258, 3, 1, 64}, Tag{259, 3, 1, 1}, Tag{262, 3, 1, 1},
                       Tag{273, 4, 1, pixels}, Tag{277, 3, 1, 1}, Tag{278, 3, 1, 3}, Tag{279, 4, 1, 96},
                       Tag{339, 3, 1, 3}, Tag{33550, 12, 3, scale}, Tag{33922, 12, 6, tie}, Tag{34735, 3, 16, keys}}) {
    append(s, t.id);
    append(s, t.type);
    append(s, t.count);
    append(s, t.value);
  }
  append(s, std::uint32_t{0});
  return s + data;
}

std::string lines_of_points(const std::string& between, bool decimal_comma = false, double z_factor = 1) {
  std::string s;
  for (int i = n_columns - 1; i >= 0; --i)
    for (int j = 0; j < n_rows; ++j) {
      const std::string line =
          text(node_x(i)) + between + text(node_y(j)) + between + text(z_factor * node_height(i, j));
      s += (decimal_comma ? comma(line) : line) + "\n";
    }
  return s;
}

std::string earth_vision(bool grid) {
  std::string s =
      "# Type: scattered data\n# Version: 6\n# Format: free\n# Field: 1 x\n# Field: 2 y\n# Field: 3 z meters\n";
  if (grid) s += "# Field: 4 column\n# Field: 5 row\n";
  s += "# Projection: Local Rectangular\n# Units: meters\n# End:\n";
  if (!grid) return s + lines_of_points(" ");
  s += "# Information from grid:\n# Grid_size: 4 x 3\n# Grid_space: 1,2,3,4\n";
  for (int j = 0; j < n_rows; ++j)
    for (int i = 0; i < n_columns; ++i)
      s += text(node_x(i)) + " " + text(node_y(j)) + " " + text(node_height(i, j)) + " " + std::to_string(i + 1) + " " +
           std::to_string(j + 1) + "\n";
  return s;
}

std::string petrel() {
  return "# Petrel Points with attributes\n# Unit in X and Y direction: m\n# Unit in depth: m\nVERSION 1\nBEGIN "
         "HEADER\nX\nY\nZ\nEND HEADER\n" +
         lines_of_points(" ");
}

std::string pair(int code, const std::string& value) { return std::to_string(code) + "\r\n" + value + "\r\n"; }
std::string dxf_point(int k, const Vec3& p) {
  return pair(10 + k, text(p.x)) + pair(20 + k, text(p.y)) + pair(30 + k, text(p.z));
}
std::string dxf(const std::string& entities) {
  return pair(0, "SECTION") + pair(2, "HEADER") + pair(9, "$INSUNITS") + pair(70, "6") + pair(0, "ENDSEC") +
         pair(0, "SECTION") + pair(2, "ENTITIES") + entities + pair(0, "ENDSEC") + pair(0, "EOF");
}

std::string dxf_faces() {
  const Plane plane;
  std::string s;
  for (const Triangle& t : plane.triangles) {
    s += pair(0, "3DFACE") + pair(8, "plane");
    for (int k = 0; k < 4; ++k) s += dxf_point(k, plane.points[t[static_cast<std::size_t>(std::min(k, 2))]]);
  }
  return dxf(s);
}

std::string dxf_polyface() {
  const Plane plane;
  std::string s =
      pair(0, "POLYLINE") + pair(8, "plane") + pair(66, "1") + pair(70, "64") + pair(71, "12") + pair(72, "12");
  for (const Vec3& p : plane.points) s += pair(0, "VERTEX") + pair(8, "plane") + dxf_point(0, p) + pair(70, "192");
  for (const Triangle& t : plane.triangles) {
    s += pair(0, "VERTEX") + pair(8, "plane") + dxf_point(0, {}) + pair(70, "128");
    for (int k = 0; k < 3; ++k)
      s += pair(71 + k, std::string(k == 1 ? "-" : "") + std::to_string(t[static_cast<std::size_t>(k)] + 1));
  }
  return dxf(s + pair(0, "SEQEND"));
}

/// M runs west so that the faces, which follow M before N, turn left from above.
std::string dxf_mesh() {
  std::string s =
      pair(0, "POLYLINE") + pair(8, "plane") + pair(66, "1") + pair(70, "16") + pair(71, "4") + pair(72, "3");
  for (int i = 0; i < n_columns; ++i)
    for (int j = 0; j < n_rows; ++j)
      s += pair(0, "VERTEX") + pair(8, "plane") + dxf_point(0, {node_x(i), node_y(j), node_height(i, j)}) +
           pair(70, "64");
  return dxf(s + pair(0, "SEQEND"));
}

/// The faces in a block within a block: the inner one mirrored in x, at half the size, about a base point; the outer
/// one turned by 90 degrees. 1/2 and quarter turns about whole numbers lose nothing.
std::string dxf_blocks() {
  // On the way out a point p of the inner block becomes q = (-2 (p.x - 3), 2 (p.y - 5), 2 p.z) + (10, 20, 0), then
  // (-q.y, q.x, q.z) + at.
  const Vec3 at{Plane::x0, Plane::y0, -1000};
  const auto inner = [&](const Vec3& out) {
    const Vec3 r = out - at, q{r.y, -r.x, r.z};
    return Vec3{3 - (q.x - 10) / 2, 5 + (q.y - 20) / 2, q.z / 2};
  };
  const Plane plane;
  std::string faces;
  for (const Triangle& t : plane.triangles) {
    faces += pair(0, "3DFACE") + pair(8, "0");  // the other way round: the mirror turns them
    for (int k = 0; k < 4; ++k)
      faces += dxf_point(k, inner(plane.points[t[static_cast<std::size_t>(k == 0 ? 0 : k == 1 ? 2 : 1)]]));
  }
  std::string s = pair(0, "SECTION") + pair(2, "BLOCKS");
  s += pair(0, "BLOCK") + pair(8, "0") + pair(2, "inner") + dxf_point(0, {3, 5, 0}) + faces + pair(0, "ENDBLK");
  s += pair(0, "BLOCK") + pair(8, "0") + pair(2, "outer") + dxf_point(0, {0, 0, 0});
  s += pair(0, "INSERT") + pair(8, "0") + pair(2, "inner") + dxf_point(0, {10, 20, 0}) + pair(41, "-2") +
       pair(42, "2") + pair(43, "2") + pair(0, "ENDBLK");
  s += pair(0, "ENDSEC") + pair(0, "SECTION") + pair(2, "ENTITIES");
  s += pair(0, "INSERT") + pair(8, "plane") + pair(2, "outer") + dxf_point(0, at) + pair(50, "90");
  return s + pair(0, "ENDSEC") + pair(0, "EOF");
}

/// zlib with one stored block.
std::string stored(const std::string& bytes) {
  std::string s("\x78\x01\x01", 3);
  append(s, static_cast<std::uint16_t>(bytes.size()));
  append(s, static_cast<std::uint16_t>(~bytes.size()));
  std::uint32_t a = 1, b = 0;
  for (const char c : bytes) {
    a = (a + static_cast<unsigned char>(c)) % 65521;
    b = (b + a) % 65521;
  }
  s += bytes;
  append(s, (b << 16) | a, true);
  return s;
}

std::string omf() {
  const Plane plane;
  const Vec3 project{400000, 6000000, 0}, element{32000, 12345, -500};
  std::string points, triangles;
  for (const Vec3& p : plane.points)
    for (std::size_t k = 0; k < 3; ++k) append(points, p[k] - project[k] - element[k]);
  for (const Triangle& t : plane.triangles)
    for (const VertexIndex v : t) append(triangles, static_cast<std::int64_t>(v));
  const std::string first = stored(points), second = stored(triangles);
  std::string s("\x84\x83\x82\x81OMF-v0.9.0", 14);
  s.resize(36, '\0');
  for (int i = 0; i < 16; ++i) s += static_cast<char>(i + 1);
  append(s, static_cast<std::uint64_t>(60 + first.size() + second.size()));
  s += first + second;
  const std::string at2 = std::to_string(60 + first.size());
  s +=
      R"({"01020304-0506-0708-090a-0b0c0d0e0f10": {"__class__": "Project", "elements": ["e"], "origin": [400000, 6000000, 0], "units": "m"},)";
  s += R"("e": {"__class__": "SurfaceElement", "name": "plane", "geometry": "g"},)";
  s += R"("g": {"__class__": "SurfaceGeometry", "origin": [32000, 12345, -500], "vertices": "v", "triangles": "t"},)";
  s += R"("v": {"__class__": "Vector3Array", "array": {"start": 60, "length": )" + std::to_string(first.size()) +
       R"(, "dtype": "<f8"}},)";
  s += R"("t": {"__class__": "Int3Array", "array": {"start": )" + at2 + R"(, "length": )" +
       std::to_string(second.size()) + R"(, "dtype": "<i8"}}})";
  return s;
}

/// As omf(), as a grid surface whose nodes run along u or along v first; the axes are x and y.
std::string omf_grid(bool u_first) {
  const Vec3 project{400000, 6000000, 0};
  std::string u, v, offsets;
  for (int i = 0; i + 1 < n_columns; ++i) append(u, double{dx});
  for (int j = 0; j + 1 < n_rows; ++j) append(v, double{dy});
  for (int a = 0; a < (u_first ? n_rows : n_columns); ++a)
    for (int b = 0; b < (u_first ? n_columns : n_rows); ++b)
      append(offsets, (u_first ? node_height(b, a) : node_height(a, b)) + 500);
  const std::array<std::string, 3> arrays{stored(u), stored(v), stored(offsets)};
  std::string s("\x84\x83\x82\x81OMF-v0.9.0", 14), joined;
  std::array<std::string, 3> at;
  for (std::size_t k = 0; k < 3; ++k) {
    at[k] = R"({"start": )" + std::to_string(60 + joined.size()) + R"(, "length": )" +
            std::to_string(arrays[k].size()) + R"(, "dtype": "<f8"})";
    joined += arrays[k];
  }
  s.resize(36, '\0');
  for (int i = 0; i < 16; ++i) s += static_cast<char>(i + 1);
  append(s, static_cast<std::uint64_t>(60 + joined.size()));
  s += joined;
  s +=
      R"({"01020304-0506-0708-090a-0b0c0d0e0f10": {"__class__": "Project", "elements": ["e"], "origin": [400000, 6000000, 0], "units": "m"},)";
  s += R"("e": {"__class__": "SurfaceElement", "name": "plane", "geometry": "g"},)";
  s += R"("g": {"__class__": "SurfaceGridGeometry", "origin": [)" + text(node_x(0) - project.x) + ", " +
       text(node_y(0) - project.y) + R"(, -500], )";
  s += R"("axis_u": [1, 0, 0], "axis_v": [0, 1, 0], "tensor_u": )" + at[0] + R"(, "tensor_v": )" + at[1] +
       R"(, "offset_w": "w"},)";
  return s + R"("w": {"__class__": "ScalarArray", "array": )" + at[2] + "}}";
}

}  // namespace

std::vector<PlaneFile> grid_plane_files() {
  return {{"corner.asc", esri(true, false), 0},
          {"centre.asc", esri(false, true), 0},
          {"text.grd", surfer_text(), 0},
          {"surfer6.grd", surfer_6(), 0},
          {"surfer7.grd", surfer_7(), 0},
          {"blanks.zmap", zmap("%15.4f", 15, 4, 1), 0},
          {"abutting.zmap", zmap("%10.4f", 10, 4, 1), 0},
          {"implied.zmap", zmap("%12.0f", 12, 4, 1e4), 1e-9},
          {"a.cps3", cps3(), 0},
          {"a.irap", irap(false), 0},
          {"turned.irap", irap(true), 0},
          {"binary.irap", irap_binary(), 0.5},
          {"area.tif", geotiff(false), 0},
          {"point.tif", geotiff(true), 0},
          {"a.xyz", lines_of_points(" "), 0, false},
          {"tabs.xyz", "X\tY\tZ\n" + lines_of_points("\t"), 0, false},
          {"comma.csv", "x,y,z\n" + lines_of_points(","), 0, false},
          {"depth.csv", "\"Easting [m]\",Northing,Depth_ft\n" + lines_of_points(",", false, -1 / 0.3048), 2e-9, false},
          {"decimal_comma.csv", "x;y;z\n" + lines_of_points(";", true), 0, false},
          {"decimal_comma.xyz", lines_of_points(" ", true), 0, false},
          {"points.ev", earth_vision(false), 0, false},
          {"grid.ev", earth_vision(true), 0, false},
          {"a.petrel", petrel(), 0, false},
          {"faces.dxf", dxf_faces(), 0},
          {"polyface.dxf", dxf_polyface(), 0},
          {"mesh.dxf", dxf_mesh(), 0},
          {"blocks.dxf", dxf_blocks(), 1e-9},
          {"a.omf", omf(), 0},
          {"along_u.omf", omf_grid(true), 0},
          {"along_v.omf", omf_grid(false), 0}};
}

}  // namespace geomesh::geomodel
