// SPDX-License-Identifier: MIT
// Inserts a point where it raises the shapes around it. Declared in remesh/operations/improve.hpp.
#include <algorithm>

#include "quality/measure/shape.hpp"
#include "remesh/operations/improve.hpp"
#include "remesh/operations/improve_schedule.hpp"
#include "search/closest_point.hpp"

namespace geomesh::remesh {

namespace {

/// Grows a cavity around a cell. Each step crosses the border face that would make the worst new cell.
class CavityDigger {
 public:
  CavityDigger(const DomainMesh& mesh, CellIndex seed) : mesh_(mesh), cells_{seed} {}

  /// Grows the cavity and keeps the stage at which the worst new cell with apex p is best. Returns false if p sees the
  /// whole border at no stage.
  bool dig(const Vec3& p, std::size_t max_cells) {
    cells_.resize(1);
    border_.clear();
    add_border(p);
    std::size_t best_size = 0;
    double best = 0;
    while (cells_.size() <= max_cells) {
      const BorderFace worst = worst_border();
      if (worst.shape > best) best = worst.shape, best_size = cells_.size();
      if (!worst.neighbor.valid() || worst.is_constrained) break;
      cells_.push_back(worst.neighbor.cell());
      std::erase_if(border_,
                    [&](const BorderFace& f) { return f.neighbor.valid() && f.neighbor.cell() == cells_.back(); });
      add_border(p);
    }
    cells_.resize(best_size);
    return best_size > 0;
  }
  const std::vector<CellIndex>& cells() const { return cells_; }

 private:
  struct BorderFace {
    double shape = 1;  ///< shape of the new cell between this face of the cavity's border and the new point
    FaceRef neighbor;  ///< this face of the cavity's border, as a face of the cell outside the cavity
    bool is_constrained = false;
  };

  /// Adds to the cavity's border the border faces of the cell that the cavity received last.
  void add_border(const Vec3& p) {
    const CellIndex c = cells_.back();
    for (unsigned i = 0; i < 4; ++i) {
      const FaceRef n = mesh_.cells().neighbor(c, i);
      if (n.valid() && std::find(cells_.begin(), cells_.end(), n.cell()) != cells_.end()) continue;
      border_.push_back({mesh_.shape(mesh_.face(c, i), p), n, mesh_.tag(c, i).constrained()});
    }
  }

  /// Returns the face of the cavity's border with the worst new cell; of equal ones the first.
  BorderFace worst_border() const {
    BorderFace worst;
    for (const BorderFace& f : border_)
      if (f.shape < worst.shape) worst = f;
    return worst;
  }

  const DomainMesh& mesh_;
  std::vector<CellIndex> cells_;
  std::vector<BorderFace> border_;
};

/// Returns whether a point on the edge a-b necessarily leaves a cell hardly better than the worst removed cell. The
/// dihedral angle of a cell at the edge opposite a-b is divided between two new cells.
bool halves_a_bad_angle(Toolbox& tools, CellIndex c, VertexIndex a, VertexIndex b) {
  const DomainMesh& mesh = tools.mesh;
  const auto& cells = tools.work.cells;
  const auto& ring = tools.work.ring;
  turn_about_edge(mesh.cells(), c, a, b, tools.work.cells, tools.work.ring);
  double before = 1;
  for (const CellIndex k : cells) before = std::min(before, mesh.shape_of(k));
  for (std::size_t k = 0; k < cells.size(); ++k)
    if (mesh.measure().most_of_half_angle(mesh.point(a), mesh.point(b), mesh.point(ring[k]),
                                          mesh.point(ring[(k + 1) % ring.size()])) <= before * point_limits.least_rise)
      return true;
  return false;
}

bool has_room(const Toolbox& tools, const StarCavity& cavity, const Vec3& p, double room) {
  Index last = cavity.link[0].component;
  LocalLength size = tools.lengths.at(p, last);
  for (const LinkFace& f : cavity.link)
    if (f.component != last) size = least(size, tools.lengths.at(p, last = f.component));
  const LocalLength limit = room * size;
  return std::all_of(cavity.link.begin(), cavity.link.end(), [&](const LinkFace& f) {
    return std::none_of(f.vertices.begin(), f.vertices.end(),
                        [&](VertexIndex v) { return limit.exceeds(tools.mesh.point(v) - p); });
  });
}

/// Returns whether p is between two surfaces less than a quarter of the target size apart, where points only make more
/// flat elements. Examines the faces of the cavity's cells and of their neighbours.
bool is_barred_by_gap(const Toolbox& tools, const StarCavity& cavity, const Vec3& p) {
  if (tools.points_in_thin_gaps) return false;
  const DomainMesh& mesh = tools.mesh;
  const LocalLength limit = point_limits.thin_gap * tools.lengths.at(p, cavity.link[0].component);
  std::vector<Vec3> ways;  // to surfaces
  const auto closes_gap = [&](CellIndex c, unsigned i) {
    const auto [q, r, s] = mesh.places(mesh.face(c, i));
    const Vec3 way = search::closest_on_triangle(p, q, r, s) - p;
    const double l = limit.measure(way);
    if (!(l < 1)) return false;
    const bool closes = std::any_of(ways.begin(), ways.end(),
                                    [&](const Vec3& w) { return dot(way, w) < 0 && l + limit.measure(w) < 1; });
    ways.push_back(way);
    return closes;
  };
  for (const CellIndex c : cavity.cells)
    for (unsigned i = 0; i < 4; ++i) {
      if (mesh.tag(c, i).constrained()) {
        if (closes_gap(c, i)) return true;
        continue;
      }
      const CellIndex beside = mesh.cells().neighbor(c, i).cell();
      for (unsigned k = 0; k < 4; ++k)
        if (mesh.tag(beside, k).constrained() && closes_gap(beside, k)) return true;
    }
  return false;
}

}  // namespace

bool insert_to_improve(Toolbox& tools, CellIndex c, double room) {
  DomainMesh& mesh = tools.mesh;
  Vec3 p = mesh.middle(mesh.vertices(c));
  CavityDigger digger(mesh, c);
  StarCavity& cavity = tools.work.cavity;
  StarProblem problem{tools.work.link};
  for (unsigned place = 0; place < point_limits.most_places; ++place) {
    if (!digger.dig(p, point_limits.most_cells)) return false;
    gather_cells(mesh, tools.work.marks, digger.cells(), cavity);
    problem.set_link(mesh, cavity);
    const OptimizedPlace best = optimize_place(problem, p, {.max_steps = point_limits.ascent_steps});
    p = best.point;
    if (!(best.shape > removed_shape(mesh, cavity) * point_limits.least_rise) || !star_is_positive(mesh, cavity, p) ||
        tools.spoils(cavity, p))
      continue;
    if (swallows_constraint(mesh, tools.work, cavity.cells, cavity.link) || !has_room(tools, cavity, p, room) ||
        is_barred_by_gap(tools, cavity, p))
      return false;
    fill_with_star(mesh, cavity, mesh.add_vertex(p, VertexKind::inside), tools.work);
    ++tools.statistics.improving_insertions;
    return true;
  }
  return false;
}

bool split_to_improve(Toolbox& tools, CellIndex c, VertexIndex a, VertexIndex b, double room) {
  DomainMesh& mesh = tools.mesh;
  if (mesh.is_pinched(a, b) || halves_a_bad_angle(tools, c, a, b)) return false;
  StarCavity& cavity = tools.work.cavity;
  gather_edge(mesh, c, a, b, cavity);
  const double before = removed_shape(mesh, cavity);
  const Index curve = mesh.curve_of(a, b);
  if (tools.stays(cavity, curve)) return false;
  const Index patch = cavity.spokes.empty() ? no_index : mesh.patch_of_facet(cavity.spokes[0].facet);
  if (patch == hull_patch) return false;
  const Vec3 middle = 0.5 * (mesh.point(a) + mesh.point(b));
  StarProblem problem{tools.work.link};
  problem.set_link(mesh, cavity);
  const bool moves_on_patch = curve == no_index && patch != no_index;
  if (curve != no_index) {
    problem.freedom = StarProblem::Freedom::line;
    problem.direction = (1 / distance(mesh.point(a), mesh.point(b))) * (mesh.point(b) - mesh.point(a));
  } else if (moves_on_patch) {
    problem.freedom = StarProblem::Freedom::plane;
    problem.direction = tools.guard.normal(patch, middle);
  }
  Vec3 p = optimize_place(problem, middle, {.max_steps = point_limits.ascent_steps}).point;
  if (moves_on_patch) p = tools.guard.project_to_patch(patch, p);
  if (!(problem.shape_at(p, before) > before * point_limits.least_rise) || !star_is_positive(mesh, cavity, p) ||
      tools.spoils(cavity, p))
    return false;
  if (!has_room(tools, cavity, p, room) || (curve == no_index && !moves_on_patch && is_barred_by_gap(tools, cavity, p)))
    return false;
  const bool is_guarded = moves_on_patch || (tools.guard.exact() && curve != no_index);
  if (is_guarded && !tools.guard.admits({faces_at_edge(mesh, cavity, a, b), {}}, surface_of(mesh, cavity, p)))
    return false;
  fill_from_edge(tools, cavity, a, b, p);
  ++tools.statistics.improving_insertions;
  return true;
}

}  // namespace geomesh::remesh
