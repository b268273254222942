// SPDX-License-Identifier: GPL-3.0-or-later
// Describes spots (places of note in a model) for a geologist, declared in geomesh/geomodel/arrangement.hpp.
#include <cstdio>
#include <map>

#include "arrangement/diagnosis/diagnosis.hpp"

namespace geomesh::geomodel {
namespace {

std::string name_of(const std::vector<TriangulatedSurface>& surfaces, Index s) {
  return s < surfaces.size() ? std::string(to_string(surfaces[s].kind)) + " " + surfaces[s].name
                             : std::string("a surface");
}

std::string scaled(double value, double large, double unit, const char* small_name, const char* large_name) {
  char text[48];
  std::snprintf(text, sizeof text, "%.3g %s", value < large ? value : value / unit,
                value < large ? small_name : large_name);
  return text;
}
std::string length_text(double metres) { return scaled(metres, 1000, 1000, "m", "km"); }
std::string area_text(double square_metres) { return scaled(square_metres, 1e5, 1e6, "m2", "km2"); }

std::string near(const Spot& spot) { return " near " + arrangement::to_text(spot.place); }

std::string crossing_text(const Spot& spot, const std::vector<TriangulatedSurface>& surfaces) {
  const std::string a = name_of(surfaces, spot.surface_a);
  std::string text =
      a + (spot.surface_a == spot.surface_b ? " crosses itself" : " crosses " + name_of(surfaces, spot.surface_b));
  if (spot.area > 0) text += " over " + area_text(spot.area);
  return text + " along " + length_text(spot.measure) + near(spot) + " (" + std::to_string(spot.count) +
         " pairs of triangles)";
}

std::string overlap_text(const Spot& spot, const std::vector<TriangulatedSurface>& surfaces) {
  const std::string a = name_of(surfaces, spot.surface_a);
  const std::string what = spot.surface_a == spot.surface_b
                               ? a + " lies on itself (repeated or overlapping triangles)"
                               : a + " and " + name_of(surfaces, spot.surface_b) + " coincide";
  return what + " over " + area_text(spot.measure) + near(spot) + "; merged";
}

/// Describes where two surfaces were merged: by rounding if they were a few ulps apart, otherwise by the tolerance.
std::string merged_text(const Spot& spot, const std::vector<TriangulatedSurface>& surfaces) {
  const std::string a = name_of(surfaces, spot.surface_a);
  const std::string what = spot.surface_a == spot.surface_b
                               ? a + " was merged with itself"
                               : a + " and " + name_of(surfaces, spot.surface_b) + " were merged";
  return what + " over " + area_text(spot.measure) + near(spot) +
         ", where they lie too near each other to be kept apart; what lay between them is gone";
}

std::string vanished_text(const Spot& spot, const std::vector<TriangulatedSurface>& surfaces) {
  return name_of(surfaces, spot.surface_a) + ": " + std::to_string(spot.count) +
         " facets too thin to be kept were merged into their neighbours" + near(spot);
}

std::string border_text(const Spot& spot, const std::vector<TriangulatedSurface>& surfaces, std::size_t n_pieces) {
  const std::string a = name_of(surfaces, spot.surface_a);
  std::string where = length_text(spot.measure);
  if (n_pieces > 1) where.append(" in ").append(std::to_string(n_pieces)).append(" pieces, the longest");
  where += near(spot);
  if (spot.what == "gap")
    return a + (n_pieces > 1 ? " has gaps: holes with borders of " : " has a gap: a hole with a border of ") + where;
  const SurfaceKind kind = spot.surface_a < surfaces.size() ? surfaces[spot.surface_a].kind : SurfaceKind::surface;
  if (kind == SurfaceKind::fault) return a + " ends inside the model (tip line) along " + where;
  if (kind == SurfaceKind::horizon) return a + " dangles: it stops short inside the model along " + where;
  return a + " is open: free border of " + where;
}

bool is_border(const Spot& spot) { return spot.what.rfind("free border", 0) == 0 || spot.what == "gap"; }

}  // namespace

std::string describe(const Spot& spot, const std::vector<TriangulatedSurface>& surfaces) {
  if (spot.what == "crossing" || spot.what == "self-crossing") return crossing_text(spot, surfaces);
  if (spot.what == "overlap") return overlap_text(spot, surfaces);
  if (spot.what == "merged") return merged_text(spot, surfaces);
  if (spot.what == "vanished") return vanished_text(spot, surfaces);
  if (is_border(spot)) return border_text(spot, surfaces, 1);
  std::string text = name_of(surfaces, spot.surface_a) + ": " + spot.what;
  if (spot.surface_b != no_index) text.append(" ").append(name_of(surfaces, spot.surface_b));
  return text.append(", ").append(area_text(spot.measure)).append(near(spot));
}

std::vector<std::string> findings(const std::vector<Spot>& spots, const std::vector<TriangulatedSurface>& surfaces) {
  std::vector<std::string> lines;
  for (const Spot& spot : spots)
    if (spot.what == "crossing" || spot.what == "self-crossing") lines.push_back(describe(spot, surfaces));
  // Gaps are listed before dangling edges, with one line per surface that gives the longest piece first.
  std::map<std::pair<bool, Index>, std::pair<Spot, std::size_t>> borders;
  for (const Spot& spot : spots) {
    if (!is_border(spot)) continue;
    const auto [at, is_new] = borders.try_emplace({spot.what != "gap", spot.surface_a}, spot, spot.n_pieces);
    if (is_new) continue;
    at->second.first.measure += spot.measure;
    at->second.second += spot.n_pieces;
  }
  for (const auto& [key, entry] : borders) lines.push_back(border_text(entry.first, surfaces, entry.second));
  return lines;
}

}  // namespace geomesh::geomodel
