// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// On which sides of faults the sheets of a horizon lie.
#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "common/union_find.hpp"
#include "geomesh/geomodel/surface.hpp"
#include "rules/throw/area_samples.hpp"
#include "rules/throw/nearest_point.hpp"
#include "rules/throw/side_bounds.hpp"

namespace geomesh::geomodel {

/// Pairs of triangles with an edge in common (equal coordinates merged).
std::vector<std::pair<Index, Index>> neighbours_in(const TriangulatedSurface& surface);

/// Sheets joined across the pairs that `joins` accepts, as the least triangle of each.
template <class F>
std::vector<Index> sheets_of(std::size_t n_triangles, const std::vector<std::pair<Index, Index>>& neighbours,
                             F&& joins) {
  UnionFind joined(n_triangles);
  for (const auto& [a, b] : neighbours)
    if (joins(a, b)) joined.unite(a, b);
  std::vector<Index> sheet(n_triangles);
  for (Index t = 0; t < sheet.size(); ++t) sheet[t] = joined.find(t);
  return sheet;
}

/// A fault's triangles with normals to one side. A query costs O(log triangles), and next to nothing where the place
/// is on one side of the planes of all.
class FaultSides {
 public:
  explicit FaultSides(const TriangulatedSurface& fault);
  /// By the plane of the triangle that is nearest by its centre.
  bool is_above(const Vec3& p) const;

 private:
  std::vector<SidedPlane> planes_;  ///< by triangle, through their centres
  NearestPoint nearest_;
  SideBounds bounds_;
};

/// Sheets of a horizon (triangles that hang together by edges), and how much of each lies on which side of each fault.
/// A sheet is on the side where most of its area is. Cost: parts of triangles times faults, each O(log n).
class SheetSides {
 public:
  /// Both outlive this.
  SheetSides(const TriangulatedSurface& horizon, const std::vector<const TriangulatedSurface*>& faults);

  /// Per fault, whether a sheet runs on across it, so that the horizon has no throw there. A tenth of the sheet's area
  /// at least lies on either side. Where another sheet is on the same sides of all faults as the smaller part, it is a
  /// quarter. Over or under that part lies no other sheet, as one does where the sheet only overshoots. A fiftieth is
  /// enough where other faults lie between all sheets that this one has on its two sides: it cuts a corner off.
  std::vector<bool> run_across() const;

  /// Per fault, whether it is one of the fewest faults that part the sheets. Of two that part the same ones it is that
  /// with less of them on the wrong side. One that a sheet runs on across parts none. Sheets of less than a
  /// two-hundredth of the horizon's area do not count.
  std::vector<bool> parting() const;

 private:
  /// Part of a triangle (AreaSamples).
  struct Part {
    Index sheet;
    Vec3 place;
    double area;
    std::vector<bool> above;  ///< per fault
  };
  struct Sheet {
    double area = 0;
    std::vector<double> above{};  ///< area, per fault
    void add(const Part& part) {
      area += part.area;
      for (std::size_t f = 0; f < above.size(); ++f) above[f] += part.above[f] ? part.area : 0;
    }
    bool is_above(std::size_t fault) const { return 2 * above[fault] > area; }
    double smaller(std::size_t fault) const { return std::min(above[fault], area - above[fault]); }
  };
  /// Area of the sheet's smaller part beside the fault over and under which no other sheet lies; and whether another
  /// sheet is on the same sides as that part.
  struct SmallerPart {
    double alone;
    bool has_another;
  };
  SmallerPart smaller_part(Index sheet, std::size_t fault) const;
  bool runs_across(std::size_t fault) const;
  /// Whether two sheets lie on different sides of the fault, and on the same side of all others that count.
  bool parts_alone(std::size_t fault, const std::vector<bool>& counts) const;
  bool parts_any(std::size_t fault) const;
  double largest_corner(std::size_t fault) const;  ///< smaller part alone, as a share of its sheet
  double on_wrong_side(std::size_t fault) const;   ///< area of all smaller parts
  /// Of the faults that count, the one with most of it that parts sheets, though others that count part them as well;
  /// n_faults_ where none has more than `least`.
  template <class F>
  std::size_t least_needed(const std::vector<bool>& counts, double least, F&& much) const;

  const TriangulatedSurface& horizon_;
  std::size_t n_faults_;
  std::vector<Index> sheet_;  ///< per triangle
  std::vector<Part> parts_;
  std::map<Index, Sheet> sheets_;
  double area_ = 0;
};

/// SheetSides::parting. A horizon of one sheet is parted by none, without looking at its sides.
std::vector<bool> parting_of(const TriangulatedSurface& horizon, const std::vector<const TriangulatedSurface*>& faults);

}  // namespace geomesh::geomodel
