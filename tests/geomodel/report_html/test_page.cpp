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
#include "report_html/section.hpp"
#include "report_html/viewer.hpp"

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
  CHECK(page::vertical_exaggeration({{0, 0, 0}, {10, 10, 10}}) == 1);
  CHECK(page::vertical_exaggeration({{0, 0, -3}, {10, 8, 0}}) == 1);
  CHECK(page::vertical_exaggeration({{0, 0, -2}, {10, 8, 0}}) == 2);
  CHECK(page::vertical_exaggeration({{0, 0, -100}, {10000, 8000, 0}}) == 50);
}

TEST_CASE("the turnable picture holds every face, and text that cannot end its element", "[page]") {
  ModelMesh mesh = three_layer_mesh(2);
  mesh.regions[0].name = "</script><b>";
  Box3 bounds;
  for (const Vec3& p : mesh.points) bounds.add(p);
  const std::string text = page::viewer_data(mesh, bounds);
  CHECK(text.find("</") == std::string::npos);
  const json data = json::parse(text);
  CHECK(data["regions"][0]["name"] == "</script><b>");
  CHECK(data["regions"].size() == mesh.regions.size());
  CHECK(data["surfaces"].size() == mesh.surfaces.size());
  const std::size_t bytes = mesh.faces.size() * 3 * 4;
  CHECK(data["corners"].get<std::string>().size() == (bytes + 2) / 3 * 4);
  CHECK(data["sides"].get<std::string>().size() == (bytes + 2) / 3 * 4);
  const auto coded = [](std::size_t n) { return (n + 2) / 3 * 4; };
  CHECK(data["angles"].get<std::string>().size() == coded(2 * mesh.faces.size()));
  CHECK(data["cells"].get<std::string>().size() == coded(16 * mesh.tetrahedra.size()));
  CHECK(data["cell_angles"].get<std::string>().size() == coded(mesh.tetrahedra.size()));
  CHECK(data["edges"].get<std::string>().size() == coded(8 * mesh.curve_edges.size()));
  CHECK(data["curves"].size() == mesh.curves.size());
  CHECK(data["worst"].empty());
}

TEST_CASE("the turnable picture holds the corners of the worst elements, from the middle of the model", "[page]") {
  const ModelMesh mesh = three_layer_mesh(2);
  Box3 bounds;
  for (const Vec3& p : mesh.points) bounds.add(p);
  const QualityReport quality = quality_of(mesh);
  const json data = json::parse(page::viewer_data(mesh, bounds, &quality));
  REQUIRE(data["worst"].size() == std::min<std::size_t>(50, quality.measured.worst.size()));
  REQUIRE(!data["worst"].empty());
  const Tetrahedron& first = mesh.tetrahedra[quality.measured.worst[0].tetrahedron];
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t k = 0; k < 3; ++k)
      CHECK(data["worst"][0]["corners"][3 * i + k].get<double>() ==
            Approx(mesh.points[first[i]][k] - 0.5 * (bounds.min[k] + bounds.max[k])).margin(1e-6));
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
  CHECK(html.find("Edges by length over the asked size") != std::string::npos);
  CHECK(html.find("gap of 0.5 between horizon upper and horizon lower") != std::string::npos);
  report.quality->has_sizes = false;
  CHECK(to_html(report).find("Edges by length") == std::string::npos);
}
