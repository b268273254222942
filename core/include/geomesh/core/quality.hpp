// SPDX-License-Identifier: MIT
/// @file
/// Statistics of element shapes: the paper's Figure 11 and more, whole and per component, and the worst elements with
/// their cause.
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

/// Shape measures of one tetrahedron; angles in degrees; every ratio is 1 for the regular tetrahedron and 0 for a flat
/// one.
struct TetrahedronShape {
  std::array<double, 6> dihedral;  ///< dihedral angles at the edges in the order of edge_vertices
  double min_dihedral, max_dihedral;
  std::array<double, 4>
      /// Solid angles at the vertices, as degrees of spherical excess (the paper's unit: 31.6 for the regular
      /// tetrahedron).
      solid_angle;
  double radius_ratio;  ///< 3 * inscribed radius / circumscribed radius
  double aspect;        ///< least height divided by longest edge, relative to the regular tetrahedron
  double mean_ratio;    ///< 12 (3V)^(2/3) / sum of squared edges
  double volume;
  double shortest_edge, longest_edge;
};

/// O(1). The tetrahedron should be positive; a flat or inverted one yields angles of 0 and 180 and ratios of 0.
TetrahedronShape tetrahedron_shape(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

struct DihedralRange {
  double least = 0, greatest = 0;  ///< degrees
};

/// Computes the angles of tetrahedron_shape in a third of its time; 0 and 180 for a needle whose volume is lost in
/// rounding. O(1).
DihedralRange dihedral_range(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

struct Distribution {
  double min = 0, max = 0, mean = 0, first_percentile = 0;
};

/// Statistics over a set of tetrahedra. Histograms are counts in equal bins from 0 to 180 degrees (dihedral) or 0 to 1
/// (ratios).
struct ShapeStatistics {
  std::size_t n_tetrahedra = 0;
  double volume = 0;
  Distribution min_dihedral, max_dihedral, solid_angle, radius_ratio, aspect, mean_ratio, edge_length;
  double share_below_10 = 0, share_above_24_85 = 0;  ///< shares of elements by their least dihedral angle
  std::array<std::size_t, 36> dihedral_histogram{};  ///< all angles, in bins of 5 degrees
  std::array<std::size_t, 18>
      min_dihedral_histogram{};  ///< least angle of each element, in bins of 5 degrees from 0 to 90
  std::array<std::size_t, 20> radius_ratio_histogram{};
  /// Number of edges by length divided by target size: below 1/4, 1/2, 1/sqrt 2, 1, sqrt 2, 2, 4, above. Zero if no
  /// size field is given.
  std::array<std::size_t, 8> edge_size_histogram{};
};

/// Why an element is bad.
enum class ShapeCause {
  free,         ///< nothing forces it
  input_angle,  ///< it has a vertex at which two facets or segments of the input meet at less than `forcing_angle`
  thin_gap,     ///< it spans a gap thinner than a quarter of the target size that the tolerance does not allow to close
};

struct WorstElement {
  Index tetrahedron = no_index;
  double min_dihedral = 0, max_dihedral = 0;
  Vec3 place;  ///< centroid
  ShapeCause cause = ShapeCause::free;
  double forcing_angle = 0;                      ///< the input angle in degrees, if that is the cause
  Index facet_a = no_index, facet_b = no_index;  ///< the input facets that meet there, or between which the gap lies
  Index segment_a = no_index, segment_b = no_index;  ///< the segments, if an angle with a segment is the cause
  double gap = 0;                                    ///< the width of the gap, if that is the cause
};

struct QualityOptions {
  double bad_angle =
      8;  ///< elements with a least dihedral angle below this are listed, and some of the worst in any case:
  std::size_t min_worst = 0;        ///< at least this many (if there are as many elements) ...
  std::size_t max_worst = 100;      ///< ... and at most this many
  double forcing_angle = 16;        ///< degrees
  const SizeField* size = nullptr;  ///< target sizes with which edges are compared
  const SizeField* asked =
      nullptr;  ///< sizes with which gaps are compared: target sizes without those that gaps require; null: `size`
  /// Distance by which surfaces may move: a gap of up to twice of it could be closed, and is not a cause.
  double tolerance = 0;
  /// Share of the target size that limits the movement too; surfaces then never close a gap, so every gap is a cause.
  /// 0: the tolerance is the only limit.
  double tolerance_share = 0;
  /// For each facet of the PLC, its patch, if surfaces were remeshed: edges between facets of one patch are no longer
  /// constraints of the input. Empty: every facet is kept.
  std::vector<Index> facet_patch;
  /// For each tetrahedron, the group below `n_groups` by which statistics are divided; empty: by components.
  std::vector<Index> group;
  std::size_t n_groups = 0;
  unsigned threads = 0;  ///< 0: all cores; the result does not depend on it
};

struct MeshQuality {
  ShapeStatistics whole;
  std::vector<ShapeStatistics> per_component;  ///< or per group
  std::vector<WorstElement> worst;  ///< elements without a cause in the input first, each kind with the worst first
  std::size_t n_bad = 0;            ///< elements below bad_angle
  std::size_t n_bad_forced = 0;     ///< number of bad elements with a cause in the input
};

/// Nearly linear in the elements, plus for each vertex of a bad element the square of the number of faces there. The
/// result does not depend on the number of threads. Precondition: groups, if given, are below n_groups, one for each
/// tetrahedron.
MeshQuality measure_quality(const PiecewiseLinearComplex& plc, const ConstrainedTetrahedralization& mesh,
                            const QualityOptions& options = {});
/// Measures a mesh of any origin, without causes.
ShapeStatistics measure_shapes(std::span<const Vec3> points, std::span<const Tetrahedron> tetrahedra);

}  // namespace geomesh
