// SPDX-License-Identifier: GPL-3.0-or-later
#include "report_html/model/draw_model.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "report_html/model/section.hpp"

namespace geomesh::geomodel::page {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr std::size_t picture_width = 900, picture_height = 580, oversampling = 2;
constexpr double azimuth = 215 * pi / 180, elevation = 28 * pi / 180, view_angle = 25 * pi / 180;
constexpr Colour background{0.965, 0.965, 0.957};

Vec3 normalised(const Vec3& v) { return (1 / std::max(std::sqrt(dot(v, v)), 1e-300)) * v; }

/// A perspective camera whose view contains the whole of a box.
class Camera {
 public:
  Camera(const Box3& bounds, double stretch)
      : stretch_(stretch),
        middle_(stretched(0.5 * (bounds.min + bounds.max))),
        back_{std::sin(azimuth) * std::cos(elevation), std::cos(azimuth) * std::cos(elevation), std::sin(elevation)},
        right_(normalised(cross({0, 0, 1}, back_))),
        up_(cross(back_, right_)) {
    const double tall = std::tan(view_angle / 2), wide = tall * picture_width / picture_height;
    for (unsigned corner = 0; corner < 8; ++corner) {
      const Vec3 p = stretched({corner & 1u ? bounds.max.x : bounds.min.x, corner & 2u ? bounds.max.y : bounds.min.y,
                                corner & 4u ? bounds.max.z : bounds.min.z}) -
                     middle_;
      constexpr double margin = 1.06;
      const double need = margin * std::max(std::abs(dot(p, right_)) / wide, std::abs(dot(p, up_)) / tall);
      distance_ = std::max(distance_, need + dot(p, back_));
    }
    scale_ = oversampling * picture_height / 2.0 / tall;
  }

  Vec3 stretched(const Vec3& p) const { return {p.x, p.y, p.z * stretch_}; }
  /// Projects p to the picture. Returns pixels from the left and from the top, and the reciprocal of the distance.
  Vec3 seen(const Vec3& p) const {
    const Vec3 q = stretched(p) - middle_;
    const double near = 1 / std::max(distance_ - dot(q, back_), 1e-300);
    return {oversampling * picture_width / 2.0 + scale_ * near * dot(q, right_),
            oversampling * picture_height / 2.0 - scale_ * near * dot(q, up_), near};
  }
  /// Returns the brightness of a face with these corners in light from above, slightly from the left.
  double light(const Vec3& a, const Vec3& b, const Vec3& c) const {
    Vec3 n = normalised(cross(stretched(b) - stretched(a), stretched(c) - stretched(a)));
    if (dot(n, back_) < 0) n = -1.0 * n;
    constexpr double of_sides = 0.83, from_above = 0.17, from_left = 0.11;
    return std::min(1.0, of_sides + from_above * n.z - from_left * dot(n, right_));
  }

 private:
  double stretch_;
  Vec3 middle_, back_, right_, up_;
  double distance_ = 0, scale_ = 1;
};

/// A function that returns whether the picture shows the model at (x, y), or leaves it out to open a view inside.
using Kept = std::function<bool(double x, double y)>;

class Canvas {
 public:
  explicit Canvas(const Camera& camera)
      : camera_(camera), near_(wide * tall, 0.0F), colour_(wide * tall, bytes_of(background)) {}

  void fill(const std::vector<Vec3>& polygon, const Colour& colour, const Kept& kept) {
    for (std::size_t i = 2; i < polygon.size(); ++i) {
      const std::array<Vec3, 3> corners{polygon[0], polygon[i - 1], polygon[i]};
      triangle(corners, {true, i + 1 == polygon.size(), i == 2}, colour, kept);
    }
  }

  Picture picture() const {
    Picture out{picture_width, picture_height, {}};
    for (std::size_t y = 0; y < picture_height; ++y)
      for (std::size_t x = 0; x < picture_width; ++x)
        for (std::size_t k = 0; k < 3; ++k) {
          unsigned sum = 0;
          for (std::size_t j = 0; j < oversampling; ++j)
            for (std::size_t i = 0; i < oversampling; ++i)
              sum += colour_[(oversampling * y + j) * wide + oversampling * x + i][k];
          out.rgb.push_back(static_cast<std::uint8_t>(sum / (oversampling * oversampling)));
        }
    return out;
  }

 private:
  using Bytes = std::array<std::uint8_t, 3>;
  static Bytes bytes_of(const Colour& c) {
    const auto byte = [](double v) { return static_cast<std::uint8_t>(std::lround(255 * v)); };
    return {byte(c[0]), byte(c[1]), byte(c[2])};
  }
  static constexpr std::size_t wide = oversampling * picture_width, tall = oversampling * picture_height;

  /// Returns how dark the edges of a triangle are drawn, by its mean height in pixels; 0 if it is so small that its
  /// edges would merge.
  static double edge_strength(double height) { return 0.42 * std::clamp((height / oversampling - 3) / 22, 0.0, 1.0); }

  /// Draws a triangle. `is_edge[k]` is whether the side opposite corner k is a mesh edge.
  void triangle(const std::array<Vec3, 3>& p, const std::array<bool, 3>& is_edge, const Colour& colour,
                const Kept& kept) {
    const std::array<Vec3, 3> s{camera_.seen(p[0]), camera_.seen(p[1]), camera_.seen(p[2])};
    const double area = (s[1].x - s[0].x) * (s[2].y - s[0].y) - (s[1].y - s[0].y) * (s[2].x - s[0].x);
    if (!(std::abs(area) > 1e-9)) return;
    std::array<double, 3> height{};  // height of each corner of the triangle above the opposite side, in pixels
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 &a = s[(k + 1) % 3], &b = s[(k + 2) % 3];
      height[k] = std::abs(area) / std::max(std::hypot(b.x - a.x, b.y - a.y), 1e-9);
    }
    const double light = camera_.light(p[0], p[1], p[2]),
                 dark = edge_strength(3 / (1 / height[0] + 1 / height[1] + 1 / height[2]));
    const auto pixel = [](double v, std::size_t end) {
      return static_cast<std::size_t>(std::clamp(v, 0.0, static_cast<double>(end)));
    };
    const std::size_t x0 = pixel(std::min({s[0].x, s[1].x, s[2].x}), wide),
                      x1 = pixel(std::max({s[0].x, s[1].x, s[2].x}) + 1, wide),
                      y0 = pixel(std::min({s[0].y, s[1].y, s[2].y}), tall),
                      y1 = pixel(std::max({s[0].y, s[1].y, s[2].y}) + 1, tall);
    for (std::size_t y = y0; y < y1; ++y)
      for (std::size_t x = x0; x < x1; ++x) {
        const double px = static_cast<double>(x) + 0.5, py = static_cast<double>(y) + 0.5;
        std::array<double, 3> w{};
        for (std::size_t k = 0; k < 3; ++k) {
          const Vec3 &a = s[(k + 1) % 3], &b = s[(k + 2) % 3];
          w[k] = ((b.x - a.x) * (py - a.y) - (b.y - a.y) * (px - a.x)) / area;
        }
        if (w[0] < 0 || w[1] < 0 || w[2] < 0) continue;
        const double near = w[0] * s[0].z + w[1] * s[1].z + w[2] * s[2].z;
        float& before = near_[y * wide + x];
        if (near <= static_cast<double>(before) || !kept(across(w, s, p, 0) / near, across(w, s, p, 1) / near))
          continue;
        before = static_cast<float>(near);
        double shade = light;
        for (std::size_t k = 0; k < 3; ++k)
          if (is_edge[k] && w[k] * height[k] < 0.5 * oversampling) shade = light * (1 - dark);
        colour_[y * wide + x] = bytes_of({shade * colour[0], shade * colour[1], shade * colour[2]});
      }
  }
  static double across(const std::array<double, 3>& w, const std::array<Vec3, 3>& s, const std::array<Vec3, 3>& p,
                       std::size_t axis) {
    return w[0] * s[0].z * p[0][axis] + w[1] * s[1].z * p[1][axis] + w[2] * s[2].z * p[2][axis];
  }

  const Camera& camera_;
  std::vector<float> near_;  ///< depth buffer: for each pixel, the reciprocal of the distance of the drawn surface
  std::vector<Bytes> colour_;
};

/// Draws the cut through the elements in the plane `axis = at`, which is a wall of the opened corner.
void draw_wall(Canvas& canvas, const ModelMesh& mesh, std::size_t axis, double at, const std::vector<Colour>& colours,
               const Kept& kept) {
  for (const Section::Cut& cut : cut_mesh(mesh, axis, at).cuts) {
    std::vector<Vec3> polygon;
    for (const Vec2& p : cut.polygon) polygon.push_back(axis == 0 ? Vec3{at, p.x, p.y} : Vec3{p.x, at, p.y});
    canvas.fill(polygon, colours[static_cast<std::size_t>(cut.region - 1)], kept);
  }
}

}  // namespace

Picture draw_model(const ModelMesh& mesh, const Vec2& corner, double stretch, const std::vector<Colour>& colours) {
  Box3 bounds;
  for (const Vec3& p : mesh.points) bounds.add(p);
  const Camera camera(bounds, stretch);
  Canvas canvas(camera);
  for (const ModelMesh::Face& face : mesh.faces) {
    if (face.region_minus != 0 && face.region_plus != 0) continue;
    const auto row = static_cast<std::size_t>(std::max(face.region_minus, face.region_plus) - 1);
    canvas.fill({mesh.points[face.vertices[0]], mesh.points[face.vertices[1]], mesh.points[face.vertices[2]]},
                colours[row], [&](double x, double y) { return x >= corner.x || y >= corner.y; });
  }
  draw_wall(canvas, mesh, 0, corner.x, colours, [&](double, double y) { return y < corner.y; });
  draw_wall(canvas, mesh, 1, corner.y, colours, [&](double x, double) { return x < corner.x; });
  return canvas.picture();
}

}  // namespace geomesh::geomodel::page
