// SPDX-License-Identifier: MIT
/// Removes added points that the mesh does not need: first those on segments and facets (boundary_points_inward.cpp,
/// which may leave points inside regions), then those inside (inner_points.cpp). When all constraints are present, the
/// two sides of a facet no longer interact, so flips can achieve much that they could not before.
#include <algorithm>

#include "common/sort_unique.hpp"
#include "recover/model/excerpt.hpp"
#include "recover/model/messages.hpp"
#include "recover/model/recovery_budget.hpp"
#include "recover/operations/edge_removal.hpp"
#include "recover/steiner_removal/point_removal.hpp"

namespace geomesh::recover {

namespace {

/// Returns the edges of the link of x that are not subsegments, sorted.
std::vector<DirectedEdge> link_edges(Recovery& recovery, VertexIndex x) {
  std::vector<DirectedEdge> out;
  std::vector<CellIndex> star;
  recovery.mesh.star(x, star);
  for (CellIndex c : star)
    for (const auto& e : edge_vertices) {
      const VertexIndex u = recovery.mesh.cells().vertex(c, e[0]), w = recovery.mesh.cells().vertex(c, e[1]);
      if (u != x && w != x && !recovery.constraints.is_subsegment(u, w))
        out.push_back({std::min(u, w), std::max(u, w)});
    }
  sort_unique(out);
  return out;
}

/// Removes each edge of the link of x in turn and then calls `attempt`; undoes the removal if that returns false.
template <class Attempt>
bool after_link_flips(Recovery& recovery, VertexIndex x, const Attempt& attempt) {
  ConstrainedMesh& mesh = recovery.mesh;
  EdgeRemover remover(mesh, recovery.constraints);
  unsigned tried = 0;
  for (const auto& [u, w] : link_edges(recovery, x)) {
    if (tried == recovery_budget.link_edges) return false;
    if (mesh.find_edge(u, w) == no_cell) continue;
    const std::size_t mark = mesh.mark();
    if (remover.remove(u, w, recovery_budget.link_edge_depth, nullptr, recovery_budget.link_edge_effort)) {
      ++tried;
      if (attempt()) {
        mesh.keep();
        return true;
      }
    }
    mesh.roll_back(mark);
  }
  return false;
}

/// Removes the mesh edge, if there is one, between the two neighbours of the point x on its segment.
void clear_chord(Recovery& recovery, VertexIndex x) {
  const std::vector<VertexIndex> ends = segment_neighbors(recovery, x);
  if (ends.size() == 2 && recovery.mesh.find_edge(ends[0], ends[1]) != no_cell)
    EdgeRemover(recovery.mesh, recovery.constraints)
        .remove(ends[0], ends[1], recovery_budget.chord_depth, nullptr, recovery_budget.chord_effort);
}

/// Tries to remove the Steiner point x from its segment or facet: with effort 0 by filling its star anew, with 1 also
/// after flips at x, with 2 also together with cells around the star and after flips of edges of its link.
bool take_off_boundary(Recovery& recovery, VertexIndex x, unsigned effort) {
  if (take_point_off_boundary(recovery, x)) return true;
  if (effort == 0) return false;
  clear_chord(recovery, x);
  lower_degree(recovery, x);
  if (take_point_off_boundary(recovery, x)) return true;
  return effort > 1 && (take_point_off_boundary(recovery, x, RefilledCells::region_about_star) ||
                        after_link_flips(recovery, x, [&] { return take_point_off_boundary(recovery, x); }));
}

/// Tries to remove all added points from segments and facets, the last one first, because it depends on earlier ones.
/// Sets `changed` if any was removed, and returns how many are left.
template <class TakeOff>
std::size_t take_points_off_boundary(Recovery& recovery, bool& changed, const TakeOff& take_off) {
  std::size_t left = 0;
  for (VertexIndex x = static_cast<VertexIndex>(recovery.mesh.points().size()); x-- > first_added(recovery);) {
    recovery.context.check_cancelled();
    if (!is_on_boundary(recovery, x)) continue;
    const bool taken = take_off(x);
    changed = changed || taken;
    left += !taken;
  }
  return left;
}

}  // namespace

std::vector<VertexIndex> segment_neighbors(Recovery& recovery, VertexIndex x) {
  std::vector<VertexIndex> ends;
  for (VertexIndex v : recovery.mesh.neighbors(x)) {
    const Index s = recovery.constraints.subsegment_of(x, v);
    if (s != no_index && recovery.constraints.subsegments[s].segment != no_index) ends.push_back(v);
  }
  return ends;
}

void require_untouched_boundary(Recovery& recovery) {
  for (VertexIndex x = first_added(recovery); x < recovery.mesh.points().size(); ++x) {
    if (!is_on_boundary(recovery, x)) continue;
    const VertexRecord& r = recovery.constraints.vertices[x];
    const bool on_segment = r.origin == VertexOrigin::on_segment;
    ErrorContext context;
    context.places = {recovery.mesh.point(x)};
    context.excerpt = excerpt_about(recovery, {&x, 1});
    if (!on_segment) context.facets = {r.owner};
    if (on_segment && recovery.constraints.segments[r.owner].row != no_index)
      context.segments = {recovery.constraints.segments[r.owner].row};
    const ModelSegment segment = on_segment ? recovery.constraints.segments[r.owner] : ModelSegment{};
    return recovery.end(Error(ErrorKind::cannot_mesh,
                              (on_segment ? "the segment " + describe_edge(recovery, segment.a, segment.b)
                                          : "facet " + std::to_string(recovery.names.facet[r.owner])) +
                                  " cannot be kept free of added points: mesh it without preserve_boundary",
                              std::move(context)));
  }
}

void remove_added_points(Recovery& recovery, BoundaryPoints boundary, InnerEffort effort_at_last) {
  if (recovery.mesh.points().size() == first_added(recovery)) return;
  constexpr unsigned hardest = recovery_budget.removal_effort;
  for (unsigned pass = 0; pass < recovery_budget.removal_passes; ++pass) {
    bool changed = false;
    const unsigned effort = std::min(pass, hardest);
    const std::size_t left = take_points_off_boundary(
        recovery, changed, [&](VertexIndex x) { return take_off_boundary(recovery, x, effort); });
    remove_inner_points(recovery, InnerEffort::star);
    if (left == 0 || (pass >= hardest && !changed)) break;
  }
  for (bool changed = boundary == BoundaryPoints::must_go; changed;) {
    changed = false;
    const std::size_t left = take_points_off_boundary(recovery, changed, [&](VertexIndex x) {
      return take_off_boundary(recovery, x, hardest) || take_off_with_sheets(recovery, x);
    });
    if (left == 0) break;
  }
  if (effort_at_last == InnerEffort::region) remove_inner_points(recovery, InnerEffort::region);
}

}  // namespace geomesh::recover
