// SPDX-License-Identifier: GPL-3.0-or-later
// Doubts about inputs: what is doubted, how sure it is, and what is not doubted.
#include <catch2/catch.hpp>
#include <cmath>

#include "geomesh/core/error.hpp"
#include "plausibility/plausibility.hpp"

using namespace geomesh;
using namespace geomesh::geomodel;

namespace {

using Sureness = Finding::Sureness;

TriangulatedSurface sheet(const std::string& name, SurfaceKind kind, const Box3& b) {
  TriangulatedSurface s;
  s.name = name;
  s.kind = kind;
  s.points = {{b.min.x, b.min.y, b.min.z},
              {b.max.x, b.min.y, b.min.z},
              {b.max.x, b.max.y, b.max.z},
              {b.min.x, b.max.y, b.max.z}};
  s.triangles = {{0, 1, 2}, {0, 2, 3}};
  return s;
}

/// An open or closed box as a body.
TriangulatedSurface body(const Box3& b, bool closed) {
  TriangulatedSurface s;
  s.name = "salt";
  s.kind = SurfaceKind::body;
  for (int i = 0; i < 8; ++i)
    s.points.push_back({i & 1 ? b.max.x : b.min.x, i & 2 ? b.max.y : b.min.y, i & 4 ? b.max.z : b.min.z});
  s.triangles = {{0, 2, 3}, {0, 3, 1}, {0, 1, 5}, {0, 5, 4}, {2, 6, 7},
                 {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  if (closed) {
    s.triangles.push_back({4, 5, 7});
    s.triangles.push_back({4, 7, 6});
  }
  return s;
}

const Box3 box{{430000, 5800000, -3000}, {440000, 5810000, 0}};

struct Model {
  Project project;
  std::vector<TriangulatedSurface> surfaces;

  explicit Model(std::vector<TriangulatedSurface> given) : surfaces(std::move(given)) {
    project.crs.horizontal = "local";
    project.box = VolumeSpec{};
    project.box->box = box;
    for (const TriangulatedSurface& s : surfaces) {
      SurfaceSpec spec;
      spec.name = s.name;
      spec.kind = s.kind;
      project.surfaces.push_back(spec);
      project.rules.surfaces.emplace_back();
    }
  }

  std::vector<Finding> doubts() const {
    ProjectInputs inputs{ModelFrame(project, {})};
    inputs.surfaces = surfaces;
    inputs.volume = project.box;
    return find_doubts(project, inputs, box);
  }
};

Box3 moved(Box3 b, double (*x)(const Vec3&), double (*y)(const Vec3&), double (*z)(const Vec3&)) {
  return {{x(b.min), y(b.min), z(b.min)}, {x(b.max), y(b.max), z(b.max)}};
}

const Box3 inside{{430500, 5800500, -1200}, {439500, 5809500, -1000}};

}  // namespace

TEST_CASE("a box far longer than all horizons is refused, unless one of them says how it goes on", "[plausibility]") {
  const auto doubts_over = [](double length, Extend extend, SurfaceKind kind) {
    Model model({sheet("top", kind, {{430000, 5800500, -1200}, {430000 + length, 5809500, -1000}})});
    model.project.rules.surfaces[0].extend = extend;
    return model.doubts();
  };
  const std::vector<Finding> found = doubts_over(190, Extend::none, SurfaceKind::horizon);
  REQUIRE(found.size() == 1);
  CHECK(found[0].sureness == Sureness::certain);
  CHECK_THAT(found[0].text, Catch::Contains("top reaches over 190 m of the box's 1e+04 m in x"));
  CHECK_THAT(found[0].remedy, Catch::Contains("digit too many"));
  CHECK(doubts_over(210, Extend::none, SurfaceKind::horizon).empty());
  CHECK(doubts_over(190, Extend::flat, SurfaceKind::horizon).empty());
  CHECK(doubts_over(190, Extend::none, SurfaceKind::fault).empty());

  Model ends({sheet("top", SurfaceKind::horizon, {{430000, 5800500, -1200}, {430190, 5809500, -1000}})});
  ends.project.rules.surfaces[0].continues = false;  // extend: none in its entry
  CHECK(ends.doubts().empty());
}

TEST_CASE("in a box laid about the data one horizon far longer than all others is refused", "[plausibility]") {
  const auto doubts_of = [](std::size_t n_others, double length, Extend extend) {
    std::vector<TriangulatedSurface> horizons{sheet("long", SurfaceKind::horizon, inside)};
    for (std::size_t k = 0; k < n_others; ++k) {
      const double z = -1300 - 100.0 * static_cast<double>(k);
      horizons.push_back(sheet("h" + std::to_string(k), SurfaceKind::horizon,
                               {{431000, 5801000, z - 20}, {431000 + length, 5809000, z}}));
    }
    Model model(horizons);
    model.project.box->shape = VolumeSpec::Shape::margin;
    model.project.rules.surfaces[0].extend = extend;
    std::vector<Finding> doubts = model.doubts();
    std::erase_if(doubts, [](const Finding& f) { return f.cause != "extent of the box"; });
    return doubts;
  };
  const std::vector<Finding> found = doubts_of(2, 170, Extend::none);
  REQUIRE(found.size() == 1);
  CHECK(found[0].sureness == Sureness::certain);
  CHECK(found[0].inputs == std::vector<std::string>{"long"});
  CHECK_THAT(found[0].text, Catch::Contains("long reaches over 9000 m in x, the other 2 horizons together over 170 m"));
  CHECK(doubts_of(2, 190, Extend::none).empty());
  CHECK(doubts_of(2, 170, Extend::flat).empty());
  CHECK(doubts_of(1, 170, Extend::none).empty());  // of two, nobody knows which is wrong
}

TEST_CASE("a surface that lies elsewhere is told what would bring it in", "[plausibility]") {
  struct Case {
    Box3 bounds;
    std::string cause, words;
  };
  const auto x = [](const Vec3& p) { return p.x; };
  const auto y = [](const Vec3& p) { return p.y; };
  const auto z = [](const Vec3& p) { return p.z; };
  const std::vector<Case> cases{
      {moved(inside, y, x, z), "exchanged axes", "columns: {x: 2, y: 1, z: 3}"},
      {moved(
           inside, [](const Vec3& p) { return p.x / 0.3048; }, [](const Vec3& p) { return p.y / 0.3048; }, z),
       "unit", "feet where metres"},
      {moved(
           inside, [](const Vec3& p) { return p.x / 1000; }, [](const Vec3& p) { return p.y / 1000; }, z),
       "unit", "kilometres where metres"},
      {moved(
           inside, [](const Vec3& p) { return p.x + 32e6; }, y, z),
       "zone in front", "32 million"},
      {moved(inside, x, y, [](const Vec3& p) { return -p.z; }), "direction of z", "z: depth"},
      {moved(inside, x, y, [](const Vec3& p) { return p.z / 0.3048; }), "unit of z", "z were in feet"},
      {{{8, 52, -100}, {8.1, 52.1, -100}}, "degrees", "crs: geographic"},
      {{{1e8, 9e8, -5}, {1.1e8, 9.1e8, -4}}, "place", "same system and unit"},
  };
  for (const Case& c : cases) {
    INFO(c.words);
    const Model model({sheet("good", SurfaceKind::horizon, inside), sheet("a", SurfaceKind::horizon, c.bounds),
                       sheet("b", SurfaceKind::horizon, moved(c.bounds, x, y, z))});
    std::vector<Finding> doubts = model.doubts();
    std::erase_if(doubts, [](const Finding& f) { return f.cause == "duplicate"; });
    REQUIRE(doubts.size() == 1);  // one cause, one finding
    CHECK(doubts[0].cause == c.cause);
    CHECK(doubts[0].sureness == Sureness::probable);
    CHECK(doubts[0].inputs == std::vector<std::string>{"a", "b"});
    CHECK(to_text(doubts[0]).find(c.words) != std::string::npos);
  }
  CHECK(Model({sheet("good", SurfaceKind::horizon, inside)}).doubts().empty());
}

TEST_CASE("nothing of the column in the box is nonsense, and so is a box in kilometres", "[plausibility]") {
  Box3 deep = inside;
  deep.min.z = -9000, deep.max.z = -8000;
  Model model({sheet("top", SurfaceKind::horizon, deep), sheet("f", SurfaceKind::fault, inside)});
  CHECK(model.doubts().at(0).sureness == Sureness::probable);
  model.project.column = {"young", "top", "old"};
  CHECK(model.doubts().at(0).sureness == Sureness::certain);
  CHECK_THROWS_AS(refuse_nonsense(model.doubts()), Error);
  Box3 large = inside;
  large.min = 1000 * large.min, large.max = 1000 * large.max;
  const std::vector<Finding> doubts = Model({sheet("top", SurfaceKind::horizon, large)}).doubts();
  CHECK(doubts.at(0).cause == "unit of the box");
  CHECK(doubts.at(0).sureness == Sureness::certain);
}

TEST_CASE("kinds that do not fit the shape are doubted, and usual ones are not", "[plausibility]") {
  const Box3 upright{{431000, 5801000, -2900}, {431000, 5809000, -100}};
  TriangulatedSurface wall = sheet("wall", SurfaceKind::horizon, upright);
  wall.points = {{431000, 5801000, -2900}, {431200, 5809000, -2900}, {431300, 5809000, -100}, {431100, 5801000, -100}};
  CHECK(Model({wall}).doubts().at(0).cause == "upright horizon");
  wall.kind = SurfaceKind::fault;
  CHECK(Model({wall}).doubts().empty());
  Box3 level = box;
  level.min.z = -1000.0, level.max.z = -990.0;
  CHECK(Model({sheet("f", SurfaceKind::fault, level)}).doubts().at(0).cause == "level fault");
  CHECK(Model({sheet("h", SurfaceKind::horizon, level)}).doubts().empty());
  const Model twins({sheet("a", SurfaceKind::horizon, inside), sheet("b", SurfaceKind::horizon, inside)});
  CHECK(twins.doubts().at(0).cause == "duplicate");
}

TEST_CASE("a body that is open inside the model is doubted, and an empty one is nonsense", "[plausibility]") {
  const Box3 within{{433000, 5803000, -2000}, {435000, 5805000, -1000}};
  CHECK(Model({body(within, true)}).doubts().empty());
  const std::vector<Finding> open = Model({body(within, false)}).doubts();
  REQUIRE(open.size() == 1);
  CHECK(open[0].cause == "open body");
  CHECK(open[0].sureness == Sureness::probable);
  CHECK(open[0].text.find("1000 m before") != std::string::npos);
  Box3 through = within;
  through.max.z = 100;  // it leaves the box above
  CHECK(Model({body(through, false)}).doubts().empty());
  Model lid({body(within, false)});
  lid.project.rules.surfaces[0].fill_holes = 1e9;
  CHECK(lid.doubts().empty());
  Box3 flat = within;
  flat.max.z = flat.min.z;
  CHECK(Model({body(flat, true)}).doubts().at(0).cause == "empty body");
}

TEST_CASE("a horizon in no column is told where it belongs, and one that crosses others is not doubted",
          "[plausibility]") {
  Box3 above = inside, below = inside, between = inside, crossing = inside;
  below.min.z -= 1000, below.max.z -= 1000;
  between.min.z -= 500, between.max.z -= 500;
  crossing.min.z = -2500, crossing.max.z = -500;
  Model model({sheet("top", SurfaceKind::horizon, above), sheet("base", SurfaceKind::horizon, below),
               sheet("middle", SurfaceKind::horizon, between), sheet("isotherm", SurfaceKind::horizon, crossing)});
  model.project.column = {"a", "top", "b", "base", "c"};
  const std::vector<Finding> doubts = model.doubts();
  REQUIRE(doubts.size() == 1);
  CHECK(doubts[0].inputs == std::vector<std::string>{"middle"});
  CHECK(doubts[0].remedy.find("middle between top and base") != std::string::npos);
  model.project.column.clear();
  CHECK(model.doubts().empty());
}

TEST_CASE("a horizon against the order of the column is told the unit that would bring it in order", "[plausibility]") {
  const auto at = [](double z) { return Box3{{430500, 5800500, z - 100}, {439500, 5809500, z}}; };
  const auto doubts_of = [&](const std::vector<double>& heights, const std::string& unit) {
    Model model({sheet("top", SurfaceKind::horizon, at(heights[0])),
                 sheet("middle", SurfaceKind::horizon, at(heights[1])),
                 sheet("base", SurfaceKind::horizon, at(heights[2]))});
    model.project.column = {"a", "top", "b", "middle", "c", "base", "d"};
    model.project.crs.unit = unit;
    return model.doubts();
  };
  const std::vector<Finding> feet = doubts_of({-400, -800 / 0.3048, -1200}, "m");
  REQUIRE(feet.size() == 1);
  CHECK(feet[0].inputs == std::vector<std::string>{"middle"});
  CHECK(to_text(feet[0]).find("in feet where metres were understood; if so, give 'z_unit: ft'") != std::string::npos);
  const std::vector<Finding> metres = doubts_of({-1500, -700, -2800}, "ft");
  REQUIRE(metres.size() == 1);
  CHECK(metres[0].inputs == std::vector<std::string>{"middle"});
  CHECK(metres[0].remedy == "if so, give 'z_unit: m' in its entry");
  CHECK(doubts_of({-400, -800, -1200}, "m").empty());
  CHECK(doubts_of({-1200, -800, -400}, "m").empty());  // the column upside down
}
