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

/// Shapes of one tetrahedron; angles in degrees; every ratio is 1 for the regular tetrahedron and falls to 0 for a flat
/// one.
struct TetrahedronShape {
  std::array<double, 6> dihedral;  ///< at the edges in the order of edge_vertices
  double min_dihedral, max_dihedral;
  std::array<double, 4>
      solid_angle;      ///< at the vertices, as degrees of spherical excess (the paper's unit: 31.6 for the regular)
  double radius_ratio;  ///< 3 * inscribed radius / circumscribed radius
  double aspect;        ///< least height / longest edge, over that of the regular
  double mean_ratio;    ///< 12 (3V)^(2/3) / sum of squared edges
  double volume;
  double shortest_edge, longest_edge;
};

/// O(1). The tetrahedron should be positive; a flat or inverted one yields angles of 0 and 180 and ratios of 0.
TetrahedronShape tetrahedron_shape(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

struct DihedralRange {
  double least = 0, greatest = 0;  ///< degrees
};

/// As tetrahedron_shape's angles, in a third of its time; 0 and 180 for a needle whose volume rounding hides. O(1).
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
  double share_below_10 = 0, share_above_24_85 = 0;  ///< of elements by their least dihedral angle
  std::array<std::size_t, 36> dihedral_histogram{};  ///< every angle, bins of 5 degrees
  std::array<std::size_t, 18>
      min_dihedral_histogram{};  ///< least angle of each element, bins of 5 degrees from 0 to 90
  std::array<std::size_t, 20> radius_ratio_histogram{};
  /// Edges by length over asked size: below 1/4, 1/2, 1/sqrt 2, 1, sqrt 2, 2, 4, above. Zero where no size field is
  /// given.
  std::array<std::size_t, 8> edge_size_histogram{};
};

/// Why an element is bad.
enum class ShapeCause {
  free,         ///< nothing forces it
  input_angle,  ///< it has a vertex at which two facets or segments of the input meet at less than `forcing_angle`
  thin_gap,     ///< it spans a gap thinner than a quarter of the asked size that the tolerance forbids to close
};

struct WorstElement {
  Index tetrahedron = no_index;
  double min_dihedral = 0, max_dihedral = 0;
  Vec3 place;  ///< centroid
  ShapeCause cause = ShapeCause::free;
  double forcing_angle = 0;                      ///< degrees: the input angle, where that is the cause
  Index facet_a = no_index, facet_b = no_index;  ///< the input facets that meet there, or between which the gap lies
  Index segment_a = no_index, segment_b = no_index;  ///< the segments, where an angle with a segment forces it
  double gap = 0;                                    ///< the gap's width, where that is the cause
};

struct QualityOptions {
  double bad_angle =
      8;  ///< elements below this least dihedral angle are listed, and some of the worst whatever they are:
  std::size_t min_worst = 0;        ///< at least this many (where there are as many elements) ...
  std::size_t max_worst = 100;      ///< ... and at most this many
  double forcing_angle = 16;        ///< degrees
  const SizeField* size = nullptr;  ///< what edges are compared with
  const SizeField* asked =
      nullptr;           ///< what gaps are compared with: sizes asked but for those that gaps ask for; null: `size`
  double tolerance = 0;  ///< by which surfaces may move: a gap of up to twice of it could be closed, and forces nothing
  /// Of the asked size: they move by no more of it, and never so far that a gap closes: every gap forces. 0: the
  /// tolerance holds everywhere.
  double tolerance_share = 0;
  /// Per facet of the PLC, where surfaces were remeshed: what lies between facets of one patch is no longer the
  /// input's. Empty: every facet is kept.
  std::vector<Index> facet_patch;
  /// Per tetrahedron, what statistics are parted by, with `n_groups`; empty: components.
  std::vector<Index> group;
  std::size_t n_groups = 0;
  unsigned threads = 0;  ///< 0: all cores; without influence on the result
};

struct MeshQuality {
  ShapeStatistics whole;
  std::vector<ShapeStatistics> per_component;  ///< or per group
  std::vector<WorstElement> worst;             ///< those that nothing forces first, each kind the worst first
  std::size_t n_bad = 0;                       ///< elements below bad_angle
  std::size_t n_bad_forced = 0;                ///< of them, forced by the input
};

/// Near-linear in the elements, plus for each vertex of a bad element the square of the number of faces there. Same
/// result for any number of threads. Precondition: groups, where given, are below n_groups, one for each tetrahedron.
MeshQuality measure_quality(const PiecewiseLinearComplex& plc, const ConstrainedTetrahedralization& mesh,
                            const QualityOptions& options = {});
/// Without causes, for a mesh of any origin.
ShapeStatistics measure_shapes(std::span<const Vec3> points, std::span<const Tetrahedron> tetrahedra);

}  // namespace geomesh
