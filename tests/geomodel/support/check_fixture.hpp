// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// A hand-made named mesh with everything that `geomesh check` judges, as files: a box of three by three by three with
/// the horizon "mid", the fault "fault" that ends inside, and the body "salt" that cuts both. Tests break it and look
/// for the fault's name.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "geomesh/core/geometry.hpp"
#include "test_places.hpp"

namespace check_fixture {

using geomesh::Tetrahedron;
using geomesh::Triangle;
using geomesh::Vec3;

/// A folder of its own under the build tree, emptied first.
inline std::filesystem::path fresh_folder(const std::string& name) {
  const std::filesystem::path folder = std::filesystem::path(GEOMESH_BINARY_DIR) / "test_check" / name;
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder;
}

struct Face {
  Triangle vertices;
  std::int32_t surface, surface_set, patch, region_minus, region_plus, source_triangle;
};

struct CheckModel {
  std::vector<Vec3> points;
  std::vector<Tetrahedron> tetrahedra;
  std::vector<std::int32_t> region;
  std::map<std::int32_t, std::string> region_names{{1, "lower"}, {2, "upper"}, {3, "salt"}};
  std::vector<Face> faces;
  std::map<std::int32_t, std::string> surface_names{{4, "mid"},  {5, "fault"}, {6, "salt"},  {7, "xmin"}, {8, "xmax"},
                                                    {9, "ymin"}, {10, "ymax"}, {11, "zmin"}, {12, "zmax"}};

  std::int32_t input_vertex_of_point_3 = 3;  ///< the others are their own rows

  /// Writes NAME.vtu, NAME.faces.vtp (where there are faces) and returns the first.
  std::filesystem::path write(const std::filesystem::path& folder, const std::string& name = "model") const;
  std::filesystem::path write_msh(const std::filesystem::path& folder) const;
  std::filesystem::path write_inp(const std::filesystem::path& folder) const;
};

constexpr int cells = 6;         ///< per axis
constexpr double spacing = 0.5;  ///< so the box is [0,3] in each axis
constexpr int body_from = 2, body_to = 4, mid_level = 3, fault_column = 3, fault_tip_row = 3;

inline std::uint32_t grid_point(int i, int j, int k) {
  return static_cast<std::uint32_t>((k * (cells + 1) + j) * (cells + 1) + i);
}

/// Points that no surface needs in place move by up to `jitter`.
inline void add_points(CheckModel& model, double jitter) {
  std::uint32_t seed = 12345;
  const auto random = [&] {
    seed = seed * 1664525u + 1013904223u;
    return jitter * (double(seed >> 8) / (1u << 24) - 0.5);
  };
  for (int k = 0; k <= cells; ++k)
    for (int j = 0; j <= cells; ++j)
      for (int i = 0; i <= cells; ++i) {
        const auto inner = [](int a) { return a > 0 && a < cells; };
        const auto in_body = [](int a) { return a >= body_from && a <= body_to; };
        Vec3 p{i * spacing, j * spacing, k * spacing};
        const bool free = inner(i) && inner(j) && inner(k) && k != mid_level && i != fault_column &&
                          !(in_body(i) && in_body(j) && in_body(k));
        if (free) p = p + Vec3{random(), random(), random()};
        model.points.push_back(p);
      }
}

/// Six tetrahedra a grid cell, one for each order of the axes.
inline void add_tetrahedra(CheckModel& model) {
  constexpr std::array<std::array<int, 3>, 6> orders{
      {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {1, 0, 2}, {0, 2, 1}, {2, 1, 0}}};
  for (int k = 0; k < cells; ++k)
    for (int j = 0; j < cells; ++j)
      for (int i = 0; i < cells; ++i)
        for (std::size_t o = 0; o < 6; ++o) {
          std::array<int, 3> at{i, j, k};
          Tetrahedron t{grid_point(i, j, k)};
          for (std::size_t step = 0; step < 3; ++step) {
            ++at[static_cast<std::size_t>(orders[o][step])];
            t[step + 1] = grid_point(at[0], at[1], at[2]);
          }
          if (o >= 3) std::swap(t[2], t[3]);
          const auto in_body = [](int a) { return a >= body_from && a < body_to; };
          model.tetrahedra.push_back(t);
          model.region.push_back(in_body(i) && in_body(j) && in_body(k) ? 3 : k >= mid_level ? 2 : 1);
        }
}

/// The face's surface by its place: box sides, then salt, mid, fault; 0: none.
inline std::int32_t surface_at(const CheckModel& model, const Triangle& t, std::int32_t minus, std::int32_t plus) {
  const auto all = [&](std::size_t axis, double value) {
    for (const auto v : t)
      if (model.points[v][axis] != value) return false;
    return true;
  };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (all(axis, 0)) return static_cast<std::int32_t>(7 + 2 * axis);
    if (all(axis, cells * spacing)) return static_cast<std::int32_t>(8 + 2 * axis);
  }
  if (minus != plus) return minus == 3 || plus == 3 ? 6 : 4;
  if (minus == 3 || !all(0, fault_column * spacing)) return 0;
  for (const auto v : t)
    if (model.points[v].y > fault_tip_row * spacing || model.points[v].z < mid_level * spacing) return 0;
  return 5;
}

/// Row in the input surface (see write_project): squares are two triangles parted by the diagonal from their least to
/// their greatest corner.
inline std::int32_t source_of(const CheckModel& model, const Triangle& t, std::int32_t surface) {
  Vec3 c{};
  for (const auto v : t) c = c + (1.0 / 3) * model.points[v];
  if (surface == 4) return c.y < c.x ? 0 : 1;
  if (surface == 5) return c.z - mid_level * spacing < c.y ? 0 : 1;
  if (surface != 6) return 0;
  const double low = body_from * spacing, high = body_to * spacing;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double u = c[(axis + 1) % 3], v = c[(axis + 2) % 3];
    const auto side = static_cast<std::int32_t>(4 * axis + (v < u ? 0 : 1));
    if (model.points[t[0]][axis] == low && model.points[t[1]][axis] == low && model.points[t[2]][axis] == low)
      return side;
    if (model.points[t[0]][axis] == high && model.points[t[1]][axis] == high && model.points[t[2]][axis] == high)
      return side + 2;
  }
  return -1;
}

inline void add_faces(CheckModel& model) {
  constexpr std::array<std::array<int, 3>, 4> outward{{{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};
  std::map<Triangle, std::pair<Triangle, std::int32_t>> open;  // sorted -> (outward, region)
  const auto add = [&](const Triangle& t, std::int32_t minus, std::int32_t plus) {
    const std::int32_t surface = surface_at(model, t, minus, plus);
    if (surface != 0) model.faces.push_back({t, surface, surface - 4, 1, minus, plus, source_of(model, t, surface)});
  };
  for (std::size_t i = 0; i < model.tetrahedra.size(); ++i)
    for (const auto& f : outward) {
      const Triangle t{model.tetrahedra[i][f[0]], model.tetrahedra[i][f[1]], model.tetrahedra[i][f[2]]};
      Triangle key = t;
      std::sort(key.begin(), key.end());
      const auto it = open.find(key);
      if (it == open.end()) {
        open.emplace(key, std::pair{t, model.region[i]});
      } else {
        add(it->second.first, it->second.second, model.region[i]);
        open.erase(it);
      }
    }
  for (const auto& [key, side] : open) add(side.first, side.second, 0);
}

inline CheckModel sound_model(double jitter = 0.15) {
  CheckModel model;
  add_points(model, jitter);
  add_tetrahedra(model);
  add_faces(model);
  return model;
}

inline void write_ts(const std::filesystem::path& file, const std::string& name, const std::vector<Vec3>& points,
                     const std::vector<Triangle>& triangles) {
  std::ofstream out(file);
  out.precision(17);
  out << "GOCAD TSurf 1\nHEADER {\nname:" << name << "\n}\nTFACE\n";
  for (std::size_t i = 0; i < points.size(); ++i)
    out << "VRTX " << i + 1 << ' ' << points[i].x << ' ' << points[i].y << ' ' << points[i].z << '\n';
  for (const Triangle& t : triangles) out << "TRGL " << t[0] + 1 << ' ' << t[1] + 1 << ' ' << t[2] + 1 << '\n';
  out << "END\n";
}

/// The project that the sound model is a mesh of, with its surfaces; returns the project file.
inline std::filesystem::path write_project(const std::filesystem::path& folder) {
  const double z = mid_level * spacing, x = fault_column * spacing, tip = fault_tip_row * spacing,
               top = cells * spacing;
  // The horizon overshoots the box on all sides, its diagonal along x = y.
  write_ts(folder / "mid.ts", "mid", {{-1, -1, z}, {4, -1, z}, {4, 4, z}, {-1, 4, z}}, {{0, 1, 2}, {0, 2, 3}});
  write_ts(folder / "fault.ts", "fault", {{x, 0, z}, {x, tip, z}, {x, tip, top}, {x, 0, top}}, {{0, 1, 2}, {0, 2, 3}});
  std::vector<Vec3> corners;
  std::vector<Triangle> triangles;
  const double low = body_from * spacing, high = body_to * spacing;
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const double at : {low, high}) {
      const auto first = static_cast<std::uint32_t>(corners.size());
      for (const auto& [u, v] : {std::pair{low, low}, {high, low}, {high, high}, {low, high}}) {
        Vec3 p;
        p[axis] = at;
        p[(axis + 1) % 3] = u;
        p[(axis + 2) % 3] = v;
        corners.push_back(p);
      }
      Triangle one{first, first + 1, first + 2}, two{first, first + 2, first + 3};
      if (at == low) {
        std::swap(one[1], one[2]);
        std::swap(two[1], two[2]);
      }
      triangles.push_back(one);
      triangles.push_back(two);
    }
  write_ts(folder / "salt.ts", "salt", corners, triangles);
  std::ofstream(folder / "project.yaml") << "name: model\n"
                                            "box: {min: [0, 0, 0], max: [3, 3, 3]}\n"
                                            "surfaces:\n"
                                            "  - {name: mid, kind: horizon, file: mid.ts}\n"
                                            "  - {name: fault, kind: fault, file: fault.ts}\n"
                                            "  - {name: salt, kind: body, file: salt.ts, cuts: all}\n"
                                            "column: [upper, mid, lower]\n"
                                            "mesh: {refine: none}\n";
  return folder / "project.yaml";
}

template <class Range, class Text>
void write_array(std::ofstream& out, const char* type, const std::string& name, int components, const Range& range,
                 Text&& text) {
  out << "<DataArray type=\"" << type << "\" Name=\"" << name << "\" NumberOfComponents=\"" << components
      << "\" format=\"ascii\">\n";
  for (const auto& item : range) {
    text(out, item);
    out << '\n';
  }
  out << "</DataArray>\n";
}

inline void write_points(std::ofstream& out, const std::vector<Vec3>& points) {
  out << "<Points>\n";
  write_array(out, "Float64", "Points", 3, points,
              [](auto& o, const Vec3& p) { o << p.x << ' ' << p.y << ' ' << p.z; });
  out << "</Points>\n";
}

inline void write_names(std::ofstream& out, const std::string& what, const std::map<std::int32_t, std::string>& names) {
  out << "<DataArray type=\"Int32\" Name=\"" << what << "_ids\" NumberOfTuples=\"" << names.size()
      << "\" format=\"ascii\">\n";
  for (const auto& [id, name] : names) out << id << ' ';
  out << "</DataArray>\n<Array type=\"String\" Name=\"" << what << "_names\" NumberOfTuples=\"" << names.size()
      << "\" format=\"ascii\">\n";
  for (const auto& [id, name] : names) {
    for (const char c : name) out << static_cast<int>(c) << ' ';
    out << "0 ";
  }
  out << "</Array>\n";
}

inline std::filesystem::path CheckModel::write(const std::filesystem::path& folder, const std::string& name) const {
  const std::filesystem::path vtu = folder / (name + ".vtu");
  std::ofstream out(vtu);
  out.precision(17);
  out << "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
         "byte_order=\"LittleEndian\">\n<UnstructuredGrid>\n<FieldData>\n";
  write_names(out, "region", region_names);
  out << "</FieldData>\n<Piece NumberOfPoints=\"" << points.size() << "\" NumberOfCells=\"" << tetrahedra.size()
      << "\">\n";
  write_points(out, points);
  out << "<Cells>\n";
  write_array(out, "Int64", "connectivity", 1, tetrahedra,
              [](auto& o, const Tetrahedron& t) { o << t[0] << ' ' << t[1] << ' ' << t[2] << ' ' << t[3]; });
  std::size_t offset = 0;
  write_array(out, "Int64", "offsets", 1, tetrahedra, [&](auto& o, const Tetrahedron&) { o << (offset += 4); });
  write_array(out, "UInt8", "types", 1, tetrahedra, [](auto& o, const Tetrahedron&) { o << 10; });
  out << "</Cells>\n<CellData>\n";
  if (!region.empty()) write_array(out, "Int32", "region", 1, region, [](auto& o, std::int32_t id) { o << id; });
  out << "</CellData>\n<PointData>\n";
  write_array(out, "Int32", "kind", 1, points, [](auto& o, const Vec3&) { o << 0; });
  std::size_t row = 0;
  write_array(out, "Int32", "input_vertex", 1, points, [&](auto& o, const Vec3&) {
    o << (row == 3 ? input_vertex_of_point_3 : static_cast<std::int32_t>(row));
    ++row;
  });
  out << "</PointData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
  if (faces.empty()) return vtu;

  std::ofstream vtp(folder / (name + ".faces.vtp"));
  vtp.precision(17);
  vtp << "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\">\n<PolyData>\n<FieldData>\n";
  write_names(vtp, "surface", surface_names);
  vtp << "<DataArray type=\"Int32\" Name=\"surface_set_offsets\" NumberOfTuples=\"" << surface_names.size() + 1
      << "\" format=\"ascii\">\n";
  for (std::size_t i = 0; i <= surface_names.size(); ++i) vtp << i << ' ';
  vtp << "</DataArray>\n<DataArray type=\"Int32\" Name=\"surface_set_ids\" NumberOfTuples=\"" << surface_names.size()
      << "\" format=\"ascii\">\n";
  for (const auto& [id, text] : surface_names) vtp << id << ' ';
  vtp << "</DataArray>\n</FieldData>\n<Piece NumberOfPoints=\"" << points.size() << "\" NumberOfPolys=\""
      << faces.size() << "\">\n";
  write_points(vtp, points);
  vtp << "<Polys>\n";
  write_array(vtp, "Int64", "connectivity", 1, faces,
              [](auto& o, const Face& f) { o << f.vertices[0] << ' ' << f.vertices[1] << ' ' << f.vertices[2]; });
  offset = 0;
  write_array(vtp, "Int64", "offsets", 1, faces, [&](auto& o, const Face&) { o << (offset += 3); });
  vtp << "</Polys>\n<CellData>\n";
  const auto add = [&](const char* array, std::int32_t Face::*member) {
    write_array(vtp, "Int32", array, 1, faces, [&](auto& o, const Face& f) { o << f.*member; });
  };
  add("surface", &Face::surface);
  add("surface_set", &Face::surface_set);
  add("patch", &Face::patch);
  add("region_minus", &Face::region_minus);
  add("region_plus", &Face::region_plus);
  add("source_triangle", &Face::source_triangle);
  vtp << "</CellData>\n</Piece>\n</PolyData>\n</VTKFile>\n";
  return vtu;
}

inline std::filesystem::path CheckModel::write_msh(const std::filesystem::path& folder) const {
  const std::filesystem::path file = folder / "model.msh";
  std::ofstream out(file);
  out.precision(17);
  out << "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PhysicalNames\n" << region_names.size() << '\n';
  for (const auto& [id, text] : region_names) out << "3 " << id << " \"" << text << "\"\n";
  out << "$EndPhysicalNames\n$Entities\n0 0 0 " << region_names.size() << '\n';
  for (const auto& [id, text] : region_names) out << id << " 0 0 0 3 3 3 1 " << id << " 0\n";
  out << "$EndEntities\n$Nodes\n1 " << points.size() << " 1 " << points.size() << "\n3 1 0 " << points.size() << '\n';
  for (std::size_t i = 0; i < points.size(); ++i) out << i + 1 << '\n';
  for (const Vec3& p : points) out << p.x << ' ' << p.y << ' ' << p.z << '\n';
  out << "$EndNodes\n$Elements\n"
      << region_names.size() << ' ' << tetrahedra.size() << " 1 " << tetrahedra.size() << '\n';
  for (const auto& [id, text] : region_names) {
    std::size_t n = 0;
    for (const auto r : region) n += r == id ? 1 : 0;
    out << "3 " << id << " 4 " << n << '\n';
    for (std::size_t i = 0; i < tetrahedra.size(); ++i) {
      if (region[i] != id) continue;
      out << i + 1;
      for (const auto v : tetrahedra[i]) out << ' ' << v + 1;
      out << '\n';
    }
  }
  out << "$EndElements\n";
  return file;
}

inline std::filesystem::path CheckModel::write_inp(const std::filesystem::path& folder) const {
  const std::filesystem::path file = folder / "model.inp";
  std::ofstream out(file);
  out.precision(17);
  out << "*HEADING\nhand-made\n*NODE, NSET=all\n";
  for (std::size_t i = 0; i < points.size(); ++i)
    out << i + 1 << ", " << points[i].x << ", " << points[i].y << ", " << points[i].z << '\n';
  for (const auto& [id, text] : region_names) {
    out << "*ELEMENT, TYPE=C3D4, ELSET=" << text << '\n';
    for (std::size_t i = 0; i < tetrahedra.size(); ++i) {
      if (region[i] != id) continue;
      out << i + 1;
      for (const auto v : tetrahedra[i]) out << ", " << v + 1;
      out << '\n';
    }
  }
  return file;
}

}  // namespace check_fixture
