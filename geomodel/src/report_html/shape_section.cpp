// SPDX-License-Identifier: GPL-3.0-or-later
#include "report_html/shape_section.hpp"

#include <algorithm>
#include <array>

#include "report/words.hpp"
#include "report_html/drawing.hpp"

namespace geomesh::geomodel::page {
namespace {

constexpr std::size_t most_elements_shown = 10;
/// Largest number of regions for which histograms are drawn beside the table.
constexpr std::size_t most_regions_drawn = 24;

std::string numeric(const std::string& text) { return "<td class=\"n\">" + text + "</td>"; }

template <std::size_t N>
std::string histogram(const std::array<std::size_t, N>& counts, double width, std::string_view quantity) {
  return draw_histogram({counts.begin(), counts.end()}, width, quantity);
}

std::string summary(const MeshQuality& q) {
  const ShapeStatistics& s = q.whole;
  return "<p>Smallest dihedral angle " + number(s.min_dihedral.min) + " degrees, largest " +
         number(s.max_dihedral.max) + "; solid angles from " + number(s.solid_angle.min) + " to " +
         number(s.solid_angle.max) + " degrees of spherical excess; smallest radius ratio " +
         number(s.radius_ratio.min) + " (1 is the regular tetrahedron). " + number(100 * s.share_above_24_85) +
         " % of the elements have all angles above 24.85 degrees. " + std::to_string(q.n_bad) +
         " elements are below 8 degrees, " + std::to_string(q.n_bad_forced) + " of them imposed by the input.</p>\n";
}

std::string row_of(const std::string& name, const ShapeStatistics& s) {
  std::string out = "<tr><td>" + escape(name) + "</td>" + numeric(grouped_words(s.n_tetrahedra));
  for (const double value :
       {s.min_dihedral.min, s.min_dihedral.first_percentile, s.min_dihedral.mean, s.max_dihedral.max,
        100 * s.share_below_10, 100 * s.share_above_24_85, s.radius_ratio.min, s.edge_length.mean})
    out += numeric(number(value));
  return out + "</tr>\n";
}

std::string table(const MeshQuality& q, const ModelMesh& mesh) {
  std::string out = "<div class=\"wide\" tabindex=\"0\"><table><tr><th>unit</th>";
  for (const char* head : {"tetrahedra", "least angle", "first percentile", "mean of least", "largest angle",
                           "% below 10", "% above 24.85", "least radius ratio", "mean edge"})
    out += std::string("<th class=\"n\">") + head + "</th>";
  out += "</tr>\n" + row_of("whole", q.whole);
  for (std::size_t r = 0; r < std::min(mesh.regions.size(), q.per_component.size()); ++r)
    out += row_of(mesh.regions[r].name, q.per_component[r]);
  return out + "</table></div>\n";
}

std::string by_region(const MeshQuality& q, const ModelMesh& mesh) {
  const std::size_t n = std::min(mesh.regions.size(), q.per_component.size());
  if (n < 2 || n > most_regions_drawn) return {};
  std::string out = "<details><summary>Smallest dihedral angles by unit</summary><div class=\"row\">\n";
  for (std::size_t r = 0; r < n; ++r)
    out += "<div><h3>" + escape(mesh.regions[r].name) + "</h3>" +
           histogram(q.per_component[r].min_dihedral_histogram, 5, "smallest dihedral angle, degrees") + "</div>\n";
  return out + "</div></details>\n";
}

std::string edges_against_size(const ShapeStatistics& s) {
  static constexpr std::array<const char*, 8> bins{"below 1/4", "1/4 to 1/2", "1/2 to 0.71", "0.71 to 1",
                                                   "1 to 1.41", "1.41 to 2",  "2 to 4",      "above 4"};
  std::size_t all = 0;
  for (const std::size_t n : s.edge_size_histogram) all += n;
  std::string out = "<h3>Edges by length over the requested size</h3>\n<div class=\"wide\" tabindex=\"0\"><table><tr>";
  for (const char* bin : bins) out += std::string("<th class=\"n\">") + bin + "</th>";
  out += "</tr><tr>";
  for (const std::size_t n : s.edge_size_histogram)
    out += numeric(number(100.0 * static_cast<double>(n) / static_cast<double>(std::max<std::size_t>(1, all))) + " %");
  return out + "</tr></table></div>\n";
}

std::string place_words(const Vec3& place, double range) {
  return coordinate(place.x, range) + ", " + coordinate(place.y, range) + ", " + coordinate(place.z, range);
}

std::string worst_elements(const QualityReport& report, const ModelMesh& mesh) {
  const MeshQuality& q = report.measured;
  Box3 bounds;
  for (const Vec3& p : mesh.points) bounds.add(p);
  const double range = 1e3 * std::max(bounds.max.x - bounds.min.x, bounds.max.y - bounds.min.y);
  std::string out =
      "<h3>Worst elements</h3>\n<div class=\"wide\" tabindex=\"0\"><table><tr><th class=\"n\">smallest angle</th><th "
      "class=\"n\">largest</th><th>at</th><th>unit</th><th>cause</th></tr>\n";
  for (std::size_t i = 0; i < std::min(q.worst.size(), most_elements_shown); ++i) {
    const WorstElement& w = q.worst[i];
    const auto region = static_cast<std::size_t>(mesh.tet_region[w.tetrahedron] - 1);
    out += "<tr>" + numeric(number(w.min_dihedral)) + numeric(number(w.max_dihedral)) + "<td>" +
           place_words(w.place, range) + "</td><td>" + escape(mesh.regions[region].name) + "</td><td>" +
           escape(report.causes[i]) + "</td></tr>\n";
  }
  return out + "</table></div>\n";
}

}  // namespace

std::string shape_section(const QualityReport& report, const ModelMesh& mesh) {
  const MeshQuality& q = report.measured;
  std::string out = "<h2>Shape of the elements</h2>\n" + summary(q) + "<div class=\"row\">" +
                    histogram(q.whole.min_dihedral_histogram, 5, "smallest dihedral angle of an element, degrees") +
                    histogram(q.whole.dihedral_histogram, 5, "every dihedral angle, degrees") +
                    histogram(q.whole.radius_ratio_histogram, 0.05, "radius ratio") + "</div>\n";
  out += table(q, mesh) + by_region(q, mesh);
  if (report.has_sizes) out += edges_against_size(q.whole);
  return out + worst_elements(report, mesh);
}

std::string solver_section(const SolverVerdict& verdict) {
  std::string out = "<h2>For solvers</h2>\n";
  for (const std::string& line : to_lines(verdict)) out += "<p>" + escape(line) + "</p>\n";
  return out;
}

}  // namespace geomesh::geomodel::page
