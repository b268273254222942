// SPDX-License-Identifier: GPL-3.0-or-later
// One degenerate situation each, small enough to know the answer.
#include <algorithm>
#include <catch2/catch.hpp>

#include "arrangement_inputs.hpp"
#include "geomesh/core/error.hpp"
#include "require_sound.hpp"

using namespace geomesh;
using namespace geomesh::geomodel;
using namespace geomesh::geomodel::testing;

namespace {

std::size_t n_with_origins(const PolygonSoup& soup, std::size_t n) {
  std::size_t count = 0;
  for (Index f = 0; f < soup.facets.size(); ++f) count += soup.origin_offsets[f + 1] - soup.origin_offsets[f] == n;
  return count;
}

bool has_point(const PolygonSoup& soup, const Vec3& p) {
  return std::find(soup.points.begin(), soup.points.end(), p) != soup.points.end();
}

bool any_contains(const std::vector<std::string>& texts, const std::string& part) {
  return std::any_of(texts.begin(), texts.end(),
                     [&](const std::string& t) { return t.find(part) != std::string::npos; });
}

const Spot* find_spot(const ArrangementResult& result, const std::string& what) {
  for (const Spot& s : result.spots)
    if (s.what == what) return &s;
  return nullptr;
}

TriangulatedSurface cube(const std::string& name, const Vec3& lo, const Vec3& hi, SurfaceKind kind) {
  TriangulatedSurface s;
  s.name = name;
  s.kind = kind;
  for (int k = 0; k < 8; ++k) s.points.push_back({k & 1 ? hi.x : lo.x, k & 2 ? hi.y : lo.y, k & 4 ? hi.z : lo.z});
  s.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                 {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return s;
}

}  // namespace

TEST_CASE("arrange: two triangles cross in a segment", "[arrangement]") {
  const auto a = triangles("a", {{Vec3{-2, -2, 0}, Vec3{2, -2, 0}, Vec3{0, 3, 0}}});
  const auto b = triangles("b", {{Vec3{0, 0, -1}, Vec3{0, 0, 1}, Vec3{0, 9, 0}}});
  const auto result = arrange({a, b}, {}, {}, {});
  require_sound(result.soup);
  CHECK(result.n_crossing_pairs == 1);
  CHECK(has_point(result.soup, {0, 0, 0}));
  CHECK(has_point(result.soup, {0, 3, 0}));
  const Spot* spot = find_spot(result, "crossing");
  REQUIRE(spot);
  CHECK(spot->count == 1);
  CHECK(spot->measure == Approx(3));
  CHECK(any_contains(result.warnings, "surface a crosses surface b"));
  for (std::size_t v = 0; v < result.soup.points.size(); ++v)
    CHECK((result.soup.kind[v] == SoupVertexKind::input) == (result.soup.input_point[v] != no_index));
}

TEST_CASE("arrange: refused crossings name the pair and the place", "[arrangement]") {
  const auto a = triangles("upper", {{Vec3{-2, -2, 0}, Vec3{2, -2, 0}, Vec3{0, 3, 0}}});
  const auto b = triangles("lower", {{Vec3{0, 0, -1}, Vec3{0, 0, 1}, Vec3{0, 9, 0}}});
  ArrangementOptions options;
  options.crossings = ArrangementOptions::Crossings::refuse;
  try {
    arrange({a, b}, {}, {}, options);
    FAIL("crossings were not refused");
  } catch (const Error& error) {
    CHECK(error.kind() == ErrorKind::invalid_input);
    CHECK(std::string(error.what()).find("upper") != std::string::npos);
    CHECK(std::string(error.what()).find("lower") != std::string::npos);
    REQUIRE(error.context().places.size() == 1);
    CHECK(error.context().places[0] == Vec3{0, 1.5, 0});
  }
  const auto apart = triangles("lower", {{Vec3{0, 0, 1}, Vec3{0, 1, 1}, Vec3{0, 9, 2}}});
  CHECK(arrange({a, apart}, {}, {}, options).soup.facets.size() == 2);
}

TEST_CASE("arrange: three planes meet in a triple point", "[arrangement]") {
  const auto flat = triangles("flat", {{Vec3{-3, -3, 0}, Vec3{3, -3, 0}, Vec3{0, 4, 0}}});
  const auto steep = triangles("steep", {{Vec3{0, -3, -3}, Vec3{0, 3, -3}, Vec3{0, 0, 4}}});
  const auto cross = triangles("cross", {{Vec3{-3, 0, -3}, Vec3{3, 0, -3}, Vec3{0, 0, 4}}});
  const auto result = arrange({flat, steep, cross}, {}, {}, {});
  require_sound(result.soup);
  const auto at = std::find(result.soup.points.begin(), result.soup.points.end(), Vec3{0, 0, 0});
  REQUIRE(at != result.soup.points.end());
  CHECK(result.soup.kind[static_cast<std::size_t>(at - result.soup.points.begin())] == SoupVertexKind::triple_point);
}

TEST_CASE("arrange: coplanar overlaps become facets with several origins", "[arrangement]") {
  const auto a = triangles("a", {{Vec3{0, 0, 0}, Vec3{4, 0, 0}, Vec3{0, 4, 0}}});
  const auto b = triangles("b", {{Vec3{0, 0, 0}, Vec3{0, 4, 0}, Vec3{4, 4, 0}}});  // turns the other way
  const auto result = arrange({a, b}, {}, {}, {});
  require_sound(result.soup);
  CHECK(n_with_origins(result.soup, 2) >= 1);
  CHECK(area_of(result.soup, 0) == Approx(8));
  CHECK(area_of(result.soup, 1) == Approx(8));
  for (Index f = 0; f < result.soup.facets.size(); ++f) {
    const Index begin = result.soup.origin_offsets[f];
    CHECK_FALSE(result.soup.origins[begin].reversed);
    if (result.soup.origin_offsets[f + 1] - begin == 2) CHECK(result.soup.origins[begin + 1].reversed);
  }
  const Spot* spot = find_spot(result, "overlap");
  REQUIRE(spot);
  CHECK(spot->measure == Approx(4));
  CHECK(any_contains(result.warnings, "coincide"));
}

TEST_CASE("arrange: what would take more memory than allowed is refused with the place", "[arrangement]") {
  std::mt19937 random(1);
  const auto unit = [&] { return static_cast<double>(random()) / 4294967296.0; };
  std::vector<std::array<Vec3, 3>> list(60);
  for (auto& t : list)
    for (Vec3& p : t) p = {unit(), unit(), unit()};
  const auto heap = triangles("heap", list);  // everything crosses everything
  ArrangementOptions options;
  const auto whole = arrange({heap}, {}, {}, options);
  CHECK(whole.memory_bound > 1e8);
  for (const std::size_t bytes :
       {std::size_t{10000}, whole.soup.facets.size() * 200}) {  // too little for the contacts; for the facets
    INFO(bytes);
    options.max_memory = bytes;
    try {
      arrange({heap}, {}, {}, options);
      FAIL("it was not refused");
    } catch (const Error& e) {
      CHECK(e.kind() == ErrorKind::cannot_mesh);
      REQUIRE(e.context().places.size() == 1);
      CHECK(std::find(heap.points.begin(), heap.points.end(), e.context().places[0]) != heap.points.end());
      CHECK(std::string(e.what()).find("of memory") != std::string::npos);
    }
  }
  options.max_memory = whole.soup.facets.size() * 1000;
  CHECK(arrange({heap}, {}, {}, options).soup.facets == whole.soup.facets);
}

TEST_CASE("arrange: repeated triangles, zero area, -0 and T-junctions", "[arrangement]") {
  const std::array<Vec3, 3> t{Vec3{0, 0, 0}, Vec3{2, 0, 0}, Vec3{0, 2, 0}};
  SECTION("repeated triangles merge") {
    const auto result = arrange({triangles("a", {t, t}), triangles("b", {t})}, {}, {}, {});
    require_sound(result.soup);
    REQUIRE(result.soup.facets.size() == 1);
    CHECK(result.soup.origins.size() == 3);
  }
  SECTION("zero-area triangles are left out with a warning") {
    const auto result = arrange(
        {triangles("thin", {t, {Vec3{0, 0, 0}, Vec3{1, 1, 1}, Vec3{2, 2, 2}}, {t[0], t[0], t[1]}})}, {}, {}, {});
    CHECK(result.soup.facets.size() == 1);
    CHECK(any_contains(result.warnings, "thin: 2 triangle(s) without area"));
  }
  SECTION("-0 is 0") {
    const auto result =
        arrange({triangles("a", {t, {Vec3{-0.0, -0.0, 0}, Vec3{0, 2, -0.0}, Vec3{-1, 0, 0}}})}, {}, {}, {});
    require_sound(result.soup);
    CHECK(result.soup.points.size() == 4);
    CHECK_FALSE(std::signbit(result.soup.points[0].x));
  }
  SECTION("a vertex on an edge splits it") {
    const auto result = arrange({triangles("a", {t, {Vec3{1, 0, 0}, Vec3{2, -2, 0}, Vec3{0, -2, 1}}})}, {}, {}, {});
    require_sound(result.soup);
    CHECK(result.soup.facets.size() == 3);
    CHECK(result.rounding.points_moved == 0);
  }
  SECTION("a vertex on a face splits it") {
    const auto result = arrange({triangles("a", {t, {Vec3{0.5, 0.5, 0}, Vec3{2, -2, 2}, Vec3{0, -2, 2}}})}, {}, {}, {});
    require_sound(result.soup);
    CHECK(result.soup.facets.size() == 4);
  }
}

TEST_CASE("arrange: wells get a vertex where they meet a facet", "[arrangement]") {
  const auto floor = triangles("floor", {{Vec3{-4, -4, 0}, Vec3{4, -4, 0}, Vec3{0, 4, 0}}}, SurfaceKind::horizon);
  ArrangementOptions options;
  options.box = Box3{{-5, -5, -2}, {5, 5, 2}};
  const Polyline well{"well", "", {{0, 0, 7}, {0, 0, -1}, {1, 0, -1}}};
  const Polyline along{"drift", "", {{-1, -2, 0}, {1, -2, 0}}};
  const NamedPoint inside{"monitor", {0.25, 0.25, 0}}, outside{"lost", {0, 0, 3}};
  const auto result = arrange({floor}, {well, along}, {inside, outside}, options);
  require_sound(result.soup);
  CHECK(has_point(result.soup, {0, 0, 0}));
  CHECK(has_point(result.soup, {0, 0, 2}));
  CHECK_FALSE(has_point(result.soup, {0, 0, 7}));
  CHECK(std::ranges::count(result.spots, "clipped polyline", &Spot::what) == 1);
  CHECK(any_contains(result.warnings, "point lost"));
  REQUIRE(result.soup.isolated_points.size() == 1);
  std::array<double, 2> length{};
  for (const auto& s : result.soup.segments) {
    const Vec3 d = result.soup.points[s.a] - result.soup.points[s.b];
    length[s.polyline] += std::sqrt(dot(d, d));
  }
  CHECK(length[0] == Approx(4));
  CHECK(length[1] == Approx(2));
}

TEST_CASE("arrange: bodies with cuts_all remove what is strictly inside", "[arrangement]") {
  auto body = cube("salt", {0, 0, 0}, {4, 4, 4}, SurfaceKind::body);
  body.cuts_all = true;
  const auto horizon = grid_surface("horizon", SurfaceKind::horizon, 3, -1, 5, -1, 5, [](double, double) { return 2; });
  const auto top = grid_surface("top", SurfaceKind::horizon, 3, -1, 5, -1, 5, [](double, double) { return 4; });
  const auto other = cube("ore", {1, 1, 1}, {2, 2, 2}, SurfaceKind::body);
  const auto result = arrange({body, horizon, top, other}, {}, {}, {});
  require_sound(result.soup);
  CHECK(result.area_clipped_by_bodies[1] == Approx(16));
  CHECK(result.area_clipped_by_bodies[2] == 0);  // lies on the body, not inside it
  CHECK(result.area_clipped_by_bodies[3] == 0);  // bodies do not cut bodies
  CHECK(area_of(result.soup, 2) == Approx(36));
  CHECK(area_of(result.soup, 3) == Approx(6));
  const Spot* spot = find_spot(result, "cut by body");
  REQUIRE(spot);
  CHECK(spot->measure == Approx(16));
}

TEST_CASE("arrange: a body that crosses itself is resolved by winding number", "[arrangement]") {
  auto body = cube("salt", {0, 0, 0}, {4, 4, 4}, SurfaceKind::body);
  const auto second = cube("second", {2, 1, 1}, {6, 3, 3}, SurfaceKind::body);
  for (const Triangle& t : second.triangles) body.triangles.push_back({t[0] + 8, t[1] + 8, t[2] + 8});
  body.points.insert(body.points.end(), second.points.begin(), second.points.end());
  body.cuts_all = true;
  const auto horizon = grid_surface("horizon", SurfaceKind::horizon, 1, -1, 7, -1, 5, [](double, double) { return 2; });
  const auto result = arrange({body, horizon}, {}, {}, {});
  require_sound(result.soup);
  CHECK(any_contains(result.warnings, "salt crosses itself"));
  CHECK(find_spot(result, "self-crossing"));
  CHECK(area_of(result.soup, 0) == Approx(96 + 16.0));  // two cubes less the inner walls on both sides of the hole
  CHECK(volume_inside(result.soup, [](const auto& o) { return o.surface == 0; }) == Approx(64 + 8.0));
  CHECK(result.area_clipped_by_bodies[1] == Approx(16 + 4.0));
}

TEST_CASE("arrange: an open body warns, and cuts where its mouth lies outside the box", "[arrangement]") {
  auto body = cube("stock", {1, 1, -9}, {3, 3, 3}, SurfaceKind::body);
  body.cuts_all = true;
  body.triangles.erase(body.triangles.begin(), body.triangles.begin() + 2);  // no floor
  const auto horizon = grid_surface("horizon", SurfaceKind::horizon, 2, -1, 5, -1, 5, [](double, double) { return 2; });
  ArrangementOptions options;
  SECTION("the mouth is below the box") {
    options.box = Box3{{0, 0, 0}, {4, 4, 4}};
    const auto result = arrange({body, horizon}, {}, {}, options);
    require_sound(result.soup);
    CHECK(any_contains(result.warnings, "stock is not closed"));
    CHECK(result.area_clipped_by_bodies[1] == Approx(4));
  }
  SECTION("the mouth is inside the box") {
    options.box = Box3{{0, 0, -10}, {4, 4, 4}};
    const auto result = arrange({body, horizon}, {}, {}, options);
    require_sound(result.soup);
    CHECK(any_contains(result.warnings, "cuts nothing"));
    CHECK(result.area_clipped_by_bodies[1] == 0);
  }
}

TEST_CASE("arrange: pieces in a box side merge with it", "[arrangement]") {
  const auto horizon = grid_surface("top", SurfaceKind::horizon, 3, -1, 5, -1, 5, [](double, double) { return 4; });
  ArrangementOptions options;
  options.box = Box3{{0, 0, 0}, {4, 4, 4}};
  const auto result = arrange({horizon}, {}, {}, options);
  require_sound(result.soup);
  CHECK(area_of(result.soup, 0) == Approx(16));
  CHECK(area_of(result.soup, 1 + 5) == Approx(16));
  CHECK(n_with_origins(result.soup, 2) > 0);
}

TEST_CASE("arrange: union, difference and overlap of two solids from the soup", "[arrangement]") {
  const auto volumes = [](const TriangulatedSurface& a, const TriangulatedSurface& b) {
    const PolygonSoup soup = arrange({a, b}, {}, {}, {}).soup;
    require_sound(soup);
    std::array<double, 2> out{}, in{};
    Vec3 union_area, overlap_area;  // vector areas: zero for closed surfaces
    for (Index f = 0; f < soup.facets.size(); ++f) {
      const auto& [i, j, k] = soup.facets[f];
      const Vec3 &p = soup.points[i], &q = soup.points[j], &r = soup.points[k];
      const Index own = soup.origins[soup.origin_offsets[f]].surface;
      const bool is_in = winding_number(own == 0 ? b : a, (1.0 / 3) * (p + q + r)) != 0;
      (is_in ? in : out)[own] += dot(p, cross(q, r)) / 6;
      Vec3& total = is_in ? overlap_area : union_area;
      total = total + cross(q - p, r - p);
    }
    CHECK(dot(union_area, union_area) == Approx(0).margin(1e-18));
    CHECK(dot(overlap_area, overlap_area) == Approx(0).margin(1e-18));
    return std::array<double, 3>{out[0] + out[1], out[0] - in[1], in[0] + in[1]};
  };
  const auto cubes = volumes(cube("a", {0, 0, 0}, {4, 4, 4}, SurfaceKind::surface),
                             cube("b", {2, 1, 1}, {6, 3, 3}, SurfaceKind::surface));
  CHECK(cubes[0] == Approx(64 + 8.0).epsilon(1e-14));
  CHECK(cubes[1] == Approx(64 - 8.0).epsilon(1e-14));
  CHECK(cubes[2] == Approx(8.0).epsilon(1e-14));
  const auto a = ellipsoid("a", {0, 0, 0}, {1, 1.5, 1}, 3), b = ellipsoid("b", {0.7, 0.2, 0.1}, {1, 1, 1.3}, 3);
  const auto v = volumes(a, b);
  const double volume_a = volume_inside(arrange({a}, {}, {}, {}).soup, [](const auto&) { return true; });
  CHECK(v[1] + v[2] == Approx(volume_a).epsilon(1e-13));
}

TEST_CASE("winding_number: nested and doubled shells", "[arrangement]") {
  auto shell = cube("shell", {0, 0, 0}, {4, 4, 4}, SurfaceKind::body);
  CHECK(winding_number(shell, {2, 2, 2}) == 1);
  CHECK(winding_number(shell, {1, 1, 1}) == 1);   // the ray meets a diagonal
  CHECK(winding_number(shell, {0, 0, -1}) == 0);  // the ray runs along an edge
  CHECK(winding_number(shell, {5, 2, 2}) == 0);
  const auto inner = cube("inner", {1, 1, 1}, {3, 3, 3}, SurfaceKind::body);
  for (const Triangle& t : inner.triangles) shell.triangles.push_back({t[0] + 8, t[1] + 8, t[2] + 8});
  shell.points.insert(shell.points.end(), inner.points.begin(), inner.points.end());
  CHECK(winding_number(shell, {2, 2, 2}) == 2);
  for (std::size_t t = 12; t < 24; ++t) std::swap(shell.triangles[t][1], shell.triangles[t][2]);
  CHECK(winding_number(shell, {2, 2, 2}) == 0);
  CHECK(winding_number(shell, {0.5, 2, 2}) == 1);
}

TEST_CASE("arrange: coordinates that are not finite are refused with the place", "[arrangement]") {
  auto bad = triangles("bad", {{Vec3{0, 0, 0}, Vec3{1, std::nan(""), 0}, Vec3{0, 1, 0}}});
  try {
    arrange({bad}, {}, {}, {});
    FAIL("a NaN was taken");
  } catch (const Error& error) {
    CHECK(error.kind() == ErrorKind::invalid_input);
    CHECK(std::string(error.what()).find("bad") != std::string::npos);
    CHECK(error.context().vertices == std::vector<VertexIndex>{1});
  }
}

TEST_CASE("validate_soup finds each kind of fault", "[arrangement]") {
  const auto soup_of = [](const std::vector<Vec3>& points, const std::vector<Triangle>& facets) {
    PolygonSoup soup;
    soup.points = points;
    soup.kind.assign(points.size(), SoupVertexKind::input);
    soup.input_point.assign(points.size(), 0);
    soup.facets = facets;
    for (Index f = 0; f < facets.size(); ++f) {
      soup.origins.push_back({0, f, false});
      soup.origin_offsets.push_back(f + 1);
    }
    return soup;
  };
  const std::vector<Vec3> p{{0, 0, 0}, {4, 0, 0},  {0, 4, 0}, {1, 1, 0}, {1, 1, 3},
                            {5, 5, 3}, {1, 1, -3}, {4, 4, 0}, {2, 0, 0}, {8, 0, 0}};
  CHECK(validate_soup(soup_of(p, {{0, 1, 2}, {1, 7, 2}})).empty());
  CHECK(validate_soup(soup_of(p, {{0, 1, 2}, {0, 2, 1}})).size() == 1);  // equal as sets
  CHECK(validate_soup(soup_of(p, {{0, 1, 2}, {3, 4, 5}})).size() == 1);  // vertex on a face
  CHECK(validate_soup(soup_of(p, {{0, 1, 2}, {6, 4, 5}})).size() == 1);  // edge through a face
  CHECK(validate_soup(soup_of(p, {{0, 1, 2}, {0, 1, 7}})).size() == 1);  // coplanar overlap at a shared edge
  CHECK(validate_soup(soup_of(p, {{0, 1, 2}, {0, 7, 4}})).size() == 1);  // an edge from a shared vertex along the face
  CHECK(validate_soup(soup_of(p, {{0, 1, 2}, {8, 4, 5}})).size() == 1);  // vertex on an edge
  CHECK(validate_soup(soup_of(p, {{0, 8, 1}})).size() == 1);             // degenerate
  CHECK(validate_soup(soup_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-0.0, 0, 0}}, {{0, 1, 2}})).size() ==
        1);  // equal points
  auto with_well = soup_of(p, {{0, 1, 2}});
  with_well.segments.push_back({4, 6, 0});
  CHECK(validate_soup(with_well).size() == 1);
  with_well.segments = {{0, 9, 0}};
  CHECK(validate_soup(with_well).size() == 1);
  with_well.segments = {{1, 9, 0}, {0, 1, 0}};
  CHECK(validate_soup(with_well).empty());
  with_well.isolated_points = {{3, 0}};
  CHECK(validate_soup(with_well).size() == 1);
  with_well.isolated_points = {{8, 0}};
  CHECK(validate_soup(with_well).size() == 2);  // on the facet's edge and on the segment
}
