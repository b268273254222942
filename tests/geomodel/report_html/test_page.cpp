// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "geomesh/geomodel/report.hpp"
#include "hand_made.hpp"
#include "made_up_quality.hpp"
#include "report_html/drawing.hpp"
#include "report_html/model/draw_model.hpp"
#include "report_html/model/png.hpp"
#include "report_html/model/section.hpp"
#include "report_html/model/viewer.hpp"

using namespace geomesh;
using namespace geomesh::geomodel;
using namespace geomesh::geomodel::testing;
using nlohmann::json;

namespace {

double area_of(const std::vector<Vec2>& polygon) {
  double twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    twice += a.x * b.y - b.x * a.y;
  }
  return std::abs(twice) / 2;
}

std::map<std::int32_t, double> area_by_region(const page::Section& section) {
  std::map<std::int32_t, double> area;
  for (const auto& cut : section.cuts) area[cut.region] += area_of(cut.polygon);
  return area;
}

Box3 bounds_of(const ModelMesh& mesh) {
  Box3 bounds;
  for (const Vec3& p : mesh.points) bounds.add(p);
  return bounds;
}

json data_of(const ModelMesh& mesh, const QualityReport* quality = nullptr, const page::DrawingLimits& limits = {}) {
  return json::parse(page::viewer_data(mesh, bounds_of(mesh), page::colours_of(mesh, {}), quality, limits));
}

std::size_t bytes_in(const json& coded) {
  const std::string text = coded.get<std::string>();
  return text.size() / 4 * 3 - static_cast<std::size_t>(std::count(text.begin(), text.end(), '='));
}

std::size_t occurrences(const std::string& text, const std::string& what) {
  std::size_t n = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++n;
  return n;
}

}  // namespace

TEST_CASE("a section cuts every unit over its true area", "[page]") {
  const ModelMesh mesh = three_layer_mesh(3);  // 3 x 3 x 3, layers one unit thick
  for (double at : {1.3, 2.0, 2.75}) {         // 2.0 runs through a sheet of vertices
    CAPTURE(at);
    for (std::size_t axis : {0u, 1u}) {
      const auto area = area_by_region(page::cut_mesh(mesh, axis, at));
      REQUIRE(area.size() == 3);
      for (const auto& [region, measured] : area) CHECK(measured == Approx(3.0).epsilon(1e-12));
    }
  }
  const auto map = area_by_region(page::cut_mesh(mesh, 2, 1.5));
  REQUIRE(map.size() == 1);
  CHECK(map.at(2) == Approx(9.0).epsilon(1e-12));
}

TEST_CASE("surfaces leave traces of their true length in a section", "[page]") {
  const page::Section section = page::cut_mesh(three_layer_mesh(3), 0, 1.3);
  double length = 0;
  for (const auto& t : section.traces) length += std::hypot(t.a.x - t.b.x, t.a.y - t.b.y);
  CHECK(length == Approx(4 * 3 + 2 * 3).epsilon(1e-12));  // the box's outline and two horizons
}

TEST_CASE("a section outside the model is empty", "[page]") {
  const page::Section section = page::cut_mesh(three_layer_mesh(2), 1, 17);
  CHECK(section.cuts.empty());
  CHECK(section.traces.empty());
}

TEST_CASE("base64 as in RFC 4648, section 10", "[page]") {
  const std::map<std::string, std::string> known{{"", ""},
                                                 {"f", "Zg=="},
                                                 {"fo", "Zm8="},
                                                 {"foo", "Zm9v"},
                                                 {"foob", "Zm9vYg=="},
                                                 {"fooba", "Zm9vYmE="},
                                                 {"foobar", "Zm9vYmFy"}};
  for (const auto& [plain, coded] : known) CHECK(page::base64(plain) == coded);
  CHECK(page::base64("\xff\xff\xfe") == "///+");
}

TEST_CASE("heights are stretched until layers can be told apart, by round factors", "[page]") {
  CHECK(vertical_exaggeration({{0, 0, 0}, {10, 10, 10}}) == 1);
  CHECK(vertical_exaggeration({{0, 0, -3}, {10, 8, 0}}) == 1);
  CHECK(vertical_exaggeration({{0, 0, -2}, {10, 8, 0}}) == 2);
  CHECK(vertical_exaggeration({{0, 0, -100}, {10000, 8000, 0}}) == 50);
}

TEST_CASE("numbers are written plainly, without an exponent", "[page]") {
  CHECK(page::number(1e4) == "10,000");
  CHECK(page::number(2.117e7) == "21,170,000");
  CHECK(page::number(-1234.6) == "-1,235");
  CHECK(page::number(0.25) == "0.25");
  CHECK(page::number(12.3456) == "12.35");
  CHECK(page::number(999.96) == "1,000");
  CHECK(page::number(0) == "0");
  CHECK(page::coordinate(6788114.25, 10000) == "6788114.25");
  CHECK(page::coordinate(6788114.0, 5) == "6788114");
  CHECK(page::coordinate(-0.0, 10) == "0");
}

TEST_CASE("the turnable picture holds every face, and text that cannot end its element", "[page]") {
  ModelMesh mesh = three_layer_mesh(2);
  mesh.regions[0].name = "</script><b>";
  const std::string text = page::viewer_data(mesh, bounds_of(mesh), page::colours_of(mesh, {}));
  CHECK(text.find("</") == std::string::npos);
  const json data = json::parse(text);
  CHECK(data["regions"][0]["name"] == "</script><b>");
  CHECK(data["regions"].size() == mesh.regions.size());
  CHECK(data["surfaces"].size() == mesh.surfaces.size());
  CHECK(bytes_in(data["corners"]) == mesh.faces.size() * 3 * 4);
  CHECK(bytes_in(data["sides"]) == mesh.faces.size() * 3 * 4);
  CHECK(bytes_in(data["cells"]) == 16 * mesh.tetrahedra.size());
  CHECK(bytes_in(data["edges"]) == 8 * mesh.curve_edges.size());
  CHECK(data["curves"].size() == mesh.curves.size());
  CHECK(data["worst"].empty());
}

TEST_CASE("the viewer can colour by shape, size, and all that the mesh carries", "[page]") {
  ModelMesh mesh = three_layer_mesh(2);
  mesh.attributes = {{"porosity", {0.1, 0.3, std::nan("")}}};
  mesh.cell_arrays = {{"size", std::vector<double>(mesh.tetrahedra.size(), 2.0), "m"}};
  mesh.point_arrays = {{"temperature", std::vector<double>(mesh.points.size(), 20.0), "degC"}};
  const json all = data_of(mesh)["quantities"];
  std::vector<std::string> names;
  for (const json& q : all) names.push_back(q["name"]);
  CHECK(names == std::vector<std::string>{"least angle", "edge length", "porosity", "size", "temperature"});
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(bytes_in(all[i]["faces"]) == 2 * mesh.faces.size());
    CHECK(bytes_in(all[i]["cells"]) == mesh.tetrahedra.size());
  }
  CHECK(bytes_in(all[4]["points"]) == mesh.points.size());
  const page::Quantity porosity = page::quantities_of(mesh)[2];
  CHECK(porosity.low == 0.1);
  CHECK(porosity.high == 0.3);
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t) {
    const int wanted = mesh.tet_region[t] == 1 ? 0 : mesh.tet_region[t] == 2 ? 254 : page::Quantity::not_known;
    CHECK(static_cast<int>(porosity.steps[t]) == wanted);
  }
}

TEST_CASE("a mesh too large for a browser is drawn coarser, with its outline and all of its units", "[page]") {
  const ModelMesh mesh = three_layer_mesh(20);
  const page::DrawingLimits limits{800, 2500};
  REQUIRE(mesh.tetrahedra.size() > 2 * limits.tetrahedra);
  const page::DrawnMesh drawn = page::drawn_mesh(mesh, 1, limits);
  CHECK(!drawn.is_whole);
  CHECK(drawn.faces.size() <= limits.faces);
  CHECK(drawn.cells.size() <= limits.tetrahedra);
  CHECK(drawn.cells.size() > limits.tetrahedra / 4);
  Box3 bounds;
  std::map<std::int32_t, std::size_t> cells_of;
  for (const std::uint32_t t : drawn.cells) {
    ++cells_of[mesh.tet_region[t]];
    for (const VertexIndex v : mesh.tetrahedra[t]) bounds.add(mesh.points[drawn.corner[v]]);
  }
  CHECK(cells_of.size() == 3);
  const Box3 whole = bounds_of(mesh);
  CHECK(bounds.min == whole.min);
  CHECK(bounds.max == whole.max);
  const page::DrawnMesh in_page = page::drawn_mesh(mesh, vertical_exaggeration(whole), limits);
  const json data = data_of(mesh, nullptr, limits);
  CHECK(bytes_in(data["corners"]) == 12 * in_page.faces.size());
  CHECK(bytes_in(data["cells"]) == 16 * in_page.cells.size());
  CHECK(bytes_in(data["quantities"][0]["cells"]) == in_page.cells.size());
  CHECK(page::drawn_mesh(mesh, 1).is_whole);
}

TEST_CASE("the turnable picture holds the corners of the worst elements, from the middle of the model", "[page]") {
  const ModelMesh mesh = three_layer_mesh(2);
  const Box3 bounds = bounds_of(mesh);
  const QualityReport quality = quality_of(mesh);
  const json data = data_of(mesh, &quality);
  REQUIRE(data["worst"].size() == std::min<std::size_t>(50, quality.measured.worst.size()));
  REQUIRE(!data["worst"].empty());
  const Tetrahedron& first = mesh.tetrahedra[quality.measured.worst[0].tetrahedron];
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t k = 0; k < 3; ++k)
      CHECK(data["worst"][0]["corners"][3 * i + k].get<double>() ==
            Approx(mesh.points[first[i]][k] - 0.5 * (bounds.min[k] + bounds.max[k])).margin(1e-6));
}

TEST_CASE("the open corner stands in the middle, or in a body that walls through the middle would miss", "[page]") {
  ModelMesh mesh = three_layer_mesh(4);
  const Box3 bounds = bounds_of(mesh);
  const Vec2 middle{0.5 * (bounds.min.x + bounds.max.x), 0.5 * (bounds.min.y + bounds.max.y)};
  CHECK(page::open_corner(mesh, bounds) == middle);
  // A lens inside the middle layer beside the middle of the box: one element that touches no side.
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t) {
    Box3 own;
    for (const VertexIndex v : mesh.tetrahedra[t]) own.add(mesh.points[v]);
    if (mesh.tet_region[t] != 2 || own.min.x < middle.x || own.max.x > 0.9 * bounds.max.x || own.min.y < middle.y)
      continue;
    mesh.tet_region[t] = 4;
    mesh.regions.push_back({4, "lens", {}, 1, 1.0});
    CHECK(page::open_corner(mesh, bounds) == Vec2{0.5 * (own.min.x + own.max.x), 0.5 * (own.min.y + own.max.y)});
    return;
  }
  FAIL("the mesh has no element beside its middle");
}

TEST_CASE("parts of a unit have shades of its colour, and the project's colours win", "[page]") {
  const auto next_to = [](const Colour& a, const Colour& b) {
    return std::abs(a[0] / b[0] - a[1] / b[1]) < 0.01 && std::abs(a[0] / b[0] - a[2] / b[2]) < 0.01;
  };
  Palette palette(Palette::Of::units);
  const Colour first = palette.colour_of("sand__1"), clay = palette.colour_of("clay"),
               second = palette.colour_of("sand__2");
  CHECK(first != second);
  CHECK(next_to(first, second));
  CHECK(!next_to(first, clay));
  const Colour red = *colour_from("#ff0000"), blue = *colour_from("#00f");
  CHECK(to_hex(blue) == "#0000ff");
  Palette given(Palette::Of::units, {{"clay", red}, {"sand__2", blue}});
  CHECK(given.colour_of("sand__1") == first);
  CHECK(given.colour_of("clay") == red);
  CHECK(given.colour_of("sand__2") == blue);
  CHECK(!colour_from("#12345"));
  CHECK(!colour_from("no colour"));
  CHECK(colours_of_report(R"({"input": {"colours": {"clay": "#ff0000", "x": 3}}})") == GivenColours{{"clay", red}});
  CHECK(colours_of_report("no report").empty());
}

TEST_CASE("the picture for browsers without WebGL shows each unit in its colour, light on top", "[page]") {
  const ModelMesh mesh = three_layer_mesh(3);
  const std::vector<Colour> colours{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const page::Picture picture = page::draw_model(mesh, page::open_corner(mesh, bounds_of(mesh)), 1, colours);
  REQUIRE(picture.rgb.size() == 3 * picture.width * picture.height);
  std::array<std::size_t, 3> seen{};
  std::array<std::uint8_t, 3> lightest{};
  for (std::size_t i = 0; i < picture.rgb.size(); i += 3)
    for (std::size_t k = 0; k < 3; ++k)
      if (picture.rgb[i + (k + 1) % 3] == 0 && picture.rgb[i + (k + 2) % 3] == 0) {
        ++seen[k];
        lightest[k] = std::max(lightest[k], picture.rgb[i + k]);
      }
  for (const std::size_t n : seen) CHECK(n > picture.rgb.size() / 3 / 50);
  // Only the uppermost unit shows its top.
  CHECK(static_cast<int>(std::max({lightest[0], lightest[1], lightest[2]})) == 255);
  const std::string png = page::to_png(picture);
  CHECK(png.substr(1, 3) == "PNG");
  CHECK(png.size() < picture.rgb.size() / 4);
}

TEST_CASE("the page names units, surfaces and warnings, and escapes them", "[page]") {
  ModelMesh mesh = three_layer_mesh(2);
  mesh.regions[1].name = "<i>marl</i> & \"clay\"";
  Report report;
  report.name = "a < b";
  report.mesh = &mesh;
  report.quality = quality_of(mesh);
  report.warnings = {"fault <F1> ends inside"};
  report.notes = {"clipped 3 m2"};
  report.stages = {{"read", 0.25, 0.25, 1000}, {"refine", 0.5, 0.5, 1000, 3}};
  report.refinement = RefineStatistics{.runs = 3, .off_before = 17};
  const std::string html = to_html(report);
  CHECK(html.find("<title>a &lt; b</title>") != std::string::npos);
  CHECK(html.find("&lt;i&gt;marl&lt;/i&gt; &amp; &quot;clay&quot;") != std::string::npos);
  CHECK(html.find("<td><i>marl") == std::string::npos);
  CHECK(html.find("fault &lt;F1&gt; ends inside") != std::string::npos);
  CHECK(html.find("clipped 3 m2") != std::string::npos);
  CHECK(html.find("<td>read</td><td class=\"n\">0.25</td>") != std::string::npos);
  CHECK(html.find("<td>refine (3 runs)</td><td class=\"n\">0.5</td>") != std::string::npos);
  CHECK(html.find("in 17 places of earlier runs") != std::string::npos);
  for (const NamedSurface& s : mesh.surfaces) CHECK(html.find(s.name) != std::string::npos);
  CHECK(html.find("geomesh ") != std::string::npos);
  CHECK(html.find("<dt>Box</dt><dd>x 0 to 2, y 0 to 2, z 0 to 3 (2 x 2 x 3 m)</dd>") != std::string::npos);
  CHECK(html.find("<dt>Made</dt>") != std::string::npos);
  CHECK(html.find("initial-scale=1") != std::string::npos);
  CHECK(html.find("src=\"data:image/png;base64,") != std::string::npos);
  CHECK(occurrences(html, "<svg ") == 6 + mesh.regions.size());  // three sections, three histograms, one for each unit
  CHECK(occurrences(html, "<svg ") == occurrences(html, "</svg>"));
  CHECK(html.find("http") == std::string::npos);  // the page asks nothing of a network
}

TEST_CASE("the page tells shapes of the whole and of each unit, and why the worst elements are bad", "[page]") {
  const ModelMesh mesh = three_layer_mesh(2);
  Report report;
  report.mesh = &mesh;
  report.quality = quality_of(mesh);
  const std::string html = to_html(report);
  const ShapeStatistics& whole = report.quality->measured.whole;
  CHECK(html.find("<td>whole</td><td class=\"n\">" + std::to_string(whole.n_tetrahedra) + "</td><td class=\"n\">" +
                  page::number(whole.min_dihedral.min)) != std::string::npos);
  for (std::size_t r = 0; r < mesh.regions.size(); ++r)
    CHECK(html.find("<td>" + mesh.regions[r].name + "</td><td class=\"n\">" +
                    std::to_string(report.quality->measured.per_component[r].n_tetrahedra) + "</td>") !=
          std::string::npos);
  // Every element is in one bar of the first histogram (the paper's Figure 11), and each of its angles in one of the
  // second.
  const auto counted = [](const auto& histogram) {
    std::size_t n = 0;
    for (const std::size_t k : histogram) n += k;
    return n;
  };
  CHECK(counted(whole.min_dihedral_histogram) == whole.n_tetrahedra);
  CHECK(counted(whole.dihedral_histogram) == 6 * whole.n_tetrahedra);
  CHECK(html.find("smallest dihedral angle of an element, degrees") != std::string::npos);
  CHECK(html.find("every dihedral angle, degrees") != std::string::npos);
  CHECK(html.find("Edges by length over the requested size") != std::string::npos);
  CHECK(html.find("gap of 0.5 between horizon upper and horizon lower") != std::string::npos);
  report.quality->has_sizes = false;
  CHECK(to_html(report).find("Edges by length") == std::string::npos);
}
