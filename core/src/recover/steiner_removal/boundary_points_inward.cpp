// SPDX-License-Identifier: MIT
/// Removes an added point from its segment or facet. The facets around it are triangulated again without it; each
/// sector of its star between the facets is refilled: without a point if possible, else with a point moved from the old
/// place into the sector.
///
/// For a facet's inner point the two sectors are the halves of its star. A moved point sees the sector's part of the
/// link if it moves little. It sees the facets' new triangles if it moves to the inner side of their planes; exact
/// tests decide which step is small enough, and the sector grows across parts of the link that are not visible from the
/// moved point. A sector that surrounds the segment (the border of a facet that ends inside a region, a well) has no
/// such side: it is divided by sheets, triangles at the segment that become faces of the mesh.
#include <algorithm>
#include <cmath>

#include "common/geometry.hpp"
#include "common/sort_unique.hpp"
#include "recover/model/recover.hpp"
#include "recover/model/recovery_budget.hpp"
#include "recover/operations/cavity_retriangulation.hpp"
#include "recover/operations/exact_points.hpp"
#include "recover/steiner_removal/region_filling.hpp"
#include "recover/steiner_removal/star_sectors.hpp"

namespace geomesh::recover {

namespace {

/// Finds cells that fill the star of an added point without it, one sector (part between facets) after the other.
class SectorFilling {
 public:
  SectorFilling(Recovery& recovery, VertexIndex x, const StarFans& around, RefilledCells refilled,
                const std::vector<CellIndex>& star)
      : recovery_(recovery),
        mesh_(recovery.mesh),
        constraints_(recovery.constraints),
        x_(x),
        around_(around),
        refilled_(refilled),
        grown_(star) {}

  /// Fills a sector (a part between facets) of the star of x: without a point if possible, otherwise around a point
  /// that is moved into the sector.
  bool fill(Sector& s) {
    Cavity cavity = cavity_of(s);
    const std::vector<Triangle> boundary = cavity.boundary();
    if (!s.wraps_round()) {
      for (VertexIndex v : vertices_of(boundary)) {
        auto fan = fan_from(mesh_, constraints_, boundary, v);
        if (fan && take(s, std::move(*fan), cavity.cells())) return true;
      }
    }
    auto filling = cavity.fill({recovery_budget.filling_nodes_sector});
    if (filling && take(s, std::move(*filling), cavity.cells())) return true;
    if (refilled_ == RefilledCells::region_about_star && fill_by_region(s)) return true;
    return !s.wraps_round() && fill_about_moved_point(s);
  }

 private:
  Cavity cavity_of(const Sector& s) const {
    Cavity out(recovery_, s.cells, x_);
    for (const Triangle& t : sheets_of(s, around_)) out.add_sheet(t);
    out.forbid(grown_);
    return out;
  }
  /// Fills a sector (a part between facets) of the star of x, together with cells beyond the star, without a point.
  bool fill_by_region(Sector& s) {
    std::optional<Region> region =
        region_about(recovery_, s.cells, {&x_, 1}, recovery_budget.region_vertices.back(), grown_);
    if (!region) return false;
    for (const Triangle& t : sheets_of(s, around_)) region->boundary.push_back(t);
    auto filling = fill_region_once(recovery_, *region);
    return filling && take(s, std::move(*filling), region->cells);
  }
  bool take(Sector& s, std::vector<Tetrahedron>&& filling, const std::vector<CellIndex>& cells) {
    if (!has_segment(filling)) return false;
    s.filling = std::move(filling);
    s.cells = cells;
    grown_.insert(grown_.end(), s.cells.begin(), s.cells.end());
    sort_unique(grown_);
    return true;
  }
  /// Returns whether the new cells of the star of x have the segment of x as an edge. This is tested only for a segment
  /// without facets (a well), because facets would ensure it.
  bool has_segment(const std::vector<Tetrahedron>& filling) const {
    if (around_.halves.empty() || !around_.fans.empty()) return true;
    return std::any_of(filling.begin(), filling.end(), [&](const Tetrahedron& t) {
      return std::count_if(t.begin(), t.end(), [&](VertexIndex v) { return around_.is_end(v); }) == 2;
    });
  }
  bool fill_about_moved_point(Sector& s) {
    if (s.inward == Vec3{} || around_.fans.empty()) return false;
    const Vec3 direction = (1 / length(s.inward)) * s.inward;
    const Vec3 origin = mesh_.point(x_);
    const Cavity cavity = cavity_of(s);
    double reach = 0;
    for (const Triangle& t : cavity.boundary())
      for (VertexIndex v : t) reach = std::max(reach, std::fabs(dot(mesh_.offset(x_, v), direction)));
    const VertexIndex moved = mesh_.add_point(origin);
    constraints_.vertices.resize(mesh_.points().size(), {VertexOrigin::inside, no_index});
    for (const unsigned max_growths : {0u, recovery_budget.moved_growths}) {
      if (max_growths > 0 && !cavity.is_valid()) break;
      const double least_part = mesh_.is_exact(x_) ? recovery_budget.least_move_exact : recovery_budget.least_move;
      for (double step = reach / 2; step > reach * least_part; step /= max_growths == 0 ? 2 : 8) {
        move_beside(moved, step * direction);
        Cavity trial = cavity;
        auto fan = trial.star_from(moved, max_growths);
        if (fan && take(s, std::move(*fan), trial.cells())) return true;
      }
    }
    mesh_.drop_last_point();
    constraints_.vertices.pop_back();
    return false;
  }

  /// Places the vertex `moved` beside the vertex x that is removed, at the offset `step` from it.
  void move_beside(VertexIndex moved, const Vec3& step) {
    if (mesh_.is_exact(x_)) {
      mesh_.move_point(moved, place_beside(mesh_, x_, step));
    } else {
      mesh_.move_point(moved, mesh_.point(x_) + step);
    }
  }

  Recovery& recovery_;
  ConstrainedMesh& mesh_;
  Constraints& constraints_;
  VertexIndex x_;
  const StarFans& around_;
  RefilledCells refilled_;
  std::vector<CellIndex> grown_;  ///< the star of x and the cells beyond it that are filled anew, sorted
};

/// Removes an added point from its facets or segment, and from the mesh.
class PointRemoval {
 public:
  PointRemoval(Recovery& recovery, VertexIndex x, RefilledCells refilled)
      : recovery_(recovery),
        mesh_(recovery.mesh),
        constraints_(recovery.constraints),
        x_(x),
        refilled_(refilled),
        n_points_(recovery.mesh.points().size()) {}

  bool run() {
    mesh_.star(x_, star_);
    std::sort(star_.begin(), star_.end());
    for (CellIndex c : star_)
      if (mesh_.cells().is_ghost(c)) return false;
    auto found = find_star_fans(recovery_, x_, star_);
    if (!found) return false;
    around_ = std::move(*found);
    if (has_foreign_chord() || repeats_subfacet()) return false;
    if (!fill_sectors(recovery_budget.sheets)) return false;
    commit();
    return true;
  }

 private:
  /// Fills all sectors (parts between facets) of the star of x without x. Divides a sector for which that fails by a
  /// triangle, up to `n_sheets` times. Otherwise removes the points that were added in sectors and returns false.
  bool fill_sectors(unsigned n_sheets) {
    std::vector<Sector> sectors = gather_sectors(mesh_, x_, around_, star_);
    SectorFilling filling(recovery_, x_, around_, refilled_, star_);
    std::size_t stuck = sectors.size();
    for (std::size_t i = 0; i < sectors.size() && stuck == sectors.size(); ++i)
      if (!filling.fill(sectors[i])) stuck = i;
    if (stuck == sectors.size()) {
      sectors_ = std::move(sectors);
      return true;
    }
    drop_moved_points();
    if (n_sheets == 0 || around_.halves.empty()) return false;
    for (VertexIndex w : sheet_apexes(mesh_, x_, around_, sectors[stuck])) {
      around_.fans.push_back(sheet(w));
      if (fill_sectors(n_sheets - 1)) return true;
      around_.fans.pop_back();
    }
    return false;
  }
  /// Returns whether the mesh already has an edge between the neighbours of x on its segment, and the edge does not
  /// bound a part of a facet of zero width.
  bool has_foreign_chord() {
    if (around_.halves.empty() || mesh_.find_edge(around_.ends[0], around_.ends[1]) == no_cell) return false;
    return std::none_of(around_.fans.begin(), around_.fans.end(), [](const Fan& f) { return f.is_thin(); });
  }
  /// Returns whether a new triangle of a facet without x already is a subfacet, of this facet or of another one.
  bool repeats_subfacet() const {
    return std::any_of(around_.fans.begin(), around_.fans.end(), [&](const Fan& f) {
      return std::any_of(f.triangles.begin(), f.triangles.end(),
                         [&](const Triangle& t) { return constraints_.subfacet_of(t[0], t[1], t[2]) != no_index; });
    });
  }
  void drop_moved_points() {
    while (mesh_.points().size() > n_points_) mesh_.drop_last_point();
    constraints_.vertices.resize(n_points_);
  }

  Fan sheet(VertexIndex w) const {
    Fan out;
    out.rim = {around_.ends[0], w, around_.ends[1]};
    out.triangles = {{out.rim[0], out.rim[1], out.rim[2]}};
    return out;
  }

  void commit() {
    std::vector<Tetrahedron> filling;
    std::vector<CellIndex> cells;
    for (const Sector& s : sectors_) {
      filling.insert(filling.end(), s.filling.begin(), s.filling.end());
      cells.insert(cells.end(), s.cells.begin(), s.cells.end());
    }
    refill(mesh_, cells, filling);
    if (!around_.halves.empty()) {
      const Index segment = constraints_.subsegments[around_.halves[0]].segment;
      const Index chord = constraints_.subsegment_of(around_.ends[0], around_.ends[1]);
      if (chord == no_index) {
        constraints_.add_subsegment(around_.ends[0], around_.ends[1], segment, no_index);
      } else {
        constraints_.subsegments[chord].segment = segment;
      }
    }
    for (const Fan& fan : around_.fans)
      for (const Triangle& t : fan.triangles) {
        if (fan.facet == no_index) continue;
        constraints_.add_subfacet(t, fan.facet);
        mesh_.lock(mesh_.find_face(t[0], t[1], t[2]));
      }
    for (const Fan& fan : around_.fans)
      for (Index f : fan.subfacets) constraints_.remove_subfacet(f);
    for (Index s : around_.halves) constraints_.remove_subsegment(s);
  }

  Recovery& recovery_;
  ConstrainedMesh& mesh_;
  Constraints& constraints_;
  VertexIndex x_;
  RefilledCells refilled_;
  std::size_t n_points_;
  std::vector<CellIndex> star_;  ///< sorted
  StarFans around_;
  std::vector<Sector> sectors_;
};

}  // namespace

bool take_point_off_boundary(Recovery& recovery, VertexIndex x, RefilledCells cells) {
  return PointRemoval(recovery, x, cells).run();
}

}  // namespace geomesh::recover
