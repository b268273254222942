// SPDX-License-Identifier: MIT
#include "recover/steiner_removal/star_sectors.hpp"

#include "common/geometry.hpp"
#include "common/sort_unique.hpp"
#include "recover/model/recovery_budget.hpp"

namespace geomesh::recover {

namespace {

using RimEdges = std::map<DirectedEdge, std::size_t>;

/// Returns for each directed edge opposite x in a facet's triangle at x the row of that facet in `around.fans`.
RimEdges rim_edges(const StarFans& around) {
  RimEdges out;
  for (std::size_t f = 0; f < around.fans.size(); ++f) {
    const Fan& fan = around.fans[f];
    for (std::size_t i = 0; i + 1 < fan.rim.size(); ++i) out[{fan.rim[i], fan.rim[i + 1]}] = f;
    if (fan.is_closed) out[{fan.rim.back(), fan.rim.front()}] = f;
  }
  return out;
}

/// Extends a sector of the star of x from its cell c to the neighbours in `left` that no facet separates from c.
void extend(Sector& s, CellIndex c, VertexIndex x, const TetMesh& cells, std::vector<CellIndex>& left,
            const RimEdges& rims) {
  for (unsigned i = 0; i < 4; ++i) {
    if (cells.vertex(c, i) == x) continue;
    std::array<VertexIndex, 3> t;
    for (unsigned k = 0; k < 3; ++k) t[k] = cells.vertex(c, face_vertices[i][k]);
    std::rotate(t.begin(), std::find(t.begin(), t.end(), x), t.end());
    const auto above = rims.find({t[1], t[2]}), below = rims.find({t[2], t[1]});
    if (above != rims.end()) {
      s.fans[above->second] |= 1u;
    } else if (below != rims.end()) {
      s.fans[below->second] |= 2u;
    } else {
      const auto it = std::lower_bound(left.begin(), left.end(), cells.neighbor_cell(c, i));
      if (it == left.end() || *it != cells.neighbor_cell(c, i)) continue;
      s.cells.push_back(*it);
      left.erase(it);
    }
  }
}

bool is_on_fan(const StarFans& around, VertexIndex v) {
  return std::any_of(around.fans.begin(), around.fans.end(),
                     [&](const Fan& f) { return std::find(f.rim.begin(), f.rim.end(), v) != f.rim.end(); });
}

/// Returns a vector from x away from the facets that bound this part of its star.
Vec3 away_from_fans(const ConstrainedMesh& mesh, VertexIndex x, const StarFans& around, const Sector& s) {
  const Vec3& o = mesh.point(x);
  Vec3 out;
  for (const auto& [i, side] : s.fans)
    for (VertexIndex v : around.fans[i].rim)
      if (!around.is_end(v)) out = out - (mesh.point(v) - o);
  return out;
}

}  // namespace

std::vector<Sector> gather_sectors(const ConstrainedMesh& mesh, VertexIndex x, const StarFans& around,
                                   const std::vector<CellIndex>& star) {
  const auto rims = rim_edges(around);
  std::vector<Sector> out;
  std::vector<CellIndex> left = star;
  while (!left.empty()) {
    Sector s;
    s.cells.push_back(left.front());
    left.erase(left.begin());
    for (std::size_t i = 0; i < s.cells.size(); ++i) extend(s, s.cells[i], x, mesh.cells(), left, rims);
    for (const auto& [fan, side] : s.fans) {
      const Vec3 n = fan_normal(mesh, x, around.fans[fan]);
      const double size = length(n);
      if (around.fans[fan].is_thin() || side == 3u) continue;
      if (side == 1u) s.inward = s.inward + (1 / size) * n;
      if (side == 2u) s.inward = s.inward - (1 / size) * n;
    }
    out.push_back(std::move(s));
  }
  return out;
}

std::vector<Triangle> sheets_of(const Sector& s, const StarFans& around) {
  std::vector<Triangle> out;
  for (const auto& [fan, side] : s.fans)
    for (const Triangle& t : around.fans[fan].triangles) {
      if (side & 1u) out.push_back(t);
      if (side & 2u) out.push_back({t[0], t[2], t[1]});
    }
  return out;
}

std::vector<VertexIndex> sheet_apexes(const ConstrainedMesh& mesh, VertexIndex x, const StarFans& around,
                                      const Sector& s) {
  const VertexIndex a = around.ends[0], b = around.ends[1];
  std::vector<VertexIndex> with_a, with_b, out;
  for (CellIndex c : s.cells)
    for (VertexIndex v : mesh.cells().vertices(c)) {
      if (v == x || v == a || v == b || is_on_fan(around, v)) continue;
      if (mesh.cells().has_vertex(c, a)) with_a.push_back(v);
      if (mesh.cells().has_vertex(c, b)) with_b.push_back(v);
    }
  sort_unique(with_a);
  sort_unique(with_b);
  std::set_intersection(with_a.begin(), with_a.end(), with_b.begin(), with_b.end(), std::back_inserter(out));
  const Vec3 inward = s.inward, along = mesh.point(b) - mesh.point(a), o = mesh.point(x);
  const auto evenness = [&](VertexIndex v) {
    const Vec3 d = mesh.point(v) - o, across = d - dot(d, along) / dot(along, along) * along;
    return s.wraps_round() ? -dot(away_from_fans(mesh, x, around, s), across) / length(across)
                           : -dot(inward, across) / length(across);
  };
  std::stable_sort(out.begin(), out.end(), [&](VertexIndex v, VertexIndex w) { return evenness(v) < evenness(w); });
  if (out.size() > recovery_budget.sheet_apexes) out.resize(recovery_budget.sheet_apexes);
  return out;
}

}  // namespace geomesh::recover
