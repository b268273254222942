// SPDX-License-Identifier: MIT
/// Removes added points inside regions: from their star by a fan, by search or after flips at the point, and finally
/// from a region around it whose filling is decided by a formula (region_filling.hpp).
#include <algorithm>

#include "common/flood.hpp"
#include "recover/model/recovery_budget.hpp"
#include "recover/operations/cavity_retriangulation.hpp"
#include "recover/operations/edge_removal.hpp"
#include "recover/steiner_removal/point_removal.hpp"
#include "recover/steiner_removal/region_filling.hpp"

namespace geomesh::recover {

namespace {

/// Fills the star of x without x: by connecting its boundary with a neighbour of x, or else by a search.
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

bool remove_from_star(Recovery& recovery, VertexIndex x) {
  for (unsigned round = 0; round < recovery_budget.star_rounds; ++round) {
    if (empty_star(recovery, x)) return true;
    if (!lower_degree(recovery, x)) break;
  }
  return false;
}

bool remove_from_region(Recovery& recovery, VertexIndex x, std::size_t max_vertices) {
  ConstrainedMesh& mesh = recovery.mesh;
  std::vector<CellIndex> star;
  mesh.star(x, star);
  const std::optional<Region> region = region_about(recovery, star, {&x, 1}, max_vertices);
  if (!region) return false;
  const auto filling = fill_region_once(recovery, *region);
  if (!filling) return false;
  refill(mesh, region->cells, *filling);
  return true;
}

/// Returns the added points inside regions, without those outside the model, which are not part of the result.
std::vector<VertexIndex> inner_points(const Recovery& recovery) {
  const ConstrainedMesh& mesh = recovery.mesh;
  std::vector<VertexIndex> out;
  for (VertexIndex x = first_added(recovery); x < mesh.points().size(); ++x)
    if (mesh.in_mesh(x) && !is_on_boundary(recovery, x)) out.push_back(x);
  if (out.empty()) return out;
  const std::vector<std::uint8_t> outside = cells_outside(mesh);
  std::erase_if(out, [&](VertexIndex x) { return outside[mesh.cell_of(x)] != 0; });
  return out;
}

template <class Remove>
void remove_each(Recovery& recovery, std::vector<VertexIndex>& points, const Remove& remove) {
  std::erase_if(points, [&](VertexIndex x) {
    recovery.context.check_cancelled();
    return !recovery.mesh.in_mesh(x) || remove(x);  // the removal of another Steiner point may have removed x, too
  });
}

}  // namespace

std::vector<std::uint8_t> cells_outside(const ConstrainedMesh& mesh) {
  constexpr std::uint8_t inside = 0, outside = 1;
  std::vector<std::uint8_t> out(mesh.cells().n_slots(), inside);
  const CellIndex at_box = mesh.cell_of(static_cast<VertexIndex>(mesh.n_input()));
  flood_cells(mesh.cells(), at_box, out, inside, outside, [&](FaceRef f) { return !mesh.is_locked(f); });
  return out;
}

bool lower_degree(Recovery& recovery, VertexIndex x) {
  EdgeRemover remover(recovery.mesh, recovery.constraints);
  bool flipped = false;
  for (VertexIndex v : recovery.mesh.neighbors(x))
    if (recovery.mesh.find_edge(x, v) != no_cell && remover.remove(x, v, 1, nullptr, recovery_budget.star_edges))
      flipped = true;
  return flipped;
}

void remove_inner_points(Recovery& recovery, InnerEffort effort) {
  std::vector<VertexIndex> points = inner_points(recovery);
  remove_each(recovery, points, [&](VertexIndex x) { return remove_from_star(recovery, x); });
  if (effort == InnerEffort::star) return;
  for (const std::size_t max_vertices : recovery_budget.region_vertices)
    remove_each(recovery, points, [&](VertexIndex x) { return remove_from_region(recovery, x, max_vertices); });
}

}  // namespace geomesh::recover
