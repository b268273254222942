// SPDX-License-Identifier: GPL-3.0-or-later
// Makes the report as an HTML page, declared in geomesh/geomodel/report.hpp.
#include <algorithm>
#include <array>

#include "geomesh/geomodel/report.hpp"
#include "geomesh/geomodel/viewer_page.hpp"
#include "geomesh/geomodel/writers.hpp"
#include "report/words.hpp"
#include "report_html/drawing.hpp"
#include "report_html/header_section.hpp"
#include "report_html/model/section.hpp"
#include "report_html/model/viewer.hpp"
#include "report_html/shape_section.hpp"
#include "report_html/stack_section.hpp"
#include "report_html/viewer_section.hpp"

namespace geomesh::geomodel {

namespace {

using page::coordinate;
using page::escape;
using page::MeshColours;
using page::number;

Box3 bounds_of(const ModelMesh& mesh) {
  Box3 bounds;
  for (const Vec3& p : mesh.points) bounds.add(p);
  return bounds;
}

std::string swatch(const Colour& colour) { return "<i style=\"background:" + to_hex(colour) + "\"></i>"; }

std::string cell(const std::string& text, bool is_number = false) {
  return (is_number ? "<td class=\"n\">" : "<td>") + text + "</td>";
}

std::string regions_table(const ModelMesh& mesh, const MeshColours& colours) {
  std::vector<std::string> bodies(mesh.regions.size());  // by region: names of the bodies around it, not its own
  for (std::size_t i = 0; i < mesh.regions.size(); ++i)
    for (const std::string& body : mesh.regions[i].inside)
      if (body != mesh.regions[i].name) bodies[i] += (bodies[i].empty() ? "" : ", ") + body;
  const bool any = std::any_of(bodies.begin(), bodies.end(), [](const std::string& b) { return !b.empty(); });
  std::string out =
      "<h2>Units</h2>\n<div class=\"wide\" tabindex=\"0\"><table><tr><th>unit</th><th class=\"n\">volume</th><th "
      "class=\"n\">tetrahedra</th>" +
      std::string(any ? "<th>lies in</th>" : "") + "</tr>\n";
  for (std::size_t i = 0; i < mesh.regions.size(); ++i) {
    const Region& r = mesh.regions[i];
    out += "<tr>" + cell(swatch(colours.regions[i]) + escape(r.name)) + cell(volume_words(r.volume, mesh.unit), true) +
           cell(grouped_words(r.n_tetrahedra), true) + (any ? cell(escape(bodies[i])) : "") + "</tr>\n";
  }
  return out + "</table></div>\n";
}

std::string curves_table(const ModelMesh& mesh) {
  std::string out =
      "<details><summary>Curves</summary><div class=\"wide\" tabindex=\"0\"><table><tr><th>curve</th><th>kind</th><th "
      "class=\"n\">length, " +
      mesh.unit + "</th></tr>\n";
  for (const NamedCurve& c : mesh.curves)
    out += "<tr>" + cell(escape(c.name)) + cell(escape(c.kind)) + cell(number(c.length), true) + "</tr>\n";
  return out + "</table></div></details>\n";
}

std::string surfaces_table(const ModelMesh& mesh, const MeshColours& colours) {
  std::string out =
      "<h2>Surfaces and curves</h2>\n<div class=\"wide\" tabindex=\"0\"><table><tr><th>surface</th><th>kind</th><th "
      "class=\"n\">area, " +
      mesh.unit + "2</th></tr>\n";
  for (std::size_t i = 0; i < mesh.surfaces.size(); ++i) {
    const NamedSurface& s = mesh.surfaces[i];
    out += "<tr>" + cell(swatch(colours.surfaces[i]) + escape(s.name)) + cell(std::string(to_string(s.kind))) +
           cell(number(s.area), true) + "</tr>\n";
  }
  return out + "</table></div>\n" + (mesh.curves.empty() ? "" : curves_table(mesh));
}

std::string sections(const ModelMesh& mesh, const Box3& bounds, const MeshColours& colours) {
  static constexpr std::array<const char*, 3> names{"x", "y", "z"};
  const Vec3 middle = 0.5 * (bounds.min + bounds.max);
  const double stretch = vertical_exaggeration(bounds);
  std::string out = "<h2>Sections through the middle</h2>\n";
  for (std::size_t axis : {1u, 0u, 2u}) {
    out += std::string("<h3>") + names[axis] + " = " + coordinate(middle[axis], bounds.max[axis] - bounds.min[axis]) +
           " " + mesh.unit;
    if (axis != 2 && stretch != 1) out += ", heights " + number(stretch) + " times";
    out += "</h3>\n" + draw_section(page::cut_mesh(mesh, axis, middle[axis]), bounds, colours.regions);
  }
  return out;
}

/// Lists the warnings. Several are collapsed under a line with their number, so that the reader sees the model first.
std::string warnings(const Report& report) {
  std::string out;
  for (const std::string& w : report.warnings) out += "<div class=\"warning\">" + escape(w) + "</div>\n";
  if (report.warnings.size() < 2) return out;
  return "<details class=\"warnings\"><summary>" + grouped_words(report.warnings.size()) + " warnings</summary>\n" +
         out + "</details>\n";
}

std::string notes(const Report& report) {
  if (report.notes.empty()) return {};
  constexpr std::size_t few = 5;
  std::string out = "<h2>Found in the surfaces, and changed by rules</h2>\n<details" +
                    std::string(report.notes.size() <= few ? " open" : "") + "><summary>" +
                    grouped_words(report.notes.size()) + (report.notes.size() == 1 ? " note" : " notes") +
                    "</summary>\n<ul>\n";
  for (const std::string& n : report.notes) out += "<li>" + escape(n) + "</li>\n";
  return out + "</ul></details>\n";
}

std::string run(const Report& report) {
  std::string out = "<h2>The run</h2>\n<table><tr><th>stage</th><th class=\"n\">seconds</th></tr>\n";
  for (const StageRecord& s : report.stages)
    out += "<tr>" + cell(escape(s.name) + (s.runs > 1 ? " (" + std::to_string(s.runs) + " runs)" : "")) +
           cell(number(s.wall_s), true) + "</tr>\n";
  out += "</table>\n";
  if (report.refinement && report.refinement->runs > 1)
    out += "<p>Surfaces were not within the tolerance at first, in " + std::to_string(report.refinement->off_before) +
           " places of earlier runs: they were held more closely there, and the model was refined again. The mesh is "
           "that of the last run.</p>\n";
  if (report.core) {
    const RecoveryStatistics& r = report.core->recovery;
    out += "<p>Points added to keep every surface: " + std::to_string(r.steiner_on_segments) +
           " on curves and edges, " + std::to_string(r.steiner_on_facets) + " on surfaces, " +
           std::to_string(r.steiner_inside) + " inside.</p>\n";
  }
  return out;
}

}  // namespace

std::string to_html(const Report& report) {
  const Box3 bounds = report.mesh ? bounds_of(*report.mesh) : Box3{};
  std::string out = "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>" + escape(report.name) +
                    "</title><meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"><style>" +
                    std::string(page::page_style()) + "</style></head><body>\n<main>" +
                    page::header_section(report, bounds) + warnings(report);
  if (report.mesh) {
    const ModelMesh& mesh = *report.mesh;
    const MeshColours colours = page::colours_of(mesh, colours_of_report("{\"input\":" + report.input_json + "}"));
    out +=
        page::viewer_section(report, bounds, colours) + regions_table(mesh, colours) + sections(mesh, bounds, colours);
    if (report.stack) out += page::stack_section(*report.stack, mesh.unit);
    if (report.solver) out += page::solver_section(*report.solver);
    if (report.quality) out += page::shape_section(*report.quality, mesh);
    out += surfaces_table(mesh, colours);
  }
  return out + notes(report) + run(report) + "</main></body></html>\n";
}

std::string viewer_page(const ModelMesh& mesh) {
  Report report;
  report.name = mesh.name;
  report.mesh = &mesh;
  return "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>" + escape(mesh.name) +
         "</title><meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"><style>" +
         std::string(page::page_style()) + "</style></head><body>\n<main>" +
         page::viewer_section(report, bounds_of(mesh), page::colours_of(mesh, {})) + "</main></body></html>\n";
}

void write_html_report(const Report& report, const std::filesystem::path& file) {
  write_text_file(file, to_html(report));
}

}  // namespace geomesh::geomodel
