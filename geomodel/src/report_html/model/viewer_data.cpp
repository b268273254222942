// SPDX-License-Identifier: GPL-3.0-or-later
// Converts the mesh to the JSON data of the HTML report's viewer, declared in viewer.hpp.
#include <algorithm>
#include <bit>
#include <nlohmann/json.hpp>
#include <vector>

#include "report_html/model/png.hpp"
#include "report_html/model/viewer.hpp"
#include "solver_mesh/face_sides.hpp"

namespace geomesh::geomodel::page {

namespace {

static_assert(std::endian::native == std::endian::little, "the page's arrays are little-endian");

using Json = nlohmann::ordered_json;

template <class T>
std::string base64_of(const std::vector<T>& values) {
  return base64({reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)});
}

/// Largest number of poor elements that the viewer highlights.
constexpr std::size_t most_worst_shown = 50;

class UsedPoints {
 public:
  UsedPoints(const ModelMesh& mesh, const Vec3& middle)
      : mesh_(mesh), middle_(middle), number_(mesh.points.size(), no_vertex) {}
  std::uint32_t operator()(VertexIndex v) {
    if (number_[v] == no_vertex) {
      number_[v] = static_cast<std::uint32_t>(rows_.size());
      rows_.push_back(v);
      const Vec3 p = mesh_.points[v] - middle_;
      for (std::size_t i = 0; i < 3; ++i) coordinates_.push_back(static_cast<float>(p[i]));
    }
    return number_[v];
  }
  const std::vector<float>& coordinates() const { return coordinates_; }
  const std::vector<VertexIndex>& rows() const { return rows_; }

 private:
  const ModelMesh& mesh_;
  Vec3 middle_;
  std::vector<std::uint32_t> number_;
  std::vector<VertexIndex> rows_;
  std::vector<float> coordinates_;
};

void add_faces(const ModelMesh& mesh, const DrawnMesh& drawn, UsedPoints& used, Json& data) {
  std::vector<std::uint32_t> corners;
  std::vector<std::int32_t> sides;
  for (const std::uint32_t f : drawn.faces) {
    const ModelMesh::Face& face = mesh.faces[f];
    for (const VertexIndex v : face.vertices) corners.push_back(used(drawn.corner[v]));
    sides.insert(sides.end(), {face.surface, face.region_minus, face.region_plus});
  }
  data["corners"] = base64_of(corners);
  data["sides"] = base64_of(sides);
}

void add_cells(const ModelMesh& mesh, const DrawnMesh& drawn, UsedPoints& used, Json& data) {
  std::vector<std::uint32_t> cells;
  std::vector<std::int32_t> regions;
  for (const std::uint32_t t : drawn.cells) {
    for (const VertexIndex v : mesh.tetrahedra[t]) cells.push_back(used(drawn.corner[v]));
    regions.push_back(mesh.tet_region[t]);
  }
  data["cells"] = base64_of(cells);
  data["cell_regions"] = base64_of(regions);
}

/// Adds the quantities by which the viewer colours the mesh; a face gets the values of the tetrahedra on both sides.
void add_quantities(const ModelMesh& mesh, const DrawnMesh& drawn, const UsedPoints& used, Json& data) {
  std::vector<Triangle> faces;
  for (const std::uint32_t f : drawn.faces) faces.push_back(mesh.faces[f].vertices);
  const auto at_faces = tetrahedra_at_faces(mesh.tetrahedra, faces);
  data["quantities"] = Json::array();
  for (const Quantity& q : quantities_of(mesh)) {
    Json one{{"name", q.name}, {"unit", q.unit}, {"low", q.low}, {"high", q.high}};
    std::vector<std::uint8_t> of_faces, of_cells, of_points;
    if (q.is_of_points) {
      for (const VertexIndex v : used.rows()) of_points.push_back(q.steps[v]);
      one["points"] = base64_of(of_points);
    } else {
      for (const auto& at : at_faces)
        for (const TetrahedronSide& side : at)
          of_faces.push_back(side.tetrahedron == no_side ? Quantity::not_known : q.steps[side.tetrahedron]);
      for (const std::uint32_t t : drawn.cells) of_cells.push_back(q.steps[t]);
      one["faces"] = base64_of(of_faces);
      one["cells"] = base64_of(of_cells);
    }
    data["quantities"].push_back(std::move(one));
  }
  data["angle_colours"] = Json::array();
  for (const Colour& c : angle_colours) data["angle_colours"].push_back(to_hex(c));
}

void add_curves(const ModelMesh& mesh, const MeshColours& colours, UsedPoints& used, Json& data) {
  std::vector<std::uint32_t> ends;
  std::vector<std::int32_t> curves;
  for (const ModelMesh::CurveEdge& edge : mesh.curve_edges) {
    ends.insert(ends.end(), {used(edge.a), used(edge.b)});
    curves.push_back(edge.curve);
  }
  data["edges"] = base64_of(ends);
  data["edge_curves"] = base64_of(curves);
  data["curves"] = Json::array();
  for (std::size_t i = 0; i < mesh.curves.size(); ++i) {
    const NamedCurve& c = mesh.curves[i];
    data["curves"].push_back({{"id", c.id},
                              {"name", c.name},
                              {"kind", c.kind},
                              {"length", c.length},
                              {"colour", to_hex(colours.curves[i])}});
  }
}

void add_worst(const ModelMesh& mesh, const Vec3& middle, const QualityReport* quality, Json& data) {
  data["worst"] = Json::array();
  if (!quality) return;
  for (std::size_t i = 0; i < std::min(quality->measured.worst.size(), most_worst_shown); ++i) {
    const WorstElement& element = quality->measured.worst[i];
    std::vector<float> corners;
    for (const VertexIndex v : mesh.tetrahedra[element.tetrahedron])
      for (std::size_t k = 0; k < 3; ++k) corners.push_back(static_cast<float>(mesh.points[v][k] - middle[k]));
    data["worst"].push_back({{"angle", element.min_dihedral}, {"corners", corners}});
  }
}

void add_names(const ModelMesh& mesh, const MeshColours& colours, const Vec3& middle, Json& data) {
  data["regions"] = Json::array();
  for (std::size_t i = 0; i < mesh.regions.size(); ++i) {
    const Region& r = mesh.regions[i];
    data["regions"].push_back({{"id", r.id},
                               {"name", r.name},
                               {"volume", r.volume},
                               {"tetrahedra", r.n_tetrahedra},
                               {"inside", r.inside},
                               {"colour", to_hex(colours.regions[i])}});
  }
  data["surfaces"] = Json::array();
  for (std::size_t i = 0; i < mesh.surfaces.size(); ++i) {
    const NamedSurface& s = mesh.surfaces[i];
    data["surfaces"].push_back({{"id", s.id},
                                {"name", s.name},
                                {"kind", std::string(to_string(s.kind))},
                                {"area", s.area},
                                {"colour", to_hex(colours.surfaces[i])}});
  }
  data["places"] = Json::array();
  for (const ModelMesh::MarkedPoint& m : mesh.marked_points) {
    const Vec3 p = mesh.points[m.v] - middle;
    data["places"].push_back({{"name", m.name}, {"at", {p.x, p.y, p.z}}});
  }
}

}  // namespace

std::string viewer_data(const ModelMesh& mesh, const Box3& bounds, const MeshColours& colours,
                        const QualityReport* quality, const DrawingLimits& limits) {
  const Vec3 middle = 0.5 * (bounds.min + bounds.max);
  const double stretch = vertical_exaggeration(bounds);
  const DrawnMesh drawn = drawn_mesh(mesh, stretch, limits);
  UsedPoints used(mesh, middle);
  Json data;
  data["name"] = mesh.name;
  data["size"] = {bounds.max.x - bounds.min.x, bounds.max.y - bounds.min.y, bounds.max.z - bounds.min.z};
  data["middle"] = {middle.x, middle.y, middle.z};
  data["unit"] = mesh.unit;
  data["stretch"] = stretch;
  const Vec2 corner = open_corner(mesh, bounds);
  data["corner"] = {corner.x - middle.x, corner.y - middle.y};
  add_faces(mesh, drawn, used, data);
  add_curves(mesh, colours, used, data);
  add_cells(mesh, drawn, used, data);
  data["points"] = base64_of(used.coordinates());
  add_quantities(mesh, drawn, used, data);
  add_worst(mesh, middle, quality, data);
  add_names(mesh, colours, middle, data);
  std::string text = data.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  // "</script>" in a name must not end the HTML element that contains the text.
  for (std::size_t at = text.find("</"); at != std::string::npos; at = text.find("</", at + 3))
    text.replace(at, 2, "<\\/");
  return text;
}

}  // namespace geomesh::geomodel::page
