// SPDX-License-Identifier: MIT
/// Removes an added point from a segment that one region surrounds: the border of a facet that ends inside the region,
/// or a well. No point moved off the segment sees both of its neighbours on the segment there. Points beside the
/// segment become the apexes of triangles (sheets) that divide the region.
#include <algorithm>
#include <cmath>

#include "common/geometry.hpp"
#include "common/sort_unique.hpp"
#include "recover/model/recovery_budget.hpp"
#include "recover/operations/cavity_retriangulation.hpp"
#include "recover/operations/exact_points.hpp"
#include "recover/steiner_removal/point_removal.hpp"

namespace geomesh::recover {

namespace {

/// Returns a vector perpendicular to the segment on which x lies, in a facet attached to the segment if there is one.
Vec3 across_segment(Recovery& recovery, VertexIndex x, const std::vector<VertexIndex>& ends, const Vec3& along) {
  ConstrainedMesh& mesh = recovery.mesh;
  std::vector<VertexIndex> towards = mesh.neighbors(x);
  const Index s = recovery.constraints.subsegment_of(x, ends[0]);
  for (Index f : recovery.constraints.subsegments[s].subfacets)
    for (VertexIndex v : recovery.constraints.subfacets[f].vertices) towards.insert(towards.begin(), v);
  for (VertexIndex v : towards) {
    const Vec3 d = mesh.offset(x, v), across = d - dot(d, along) / dot(along, along) * along;
    if (v != x && v != ends[0] && v != ends[1] && dot(across, across) > 0) return (1 / length(across)) * across;
  }
  return {};
}

/// Inserts a point beside x, which lies on a segment, in direction d (of any length) from x, connected by edges with
/// both neighbours of x on the segment. Returns no_vertex if nothing has changed.
VertexIndex insert_sheet_apex(Recovery& recovery, VertexIndex x, const std::array<VertexIndex, 2>& ends,
                              const Vec3& d) {
  ConstrainedMesh& mesh = recovery.mesh;
  const Vec3 origin = mesh.point(x);
  EdgeRing ring;
  const Vec3 to_first = mesh.offset(x, ends[0]), to_last = mesh.offset(x, ends[1]);
  const double reach = std::sqrt(std::min(dot(to_first, to_first), dot(to_last, to_last)));
  const VertexIndex y = mesh.add_point(origin);
  recovery.constraints.vertices.resize(mesh.points().size(), {VertexOrigin::inside, no_index});
  for (double step = recovery_budget.sheet_point_reach * reach; step > recovery_budget.sheet_point_least * reach;
       step *= recovery_budget.sheet_point_part) {
    const Vec3 off = step / length(d) * d;
    if (mesh.is_exact(x)) {
      mesh.move_point(y, place_beside(mesh, x, off));
    } else {
      mesh.move_point(y, origin + off);
    }
    std::vector<CellIndex> seeds;
    for (VertexIndex e : ends) {
      if (!mesh.ring(mesh.find_edge(x, e), x, e, ring)) continue;
      for (std::size_t i = 0; i < ring.cells.size(); ++i)
        if (mesh.orient(x, e, ring.ring[i], y) != Sign::negative &&
            mesh.orient(x, e, ring.ring[(i + 1) % ring.ring.size()], y) == Sign::negative)
          seeds.push_back(ring.cells[i]);
    }
    sort_unique(seeds);
    Cavity cavity(recovery, seeds);
    const auto star = seeds.empty() ? std::nullopt : cavity.star_from(y, recovery_budget.sheet_point_growths);
    if (!star || !cavity.is_valid()) continue;
    mesh.replace(cavity.cells(), *star);
    return y;
  }
  mesh.drop_last_point();
  recovery.constraints.vertices.pop_back();
  return no_vertex;
}

}  // namespace

bool take_off_with_sheets(Recovery& recovery, VertexIndex x) {
  ConstrainedMesh& mesh = recovery.mesh;
  const std::vector<VertexIndex> ends = segment_neighbors(recovery, x);
  if (ends.size() != 2) return false;
  const Vec3 along = mesh.offset(ends[0], ends[1]), first = across_segment(recovery, x, ends, along);
  const Vec3 second = (1 / length(along)) * cross(along, first);
  const std::size_t mark = mesh.mark(), n_points = mesh.points().size();
  bool taken = false;
  for (const double turn : recovery_budget.sheet_turns) {
    const double angle = turn * pi / 3;
    insert_sheet_apex(recovery, x, {ends[0], ends[1]}, std::cos(angle) * first + std::sin(angle) * second);
    if ((taken = turn != recovery_budget.sheet_turns[0] && take_point_off_boundary(recovery, x))) break;
  }
  if (taken) {
    mesh.keep();
    return true;
  }
  mesh.roll_back(mark);
  while (mesh.points().size() > n_points) {
    mesh.forget(static_cast<VertexIndex>(mesh.points().size() - 1));
    mesh.drop_last_point();
    recovery.constraints.vertices.pop_back();
  }
  return false;
}

}  // namespace geomesh::recover
