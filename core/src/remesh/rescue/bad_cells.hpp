// SPDX-License-Identifier: MIT
/// @file
/// Cells of poor shape: lists of them with the shape they had when listed, sums over them, and their causes.
#pragma once

#include <cstdint>
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
/// Returns the shape below which the share 0..1 of all cells lies, on all cores. O(n). Precondition: there are cells.
double shape_at_percentile(const DomainMesh& mesh, double share, unsigned threads);
/// The worst first.
std::vector<BadCell> cells_below(const DomainMesh& mesh, double limit);
/// Lists cells with a shape below `limit` by classes of equal width in shape, the worst class first. Within a class,
/// cells are in the order of the mesh: cells close in memory are examined one after the other, which is far faster.
std::vector<BadCell> cells_below_by_class(const DomainMesh& mesh, double limit, unsigned n_classes);
BadCell bad_cell(const DomainMesh& mesh, CellIndex c);

/// Returns whether the cell still exists with the same vertices, even if these have moved.
bool is_left(const DomainMesh& mesh, const BadCell& b);
inline bool changed_since(const DomainMesh& mesh, const BadCell& b, std::uint64_t time) {
  return changed_since(mesh, b.vertices, time);
}

/// Measures of the bad cells around a place, before and after a sequence of repair.
struct Tally {
  std::size_t n_bad = 0;
  double worst = 1;
  double deficit = 0;  ///< sum over the bad cells of 1 - shape / bad_shape, which is 1 for a flat cell

  void add(double shape, double bad_shape) {
    n_bad += shape < bad_shape;
    worst = std::min(worst, shape);
    deficit += std::max(1 - shape / bad_shape, 0.0);
  }
  bool is_better_than(const Tally& other) const {
    return worst >= other.worst &&
           (n_bad < other.n_bad || (n_bad == other.n_bad && worst > rescue_limits.notable_rise * other.worst));
  }
  /// Returns whether the worst shape is no lower, and there are fewer bad cells, or as many with a clearly lower sum of
  /// 1 - shape / bad_shape. Next to cells that cannot be improved, the worst shape alone says nothing.
  bool is_less_bad_than(const Tally& other) const {
    return worst >= other.worst &&
           (n_bad < other.n_bad || (n_bad == other.n_bad && deficit < other.deficit - rescue_limits.notable_relief));
  }
};

/// Finds the bad cells that the input does not impose, which the search for better cells starts from.
struct FreeCellJudge {
  /// Finds bad cells that the input does not impose in the whole mesh.
  std::function<std::vector<CellIndex>(const DomainMesh&)> find;
  /// Finds bad cells that the input does not impose among the cells with a vertex that has changed since the given time
  /// of the mesh. A doubtful cell is included.
  std::function<std::vector<CellIndex>(const DomainMesh&, std::uint64_t since)> find_since;
  /// Finds bad cells that the input does not impose among the given ones, the worst first. Decides by their
  /// surroundings alone, which is fast; a doubtful cell is included.
  std::function<std::vector<CellIndex>(const DomainMesh&, std::span<const CellIndex>)> find_among;
};

}  // namespace geomesh::remesh
