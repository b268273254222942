// SPDX-License-Identifier: MIT
#include "tetrahedralize/roof_filling.hpp"

#include <algorithm>
#include <set>

#include "common/flat_map.hpp"
#include "common/geometry.hpp"
#include "common/sort_unique.hpp"
#include "geomesh/core/predicates.hpp"

namespace geomesh {

namespace {

using Mesh = ConstrainedTetrahedralization;

enum class RoofSide { above, below };

/// The space between a plane polygon and its roof, a triangulated surface with the same border that is lifted off the
/// plane, on one side of the polygon. Triangles of both are oriented as seen from that side.
class RoofOnSide {
 public:
  /// `star`: cells at the inner points of the roof (the surface to be lifted) on one side; `flat`: these points'
  /// places.
  RoofOnSide(Mesh& mesh, const RoofedPart& part, RoofSide side, std::vector<Index> star, const std::vector<Vec3>& flat)
      : mesh_(mesh), part_(part), side_(side), star_(std::move(star)), flat_(flat), inner_(part.inner) {}

  /// Gives the cells on one side of the roof copies of its inner points, because those on the other keep the originals.
  void take_own_points() {
    for (std::size_t i = 0; i < inner_.size(); ++i) inner_[i] = add_point(flat_[i]);
    for (const Index t : star_)
      for (VertexIndex& v : mesh_.tetrahedra[t]) v = on_this_side(v);
  }

  /// Lifts the roof off the plane. Its height is first half of that of the cells above it, and is halved until all
  /// cells are positive. Returns false if that does not succeed.
  bool lift() {
    const Vec3 up = (side_ == RoofSide::above ? 1 : -1) * unit_normal();
    const auto highest = std::max_element(part_.rise.begin(), part_.rise.end());
    const auto peak = static_cast<std::size_t>(highest - part_.rise.begin());
    const Vec3 base = flat_[peak];
    centre_ = add_point(base);
    for (double step = reach(base, up) / 2;; step /= 2) {
      for (std::size_t i = 0; i < inner_.size(); ++i)
        mesh_.points[inner_[i]] = flat_[i] + (step * part_.rise[i] / *highest) * up;
      if (mesh_.points[inner_[peak]] == base) return false;
      if (!are_positive_above()) continue;
      for (double part = 0.5; part > least_part; part /= 2) {
        mesh_.points[centre_] = base + part * step * up;
        if (are_positive_below()) return true;
      }
    }
  }

  /// Fills the space between the polygon and the lifted roof; returns the rows of new cells at the polygon's triangles.
  std::vector<Index> fill() {
    std::vector<Index> rows;
    for (const Triangle& t : part_.triangles) {
      rows.push_back(static_cast<Index>(mesh_.tetrahedra.size()));
      add_cell(under(turned(t)));
    }
    for (const Triangle& t : part_.roof) add_cell(under(roof_seen_from_below(t)));
    return rows;
  }

 private:
  static constexpr double least_part =
      1e-3;  ///< least height of the point between polygon and lifted roof, relative to the roof's height

  VertexIndex add_point(const Vec3& p) {
    mesh_.points.push_back(p);
    mesh_.input_vertex.push_back(no_vertex);
    mesh_.origin.push_back(VertexOrigin::inside);
    return static_cast<VertexIndex>(mesh_.points.size() - 1);
  }
  void add_cell(const Tetrahedron& t) {
    mesh_.tetrahedra.push_back(t);
    mesh_.component.push_back(mesh_.component[star_.front()]);
  }
  Vec3 unit_normal() const {
    Vec3 sum;
    for (const Triangle& t : part_.triangles)
      sum = sum + triangle_normal(mesh_.points[t[0]], mesh_.points[t[1]], mesh_.points[t[2]]);
    return (1 / length(sum)) * sum;
  }
  double reach(const Vec3& from, const Vec3& up) const {
    double out = 0;
    for (const Index t : star_)
      for (const VertexIndex v : mesh_.tetrahedra[t]) out = std::max(out, dot(mesh_.points[v] - from, up));
    return out;
  }
  Triangle turned(const Triangle& t) const { return side_ == RoofSide::above ? t : Triangle{t[0], t[2], t[1]}; }
  VertexIndex on_this_side(VertexIndex v) const {
    const auto at = std::lower_bound(part_.inner.begin(), part_.inner.end(), v);
    return at != part_.inner.end() && *at == v ? inner_[static_cast<std::size_t>(at - part_.inner.begin())] : v;
  }
  Triangle roof_seen_from_below(const Triangle& t) const {
    return turned({on_this_side(t[0]), on_this_side(t[2]), on_this_side(t[1])});
  }
  Tetrahedron under(const Triangle& t) const { return {t[0], t[1], t[2], centre_}; }
  bool is_positive(const Tetrahedron& t) const {
    const auto& p = mesh_.points;
    return orient3d(p[t[0]], p[t[1]], p[t[2]], p[t[3]]) == Sign::positive;
  }
  bool are_positive_above() const {
    return std::all_of(star_.begin(), star_.end(), [&](Index t) { return is_positive(mesh_.tetrahedra[t]); });
  }
  bool are_positive_below() const {
    return std::all_of(part_.triangles.begin(), part_.triangles.end(),
                       [&](const Triangle& t) { return is_positive(under(turned(t))); }) &&
           std::all_of(part_.roof.begin(), part_.roof.end(),
                       [&](const Triangle& t) { return is_positive(under(roof_seen_from_below(t))); });
  }

  Mesh& mesh_;
  const RoofedPart& part_;
  RoofSide side_;
  std::vector<Index> star_;
  const std::vector<Vec3>& flat_;
  std::vector<VertexIndex> inner_;  ///< for each point of part_.inner, its copy in the roof on one side of the plane
  VertexIndex centre_ = no_vertex;  ///< point between polygon and lifted roof, a vertex of all cells between them
};

/// Cells at the inner points of a roof (a triangulated plane polygon), and pairs that share a face off the roof.
class RoofStar {
 public:
  RoofStar(const Mesh& mesh, const RoofedPart& part, const std::vector<Index>& cells) {
    FaceMap of_roof, first;
    for (const Triangle& t : part.roof) of_roof.insert({t[0], t[1], t[2]}, 0);
    const auto is_inner = [&](VertexIndex v) { return std::binary_search(part.inner.begin(), part.inner.end(), v); };
    for (const Index t : cells) {
      const Tetrahedron& v = mesh.tetrahedra[t];
      for (const auto& f : face_vertices) {
        const FaceMap::Key face{v[f[0]], v[f[1]], v[f[2]]};
        if (std::none_of(face.begin(), face.end(), is_inner) || of_roof.find(face) != no_index) continue;
        const Index other = first.find(face);
        first.insert(face, t);
        if (other != no_index) pairs_.insert(pairs_.end(), {{other, t}, {t, other}});
      }
    }
    std::sort(pairs_.begin(), pairs_.end());
  }

  /// Returns the cells at inner points of a triangulated polygon on one side; `out` first has those at its triangles.
  std::vector<Index> from(std::vector<Index> out) const {
    std::set<Index> found(out.begin(), out.end());
    for (std::size_t i = 0; i < out.size(); ++i)
      for (auto pair = std::lower_bound(pairs_.begin(), pairs_.end(), std::array<Index, 2>{out[i], 0});
           pair != pairs_.end() && (*pair)[0] == out[i]; ++pair)
        if (found.insert((*pair)[1]).second) out.push_back((*pair)[1]);
    return out;
  }

 private:
  std::vector<std::array<Index, 2>> pairs_;  ///< pairs of cells that share a face off the roof, in both orders, sorted
};

}  // namespace

bool fill_under_roof(Mesh& mesh, const RoofedPart& part, const std::vector<Mesh::Face>& roof,
                     const std::vector<Index>& star, std::vector<Mesh::Face>& faces) {
  const RoofStar cells_at_roof(mesh, part, star);
  std::vector<Vec3> flat;
  for (const VertexIndex v : part.inner) flat.push_back(mesh.points[v]);
  std::array<std::vector<Index>, 2> at_roof, cells;
  for (const Mesh::Face& face : roof) {
    if (face.tetrahedron_above != no_index) at_roof[0].push_back(face.tetrahedron_above);
    if (face.tetrahedron_below != no_index) at_roof[1].push_back(face.tetrahedron_below);
  }
  for (const RoofSide side : {RoofSide::above, RoofSide::below}) {
    const std::size_t k = side == RoofSide::above ? 0 : 1;
    if (at_roof[k].empty()) continue;
    sort_unique(at_roof[k]);
    RoofOnSide one(mesh, part, side, cells_at_roof.from(at_roof[k]), flat);
    if (side == RoofSide::below && !at_roof[0].empty()) one.take_own_points();
    if (!one.lift()) return false;
    cells[k] = one.fill();
  }
  for (std::size_t i = 0; i < part.triangles.size(); ++i) {
    Mesh::Face face{part.as_given[i], part.facets[i], cells[1].empty() ? no_index : cells[1][i],
                    cells[0].empty() ? no_index : cells[0][i]};
    if (part.is_turned[i]) std::swap(face.tetrahedron_below, face.tetrahedron_above);
    faces.push_back(face);
  }
  return true;
}

}  // namespace geomesh
