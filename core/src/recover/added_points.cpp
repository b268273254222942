// SPDX-License-Identifier: MIT
/// Added points are taken away again where the mesh can do without: those on segments and facets first (boundary_points_inward.cpp, which
/// may leave points inside regions), then those inside. Once all constraints are there the sides of a facet no longer hinder each other, so
/// much of what flips could not do before can be done now.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "recover/cavity_retriangulation.hpp"
#include "recover/messages.hpp"
#include "recover/recover.hpp"

namespace geomesh::recover {

namespace {

/// By a fan from a neighbour, or by search.
bool empty_star(Recovery& recovery, VertexIndex x) {
  ConstrainedMesh& mesh = recovery.mesh;
  std::vector<CellIndex> star;
  mesh.star(x, star);
  Cavity cavity(recovery, std::move(star), x);
  const std::vector<Triangle> link = cavity.boundary();
  std::optional<std::vector<Tetrahedron>> filling;
  for (VertexIndex v : mesh.neighbors(x))
    if ((filling = fan_from(mesh, recovery.constraints, link, v))) break;
  if (!filling) filling = cavity.fill({});
  if (!filling) return false;
  mesh.replace(cavity.cells(), *filling);
  mesh.forget(x);
  return true;
}

/// Edges of the link of x that may go, sorted.
std::vector<DirectedEdge> link_edges(Recovery& recovery, VertexIndex x) {
  std::vector<DirectedEdge> out;
  std::vector<CellIndex> star;
  recovery.mesh.star(x, star);
  for (CellIndex c : star)
    for (const auto& e : edge_vertices) {
      const VertexIndex u = recovery.mesh.cells().vertex(c, e[0]), w = recovery.mesh.cells().vertex(c, e[1]);
      if (u != x && w != x && !recovery.constraints.is_subsegment(u, w)) out.push_back({std::min(u, w), std::max(u, w)});
    }
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

/// Tries `attempt` after the removal of each edge of the link of x, and of each two with depth 2, and so on; what fails is taken back.
template <class Attempt>
bool after_link_flips(Recovery& recovery, VertexIndex x, unsigned depth, unsigned& budget, const Attempt& attempt) {
  ConstrainedMesh& mesh = recovery.mesh;
  EdgeRemover remover(mesh, recovery.constraints);
  for (const auto& [u, w] : link_edges(recovery, x)) {
    if (budget == 0) return false;
    if (mesh.find_edge(u, w) == no_cell) continue;
    const std::size_t mark = mesh.mark();
    if (remover.remove(u, w, 1, nullptr, 40)) {
      --budget;
      if (attempt() || (depth > 1 && after_link_flips(recovery, x, depth - 1, budget, attempt))) {
        mesh.keep();
        return true;
      }
    }
    mesh.roll_back(mark);
  }
  return false;
}

/// Removes edges at x that may go. True where any went.
bool lower_degree(Recovery& recovery, VertexIndex x) {
  EdgeRemover remover(recovery.mesh, recovery.constraints);
  bool flipped = false;
  for (VertexIndex v : recovery.mesh.neighbors(x))
    if (recovery.mesh.find_edge(x, v) != no_cell && remover.remove(x, v, 1, nullptr, 60)) flipped = true;
  return flipped;
}

constexpr unsigned link_flips = 200;  ///< tried for one point

/// Removes a point that no constraint holds; `depth` flips of its link are tried.
bool remove_inner_point(Recovery& recovery, VertexIndex x, unsigned depth) {
  for (unsigned round = 0; round < 8; ++round) {
    if (empty_star(recovery, x)) return true;
    if (!lower_degree(recovery, x)) break;
  }
  for (unsigned d = 1; d <= depth; ++d) {
    unsigned budget = link_flips;
    if (after_link_flips(recovery, x, d, budget, [&] { return empty_star(recovery, x); })) return true;
  }
  return false;
}

/// The neighbours of x on its segment.
std::vector<VertexIndex> segment_neighbors(Recovery& recovery, VertexIndex x) {
  std::vector<VertexIndex> ends;
  for (VertexIndex v : recovery.mesh.neighbors(x)) {
    const Index s = recovery.constraints.subsegment_of(x, v);
    if (s != no_index && recovery.constraints.subsegments[s].segment != no_index) ends.push_back(v);
  }
  return ends;
}

/// Removes an edge that joins the neighbours of x on its segment and so runs beside x.
void clear_chord(Recovery& recovery, VertexIndex x) {
  const std::vector<VertexIndex> ends = segment_neighbors(recovery, x);
  if (ends.size() == 2 && recovery.mesh.find_edge(ends[0], ends[1]) != no_cell)
    EdgeRemover(recovery.mesh, recovery.constraints).remove(ends[0], ends[1], 2, nullptr, 200);
}

bool take_off_boundary(Recovery& recovery, VertexIndex x, unsigned effort) {
  if (take_point_off_boundary(recovery, x)) return true;
  if (effort == 0) return false;
  clear_chord(recovery, x);
  lower_degree(recovery, x);
  if (take_point_off_boundary(recovery, x)) return true;
  unsigned budget = effort == 1 ? 0 : link_flips;
  return after_link_flips(recovery, x, 1, budget, [&] { return take_point_off_boundary(recovery, x); });
}

/// A vector across the segment of x: towards a facet that hangs on it where there is one.
Vec3 across_segment(Recovery& recovery, VertexIndex x, const std::vector<VertexIndex>& ends, const Vec3& along) {
  ConstrainedMesh& mesh = recovery.mesh;
  const Vec3& o = mesh.point(x);
  std::vector<VertexIndex> towards = mesh.neighbors(x);
  const Index s = recovery.constraints.subsegment_of(x, ends[0]);
  for (Index f : recovery.constraints.subsegments[s].subfacets)
    for (VertexIndex v : recovery.constraints.subfacets[f].vertices) towards.insert(towards.begin(), v);
  for (VertexIndex v : towards) {
    const Vec3 d = mesh.point(v) - o, across = d - dot(d, along) / dot(along, along) * along;
    if (v != x && v != ends[0] && v != ends[1] && dot(across, across) > 0) return (1 / std::sqrt(dot(across, across))) * across;
  }
  return {};
}

/// Inserts an inner point beside x that is joined with both ends of its segment, across the segment in direction d (of any length).
/// no_vertex: nothing has changed.
VertexIndex insert_sheet_apex(Recovery& recovery, VertexIndex x, const std::array<VertexIndex, 2>& ends, const Vec3& d) {
  ConstrainedMesh& mesh = recovery.mesh;
  const Vec3 origin = mesh.point(x);
  EdgeRing ring;
  double reach = std::sqrt(std::min(dot(mesh.point(ends[0]) - origin, mesh.point(ends[0]) - origin), dot(mesh.point(ends[1]) - origin, mesh.point(ends[1]) - origin)));
  const VertexIndex y = mesh.add_point(origin);
  recovery.constraints.vertices.resize(mesh.points().size(), {VertexOrigin::inside, no_index});
  for (double step = 0.25 * reach; step > 1e-12 * reach; step /= 4) {
    mesh.move_point(y, origin + step / std::sqrt(dot(d, d)) * d);
    std::vector<CellIndex> seeds;
    for (VertexIndex e : ends) {
      if (!mesh.ring(mesh.find_edge(x, e), x, e, ring)) continue;
      for (std::size_t i = 0; i < ring.cells.size(); ++i)
        if (mesh.orient(x, e, ring.ring[i], y) != Sign::negative && mesh.orient(x, e, ring.ring[(i + 1) % ring.ring.size()], y) == Sign::negative)
          seeds.push_back(ring.cells[i]);
    }
    std::sort(seeds.begin(), seeds.end());
    seeds.erase(std::unique(seeds.begin(), seeds.end()), seeds.end());
    Cavity cavity(recovery, seeds);
    const auto star = seeds.empty() ? std::nullopt : cavity.star_from(y, 60);
    if (!star || !cavity.is_valid()) continue;
    mesh.replace(cavity.cells(), *star);
    return y;
  }
  mesh.drop_last_point();
  recovery.constraints.vertices.pop_back();
  return no_vertex;
}

bool is_on_boundary(const Recovery& recovery, VertexIndex x) {
  return recovery.mesh.in_mesh(x) && recovery.constraints.vertices[x].origin != VertexOrigin::inside;
}

/// Takes x off a segment round which a region goes all the way, at the price of points in the region: three beside x are the apexes of
/// sheets that part it.
bool take_off_with_sheets(Recovery& recovery, VertexIndex x) {
  ConstrainedMesh& mesh = recovery.mesh;
  const std::vector<VertexIndex> ends = segment_neighbors(recovery, x);
  if (ends.size() != 2) return false;
  const Vec3 along = mesh.point(ends[1]) - mesh.point(ends[0]), first = across_segment(recovery, x, ends, along);
  const Vec3 second = (1 / std::sqrt(dot(along, along))) * cross(along, first);
  const std::size_t mark = mesh.mark(), n_points = mesh.points().size();
  bool taken = false;
  for (const double turn : {2.0, 4.0, 3.0, 1.0, 5.0}) {
    const double angle = turn * std::numbers::pi / 3;
    insert_sheet_apex(recovery, x, {ends[0], ends[1]}, std::cos(angle) * first + std::sin(angle) * second);
    if ((taken = turn != 2.0 && take_point_off_boundary(recovery, x))) break;
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

VertexIndex first_added(const Recovery& recovery) { return static_cast<VertexIndex>(recovery.mesh.n_input() + 8); }

/// The last point first: it hangs on those before it. Sets `changed` where any went, and returns how many are left.
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

/// Cells that no locked face parts from the box: what is there is left out in the end.
std::vector<std::uint8_t> cells_outside(const ConstrainedMesh& mesh) {
  const TetMesh& cells = mesh.cells();
  std::vector<std::uint8_t> out(cells.n_slots(), 0);
  std::vector<CellIndex> stack{mesh.cell_of(static_cast<VertexIndex>(mesh.n_input()))};
  out[stack[0]] = 1;
  while (!stack.empty()) {
    const CellIndex c = stack.back();
    stack.pop_back();
    for (unsigned i = 0; i < 4; ++i) {
      const CellIndex n = cells.neighbor_cell(c, i);
      if (out[n] || mesh.is_locked(FaceRef(c, i))) continue;
      out[n] = 1;
      stack.push_back(n);
    }
  }
  return out;
}

void remove_inner_points(Recovery& recovery, unsigned depth) {
  ConstrainedMesh& mesh = recovery.mesh;
  std::vector<VertexIndex> inner;
  for (VertexIndex x = first_added(recovery); x < mesh.points().size(); ++x)
    if (mesh.in_mesh(x) && !is_on_boundary(recovery, x)) inner.push_back(x);
  if (inner.empty()) return;
  const std::vector<std::uint8_t> outside = cells_outside(mesh);
  std::erase_if(inner, [&](VertexIndex x) { return outside[mesh.cell_of(x)] != 0; });
  for (VertexIndex x : inner) {
    recovery.context.check_cancelled();
    remove_inner_point(recovery, x, depth);
  }
}

}  // namespace

void require_untouched_boundary(const Recovery& recovery) {
  for (VertexIndex x = static_cast<VertexIndex>(recovery.mesh.n_input() + 8); x < recovery.mesh.points().size(); ++x) {
    const VertexRecord& r = recovery.constraints.vertices[x];
    if (!recovery.mesh.in_mesh(x) || r.origin == VertexOrigin::inside) continue;
    const bool on_segment = r.origin == VertexOrigin::on_segment;
    ErrorContext context;
    context.places = {recovery.mesh.point(x)};
    if (!on_segment) context.facets = {r.owner};
    if (on_segment && recovery.constraints.segments[r.owner].row != no_index) context.segments = {recovery.constraints.segments[r.owner].row};
    const ModelSegment segment = on_segment ? recovery.constraints.segments[r.owner] : ModelSegment{};
    throw Error(ErrorKind::cannot_mesh,
                (on_segment ? "the segment " + describe_edge(recovery, segment.a, segment.b) : "facet " + std::to_string(r.owner)) +
                    " cannot be kept free of added points: mesh it without preserve_boundary",
                std::move(context));
  }
}

void remove_added_points(Recovery& recovery, bool must_clear) {
  if (recovery.mesh.points().size() == first_added(recovery)) return;
  constexpr unsigned max_passes = 8, hardest = 2;
  for (unsigned pass = 0; pass < max_passes; ++pass) {
    bool changed = false;
    const unsigned effort = std::min(pass, hardest);
    const std::size_t left = take_points_off_boundary(recovery, changed, [&](VertexIndex x) { return take_off_boundary(recovery, x, effort); });
    remove_inner_points(recovery, 0);
    if (left == 0 || (pass >= hardest && !changed)) break;
  }
  for (bool changed = must_clear; changed;) {
    changed = false;
    const std::size_t left = take_points_off_boundary(recovery, changed, [&](VertexIndex x) {
      return take_off_boundary(recovery, x, hardest) || take_off_with_sheets(recovery, x);
    });
    if (left == 0) break;
  }
  remove_inner_points(recovery, 2);
}

}  // namespace geomesh::recover
