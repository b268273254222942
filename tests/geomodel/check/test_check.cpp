// SPDX-License-Identifier: GPL-3.0-or-later
// Every break of a sound mesh is caught by the name of its fault, and the sound mesh passes.
#include <algorithm>
#include <catch2/catch.hpp>
#include <limits>

#include "check_fixture.hpp"
#include "geomesh/core/error.hpp"
#include "geomesh/geomodel/check.hpp"

using namespace check_fixture;
using geomesh::Error;
using geomesh::ErrorKind;
using geomesh::geomodel::check_mesh;
using geomesh::geomodel::CheckFault;
using geomesh::geomodel::CheckRequest;
using geomesh::geomodel::CheckResult;

namespace {

std::vector<std::string> fault_names(const CheckResult& result) {
  std::vector<std::string> names;
  for (const CheckFault& fault : result.faults) names.push_back(fault.id);
  return names;
}

/// Checks the model's files, alone or against its project.
CheckResult check(const CheckModel& model, const std::string& name, bool with_project = false) {
  const auto folder = fresh_folder(name);
  CheckRequest request;
  request.contract = CheckRequest::Contract::passed_over;
  request.mesh = model.write(folder);
  if (with_project) request.project = write_project(folder);
  return check_mesh(request);
}

bool caught(const CheckResult& result, const std::string& id) {
  const auto names = fault_names(result);
  UNSCOPED_INFO(geomesh::geomodel::to_text(result));
  return std::find(names.begin(), names.end(), id) != names.end();
}

/// The first tetrahedron all of whose points are off the boundary.
std::size_t inner_tetrahedron(const CheckModel& model, std::int32_t region) {
  for (std::size_t i = 0; i < model.tetrahedra.size(); ++i) {
    const auto inner = [&](geomesh::VertexIndex v) {
      const Vec3& p = model.points[v];
      return std::min({p.x, p.y, p.z}) > 0 && std::max({p.x, p.y, p.z}) < cells * spacing;
    };
    if (model.region[i] == region && std::all_of(model.tetrahedra[i].begin(), model.tetrahedra[i].end(), inner))
      return i;
  }
  return 0;
}

std::size_t face_of(const CheckModel& model, std::int32_t surface) {
  for (std::size_t i = 0; i < model.faces.size(); ++i)
    if (model.faces[i].surface == surface) return i;
  return 0;
}

/// Adds a copy of all tetrahedra, its points mapped by scale and shift.
void add_copy(CheckModel& model, double scale, const Vec3& shift) {
  const auto n_points = static_cast<std::uint32_t>(model.points.size());
  const std::size_t n = model.tetrahedra.size();
  for (std::uint32_t v = 0; v < n_points; ++v) model.points.push_back(scale * model.points[v] + shift);
  for (std::size_t i = 0; i < n; ++i) {
    Tetrahedron t = model.tetrahedra[i];
    for (auto& v : t) v += n_points;
    model.tetrahedra.push_back(t);
    model.region.push_back(model.region[i]);
  }
}

}  // namespace

TEST_CASE("check: a sound mesh passes, with its exact volumes", "[check]") {
  const CheckResult result = check(sound_model(), "sound", true);
  INFO(geomesh::geomodel::to_text(result));
  CHECK(fault_names(result).empty());
  CHECK(result.volume == 27.0);
  REQUIRE(result.regions.size() == 3);
  CHECK(result.regions[0].name == "lower");
  CHECK(result.regions[0].volume == 13.0);
  CHECK(result.regions[1].volume == 13.0);
  CHECK(result.regions[2].name == "salt");
  CHECK(result.regions[2].volume == 1.0);
  const std::string json = geomesh::geomodel::to_json(result);
  CHECK(json.find("\"passes\": true") != std::string::npos);
  CHECK(geomesh::geomodel::to_text(result).find("The mesh passes.") != std::string::npos);
}

TEST_CASE("check: a mesh of another tool needs no regions and no face set", "[check]") {
  CheckModel model = sound_model();
  model.faces.clear();
  model.region.clear();
  model.region_names.clear();
  CHECK(fault_names(check(model, "plain")).empty());
}

TEST_CASE("check: Gmsh and Abaqus files of the mesh pass with the same regions", "[check]") {
  const CheckModel model = sound_model();
  const auto folder = fresh_folder("text_formats");
  for (const auto& file : {model.write_msh(folder), model.write_inp(folder)}) {
    CheckRequest request;
    request.contract = CheckRequest::Contract::passed_over;
    request.mesh = file;
    const CheckResult result = check_mesh(request);
    INFO(file.string() + "\n" + geomesh::geomodel::to_text(result));
    CHECK(fault_names(result).empty());
    REQUIRE(result.regions.size() == 3);
    CHECK(result.regions[2].name == "salt");
    CHECK(result.regions[2].volume == 1.0);
  }
}

TEST_CASE("check: faults of cells and points are named", "[check]") {
  CheckModel model = sound_model();
  SECTION("inverted by the order of its points") {
    std::swap(model.tetrahedra[100][0], model.tetrahedra[100][1]);
    const CheckResult result = check(model, "inverted_order");
    CHECK(fault_names(result) == std::vector<std::string>{"inverted_tetrahedra"});
    CHECK(result.faults.front().examples == std::vector<std::size_t>{100});
  }
  SECTION("inverted by a point pulled through a face") {
    const Tetrahedron t = model.tetrahedra[inner_tetrahedron(model, 1)];
    model.points[t[0]] = model.points[t[0]] + 2.5 * (model.points[t[1]] - model.points[t[0]]);
    const CheckResult result = check(model, "inverted_place");
    CHECK(caught(result, "inverted_tetrahedra"));
    CHECK(caught(result, "faces_shared_from_one_side"));
  }
  SECTION("flat") {
    model.tetrahedra.push_back({grid_point(0, 0, 0), grid_point(1, 0, 0), grid_point(0, 1, 0), grid_point(1, 1, 0)});
    model.region.push_back(1);
    CHECK(caught(check(model, "flat"), "flat_tetrahedra"));
  }
  SECTION("nearly flat, and positive all the same") {
    CheckModel sliver;
    sliver.points = {{0, 0, 0}, {1e7, 0, 0}, {0, 1e7, 0}, {1e7 + 3, 1e7 - 7, 1e-300}};
    sliver.tetrahedra = {{0, 1, 2, 3}};
    CHECK(fault_names(check(sliver, "sliver")).empty());
    sliver.points[3].z = -1e-300;
    CHECK(fault_names(check(sliver, "sliver_below")) == std::vector<std::string>{"inverted_tetrahedra"});
  }
  SECTION("two points in one place") {
    model.points.push_back(model.points[model.tetrahedra[7][2]]);
    model.tetrahedra[7][2] = static_cast<std::uint32_t>(model.points.size() - 1);
    CHECK(caught(check(model, "equal_points"), "equal_points"));
  }
  SECTION("a point that nothing uses") {
    model.points.push_back({0.1, 0.2, 0.3});
    CHECK(fault_names(check(model, "unused")) == std::vector<std::string>{"unused_points"});
  }
  SECTION("a coordinate that is no number") {
    model.points[5].y = std::numeric_limits<double>::quiet_NaN();
    model.faces.clear();
    CHECK(caught(check(model, "nan"), "not_finite"));
  }
}

TEST_CASE("check: faults of conformity and overlap are named", "[check]") {
  CheckModel model = sound_model();
  model.faces.clear();
  SECTION("a hanging face") {
    // On a straight grid the edge's middle is exact; elsewhere its rounding makes the same break a crossing.
    const bool exact = GENERATE(true, false);
    if (exact) model = sound_model(0);
    model.faces.clear();
    const std::size_t i = inner_tetrahedron(model, 1);
    const Tetrahedron t = model.tetrahedra[i];
    const auto middle = static_cast<std::uint32_t>(model.points.size());
    model.points.push_back(0.5 * (model.points[t[0]] + model.points[t[1]]));
    model.tetrahedra[i][1] = middle;
    model.tetrahedra.push_back({middle, t[1], t[2], t[3]});
    model.region.push_back(model.region[i]);
    CHECK(caught(check(model, "hanging"), exact ? "hanging_faces" : "boundary_crossings"));
  }
  SECTION("one tetrahedron twice") {
    model.tetrahedra.push_back(model.tetrahedra[42]);
    model.region.push_back(model.region[42]);
    CHECK(caught(check(model, "twice"), "faces_shared_by_many"));
  }
  SECTION("two meshes through each other") {
    add_copy(model, 1, {1.03, 0.97, 1.01});
    CHECK(caught(check(model, "through"), "boundary_crossings"));
  }
  SECTION("a mesh inside another, boundaries apart") {
    add_copy(model, 0.5, {0.71, 0.73, 0.77});
    CHECK(fault_names(check(model, "inside")) == std::vector<std::string>{"overlapping_tetrahedra"});
  }
  SECTION("a mesh beside another is no fault") {
    add_copy(model, 1, {3.5, 0, 0});
    CHECK(fault_names(check(model, "beside")).empty());
  }
  SECTION("a mesh that touches another with the same points, not shared") {
    add_copy(model, 1, {3, 0, 0});
    const CheckResult result = check(model, "touching");
    CHECK(caught(result, "equal_points"));
    CHECK(caught(result, "hanging_faces"));
  }
  SECTION("a cavity is closed and no fault of the mesh alone") {
    const std::size_t i = inner_tetrahedron(model, 1);
    model.tetrahedra.erase(model.tetrahedra.begin() + static_cast<std::ptrdiff_t>(i));
    model.region.erase(model.region.begin() + static_cast<std::ptrdiff_t>(i));
    CHECK(fault_names(check(model, "cavity")).empty());
  }
}

TEST_CASE("check: faults of regions and face sets are named", "[check]") {
  CheckModel model = sound_model();
  SECTION("a hole") {
    const std::size_t i = inner_tetrahedron(model, 1);
    model.tetrahedra.erase(model.tetrahedra.begin() + static_cast<std::ptrdiff_t>(i));
    model.region.erase(model.region.begin() + static_cast<std::ptrdiff_t>(i));
    const CheckResult result = check(model, "hole", true);
    CHECK(caught(result, "box_volume"));
    CHECK(caught(result, "unlisted_region_faces"));
  }
  SECTION("a tetrahedron with the wrong region") {
    model.region[inner_tetrahedron(model, 1)] = 2;
    CHECK(caught(check(model, "wrong_region"), "unlisted_region_faces"));
  }
  SECTION("a region without a name") {
    model.region_names.erase(2);
    CHECK(fault_names(check(model, "unnamed")) == std::vector<std::string>{"unnamed_regions"});
  }
  SECTION("a name without a region") {
    model.region_names[9] = "nowhere";
    CHECK(fault_names(check(model, "empty_region")) == std::vector<std::string>{"empty_regions"});
  }
  SECTION("a wrong region on a face") {
    model.faces[face_of(model, 4)].region_plus = 3;
    const CheckResult result = check(model, "wrong_side");
    CHECK(caught(result, "wrong_face_regions"));
    CHECK(caught(result, "open_regions"));
  }
  SECTION("a boundary face turned inwards") {
    Face& face = model.faces[face_of(model, 7)];
    std::swap(face.vertices[0], face.vertices[1]);
    CHECK(caught(check(model, "turned"), "boundary_faces_turned"));
  }
  SECTION("a face twice") {
    model.faces.push_back(model.faces[face_of(model, 5)]);
    CHECK(fault_names(check(model, "repeated")) == std::vector<std::string>{"repeated_faces"});
  }
  SECTION("a triangle that is no face") {
    model.faces[face_of(model, 5)].vertices = {grid_point(0, 0, 0), grid_point(3, 0, 3), grid_point(0, 4, 0)};
    CHECK(caught(check(model, "no_face"), "faces_not_in_mesh"));
  }
  SECTION("a surface without a name") {
    model.faces[face_of(model, 5)].surface = 77;
    CHECK(caught(check(model, "unnamed_surface"), "unnamed_surfaces"));
  }
  SECTION("input points after added ones") {
    model.input_vertex_of_point_3 = -1;
    CHECK(fault_names(check(model, "not_first")) == std::vector<std::string>{"input_points_not_first"});
  }
  SECTION("ids shared between regions and surfaces") {
    model.surface_names[2] = "fault";
    for (Face& face : model.faces)
      if (face.surface == 5) face.surface = 2;
    CHECK(caught(check(model, "shared_ids"), "shared_ids"));
  }
}

TEST_CASE("check: input triangles must be covered", "[check]") {
  CheckModel model = sound_model();
  SECTION("a piece of a fault is missing, where nothing else tells") {
    model.faces.erase(model.faces.begin() + static_cast<std::ptrdiff_t>(face_of(model, 5)));
    CHECK(fault_names(check(model, "missing_fault_piece")).empty());
    CHECK(fault_names(check(model, "missing_fault_piece_project", true)) ==
          std::vector<std::string>{"uncovered_triangles"});
  }
  SECTION("a piece of the horizon is missing") {
    model.faces.erase(model.faces.begin() + static_cast<std::ptrdiff_t>(face_of(model, 4)));
    CHECK(caught(check(model, "missing_horizon_piece", true), "uncovered_triangles"));
  }
  SECTION("a piece of the horizon inside the salt") {
    // The square of the middle level about the body's axis: mesh faces, inside the body.
    const auto a = grid_point(2, 2, 3), b = grid_point(3, 2, 3), c = grid_point(3, 3, 3);
    model.faces.push_back({{a, b, c}, 4, 0, 1, 3, 3, 0});
    CHECK(caught(check(model, "inside_salt", true), "faces_inside_bodies"));
  }
  SECTION("faces that name the wrong triangle") {
    model.faces[face_of(model, 4)].source_triangle ^= 1;
    CHECK(fault_names(check(model, "wrong_source", true)) == std::vector<std::string>{"faces_off_their_triangle"});
    model.faces[face_of(model, 4)].source_triangle = 12;
    CHECK(caught(check(model, "no_source", true), "wrong_source_triangles"));
  }
  SECTION("a surface moved by a thousandth") {
    const auto folder = fresh_folder("moved");
    CheckRequest request;
    request.contract = CheckRequest::Contract::passed_over;
    request.mesh = model.write(folder);
    request.project = write_project(folder);
    write_ts(folder / "fault.ts", "fault", {{1.501, 0, 1.5}, {1.501, 1.5, 1.5}, {1.501, 1.5, 3}, {1.501, 0, 3}},
             {{0, 1, 2}, {0, 2, 3}});
    const CheckResult result = check_mesh(request);
    CHECK(caught(result, "uncovered_triangles"));
    CHECK(caught(result, "faces_off_their_triangle"));
    request.tolerance = 0.0011;
    CHECK(fault_names(check_mesh(request)).empty());
  }
  SECTION("surfaces without a face set are found by place") {
    model.faces.clear();
    const auto folder = fresh_folder("by_place");
    write_project(folder);
    CheckRequest request;
    request.contract = CheckRequest::Contract::passed_over;
    request.mesh = model.write(folder);
    request.surfaces = {folder / "fault.ts", folder / "salt.ts"};
    CHECK(fault_names(check_mesh(request)).empty());
    write_ts(folder / "off.ts", "off", {{1.51, 0, 1.5}, {1.51, 1.5, 1.5}, {1.51, 1.5, 3}}, {{0, 1, 2}});
    request.surfaces.push_back(folder / "off.ts");
    CHECK(fault_names(check_mesh(request)) == std::vector<std::string>{"uncovered_triangles"});
  }
}

TEST_CASE("check: Delaunay is decided exactly, ties allowed", "[check]") {
  CheckRequest request;
  request.contract = CheckRequest::Contract::passed_over;
  request.delaunay = true;
  SECTION("a grid of cospherical cells is Delaunay") {
    request.mesh = sound_model(0).write(fresh_folder("grid"));
    CHECK(fault_names(check_mesh(request)).empty());
  }
  SECTION("a point moved by an ulp into the spheres of its neighbours") {
    CheckModel model = sound_model(0);
    model.points[grid_point(1, 1, 1)].x = std::nextafter(0.5, 1.0);
    request.mesh = model.write(fresh_folder("grid_ulp"));
    CHECK(caught(check_mesh(request), "not_delaunay"));
  }
  SECTION("two tetrahedra where three would be") {
    CheckModel model;
    model.points = {{1, 0, 0}, {-0.5, 0.8, 0}, {-0.5, -0.8, 0}, {0, 0, 0.3}, {0, 0, -0.3}};
    model.tetrahedra = {{0, 1, 2, 3}, {0, 2, 1, 4}};
    request.mesh = model.write(fresh_folder("two"));
    CHECK(fault_names(check_mesh(request)) == std::vector<std::string>{"not_delaunay"});
    model.tetrahedra = {{0, 1, 4, 3}, {1, 2, 4, 3}, {2, 0, 4, 3}};
    request.mesh = model.write(fresh_folder("three"));
    CHECK(fault_names(check_mesh(request)).empty());
  }
}

TEST_CASE("check: files that cannot be understood are refused", "[check]") {
  const auto folder = fresh_folder("refused");
  CheckRequest request;
  request.contract = CheckRequest::Contract::passed_over;
  const auto kind_of = [&] {
    try {
      check_mesh(request);
    } catch (const Error& error) {
      INFO(error.what());
      return static_cast<int>(error.kind());
    }
    return 0;
  };
  request.mesh = folder / "absent.vtu";
  CHECK(kind_of() == static_cast<int>(ErrorKind::usage));
  CheckModel model = sound_model();
  model.tetrahedra[3][1] = 100000;
  request.mesh = model.write(folder, "out_of_range");
  CHECK(kind_of() == static_cast<int>(ErrorKind::invalid_input));
  request.mesh = sound_model().write(folder, "truncated");
  std::filesystem::resize_file(request.mesh, std::filesystem::file_size(request.mesh) / 2);
  CHECK(kind_of() == static_cast<int>(ErrorKind::invalid_input));
  std::ofstream(folder / "noise.vtu") << "\x01\x02 no mesh";
  request.mesh = folder / "noise.vtu";
  CHECK(kind_of() == static_cast<int>(ErrorKind::invalid_input));
  std::ofstream(folder / "noise.msh") << "$Elements\n1\n";
  request.mesh = folder / "noise.msh";
  CHECK(kind_of() == static_cast<int>(ErrorKind::invalid_input));
  std::ofstream(folder / "empty.inp") << "*HEADING\n";
  request.mesh = folder / "empty.inp";
  CHECK(fault_names(check_mesh(request)) == std::vector<std::string>{"no_tetrahedra"});
}

TEST_CASE("check: no random break passes against the project", "[check]") {
  const CheckModel sound = sound_model();
  const auto folder = fresh_folder("random");
  CheckRequest request;
  request.contract = CheckRequest::Contract::passed_over;
  request.project = write_project(folder);
  std::uint32_t seed = 2024;
  const auto random = [&](std::size_t n) {
    seed = seed * 1664525u + 1013904223u;
    return static_cast<std::size_t>((std::uint64_t(seed) * n) >> 32);
  };
  for (int round = 0; round < 60; ++round) {
    CheckModel model = sound;
    const std::size_t t = random(model.tetrahedra.size()), f = random(model.faces.size());
    std::string kind;
    switch (round % 10) {
      case 0:
        kind = "two points of a cell exchanged";
        std::swap(model.tetrahedra[t][random(4)], model.tetrahedra[t][3]);
        if (model.tetrahedra[t] == sound.tetrahedra[t]) std::swap(model.tetrahedra[t][0], model.tetrahedra[t][1]);
        break;
      case 1:
        kind = "a cell lost";
        model.tetrahedra.erase(model.tetrahedra.begin() + static_cast<std::ptrdiff_t>(t));
        model.region.erase(model.region.begin() + static_cast<std::ptrdiff_t>(t));
        break;
      case 2:
        kind = "a cell twice";
        model.tetrahedra.push_back(model.tetrahedra[t]);
        model.region.push_back(model.region[t]);
        break;
      case 3:
        kind = "a point moved by a cell's size";
        model.points[random(model.points.size())].z += 0.7;
        break;
      case 4:
        kind = "a point of a surface moved by a ten-thousandth";
        model.points[model.faces[f].vertices[random(3)]] =
            model.points[model.faces[f].vertices[0]] + Vec3{1e-4, 1.1e-4, 0.9e-4};
        break;
      case 5:
        kind = "a region changed";
        model.region[t] = model.region[t] % 3 + 1;
        break;
      case 6:
        kind = "a face turned";
        std::swap(model.faces[f].vertices[1], model.faces[f].vertices[2]);
        if (model.faces[f].region_minus == model.faces[f].region_plus) continue;
        break;
      case 7:
        kind = "a face lost";
        model.faces.erase(model.faces.begin() + static_cast<std::ptrdiff_t>(f));
        break;
      case 8:
        kind = "a face of another surface";
        model.faces[f].surface = model.faces[f].surface == 4 ? 5 : 4;
        model.faces[f].surface_set = model.faces[f].surface - 4;
        break;
      default:
        kind = "a cell with a point of another";
        model.tetrahedra[t][random(4)] = model.tetrahedra[(t + 500) % model.tetrahedra.size()][0];
    }
    request.mesh = model.write(folder);
    INFO("round " << round << ": " << kind << " (cell " << t << ", face " << f << ")");
    CHECK_FALSE(check_mesh(request).faults.empty());
  }
}
