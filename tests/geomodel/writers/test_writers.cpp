// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>
#include <thread>

#include "geomesh/core/error.hpp"
#include "geomesh/geomodel/formats.hpp"
#include "geomesh/geomodel/writers.hpp"
#include "hand_made.hpp"
#include "installed.hpp"
#include "test_places.hpp"

using namespace geomesh;
using namespace geomesh::geomodel;
using namespace geomesh::geomodel::testing;
using nlohmann::json;
namespace fs = std::filesystem;

namespace {

/// An empty folder of its own under the build tree.
fs::path fresh_folder(const std::string& name) {
  const fs::path folder = fs::path(GEOMESH_BINARY_DIR) / "test-output" / name;
  fs::remove_all(folder);
  fs::create_directories(folder);
  return folder;
}

std::string bytes_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// Runs read_back.py; skips aloud where the reader is not installed.
void read_back(const std::string& what, const fs::path& first, const fs::path& second) {
  const fs::path log = fs::path(GEOMESH_BINARY_DIR) / "test-output" / "read_back.log";
  const std::string command = std::string("timeout 120 /usr/bin/python3 ") + GEOMESH_SOURCE_DIR +
                              "/tests/geomodel/read_back.py " + what + " '" + first.string() + "' '" + second.string() +
                              "' > '" + log.string() + "' 2>&1";
  const int status = exit_code_of(command);
  if (status == no_reader || status == no_program) {
    WARN("skipped: reading back with " << what << " (not installed)");
    return;
  }
  INFO(what << ": " << bytes_of(log));
  CHECK(status == 0);
}

json expectations(const ModelMesh& mesh) {
  json wanted;
  wanted["points"] = mesh.points.size();
  wanted["tetrahedra"] = mesh.tetrahedra.size();
  wanted["faces"] = mesh.faces.size();
  wanted["curve_edges"] = mesh.curve_edges.size();
  wanted["marked_points"] = mesh.marked_points.size();
  for (const Vec3& p : mesh.points) wanted["coordinates"].push_back({p.x, p.y, p.z});
  for (const Region& r : mesh.regions) wanted["regions"].push_back(r.name);
  for (const NamedSurface& s : mesh.surfaces) wanted["surfaces"].push_back(s.name);
  for (const NamedCurve& c : mesh.curves) wanted["curves"].push_back(c.name);
  for (const auto& p : mesh.marked_points) wanted["curves"].push_back(p.name);
  return wanted;
}

/// Elements that a group with this full name ("surface", "surface/region", a region, curve or point) must have.
std::size_t n_elements_of(const ModelMesh& mesh, const std::string& full_name) {
  for (const Region& r : mesh.regions)
    if (r.name == full_name) return r.n_tetrahedra;
  for (const NamedCurve& c : mesh.curves)
    if (c.name == full_name)
      return static_cast<std::size_t>(std::count_if(mesh.curve_edges.begin(), mesh.curve_edges.end(),
                                                    [&](const auto& e) { return e.curve == c.id; }));
  for (const auto& p : mesh.marked_points)
    if (p.name == full_name) return 1;
  const std::string surface = full_name.substr(0, full_name.find('/'));
  const std::string region = full_name.find('/') == std::string::npos ? "" : full_name.substr(full_name.find('/') + 1);
  std::size_t n = 0;
  for (const auto& face : mesh.faces)
    for (const NamedSurface& s : mesh.surfaces)
      n += s.id == face.surface && s.name == surface &&
           (region.empty() || mesh.regions[static_cast<std::size_t>(face.region_minus - 1)].name == region);
  return n;
}

json groups_with_counts(const ModelMesh& mesh, const fs::path& sidecar) {
  json groups;
  const json listed = json::parse(bytes_of(sidecar));
  for (const json& g : listed["groups"]) groups[g["name"].get<std::string>()] = n_elements_of(mesh, g["full_name"]);
  return groups;
}

}  // namespace

TEST_CASE("the VTK files hold the contract's arrays and read back to the same doubles", "[writers]") {
  const fs::path folder = fresh_folder("vtk");
  const ModelMesh mesh = three_layer_mesh(2, 1.0 / 3, {549500.1, 7820100.7, -0.1});
  const auto files = write_format(mesh, "vtu", folder / "model");
  CHECK(files == std::vector<fs::path>{folder / "model.vtu", folder / "model.faces.vtp", folder / "model.curves.vtp",
                                       folder / "model.vtu.json"});
  std::ofstream(folder / "wanted.json") << expectations(mesh);
  read_back("vtk", folder / "model", folder / "wanted.json");
  read_back("meshio", folder / "model.vtu", folder / "wanted.json");
  const std::string head = bytes_of(files[0]).substr(0, 400);
  CHECK(head.find("header_type=\"UInt64\"") != std::string::npos);
  CHECK(head.find("vtkZLibDataCompressor") != std::string::npos);
}

TEST_CASE("every format is the same byte for byte when written again", "[writers]") {
  const auto write_all = [](const fs::path& folder) {
    std::map<std::string, std::map<fs::path, std::string>> bytes;  // by format and file in the folder
    const ModelMesh mesh = three_layer_mesh(3);
    const std::set<std::string> of_modules{"exodus", "med", "xdmf", "seissol", "vtkhdf"};
    for (const std::string& format : mesh_formats()) {
      if (of_modules.contains(format) && !has_module(format)) continue;
      for (const fs::path& file : write_format(mesh, format, folder / "model"))
        bytes[format][file.lexically_relative(folder)] = bytes_of(file);
    }
    for (const auto& entry : fs::directory_iterator(folder)) CHECK(entry.path().extension() != ".part");
    return bytes;
  };
  const auto first = write_all(fresh_folder("again-1"));
  // HDF5 stores times in seconds: the second writing is in another one.
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));
  const auto second = write_all(fresh_folder("again-2"));
  for (const auto& [format, files] : first)
    for (const auto& [file, bytes] : files) {
      INFO(format << ": " << file);
      CHECK(!bytes.empty());
      CHECK((second.at(format).at(file) == bytes));
    }
}

TEST_CASE("Gmsh and meshio read the .msh with all names and counts", "[writers]") {
  const fs::path folder = fresh_folder("msh");
  const ModelMesh mesh = three_layer_mesh(2, 0.1, {500000, 6000000, 0});
  write_format(mesh, "msh", folder / "model");
  json wanted = expectations(mesh);
  wanted["groups"] = groups_with_counts(mesh, folder / "model.msh.json");
  std::size_t n_faces = 0;
  std::set<std::string> names;
  const json sidecar = json::parse(bytes_of(folder / "model.msh.json"));
  for (const json& g : sidecar["groups"]) {
    const std::string name = g["name"];
    CHECK(std::regex_match(name, std::regex("[A-Za-z][A-Za-z0-9_.-]{0,79}")));
    CHECK(names.insert(name).second);
    if (g["dimension"] == 2) n_faces += wanted["groups"][name].get<std::size_t>();
  }
  CHECK(n_faces == mesh.faces.size());
  std::ofstream(folder / "wanted.json") << wanted;
  read_back("meshio", folder / "model.msh", folder / "wanted.json");
  read_back("gmsh", folder / "model.msh", folder / "wanted.json");
}

TEST_CASE("meshio reads the .inp with its element and node sets", "[writers]") {
  const fs::path folder = fresh_folder("inp");
  const ModelMesh mesh = three_layer_mesh(2);
  write_format(mesh, "inp", folder / "model");
  json wanted = expectations(mesh);
  const json sidecar = json::parse(bytes_of(folder / "model.inp.json"));
  for (const json& g : sidecar["groups"]) {
    if (g["type"] == "elset") wanted["groups"][g["name"].get<std::string>()] = n_elements_of(mesh, g["full_name"]);
    if (g["full_name"] == "zmin" || g["full_name"] == "upper") wanted["groups"][g["name"].get<std::string>()] = 9;
  }
  std::ofstream(folder / "wanted.json") << wanted;
  read_back("meshio", folder / "model.inp", folder / "wanted.json");
}

TEST_CASE("numbers of an .inp have at most 20 characters and lose nothing at model scale", "[writers]") {
  const fs::path folder = fresh_folder("inp-numbers");
  ModelMesh mesh = three_layer_mesh(1);
  const std::vector<double> values{
      0.1 + 0.2, -7821750.123456789, 1.2345678901234567e-5, -1.2345678901234567e-5, 5e-324, -8.7654321e+22, 1e22, 0};
  for (std::size_t i = 0; i < values.size(); ++i) mesh.points[i].x = values[i];
  write_format(mesh, "inp", folder / "model");
  std::istringstream lines(bytes_of(folder / "model.inp"));
  std::string line, word;
  while (std::getline(lines, line) && line != "*NODE") {
  }
  for (const double value : values) {
    REQUIRE(std::getline(lines, line));
    std::istringstream words(line);
    std::getline(words, word, ',');
    std::getline(words, word, ',');
    word.erase(0, 1);
    CHECK(word.size() <= 20);
    INFO(word);
    if (std::abs(value) >= 1e-3 || value == 0) {
      CHECK(std::strtod(word.c_str(), nullptr) == value);
    } else {
      CHECK(std::strtod(word.c_str(), nullptr) == Approx(value).epsilon(1e-13));
    }
  }
}

TEST_CASE("sides of C3D4 elements in the .inp are those of the surface", "[writers]") {
  const fs::path folder = fresh_folder("inp-sides");
  const ModelMesh mesh = three_layer_mesh(2);
  write_format(mesh, "inp", folder / "model", {.groups = GroupChoice::both});
  // Nodes of S1 .. S4 as the solvers' manuals number them, from 0.
  const int nodes_of_side[4][3] = {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}};
  std::istringstream lines(bytes_of(folder / "model.inp"));
  std::string line, keyword, current;
  std::map<std::size_t, Tetrahedron> elements;
  std::map<std::string, std::vector<Triangle>> faces;
  while (std::getline(lines, line)) {
    if (line[0] == '*') {
      keyword = line.substr(0, line.find(','));
      current = line.rfind("*SURFACE, NAME=", 0) == 0 ? line.substr(15, line.find(',', 15) - 15) : "";
    } else if (keyword == "*ELEMENT") {
      std::replace(line.begin(), line.end(), ',', ' ');
      std::istringstream row(line);
      std::size_t element = 0;
      row >> element;
      for (VertexIndex& v : elements[element]) {
        row >> v;
        --v;  // nodes are the mesh's points, from 1
      }
    } else if (!current.empty()) {
      const std::size_t element = std::stoul(line), side = static_cast<std::size_t>(line[line.find('S') + 1] - '1');
      Triangle t;
      for (std::size_t k = 0; k < 3; ++k) t[k] = elements.at(element)[static_cast<std::size_t>(nodes_of_side[side][k])];
      faces[current].push_back(t);
    }
  }
  CHECK(elements.size() == mesh.tetrahedra.size());
  const auto mean_normal_z = [&](const std::vector<Triangle>& list) {
    double z = 0;
    for (const Triangle& t : list)
      z += cross(mesh.points[t[1]] - mesh.points[t[0]], mesh.points[t[2]] - mesh.points[t[0]]).z / 2;
    return z;
  };
  // The manuals' order turns round the element so that the normal points out of it: where it is in, the sign is the
  // other one.
  CHECK(faces.at("zmin.faces").size() == 8);
  CHECK(std::abs(mean_normal_z(faces.at("zmin.faces"))) == 4);
  std::size_t by_region = 0;  // xmin meets all three regions: by region it is given once more
  for (const auto& [name, list] : faces)
    if (name.rfind("xmin.faces", 0) != 0 && name.rfind("xmin", 0) == 0) by_region += list.size();
  CHECK(by_region == faces.at("xmin.faces").size());
  CHECK(mean_normal_z(faces.at("upper.minus")) == -mean_normal_z(faces.at("upper.plus")));
  for (const auto& [name, list] : faces)
    for (const Triangle& t : list) {
      const std::string surface = name.substr(0, name.find('.'));
      if (surface == "upper") CHECK((mesh.points[t[0]].z == 2 && mesh.points[t[1]].z == 2 && mesh.points[t[2]].z == 2));
      if (surface == "zmin") CHECK((mesh.points[t[0]].z == 0 && mesh.points[t[1]].z == 0 && mesh.points[t[2]].z == 0));
    }
}

TEST_CASE("what cannot be written leaves no file, and an unknown format is refused", "[writers]") {
  const ModelMesh mesh = three_layer_mesh(1);
  for (const std::string& format : mesh_formats()) {
    const fs::path missing = fs::path(GEOMESH_BINARY_DIR) / "test-output" / "no-such-folder";
    fs::remove_all(missing);
    CHECK_THROWS(write_format(mesh, format, missing / "model"));
    CHECK(!fs::exists(missing));
  }
  CHECK_THROWS_AS(write_format(mesh, "doc", "model"), Error);
}

TEST_CASE("a file being written is removed by a handler of signals, one that is finished is not", "[writers]") {
  const fs::path folder = fresh_folder("being-written");
  const auto write = [](const fs::path& file, const char* text) { std::ofstream(file) << text; };
  write_complete_or_absent(folder / "whole.txt", [&](const fs::path& temporary) { write(temporary, "all"); });
  fs::path unfinished;
  const auto write_half = [&](const fs::path& temporary) {
    unfinished = temporary;
    write(temporary, "half");
    remove_files_being_written();
    CHECK_FALSE(fs::exists(unfinished));
    throw Error(ErrorKind::interrupted, "interrupted");
  };
  CHECK_THROWS_AS(write_complete_or_absent(folder / "half.txt", write_half), Error);
  write(unfinished, "of another file");
  remove_files_being_written();  // nothing of that name is watched any more
  CHECK(fs::exists(unfinished));
  CHECK(bytes_of(folder / "whole.txt") == "all");
}
