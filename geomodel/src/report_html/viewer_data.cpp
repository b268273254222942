// SPDX-License-Identifier: GPL-3.0-or-later
// The mesh as the page's viewer takes it, declared in report_html/viewer.hpp.
#include <algorithm>
#include <bit>
#include <nlohmann/json.hpp>
#include <vector>

#include "report_html/drawing.hpp"
#include "report_html/viewer.hpp"
#include "solver_mesh/face_sides.hpp"

namespace geomesh::geomodel::page {

namespace {

static_assert(std::endian::native == std::endian::little, "the page's arrays are little-endian");

template <class T>
std::string base64_of(const std::vector<T>& values) {
  return base64({reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)});
}

/// Elements that are drawn as the worst ones.
constexpr std::size_t most_worst_shown = 50;

/// The points that are used, numbered anew in the order of their first use.
class UsedPoints {
 public:
  UsedPoints(const ModelMesh& mesh, const Vec3& middle)
      : mesh_(mesh), middle_(middle), number_(mesh.points.size(), no_vertex) {}
  std::uint32_t operator()(VertexIndex v) {
    if (number_[v] == no_vertex) {
      number_[v] = static_cast<std::uint32_t>(coordinates_.size() / 3);
      const Vec3 p = mesh_.points[v] - middle_;
      for (std::size_t i = 0; i < 3; ++i) coordinates_.push_back(static_cast<float>(p[i]));
    }
    return number_[v];
  }
  const std::vector<float>& coordinates() const { return coordinates_; }

 private:
  const ModelMesh& mesh_;
  Vec3 middle_;
  std::vector<std::uint32_t> number_;
  std::vector<float> coordinates_;
};

/// Least dihedral angle in whole degrees.
std::uint8_t angle_of(const ModelMesh& mesh, std::size_t t) {
  const Tetrahedron& v = mesh.tetrahedra[t];
  const TetrahedronShape shape =
      tetrahedron_shape(mesh.points[v[0]], mesh.points[v[1]], mesh.points[v[2]], mesh.points[v[3]]);
  return static_cast<std::uint8_t>(shape.min_dihedral);
}

void add_faces(const ModelMesh& mesh, UsedPoints& used, nlohmann::ordered_json& data) {
  std::vector<std::uint32_t> corners;
  std::vector<std::int32_t> sides;
  std::vector<std::uint8_t> angles;
  std::vector<Triangle> faces;
  for (const ModelMesh::Face& face : mesh.faces) {
    for (const VertexIndex v : face.vertices) corners.push_back(used(v));
    sides.insert(sides.end(), {face.surface, face.region_minus, face.region_plus});
    faces.push_back(face.vertices);
  }
  for (const auto& at : tetrahedra_at_faces(mesh.tetrahedra, faces))
    for (const TetrahedronSide& side : at)
      angles.push_back(side.tetrahedron == no_side ? std::uint8_t{0} : angle_of(mesh, side.tetrahedron));
  data["corners"] = base64_of(corners);
  data["sides"] = base64_of(sides);
  data["angles"] = base64_of(angles);
}

void add_cells(const ModelMesh& mesh, UsedPoints& used, nlohmann::ordered_json& data) {
  std::vector<std::uint32_t> cells;
  std::vector<std::int32_t> regions;
  std::vector<std::uint8_t> angles;
  for (std::size_t t = 0; t < mesh.tetrahedra.size() && mesh.tetrahedra.size() <= most_cells_shown; ++t) {
    for (const VertexIndex v : mesh.tetrahedra[t]) cells.push_back(used(v));
    regions.push_back(mesh.tet_region[t]);
    angles.push_back(angle_of(mesh, t));
  }
  data["cells"] = base64_of(cells);
  data["cell_regions"] = base64_of(regions);
  data["cell_angles"] = base64_of(angles);
}

void add_curves(const ModelMesh& mesh, UsedPoints& used, nlohmann::ordered_json& data) {
  std::vector<std::uint32_t> ends;
  std::vector<std::int32_t> curves;
  for (const ModelMesh::CurveEdge& edge : mesh.curve_edges) {
    ends.insert(ends.end(), {used(edge.a), used(edge.b)});
    curves.push_back(edge.curve);
  }
  data["edges"] = base64_of(ends);
  data["edge_curves"] = base64_of(curves);
  data["curves"] = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < mesh.curves.size(); ++i) {
    const NamedCurve& c = mesh.curves[i];
    data["curves"].push_back({{"id", c.id},
                              {"name", c.name},
                              {"kind", c.kind},
                              {"colour", colour(mesh.regions.size() + mesh.surfaces.size() + i)}});
  }
}

void add_worst(const ModelMesh& mesh, const Vec3& middle, const QualityReport* quality, nlohmann::ordered_json& data) {
  data["worst"] = nlohmann::ordered_json::array();
  if (!quality) return;
  for (std::size_t i = 0; i < std::min(quality->measured.worst.size(), most_worst_shown); ++i) {
    const WorstElement& element = quality->measured.worst[i];
    std::vector<float> corners;
    for (const VertexIndex v : mesh.tetrahedra[element.tetrahedron])
      for (std::size_t k = 0; k < 3; ++k) corners.push_back(static_cast<float>(mesh.points[v][k] - middle[k]));
    data["worst"].push_back({{"angle", element.min_dihedral}, {"corners", corners}});
  }
}

}  // namespace

std::string base64(std::string_view bytes) {
  static constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  out.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t n = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) group = group << 8 | (k < n ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k) out += k <= n ? digits[group >> (18 - 6 * k) & 63u] : '=';
  }
  return out;
}

std::string viewer_data(const ModelMesh& mesh, const Box3& bounds, const QualityReport* quality) {
  const Vec3 middle = 0.5 * (bounds.min + bounds.max);
  UsedPoints used(mesh, middle);
  nlohmann::ordered_json data;
  data["size"] = {bounds.max.x - bounds.min.x, bounds.max.y - bounds.min.y, bounds.max.z - bounds.min.z};
  data["middle"] = {middle.x, middle.y, middle.z};
  data["unit"] = mesh.unit;
  data["stretch"] = vertical_exaggeration(bounds);
  add_faces(mesh, used, data);
  add_curves(mesh, used, data);
  add_cells(mesh, used, data);
  add_worst(mesh, middle, quality, data);
  data["points"] = base64_of(used.coordinates());
  data["regions"] = nlohmann::ordered_json::array();
  for (const Region& r : mesh.regions)
    data["regions"].push_back({{"id", r.id}, {"name", r.name}, {"colour", colour(static_cast<std::size_t>(r.id - 1))}});
  data["surfaces"] = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < mesh.surfaces.size(); ++i) {
    const NamedSurface& s = mesh.surfaces[i];
    data["surfaces"].push_back({{"id", s.id},
                                {"name", s.name},
                                {"box", s.kind == SurfaceKind::box},
                                {"colour", colour(mesh.regions.size() + i)}});
  }
  std::string text = data.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  // "</script>" in a name must not end the element that holds the text.
  for (std::size_t at = text.find("</"); at != std::string::npos; at = text.find("</", at + 3))
    text.replace(at, 2, "<\\/");
  return text;
}

}  // namespace geomesh::geomodel::page
