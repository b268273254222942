// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrangement/model/ingest.hpp"

#include <bit>
#include <cmath>
#include <cstdio>
#include <sstream>

#include "geomesh/core/error.hpp"
#include "geomesh/core/predicates.hpp"

namespace geomesh::geomodel::arrangement {
namespace {

/// Open-addressing hash table from coordinates to vertices, in which -0 equals 0.
class PointTable {
 public:
  PointTable(std::vector<Vec3>& points, std::size_t expected)
      : points_(points), slots_(std::bit_ceil(2 * expected + 16), no_vertex), mask_(slots_.size() - 1) {}

  std::pair<VertexIndex, bool> insert(const Vec3& given) {
    const Vec3 p{given.x + 0.0, given.y + 0.0, given.z + 0.0};
    std::size_t slot = hash(p) & mask_;
    while (slots_[slot] != no_vertex) {
      if (points_[slots_[slot]] == p) return {slots_[slot], false};
      slot = (slot + 1) & mask_;
    }
    slots_[slot] = static_cast<VertexIndex>(points_.size());
    points_.push_back(p);
    return {slots_[slot], true};
  }

 private:
  static std::uint64_t hash(const Vec3& p) {
    std::uint64_t h = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      h = (h ^ std::bit_cast<std::uint64_t>(p[i])) * 0x9E3779B97F4A7C15ull;
      h ^= h >> 32;
    }
    return h;
  }
  std::vector<Vec3>& points_;
  std::vector<VertexIndex> slots_;
  std::size_t mask_;
};

void refuse_bad_points(const std::vector<Vec3>& points, const std::string& what) {
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!std::isfinite(points[i].x) || !std::isfinite(points[i].y) || !std::isfinite(points[i].z)) {
      std::ostringstream text;
      text << what << ": coordinates of point " << i << " are not finite (" << points[i].x << ", " << points[i].y
           << ", " << points[i].z << "); correct or remove the point and its triangles";
      throw Error(ErrorKind::invalid_input, text.str(), {{}, {}, {static_cast<VertexIndex>(i)}, {}});
    }
  if (!exponents_are_safe(points))
    throw Error(ErrorKind::invalid_input,
                what + ": coordinates too large or too small in magnitude for exact arithmetic; use another unit");
}

bool wholly_outside(const Complex& complex, const Triangle& t, const Box3& box) {
  for (std::size_t i = 0; i < 3; ++i) {
    bool below = true, above = true;
    for (const VertexIndex v : t) {
      below &= complex.points[v][i] < box.min[i];
      above &= complex.points[v][i] > box.max[i];
    }
    if (below || above) return true;
  }
  return false;
}

class Ingestion {
 public:
  Ingestion(const SurfaceList& surfaces, const std::optional<Box3>& box, std::size_t n_points)
      : surfaces_(surfaces), box_(box), table_(result_.complex.points, n_points) {}

  void add_surface(Index row) {
    const TriangulatedSurface& surface = surfaces_[row];
    refuse_bad_points(surface.points, "surface " + surface.name);
    auto& vertices = result_.vertex_of_point.emplace_back();
    vertices.reserve(surface.points.size());
    for (const Vec3& p : surface.points) vertices.push_back(add_point(p, row < surfaces_.given.size()));
    std::size_t n_degenerate = 0;
    Vec3 place;
    for (Index t = 0; t < surface.triangles.size(); ++t) {
      const Triangle& rows = surface.triangles[t];
      for (const VertexIndex v : rows)
        if (v >= surface.points.size())
          throw Error(ErrorKind::invalid_input, "surface " + surface.name + ": triangle " + std::to_string(t) +
                                                    " names point " + std::to_string(v) + ", but there are only " +
                                                    std::to_string(surface.points.size()));
      if (!add_triangle(row, t, {vertices[rows[0]], vertices[rows[1]], vertices[rows[2]]}) && n_degenerate++ == 0)
        place = surface.points[rows[0]];
    }
    if (n_degenerate > 0)
      result_.warnings.push_back("surface " + surface.name + ": " + std::to_string(n_degenerate) +
                                 " triangle(s) without area were left out, the first near " + to_text(place));
  }

  void add_polyline(const Polyline& line, Index row) {
    refuse_bad_points(line.points, "polyline " + line.name);
    VertexIndex previous = no_vertex;
    for (const Vec3& p : line.points) {
      const VertexIndex v = add_point(p, false);
      if (previous != no_vertex && previous != v) result_.complex.segments.push_back({previous, v, row});
      previous = v;
    }
  }

  void add_isolated(const NamedPoint& point, Index row) {
    refuse_bad_points({point.point}, "point " + point.name);
    const Vec3& p = point.point;
    for (std::size_t i = 0; box_ && i < 3; ++i)
      if (p[i] < box_->min[i] || p[i] > box_->max[i]) {
        result_.warnings.push_back("point " + point.name + " lies outside the box near " + to_text(p) +
                                   " and is left out");
        return;
      }
    result_.complex.isolated_points.push_back({add_point(p, false), row});
  }

  Ingested finish() {
    result_.complex.dirty_facet.assign(result_.complex.facets.size(), 1);
    result_.complex.dirty_segment.assign(result_.complex.segments.size(), 1);
    return std::move(result_);
  }

 private:
  VertexIndex add_point(const Vec3& p, bool of_input_surface) {
    const auto [v, is_new] = table_.insert(p);
    if (is_new) result_.complex.input_point.push_back(of_input_surface ? n_input_points_ : no_index);
    n_input_points_ += of_input_surface;
    return v;
  }

  /// Adds a triangle of a surface. Returns false if the triangle has no area.
  bool add_triangle(Index surface, Index row, const Triangle& t) {
    Complex& complex = result_.complex;
    const Vec3 &a = complex.points[t[0]], &b = complex.points[t[1]], &c = complex.points[t[2]];
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0] || projection_of(a, b, c).sign == Sign::zero) return false;
    if (surface < surfaces_.given.size()) {
      if (box_ && wholly_outside(complex, t, *box_)) {
        result_.area_outside.resize(surfaces_.given.size(), 0);
        result_.area_outside[surface] += area(a, b, c);
        return true;
      }
    }
    complex.facets.push_back(t);
    const Origin origin{surface, row, false};
    complex.origins.push({&origin, 1});
    return true;
  }

  const SurfaceList& surfaces_;
  const std::optional<Box3>& box_;
  Ingested result_;
  PointTable table_;
  Index n_input_points_ = 0;
};

}  // namespace

Ingested ingest(const SurfaceList& surfaces, const std::vector<Polyline>& polylines,
                const std::vector<NamedPoint>& points, const std::optional<Box3>& box) {
  std::size_t n_points = points.size();
  for (std::size_t s = 0; s < surfaces.size(); ++s) n_points += surfaces[s].points.size();
  for (const Polyline& line : polylines) n_points += line.points.size();
  if (n_points >= no_index / 4) throw Error(ErrorKind::invalid_input, "more points than this program can number");
  Ingestion ingestion(surfaces, box, n_points);
  for (Index s = 0; s < surfaces.size(); ++s) ingestion.add_surface(s);
  for (Index l = 0; l < polylines.size(); ++l) ingestion.add_polyline(polylines[l], l);
  for (Index p = 0; p < points.size(); ++p) ingestion.add_isolated(points[p], p);
  Ingested result = ingestion.finish();
  result.area_outside.resize(surfaces.given.size(), 0);
  return result;
}

std::vector<TriangulatedSurface> make_box_sides(const Box3& box) {
  static constexpr std::array<const char*, 6> names{"xmin", "xmax", "ymin", "ymax", "zmin", "zmax"};
  std::vector<TriangulatedSurface> sides;
  for (std::size_t side = 0; side < 6; ++side) {
    const std::size_t axis = side / 2, i = (axis + 1) % 3, j = (axis + 2) % 3;
    const bool at_max = side % 2 == 1;
    TriangulatedSurface& s = sides.emplace_back();
    s.name = names[side];
    s.kind = SurfaceKind::box;
    for (std::size_t corner = 0; corner < 4; ++corner) {
      Vec3 p;
      p[axis] = at_max ? box.max[axis] : box.min[axis];
      p[i] = corner == 1 || corner == 2 ? box.max[i] : box.min[i];
      p[j] = corner >= 2 ? box.max[j] : box.min[j];
      s.points.push_back(p);
    }
    if (at_max)
      s.triangles = {{0, 1, 2}, {0, 2, 3}};
    else
      s.triangles = {{0, 2, 1}, {0, 3, 2}};
  }
  return sides;
}

std::vector<TriangulatedSurface> SurfaceList::all() const {
  std::vector<TriangulatedSurface> result;
  for (std::size_t s = 0; s < size(); ++s) {
    result.emplace_back().name = (*this)[s].name;
    result.back().kind = (*this)[s].kind;
  }
  return result;
}

std::string to_text(const Vec3& p) {
  std::array<char, 128> text;
  std::snprintf(text.data(), text.size(), "(%.10g, %.10g, %.10g)", p.x, p.y, p.z);
  return text.data();
}

}  // namespace geomesh::geomodel::arrangement
