// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Exact intersection of all surfaces with each other, with the box and with wells. The result is a polygon soup in
/// doubles whose facets meet only in shared vertices and edges.
///
/// Pipeline: merging of near ends and sides -> pairs (broad phase) -> exact constructions (narrow phase) -> constrained
/// triangulation inside each triangle -> identification of vertices -> clipping (box, bodies with cuts_all) -> rounding
/// with an exact check, and merging within the tolerance, repeated until nothing crosses -> thin voids closed, cracks
/// and holes filled. docs/decisions/arrangement.md has the file of each step.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "geomesh/core/geometry.hpp"
#include "geomesh/core/run_context.hpp"
#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel {

enum class SoupVertexKind : std::uint8_t { input, intersection, triple_point };

/// Triangles that meet only in shared vertices and edges, each with all its origins.
///
/// Invariants (validate_soup, which shares no code with the arrangement, lists every fault): indices in range; points
/// distinct; no degenerate facet; no two facets equal as sets; facets, segments and isolated points meet only in shared
/// vertices and edges.
struct PolygonSoup {
  std::vector<Vec3> points;
  std::vector<SoupVertexKind> kind;
  std::vector<Index> input_point;  ///< per point: row in the concatenated points of the input surfaces (first of equal
                                   ///< ones), else no_index

  std::vector<Triangle> facets;
  /// One origin of a facet. `reversed`: the facet's orientation is opposite to that triangle's.
  struct Origin {
    Index surface, triangle;
    bool reversed;
    friend bool operator==(const Origin&, const Origin&) = default;
  };
  /// Facet f has origins[origin_offsets[f]] .. [f+1], ordered by (surface, triangle); the first one's orientation is
  /// the facet's.
  std::vector<Origin> origins;
  std::vector<Index> origin_offsets{0};

  /// Pieces of polylines (wells); `polyline` is the row in the input.
  struct Segment {
    VertexIndex a, b;
    Index polyline;
  };
  std::vector<Segment> segments;
  struct IsolatedPoint {
    VertexIndex v;
    Index point;
  };
  std::vector<IsolatedPoint> isolated_points;
};

/// Where something of note was seen, for messages, for the report and for the VTP of offending spots.
struct Spot {
  std::string what;  ///< "crossing", "self-crossing", "free border", "gap" (a closed free border), "overlap", "merged",
                     ///< "vanished", "clipped", ...
  Index surface_a = no_index, surface_b = no_index;
  std::size_t count = 0;  ///< pairs of triangles, edges ...
  double measure = 0;     ///< area (m2) or length (m) where that makes sense
  Vec3 place;
  double area = 0;  ///< crossings that should not be: area of the lesser of the two surfaces' parts beyond the other; 0
                    ///< where nothing is parted
  std::size_t n_pieces = 1;  ///< free borders: connected pieces
};
/// The spot in a geologist's words: "horizon top crosses horizon base over 0.8 km2 along 3.1 km near (x, y, z)".
/// `surfaces`: those given, then the box's sides.
std::string describe(const Spot& spot, const std::vector<TriangulatedSurface>& surfaces);
/// What crosses what, what has gaps and what dangles, a line each.
std::vector<std::string> findings(const std::vector<Spot>& spots, const std::vector<TriangulatedSurface>& surfaces);

struct ArrangementOptions {
  std::optional<Box3>
      box;  ///< clip to it; its sides are then surfaces n .. n+5 in the order xmin xmax ymin ymax zmin zmax
  /// Clip to a closed volume of another shape: its sides, together closed, oriented outwards and free of crossings, are
  /// then surfaces n, n+1
  /// ... in this order. Not together with a box.
  std::vector<TriangulatedSurface> volume;
  enum class Crossings { resolve, refuse } crossings = Crossings::resolve;
  unsigned max_rounding_rounds = 8;
  /// Points, edges and facets nearer to each other than this are merged (0: only equal ones). The soup is proven free
  /// of crossings in any case. If not 0, at least 1024 ulps of the largest coordinate.
  double tolerance = 0;
  /// The places that `tolerance` merges: all of them, including those near a side of the box; or those where one of two
  /// surfaces that meet somewhere ends near the other. Faults that end beside another surface count as meeting it.
  /// Borders that end near a side move to it. Surfaces that follow each other within a hundredth of the tolerance are
  /// merged wherever they are near, with a warning, as are parts of one fault. Both ways move faults to edges of the
  /// volume that they run along, and close thin voids.
  enum class MergingOf { everything, surfaces_that_meet } merging = MergingOf::everything;
  /// The part of each triangle, by surface; a surface without an entry, or with an empty one, is one part. Parts of one
  /// surface may be removed later, one without the other, so a facet that stands for several parts names them all.
  std::vector<std::vector<Index>> parts;
  /// By surface: how many of its parts, the first ones, were given; the others continue them. No entry: one.
  std::vector<Index> n_given_parts;
  /// By surface: rows of the walls at which its continuations end, ascending. What the walls cut off from what was
  /// given is removed before anything is merged. Surfaces without an entry, or with an empty one, lose nothing.
  std::vector<std::vector<Index>> ends_at;
  /// Most bytes of memory, or 0: three quarters of the machine's. Counted by step from measured sizes; if more is
  /// needed, arrange() throws Error{cannot_mesh} with the place.
  std::size_t max_memory = 0;
};

struct Displacement {
  double largest = 0, mean = 0;
  Vec3 where;
  std::size_t points_moved = 0;
};

struct ArrangementResult {
  PolygonSoup soup;
  std::vector<TriangulatedSurface> box_sides;  ///< of the box (six) or of the requested volume; surface row n + i
  Displacement rounding;
  /// The effect of merging, by `tolerance` or at places too thin for any rounding.
  struct Merging {
    Displacement displacement;
    std::size_t vertices_merged = 0, vertices_inserted = 0, facets_merged = 0, facets_collapsed = 0;
    std::size_t pockets_closed = 0;  ///< thin voids that lost one of their walls
  } merging;
  /// Per input surface: area removed inside bodies with cuts_all, area removed outside the box, free border length
  /// left.
  std::vector<double> area_clipped_by_bodies, area_clipped_by_box;
  std::vector<double> area_clipped_by_rules;  ///< filled by trim_soup's caller; empty if no rule acts on the soup
  std::vector<Spot> spots;
  std::vector<std::string> warnings;
  std::size_t n_pairs = 0, n_crossing_pairs = 0, n_rounding_rounds = 0;
  std::size_t memory_bound = 0;  ///< bytes it might take
};

/// Throws Error{invalid_input} if crossings are refused (with the pairs and places) or coordinates are not finite, and
/// Error{cannot_mesh} if no valid rounding is found (with the place).
ArrangementResult arrange(const std::vector<TriangulatedSurface>& surfaces, const std::vector<Polyline>& polylines,
                          const std::vector<NamedPoint>& points, const ArrangementOptions& options,
                          const RunContext& context = {});

/// Winding number of point p with respect to one input surface taken as a closed oriented surface. It is decided
/// exactly; p is in doubles and not on the surface. Zero outside. Used for `inside` and for bodies that cross
/// themselves. Complexity: linear in the surface; callers ask once a region.
int winding_number(const TriangulatedSurface& surface, const Vec3& p);

struct SoupFault {
  std::string what;
  std::vector<Index> facets;
  Vec3 place;
};
/// Exact check of the soup's invariants, written apart from the arrangement; collects all faults (at most `limit`).
std::vector<SoupFault> validate_soup(const PolygonSoup& soup, std::size_t limit = 100);

}  // namespace geomesh::geomodel
