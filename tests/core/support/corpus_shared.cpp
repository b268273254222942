// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus_shared.hpp"

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>

#include "corpus_builder.hpp"
#include "plc_reader.hpp"

namespace geomesh::test {

namespace {

PiecewiseLinearComplex grains_in_box(const std::string& folder) {
  PlcBuilder b;
  Box3 box;
  for (int i = 0; i < 100; ++i) {
    const PiecewiseLinearComplex grain = read_plc(folder + "/grains/" + std::to_string(i) + ".obj");
    for (Index f = 0; f < grain.n_facets(); ++f) {
      const auto t = grain.outer_loop(f);
      b.triangle(grain.points[t[0]], grain.points[t[1]], grain.points[t[2]]);
    }
    for (const Vec3& p : grain.points) box.add(p);
  }
  const Vec3 margin{1, 1, 1};
  b.box(box.min - margin, box.max + margin);
  return b.plc;
}

/// Binary little-endian PLY as one file of `solids` has it: float coordinates first, then faces as lists of int after a
/// count in a byte; what else stands in a face's row are bytes.
PiecewiseLinearComplex read_binary_ply(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::size_t n_vertices = 0, n_faces = 0, row_bytes = 0, face_extra = 0;
  bool in_faces = false;
  for (std::string line; std::getline(in, line) && line.rfind("end_header", 0) != 0;) {
    std::istringstream words(line);
    std::string key, type;
    words >> key >> type;
    if (key == "element") in_faces = type == "face", words >> (in_faces ? n_faces : n_vertices);
    if (key != "property" || type == "list") continue;
    (in_faces ? face_extra : row_bytes) += type == "uchar" ? 1 : 4;
  }
  PlcBuilder b;
  std::vector<Vec3> points;
  std::vector<char> row(row_bytes);
  for (std::size_t i = 0; i < n_vertices; ++i) {
    in.read(row.data(), static_cast<std::streamsize>(row_bytes));
    float p[3];
    std::memcpy(p, row.data(), sizeof p);
    points.push_back({p[0], p[1], p[2]});
  }
  for (std::size_t i = 0; i < n_faces; ++i) {
    const int n = in.get();
    std::int32_t v[3];
    if (n != 3 || !in.read(reinterpret_cast<char*>(v), sizeof v))
      throw std::runtime_error(path + ": a face that is no triangle");
    in.ignore(static_cast<std::streamsize>(face_extra));
    if (v[0] != v[1] && v[1] != v[2] && v[2] != v[0]) b.triangle(points.at(v[0]), points.at(v[1]), points.at(v[2]));
  }
  return b.plc;
}

bool is_binary_ply(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::string first, second;
  std::getline(in, first);
  std::getline(in, second);
  return first.rfind("ply", 0) == 0 && second.find("binary_little_endian") != std::string::npos;
}

PiecewiseLinearComplex gocad_model(const std::string& path) {
  PlcBuilder b;
  const GocadTriangles soup = read_gocad_triangles(path);
  for (const Triangle& t : soup.triangles) b.triangle(soup.points[t[0]], soup.points[t[1]], soup.points[t[2]]);
  return b.plc;
}

}  // namespace

GocadTriangles read_gocad_triangles(const std::string& path) {
  std::ifstream in(path);
  if (!in) throw std::runtime_error("cannot open " + path);
  GocadTriangles out;
  std::map<long, VertexIndex> rows;
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string key;
    words >> key;
    if (key == "GOCAD") rows.clear();
    if (key == "VRTX" || key == "PVRTX") {
      long id = 0;
      Vec3 p;
      words >> id >> p.x >> p.y >> p.z;
      rows[id] = static_cast<VertexIndex>(out.points.size());
      out.points.push_back(p);
    } else if (key == "ATOM" || key == "PATOM") {
      long id = 0, of = 0;
      words >> id >> of;
      rows[id] = rows.at(of);
    } else if (key == "TRGL") {
      long a = 0, b = 0, c = 0;
      words >> a >> b >> c;
      out.triangles.push_back({rows.at(a), rows.at(b), rows.at(c)});
    }
  }
  return out;
}

std::vector<SharedModel> shared_models(const std::string& folder) {
  std::vector<SharedModel> models;
  if (!std::filesystem::exists(folder)) return models;
  // two_spheres, Gravgen and soup cross themselves: they are no complexes before they are intersected.
  for (const char* name : {"solids/bunny25k.obj",
                           "solids/cow25k.obj",
                           "solids/sphere1.obj",
                           "solids/sphere2.obj",
                           "solids/res.obj",
                           "solids/bamboo_pen.obj",
                           "solids/cube_minus_sphere.obj",
                           "solids/humanoid.off",
                           "solids/soccerball.obj",
                           "solids/1002_tray_bottom.STL",
                           "solids/7_8ths_cube.stl",
                           "solids/featuretype.ply",
                           "solids/fixed_top.ply",
                           "solids/plate_holes.STL",
                           "solids/round.stl",
                           "solids/shared.STL",
                           "solids/multibody.stl",
                           "solids/ballA.off",
                           "solids/ballB.off",
                           "classic/schonhardt.off",
                           "classic/schonhardt_5.off",
                           "classic/schonhardt_59.off",
                           "classic/chazelle_slits_2.poly",
                           "classic/chazelle_slits_4.poly",
                           "classic/chazelle_slits_8.poly",
                           "classic/lattice_3.poly",
                           "classic/lattice_8.poly",
                           "classic/pillar_holes_regions.poly",
                           "classic/schonhardt_in_box_hole.poly",
                           "classic/schonhardt_in_box_regions.poly",
                           "classic/wedge_0.01deg.poly",
                           "classic/wedge_1deg.poly",
                           "classic/wedge_1e-6.poly"})
    models.push_back(
        {name, [path = folder + "/" + name] { return is_binary_ply(path) ? read_binary_ply(path) : read_plc(path); }});
  models.push_back({"grains in a box", [folder] { return grains_in_box(folder); }});
  models.push_back({"modelA4/modelA4.ml", [folder] { return gocad_model(folder + "/modelA4/modelA4.ml"); }});
  return models;
}

}  // namespace geomesh::test
