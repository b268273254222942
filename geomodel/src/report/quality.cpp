// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/quality.hpp"

#include <cstdio>

#include "naming/region_facts.hpp"

namespace geomesh::geomodel {

namespace {

using json = nlohmann::ordered_json;

json distribution_json(const Distribution& d) {
  return {{"min", d.min}, {"max", d.max}, {"mean", d.mean}, {"first_percentile", d.first_percentile}};
}

json statistics_json(const ShapeStatistics& s, bool has_sizes) {
  json j{{"tetrahedra", s.n_tetrahedra},
         {"volume", s.volume},
         {"min_dihedral", distribution_json(s.min_dihedral)},
         {"max_dihedral", distribution_json(s.max_dihedral)},
         {"solid_angle", distribution_json(s.solid_angle)},
         {"radius_ratio", distribution_json(s.radius_ratio)},
         {"aspect", distribution_json(s.aspect)},
         {"mean_ratio", distribution_json(s.mean_ratio)},
         {"edge_length", distribution_json(s.edge_length)},
         {"share_below_10", s.share_below_10},
         {"share_above_24_85", s.share_above_24_85},
         {"min_dihedral_histogram", s.min_dihedral_histogram},
         {"dihedral_histogram", s.dihedral_histogram},
         {"radius_ratio_histogram", s.radius_ratio_histogram}};
  if (has_sizes) j["edge_size_histogram"] = s.edge_size_histogram;
  return j;
}

std::string degrees(double angle) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g degrees", angle);
  return text;
}

/// Names of the surfaces or curves that cause a poor element, because they meet or face each other.
class CauseNames {
 public:
  CauseNames(const PolygonSoup& soup, const ModelPlc& plc, const std::vector<TriangulatedSurface>& surfaces)
      : soup_(soup), plc_(plc), surfaces_(surfaces) {}

  std::string facet(Index f) const {
    const TriangulatedSurface& s = surfaces_[origins_of(soup_, plc_, f).front().surface];
    return std::string(s.kind == SurfaceKind::box ? "box side" : to_string(s.kind)) + " " + s.name;
  }
  std::string segment(Index s) const {
    const auto& curves = plc_.segment_curves[s];
    return curves.empty() ? "segment " + std::to_string(s) : "curve " + plc_.curves[curves.front()].name;
  }
  /// Returns a text such as "between A and B", or "between two facets of A" if both are the same.
  std::string between(const WorstElement& w) const {
    const std::string a = w.segment_a != no_index ? segment(w.segment_a)
                          : w.facet_a != no_index ? facet(w.facet_a)
                                                  : "";
    const std::string b = w.segment_b != no_index ? segment(w.segment_b)
                          : w.facet_b != no_index ? facet(w.facet_b)
                                                  : "";
    if (a.empty() || b.empty()) return "at " + a + b;
    return a == b ? "between two parts of " + a : "between " + a + " and " + b;
  }

 private:
  const PolygonSoup& soup_;
  const ModelPlc& plc_;
  const std::vector<TriangulatedSurface>& surfaces_;
};

}  // namespace

std::string cause_in_words(const WorstElement& w, bool refined, const PolygonSoup& soup, const ModelPlc& plc,
                           const std::vector<TriangulatedSurface>& surfaces) {
  const CauseNames names(soup, plc, surfaces);
  switch (w.cause) {
    case ShapeCause::input_angle:
      return "input angle of " + degrees(w.forcing_angle) + " " + names.between(w);
    case ShapeCause::thin_gap:
      return "gap of " + to_text(w.gap) + " " + names.between(w) + ", thinner than a quarter of the requested size";
    case ShapeCause::free:
      break;
  }
  return refined ? "nothing in the input forces it" : "no points were added for shape: the mesh was not refined";
}

namespace {

const char* cause_in_words(EdgeCause cause) {
  switch (cause) {
    case EdgeCause::input_angle:
      return "input angle";
    case EdgeCause::thin_gap:
      return "thin gap";
    case EdgeCause::near_curves:
      return "near curves";
    case EdgeCause::bends:
      return "bends of a curve";
    case EdgeCause::near_forced:
      return "near an edge that the input forces";
    case EdgeCause::free:
      break;
  }
  return "nothing in the input forces it";
}

json short_edges_json(const ShortEdges& edges) {
  json worst = json::array();
  for (const ShortEdge& e : edges.worst) {
    json edge{{"length", e.length},
              {"size", e.size},
              {"place", {e.place.x, e.place.y, e.place.z}},
              {"forced", e.cause != EdgeCause::free},
              {"cause", cause_in_words(e.cause)}};
    if (e.cause == EdgeCause::input_angle) edge["angle"] = e.forcing_angle;
    if (e.cause == EdgeCause::thin_gap) edge["gap"] = e.gap;
    worst.push_back(std::move(edge));
  }
  return {{"edges", edges.n}, {"forced", edges.n_forced}, {"worst", std::move(worst)}};
}

}  // namespace

json quality_json(const QualityReport& quality, const ModelMesh* mesh) {
  const MeshQuality& q = quality.measured;
  const auto region_name = [&](std::size_t row) {
    return mesh && row < mesh->regions.size() ? mesh->regions[row].name : std::string();
  };
  json worst = json::array(), regions = json::array();
  for (std::size_t i = 0; i < q.worst.size(); ++i) {
    const WorstElement& w = q.worst[i];
    json element{{"tetrahedron", w.tetrahedron},
                 {"min_dihedral", w.min_dihedral},
                 {"max_dihedral", w.max_dihedral},
                 {"place", {w.place.x, w.place.y, w.place.z}}};
    if (mesh) {
      const std::int32_t region = mesh->tet_region[w.tetrahedron];
      element["region"] = region;
      element["region_name"] = region_name(static_cast<std::size_t>(region - 1));
    }
    element["forced"] = w.cause != ShapeCause::free;
    element["cause"] = quality.causes[i];
    worst.push_back(std::move(element));
  }
  for (std::size_t r = 0; r < q.per_component.size(); ++r) {
    json region{{"region", r + 1}, {"name", region_name(r)}};
    region.update(statistics_json(q.per_component[r], quality.has_sizes));
    regions.push_back(std::move(region));
  }
  json root{{"min_dihedral", q.whole.min_dihedral.min},
            {"max_dihedral", q.whole.max_dihedral.max},
            {"min_radius_ratio", q.whole.radius_ratio.min},
            {"min_dihedral_histogram", q.whole.min_dihedral_histogram},
            {"dihedral_histogram", q.whole.dihedral_histogram},
            {"radius_ratio_histogram", q.whole.radius_ratio_histogram},
            {"below_8_degrees", {{"tetrahedra", q.n_bad}, {"forced", q.n_bad_forced}}},
            {"whole", statistics_json(q.whole, quality.has_sizes)},
            {"regions", std::move(regions)},
            {"worst", std::move(worst)}};
  if (quality.has_sizes) root["short_edges"] = short_edges_json(quality.short_edges);
  return root;
}

json refinement_json(const RefineStatistics& s, const QualityReport* quality) {
  return {{"estimated_tetrahedra", s.estimated_elements},
          {"runs", s.runs},
          {"off_before", s.off_before},
          {"points_on_curves", s.points_on_curves},
          {"points_on_surfaces", s.points_on_surfaces},
          {"points_inside", s.points_inside},
          {"quality_measure", name_of(s.quality_measure)},
          {"worst_shape_before", s.worst_shape_before},
          {"worst_shape_after", s.worst_shape_after},
          {"collapses", s.collapses},
          {"edge_removals", s.edge_removals},
          {"face_removals", s.face_removals},
          {"smoothing_moves", s.smoothing_moves},
          {"improving_insertions", s.improving_insertions},
          {"passes", s.passes},
          {"sizes_on_surfaces", s.sizes_on_surfaces},
          {"edges_within_size", quality ? quality->measured.whole.share_within_size() : 1.0},
          {"deviation_result_to_input", s.deviation_result_to_input},
          {"deviation_input_to_result", s.deviation_input_to_result},
          {"out_of_time", s.out_of_time}};
}

}  // namespace geomesh::geomodel
