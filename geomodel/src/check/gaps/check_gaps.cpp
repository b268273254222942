// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/gaps/check_gaps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

#include "check/exact/deviation.hpp"
#include "check/mesh/faults.hpp"
#include "check/names/name_parts.hpp"
#include "check/names/sheet_sides.hpp"
#include "common/union_find.hpp"

namespace geomesh::geomodel::checking {
namespace {

/// Share of the continuation distance within which a wall counts as near. The shortest distance to a wall is less than
/// the distance along the horizon; it is half of it if horizon and wall meet at 30 degrees.
constexpr double share_of_distance = 0.5;
/// A surface is a wall ahead of a horizon's border if the direction to the wall's nearest point and the outward
/// direction at the border make an angle with at least this cosine. A horizon directly above or below the border is
/// thus no wall.
constexpr double least_ahead = 0.25;

/// The faces of each mesh cell, and whether each face belongs to a surface.
struct MeshWays {
  std::vector<std::array<Index, 4>> faces_of_cell;
  std::vector<bool> has_surface;  ///< per FacePair

  explicit MeshWays(const CheckedFaces& checked) {
    const CheckedMesh& mesh = checked.mesh();
    faces_of_cell.assign(mesh.cells.size(), {no_index, no_index, no_index, no_index});
    has_surface.assign(mesh.faces.size(), false);
    for (Index f = 0; f < mesh.faces.size(); ++f)
      for (const Index cell : {mesh.faces[f].even, mesh.faces[f].odd})
        if (cell != no_index) *std::ranges::find(faces_of_cell[cell], no_index) = f;
    for (const Triangle& t : checked.candidates())
      if (const FacePair* pair = find_face(mesh, t))
        has_surface[static_cast<std::size_t>(pair - mesh.faces.data())] = true;
  }
};

/// A face of a horizon that has the same region on both sides.
struct InnerFace {
  Index face;         ///< of `checked.candidates()`
  Index over, under;  ///< cells
};

enum class HorizonSide : std::uint8_t { none, over, under };

using Edge = std::pair<VertexIndex, VertexIndex>;

/// Finds gaps of one horizon in one region that lies on both sides of it.
class GapChecker {
 public:
  GapChecker(const CheckedFaces& checked, const MeshWays& ways, Index horizon, std::int32_t region)
      : mesh_(checked.mesh()), ways_(ways), region_(region), walls_({}) {
    std::vector<Corners> walls;
    std::map<Edge, int> uses;
    for (Index f = 0; f < checked.candidates().size(); ++f) {
      if (checked.faces()->region_minus[f] != region && checked.faces()->region_plus[f] != region) continue;
      const Triangle& t = checked.candidates()[f];
      if (!checked.carries(f, horizon)) {
        walls.push_back({mesh_.point(t[0]), mesh_.point(t[1]), mesh_.point(t[2])});
        continue;
      }
      for (std::size_t i = 0; i < 3; ++i) {
        const Edge edge = std::minmax(t[i], t[(i + 1) % 3]);
        ++uses[edge];
        border_[edge] = t[(i + 2) % 3];
      }
    }
    std::erase_if(border_, [&](const auto& edge) { return uses.at(edge.first) != 1; });
    walls_ = TriangleSet(std::move(walls));
  }

  /// Returns a point in a gap of the horizon whose whole border faces a wall (another surface); nothing if there is
  /// none.
  std::optional<Vec3> narrow_gap(const std::vector<InnerFace>& inner, double distance) {
    spread(inner);
    const std::vector<Index> between = faces_between();
    UnionFind joined(between.size());
    std::map<Edge, Index> at_edge;
    for_each_edge(between, [&](Index k, const Edge& edge) {
      const auto [at, is_new] = at_edge.emplace(edge, k);
      if (!is_new) joined.unite(at->second, k);
    });
    std::map<Index, bool> is_narrow;  // by gap
    std::map<Index, Vec3> place;
    for_each_edge(between, [&](Index k, const Edge& edge) {
      const auto ends = border_.find(edge);
      if (ends == border_.end()) return;
      const auto [at, is_new] = is_narrow.emplace(joined.find(k), true);
      at->second = at->second && has_wall_ahead(edge, ends->second, distance);
      place.emplace(at->first, mesh_.point(edge.first));
    });
    for (const auto& [gap, narrow] : is_narrow)
      if (narrow) return place.at(gap);
    return std::nullopt;
  }

 private:
  /// Determines which side of the horizon is nearer to each cell of the region, along paths inside the region.
  void spread(const std::vector<InnerFace>& inner) {
    struct Reached {
      double distance;
      Index cell;
      HorizonSide side;
      bool operator<(const Reached& other) const {
        return distance != other.distance ? distance > other.distance : cell > other.cell;
      }
    };
    side_.assign(mesh_.cells.size(), HorizonSide::none);
    std::priority_queue<Reached> queue;
    for (const InnerFace& f : inner) {
      queue.push({0, f.over, HorizonSide::over});
      queue.push({0, f.under, HorizonSide::under});
    }
    while (!queue.empty()) {
      const Reached at = queue.top();
      queue.pop();
      if (side_[at.cell] != HorizonSide::none) continue;
      side_[at.cell] = at.side;
      const Vec3 from = centroid(mesh_, mesh_.cells[at.cell]);
      for_each_neighbour(at.cell, [&](Index, Index next) {
        if (side_[next] != HorizonSide::none) return;
        const Vec3 way = centroid(mesh_, mesh_.cells[next]) - from;
        queue.push({at.distance + std::sqrt(dot(way, way)), next, at.side});
      });
    }
  }

  /// Calls visit(face, neighbour) for each cell that shares a face with the given one, if both are in the same region
  /// and no surface contains the face.
  template <class F>
  void for_each_neighbour(Index cell, F&& visit) const {
    for (const Index f : ways_.faces_of_cell[cell]) {
      if (f == no_index || ways_.has_surface[f] || !is_inner(mesh_.faces[f])) continue;
      const Index next = mesh_.faces[f].even == cell ? mesh_.faces[f].odd : mesh_.faces[f].even;
      if (mesh_.file.region[next] == region_) visit(f, next);
    }
  }

  std::vector<Index> faces_between() const {
    std::vector<Index> between;
    for (Index cell = 0; cell < side_.size(); ++cell)
      if (side_[cell] == HorizonSide::over)
        for_each_neighbour(cell, [&](Index f, Index next) {
          if (side_[next] == HorizonSide::under) between.push_back(f);
        });
    return between;
  }

  template <class F>
  void for_each_edge(const std::vector<Index>& faces, F&& visit) const {
    for (Index k = 0; k < faces.size(); ++k) {
      const Triangle& t = mesh_.faces[faces[k]].key;
      for (std::size_t i = 0; i < 3; ++i) visit(k, Edge(std::minmax(t[i], t[(i + 1) % 3])));
    }
  }

  /// Returns whether another surface lies in front of a border edge of the horizon, in the direction away from the
  /// third corner of the edge's face.
  bool has_wall_ahead(const Edge& edge, VertexIndex third, double distance) const {
    const Vec3 &a = mesh_.point(edge.first), &b = mesh_.point(edge.second);
    const Vec3 along = b - a, middle = 0.5 * (a + b), inward = mesh_.point(third) - a;
    const Vec3 outward = (dot(inward, along) / dot(along, along)) * along - inward;
    const double length = std::sqrt(dot(outward, outward));
    return std::ranges::any_of(walls_.near(middle, distance), [&](const TriangleSet::Near& near) {
      return dot(near.point - middle, outward) >= least_ahead * near.distance * length;
    });
  }

  const CheckedMesh& mesh_;
  const MeshWays& ways_;
  std::int32_t region_;
  TriangleSet walls_;                   ///< faces on the boundary of the region, except those of the horizon
  std::map<Edge, VertexIndex> border_;  ///< border edges of the horizon, with the third corner of the face at each
  std::vector<HorizonSide> side_;       ///< per cell
};

/// Returns the faces of one horizon that have the same region on both sides, grouped by region.
std::map<std::int32_t, std::vector<InnerFace>> inner_faces(const CheckedFaces& checked, Index horizon) {
  const CheckedMesh& mesh = checked.mesh();
  const FacesFile& faces = *checked.faces();
  const TriangulatedSurface& surface = checked.specification().surfaces[horizon];
  std::map<std::int32_t, std::vector<InnerFace>> found;
  std::vector<int> upper_side;
  for (Index f = 0; f < checked.candidates().size(); ++f) {
    const auto source = static_cast<std::size_t>(faces.source_triangle[f]);
    if (faces.region_minus[f] != faces.region_plus[f] || checked.surface_of(faces.surface[f]) != horizon ||
        source >= surface.triangles.size())
      continue;
    const FacePair* pair = find_face(mesh, checked.candidates()[f]);
    if (!pair || !is_inner(*pair)) continue;
    if (upper_side.empty()) upper_side = upper_sides(surface);
    const Triangle& s = surface.triangles[source];
    const Vec3 of_source =
        cross(surface.points[s[1]] - surface.points[s[0]], surface.points[s[2]] - surface.points[s[0]]);
    const Vec3 of_face = cross(mesh.point(pair->key[1]) - mesh.point(pair->key[0]),
                               mesh.point(pair->key[2]) - mesh.point(pair->key[0]));  // out of `even`
    const double lengths = std::sqrt(dot(of_source, of_source) * dot(of_face, of_face));
    const double cosine = lengths > 0 ? upper_side[source] * dot(of_source, of_face) / lengths : 0;
    if (std::abs(cosine) < least_cosine) continue;
    found[faces.region_plus[f]].push_back(
        {f, cosine > 0 ? pair->odd : pair->even, cosine > 0 ? pair->even : pair->odd});
  }
  return found;
}

/// Returns whether the region's name contains a unit next to the horizon. If not, the horizon is a remnant, for example
/// of an older horizon above an unconformity, and separates no units there.
bool is_named_beside(const std::string& name, const std::string& horizon, const Specification& specification) {
  const std::vector<std::string>& column = specification.names.column;
  const auto at = std::ranges::find(column, horizon);
  if (at == column.end()) return false;
  const std::string units = "+" + parts_of(name, names_of_specification(specification)).base + "+";
  return units.find("+" + *(at - 1) + "+") != std::string::npos ||
         units.find("+" + *(at + 1) + "+") != std::string::npos;
}

/// Returns whether the run's report says that the horizon is open somewhere, or that units are joined in the region.
bool is_told(const std::vector<ReportedGap>& told, const std::string& horizon, const std::string& region) {
  return std::ranges::any_of(told, [&](const ReportedGap& gap) {
    return gap.horizon == horizon || (gap.joins_units && gap.region == region);
  });
}

}  // namespace

void check_gaps(const CheckedFaces& checked, const std::vector<ReportedGap>& told, CheckResult& result) {
  const SpecifiedNames& names = checked.specification().names;
  if (!(names.continued_within > 0) || checked.mesh().file.region.empty()) return;
  FaultCollector joined("units_joined_by_gap");
  std::string which;
  std::optional<MeshWays> ways;
  for (const Index horizon : names.continued) {
    for (const auto& [region, inner] : inner_faces(checked, horizon)) {
      const auto name = checked.mesh().file.region_names.find(region);
      if (name == checked.mesh().file.region_names.end() ||
          !is_named_beside(name->second, checked.specification().surfaces[horizon].name, checked.specification()))
        continue;
      if (!ways) ways.emplace(checked);
      const auto place =
          GapChecker(checked, *ways, horizon, region).narrow_gap(inner, share_of_distance * names.continued_within);
      if (!place) continue;
      const std::string& surface = checked.specification().surfaces[horizon].name;
      if (is_told(told, surface, name->second)) {
        result.checks_done.push_back("units join across " + surface + " in region " + name->second +
                                     ", through a gap of which the run warned");
        continue;
      }
      joined.add(static_cast<std::size_t>(region), *place);
      if (joined.count() <= 5) which += (which.empty() ? "" : "; ") + name->second + " across " + surface;
    }
  }
  joined.report(result,
                "regions lie on both sides of a horizon through a gap that is closed by default (" + which + ")");
}

}  // namespace geomesh::geomodel::checking
