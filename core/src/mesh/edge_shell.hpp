// SPDX-License-Identifier: MIT
/// @file
/// Edge removal: the shell of an edge, which consists of the cells around it, is triangulated anew without the edge.
/// Each triangle of a triangulation of the polygon of ring vertices represents two cells, one with each end of the
/// edge. The best triangulation is found by dynamic programming over spans of the polygon (Klincsek 1980; Shewchuk
/// 2002, "Two discrete optimization algorithms for the topological improvement of tetrahedral meshes"). The goal
/// defines what is best:
///
///   recovery   positive   any triangulation of positive cells without forbidden diagonals
///   remeshing  worst      the largest worst shape
///              mean       the largest sum of worths, no cell below a floor
///              surface    either, on each side of a surface through the edge
#pragma once

#include <cstddef>
#include <cstdint>

namespace geomesh {

/// Best triangulations of polygons of at most `max_vertices` vertices. The goal defines
///   edge()                    the value of a side of the polygon
///   none()                    the value of a span that has no triangulation
///   allows(i, j)              whether a triangulation may have the diagonal i-j
///   is_enough(value)          whether no better triangulation is searched for in this span
///   value(span, left, right)  the value of triangle (i, k, j) with the best on its sides (i, k) and (k, j);
///                             it counts only if it exceeds span.best
template <class Value, std::size_t max_vertices>
class EdgeShell {
 public:
  struct Span {
    std::size_t i, k, j;
    Value best;
  };

  /// Finds the best triangulation of the n vertices around an edge by dynamic programming; returns its value. O(n^3).
  template <class Goal>
  Value triangulate(std::size_t n, const Goal& goal) {
    n_ = n;
    for (std::size_t i = 0; i + 1 < n; ++i) best_[i][i + 1] = goal.edge();
    for (std::size_t span = 2; span < n; ++span)
      for (std::size_t i = 0; i + span < n; ++i) {
        const std::size_t j = i + span;
        best_[i][j] = goal.none();
        apex_[i][j] = 0;
        if (span + 1 < n && !goal.allows(i, j)) continue;
        for (std::size_t k = i + 1; k < j && !goal.is_enough(best_[i][j]); ++k)
          if (const Value v = goal.value(Span{i, k, j, best_[i][j]}, best_[i][k], best_[k][j]); v > best_[i][j])
            best_[i][j] = v, apex_[i][j] = static_cast<std::uint8_t>(k);
      }
    return n < 3 ? goal.edge() : best_[0][n - 1];
  }

  /// Calls visit(i, k, j), i < k < j, for each triangle of the best triangulation that was found for the polygon.
  template <class Visit>
  void for_each_triangle(const Visit& visit) const {
    if (n_ >= 3) descend(0, n_ - 1, visit);
  }

 private:
  static_assert(max_vertices <= 256);

  template <class Visit>
  void descend(std::size_t i, std::size_t j, const Visit& visit) const {
    if (j < i + 2) return;
    const std::size_t k = apex_[i][j];
    visit(i, k, j);
    descend(i, k, visit);
    descend(k, j, visit);
  }

  std::size_t n_ = 0;
  Value best_[max_vertices][max_vertices];
  std::uint8_t apex_[max_vertices][max_vertices];
};

}  // namespace geomesh
