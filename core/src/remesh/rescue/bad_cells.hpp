// SPDX-License-Identifier: MIT
/// @file
/// Cells of poor shape: lists of them, as they were when they were listed, sums over them, and what forces them.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "remesh/domain/domain_mesh.hpp"
#include "remesh/operations/improve_schedule.hpp"

namespace geomesh::remesh {

struct BadCell {
  double shape;
  CellIndex cell;
  Tetrahedron vertices;
};

std::size_t count_below(const DomainMesh& mesh, double limit);
/// The shape below which that share of all cells is, 0..1. On all cores. O(n). Precondition: there are cells.
double shape_at_percentile(const DomainMesh& mesh, double share, unsigned threads);
/// The worst first.
std::vector<BadCell> cells_below(const DomainMesh& mesh, double limit);
/// The same by classes of equal width in shape, the worst class first. Within a class cells come in the order of the
/// mesh: those that are near to each other are looked at one after the other, which is many times as fast.
std::vector<BadCell> cells_below_by_class(const DomainMesh& mesh, double limit, unsigned n_classes);
BadCell bad_cell(const DomainMesh& mesh, CellIndex c);

/// Whether it is there still; a vertex may have moved.
bool is_left(const DomainMesh& mesh, const BadCell& b);
inline bool changed_since(const DomainMesh& mesh, const BadCell& b, std::uint64_t time) {
  return changed_since(mesh, b.vertices, time);
}

/// What the bad cells about a place come to, before and after a sequence of repair.
struct Tally {
  std::size_t n_bad = 0;
  double worst = 1;
  double deficit = 0;  ///< sum over the bad cells of what they lack, as a share of the bad shape

  void add(double shape, double bad_shape) {
    n_bad += shape < bad_shape;
    worst = std::min(worst, shape);
    deficit += std::max(1 - shape / bad_shape, 0.0);
  }
  bool is_better_than(const Tally& other) const {
    return worst >= other.worst &&
           (n_bad < other.n_bad || (n_bad == other.n_bad && worst > rescue_limits.notable_rise * other.worst));
  }
  /// Beside cells that cannot be mended the worst says nothing. There all bad cells together count.
  bool is_less_bad_than(const Tally& other) const {
    return worst >= other.worst &&
           (n_bad < other.n_bad || (n_bad == other.n_bad && deficit < other.deficit - rescue_limits.notable_relief));
  }
};

/// Tells the bad cells that nothing of the input forces: what the search for better cells asks.
struct FreeCellJudge {
  std::function<std::vector<CellIndex>(const DomainMesh&)> find;
  /// Those of some cells that are such, the worst first, by what is near to them: quick, and in doubt they are.
  std::function<std::vector<CellIndex>(const DomainMesh&, std::span<const CellIndex>)> find_among;
};

}  // namespace geomesh::remesh
