// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes whose surfaces may lie off the input by a tolerance: what is within passes, each kind of break is caught by
// its name.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>
#include <random>

#include "check/exact/deviation.hpp"
#include "check/exact/vertical_line.hpp"
#include "check/within/input_border.hpp"
#include "check_fixture.hpp"
#include "geomesh/geomodel/check.hpp"

using namespace check_fixture;
using geomesh::Index;
using geomesh::geomodel::check_mesh;
using geomesh::geomodel::CheckRequest;
using geomesh::geomodel::CheckResult;
using geomesh::geomodel::checking::Corners;
using geomesh::geomodel::checking::Deviation;
using geomesh::geomodel::checking::DeviationChecker;
using geomesh::geomodel::checking::TriangleSet;

namespace {

constexpr double within = 0.04;

/// Patches as the output contract has them: faces joined across edges where just two faces of the same surfaces meet.
void number_patches(CheckModel& model) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::size_t>> at;
  for (std::size_t f = 0; f < model.faces.size(); ++f)
    for (std::size_t i = 0; i < 3; ++i) {
      const auto a = model.faces[f].vertices[i], b = model.faces[f].vertices[(i + 1) % 3];
      at[std::minmax(a, b)].push_back(f);
    }
  for (Face& face : model.faces) face.patch = 0;
  std::int32_t n = 0;
  for (std::size_t f = 0; f < model.faces.size(); ++f) {
    if (model.faces[f].patch != 0) continue;
    std::vector<std::size_t> open{f};
    model.faces[f].patch = ++n;
    while (!open.empty()) {
      const std::size_t g = open.back();
      open.pop_back();
      for (std::size_t i = 0; i < 3; ++i) {
        const auto a = model.faces[g].vertices[i], b = model.faces[g].vertices[(i + 1) % 3];
        const auto& both = at[std::minmax(a, b)];
        if (both.size() != 2) continue;
        const std::size_t h = both[0] == g ? both[1] : both[0];
        if (model.faces[h].patch != 0 || model.faces[h].surface_set != model.faces[g].surface_set) continue;
        model.faces[h].patch = n;
        open.push_back(h);
      }
    }
  }
}

CheckModel numbered_model() {
  CheckModel model = sound_model(0);
  number_patches(model);
  return model;
}

struct Checked {
  CheckResult result;
  bool passes() const { return result.faults.empty(); }
  bool caught(const std::string& id) const {
    UNSCOPED_INFO(geomesh::geomodel::to_text(result));
    return std::any_of(result.faults.begin(), result.faults.end(), [&](const auto& f) { return f.id == id; });
  }
  bool says(const std::string& text) const {
    return geomesh::geomodel::to_text(result).find(text) != std::string::npos;
  }
};

/// Against the project; `report`: text of the report beside the mesh, empty: none.
Checked check(const CheckModel& model, const std::string& name, double allowed = within,
              const std::string& report = "") {
  const auto folder = fresh_folder("within_" + name);
  CheckRequest request;
  request.contract = CheckRequest::Contract::passed_over;
  request.mesh = model.write(folder);
  request.project = write_project(folder);
  request.within = allowed;
  if (!report.empty()) std::ofstream(folder / "model.report.json") << report;
  return {check_mesh(request)};
}

std::string report_of(double lower, double upper, double salt) {
  const auto region = [](const char* name, double volume) {
    return std::string("{\"name\": \"") + name + "\", \"volume_of_input\": " + std::to_string(volume) + "}";
  };
  return "{\"regions\": [" + region("lower", lower) + ", " + region("upper", upper) + ", " + region("salt", salt) +
         "]}";
}

}  // namespace

TEST_CASE("check within a tolerance: surfaces that moved by less pass, by more do not", "[check][within]") {
  CheckModel model = numbered_model();
  SECTION("nothing moved") {
    const Checked checked = check(model, "sound", within, report_of(13, 13, 1));
    INFO(geomesh::geomodel::to_text(checked.result));
    CHECK(checked.passes());
    CHECK(checked.says("proven within 0.04 for 100 % of the area"));
    CHECK(checked.says("1 closed bodies hold the volume"));
    CHECK(checked.says("region volumes are those of the input"));
  }
  SECTION("a point of a horizon off its plane") {
    Vec3& p = model.points[grid_point(1, 1, mid_level)];
    p.z = mid_level * spacing + 0.6 * within;
    CHECK(check(model, "near", within, report_of(13, 13, 1)).passes());
    CHECK_FALSE(check(model, "exact", 0).passes());
    p.z = mid_level * spacing + 2 * within;
    const Checked checked = check(model, "far");
    CHECK(checked.caught("faces_off_their_surface"));
    CHECK(checked.caught("input_off_the_mesh"));
    CHECK(checked.says("surfaces: mid"));
    CHECK(checked.says("the largest distance seen: 0.08"));
  }
  SECTION("a point of a body") {
    Vec3& p = model.points[grid_point(body_from, 3, 3)];
    p.x -= 2 * within;
    CHECK(check(model, "body").caught("faces_off_their_surface"));
    p.x += 1.4 * within;
    CHECK(check(model, "body_near").passes());
  }
  SECTION("a point of a fault's tip") {
    Vec3& p = model.points[grid_point(fault_column, fault_tip_row, 5)];
    p.y -= 2 * within;
    const Checked shorter = check(model, "tip_short");
    CHECK(shorter.caught("borders_off"));
    CHECK(shorter.caught("input_off_the_mesh"));
    p.y += 4 * within;
    CHECK(check(model, "tip_long").caught("faces_off_their_surface"));
    p.y -= 1.5 * within;
    CHECK(check(model, "tip_near").passes());
  }
  SECTION("a side of the box stays where it is") {
    model.points[grid_point(0, 1, 1)].x = 1e-6;
    CHECK(check(model, "box").caught("faces_off_box_side"));
  }
}

TEST_CASE("check within a tolerance: what is missing, swapped or renamed is caught", "[check][within]") {
  CheckModel model = numbered_model();
  const auto first_of = [&](std::int32_t surface) {
    return std::find_if(model.faces.begin(), model.faces.end(), [&](const Face& f) { return f.surface == surface; });
  };
  SECTION("a facet of a fault") {
    model.faces.erase(first_of(5));
    const Checked checked = check(model, "no_facet");
    CHECK(checked.caught("input_off_the_mesh"));
    CHECK(checked.caught("borders_off"));
  }
  SECTION("a whole fault that nothing clips") {
    // With the fault inside the box; the mesh knows nothing of it.
    std::erase_if(model.faces, [](const Face& f) { return f.surface == 5; });
    number_patches(model);
    const auto folder = fresh_folder("within_no_fault");
    CheckRequest request;
    request.contract = CheckRequest::Contract::passed_over;
    request.mesh = model.write(folder);
    request.project = write_project(folder);
    request.within = within;
    write_ts(folder / "fault.ts", "fault", {{2.5, 2.3, 2.2}, {2.6, 2.8, 2.2}, {2.5, 2.8, 2.8}}, {{0, 1, 2}});
    CHECK(Checked{check_mesh(request)}.caught("missing_surfaces"));
  }
  SECTION("regions swapped in cells and faces alike") {
    std::swap(model.region_names[1], model.region_names[3]);
    const Checked checked = check(model, "swapped", within, report_of(13, 13, 1));
    CHECK(checked.caught("region_volumes"));
    CHECK(checked.says("lower: 1, in the input 13"));
  }
  SECTION("a report that does not fill the box") {
    CHECK(check(model, "report", within, report_of(13, 13, 1.5)).caught("region_volumes"));
  }
  SECTION("a cell of the body given to what is about it") {
    for (std::size_t t = 0; t < model.tetrahedra.size(); ++t)
      if (model.region[t] == 3) {
        model.region[t] = 1;
        break;
      }
    model.faces.clear();
    add_faces(model);
    number_patches(model);
    CHECK(check(model, "cell").caught("faces_off_their_surface"));
  }
  SECTION("a face of the horizon deep in the body") {
    const auto a = grid_point(2, 2, 3), b = grid_point(3, 2, 3), c = grid_point(3, 3, 3);
    model.faces.push_back({{a, b, c}, 4, 0, 99, 3, 3, 0});
    CHECK(check(model, "deep").caught("faces_inside_bodies"));
  }
  SECTION("a curve where two surfaces cross") {
    // The input's horizon stands a little aslant in the salt: the curve runs elsewhere than the mesh's.
    const auto folder = fresh_folder("within_curve");
    CheckRequest request;
    request.contract = CheckRequest::Contract::passed_over;
    request.mesh = model.write(folder);
    request.project = write_project(folder);
    write_ts(folder / "mid.ts", "mid", {{-1, -1, 1.3}, {4, -1, 1.3}, {4, 4, 1.7}, {-1, 4, 1.7}},
             {{0, 1, 2}, {0, 2, 3}});
    request.within = 0.3;
    CHECK(Checked{check_mesh(request)}.passes());
    request.within = 0.015;  // the curves are 0.04 apart
    const Checked checked{check_mesh(request)};
    CHECK(checked.caught("curves_off"));
    CHECK(checked.caught("faces_off_their_surface"));
  }
}

TEST_CASE("check within a tolerance: a mesh alone against surfaces", "[check][within]") {
  CheckModel all = sound_model(0), model;
  std::map<std::uint32_t, std::uint32_t> rows;
  for (std::size_t t = 0; t < all.tetrahedra.size(); ++t) {
    if (all.region[t] != 3) continue;
    Tetrahedron cell{};
    for (std::size_t i = 0; i < 4; ++i) {
      const auto [it, is_new] = rows.try_emplace(all.tetrahedra[t][i], static_cast<std::uint32_t>(model.points.size()));
      if (is_new) model.points.push_back(all.points[it->first]);
      cell[i] = it->second;
    }
    model.tetrahedra.push_back(cell);
  }
  model.region_names.clear();
  const auto folder = fresh_folder("within_alone");
  write_project(folder);
  CheckRequest request;
  request.contract = CheckRequest::Contract::passed_over;
  request.surfaces = {folder / "salt.ts"};
  request.within = within;
  const std::uint32_t corner = rows[grid_point(body_from, body_from, body_from)];
  const auto check_with_corner_moved = [&](double by) {
    const Vec3 was = model.points[corner];
    model.points[corner].x += by;
    request.mesh = model.write(folder);
    model.points[corner] = was;
    return Checked{check_mesh(request)};
  };
  CHECK(check_with_corner_moved(0).passes());
  CHECK(check_with_corner_moved(0.7 * within).passes());
  CHECK(check_with_corner_moved(2 * within).caught("input_off_the_mesh"));
  CHECK(check_with_corner_moved(-2 * within).caught("faces_off_their_surface"));
}

TEST_CASE("check within a tolerance: what is called proven is so at many points", "[check][within]") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> u(0, 1);
  constexpr int n = 8;
  std::vector<Corners> hills;
  const auto at = [&](int i, int j) { return Vec3{double(i), double(j), 0.6 * std::sin(1.7 * i) * std::cos(1.3 * j)}; };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      hills.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      hills.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  const TriangleSet set(hills);
  std::size_t n_proven = 0, n_beyond = 0;
  for (int round = 0; round < 400; ++round) {
    Corners t;
    const double size = 0.1 + 2 * u(random), x = 1 + 4 * u(random), y = 1 + 4 * u(random);
    for (Vec3& p : t) {
      p = {x + size * u(random), y + size * u(random), 0};
      for (const Corners& h : hills) {  // onto the hills, and a little off
        const auto side = [](const Vec3& a, const Vec3& b, const Vec3& q) {
          return (b.x - a.x) * (q.y - a.y) - (b.y - a.y) * (q.x - a.x);
        };
        const double w0 = side(h[1], h[2], p), w1 = side(h[2], h[0], p), w2 = side(h[0], h[1], p);
        if (std::min({w0, w1, w2}) >= 0) p.z = (w0 * h[0].z + w1 * h[1].z + w2 * h[2].z) / (w0 + w1 + w2);
      }
      p.z += 0.02 * (u(random) - 0.5);
    }
    const double tolerance = 0.03 + 0.4 * u(random);
    double largest = 0;
    constexpr int grid = 40;
    for (int i = 0; i <= grid; ++i)
      for (int j = 0; i + j <= grid; ++j)
        largest =
            std::max(largest, set.distance(t[0] + double(i) / grid * (t[1] - t[0]) + double(j) / grid * (t[2] - t[0])));
    Deviation deviation;
    const auto witness = DeviationChecker(set, tolerance).check(t, deviation);
    if (witness) {
      CHECK(set.distance(*witness) > tolerance);
      ++n_beyond;
    } else if (deviation.proven >= deviation.area * (1 - 1e-9)) {
      CHECK(largest <= tolerance);
      ++n_proven;
    }
  }
  CHECK(n_proven > 50);
  CHECK(n_beyond > 40);
}

TEST_CASE("verticals find the triangles that they pass, and those that they pass near", "[check]") {
  geomesh::geomodel::TriangulatedSurface s;
  s.points = {{0, 0, 10}, {100, 0, 20}, {0, 100, 10}, {100, 100, 20}, {100, 100, 90}};
  s.triangles = {{0, 1, 2}, {2, 1, 3}, {1, 3, 4}};  // the last is upright
  const auto tree = geomesh::geomodel::checking::tree_over_triangles(s);
  const auto heights = [&](double x, double y) {
    std::vector<std::pair<Index, double>> found;
    geomesh::geomodel::checking::for_each_height(s, tree, {x, y, 0}, 0.5,
                                                 [&](Index t, double z) { found.emplace_back(t, z); });
    std::sort(found.begin(), found.end());
    return found;
  };
  using Found = std::vector<std::pair<Index, double>>;
  CHECK(heights(30, 30) == Found{{0, 13}});
  CHECK(heights(80, 70) == Found{{1, 18}});
  CHECK(heights(50, 50) == Found{{0, 15}, {1, 15}});
  CHECK(heights(20, -0.25) == Found{{0, 12}});
  CHECK(heights(20, -0.75).empty());
  CHECK(heights(100.25, 50) == Found{{1, 20}});
}

TEST_CASE("check within a tolerance: a patch that ends beside another one of its surface", "[check][within]") {
  // A wide patch in the plane x = 0, and a narrow one whose border is `gap` from the middle of the wide one.
  const double gap = GENERATE(0.0, 0.03, 0.3);
  geomesh::geomodel::TriangulatedSurface fault;
  fault.points = {{0, -2, 0}, {0, 2, 0}, {0, 2, 1}, {0, -2, 1}, {gap, 0, 0.2}, {gap, 0, 0.8}, {1, 0, 0.5}};
  fault.triangles = {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}};
  geomesh::geomodel::checking::Allowed allowed;
  allowed.surfaces = within;
  const geomesh::geomodel::checking::InputBorder border(fault, allowed);
  REQUIRE(border.edges().size() == 7);
  for (geomesh::Index e = 0; e < border.edges().size(); ++e) {
    const auto& [a, b, same] = border.edges()[e];
    const bool is_at_gap = a.x == gap && b.x == gap && std::abs(a.y) < 1;
    CHECK(border.faces_other_piece(e, 0.5 * (a + b)) == (is_at_gap && gap < within));
    CHECK_FALSE(border.faces_border(e, 0.5 * (a + b)));
  }
}

TEST_CASE("check within a tolerance: a crack faces itself farther from its tip than the tolerance", "[check][within]") {
  geomesh::geomodel::TriangulatedSurface sheet;  // two blocks that part along y, from (0, 0, 0) on
  sheet.points = {{-1, 0, 0}, {0, 0, 0}, {0, 2, 0}, {-1, 2, 0}, {1, 0, 0}, {1, 2, 0}, {0, 2, 1e-3}};
  sheet.triangles = {{0, 1, 2}, {0, 2, 3}, {1, 4, 5}, {1, 5, 6}};
  geomesh::geomodel::checking::Allowed allowed;
  allowed.surfaces = within;
  const geomesh::geomodel::checking::InputBorder border(sheet, allowed);
  std::size_t n_of_crack = 0;
  for (geomesh::Index e = 0; e < border.edges().size(); ++e) {
    const auto& [a, b, same] = border.edges()[e];
    if (a.x != 0 || b.x != 0) continue;
    ++n_of_crack;
    for (const double tolerances : {0.9, 1.1, 1.9, 2.1, 5.0})
      CHECK(border.faces_border(e, {0, tolerances * within, 0}) == (tolerances > 1));
  }
  CHECK(n_of_crack == 2);
}
