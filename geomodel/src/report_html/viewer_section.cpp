// SPDX-License-Identifier: GPL-3.0-or-later
#include "report_html/viewer_section.hpp"

#include "report/words.hpp"
#include "report_html/drawing.hpp"
#include "report_html/model/draw_model.hpp"

namespace geomesh::geomodel::page {
namespace {

constexpr std::string_view controls = R"html(<div class="bar" hidden>
<div class="set"><label>Cut <select name="cut"><option value="corner">a corner away</option><option value="x">at x</option><option value="y">at y</option><option value="z">at z</option><option value="line">along a line</option><option value="">nothing</option></select></label>
<label data-for="corner x line"><span class="what">x</span> <input type="range" name="at1" min="0" max="1" step="0.001"></label>
<label data-for="corner y"><span>y</span> <input type="range" name="at2" min="0" max="1" step="0.001"></label>
<label data-for="z"><span>z</span> <input type="range" name="at3" min="0" max="1" step="0.001"></label>
<label data-for="line">strike <input type="range" name="strike" min="0" max="180" step="0.1" value="90"></label>
<button type="button" name="draw" data-for="line">Draw the line</button>
<button type="button" name="flip" data-for="corner x y z line">Other side</button>
<button type="button" name="face" data-for="x y z line">Look at the cut</button></div>
<div class="set"><label>Colour <select name="colours"><option value="unit">by unit</option></select></label>
<label>Heights <input type="range" name="stretch" min="1" max="10" step="0.5"> <output name="times"></output></label>
<label>Apart <input type="range" name="apart" min="0" max="1" step="0.01" value="0"></label>
<label><input type="checkbox" name="lines" checked> mesh</label>
<button type="button" name="reset">Whole view</button>
<button type="button" name="full">Full screen</button>
<button type="button" name="save">Save PNG</button></div></div>
)html";

constexpr std::string_view below = R"html(<div class="says hint" role="status"></div>
<details class="hint keys"><summary>Mouse, fingers and keys</summary><p id="viewer-keys">Click a unit to learn its name. Drag to turn; with shift, the right button or two fingers to move; with alt to move the cut; wheel or pinch to zoom; double click to turn about a place.
Keys: arrows turn, with shift move; + and - zoom; c, x, y, z cut, [ and ] move the cut; f full screen; 0 begins anew.</p></details></div>
<div class="side"><div class="card" role="region" aria-label="What was clicked" aria-live="polite"></div><div class="list" tabindex="0" role="group" aria-label="What is shown"></div></div></div>
)html";

/// Returns a still picture of the initial view, shown until the script has drawn the model, or if it cannot run.
std::string poster(const ModelMesh& mesh, const Box3& bounds, const MeshColours& colours) {
  const double stretch = vertical_exaggeration(bounds);
  std::string text = "The model with a corner cut away";
  if (stretch != 1) text += ", heights " + number(stretch) + " times";
  return "<img class=\"poster\" alt=\"" + text + "\" src=\"data:image/png;base64," +
         base64(to_png(draw_model(mesh, open_corner(mesh, bounds), stretch, colours.regions))) + "\">";
}

std::string reduced_words(const ModelMesh& mesh, const DrawingLimits& limits) {
  if (mesh.faces.size() <= limits.faces && mesh.tetrahedra.size() <= limits.tetrahedra) return {};
  return "<p class=\"hint\">The mesh has " + grouped_words(mesh.tetrahedra.size()) + " tetrahedra and " +
         grouped_words(mesh.faces.size()) +
         " faces on surfaces, too many for a browser: it is drawn coarser than it is. Volumes, counts and the sections "
         "below are those of the mesh itself.</p>\n";
}

}  // namespace

std::string viewer_section(const Report& report, const Box3& bounds, const MeshColours& colours,
                           const DrawingLimits& limits) {
  const ModelMesh& mesh = *report.mesh;
  return "<div id=\"viewer\"><div class=\"main\">" + std::string(controls) + "<div class=\"stage\">" +
         poster(mesh, bounds, colours) +
         "<canvas class=\"model\" tabindex=\"0\" role=\"application\" aria-label=\"The model in three dimensions\" "
         "aria-describedby=\"viewer-keys\" hidden></canvas><canvas class=\"axes\" "
         "aria-hidden=\"true\"></canvas></div>\n" +
         std::string(below) + reduced_words(mesh, limits) + "<script type=\"application/json\" id=\"model\">" +
         viewer_data(mesh, bounds, colours, report.quality ? &*report.quality : nullptr, limits) +
         "</script>\n<script>" + std::string(viewer_script()) + "</script>\n";
}

}  // namespace geomesh::geomodel::page
