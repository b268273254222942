// SPDX-License-Identifier: MIT
/// Added points are taken away again where the mesh can do without: those on segments and facets first (boundary_points_inward.cpp, which
/// may leave points inside regions), then those inside. Once all constraints are there the sides of a facet no longer hinder each other, so
/// much of what flips could not do before can be done now.
#include <algorithm>

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

/// Removes an edge that joins the neighbours of x on its segment and so runs beside x.
void clear_chord(Recovery& recovery, VertexIndex x) {
  std::vector<VertexIndex> ends;
  for (VertexIndex v : recovery.mesh.neighbors(x)) {
    const Index s = recovery.constraints.subsegment_of(x, v);
    if (s != no_index && recovery.constraints.subsegments[s].segment != no_index) ends.push_back(v);
  }
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

bool is_on_boundary(const Recovery& recovery, VertexIndex x) {
  return recovery.mesh.in_mesh(x) && recovery.constraints.vertices[x].origin != VertexOrigin::inside;
}
VertexIndex first_added(const Recovery& recovery) { return static_cast<VertexIndex>(recovery.mesh.n_input() + 8); }

/// The last point first: it hangs on those before it. Sets `changed` where any went, and returns how many are left.
std::size_t take_points_off_boundary(Recovery& recovery, unsigned effort, bool& changed) {
  std::size_t left = 0;
  for (VertexIndex x = static_cast<VertexIndex>(recovery.mesh.points().size()); x-- > first_added(recovery);) {
    recovery.context.check_cancelled();
    if (!is_on_boundary(recovery, x)) continue;
    const bool taken = take_off_boundary(recovery, x, effort);
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

void remove_added_points(Recovery& recovery) {
  if (recovery.mesh.points().size() == first_added(recovery)) return;
  constexpr unsigned max_passes = 8, hardest = 2;
  for (unsigned pass = 0; pass < max_passes; ++pass) {
    bool changed = false;
    const std::size_t left = take_points_off_boundary(recovery, std::min(pass, hardest), changed);
    remove_inner_points(recovery, 0);
    if (left == 0 || (pass >= hardest && !changed)) break;
  }
  remove_inner_points(recovery, 2);
}

}  // namespace geomesh::recover
