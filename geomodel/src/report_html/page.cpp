// SPDX-License-Identifier: GPL-3.0-or-later
// The report as a page, declared in geomesh/geomodel/report.hpp.
#include <algorithm>
#include <array>
#include <optional>

#include "geomesh/geomodel/report.hpp"
#include "geomesh/geomodel/viewer_page.hpp"
#include "geomesh/geomodel/writers.hpp"
#include "report/words.hpp"
#include "report_html/drawing.hpp"
#include "report_html/section.hpp"
#include "report_html/shape_section.hpp"
#include "report_html/stack_section.hpp"
#include "report_html/viewer.hpp"

namespace geomesh::geomodel {

namespace {

using page::colour;
using page::escape;
using page::number;

constexpr std::string_view style = R"css(
:root { color-scheme: light dark; --text: #222; --soft: #595959; --back: #fff; --line: #ddd; --note: #fdf6e6; --picture: #f7f7f5; --bar: #6b8fb3; }
@media (prefers-color-scheme: dark) { :root { --text: #e6e6e6; --soft: #a8a8a8; --back: #17191c; --line: #3a3d42; --note: #3a3120; --picture: #202327; --bar: #7fa6cc; } }
body { font: 15px/1.5 system-ui, sans-serif; margin: 2rem auto; max-width: 62rem; padding: 0 1rem; color: var(--text); background: var(--back); }
h1 { font-size: 1.7rem; margin-bottom: 0; } h2 { font-size: 1.2rem; margin-top: 2.2rem; border-bottom: 1px solid var(--line); }
h3 { font-size: .9rem; margin: .7rem 0 .2rem; } p.lead { color: var(--soft); margin-top: .2rem; }
table { border-collapse: collapse; } td, th { padding: .15rem .8rem .15rem 0; text-align: left; vertical-align: top; }
td.n, th.n { text-align: right; font-variant-numeric: tabular-nums; } i { display: inline-block; width: .85em; height: .85em; border-radius: 2px; margin: 0 .45em 0 .2em; }
svg { max-width: 100%; height: auto; font-size: 11px; } svg text { fill: currentColor; } .unit { stroke: var(--back); stroke-width: .35; stroke-linejoin: round; }
.trace { stroke: var(--text); stroke-width: 1.1; fill: none; } .frame { fill: none; stroke: #888; } .bar { fill: var(--bar); }
.warning { border-left: 4px solid #d99000; padding: .2rem .8rem; margin: .4rem 0; background: var(--note); } .row { display: flex; flex-wrap: wrap; align-items: flex-start; gap: 1.5rem; }
#viewer { display: grid; grid-template-columns: minmax(0, 1fr) 15rem; gap: 1rem; } #viewer .stage { position: relative; height: 30rem; }
#viewer canvas { position: absolute; inset: 0; width: 100%; height: 100%; } #viewer canvas.axes { pointer-events: none; }
#viewer canvas.model { touch-action: none; cursor: grab; border: 1px solid var(--line); background: var(--picture); color: var(--text); }
#viewer canvas.model:focus-visible { outline: 3px solid #2f6fd0; } #viewer .list { max-height: 30rem; overflow-y: auto; } #viewer fieldset { border: 0; padding: 0; margin: 0 0 .6rem; }
#viewer legend { font-weight: 600; font-size: .9rem; } #viewer .list label { display: block; } #viewer .tools label { margin-right: 1rem; } .hint { color: var(--soft); font-size: .85rem; }
@media (max-width: 45rem) { #viewer { grid-template-columns: 1fr; } }
)css";

Box3 bounds_of(const ModelMesh& mesh) {
  Box3 bounds;
  for (const Vec3& p : mesh.points) bounds.add(p);
  return bounds;
}

std::string swatch(std::size_t row) { return "<i style=\"background:" + colour(row) + "\"></i>"; }

std::string cell(const std::string& text, bool is_number = false) {
  return (is_number ? "<td class=\"n\">" : "<td>") + text + "</td>";
}

std::string regions_table(const ModelMesh& mesh) {
  std::string out =
      "<h2>Units</h2>\n<table><tr><th>unit</th><th class=\"n\">volume</th><th class=\"n\">tetrahedra</th><th>lies "
      "in</th></tr>\n";
  for (const Region& r : mesh.regions) {
    std::string inside;
    for (const std::string& body : r.inside) inside += (inside.empty() ? "" : ", ") + body;
    out += "<tr>" + cell(swatch(static_cast<std::size_t>(r.id - 1)) + escape(r.name)) +
           cell(volume_words(r.volume, mesh.unit), true) + cell(std::to_string(r.n_tetrahedra), true) +
           cell(escape(inside)) + "</tr>\n";
  }
  return out + "</table>\n";
}

std::string surfaces_table(const ModelMesh& mesh) {
  std::string out =
      "<h2>Surfaces and curves</h2>\n<div class=\"row\"><table><tr><th>surface</th><th>kind</th><th "
      "class=\"n\">area, " +
      mesh.unit + "2</th></tr>\n";
  for (std::size_t i = 0; i < mesh.surfaces.size(); ++i) {
    const NamedSurface& s = mesh.surfaces[i];
    out += "<tr>" + cell(swatch(mesh.regions.size() + i) + escape(s.name)) + cell(std::string(to_string(s.kind))) +
           cell(number(s.area), true) + "</tr>\n";
  }
  out += "</table><table><tr><th>curve</th><th>kind</th><th class=\"n\">length, " + mesh.unit + "</th></tr>\n";
  for (const NamedCurve& c : mesh.curves)
    out += "<tr>" + cell(escape(c.name)) + cell(escape(c.kind)) + cell(number(c.length), true) + "</tr>\n";
  return out + "</table></div>\n";
}

constexpr std::string_view viewer_elements = R"html(<div id="viewer"><div>
<div class="stage"><canvas class="model" tabindex="0" role="application" aria-label="The model in three dimensions" aria-describedby="viewer-keys"></canvas><canvas class="axes" aria-hidden="true"></canvas></div>
<div class="tools"><label>Cut away along <select name="cut"><option value="">nothing</option><option>x</option><option>y</option><option>z</option></select></label>
<label>at <input type="range" name="at" min="0" max="1" step="0.002" value="0.5"></label> <label>Colour by <select name="colours"><option value="unit">unit</option><option value="angle">least angle</option></select></label>
<label>Vertical stretch <input type="range" name="stretch" min="1" max="10" step="0.5"></label> <label><input type="checkbox" name="lines" checked> mesh edges</label></div>
<div class="says hint" role="status"></div>
<div class="hint" id="viewer-keys">Drag to turn, with shift or two fingers to move, with alt to move the cut; wheel or pinch to zoom. Keys: arrows turn, with shift move; + and - zoom; x, y, z cut, [ and ] move the cut; 0 begins anew.
Least dihedral angles: red below 8 degrees, yellow at 25, blue from 50.</div></div>
<div class="list" tabindex="0" role="group" aria-label="What is shown"></div></div>
)html";

std::string viewer(const ModelMesh& mesh, const Box3& bounds, const std::optional<QualityReport>& quality) {
  if (mesh.faces.size() > page::most_faces_shown)
    return "<p class=\"hint\">" + std::to_string(mesh.faces.size()) +
           " faces are too many to turn in a browser: open the .faces.vtp in ParaView.</p>\n";
  std::string out(viewer_elements);
  if (mesh.tetrahedra.size() > page::most_cells_shown)
    out += "<p class=\"hint\">" + std::to_string(mesh.tetrahedra.size()) +
           " tetrahedra are too many for a page: a cut shows surfaces alone.</p>\n";
  return out + "<script type=\"application/json\" id=\"model\">" +
         page::viewer_data(mesh, bounds, quality ? &*quality : nullptr) + "</script>\n<script>" +
         std::string(page::viewer_script()) + "</script>\n";
}

std::string sections(const ModelMesh& mesh, const Box3& bounds) {
  static constexpr std::array<const char*, 3> names{"x", "y", "z"};
  const Vec3 middle = 0.5 * (bounds.min + bounds.max);
  const double stretch = page::vertical_exaggeration(bounds);
  std::string out = "<h2>Sections through the middle</h2>\n";
  for (std::size_t axis : {1u, 0u, 2u}) {
    out += std::string("<h3>") + names[axis] + " = " + number(middle[axis]);
    if (axis != 2 && stretch != 1) out += ", heights stretched " + number(stretch) + " times";
    out += "</h3>\n" + draw_section(page::cut_mesh(mesh, axis, middle[axis]), bounds);
  }
  return out;
}

std::string warnings(const Report& report) {
  std::string out;
  for (const std::string& w : report.warnings) out += "<div class=\"warning\">" + escape(w) + "</div>\n";
  return out;
}

std::string notes(const Report& report) {
  if (report.notes.empty()) return {};
  std::string out = "<h2>Found in the surfaces, and changed by rules</h2>\n<ul>\n";
  for (const std::string& n : report.notes) out += "<li>" + escape(n) + "</li>\n";
  return out + "</ul>\n";
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
  std::string out = "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>" + escape(report.name) +
                    "</title><meta name=\"viewport\" content=\"width=device-width\"><style>" + std::string(style) +
                    "</style></head><body>\n<main><h1>" + escape(report.name) + "</h1>\n";
  if (report.mesh) {
    const ModelMesh& mesh = *report.mesh;
    const Box3 bounds = bounds_of(mesh);
    out += "<p class=\"lead\">" + std::to_string(mesh.tetrahedra.size()) + " tetrahedra, " +
           std::to_string(mesh.points.size()) + " points, " + std::to_string(mesh.regions.size()) + " units</p>\n" +
           warnings(report) + viewer(mesh, bounds, report.quality) + regions_table(mesh) + notes(report);
    if (report.stack) out += page::stack_section(*report.stack, mesh.unit);
    out += sections(mesh, bounds);
    if (report.solver) out += page::solver_section(*report.solver);
    if (report.quality) out += page::shape_section(*report.quality, mesh);
    out += surfaces_table(mesh);
  } else {
    out += warnings(report) + notes(report);
  }
  return out + run(report) + "</main></body></html>\n";
}

std::string viewer_page(const ModelMesh& mesh) {
  return "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>" + escape(mesh.name) +
         "</title><meta name=\"viewport\" content=\"width=device-width\"><style>" + std::string(style) +
         "</style></head><body>\n" + viewer(mesh, bounds_of(mesh), std::nullopt) + "</body></html>\n";
}

void write_html_report(const Report& report, const std::filesystem::path& file) {
  write_text_file(file, to_html(report));
}

}  // namespace geomesh::geomodel
