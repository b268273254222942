// SPDX-License-Identifier: GPL-3.0-or-later
// The mesh as the page's viewer takes it, declared in report_html/viewer.hpp.
#include <bit>
#include <nlohmann/json.hpp>
#include <vector>

#include "report_html/drawing.hpp"
#include "report_html/viewer.hpp"

namespace geomesh::geomodel::page {

namespace {

static_assert(std::endian::native == std::endian::little, "the page's arrays are little-endian");

template <class T>
std::string base64_of(const std::vector<T>& values) {
  return base64({reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)});
}

/// The points that faces use, numbered anew in the order of their first use.
struct UsedPoints {
  std::vector<float> coordinates;
  std::vector<std::uint32_t> corners;
};

UsedPoints used_points(const ModelMesh& mesh, const Vec3& middle) {
  UsedPoints used;
  std::vector<std::uint32_t> number(mesh.points.size(), no_vertex);
  for (const ModelMesh::Face& face : mesh.faces) {
    for (VertexIndex v : face.vertices) {
      if (number[v] == no_vertex) {
        number[v] = static_cast<std::uint32_t>(used.coordinates.size() / 3);
        const Vec3 p = mesh.points[v] - middle;
        for (std::size_t i = 0; i < 3; ++i) used.coordinates.push_back(static_cast<float>(p[i]));
      }
      used.corners.push_back(number[v]);
    }
  }
  return used;
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

std::string viewer_data(const ModelMesh& mesh, const Box3& bounds) {
  const UsedPoints used = used_points(mesh, 0.5 * (bounds.min + bounds.max));
  std::vector<std::int32_t> sides;
  for (const ModelMesh::Face& face : mesh.faces)
    sides.insert(sides.end(), {face.surface, face.region_minus, face.region_plus});
  nlohmann::ordered_json data;
  data["size"] = {bounds.max.x - bounds.min.x, bounds.max.y - bounds.min.y, bounds.max.z - bounds.min.z};
  data["stretch"] = vertical_exaggeration(bounds);
  data["points"] = base64_of(used.coordinates);
  data["corners"] = base64_of(used.corners);
  data["sides"] = base64_of(sides);
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
