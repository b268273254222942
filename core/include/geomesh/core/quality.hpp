// SPDX-License-Identifier: MIT
/// @file
/// Statistics of element shapes, for the whole mesh and for each component (Cavalcanti and Mello 1999, figure 11, and
/// more). Lists the worst elements with the cause of each.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "geomesh/core/geometry.hpp"
#include "geomesh/core/plc.hpp"
#include "geomesh/core/size_field.hpp"
#include "geomesh/core/tetrahedralize.hpp"

namespace geomesh {

/// Shape measures of one tetrahedron; angles in degrees; ratios are 1 for the regular tetrahedron and 0 for a flat one.
struct TetrahedronShape {
  std::array<double, 6> dihedral;  ///< dihedral angles at the edges in the order of edge_vertices
  double min_dihedral, max_dihedral;
  /// Solid angles at the vertices, as degrees of spherical excess; 31.6 for the regular tetrahedron.
  std::array<double, 4> solid_angle;
  double radius_ratio;  ///< 3 * inscribed radius / circumscribed radius
  double aspect;        ///< least height divided by longest edge, relative to the regular tetrahedron
  double mean_ratio;    ///< 12 (3 volume)^(2/3) / sum of squared edge lengths
  double volume;
  double shortest_edge, longest_edge;
};

/// Computes all shape measures of a tetrahedron, which should be positively oriented. A flat or inverted one yields
/// angles of 0 and 180 degrees and ratios of 0. O(1).
TetrahedronShape tetrahedron_shape(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

struct DihedralRange {
  double least = 0, greatest = 0;  ///< degrees
};

/// Computes the least and greatest dihedral angle of a tetrahedron, in a third of the time of tetrahedron_shape. They
/// are 0 and 180 degrees for a needle whose volume is lost in rounding. O(1).
DihedralRange dihedral_range(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

struct Distribution {
  double min = 0, max = 0, mean = 0, first_percentile = 0;
};

/// Statistics over a set of tetrahedra. Histograms have equal bins from 0 to 180 degrees (dihedral) or 0 to 1 (ratios).
struct ShapeStatistics {
  std::size_t n_tetrahedra = 0;
  double volume = 0;
  Distribution min_dihedral, max_dihedral, solid_angle, radius_ratio, aspect, mean_ratio, edge_length;
  /// Shares of elements whose least dihedral angle is below 10 or above 24.85 degrees.
  double share_below_10 = 0, share_above_24_85 = 0;
  std::array<std::size_t, 36> dihedral_histogram{};      ///< histogram of all dihedral angles, in bins of 5 degrees
  std::array<std::size_t, 18> min_dihedral_histogram{};  ///< histogram of the elements' least dihedral angles, in bins
                                                         ///< of 5 degrees from 0 to 90
  std::array<std::size_t, 20> radius_ratio_histogram{};
  /// Number of edges by length / target size: below 1/4, 1/2, 1/sqrt 2, 1, sqrt 2, 2, 4, above. Zero without sizes.
  std::array<std::size_t, 8> edge_size_histogram{};
  /// Returns the share of edges between half and twice the target size; 1 without edges or without sizes. O(1).
  double share_within_size() const;
};

/// Why an element is bad.
enum class ShapeCause {
  free,         ///< no feature of the input imposes the element's bad shape
  input_angle,  ///< two facets or segments of the input meet at less than `forcing_angle` at a vertex of the element
  /// The element spans a gap thinner than a quarter of the target size that the tolerance does not allow to close.
  thin_gap,
};

struct WorstElement {
  Index tetrahedron = no_index;
  double min_dihedral = 0, max_dihedral = 0;
  Vec3 place;  ///< centroid
  ShapeCause cause = ShapeCause::free;
  double forcing_angle = 0;                      ///< the small angle of the input in degrees, if `cause` is input_angle
  Index facet_a = no_index, facet_b = no_index;  ///< input facets that form the small angle or bound the gap
  Index segment_a = no_index, segment_b = no_index;  ///< input segments that form the small angle, if any
  double gap = 0;                                    ///< width of the gap, if `cause` is thin_gap
};

struct QualityOptions {
  /// Elements whose least dihedral angle (degrees) is below this are bad and are listed.
  double bad_angle = 8;
  std::size_t min_worst = 0;        ///< least number of elements listed, bad or not
  std::size_t max_worst = 100;      ///< largest number of elements listed
  double forcing_angle = 16;        ///< degrees
  const SizeField* size = nullptr;  ///< target sizes with which edges are compared
  /// Target sizes with which the widths of gaps are compared: without the sizes that gaps require. Null: `size`.
  const SizeField* asked = nullptr;
  /// Distance by which surfaces may move. A gap of up to twice this could be closed, so it is no cause of a bad shape.
  double tolerance = 0;
  /// A second limit on the movement of surfaces, as a share of the target size. With it, surfaces never close a gap, so
  /// every thin gap is a cause of bad elements. 0: `tolerance` is the only limit.
  double tolerance_share = 0;
  /// For each facet of the PLC its patch, if surfaces were remeshed: edges between facets of one patch are then no
  /// constraints. Empty: every facet is kept.
  std::vector<Index> facet_patch;
  /// For each tetrahedron its group, below `n_groups`, by which statistics are divided. Empty: division by components.
  std::vector<Index> group;
  std::size_t n_groups = 0;
  unsigned threads = 0;  ///< number of threads; 0: all cores
};

struct MeshQuality {
  ShapeStatistics whole;
  std::vector<ShapeStatistics> per_component;  ///< or per group
  /// Elements without a cause in the input, then those with one; the worst first in each list.
  std::vector<WorstElement> worst;
  std::size_t n_bad = 0;         ///< number of elements with an angle below bad_angle
  std::size_t n_bad_forced = 0;  ///< number of bad elements with a cause in the input
};

/// Measures the quality of a mesh and finds the worst elements. Takes nearly linear time in the elements, plus the
/// squared number of faces at each vertex of a bad element. The result does not depend on the number of threads.
/// Precondition: `group`, if not empty, has an entry below n_groups for each tetrahedron.
MeshQuality measure_quality(const PiecewiseLinearComplex& plc, const ConstrainedTetrahedralization& mesh,
                            const QualityOptions& options = {});
/// Computes shape statistics of any tetrahedral mesh, without looking for causes of bad shapes.
ShapeStatistics measure_shapes(std::span<const Vec3> points, std::span<const Tetrahedron> tetrahedra);

}  // namespace geomesh
