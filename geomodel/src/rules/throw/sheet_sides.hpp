// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Determines on which sides of faults the sheets (connected parts) of a horizon lie.
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

/// Returns pairs of triangles with a common edge (equal coordinates are merged).
std::vector<std::pair<Index, Index>> neighbours_in(const TriangulatedSurface& surface);

/// Returns for each triangle its sheet (set of triangles connected across the pairs that `joins` accepts), identified
/// by the sheet's smallest triangle index.
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

/// A fault's triangles with normals to one side. A query costs O(log triangles), and much less if the place is on one
/// side of all their planes.
class FaultSides {
 public:
  explicit FaultSides(const TriangulatedSurface& fault);
  /// Returns whether p is above the plane of that triangle of the fault whose centre is nearest to p.
  bool is_above(const Vec3& p) const;

 private:
  std::vector<SidedPlane> planes_;  ///< planes through the centres of the fault's triangles, in their order
  NearestPoint nearest_;
  SideBounds bounds_;
};

/// Sheets of a horizon (sets of triangles connected by edges), and how much of each lies on each side of each fault. A
/// sheet is on the side where most of its area is. Cost: parts of triangles times faults, each O(log n).
class SheetSides {
 public:
  /// Both outlive this.
  SheetSides(const TriangulatedSurface& horizon, const std::vector<const TriangulatedSurface*>& faults);

  /// For each fault, returns whether a sheet continues across it, so that the horizon has no throw there. At least a
  /// tenth of the sheet's area must lie on either side, or a quarter if another sheet is on the same sides of all
  /// faults as the smaller part. No other sheet may lie above or below that part, because then the sheet only
  /// overshoots the fault. A fiftieth is enough if other faults lie between all sheets that this one has on its two
  /// sides: the fault then cuts off a corner.
  std::vector<bool> run_across() const;

  /// For each fault, returns whether it belongs to a smallest set of faults that separates the sheets (connected
  /// parts). If two faults separate the same sheets, the one with less of their area on its wrong side is chosen. A
  /// fault across which a sheet continues separates none. Sheets below 0.5 % of the horizon's area are ignored.
  std::vector<bool> parting() const;

 private:
  /// Part of a triangle, with the area it represents (AreaSamples).
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
  /// Area of a sheet's (connected part's) smaller part beside a fault, excluding what has another sheet above or below
  /// it; and whether another sheet lies on the same sides of all faults as that part.
  struct SmallerPart {
    double alone;
    bool has_another;
  };
  SmallerPart smaller_part(Index sheet, std::size_t fault) const;
  bool runs_across(std::size_t fault) const;
  /// Returns whether the fault separates two connected parts that lie on the same sides of all other counted faults.
  bool parts_alone(std::size_t fault, const std::vector<bool>& counts) const;
  bool parts_any(std::size_t fault) const;
  /// Returns the largest part of a sheet (connected part) on the smaller of its two sides of the fault, as a share of
  /// its sheet and without what has another sheet above or below it.
  double largest_corner(std::size_t fault) const;
  double on_wrong_side(std::size_t fault) const;  ///< total over connected parts of the smaller area beside the fault
  /// Among the counted faults, returns the one with the greatest measure (`much`) that separates only sheets (connected
  /// parts) which other counted faults separate as well; n_faults_ if no measure exceeds `least`.
  template <class F>
  std::size_t least_needed(const std::vector<bool>& counts, double least, F&& much) const;

  const TriangulatedSurface& horizon_;
  std::size_t n_faults_;
  std::vector<Index> sheet_;  ///< per triangle
  std::vector<Part> parts_;
  std::map<Index, Sheet> sheets_;
  double area_ = 0;
};

/// Returns SheetSides::parting(): whether each fault is needed to separate the horizon's connected parts.
std::vector<bool> parting_of(const TriangulatedSurface& horizon, const std::vector<const TriangulatedSurface*>& faults);

}  // namespace geomesh::geomodel
